// The panel of collision_map.cpp, whose words are in collision_map_words.cpp.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/collision/collision_map_keys.h"
#include "panels/collision/pair_collision.h"
#include "panels/collision/pair_motion.h"
#include "panels/plot/plot_panel.h"

namespace carom::collision_map {

using plot::Arrow, plot::Axis, plot::Column, plot::Layer, plot::Level, plot::Polyline, plot::Marker,
    plot::Note, plot::Plot, plot::Points, plot::Role, plot::Shade, plot::Stroke, plot::Text;
using plot::column, plot::dashes_in_print, plot::named, plot::text_of;
using Vector = Eigen::Array2d;
using Cause = WalkStep::Cause;

/// The dots of a state after and before, and the strokes of the lines, which keys show too.
inline const plot::Dot full{.role = {Role::Of::ink}, .radius = 0.36, .halo = 0.1};
inline const plot::Dot hollow{
    .role = {Role::Of::ink}, .radius = 0.36, .is_hollow = true, .halo = 0.1};
inline const Stroke of_energy{.width = 0.16}, of_equal{.width = 0.1, .dashes = {0.12, 0.3}};
inline const Stroke of_steps{.role = {Role::Of::highlight}, .width = 0.14, .shade = Shade::legible};
inline const Stroke of_walls{.width = 0.11, .dashes = {0.4, 0.3}};
inline const Role ink{Role::Of::ink}, page{Role::Of::page}, muted{Role::Of::muted};

/// Collisions of the two beads with each other and with walls.
struct Counts {
    std::int64_t pair = 0, wall = 0;
};

/// The stroke of a line of constant momentum.
Stroke of_momentum();

class CollisionMapPanel : public PlotPanel {
  public:
    CollisionMapPanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context), spec_(spec), watch_(context, spec), walk_watch_(context, spec) {}

    void survey(const FrameInput& input) override;
    bool is_of_run() const override { return !options().given; }
    bool surveys_collisions() const override { return !options().given; }
    void fix_axes() override;
    void archive(Archive& archive) override {
        archive(met_, motion_, number_, walk_, factor_, reach_);
        if (archive.is_reading()) make_plot();
    }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive&) override {}
    Plot plot(const PanelState* state) const override;
    std::optional<std::array<double, 2>> time_shown(double at) const override;

  private:
    const CollisionMapOptions& options() const { return spec_.options.as<CollisionMapOptions>(); }
    bool is_walk() const { return options().walk; }
    bool is_scaled() const { return options().scaled.value_or(is_walk()); }
    void find_motion();
    Counts counts_of(std::size_t steps) const;
    std::string subscripted(const char* letter, std::size_t k) const;
    std::string name_of(std::size_t k) const;
    Heading column_of(std::size_t k) const;
    Axis axis(std::size_t k) const;
    std::vector<Text> titles() const;
    /// Only a walk says all without numbers of particles.
    std::optional<std::array<std::string, 2>> walking_names() const {
        return is_walk() && met_ ? own_names(context_, *met_) : std::nullopt;
    }
    Note key(std::size_t steps) const;
    Note key_of_walk(std::size_t steps) const;
    Note key_of_collision() const;
    std::string energy_words() const;
    std::vector<Column> columns(const std::vector<Vector>& velocities) const;
    Polyline line(const std::vector<Vector>& through, Stroke stroke, int depth) const;
    Points points(const std::vector<Vector>& at, const plot::Dot& dot) const;
    Arrow arrow(const Vector& from, const Vector& to, const Role& role, const Role& edge) const;
    void make_plot();
    void add_energy();
    void add_collision();
    void add_matrix();
    void add_walk(Plot& plot, std::size_t steps) const;
    std::string account_of(std::size_t steps) const;

    PanelContext context_;
    PanelSpec spec_;
    PairCollisionWatch watch_;
    WalkWatch walk_watch_;
    std::optional<PairCollision> met_;  // of the run
    PairMotion motion_;
    std::array<std::int64_t, 2> number_{1, 2};  // what the two are called
    std::vector<WalkStep> walk_;
    Vector factor_{1.0, 1.0};  // of each velocity: 1, or the root of its mass
    Vector reach_{1.0, 1.0};   // largest velocities shown, times factor_
    Plot whole_;               // what is still
};

}  // namespace carom::collision_map
