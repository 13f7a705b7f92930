// Numbers against elapsed time: lines that grow while their axis is the whole film's, with marks
// at reversals and at other events. Which numbers is given by the panel's own file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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
        {};  ///< one number for each line, every frame of the first pass in order; NaN: none
    std::vector<Line> lines = {};
    std::vector<plot::Text> titles = {};  ///< from the longest on
    std::vector<std::string> names = {};  ///< of several lines, as a key shows them
    bool last_title_names = true;         ///< the lines; if not, a key under it does
    std::vector<std::string> notes = {};  ///< markup under the title, from the longest on
    std::function<ReferenceLevels()> references = {};  ///< after the first pass
    std::function<std::vector<std::vector<MeanError>>()> numbers =
        {};                          ///< of each line, after the first pass
    std::optional<double> top = {};  ///< of the axis; none: as the run shows
    bool is_signed =
        false;             ///< numbers may be negative: where any is, the axis is symmetric about 0
    bool spreads = false;  ///< over powers of ten, if need be
    Phrase quantity = {};  ///< "entropy"
    std::string unit = {};     ///< "1"
    std::size_t compared = 0;  ///< the line that stands for a run beside others
    std::optional<plot::Text> compared_title = {};  ///< of that line; none: the title
    bool needs_collisions = false;                  ///< to measure
    bool needs_positions = true;                    ///< to measure
    std::function<void(const SeriesRecord&, plot::Plot& whole)> add =
        {};  ///< layers, notes and words that come from the whole record
};

/// Titles of a subject whose lines and names are set: what they show with their names in their
/// colours, or where there is no room alone, over a key.
void title_with_names(SeriesSubject& subject, Language language, const std::string& what);

/// A line for each choice of particles that the panel shows, and the title that names them: what
/// is measured of each is for the caller to add.
SeriesSubject subject_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title);

/// "pressure 1.25": the last number there is among those shown.
std::string account_of_last(Language language, Phrase quantity, const std::vector<double>& values,
                            std::size_t shown);

class SeriesPanel : public RecordPanel<SeriesRecord> {
  public:
    /// A title that the scene gives says nothing of the lines: a key and the axis name them.
    SeriesPanel(const PanelContext& context, const PanelSpec& spec, SeriesSubject subject);

    void survey(const FrameInput& input) override;
    bool surveys_positions() const override { return subject_.needs_positions; }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override { archive(seen_); }
    plot::Plot plot(const PanelState* state) const override;
    bool surveys_collisions() const override { return subject_.needs_collisions; }
    void archive(Archive& archive) override;

  protected:
    void finish_record() override;
    void make_axes() override;

  private:
    bool rests_at_zero() const;
    Phrase time_name() const;
    plot::Axis axis_up() const;
    void make_plot();
    void add_key();
    bool has_numbers() const;
    std::vector<std::string> notes() const;
    std::vector<std::string> accounts_of_runs(const ShownState& now) const;
    void add_run(std::size_t run);
    plot::Level level_of(const ReferenceLevel& of) const;
    void add_levels();
    void add_common_levels(const ReferenceLevels& levels);
    void add_band_about(const plot::Level& level, double deviation);
    void add_turns();
    void add_events();

    PanelContext context_;
    SeriesSubject subject_;
    bool is_titled_by_scene_;
    std::size_t seen_ = 0;
    plot::Plot whole_;  ///< of the whole film
};

}  // namespace carom
