// Particles as points in a plane of two of their numbers; a single one leaves its path. Which
// numbers is given by the panel's own file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/plot/plot_panel.h"

namespace carom {

/// What the points show: sets of them, each in a colour.
struct PointsSubject {
    struct Set {
        std::string name;  ///< in a table
        plot::Role role = {.of = plot::Role::Of::bar};
    };
    std::vector<plot::Text> titles;   ///< from the longest on
    Language language;                ///< of the numbers
    std::string across, up;           ///< the axes' titles
    std::pair<double, double> width;  ///< of the axis across
    std::function<void(PointsSubject&, const FrameInput&)> widen =
        {};  ///< makes axes of positions as wide as the box gets
    std::optional<std::pair<double, double>>
        height;  ///< of the axis up; none: symmetric about 0, as the run shows
    std::vector<Set> sets;
    std::function<std::vector<Point>(const FrameInput&, std::size_t set)> points;
    std::function<std::vector<Point>(const FrameInput&, std::size_t set)>
        corners;  ///< of the path of a set of one, on the way from the frame before, in order;
                  ///< every frame in order; none: paths have no corners but at frames
    bool fades = false;          ///< the older parts of paths, so that the recent ones are seen
    bool never_equal = false;    ///< the two numbers: a line where they would be is drawn
    double breaks_across = 0.0;  ///< steps of a path beyond these go around the box: not drawn;
    double breaks_up = 0.0;      ///< 0: none does
    std::pair<std::string, std::string> columns = {};  ///< of a table, with their units
};

class PointsPanel : public PlotPanel {
  public:
    explicit PointsPanel(PointsSubject subject) : subject_(std::move(subject)) {}

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void archive(Archive& archive) override;
    bool surveys_collisions() const override { return static_cast<bool>(subject_.corners); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override { archive(seen_); }
    plot::Plot plot(const PanelState* state) const override;

    /// For tests: the points of a set in a state.
    static const std::vector<Point>& points(const PanelState& state, std::size_t set);

  private:
    /// Of a set of one.
    struct Path {
        std::vector<double> x, y;
        std::vector<std::size_t> ends;  ///< of each frame, the number of points up to it
        void archive(Archive& archive) { archive(x, y, ends); }
        plot::Shown until(std::size_t frames) const;
    };
    std::vector<int> pieces_of(const Path& path) const;
    plot::Line line_of(std::size_t set) const;
    void add_path(plot::Plot& now, std::size_t set, std::size_t frames) const;
    void make_plot();

    PointsSubject subject_;
    std::vector<Path> paths_;
    std::vector<double> pool_;  ///< sizes of the numbers up, thinned
    std::size_t surveyed_ = 0, seen_ = 0;
    std::pair<double, double> height_ = {0.0, 1.0};
    plot::Plot whole_;               ///< what is still
    std::vector<plot::Line> lines_;  ///< of the whole film, of each set
};

}  // namespace carom
