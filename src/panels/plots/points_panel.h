// Particles as points in the plane of two of their quantities; a set of a single particle leaves
// its path. The quantities are defined in the file of each kind of panel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/plot/plot_panel.h"
#include "scene/panel_kind.h"

namespace carom {

/// What the points show: sets of them, each in a colour.
struct PointsSubject {
    struct Set {
        std::string name;  ///< in a table
        plot::Role role = {.of = plot::Role::Of::bar};
    };
    std::vector<plot::Text> titles;   ///< from longest to shortest
    Language language;                ///< of the numbers
    std::string across, up;           ///< the axes' titles
    std::pair<double, double> width;  ///< of the horizontal axis
    std::function<void(PointsSubject&, const FrameInput&)> widen =
        {};  ///< widens axes of positions to the largest extent of the box
    std::optional<std::pair<double, double>>
        height;  ///< of the vertical axis; none: symmetric about 0, determined from the run
    std::vector<Set> sets;
    std::function<std::vector<Point>(const FrameInput&, std::size_t set)> points;
    std::function<std::vector<Point>(const FrameInput&, std::size_t set)>
        corners;  ///< of the path of a single-particle set since the frame before, in order;
                  ///< called for every frame in order; empty: paths have corners at frames only
    std::function<bool(double time)> is_sample =
        {};  ///< if given, points are those of these times so far, and there are no paths
    bool shows_present = true;   ///< beside such points
    std::string remark = {};     ///< plain words under the title
    bool fades = false;          ///< older parts of paths fade, so that recent ones stand out
    bool never_equal = false;    ///< the two quantities: a line marks where they would be equal
    double breaks_across = 0.0;  ///< steps of a path beyond these go around the box: not drawn;
    double breaks_up = 0.0;      ///< 0: none does
    std::pair<Heading, Heading> columns = {};  ///< of a table, and what the axes show
};

struct PointOptions {
    bool by_clock = false;  ///< of the samples of the run alone
};

/// With `samples: clock`, shows the points of the samples of the run so far.
void show_samples(const PanelContext& context, const PanelSpec& spec, PointsSubject& subject);

/// The keys of points.
std::vector<Binding<PanelSpec>> point_keys();

class PointsPanel : public PlotPanel {
  public:
    explicit PointsPanel(PointsSubject subject) : subject_(std::move(subject)) {}

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override {
        return subject_.is_sample ? SurveyedAt::samples : SurveyedAt::frames;
    }
    void fix_axes() override;
    void archive(Archive& archive) override;
    bool surveys_collisions() const override { return static_cast<bool>(subject_.corners); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override { archive(seen_); }
    plot::Plot plot(const PanelState* state) const override;

    /// For tests: the present points of a set in a state.
    static const std::vector<Point>& points(const PanelState& state, std::size_t set);

  private:
    /// The path of a set of a single particle.
    struct Path {
        std::vector<double> x, y;
        std::vector<std::size_t> ends;  ///< for each frame, the number of points up to it
        void archive(Archive& archive) { archive(x, y, ends); }
        plot::Shown until(std::size_t frames) const;
    };
    /// The points of a set at all samples.
    struct Cloud {
        std::vector<double> time, x, y;
        void archive(Archive& archive) { archive(time, x, y); }
    };
    void survey_samples(const FrameInput& input);
    void keep_for_axis(const std::vector<Point>& points);
    void add_cloud(plot::Plot& now, std::size_t set, double time) const;
    std::vector<int> pieces_of(const Path& path) const;
    plot::Polyline line_of(std::size_t set) const;
    void add_path(plot::Plot& now, std::size_t set, std::size_t frames) const;
    void make_plot();

    PointsSubject subject_;
    std::vector<Path> paths_;
    std::vector<Cloud> clouds_;  ///< instead of paths
    std::vector<double> pool_;   ///< magnitudes of the vertical quantity, thinned
    std::size_t surveyed_ = 0, seen_ = 0;
    std::pair<double, double> height_ = {0.0, 1.0};
    plot::Plot whole_;                   ///< the part that is the same in all frames
    std::vector<plot::Polyline> lines_;  ///< path of each set in the whole film
    std::vector<plot::Points> points_;   ///< or its points
};

}  // namespace carom
