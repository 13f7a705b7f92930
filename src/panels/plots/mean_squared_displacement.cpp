// The mean squared displacement of particles against time, since a time and on through periodic
// sides, with the line of slope 2 d D that fits it from a time on: D is the diffusion coefficient.
#include <cmath>
#include <limits>
#include <memory>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// How far particles have come since the first frame at or after a time.
class Displacements {
  public:
    Displacements(const Box& box, double from) : box_(box), from_(from) {}

    /// N x d, of a frame; all frames in order, with the collisions on the way. NaN before the time.
    Eigen::ArrayXXd operator()(const FrameInput& input) {
        const Eigen::ArrayXXd& position = input.sample.position;
        if (input.tick.time < from_)
            return Eigen::ArrayXXd::Constant(position.rows(), position.cols(), none);
        if (start_.size() == 0) {
            start_ = position;
            moved_ = 0.0 * position;
            time_ = Eigen::ArrayXd::Constant(position.rows(), input.tick.time);
            velocity_ = input.sample.velocity;
        }
        for (const Collision& one : input.advanced.collisions) {
            fly(one.first, one.time, one.first_after);
            if (one.second.is_particle()) fly(one.second.particle(), one.time, one.second_after);
        }
        moved_ += velocity_.colwise() * (input.tick.time - time_);
        time_ = input.tick.time;
        velocity_ = input.sample.velocity;
        // Straight flights give the number of turns around the box, positions all digits.
        for (Eigen::Index axis = 0; axis < moved_.cols(); ++axis) {
            const Eigen::ArrayXd inside = position.col(axis) - start_.col(axis);
            const double period = box_.size[axis];
            const bool wraps = box_.is_periodic(axis);
            moved_.col(axis) =
                wraps ? inside + period * ((moved_.col(axis) - inside) / period).round() : inside;
        }
        return moved_;
    }

  private:
    void fly(Eigen::Index particle, double time, const Eigen::Array2d& after) {
        if (time < time_[particle]) return;  // on the way to the first frame
        moved_.row(particle) += (time - time_[particle]) * velocity_.row(particle);
        time_[particle] = time;
        velocity_.row(particle) = after.head(velocity_.cols()).transpose();
    }

    Box box_;
    double from_;
    Eigen::ArrayXXd start_, moved_, velocity_;  // N x d
    Eigen::ArrayXd time_;                       // of each particle's last collision, or the frame
};

// The straight line of least squares through a line of a run before it turns back, from a time on.
struct Fit {
    double slope = none, from = 0.0, to = 0.0, middle = 0.0, mean = 0.0;
    double at(double time) const { return mean + slope * (time - middle); }
};

Fit fit_of(const SeriesRun& run, std::size_t line, double from) {
    std::vector<Point> points;
    Fit fit;
    for (std::size_t i = 0; i < run.time.size() && run.reversals[i] == 0; ++i) {
        const Point now{run.time[i], run.lines[line][i]};
        const bool stands = !points.empty() && points.back().x == now.x;
        if (now.x >= from && std::isfinite(now.y) && !stands) points.push_back(now);
    }
    if (points.size() < 2) return fit;
    for (const Point& one : points) {
        fit.middle += one.x / static_cast<double>(points.size());
        fit.mean += one.y / static_cast<double>(points.size());
    }
    double products = 0.0, squares = 0.0;
    for (const Point& one : points) {
        products += (one.x - fit.middle) * (one.y - fit.mean);
        squares += (one.x - fit.middle) * (one.x - fit.middle);
    }
    fit.slope = products / squares;
    fit.from = points.front().x;
    fit.to = points.back().x;
    return fit;
}

// The lines that fit, and their coefficients in words.
void add_fits(const PanelContext& context, const std::vector<Chosen>& chosen, double from,
              const SeriesRecord& record, plot::Plot& whole) {
    const bool compares = record.compares();
    std::vector<std::string> all;
    for (std::size_t k = 0; k < record.runs.size(); ++k)
        for (std::size_t i = 0; i < record.runs[k].lines.size(); ++i) {
            const Fit fit = fit_of(record.runs[k], i, from);
            if (!std::isfinite(fit.slope)) continue;
            const std::string of = name_of(context, chosen[compares ? record.compared : i]);
            plot::Line line;
            line.part = "fit";
            line.of = of;
            if (compares) line.run = k;
            line.still = true;
            line.x = plot::column(whole.columns[0], {fit.from, fit.to});
            line.y = plot::column(whole.columns[2], {fit.at(fit.from), fit.at(fit.to)});
            line.stroke = compares ? plot::stroke_of_run(k, 0.08)
                                   : plot::Stroke{.role = {.of = plot::Role::Of::highlight},
                                                  .width = 0.08,
                                                  .dashes = {0.3},
                                                  .shade = plot::Shade::legible};
            whole.layers.emplace_back(std::move(line));
            const int dimension = context.scene.gas.box.dimension;
            const std::string value = three_digits(fit.slope / (2.0 * dimension));
            const std::string name = compares ? record.runs[k].name : of;
            all.push_back(chosen.size() > 1 || compares ? name + " " + value : value);
        }
    if (all.empty()) return;
    const std::string since = " from time " + three_digits(from) + " on";
    plot::Note note;
    note.entries.push_back({plot::Stroke{.role = {.of = plot::Role::Of::highlight},
                                         .width = 0.08,
                                         .dashes = {0.3},
                                         .shade = plot::Shade::legible},
                            {"2<i>dDt</i>" + since + ": <i>D</i> = " + escape_markup(listed(all)),
                             "<i>D</i> = " + escape_markup(listed(all))}});
    whole.notes.push_back(std::move(note));
    whole.account = "The line 2dDt that fits" + since + " has D = " + listed(all) + ".";
}

}  // namespace

std::unique_ptr<Panel> make_mean_squared_displacement(const PanelContext& context,
                                                      const PanelSpec& spec) {
    const std::vector<Chosen> chosen = choices(spec);
    const double fit_from = spec.fit_from.value_or(0.5 * (spec.from + context.scene.run.until));
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(context, one));
    SeriesSubject subject{
        .measure =
            [lists, moved = Displacements(context.scene.gas.box, spec.from)](
                const FrameInput& input) mutable {
                const Eigen::ArrayXd square = moved(input).square().rowwise().sum();
                std::vector<double> now;
                for (const std::vector<Eigen::Index>& list : lists)
                    now.push_back(square(list).mean());
                return now;
            },
        .lines = {},
        .titles = {spec.title        ? plot::Text(escape_markup(*spec.title))
                   : spec.of.empty() ? plot::Text("Mean squared displacement")
                                     : "Mean squared displacement of " +
                                           names_of(context, chosen, plot::Sample::line)},
        .quantity = "mean squared displacement",
        .unit = "length^2",
        .needs_collisions = true,
        .add = [context, chosen, fit_from](
                   const SeriesRecord& record,
                   plot::Plot& whole) { add_fits(context, chosen, fit_from, record, whole); }};
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.lines.push_back({name_of(context, chosen[k]), role_among(context, chosen, k)});
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
