// Curves against a distance, a length or a time lag, measured from the run so far: one for each
// choice of particles. They converge as the film goes on. What is measured, and what theory
// predicts for it, is defined in the file of each kind of panel.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/means/runs_record.h"
#include "panels/meters/meter.h"
#include "panels/plot/plot_panel.h"
#include "scene/panel_kind.h"

namespace carom {

/// The title of a vertical axis that shows shares in bins of this width: "% per 0.5".
std::string percent_per(Language language, double width);

/// The longest number; a note reserves its room while the number changes.
inline const std::string longest_number = "\u22120.0000";

/// What has been measured up to a frame; the numbers of each line are for words and theory. The
/// errors of a mean over runs are in it, too.
struct CurveValues : Measured {
    std::vector<LineLaw> laws = {};            ///< of each line; none of a mean of runs
    double reach() const { return x.back(); }  ///< end of the horizontal axis
    void archive(auto& archive) {
        Measured::archive(archive);
        archive(laws);
    }
};

/// Measures the curves of a run.
class CurveMeter {
  public:
    virtual ~CurveMeter() = default;

    /// Called for every frame in order, with the collisions since the frame before.
    virtual void see(const FrameInput& input) = 0;

    /// Where the horizontal axis should begin and end; valid after all frames. For subjects that do
    /// not fix the axis.
    virtual double start() const { return 0.0; }
    virtual double reach() const { return 1.0; }

    /// Fixes the horizontal axis: its start, its end, and the number of points or bins. To be
    /// called before values(); holds for frames that were seen and for those to come.
    virtual void fix_axis(double start, double reach, int points) = 0;

    /// The curves on the axis of fix_axis(). The places are filled in by the caller.
    virtual Measured measured() const = 0;

    /// Writes or reads all that see() has accumulated; to be called after fix_axis().
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
    std::vector<MeterLine> lines = {};
    std::vector<plot::Text> titles = {};     ///< from longest to shortest
    std::vector<plot::KeyEntry> names = {};  ///< key of what the last title leaves out
    bool names_axis = false;       ///< the vertical one; else the title names the quantity
    Quantity along = {}, up = {};  ///< of the axes
    /// Title of the vertical axis for bins of this width; none: `up`.
    std::function<std::string(double width)> height = {};
    std::optional<double> reach = {};  ///< end of the horizontal axis, which begins at 0; each of
                                       ///< several compared runs has its own
    std::optional<double> top = {};    ///< end of the vertical axis; none: from the data
    std::optional<double> level = {};  ///< horizontal line across the plot
    Over over = {Over::Since::start, 0.0};  ///< the time that is averaged over
    double from = 0.0;                      ///< the time before which nothing is measured
    double least_top = 0.0;                 ///< lower bound of the vertical axis's end
    bool logarithmic = false;               ///< whether the vertical axis is
    std::function<std::vector<LineLaw>(const CurveValues&)> laws = {};  ///< of this panel's own run
    struct Results {
        std::vector<Quantity> of = {};
        std::function<std::vector<MeanError>(const CurveValues&, std::size_t line)> find = {};
    };
    Results results = {};  ///< as MeterResults, of each line
    std::function<std::string(const CurveValues&, std::size_t line)> account =
        {};  ///< result of a line in words: "mean free path 1.25"; empty if not known

    /// Adds theory and notes, computed from the numbers that are shown as text; nullptr before
    /// there are any. Not called if runs are compared.
    std::function<void(const CurveValues*, plot::Plot&)> add = {};
};

/// What the first pass of a run has shown.
struct CurveRun {
    std::string name = {};  ///< among compared runs
    double start = 0.0, reach = 1.0, least = 0.0, most = 0.0;
    double least_positive = 1.0;
    int points = 0;                 ///< or bins, up to the reach
    bool is_reach_its_own = false;  ///< fixed by the subject, not by the course of the run
    void archive(Archive& archive) {
        archive(name, start, reach, least, most, least_positive, points, is_reach_its_own);
    }
};

struct CurveRecord : RunsRecord<CurveRun> {
    double start() const;
    double reach() const;
};

/// The record of the mean of runs that differ only in their seeds.
CurveRecord mean_of(const std::vector<CurveRecord>& records);

/// What a frame shows.
struct CurveState : PanelState {
    std::vector<CurveValues> runs;                     ///< one, or the compared runs
    std::shared_ptr<const CurveValues> readouts = {};  ///< values written as text: of one run
    std::size_t bytes() const override;
};

/// Adds a line for each choice of particles that the panel shows, and titles that name the choices
/// and `time`, the time that is averaged over (empty: not mentioned). `what` is markup.
void name_curves(CurveSubject& subject, const PanelContext& context, const PanelSpec& spec,
                 const std::string& what, const std::string& time);

class CurvePanel : public RecordPanel<CurveRecord> {
  public:
    CurvePanel(const PanelContext& context, CurveSubject subject);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::samples; }
    void archive(Archive& archive) override { archive_record(archive); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void see(const FrameInput& input) override { shown_->see(input); }
    void archive_progress(Archive& archive) override;
    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    plot::Plot plot(const PanelState* state) const override;
    bool surveys_collisions() const override { return true; }
    bool wants_collisions() const override { return true; }
    std::optional<std::array<double, 2>> time_shown(double at) const override;

  protected:
    void finish_record() override;
    void make_axes() override;
    void take_axes(const RecordPanel& of) override { take_record(of); }

  private:
    void take_in(const Measured& values);
    plot::Axis axis_up() const;
    void make_plot();
    void add_curve(plot::Plot& plot, const CurveState& state, std::size_t run,
                   std::size_t line) const;
    CurveValues values_of(const CurveMeter& meter) const;
    std::vector<double> places() const;
    plot::Bars bars_of(const CurveValues& run, std::size_t line) const;
    plot::Polyline line_of(const CurveValues& run, std::size_t index) const;

    PanelContext context_;
    CurveSubject subject_;
    std::unique_ptr<CurveMeter> surveyed_, shown_;
    int samples_seen_ = 0;
    std::shared_ptr<const CurveValues> readouts_;
    plot::Plot whole_;
    double shown_start_ = 0.0, shown_reach_ = 1.0;  ///< of this panel's own run
    int shown_points_ = 0;
};

/// The meter of the results of curves: without readings; empty if there are no results.
Meter meter_of_curves(const CurveSubject& subject);

/// Returns a kind of panel that shows curves: with what makes its panels, and the meter of its
/// results. `subject(context, spec)` gives a CurveSubject.
template <auto subject>
PanelKind curve_kind(PanelKind kind) {
    kind.meter = [](const PanelContext& context, const PanelSpec& spec) {
        return meter_of_curves(subject(context, spec));
    };
    kind.make = [](const PanelContext& context, const PanelSpec& spec) -> std::unique_ptr<Panel> {
        return std::make_unique<CurvePanel>(context, subject(context, spec));
    };
    return kind;
}

}  // namespace carom
