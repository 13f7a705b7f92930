// Particles as points in a plane of two of their numbers; a single one leaves its path. Which
// numbers is given by the panel's own file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// What the points show: sets of them, each in a colour.
struct PointsSubject {
    std::function<std::vector<std::string>(const Theme&)>
        titles;                       ///< markup, the shorter ones for narrow panels
    std::string across, up;           ///< the axes' titles
    std::pair<double, double> width;  ///< of the axis across
    std::optional<std::pair<double, double>>
        height;  ///< of the axis up; none: symmetric about 0, as the run shows
    std::size_t sets = 1;
    std::function<std::vector<Point>(const FrameInput&, std::size_t set)> points;
    std::function<Color(std::size_t set, const Theme&)> color;
    std::function<std::vector<Point>(const FrameInput&, std::size_t set)>
        corners;  ///< of the path of a set of one, on the way from the frame before, in order;
                  ///< every frame in order; none: paths have no corners but at frames
    bool never_equal = false;    ///< the two numbers: a line where they would be is drawn
    double breaks_across = 0.0;  ///< steps of a path beyond these go around the box: not drawn;
    double breaks_up = 0.0;      ///< 0: none does
    std::pair<std::string, std::string> columns = {};  ///< of a table, with their units
    std::vector<std::string> names = {};               ///< of the sets, in a table
};

class PointsPanel : public Panel {
  public:
    explicit PointsPanel(PointsSubject subject) : subject_(std::move(subject)) {}

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    bool surveys_collisions() const override { return static_cast<bool>(subject_.corners); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

    /// For tests: the points of a set in a state.
    static const std::vector<Point>& points(const PanelState& state, std::size_t set);

  private:
    struct Scales;
    /// Of a set of one.
    struct Path {
        std::vector<Point> points;
        std::vector<std::size_t> ends;  ///< of each frame, the number of points up to it
        std::pair<std::size_t, std::size_t> until(std::size_t frames) const;  ///< first and end
    };
    bool breaks_between(const Point& from, const Point& to) const;
    Scales scales(const DrawContext& dc) const;
    void draw_path(Canvas& canvas, const DrawContext& dc, std::size_t set, std::size_t shown) const;

    PointsSubject subject_;
    std::vector<Path> paths_;
    std::vector<double> pool_;  ///< sizes of the numbers up, thinned
    std::size_t surveyed_ = 0, seen_ = 0;
    double low_ = 0.0, high_ = 1.0;
};

}  // namespace carom
