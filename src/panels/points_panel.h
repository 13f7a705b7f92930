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
    std::function<std::vector<Point>(const Observation&, std::size_t set)> points;
    std::function<Color(std::size_t set, const Theme&)> color;
    bool never_equal = false;    ///< the two numbers: a line where they would be is drawn
    double breaks_across = 0.0;  ///< steps of a path beyond these go around the box: not drawn;
    double breaks_up = 0.0;      ///< 0: none does
    std::pair<std::string, std::string> columns = {};  ///< of a table, with their units
    std::vector<std::string> names = {};               ///< of the sets, in a table
};

class PointsPanel : public Panel {
  public:
    explicit PointsPanel(PointsSubject subject) : subject_(std::move(subject)) {}

    void survey(const Observation& observation) override;
    void settle() override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

    /// For tests: the points of a set in a state.
    static const std::vector<Point>& points(const PanelState& state, std::size_t set);

  private:
    struct Scales;
    bool breaks_between(const Point& from, const Point& to) const;
    Scales scales(const Page& page) const;
    void draw_path(Canvas& canvas, const Page& page, std::size_t set, std::size_t shown) const;

    PointsSubject subject_;
    std::vector<std::vector<Point>> paths_;  ///< of sets of one: a point for each frame
    std::vector<double> pool_;               ///< sizes of the numbers up, thinned
    std::size_t surveyed_ = 0, seen_ = 0;
    double low_ = 0.0, high_ = 1.0;
};

}  // namespace carom
