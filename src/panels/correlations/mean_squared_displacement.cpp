// The mean squared displacement of particles, unwrapped across periodic sides: since a fixed time,
// or averaged over all starting times from then on. With the fitted line of slope 2 d D, where D is
// the diffusion coefficient, and the initial ballistic parabola <v^2> t^2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/lag_meter.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/displacements.h"
#include "util/text.h"

namespace carom {
namespace {

const plot::Stroke of_fit{.role = {.of = plot::Role::Of::highlight},
                          .width = 0.08,
                          .dashes = {0.3},
                          .shade = plot::Shade::legible};
const plot::Stroke of_ballistic{.role = {.of = plot::Role::Of::accent},
                                .width = 0.1,
                                .dashes = {0.5, 0.35},
                                .shade = plot::Shade::legible};

// Indices of the numbers of a line beyond its points.
enum : std::size_t { of_diffusion, of_square_speed };

std::string with_error(Language language, const MeanError& number) {
    return carom::with_error(language, number.mean, number.error);
}

// The time of the first reversal, or infinity.
double first_reversal(const Run& run) {
    const std::vector<double> times = reversal_times(run);
    return times.empty() ? INFINITY : times.front();
}

// Fits a line to the squared displacements of each particle. The mean of the slopes is the slope of
// the mean, and their scatter gives its standard error.
class SlopesOfParticles {
  public:
    SlopesOfParticles(double from, double until) : from_(from), until_(until) {}

    void add(double time, const Eigen::ArrayXd& squares) {
        if (time < from_ || time > until_ || time == last_ || !squares.allFinite()) return;
        last_ = time;
        if (count_ == 0.0) values_ = products_ = 0.0 * squares;
        count_ += 1.0;
        times_ += time;
        time_squares_ += time * time;
        values_ += squares;
        products_ += time * squares;
    }

    MeanError slope(const std::vector<Eigen::Index>& particles) const {
        std::vector<double> slopes;
        const double spread = time_squares_ - times_ * times_ / count_;
        for (const Eigen::Index i : particles)
            if (count_ > 1.0 && spread > 0.0)
                slopes.push_back((products_[i] - values_[i] * times_ / count_) / spread);
        return mean_error(slopes);
    }

  private:
    double from_, until_, last_ = -INFINITY;
    double count_ = 0.0, times_ = 0.0, time_squares_ = 0.0;
    Eigen::ArrayXd values_, products_;
};

// What a run has shown of displacements since a fixed time.
struct Followed {
    std::vector<std::vector<Eigen::Index>> lists;
    Displacements moved;
    SlopesOfParticles slopes;
    std::vector<double> square_speeds = {};

    std::vector<double> see(const FrameInput& input) {
        const Eigen::ArrayXd square =
            moved(input.sample, input.advanced.collisions).square().rowwise().sum();
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : lists) now.push_back(square(list).mean());
        if (square_speeds.empty() && square.allFinite())
            for (const std::vector<Eigen::Index>& list : lists)
                square_speeds.push_back(input.speed(list).square().mean());
        slopes.add(input.tick.time, square);
        return now;
    }

    std::vector<std::vector<MeanError>> numbers(int dimension) const {
        std::vector<std::vector<MeanError>> all;
        for (std::size_t k = 0; k < lists.size(); ++k) {
            MeanError diffusion = slopes.slope(lists[k]);
            diffusion.mean /= 2.0 * dimension;
            diffusion.error /= 2.0 * dimension;
            all.push_back({diffusion, {square_speeds.empty() ? NAN : square_speeds[k], NAN}});
        }
        return all;
    }
};

plot::Line straight_line(const plot::Plot& plot, const LineFit& fit, double from, double to) {
    plot::Line line;
    line.part = "fit";
    line.still = true;
    line.x = plot::column(plot.columns[0], {from, to});
    line.y = plot::column(plot.columns[1], {fit.at(from), fit.at(to)});
    line.stroke = of_fit;
    return line;
}

// The straight line fitted to a line of a run between `from` and `until`, the first reversal; none
// if there are too few points.
std::optional<plot::Line> fit_of(const plot::Plot& plot, const std::vector<double>& x,
                                 const std::vector<double>& y, double from, double until) {
    std::vector<double> times, squares;
    for (std::size_t i = 0; i < x.size() && x[i] <= until; ++i) {
        const bool stands = !times.empty() && times.back() == x[i];
        if (x[i] < from || stands || !std::isfinite(y[i])) continue;
        times.push_back(x[i]);
        squares.push_back(y[i]);
    }
    if (times.size() < 2) return {};
    return straight_line(plot, fit_line(times, squares), times.front(), times.back());
}

bool has_gravity(const PanelContext& context) {
    return (context.scene.gas.box.surfaces.gravity != 0.0).any();
}

// Adds the ballistic parabola as far as it is visible. Returns false if it is not, and under
// gravity, where it does not hold.
bool add_ballistic(const PanelContext& context, double from, double square_speed, bool is_still,
                   plot::Plot& plot) {
    constexpr double least_seen = 0.015;  // of the axis
    constexpr int points = 40;
    const double reach = std::sqrt(plot.y.high / square_speed);
    const double span = plot.x.high - plot.x.low;
    if (!(square_speed > 0.0) || !(reach > least_seen * span) || has_gravity(context)) return false;
    std::vector<double> x, y;
    for (int i = 0; i <= points; ++i) {
        const double time = std::min(reach, plot.x.high - from) * i / points;
        x.push_back(from + time);
        y.push_back(square_speed * time * time);
    }
    plot::Line line;
    line.part = "ballistic";
    line.still = is_still;
    line.x = plot::column(plot.columns[0], std::move(x));
    line.y = plot::column(plot.columns[1], std::move(y));
    line.beyond = plot::Beyond::cut;
    line.stroke = of_ballistic;
    line.depth = 1;
    plot.layers.emplace_back(std::move(line));
    return true;
}

plot::KeyEntry ballistic_entry(Language language) {
    const std::string formula = "⟨<i>v</i>²⟩<i>t</i>²";
    return {of_ballistic, {say(language, "without collisions {}", formula), formula}};
}

// Adds the diffusion coefficients as text, each with the name of its line.
void add_coefficients(Language language, double from, const std::vector<std::string>& all,
                      plot::Plot& plot) {
    if (all.empty()) return;
    const std::string since = three_digits(language, from), values = listed(language, all);
    const std::string found = "<i>D</i> = " + escape_markup(values);
    plot.notes.push_back(
        {.entries = {
             {of_fit, {say(language, "fit 2<i>dDt</i> from time {}: {}", since, found), found}}}});
    plot.account = say(language, "The line 2dDt fitted from time {} on has D = {}.", since, values);
}

// The same for numbers that change: a row for each.
plot::KeyEntry coefficient_entry(Language language, const std::string& name,
                                 const std::string& value) {
    const auto words = [&](const std::string& number) {
        const std::string all = "<i>D</i> = " + number;
        return plot::Text(name.empty() ? all : say(language, "{}: {}", escape_markup(name), all));
    };
    return {.sample = of_fit, .words = {words(value)}, .longest = words("0.0000 ± 0.0000")};
}

std::unique_ptr<Panel> since_a_time(const PanelContext& context, const PanelSpec& spec) {
    const double fit_from = spec.fit_from.value_or(0.5 * (spec.from + context.scene.run.until));
    const std::vector<Chosen> chosen = choices(spec);
    SeriesSubject subject = subject_of_choices(context, spec, Phrase{"Mean squared displacement"});
    const auto followed = std::make_shared<Followed>(Followed{
        members_that_collide(context, chosen), Displacements(context.scene.gas.box, spec.from),
        SlopesOfParticles(fit_from, first_reversal(context.scene.run))});
    subject.measure = [followed](const FrameInput& input) { return followed->see(input); };
    subject.numbers = [followed, dimension = context.scene.gas.box.dimension] {
        return followed->numbers(dimension);
    };
    subject.quantity = Phrase{"mean squared displacement"};
    subject.unit = "length^2";
    subject.needs_collisions = true;
    if (!spec.theory) return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
    subject.add = [context, chosen, fit_from, from = spec.from](const SeriesRecord& record,
                                                                plot::Plot& whole) {
        const bool compares = record.compares();
        std::vector<std::string> all;
        for (std::size_t k = 0; k < record.runs.size(); ++k)
            for (std::size_t i = 0; i < record.runs[k].lines.size(); ++i) {
                const SeriesRun& run = record.runs[k];
                std::optional<plot::Line> line =
                    fit_of(whole, run.time, run.lines[i], fit_from,
                           run.turns.empty() ? INFINITY : run.turns.front());
                if (!line) continue;
                line->of = column_name_of(context.scene, chosen[compares ? record.compared : i]);
                if (compares) line->run = k;
                if (compares) line->stroke = plot::stroke_of_run(k, of_fit.width);
                const std::string value =
                    with_error(context.language(), run.numbers[i][of_diffusion]);
                const std::string name = compares ? run.name : name_of(context.scene, chosen[i]);
                all.push_back(chosen.size() > 1 || compares ? name + " " + value : value);
                whole.layers.emplace_back(std::move(*line));
            }
        add_coefficients(context.language(), fit_from, all, whole);
        if (!compares && chosen.size() == 1 &&
            add_ballistic(context, from, record.runs.front().numbers[0][of_square_speed].mean, true,
                          whole))
            whole.notes.push_back({.entries = {ballistic_entry(context.language())}});
    };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

// Measures displacements of groups of particles; the scatter of the groups gives the error of the
// fit.
class DisplacementMeter : public LagMeter {
  public:
    DisplacementMeter(const PanelContext& context,
                      const std::vector<std::vector<Eigen::Index>>& lists, double from, double lags,
                      double fit_from)
        : LagMeter(context, LagAverages::Of::displacements, groups_of(lists), from, lags),
          groups_(groups_of(lists)),
          speeds_(context.scene.gas.box, LagAverages::Of::velocities, lists, from, lags, 2,
                  velocity_changes(context.scene.run)),
          fit_from_(fit_from),
          lags_(lags),
          dimension_(context.scene.gas.box.dimension) {
        for (const std::vector<Eigen::Index>& list : lists) sizes_.push_back(double(list.size()));
    }

    void see(const FrameInput& input) override {
        LagMeter::see(input);
        speeds_.see(input.sample, input.advanced.collisions);
    }

    // The numbers of each line: the diffusion coefficient, its error and the mean squared speed.
    CurveValues values() const override {
        CurveValues now;
        const Eigen::ArrayXXd means = averages_.means(), squares = speeds_.means();
        std::size_t group = 0;
        for (std::size_t k = 0; k < sizes_.size(); ++k) {
            Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(lag_count);
            std::vector<double> slopes;
            for (const std::size_t end = group + groups_in(sizes_[k]); group < end; ++group) {
                const Eigen::ArrayXd one = means.row(static_cast<Eigen::Index>(group));
                mean += one * (double(groups_[group].size()) / sizes_[k]);
                slopes.push_back(slope_of(one));
            }
            const MeanError error = mean_error(slopes);
            const double each = 2.0 * dimension_;
            now.curves.emplace_back(mean.begin(), mean.end());
            now.numbers.push_back({slope_of(mean) / each, error.error / each,
                                   squares(static_cast<Eigen::Index>(k), 0)});
        }
        return now;
    }

    void archive(Archive& archive) override {
        LagMeter::archive(archive);
        archive(speeds_);
    }

  private:
    static std::size_t groups_in(double size) {
        return static_cast<std::size_t>(std::min(size, 20.0));
    }

    static std::vector<std::vector<Eigen::Index>> groups_of(
        const std::vector<std::vector<Eigen::Index>>& lists) {
        std::vector<std::vector<Eigen::Index>> groups;
        for (const std::vector<Eigen::Index>& list : lists) {
            const std::size_t first = groups.size(), count = groups_in(double(list.size()));
            groups.resize(first + count);
            for (std::size_t i = 0; i < list.size(); ++i)
                groups[first + i * count / list.size()].push_back(list[i]);
        }
        return groups;
    }

    double slope_of(const Eigen::ArrayXd& squares) const {
        std::vector<double> x, y;
        for (int k = 0; k < lag_count; ++k) {
            const double lag = lags_ * k / (lag_count - 1);
            if (lag < fit_from_ || !std::isfinite(squares[k])) continue;
            x.push_back(lag);
            y.push_back(squares[k]);
        }
        return x.size() < 2 ? NAN : fit_line(x, y).slope;
    }

    std::vector<std::vector<Eigen::Index>> groups_;
    std::vector<double> sizes_;
    LagAverages speeds_;
    double fit_from_, lags_;
    int dimension_;
};

// The error is that of the mean over runs, or for a single run that of the groups.
MeanError diffusion_of(const CurveValues& values, std::size_t line) {
    const std::vector<double>& numbers = values.numbers[line];
    return {numbers[0], values.errors.empty() ? numbers[1] : values.errors[line][0]};
}

std::unique_ptr<Panel> over_all_origins(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const std::vector<Chosen> chosen = choices(spec);
    const double lags = usual_lags(spec, context.scene.run);
    const double fit_from = spec.fit_from.value_or(0.5 * lags);
    CurveSubject subject{.points = lag_count};
    subject.meter = [context, lists = members_that_collide(context, chosen), from = spec.from, lags,
                     fit_from] {
        return std::make_unique<DisplacementMeter>(context, lists, from, lags, fit_from);
    };
    name_curves(subject, context, spec, say(language, "Mean squared displacement"), "");
    if (spec.theory && spec.of.size() == 1) subject.names.clear();  // beside its coefficient
    subject.along = Phrase{"time lag"};
    subject.unit_along = reduced::time;
    subject.up = Phrase{"mean squared displacement"};
    subject.unit_up = "length^2";
    subject.reach = lags;
    subject.account = [language](const CurveValues& values, std::size_t line) -> std::string {
        const MeanError diffusion = diffusion_of(values, line);
        return std::isfinite(diffusion.mean) ? "D = " + with_error(language, diffusion) : "";
    };
    if (!spec.theory) return std::make_unique<CurvePanel>(context, std::move(subject));
    subject.add = [context, language, chosen, lags, fit_from, has_names = !spec.of.empty()](
                      const CurveValues* values, plot::Plot& plot) {
        plot::Note note{.wraps = true, .changes = true};
        std::vector<double> x;
        for (int i = 0; i < lag_count; ++i) x.push_back(lags * i / (lag_count - 1));
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            const std::string name = has_names ? name_of(context.scene, chosen[k]) : "";
            std::optional<plot::Line> line;
            if (values != nullptr) line = fit_of(plot, x, values->curves[k], fit_from, INFINITY);
            const std::string value = line ? with_error(language, diffusion_of(*values, k)) : "";
            note.entries.push_back(coefficient_entry(language, name, value));
            if (!line) continue;
            line->still = false;
            line->of = column_name_of(context.scene, chosen[k]);
            plot.layers.emplace_back(std::move(*line));
            if (chosen.size() == 1) add_ballistic(context, 0.0, values->numbers[k][2], false, plot);
        }
        if (chosen.size() == 1 && !has_gravity(context))
            note.entries.push_back(ballistic_entry(language));
        plot.notes.push_back(std::move(note));
    };
    return std::make_unique<CurvePanel>(context, std::move(subject));
}

}  // namespace

std::unique_ptr<Panel> make_mean_squared_displacement(const PanelContext& context,
                                                      const PanelSpec& spec) {
    return spec.all_origins ? over_all_origins(context, spec) : since_a_time(context, spec);
}

}  // namespace carom
