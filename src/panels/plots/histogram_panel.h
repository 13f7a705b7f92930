// Histograms of one number of particles, of all or of those chosen, drawn together: now, over a
// while, or since the start; with the equilibrium curves of this finite gas, a fitted normal curve,
// and means. Which number, and its curve, is given by the panel's own file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "stats/goodness.h"
#include "stats/running_histogram.h"

namespace carom {

/// What a histogram shows.
struct HistogramSubject {
    std::string title;     ///< "Particles by speed"
    std::string quantity;  ///< "speed": the axis title
    std::string beyond;    ///< "faster": what lies beyond the end of the axis
    std::function<Eigen::ArrayXXd(const FrameInput&)>
        values;  ///< a row for each particle: one number, or several that count alike
    std::function<double(const EquilibriumGas& gas, double value)> density =
        {};  ///< of a number at equilibrium; empty where there is no such curve
    std::function<double(const EquilibriumGas& gas, double low, double high)> probability =
        {};                  ///< of a value in between; wanted where the density is not finite
    bool symmetric = false;  ///< about 0; else values are never negative
    std::optional<std::pair<double, double>> extent =
        {};                             ///< all values are in here; none: as the run shows
    bool means = true;                  ///< marked where the scene does not say
    std::string unit = reduced::speed;  ///< of the numbers, in a table
    std::optional<Law> law = {};        ///< that they follow at equilibrium, for a test
};

class HistogramPanel : public Panel {
  public:
    HistogramPanel(const PanelContext& context, const PanelSpec& spec, HistogramSubject subject);

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void settle_with(const std::vector<Panel*>& others) override;
    std::shared_ptr<const PanelState> mean_state(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    void settle_beside(const std::vector<Panel*>& others,
                       const std::vector<std::string>& names) override;
    std::shared_ptr<const PanelState> beside(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    std::vector<std::string> told_of_runs(const PanelState& state) const override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    std::string finding(const PanelState& state) const override;

    /// For tests: of the bars of a choice against its curve, where the scene asks for it.
    std::optional<ChiSquared> test(const PanelState& state, std::size_t series) const;

    /// For tests: the fixed bins and the top of the vertical axis.
    const Bins& bins() const { return bins_; }
    double tallest() const { return tallest_; }

    /// For tests: the histograms of a state, one for each choice of particles.
    static const std::vector<MeanHistogram>& histograms(const PanelState& state);

    /// For tests: the standard errors of bars that are means over runs, for each choice; or none.
    static const std::vector<std::vector<double>>& errors(const PanelState& state);

  private:
    struct Probe {
        double time;
        Eigen::ArrayXd values;
    };
    struct Series {
        Chosen chosen;
        std::vector<Eigen::Index> members = {};
        std::optional<EquilibriumGas> equilibrium = {};
        std::vector<EquilibriumGas> others = {};  ///< of the other runs of a mean
        double mean_start = 0.0;
        double unit = 1.0;  ///< what one number counts: 1, or a share in per cent
        double lowest_mean = 0.0, highest_mean = 0.0;  ///< of the whole run, that at the start too
        std::vector<Probe> probes = {};  ///< whole samples at a few frames, for the height of bars
        std::vector<Point> curve = {};   ///< value, expected number in a bin around it
        std::vector<RunningHistogram> running = {};  ///< one, from fix_axes() on
    };
    struct Scales {
        Rect area;
        Scale x, y;
    };
    struct Ink {
        Color bar, curve, fit;
    };

    Eigen::ArrayXd values_of(const Series& series, const Eigen::ArrayXXd& all) const;
    std::optional<double> window() const;
    double numbers_at_a_time() const;
    double numbers_in_bars() const;
    double expected_share(const Series& series, double value) const;
    double curve_top() const;
    double reach() const;
    void choose_bins(double reach, double numbers);
    void choose_curves();
    void finish();
    void take_mean_of_curves(const std::vector<HistogramPanel*>& runs);
    void choose_height();
    Expected expected(const Series& series) const;
    Expected expected_in_run(const Series& series, const EquilibriumGas& gas) const;
    void require_testable(const Series& series) const;
    bool fills_the_middle() const { return subject_.symmetric || subject_.extent.has_value(); }
    bool marks_mean_now() const { return spec_.mean_now.value_or(subject_.means && !compares()); }
    bool marks_mean_start() const {
        return spec_.mean_start.value_or(subject_.means && !compares());
    }
    bool compares() const { return !names_.empty(); }
    std::string name_of_series(std::size_t series) const;
    Table table_of(const PanelState& state, std::size_t from, std::size_t to) const;

    Scales scales(const DrawContext& dc) const;
    Ink ink(std::size_t series, const DrawContext& dc) const;
    std::string time_words() const;
    std::string title(const DrawContext& dc) const;
    enum class NamesPlace { right, left, above };
    NamesPlace names_place(const DrawContext& dc) const;
    double names_width(const DrawContext& dc) const;
    double width_of_name(const DrawContext& dc, const std::string& name) const;
    std::string name_of_mean(bool is_short) const;
    bool has_short_names(const DrawContext& dc) const;
    bool is_low_right_of(const Rect& area, double x, const DrawContext& dc) const;
    int rows_above(const DrawContext& dc) const;
    Point row_above(const DrawContext& dc, int row) const;
    std::string title_of_runs(const DrawContext& dc) const;
    void draw_runs(Canvas& canvas, const DrawContext& dc,
                   const std::vector<MeanHistogram>& now) const;
    void draw_beyond_runs(Canvas& canvas, const DrawContext& dc,
                          const std::vector<MeanHistogram>& now) const;
    void draw_bars(Canvas& canvas, const DrawContext& dc, std::size_t series,
                   const MeanHistogram& now) const;
    void draw_outline(Canvas& canvas, const DrawContext& dc, std::size_t series,
                      const MeanHistogram& now) const;
    std::vector<Point> path_of(const DrawContext& dc, const std::vector<Point>& curve) const;
    std::vector<Point> fit_curve(std::size_t series, const MeanHistogram& now) const;
    std::optional<double> mark_place(const DrawContext& dc, double value) const;
    void draw_casings(Canvas& canvas, const DrawContext& dc, const MeanHistogram& now) const;
    void draw_errors(Canvas& canvas, const DrawContext& dc, std::size_t series,
                     const PanelState& state) const;
    void draw_fit(Canvas& canvas, const DrawContext& dc, std::size_t series,
                  const MeanHistogram& now) const;
    void draw_means(Canvas& canvas, const DrawContext& dc,
                    const std::vector<MeanHistogram>& now) const;
    void draw_mark(Canvas& canvas, const DrawContext& dc, double value, bool solid,
                   Color color) const;
    double names_x(const DrawContext& dc) const;
    Point name_place(const DrawContext& dc, int index) const;
    void draw_name(Canvas& canvas, const DrawContext& dc, Point at, const std::string& words,
                   Color color) const;
    void draw_cuts(Canvas& canvas, const DrawContext& dc,
                   const std::vector<MeanHistogram>& now) const;
    void draw_beyond(Canvas& canvas, const DrawContext& dc,
                     const std::vector<MeanHistogram>& now) const;

    PanelContext context_;
    PanelSpec spec_;
    HistogramSubject subject_;
    std::vector<Series> series_;
    std::size_t own_ = 0;                  ///< those of series_ that are of this run: the first
    std::vector<std::string> names_ = {};  ///< of runs side by side, for each of series_; or none
    bool percent_ = false;                 ///< whether runs of different counts are shown as shares
    bool same_time_ = true;                ///< whether all of these runs are seen at one time
    std::size_t runs_ = 1;                 ///< of which bars show the mean
    double numbers_each_ = 1.0;            ///< of one particle at a time
    std::vector<double> pool_;             ///< values of the whole run, thinned
    int surveyed_ = 0;
    double span_ = 0.0;       ///< of simulated time in the film
    double seen_until_ = -1;  ///< time of the last sample in a mean
    Bins bins_;
    double tallest_ = 1.0;
};

}  // namespace carom
