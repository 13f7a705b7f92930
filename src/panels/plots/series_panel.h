// Quantities against elapsed time: lines that grow on an axis that is fixed for the whole film,
// with marks at reversals and at other events. The quantities are defined in the file of each kind
// of panel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/meters/meter.h"
#include "panels/plot/plot_panel.h"
#include "physics/units/number_text.h"
#include "scene/panel_kind.h"

namespace carom {

/// What the lines show: the readings of a meter, and how they are drawn.
struct SeriesSubject : Meter {
    std::vector<plot::Text> titles = {};  ///< from longest to shortest; empty: the meter's title
                                          ///< with the names of its lines
    std::vector<std::string> notes = {};  ///< markup under the title, from longest to shortest
    std::string theory_note = {};    ///< added to these if any line of theory is known in the film
    std::optional<double> top = {};  ///< end of the axis; none: determined from the run
    bool is_signed = false;  ///< numbers may be negative; if any is, the axis is symmetric about 0
    bool spreads = false;    ///< the axis may be logarithmic if the values require it
    std::size_t compared = 0;  ///< index of the line that represents a run in a comparison
    std::optional<plot::Text> compared_title = {};  ///< title of that line; none: the usual title
    std::function<void(const HistoryRecord&, plot::Plot& whole)> add =
        {};  ///< adds layers, notes and words made from the whole record
};

/// A subject with the meter of meter_of_choices(), and a title that says what it shows of which.
SeriesSubject subject_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title,
                                 const Quantity& quantity);

/// A text like "pressure 1.25" with the last number among those shown that is not NaN.
std::string account_of_last(const Wording& language, const Quantity& quantity,
                            const std::vector<double>& values, std::size_t shown);

class SeriesPanel : public FramesPanel<HistoryRecord> {
  public:
    /// A title that is given in the scene does not name the lines: a key and the axis do so
    /// instead.
    SeriesPanel(const PanelContext& context, const PanelSpec& spec, SeriesSubject subject);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    bool surveys_positions() const override { return meter().needs_positions; }
    plot::Plot plot(const PanelState* state) const override;
    bool surveys_collisions() const override { return meter().needs_collisions; }

    /// Each point may be a mean over the time before it, but the curve is of all times until `at`.
    std::optional<std::array<double, 2>> time_shown(double at) const override { return {{at, at}}; }

  protected:
    void finish_record() override;
    void make_axes() override;

  private:
    const Meter& meter() const { return reader_.meter(); }
    bool names_lines() const;
    bool rests_at_zero() const;
    Phrase time_name() const;
    plot::Axis axis_up() const;
    void make_plot();
    void add_names();
    bool has_numbers(bool of_theory = false) const;
    std::vector<std::string> notes() const;
    std::vector<std::string> accounts_of_runs(const ShownState& now) const;
    std::string account_of(const Measured& now) const;
    double error_of_mean(const std::vector<double>& x, const std::vector<double>& y) const;
    void add_run(std::size_t run);

    /// A line of the plot that ends at the present: its layer, and what it shows.
    struct Growing {
        std::size_t layer, run, line;
    };
    plot::Level level_of(const ReferenceLevel& of) const;
    void add_levels();
    void add_common_levels(const ReferenceLevels& levels);
    void add_levels_of_lines(const ReferenceLevels& levels);
    std::string with_deviation(const ReferenceLevel& level) const;
    void add_band_about(const plot::Level& level, double deviation);
    void add_turns();
    void add_events();

    PanelContext context_;
    SeriesSubject subject_;  ///< what it reads is read by:
    MeterReader reader_;
    bool is_titled_by_scene_;
    plot::Plot whole_;  ///< of the whole film
    std::vector<Growing> growing_;
};

/// Returns a kind of panel that shows the readings of a meter against time: with what makes its
/// panels, and its meter. `subject(context, spec)` gives a Meter, or a SeriesSubject.
template <auto subject>
PanelKind series_kind(PanelKind kind) {
    kind.meter = meter_of<subject>;
    kind.make = [](const PanelContext& context, const PanelSpec& spec) -> std::unique_ptr<Panel> {
        return std::make_unique<SeriesPanel>(context, spec, SeriesSubject{subject(context, spec)});
    };
    return kind;
}

}  // namespace carom
