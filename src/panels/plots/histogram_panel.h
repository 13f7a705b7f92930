// Histograms of one quantity of particles, of all, of chosen ones or of those that are in parts of
// the box, drawn together: at present, over a time window, or since the start; with the equilibrium
// curves of this finite gas, a fitted normal curve, and means. The quantity and its equilibrium
// curve are defined in the file of each kind of panel.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panels/chosen.h"
#include "panels/plot/plot_panel.h"
#include "panels/plots/histogram_record.h"
#include "panels/surfaces/box_parts.h"
#include "scene/panel_kind.h"
#include "stats/goodness.h"
#include "stats/histogram_over_time.h"
#include "stats/paths/paths.h"
#include "stats/paths/stays.h"

namespace carom {

/// The options of all histograms of particles.
struct HistogramOptions {
    std::optional<int> bins = {};  ///< none: by rule
    std::optional<std::pair<double, double>> range = {};
    bool fit = false;
    std::optional<bool> mean_now = {};  ///< none: by kind
    std::optional<bool> mean_start = {};
    bool by_clock = false;  ///< of the samples of the run alone
    MeasuredAt parts = {};  ///< of the box, instead of choices of particles
};

/// A view of numbers in a frame's input, without a copy: a row for each particle.
using ValuesOfInput = Eigen::Map<const Eigen::ArrayXXd>;

/// Views of all columns of an array, or of one column.
template <int Columns>
ValuesOfInput values_in(const Eigen::Array<double, Eigen::Dynamic, Columns>& array) {
    return {array.data(), array.rows(), array.cols()};
}
inline ValuesOfInput values_in(const Eigen::ArrayXXd& array, Eigen::Index column) {
    return {array.col(column).data(), array.rows(), 1};
}

/// What a histogram shows.
struct HistogramSubject {
    Phrase title;       ///< "Speed distribution"
    Quantity quantity;  ///< its word is the axis title
    std::function<ValuesOfInput(const FrameInput&)>
        values;  ///< one number for each particle, or several that are counted alike
    std::function<void(const PathPiece&, const std::function<void(const Course&)>& take)> courses =
        {};  ///< of each of these numbers along a piece of the particle's path
    std::function<double(const EquilibriumGas& gas, double value)> density =
        {};  ///< probability density at equilibrium; empty: no curve
    std::function<double(const EquilibriumGas& gas, double low, double high)> probability =
        {};  ///< of a value between `low` and `high`; needed if the density is not finite
             ///< everywhere
    std::vector<int> axes = {};  ///< of the motion that counts; empty: all
    std::vector<std::pair<double, double>> shares =
        {};  ///< instead of a density: values at equal distances and their shares
    Phrase curve = Phrase{"equilibrium"};  ///< its name
    Phrase short_curve = Phrase{"equilibrium"};
    bool symmetric = false;  ///< about 0; otherwise values are never negative
    std::optional<std::pair<double, double>> extent =
        {};  ///< range of all values; none: determined from the run
    std::optional<Eigen::Index> position_axis =
        {};             ///< for positions along an axis: `extent` is the largest extent of the box
    bool means = true;  ///< default of whether means are marked
    std::optional<TestedQuantity> tested = {};  ///< for the test against equilibrium; none: no test
    std::optional<ColorBy> colored_by = {};     ///< disks coloured by the same quantity
};

/// What a histogram shows in one frame.
struct HistogramState : PanelState {
    HistogramCounts counts;
    std::shared_ptr<const HistogramCounts> readouts = {};  ///< to which numbers in texts belong
    /// Whether each bar of each series fades out at the top; empty: decided by its height.
    std::vector<std::vector<bool>> taller = {};
    std::size_t bytes() const override;
};

class HistogramPanel : public RecordPanel<HistogramRecord> {
  public:
    HistogramPanel(const PanelContext& context, const PanelSpec& spec, HistogramSubject subject);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    bool wants_collisions() const override { return window() != 0.0; }
    void take_colors(const GasColors& colors) override;
    bool explains_colors() const override { return whole_.ramp != nullptr; }
    std::vector<std::string> parts() const override {
        return parts_ ? parts_->names(context_.language()) : std::vector<std::string>{};
    }
    void see(const FrameInput& input) override;
    bool surveys_positions() const override {
        return subject_.position_axis.has_value() || parts_.has_value();
    }
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override;
    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    plot::Plot plot(const PanelState* state) const override;
    std::vector<PanelNumber> scalars(const PanelState& state) const override;

    /// For tests: the chi-squared test of the bars of a choice against its curve, if the scene asks
    /// for it.
    std::optional<ChiSquared> test(const PanelState& state, std::size_t series) const;

    /// For tests: the fixed bins and the top of the vertical axis.
    const Bins& bins() const { return axes_.bins; }
    double tallest() const { return axes_.top; }

    /// For tests: the histograms of a state, one for each choice of particles.
    static const std::vector<MeanHistogram>& histograms(const PanelState& state);

    /// For tests: the standard errors of bars that are means over runs, for each choice; otherwise
    /// empty.
    static const std::vector<std::vector<double>>& errors(const PanelState& state);

  private:
    struct Choice {
        Chosen chosen = {};
        std::vector<Eigen::Index> members = {};  ///< at present
        std::vector<bool> has = {};         ///< whether each particle is a member, or is present in
                                            ///< the box of which this is a part; empty: all are
        std::optional<Region> within = {};  ///< of a part
        double at_start = 0.0;              ///< number of members; of a part, of all particles
        double missing = 0.0;               ///< how many fewer there are at present
    };
    struct Roles {
        plot::Role bar, curve, fit;
    };
    struct SeriesLayers {
        plot::Bars bars;       ///< without their heights
        plot::Polyline curve;  ///< without points: no curve
    };

    void finish_record() override;
    void make_axes() override;
    void take_axes(const RecordPanel& of) override;
    void find_members(const FrameInput& input);
    void take_members();
    void add_missing(std::vector<HistogramOverTime>& bars, const FrameInput& input) const;
    void follow_means(const FrameInput& input);
    void find_law_of_parts(const FrameInput& input);
    void begin_counting();
    std::vector<bool> tall_bars(const MeanHistogram& now, int frame, std::size_t k);
    std::optional<double> window() const;
    void add_to_bars(const PathPiece& piece, std::vector<HistogramOverTime>& bars);
    double samples() const;       ///< number that is surveyed
    bool shows_one_mean() const;  ///< over a window that ends at a figure's time
    bool is_probe(double time, double numbers) const;
    HistogramRules rules() const;
    EquilibriumGas counted_motion(const EquilibriumGas& gas) const;
    Expected expected(const HistogramSeries& series) const;
    void require_equilibrium(const Choice& choice) const;
    void require_testable(const HistogramSeries& series) const;
    std::optional<ChiSquared> test_of(const HistogramCounts& now, std::size_t series) const;
    std::string test_words(const HistogramCounts& now) const;

    const HistogramOptions& options() const { return spec_.options.as<HistogramOptions>(); }
    bool fills_the_middle() const { return subject_.symmetric || subject_.extent.has_value(); }
    bool compares() const { return axes_.compares; }
    bool marks_mean_now() const {
        return options().mean_now.value_or(subject_.means && !compares());
    }
    bool marks_mean_start() const {
        return options().mean_start.value_or(subject_.means && !compares());
    }
    std::size_t count() const { return axes_.series.size(); }
    Heading from_column() const;
    Heading to_column() const;
    Heading value_column() const;
    Roles roles_of(std::size_t k) const;
    SeriesLayers layers_of(std::size_t k) const;
    plot::Stroke fit_stroke(std::size_t k) const;
    plot::Note fit_note(std::size_t k, const MeanHistogram* now) const;
    plot::Marker mean_marker(std::size_t k, double mean, bool is_start) const;
    std::string mean_words(std::size_t k, double mean) const;
    std::vector<plot::BarNotes::Name> mean_names(const HistogramCounts* now) const;
    plot::BarNotes bar_notes(const HistogramCounts* now) const;
    plot::Text names_of_choices(Joint joint) const;
    std::string name_of_series(std::size_t k) const;
    std::string account_of_series(const HistogramCounts& now, std::size_t k) const;
    plot::Role role_of_choice(std::size_t k) const;
    plot::Note note_of_short_title() const;
    plot::Text add_titles();
    plot::Text add_titles_of_runs();
    std::vector<plot::Text> titles_with_asides(const plot::Text& words,
                                               const plot::Text& quantity) const;
    plot::Label name_of_curve(std::size_t k) const;
    void add_names();
    bool marks_name_choices() const;
    bool tells_time() const;
    void make_plot();
    std::string height_name() const;
    plot::Bars bars_of(const HistogramState& state, std::size_t k) const;
    void add_series(plot::Plot& plot, std::size_t k, const HistogramState* state) const;

    PanelContext context_;
    PanelSpec spec_;
    HistogramSubject subject_;
    std::optional<BoxParts> parts_;  ///< instead of choices of particles
    Members members_;                ///< of the choices; of parts all that are present
    std::vector<Choice> choices_;
    int surveyed_ = 0;
    double span_ = 0.0;  ///< of simulated time in the film
    HistogramAxes axes_;
    std::vector<Roles> roles_;             ///< of each series
    plot::Plot whole_;                     ///< for the whole film: all but numbers and layers
    std::vector<SeriesLayers> layers_;     ///< of each series, the same in every frame
    Paths paths_;                          ///< in the second pass, of a mean over time
    std::vector<Stay> stays_;              ///< scratch
    std::vector<HistogramOverTime> bars_;  ///< for each choice, in the second pass
    double members_since_ = 0.0;           ///< when they changed last, in the second pass
    /// Of a figure that shows a mean over time, for its error: the integral of the mean over the
    /// particles of a choice, at the moments from the beginning of that time on.
    struct MeanOverTime {
        double last = 0.0;
        std::vector<double> times = {}, integrals = {};
    };
    std::vector<MeanOverTime> means_;  ///< of each choice
    std::shared_ptr<const HistogramCounts> readouts_;
    std::vector<std::vector<int>> taller_until_;  ///< last frame, for each bar of each series
};

/// Completes a kind of histogram by what all of them share: keys, their check, and what else is
/// known of them; for one with an equilibrium, the law of its curves and the check of a test.
/// `is_from_zero`: its values are never negative, and neither is `range`; `values_each`: how many
/// of each particle are counted.
PanelKind histogram_kind(PanelKind kind, const Quantity& quantity, bool is_from_zero = false,
                         std::function<int(const PanelSpec&, const Gas&)> values_each = always(1));

}  // namespace carom
