// The flux of particles across a partition or a line in each direction, and of the energy that they
// carry; with the prediction of kinetic theory while it holds.
#include <cmath>
#include <limits>

#include "panels/chosen.h"
#include "panels/instruments/crossings.h"
#include "panels/instruments/flux_theory.h"
#include "panels/means/trailing.h"
#include "panels/plot/window.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "scene/describe.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

/// What particles transport across a line.
enum class Carried { particles, energy, mean_energy };

struct FluxOptions {
    CrossedAt at = {};
    Carried carried = Carried::particles;
};

const FluxOptions& options_of_flux(const PanelSpec& panel) {
    return panel.options.as<FluxOptions>();
}

std::vector<Binding<FluxOptions>> flux_keys() {
    return joined<FluxOptions>(
        bind_within(&FluxOptions::at, crossed_keys()),
        std::vector{bind_key("carried", &FluxOptions::carried,
                             one_of<Carried>({{"particles", Carried::particles},
                                              {"energy", Carried::energy},
                                              {"mean-energy", Carried::mean_energy}}),
                             "What it shows of the particles that cross: number per unit of time, "
                             "energy per unit of time, or mean energy.")});
}

// A flux needs a partition that lets particles through, or a line.
void check_flux(PanelSpec& panel, const Node& node, Reading& reading) {
    if (panel.of.size() > 1)
        reading.errors.add(*find(node, "of"), "a flux takes one item in `of`",
                           "keep one, or give a panel for each");
    if (is_written(node, "line")) return check_line(node, reading);
    SurfaceNumbers& surfaces = panel.options.change<FluxOptions>().at.surfaces;
    keep_suitable(panel, surfaces, passable_surfaces(reading), node, reading);
    require_one(panel, surfaces, node, reading);
}

// What has crossed up to a time, and what should have crossed according to theory.
struct FluxAccount {
    double time = 0.0;
    std::array<FluxRates, 2> measured{}, expected{};
    std::array<double, 2> unknown{};  ///< time of which theory says nothing
};

double flux_since(const FluxRates& from, const FluxRates& to, double time, Carried carried) {
    const double particles = to.particles - from.particles, energy = to.energy - from.energy;
    switch (carried) {
        case Carried::particles:
            return particles / time;
        case Carried::energy:
            return energy / time;
        case Carried::mean_energy:
            return particles > 0.0 ? energy / particles : std::numeric_limits<double>::quiet_NaN();
    }
    return 0.0;
}

class FluxMeter {
  public:
    FluxMeter(const PanelContext& context, const PanelSpec& spec, Over over,
              std::shared_ptr<FluxTheory> theory)
        : members_(context, {choices(spec).front()}),
          crossings_(context.box(), context.particles,
                     crossed_line(context.box(), options_of_flux(spec).at),
                     members_.lists().front(), velocity_changes(context.run())),
          theory_(std::move(theory)),
          accounts_(over),
          carried_(options_of_flux(spec).carried) {}

    // The flux in each direction; then, if there is a theory, its prediction for each direction.
    std::vector<double> operator()(const FrameInput& o) {
        FluxAccount now{.time = o.tick.time};
        const CrossingTotals& totals = crossings_.see(o.sample, o.advanced.collisions);
        for (std::size_t way = 0; way < 2; ++way)
            now.measured.at(way) = {static_cast<double>(totals.count.at(way)),
                                    totals.energy.at(way)};
        if (members_.see(o.sample)) crossings_.choose(members_.lists().front());
        if (theory_) add_theory(o, now);
        accounts_.add(now, o.is_sample);
        const FluxAccount &from = accounts_.from(), &to = accounts_.to();
        const double time = to.time - from.time;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        std::vector<double> all;
        for (std::size_t way = 0; way < 2; ++way)
            all.push_back(
                time > 0.0 ? flux_since(from.measured.at(way), to.measured.at(way), time, carried_)
                           : none);
        for (std::size_t way = 0; theory_ && way < 2; ++way)
            all.push_back(
                time > 0.0 && to.unknown.at(way) == from.unknown.at(way)
                    ? flux_since(from.expected.at(way), to.expected.at(way), time, carried_)
                    : none);
        return all;
    }

  private:
    // Integrates the rates of the theory by the trapezoidal rule: they change little between
    // samples.
    void add_theory(const FrameInput& o, FluxAccount& now) {
        const std::array<FluxRates, 2> rates = theory_->at(o);
        if (!accounts_.empty()) {
            const FluxAccount& last = accounts_.last();
            const double step = 0.5 * (now.time - last.time);
            for (std::size_t way = 0; way < 2; ++way) {
                const FluxRates &a = last_rates_.at(way), &b = rates.at(way);
                const FluxRates sum{a.particles + b.particles, a.energy + b.energy};
                const bool is_known = std::isfinite(sum.particles);
                now.unknown.at(way) = last.unknown.at(way) + (is_known ? 0.0 : 2.0 * step);
                now.expected.at(way) = last.expected.at(way);
                if (!is_known) continue;
                now.expected.at(way).particles += step * sum.particles;
                now.expected.at(way).energy += step * sum.energy;
            }
        }
        if (o.is_sample) last_rates_ = rates;
    }

    Members members_;
    LineCrossings crossings_;
    std::shared_ptr<FluxTheory> theory_;
    Trailing<FluxAccount> accounts_;
    Carried carried_;
    std::array<FluxRates, 2> last_rates_{};
};

Phrase flux_title(Carried carried) {
    switch (carried) {
        case Carried::particles:
            return Phrase{"Crossing rate"};
        case Carried::energy:
            return Phrase{"Energy current"};
        case Carried::mean_energy:
            return Phrase{"Mean energy at the crossing"};
    }
    return {};
}

Quantity flux_quantity(Carried carried) {
    switch (carried) {
        case Carried::particles:
            return quantities::rate.named(Phrase{"crossing rate"});
        case Carried::energy:
            return quantities::energy_current;
        case Carried::mean_energy:
            return quantities::mean_energy;
    }
    return {};
}

SeriesSubject flux(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const Box& box = context.box();
    const auto& [at, carried] = options_of_flux(spec);
    const Over over = spec.over.value_or(usual_window(context.run()));
    const CrossedLine line = crossed_line(box, at);
    std::shared_ptr<FluxTheory> theory;
    if (spec.theory)
        theory = flux_theory(
            context, line,
            at.line ? std::optional<std::int32_t>() : std::optional(at.surfaces.front()),
            members(context, choices(spec).front()));
    SeriesSubject subject{{.title = say(language, flux_title(carried)),
                           .quantity = flux_quantity(carried),
                           .needs_collisions = true}};
    const std::array<Phrase, 2> ways = ways_across(line.axis);
    for (std::size_t way = 0; way < 2; ++way)
        subject.lines.push_back({std::string(ways.at(way).english),
                                 say(language, ways.at(way)),
                                 {.of = plot::Role::Of::run, .index = way}});
    subject.compared_title = say(language, "{} {}", subject.title, say(language, ways[0]));
    subject.notes = {
        words_of_window(context.wording(), over, Phrase{"mean since the last sample"})};
    if (theory) {
        for (std::size_t way = 0; way < 2; ++way)
            subject.lines.push_back({"theory, " + std::string(ways.at(way).english), "",
                                     subject.lines.at(way).role, true});
        subject.theory_note = say(language, "dashed: kinetic theory");
    }
    subject.read = FluxMeter(context, spec, over, std::move(theory));
    return subject;
}

}  // namespace

PanelKind flux_kind() {
    using enum Ability;
    return series_kind<flux>(
        {.name = "flux",
         .words = Phrase{"flux"},
         .shows = "Particles that cross a partition or a `line` per unit of time, in each "
                  "direction, the energy that they carry, or their mean energy (`carried`), with "
                  "the values of kinetic theory.",
         .abilities = {of, over, theory, means, comparison},
         .keys = option_keys(flux_keys()),
         .rule = check_flux,
         .measured_at = crossed_at(&FluxOptions::at),
         .work = always(PanelWork{.flights = PanelWork::Flights::recorded})});
}

}  // namespace carom
