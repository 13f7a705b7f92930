// Histograms of one number of particles, of all or of those chosen, drawn together: now, over a
// while, or since the start; with the equilibrium curves of this finite gas, a fitted normal curve,
// and means. Which number, and its curve, is given by the panel's own file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plots/histogram_record.h"
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
    const Bins& bins() const { return axes_.bins; }
    double tallest() const { return axes_.top; }

    /// For tests: the histograms of a state, one for each choice of particles.
    static const std::vector<MeanHistogram>& histograms(const PanelState& state);

    /// For tests: the standard errors of bars that are means over runs, for each choice; or none.
    static const std::vector<std::vector<double>>& errors(const PanelState& state);

  private:
    struct Choice {
        Chosen chosen;
        std::vector<Eigen::Index> members;
    };
    struct Scales {
        Rect area;
        Scale x, y;
    };
    struct Ink {
        Color bar, curve, fit;
    };

    std::optional<double> window() const;
    HistogramRules rules() const;
    HistogramRecord record() const;
    void begin(HistogramAxes axes);
    Expected expected(const HistogramSeries& series) const;
    void require_testable(const HistogramSeries& series) const;
    bool fills_the_middle() const { return subject_.symmetric || subject_.extent.has_value(); }
    bool compares() const { return axes_.compares; }
    bool marks_mean_now() const { return spec_.mean_now.value_or(subject_.means && !compares()); }
    bool marks_mean_start() const {
        return spec_.mean_start.value_or(subject_.means && !compares());
    }
    std::size_t count() const { return axes_.series.size(); }
    std::vector<std::string> names() const;
    Table table_of(const PanelState& state, std::size_t from, std::size_t to) const;

    Scales scales(const DrawContext& dc) const;
    Ink ink(std::size_t series, const DrawContext& dc) const;
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
    std::vector<Choice> choices_;
    HistogramRecord record_;  ///< of the first pass
    int surveyed_ = 0;
    double span_ = 0.0;  ///< of simulated time in the film
    HistogramAxes axes_;
    std::vector<RunningHistogram> running_;  ///< of each choice, in the second pass
    double seen_until_ = -1;                 ///< time of the last sample in a mean
};

}  // namespace carom
