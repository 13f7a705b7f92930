// The distance between two runs against time, on a logarithmic axis: the root mean square over
// particles, those chosen at the start, of how far each is from its counterpart while both are
// present. Where small distances grow exponentially it rises along a straight line, whose slope is
// fitted.
#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "scene/limits.h"
#include "scene/panel_kind.h"
#include "scene/reading/gas_reading.h"
#include "util/text.h"

namespace carom {
namespace {

// Positions of one run at some times; `place`: time after time, particle after particle, NaN of one
// that is absent.
struct RunPath {
    std::vector<double> time = {}, place = {};
    void archive(Archive& archive) { archive(time, place); }
};

// log10 of a distance against time.
struct LogDistance {
    std::vector<double> time = {}, log10 = {};
    void archive(Archive& archive) { archive(time, log10); }
};

// The straight part.
struct Growth {
    double until = 0.0;                 // since the first sample
    double slope = 0.0, at_zero = 0.0;  // of the decimal logarithm
    void archive(Archive& archive) { archive(until, slope, at_zero); }
};

struct RunDistanceRecord {
    RunPath samples = {}, frames = {};  // of one run
    Box box = {};
    LogDistance at_samples = {}, at_frames = {};  // of two runs
    std::optional<Growth> growth = {};
    void archive(Archive& archive) { archive(at_samples, at_frames, growth); }
};

LogDistance distance_of(const RunPath& a, const RunPath& b, const Box& box) {
    LogDistance all;
    const auto axes = static_cast<std::size_t>(box.dimension);
    const std::size_t size = a.time.empty() ? 0 : a.place.size() / a.time.size();
    for (std::size_t i = 0, k = 0; i < a.time.size(); ++i) {
        while (k < b.time.size() && b.time[k] < a.time[i]) ++k;
        if (k == b.time.size()) break;
        if (b.time[k] != a.time[i]) continue;  // an event of one run alone
        double sum = 0.0, numbers = 0.0;
        for (std::size_t j = 0; j < size; ++j) {
            double apart = a.place[i * size + j] - b.place[k * size + j];
            if (std::isnan(apart)) continue;
            const auto axis = static_cast<int>(j % axes);
            apart -= box.length(axis) * box.turns(axis, apart);
            sum += apart * apart;
            numbers += 1.0;
        }
        const double particles = numbers / static_cast<double>(axes);
        all.time.push_back(a.time[i]);
        all.log10.push_back(0.5 * std::log10(sum / particles));
        ++k;  // several frames may have one time
    }
    return all;
}

// The least squares line through the times before the distance first exceeds a hundredth of the
// box; none unless it rises by three powers of ten and its points are near it.
std::optional<Growth> growth_of(const LogDistance& distance, double side) {
    constexpr double small = 0.01, least_rise = 3.0, most_scatter = 0.1;
    const double limit = std::log10(small * side);
    double n = 0.0, t = 0.0, y = 0.0, tt = 0.0, ty = 0.0, yy = 0.0, until = 0.0;
    for (std::size_t i = 0; i < distance.time.size() && !(distance.log10[i] > limit); ++i) {
        if (!std::isfinite(distance.log10[i])) continue;
        const double x = distance.time[i], z = distance.log10[i];
        n += 1.0, t += x, y += z, tt += x * x, ty += x * z, yy += z * z, until = x;
    }
    const double spread = tt - t * t / n, slope = (ty - t * y / n) / spread;
    if (!(n > 2.0) || !(slope * until > least_rise)) return {};
    const double rest = yy - y * y / n - slope * slope * spread;
    if (std::sqrt(std::max(0.0, rest) / n) > most_scatter * slope * until) return {};
    return Growth{until, slope, (y - slope * t) / n};
}

// Of two runs.
RunDistanceRecord compare(const std::vector<RunDistanceRecord>& records,
                          const std::vector<std::string>&) {
    RunDistanceRecord both = records.at(0);
    both.at_samples = distance_of(both.samples, records.at(1).samples, both.box);
    both.at_frames = distance_of(both.frames, records.at(1).frames, both.box);
    const double shorter = both.box.dimension == 1 ? both.box.size[0] : both.box.shortest_side();
    both.growth = growth_of(both.at_samples, shorter);
    both.samples = both.frames = {};
    return both;
}

class RunDistancePanel : public FramesPanel<RunDistanceRecord> {
  public:
    RunDistancePanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context), spec_(spec) {
        for (const std::vector<Eigen::Index>& list : members(context, choices(spec)))
            of_.insert(of_.end(), list.begin(), list.end());
        record_.box = context.box();
    }

    void survey(const FrameInput& input) override {
        const auto add_to = [&](RunPath& path) {
            path.time.push_back(input.tick.time);
            for (const Eigen::Index i : of_)
                for (Eigen::Index axis = 0; axis < input.sample.position.cols(); ++axis)
                    path.place.push_back(is_present(input.sample, i)
                                             ? input.sample.position(i, axis)
                                             : std::nan(""));
        };
        if (input.is_sample) add_to(record_.samples);
        if (input.is_frame) add_to(record_.frames);
    }
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    plot::Plot plot(const PanelState* state) const override;

  protected:
    void make_axes() override;
    void take_axes(const RecordPanel& of) override { take_record(of); }

  private:
    plot::Polyline line_until(std::size_t shown) const;
    void add_growth(plot::Plot& plot) const;

    PanelContext context_;
    PanelSpec spec_;
    std::vector<Eigen::Index> of_;
    plot::Plot whole_;
};

void RunDistancePanel::make_axes() {
    const Language language = context_.language();
    whole_ = {
        .language = language,
        .titles = {say(language, "Distance between the runs")},
        .x = plot::axis_of(language, quantities::time, 0.0, context_.run().until),
        .y = {.low = -1.0,
              .high = 0.0,
              .kind = plot::Axis::Kind::powers,
              .quantity = quantities::distance.logarithm()},
        .columns = {quantities::time, {"log10 of distance", quantities::distance.logarithm()}}};
    if (spec_.title) whole_.titles = {escape_markup(*spec_.title)};
    std::vector<double> known;
    for (const double value : record_.at_samples.log10)
        if (std::isfinite(value)) known.push_back(value);
    if (known.empty()) return;
    const auto [low, high] = std::ranges::minmax(known);
    whole_.y.low = std::floor(low);
    whole_.y.high = std::max(whole_.y.low + 1.0, std::ceil(high));
}

// The samples so far, and the present.
plot::Polyline RunDistancePanel::line_until(std::size_t shown) const {
    const LogDistance &samples = record_.at_samples, &frames = record_.at_frames;
    std::vector<double> time, distance;
    const auto add = [&](const LogDistance& of, std::size_t i) {
        if (!std::isfinite(of.log10[i])) return;
        time.push_back(of.time[i]);
        distance.push_back(of.log10[i]);
    };
    if (shown > 0 && !frames.time.empty()) {
        const std::size_t now = std::min(shown, frames.time.size()) - 1;
        for (std::size_t i = 0; i < samples.time.size() && samples.time[i] < frames.time[now]; ++i)
            add(samples, i);
        add(frames, now);
    }
    plot::Polyline line;
    line.part = "line";
    line.of = "root mean square distance";
    line.x = plot::column(whole_.columns[0], std::move(time));
    line.y = plot::column(whole_.columns[1], std::move(distance));
    line.stroke = {.role = {.of = plot::Role::Of::bar}, .shade = plot::Shade::rimmed};
    line.head = plot::Dot{.role = line.stroke.role, .shade = line.stroke.shade};
    return line;
}

// The straight line and its slope, when its time is over.
void RunDistancePanel::add_growth(plot::Plot& plot) const {
    const Language language = context_.language();
    const Growth& growth = *record_.growth;
    const auto value_at = [&](double time) { return growth.at_zero + growth.slope * time; };
    plot::Polyline fit;
    fit.part = "fit";
    fit.x = plot::column(whole_.columns[0], {0.0, growth.until});
    fit.y = plot::column(whole_.columns[1], {value_at(0.0), value_at(growth.until)});
    fit.stroke = {.role = {.of = plot::Role::Of::ink}, .width = 0.1, .dashes = {0.5, 0.35}};
    plot.layers.emplace_back(fit);
    const std::string rate = three_digits(language, growth.slope * std::log(10.0));
    plot::Label label;
    label.words = {
        say(language, "× 10 in {}; exponent {} until {}",
            three_digits(language, 1.0 / growth.slope), rate, three_digits(language, growth.until)),
        say(language, "exponent {}", rate)};
    label.role = fit.stroke.role;
    for (const double share : {0.5, 0.6, 0.4, 0.7, 0.3}) {
        const double at = share * growth.until;
        for (const bool on_right : {true, false})
            label.anchors.push_back({.at = {at, value_at(at)},
                                     .offset = {on_right ? 1.2 : -1.2, on_right ? 1.4 : -0.6},
                                     .align = on_right ? Align::left : Align::right,
                                     .is_inside = true});
    }
    plot.layers.emplace_back(std::move(label));
    plot.finding = say(language,
                       "Until time {} the distance grows as an exponential function of time, with "
                       "the exponent {}.",
                       three_digits(language, growth.until), rate);
}

plot::Plot RunDistancePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const std::size_t shown = dynamic_cast<const ShownState&>(*state).shown.at(0);
    plot::Polyline line = line_until(shown);
    const bool has_points = line.x.size() > 0;
    const double time = has_points ? line.x[line.x.size() - 1] : 0.0;
    const Language language = context_.language();
    const std::string distance =
        has_points ? localised(language, three_digits_of_power(line.y[line.y.size() - 1]))
                   : say(language, "unknown");
    now.account = say(language, "Distance between the runs: {}.", distance);
    now.accounts_of_runs.assign(2, say(language, "distance") + " " + distance);
    now.layers.emplace_back(std::move(line));
    if (record_.growth && time >= record_.growth->until) add_growth(now);
    return now;
}

void check_run_distance(PanelSpec& panel, const Node& node, Reading& reading) {
    std::int64_t count = panel.of.empty() ? particles_in(reading.gas).value_or(0) : 0;
    for (const Chosen& chosen : panel.of) count += count_of(chosen, reading.gas).value_or(0);
    if (count > static_cast<std::int64_t>(most_in_both_runs.count()))
        reading.errors.add(node, fmt::format("`run-distance` of {} particles", count),
                           to_text(most_in_both_runs) + ": name some in `of`");
}

std::unique_ptr<Panel> make_run_distance(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<RunDistancePanel>(context, spec);
}

}  // namespace

PanelKind run_distance_kind() {
    using enum Ability;
    return {.name = "run-distance",
            .words = Phrase{"distance between the runs"},
            .shows =
                "The distance between two runs (`beside` of the film, or `compare` of the figure), "
                "as the root mean square over the particles that `of` names, on a logarithmic "
                "axis; where it grows exponentially, with the exponent.",
            .make = make_run_distance,
            .abilities = {of, two_runs, comparison},
            .rule = check_run_distance,
            .work = always(PanelWork{.keeps_places = true})};
}

}  // namespace carom
