// Quantities against elapsed time: lines that grow on an axis that is fixed for the whole film,
// with marks at reversals and at other events. The quantities are defined in the file of each kind
// of panel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/means/running_mean.h"
#include "panels/plot/plot_panel.h"
#include "panels/plots/series_record.h"

namespace carom {

/// What the lines show.
struct SeriesSubject {
    struct Line {
        std::string name;  ///< in a table, in English
        plot::Role role = {.of = plot::Role::Of::bar};
        bool is_theory = false;  ///< thin and dashed
    };
    std::function<std::vector<double>(const FrameInput&)> measure =
        {};  ///< one number for each line, at every sample and every frame of the first pass in
             ///< order; NaN: none
    std::vector<Line> lines = {};
    std::vector<plot::Text> titles = {};  ///< from longest to shortest
    std::vector<std::string> names = {};  ///< names of several lines in a key
    plot::Text plain_title = {};          ///< where the names stand at the lines
    std::vector<std::string> notes = {};  ///< markup under the title, from longest to shortest
    std::string theory_note = {};  ///< added to these if any line of theory is known in the film
    std::function<ReferenceLevels()> references = {};  ///< after the first pass
    std::function<std::vector<std::vector<MeanError>>()> numbers =
        {};  ///< numbers for each line, after the first pass
    std::function<std::vector<LineLaw>()> laws = {};  ///< of each line, after the first pass
    std::optional<double> top = {};  ///< end of the axis; none: determined from the run
    bool is_signed = false;  ///< numbers may be negative; if any is, the axis is symmetric about 0
    bool spreads = false;    ///< the axis may be logarithmic if the values require it
    Quantity quantity = {};  ///< with its word
    std::size_t compared = 0;  ///< index of the line that represents a run in a comparison
    std::optional<plot::Text> compared_title = {};  ///< title of that line; none: the usual title
    std::optional<Over> over =
        {};  ///< what is measured is averaged over this time; none: it is not
    bool needs_collisions = false;  ///< to measure
    bool needs_positions = true;    ///< to measure
    std::function<void(const SeriesRecord&, plot::Plot& whole)> add =
        {};  ///< adds layers, notes and words made from the whole record
};

/// Sets the titles of a subject whose lines and names are set: `what` with the names of the lines
/// in their colours or, if that does not fit, `what` alone with a key below.
void title_with_names(SeriesSubject& subject, Language language, const std::string& what);

/// Returns a subject with a line for each choice of particles that the panel shows, and with titles
/// that name them. The caller must add what is measured for each.
SeriesSubject subject_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title);

/// A text like "pressure 1.25" with the last number among those shown that is not NaN.
std::string account_of_last(Language language, const Quantity& quantity,
                            const std::vector<double>& values, std::size_t shown);

class SeriesPanel : public FramesPanel<SeriesRecord> {
  public:
    /// A title that is given in the scene does not name the lines: a key and the axis do so
    /// instead.
    SeriesPanel(const PanelContext& context, const PanelSpec& spec, SeriesSubject subject);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    bool surveys_positions() const override { return subject_.needs_positions; }
    plot::Plot plot(const PanelState* state) const override;
    bool surveys_collisions() const override { return subject_.needs_collisions; }

    /// Each point may be a mean over the time before it, but the curve is of all times until `at`.
    std::optional<std::array<double, 2>> time_shown(double at) const override { return {{at, at}}; }

  protected:
    void finish_record() override;
    void make_axes() override;

  private:
    bool is_mean() const;
    bool rests_at_zero() const;
    Phrase time_name() const;
    plot::Axis axis_up() const;
    void make_plot();
    void add_names();
    bool has_numbers(bool of_theory = false) const;
    std::vector<std::string> notes() const;
    std::vector<std::string> accounts_of_runs(const ShownState& now) const;
    void add_run(std::size_t run);

    /// A line of the plot that ends at the present: its layer, and what it shows.
    struct Growing {
        std::size_t layer, run, line;
    };
    std::size_t samples_until(std::size_t run, std::size_t shown) const;
    void end_at_present(plot::Polyline& line, const Growing& of, std::size_t shown) const;
    plot::Level level_of(const ReferenceLevel& of) const;
    void add_levels();
    void add_common_levels(const ReferenceLevels& levels);
    void add_levels_of_lines(const ReferenceLevels& levels);
    void add_band_about(const plot::Level& level, double deviation);
    void add_turns();
    void add_events();

    PanelContext context_;
    SeriesSubject subject_;
    RunningMean mean_;
    bool is_titled_by_scene_;
    plot::Plot whole_;  ///< of the whole film
    std::vector<Growing> growing_;
};

}  // namespace carom
