// A histogram of one number per particle as it is now: bars, the equilibrium curve of this finite
// gas, the mean now and at the start. Which number, and its curve, is given by the panel's own
// file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "stats/histogram.h"

namespace carom {

/// What a histogram shows.
struct HistogramSubject {
    std::string title;     ///< "Speed"
    std::string quantity;  ///< "speed": the axis title
    std::string beyond;    ///< "faster": what lies beyond the end of the axis
    std::function<const Eigen::ArrayXd&(const Observation&)> values;
    std::function<double(double value)>
        density;  ///< per particle, at equilibrium; empty where there is no such curve
    std::function<double(double low, double high)> probability =
        {};  ///< of a value in between; wanted where the density is not finite
};

class HistogramPanel : public Panel {
  public:
    HistogramPanel(const Cast& cast, const PanelSpec& spec, HistogramSubject subject);

    void survey(const Observation& observation) override;
    void settle() override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;

    /// For tests: the fixed bins and the top of the vertical axis.
    const Bins& bins() const { return bins_; }
    double tallest() const { return tallest_; }

  private:
    struct Scales;
    Scales scales(const Page& page) const;
    double expected_share(double value) const;
    double curve_top() const;
    void choose_bins();
    void choose_height();
    void draw_bars(Canvas& canvas, const Page& page, const Histogram& histogram) const;
    void draw_curve(Canvas& canvas, const Page& page) const;
    void draw_means(Canvas& canvas, const Page& page, double mean_now) const;
    double names_x(const Page& page) const;
    void draw_name(Canvas& canvas, const Page& page, Point at, const std::string& words,
                   Color color) const;
    void draw_ends(Canvas& canvas, const Page& page, const Histogram& histogram) const;

    PanelSpec spec_;
    HistogramSubject subject_;
    double particles_;
    double sharing_;  ///< those that share the energy: infinite masses at rest do not
    int frames_;
    std::vector<double> pool_;  ///< values of the whole run, thinned
    std::vector<Eigen::ArrayXd>
        probes_;  ///< whole samples at a few frames, for the height of the bars
    int surveyed_ = 0;
    double mean_start_ = 0.0;
    Bins bins_;
    double tallest_ = 1.0;
    std::vector<Point> curve_;  ///< value, expected number of particles in a bin around it
};

}  // namespace carom
