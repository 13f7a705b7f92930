// The histogram of the position of a moving wall or partition: the share of time in each bin, from
// its exact path. For one free piston, also the density that it would have over an ideal gas.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "panels/correlations/curve_panel.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/instruments/piston_over_gas.h"
#include "panels/registry.h"
#include "panels/surfaces/surface_words.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/panel_kind.h"
#include "stats/paths/residence.h"

namespace carom {
namespace {

const plot::Stroke of_law{.role = {.of = plot::Role::Of::accent}, .shade = plot::Shade::legible};
constexpr double percent = 100.0;
constexpr int shown_bins = 40;            // or fewer
constexpr double fine_bins_in_box = 240;  // several fine bins make one that is shown

// The numbers of a line: the parameters of the law, or none.
struct LawNumbers {
    explicit LawNumbers(const PistonOverGas& of) {
        for (const double number : {of.law.count, of.law.energy, of.law.force,
                                    double(of.law.dimension), of.zero, of.direction})
            numbers.push_back({number, NAN});
    }
    explicit LawNumbers(std::vector<MeanError> of) : numbers(std::move(of)) {}
    std::vector<MeanError> numbers;

    PistonOverGas piston() const {
        return {.law = {.count = numbers[0].mean,
                        .energy = numbers[1].mean,
                        .force = numbers[2].mean,
                        .dimension = static_cast<int>(numbers[3].mean)},
                .zero = numbers[4].mean,
                .direction = numbers[5].mean};
    }
};

// Follows a surface from hit to hit; its acceleration in between is constant.
class PistonMeter : public CurveMeter {
  public:
    PistonMeter(const PanelContext& context, std::int32_t surface)
        : context_(context),
          surface_(surface),
          axis_(context.box().surfaces.axis_of(surface)),
          times_(context.box().size[axis_] / fine_bins_in_box) {}

    void see(const FrameInput& input) override {
        const SurfaceState& state = input.advanced.surfaces.at(static_cast<std::size_t>(surface_));
        const double place = place_of_surface(context_.box(), input.advanced.surfaces,
                                              static_cast<std::size_t>(surface_));
        if (!last_) {
            law_ = piston_over_gas(context_, surface_, input);
        } else {
            follow(input, place);
        }
        last_ = Moment{input.sample.time, place, state.motion ? state.motion->velocity : 0.0,
                       acceleration(state)};
    }

    // start() and reach() are whole bins apart, each of several fine bins.
    double start() const override { return shown_bins * times_.width() * std::floor(lowest()); }
    double reach() const override {
        const double fine = times_.first() + static_cast<double>(times_.times().size()) + 1.0;
        const double in_bins = std::max(std::ceil(fine / shown_bins), std::floor(lowest()) + 1.0);
        return in_bins * shown_bins * times_.width();
    }
    void fix_axis(double start, double reach, int) override { range_ = {start, reach}; }

    Measured measured() const override {
        const std::vector<double>& fine = times_.times();
        std::vector<double> shares(shown_bins, 0.0);
        const auto [from, to] = range_.value_or(std::pair{start(), reach()});
        double all = 0.0;
        for (const double time : fine) all += time;
        // If the axis also serves another run, its bins may divide fine bins.
        const double in_one = (to - from) / times_.width() / shown_bins;
        const double before = times_.first() - from / times_.width();
        for (std::size_t i = 0; i < fine.size(); ++i) {
            const double low = (before + double(i)) / in_one, high = low + 1.0 / in_one;
            for (double bin = std::floor(low); bin < high; bin += 1.0)
                shares[static_cast<std::size_t>(std::clamp(bin, 0.0, shown_bins - 1.0))] +=
                    percent * fine[i] / all * in_one *
                    (std::min(high, bin + 1.0) - std::max(low, bin));
        }
        Measured now{.y = {std::move(shares)}};
        if (law_) now.numbers = {LawNumbers(*law_).numbers};
        return now;
    }

    void archive(Archive& archive) override { archive(times_, last_, law_); }

  private:
    struct Moment {
        double time, place, velocity, acceleration;
        void archive(auto& archive) { archive(time, place, velocity, acceleration); }
    };

    // The lowest place, in units of shown_bins fine bins.
    double lowest() const { return double(times_.first()) / shown_bins; }

    double acceleration(const SurfaceState& state) const {
        const auto* piston = piston_of(state.behaviour);
        if (piston == nullptr || state.is_held) return 0.0;
        return piston->force_in(context_.box().surfaces.gravity[axis_]) / piston->mass;
    }

    // The change of velocity of the surface by a hit.
    double change(const Collision& hit, const SurfaceState& state) const {
        const auto* piston = piston_of(state.behaviour);
        const double inverse_mass = context_.particles.inverse_mass[hit.first];
        if (piston == nullptr || inverse_mass == 0.0) return 0.0;
        return (hit.first_before[axis_] - hit.first_after[axis_]) / (inverse_mass * piston->mass);
    }

    // If the computed path does not end at the actual place, something else has changed the motion:
    // then the surface is taken to have moved uniformly.
    void follow(const FrameInput& input, double place) {
        constexpr double near = 1e-6;  // of the box
        const SurfaceState& state = input.advanced.surfaces[static_cast<std::size_t>(surface_)];
        std::vector<MotionStretch> stretches;
        MotionStretch now{last_->place, last_->velocity, last_->acceleration, 0.0};
        double since = last_->time;
        const auto go_on_to = [&](double time) {
            now.duration = std::max(0.0, time - since);
            stretches.push_back(now);
            now.place = now.place_after(now.duration);
            now.velocity += now.acceleration * now.duration;
            since = time;
        };
        for (const Collision& hit : input.advanced.collisions) {
            if (hit.second != Partner::of_surface(surface_)) continue;
            go_on_to(hit.time);
            now.velocity += change(hit, state);
        }
        go_on_to(input.sample.time);
        if (std::abs(now.place - place) > near * context_.box().size[axis_]) {
            const double time = input.sample.time - last_->time;
            if (time > 0.0) times_.add({last_->place, (place - last_->place) / time, 0.0, time});
            return;
        }
        for (const MotionStretch& stretch : stretches) times_.add(stretch);
    }

    PanelContext context_;
    std::int32_t surface_;
    int axis_;
    Residence times_;
    std::optional<std::pair<double, double>> range_;
    std::optional<Moment> last_;
    std::optional<PistonOverGas> law_;
};

plot::Polyline curve_of(const PistonOverGas& piston, const plot::Plot& plot) {
    constexpr int points = 200;
    const double length = plot.x.high - plot.x.low, width = length / shown_bins;
    std::vector<double> along, up;
    for (int i = 0; i <= points; ++i) {
        along.push_back(plot.x.low + length * i / points);
        up.push_back(percent * width * piston.density_at(along.back()));
    }
    plot::Polyline line;
    line.part = "theory";
    line.x = plot::column(plot.columns[0], std::move(along));
    line.y = plot::column(plot.columns[2], std::move(up));
    line.stroke = of_law;
    line.is_thinned = false;
    line.depth = 1;
    return line;
}

void check_piston_histogram(PanelSpec& panel, const Node& node, Reading& reading) {
    check_moving(panel, node, reading);
    require_one(panel, panel.options.as<MovingOptions>().surfaces, node, reading);
}

std::unique_ptr<Panel> make_piston_histogram(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const std::int32_t surface = spec.options.as<MovingOptions>().surfaces.front();
    CurveSubject subject{.shape = CurveSubject::Shape::steps, .points = shown_bins};
    subject.meter = [context, surface] { return std::make_unique<PistonMeter>(context, surface); };
    subject.lines = lines_of_surfaces(language, context.box(), {surface});
    const std::string title = say(language, "Distribution of positions");
    subject.titles = {
        plot::text_of(language, Phrase{"{}: {}"},
                      {title, plot::named(subject.lines.front().name, subject.lines.front().role,
                                          plot::Swatch::line, 0)}),
        title};
    if (spec.title) subject.titles = {plot::Text(escape_markup(*spec.title))};
    subject.names = {{.words = {subject.lines.front().name}}};
    subject.along = quantities::position;
    subject.up = quantities::per_cent;
    subject.height = [language](double width) { return percent_per(language, width); };
    subject.account = [language](const CurveValues& values, std::size_t) -> std::string {
        const std::vector<double>& shares = values.y.front();
        const auto highest = std::ranges::max_element(shares);
        if (highest == shares.end() || !(*highest > 0.0)) return "";
        return say(language, "the highest bar holds {} % of the time",
                   three_digits(language, *highest));
    };
    if (spec.theory && law(context.gas, LawOf::piston, {.surface = surface}))
        subject.add = [language](const CurveValues* values, plot::Plot& plot) {
            plot.notes.push_back(
                {.entries = {{.swatch = of_law, .words = {say(language, "ideal gas")}}}});
            if (values != nullptr)
                plot.layers.emplace_back(
                    curve_of(LawNumbers(values->numbers.front()).piston(), plot));
        };
    return std::make_unique<CurvePanel>(context, std::move(subject));
}

}  // namespace

PanelKind piston_histogram_kind() {
    using enum Ability;
    return {.name = "piston-histogram",
            .words = Phrase{"piston histogram"},
            .shows =
                "The share of the time that a moving wall or partition spends at each position, "
                "with the exact distribution for a free piston over an ideal gas.",
            .make = make_piston_histogram,
            .abilities = {theory, means, comparison},
            .keys = moving_keys(),
            .rule = check_piston_histogram,
            .laws = always(std::vector{LawOf::piston}),
            .measured_at = measured_at(&MovingOptions::surfaces)};
}

}  // namespace carom
