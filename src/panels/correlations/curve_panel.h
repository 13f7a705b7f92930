// Curves over a distance, a length or a lag of time, measured from the run so far: one for each
// choice of particles, that come to rest as the film goes on. What is measured, and what theory
// says of it, is given by the panel's own file.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/plot/plot_panel.h"
#include "panels/plots/series_panel.h"

namespace carom {

/// The title of the axis up of shares in bins of this width: "% per 0.5".
std::string percent_per(Language language, double width);

/// The room that a number takes in a note while it changes.
inline const std::string longest_number = "\u22120.0000";

/// What has been measured up to a frame.
struct CurveValues {
    std::vector<std::vector<double>> curves;        ///< of each line at each point; NaN: none
    std::vector<std::vector<double>> numbers = {};  ///< of each line, for words and theory
    std::vector<std::vector<double>> errors = {};   ///< of these, where they are means of runs
    double start = 0.0, reach = 0.0;                ///< of the points or bins along
    void archive(auto& archive) { archive(curves, numbers, errors, start, reach); }
};

/// Follows a run.
class CurveMeter {
  public:
    virtual ~CurveMeter() = default;

    /// Every frame in order, with the collisions on the way.
    virtual void see(const FrameInput& input) = 0;

    /// Where the axis along should begin, and how far it should reach, after all frames; for
    /// subjects that do not say.
    virtual double start() const { return 0.0; }
    virtual double reach() const { return 1.0; }

    /// Where it begins and how far it does reach, and in how many points or bins: before values(),
    /// of what was seen and of what will be.
    virtual void fix_axis(double start, double reach, int points) = 0;

    /// Of curves on the axis that was fixed, which is filled in.
    virtual CurveValues values() const = 0;

    /// Writes or reads all that see() has gathered, after fix_axis().
    virtual void archive(Archive& archive) = 0;
};

/// What the curves show.
struct CurveSubject {
    enum class Shape {
        steps,  ///< bins, with a mean in each
        line    ///< points
    };
    Shape shape = Shape::line;
    int points = 0;  ///< or bins
    std::function<std::unique_ptr<CurveMeter>()> meter = {};
    std::vector<SeriesSubject::Line> lines = {};
    std::vector<plot::Text> titles = {};     ///< from the longest on
    std::vector<plot::KeyEntry> names = {};  ///< what the last of the titles leaves out
    bool names_axis = false;                 ///< up; else the title says what it is
    Phrase along = {}, up = {};              ///< the quantities of the axes
    std::string unit_along = {}, unit_up = {};
    std::function<std::string(double width)> height = {};  ///< the title of the axis up, for bins
                                                           ///< of this width; none: its quantity
    std::optional<double> reach = {};                      ///< of the axis along, from 0; of runs
                                                           ///< side by side each has its own
    std::optional<double> top = {};                        ///< of the axis up; none: as it shows
    std::optional<double> level = {};                      ///< across the plot
    double least_top = 0.0;                                ///< of the axis up, in any case
    bool logarithmic = false;                              ///< the axis up
    std::function<std::string(const CurveValues&, std::size_t line)> account =
        {};  ///< "mean free path 1.25": of a line, if it is known

    /// Theory and notes, from the numbers that a viewer is told, or from none before there are any.
    /// Not where runs are compared.
    std::function<void(const CurveValues*, plot::Plot&)> add = {};
};

/// What the first pass of a run has shown.
struct CurveRun {
    std::string name = {};  ///< beside others
    double start = 0.0, reach = 1.0, least = 0.0, most = 0.0;
    double least_positive = 1.0;
    int points = 0;                 ///< or bins, up to the reach
    bool is_reach_its_own = false;  ///< not a matter of how the run went
    void archive(Archive& archive) {
        archive(name, start, reach, least, most, least_positive, points, is_reach_its_own);
    }
};

struct CurveRecord {
    std::vector<CurveRun> runs = {{}};
    int runs_in_mean = 1;

    bool compares() const { return runs.size() > 1; }
    double start() const;
    double reach() const;
    void archive(Archive& archive) { archive(runs, runs_in_mean); }
};

/// Of runs that differ in their seeds.
CurveRecord mean_of(const std::vector<CurveRecord>& records);

/// Of runs side by side, a line of each.
CurveRecord compare(const std::vector<CurveRecord>& records, const std::vector<std::string>& names);

/// What a frame shows.
struct CurveState : PanelState {
    std::vector<CurveValues> runs;                     ///< one, or those side by side
    std::vector<std::vector<double>> errors = {};      ///< of a mean: of each line at each point
    std::shared_ptr<const CurveValues> readouts = {};  ///< what words tell: of one run
    std::size_t bytes() const override;
};

/// A line for each choice of particles that the panel shows, and titles that name them and the time
/// that is averaged over (no words: not said). `what` is markup.
void name_curves(CurveSubject& subject, const PanelContext& context, const PanelSpec& spec,
                 const std::string& what, const std::string& time);

class CurvePanel : public RecordPanel<CurveRecord> {
  public:
    CurvePanel(const PanelContext& context, CurveSubject subject);

    void survey(const FrameInput& input) override;
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override;
    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    plot::Plot plot(const PanelState* state) const override;
    bool surveys_collisions() const override { return true; }
    bool wants_collisions() const override { return true; }

  protected:
    void finish_record() override;
    void make_axes() override;
    void take_axes(const RecordPanel& of) override;

  private:
    void take_in(const CurveValues& values);
    plot::Axis axis_up() const;
    void make_plot();
    std::string remark() const;
    void add_curve(plot::Plot& plot, const CurveState& state, std::size_t run,
                   std::size_t line) const;
    CurveValues values_of(const CurveMeter& meter) const;
    std::vector<double> places(const CurveValues& run, std::size_t line) const;
    plot::Bars bars_of(const CurveValues& run, std::size_t line) const;
    plot::Line line_of(const CurveValues& run, std::size_t index) const;

    PanelContext context_;
    CurveSubject subject_;
    std::unique_ptr<CurveMeter> surveyed_, shown_;
    int frames_seen_ = 0;
    std::shared_ptr<const CurveValues> readouts_;
    plot::Plot whole_;
    double shown_start_ = 0.0, shown_reach_ = 1.0;  ///< of this panel's own run
};

}  // namespace carom
