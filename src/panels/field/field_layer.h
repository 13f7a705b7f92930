// A quantity in the cells of a box, drawn under the particles: density, temperature, mean speed,
// flow or the share of a species. Averages use exact residence times; one scale holds for the whole
// film. Independent of where particles are drawn.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/chosen.h"
#include "panels/field/color_bar.h"
#include "panels/field/key_row.h"
#include "panels/panel.h"
#include "stats/cell_averages.h"
#include "stats/means/mean_error.h"

namespace carom {

/// The cells in which a film's field is measured: squares of the picture or, along directions in
/// which all places are alike (even_axes()), as long as the box; in space always as deep as the
/// box, so that a field is the mean along z. Requires a field.
Cells cells_of_field(const Scene& scene);

/// Cells with a lower mean number of particles show nothing.
inline constexpr double least_in_cell = 3.0;

/// The quantity that a field or a profile shows, and its name, which may be that of a species.
Quantity quantity_of_field(const Scene& scene, FieldOf of);
std::string name_of_quantity(Language language, const Scene& scene, FieldOf of,
                             std::optional<std::size_t> species);

/// Measures a quantity in cells during a run.
class CellQuantity {
  public:
    /// `chosen`: the particles that are looked at; `species`: whose share is shown.
    CellQuantity(const PanelContext& context, const Cells& cells, FieldOf of,
                 std::optional<std::size_t> species, std::optional<double> window,
                 const Chosen& chosen = {});

    /// Called for every frame in order, with the collisions since the frame before.
    void see(const FrameInput& input);

    /// The value of each cell; NaN in cells whose mean number of particles is below
    /// `least_particles`. `axis` selects the component of the flow; other quantities ignore it.
    Eigen::ArrayXd values(Eigen::Index axis = 0, double least_particles = least_in_cell) const;

    /// The standard error of each cell's value, from the scatter of pieces of the window; NaN where
    /// it is unknown. Nothing where the window is not full or its pieces are not independent.
    std::optional<Eigen::ArrayXd> errors(Eigen::Index axis = 0) const;

    /// Writes or reads all that was seen.
    void archive(auto& archive) {
        archive(members_, all_);
        if (part_) archive(*part_);
        if (archive.is_reading()) choose();
    }

  private:
    /// The value of a cell is the sum divided by the weight; a density is that divided by the area.
    struct Ratio {
        Eigen::ArrayXd sum, weight;
    };
    void choose();
    Ratio ratio(const CellSums& all, const CellSums* part, Eigen::Index axis) const;

    FieldOf of_;
    double area_;
    Members members_;  ///< all that are looked at, and those of the species
    CellAverages all_;
    std::optional<CellAverages> part_;  ///< of the species whose share is shown
};

/// What a field shows in one frame.
struct FieldState {
    std::vector<float> values;  ///< of each cell, NaN: not coloured; of a flow the x component
    std::vector<float> up;      ///< of a flow the y component
};

class FieldLayer {
  public:
    explicit FieldLayer(const PanelContext& context);

    bool shown() const { return field_.has_value(); }

    /// First pass, every frame in order; then fix_scale().
    void survey(const FrameInput& input);
    void fix_scale();

    /// For two runs that share a scale; see GasColors.
    void add_survey(const FieldLayer& other);
    void take_scale(const FieldLayer& from) { scale_ = from.scale_; }

    void archive(auto& archive) { archive(scale_, is_clear_somewhere_); }

    /// Second pass, every frame in order; null without a field.
    std::shared_ptr<const FieldState> see(const FrameInput& input);

    void archive_progress(auto& archive) {
        if (shown_) archive(*shown_);
    }

    /// Draws a state; `place` maps a region of the box to its rectangle on the canvas. In space the
    /// field lies on the back wall: `on_wall` maps places on it, and `place` gives the size of the
    /// picture of a region of it.
    using Place = std::function<Rect(const Region&)>;
    using OnWall = std::function<Point(const Vec&)>;
    void draw(Canvas& canvas, const DrawContext& dc, const FieldState& state, const Place& place,
              const OnWall& on_wall = {}) const;

    /// Draws the key of the field into the area; `scale` is pixels per unit length.
    void draw_key(Canvas& canvas, const DrawContext& dc, double scale) const;

    /// The same in one line; the layer must live as long as the row.
    void add_key(KeyRow& row, double scale) const;

    /// Add the columns of the field to a table, and a row for each cell. `x` and `y` are the
    /// indices of the table's columns of coordinates.
    void add_columns(Table& table) const;
    void add_rows(Table& table, const FieldState& state, std::size_t x,
                  std::optional<std::size_t> y) const;

    /// What it shows, in a sentence; empty without a field.
    std::string account(const FieldState& state) const;

    /// For tests.
    const ColorScale& scale() const { return scale_; }
    const Cells& cells() const { return cells_; }

  private:
    bool is_flow() const { return field_->of == FieldOf::flow; }
    ColorMap colors(const Theme& theme) const;
    void draw_colors(Canvas& canvas, const DrawContext& dc, const FieldState& state,
                     const Place& place, const OnWall& on_wall) const;
    double reach(double scale) const;  ///< pixels of an arrow per unit of speed
    Eigen::Index measured_in(Eigen::Index square) const;
    void draw_flow(Canvas& canvas, const DrawContext& dc, Point middle, Point velocity,
                   double reach) const;

    PanelContext context_;
    const std::optional<Field>& field_;
    Cells cells_;    ///< in which it is measured
    Cells squares_;  ///< in which a flow is drawn
    std::optional<CellQuantity> surveyed_, shown_;
    std::vector<double> pool_;
    int frames_seen_ = 0;
    ColorScale scale_;  ///< of a flow, of its speed: the longest arrow
    bool is_clear_somewhere_ = false;
};

/// What a film's field shows, in a sentence; empty without one.
std::string words_of_field(const Scene& scene);

}  // namespace carom
