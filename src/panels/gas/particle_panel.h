// The common base of the panels of the box (2-D and 3-D) and of the line (1-D): colours of
// particles, velocity arrows, marks and flashes, a field, and the rows of the table.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "panels/field/field_layer.h"
#include "panels/gas/camera.h"
#include "panels/gas/gas_colors.h"
#include "panels/gas/marks/callouts.h"
#include "panels/gas/marks/fading.h"
#include "panels/gas/marks/flashes.h"
#include "panels/gas/marks/ghosts.h"
#include "panels/gas/marks/spotlights.h"
#include "panels/gas/velocity_arrows.h"
#include "panels/panel.h"
#include "physics/membership.h"

namespace carom {

/// What such a panel shows in one frame, in single precision.
struct ParticleState : PanelState {
    Eigen::ArrayXXf place;  ///< of all particles as drawn, a column for each axis;
                            ///< NaN of one that is absent
    std::shared_ptr<const Membership> membership = {};  ///< null: that of the start
    Eigen::ArrayXXf velocity;                           ///< empty: not shown
    std::vector<std::uint16_t> shades;                  ///< index into the film's colours
    double label_alpha = 0.0;
    std::shared_ptr<const Ghosts> ghosts;  ///< may be null
    double ghost_words = 0.0;
    std::vector<Flash> flashes;
    std::vector<float> light;  ///< share of its colour that each particle keeps; empty: all of it
    std::vector<Spotlights::Ring> rings;
    std::vector<Callouts::Present> callouts;
    std::optional<CameraView> view;           ///< none: the whole box
    Viewpoint viewpoint;                      ///< of a box in space
    std::shared_ptr<const FieldState> field;  ///< null: none

    std::size_t bytes() const override {
        return (static_cast<std::size_t>(place.size() + velocity.size()) + light.size()) *
                   sizeof(float) +
               shades.size() * sizeof(std::uint16_t) +
               (field ? (field->values.size() + field->up.size()) * sizeof(float) : 0);
    }

    bool is_shown(Eigen::Index particle) const { return !std::isnan(place(particle, 0)); }

    /// A colour of a particle as dimmed by spotlights, on a ground.
    Color seen(Color color, Eigen::Index particle, Color ground) const {
        if (light.empty()) return color;
        return mix(ground, color, static_cast<double>(light[static_cast<std::size_t>(particle)]));
    }
};

class ParticlePanel : public Panel {
  public:
    bool surveys_collisions() const override { return flashes_.asked() || field_.shown(); }
    void archive_progress(Archive& archive) override;
    void draw_key(Canvas& canvas, const Key& key) const override;
    Rect place_of_key(const Key& key) const override { return key_row(key).place(); }
    const GasColors& colors() const { return colors_; }

    /// Replaces fix_axes() for the boxes of several runs, which get common scales of colours,
    /// arrows and field, and world lines a common span of time.
    static void share_scales(const std::vector<ParticlePanel*>& boxes);

    /// Pixels per unit length.
    virtual double scale_in(const DrawContext& own) const = 0;

  protected:
    explicit ParticlePanel(const PanelContext& context, const FixedView& fixed = {})
        : context_(context),
          colors_(context),
          arrows_(context),
          ghosts_(context.scene),
          flashes_(context),
          spotlights_(context),
          fading_(context),
          camera_(context, fixed),
          callouts_(context),
          field_(context) {}

    KeyRow key_row(const Key& key) const;

    /// Gives this panel and that of the other run a common span of time.
    virtual void share_span(const std::vector<ParticlePanel*>& others) { (void)others; }

    /// Fills the common members of a state; `places` are the positions as drawn. Second pass, every
    /// frame in order. Returns whether the membership differs from that of the frame before.
    bool see(const FrameInput& input, const Eigen::ArrayXXd& places, ParticleState& state);

    bool is_filled(Eigen::Index particle, const ParticleState& state) const;

    /// Adds a row to the table: the part, the number and the species of a particle, then the cells,
    /// and its velocity if `has_velocity` and velocities are shown.
    void add_row(Table& table, const ParticleState& state, const char* part, Eigen::Index particle,
                 std::vector<TableCell> cells, bool has_velocity = false) const;

    PanelContext context_;
    GasColors colors_;
    VelocityArrows arrows_;
    GhostKeeper ghosts_;
    Flashes flashes_;
    Spotlights spotlights_;
    Fading fading_;
    Camera camera_;
    Callouts callouts_;
    FieldLayer field_;

  private:
    std::size_t species_of(Eigen::Index particle, const ParticleState& state) const;

    MembershipWatch membership_;        ///< of the frames, in the second pass
    std::vector<Eigen::Index> absent_;  ///< at the last of them
};

}  // namespace carom
