#include "app/report/run_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "app/report/facts.h"
#include "runs/number_json.h"
#include "scene/scene.h"
#include "util/joined.h"
#include "util/text.h"

namespace carom {
namespace {

std::string number(std::optional<double> value) {
    return value && std::isfinite(*value) ? fmt::format("{:.5g}", *value) : "—";
}

std::string number(const Amount& amount) { return number(amount.value); }

// An error or an overlap over what it is compared with.
Amount relative(std::optional<double> value) { return {value, quantities::number}; }

Amount energy(std::optional<double> value) { return {value, quantities::energy}; }

std::string vector(const std::vector<std::optional<double>>& components) {
    if (components.size() == 1) return number(components[0]);
    std::vector<std::string> words;
    for (const auto& component : components) words.push_back(number(component));
    return fmt::format("({})", fmt::join(words, ", "));
}

Json vector_value(const std::vector<std::optional<double>>& components, const Quantity& quantity) {
    Json list = Json::array();
    for (const auto& component : components) list.push_back(Amount{component, quantity});
    return list;
}

Fact collisions(const RunReport& report) {
    const CollisionCounts& counts = report.collisions;
    const double of_each =
        2.0 * static_cast<double>(counts.particle) / static_cast<double>(report.particles);
    return {"collisions",
            Json{{"particle", counts.particle},
                 {"wall", counts.wall},
                 {"per_particle", Amount{of_each, quantities::count}}},
            "collisions",
            fmt::format("{} between particles ({:.3g} for each), {} with walls",
                        grouped(counts.particle), of_each, grouped(counts.wall))};
}

constexpr const char* no_error = "not conserved: an infinite mass moves";

// The terms of the energy balance in words, for runs in which surfaces act.
std::string account_words(const EnergyAccount& account) {
    std::vector<std::string> parts{"kinetic " + number(account.kinetic)};
    const auto add = [&](const char* name, double value) {
        if (value != 0.0) parts.push_back(fmt::format("{} {}", name, number(value)));
    };
    add("potential", account.potential);
    add("pistons", account.pistons);
    add("work", account.work);
    add("heat", account.heat);
    const std::string error = account.relative_error
                                  ? fmt::format(", relative error {:.1e}", *account.relative_error)
                                  : fmt::format("; {}", no_error);
    return fmt::format("{} at the end{}", fmt::join(parts, ", "), error);
}

Json account_value(const EnergyAccount& account) {
    return Json{
        {"kinetic", energy(account.kinetic)}, {"potential", energy(account.potential)},
        {"pistons", energy(account.pistons)}, {"work", energy(account.work)},
        {"heat", energy(account.heat)},       {"relative_error", relative(account.relative_error)}};
}

std::string energy_words(const RunSummary& summary) {
    if (!summary.largest_energy_error) return no_error;
    if (*summary.largest_energy_error == 0.0)
        return number(summary.energy_initial) + ", exactly conserved";
    return fmt::format("{}, relative error {:.1e}", number(summary.energy_initial),
                       *summary.largest_energy_error);
}

Fact energies(const RunReport& report) {
    const RunSummary& summary = report.summary;
    Fact fact{"energy",
              Json{{"initial", energy(summary.energy_initial)},
                   {"final", energy(summary.energy_final)},
                   {"largest_relative_error", relative(summary.largest_energy_error)}},
              "energy", ""};
    if (report.account) {
        fact.value["account"] = account_value(*report.account);
        fact.words = account_words(*report.account);
    } else {
        fact.words = energy_words(summary);
    }
    return fact;
}

// On a line its first component.
std::vector<std::optional<double>> impulse_of(const SurfaceTotals& its, int dimension) {
    if (dimension == 1) return {its.impulse[0]};
    return {its.impulse[0], its.impulse[1]};
}

std::string surface_rows(const std::vector<SurfaceReport>& surfaces, int dimension) {
    std::size_t width = 7;
    for (const SurfaceReport& surface : surfaces)
        width = std::max(width, static_cast<std::size_t>(code_points(surface.name)));
    std::string text = fmt::format("  {:<{}}  {:>9}  {:>23}  {:>10}  {:>10}  {}\n", "surface",
                                   width, "hits", "impulse", "work", "heat", "position");
    for (const SurfaceReport& surface : surfaces) {
        const SurfaceTotals& its = surface.totals;
        const std::string padding(width - static_cast<std::size_t>(code_points(surface.name)), ' ');
        const std::string position =
            surface.position
                ? fmt::format("{} ± {}, {} at the end", number(surface.position->mean),
                              number(surface.position->deviation), number(surface.position->last))
                : "—";
        text += fmt::format("  {}{}  {:>9}  {:>23}  {:>10}  {:>10}  {}\n", surface.name, padding,
                            its.hits, vector(impulse_of(its, dimension)), number(its.work),
                            number(its.heat), position);
    }
    return text;
}

// In a box with surfaces that act, obstacles or gravity.
Facts surfaces(const RunReport& report, int dimension) {
    if (report.surfaces.empty()) return {};
    Json list = Json::array();
    for (const SurfaceReport& surface : report.surfaces) {
        const SurfaceTotals& its = surface.totals;
        const auto position_of = [](double value) { return Amount{value, quantities::position}; };
        Json position = nullptr;
        if (surface.position)
            position = Json{{"mean", position_of(surface.position->mean)},
                            {"deviation", position_of(surface.position->deviation)},
                            {"last", position_of(surface.position->last)}};
        list.push_back(
            Json{{"name", surface.name},
                 {"hits", its.hits},
                 {"impulse", vector_value(impulse_of(its, dimension), quantities::momentum)},
                 {"work", energy(its.work)},
                 {"heat", energy(its.heat)},
                 {"position", std::move(position)}});
    }
    return {{"surfaces", std::move(list), "", surface_rows(report.surfaces, dimension) + "\n"}};
}

Fact momentum(const RunSummary& summary) {
    return {"momentum",
            Json{{"initial", vector_value(summary.momentum_initial, quantities::momentum)},
                 {"final", vector_value(summary.momentum_final, quantities::momentum)}},
            "momentum",
            fmt::format("{} at the start, {} at the end", vector(summary.momentum_initial),
                        vector(summary.momentum_final))};
}

std::string pressure_words(const RunReport& report) {
    const RunSummary& summary = report.summary;
    if (!report.surfaces.empty()) {
        if (!summary.wall_pressure)
            return "differs from surface to surface; see what each has received";
        const double since = summary.pressure_since.value_or(0.0);
        return number(summary.wall_pressure) + " on the walls" +
               (since > 0.0 ? fmt::format(", from time {} on", plain_number(since)) : "");
    }
    const std::string wall = summary.wall_pressure ? number(summary.wall_pressure) + " on the walls"
                                                   : "no solid walls to press on";
    if (!summary.virial_pressure) return wall;
    return fmt::format("{}, {} by the virial", wall, number(summary.virial_pressure));
}

Fact pressure(const RunReport& report, int dimension) {
    const RunSummary& summary = report.summary;
    const Quantity pressure = quantities::pressure(dimension);
    return {"pressure",
            Json{{"wall", Amount{summary.wall_pressure, pressure}},
                 {"virial", Amount{summary.virial_pressure, pressure}},
                 {"since", Amount{summary.pressure_since, quantities::time}}},
            dimension == 1 ? "force" : "pressure", pressure_words(report)};
}

// An overlap smaller than the round-off of the coordinates counts as contact.
Fact overlap(double largest) {
    return {"overlap", Json{{"largest_relative", relative(largest)}}, "overlap",
            largest == 0.0 ? "none" : fmt::format("at most {:.1e} of a contact distance", largest)};
}

Fact precision(const Scene& scene, int bits) {
    Fact fact{"precision_bits", bits};
    if (bits == bits_of_double) return fact;
    fact.label = "numbers";
    fact.words = fmt::format("of {} bits{}", bits, scene.run.bits ? "" : ", found by trial");
    return fact;
}

// Formats a length, also one too small for a double, from its decimal logarithm.
std::string length(double value, double log10) {
    if (value > 1e-300 || std::isinf(log10)) return fmt::format("{:.2g}", value);
    return fmt::format("{:.1f}e{:.0f}", std::pow(10.0, log10 - std::floor(log10)),
                       std::floor(log10));
}

std::string way_back(const ReversalReport& report) {
    if (!report.events_back) return "the run ends before the gas can return";
    const std::string events = fmt::format("{} out, {} back", counted(report.events_out, "event"),
                                           grouped(*report.events_back));
    if (report.home == report.at) return "the gas does not retrace its path at all";
    if (!report.distance) return "another reversal comes before the gas is back; " + events;
    const ReturnDistance& d = *report.distance;
    const bool is_left = report.home < 2.0 * report.at;
    return fmt::format("return error {} (r.m.s. {}){}; {}", length(d.largest, d.log10_largest),
                       length(d.root_mean_square, d.log10_root_mean_square),
                       is_left ? fmt::format(" at time {}, where the gas stops retracing its path",
                                             plain_number(report.home))
                               : "",
                       events);
}

Json reversal(const ReversalReport& report, int bits) {
    const auto length = [&](double ReturnDistance::*member) {
        return report.distance ? Amount{(*report.distance).*member, quantities::length} : Amount{};
    };
    const auto logarithm = [&](double ReturnDistance::*member) {
        return Amount{length(member).value, quantities::length.logarithm()};
    };
    return Json{{"at", Amount{report.at, quantities::time}},
                {"bits", bits},
                {"largest_return_distance", length(&ReturnDistance::largest)},
                {"root_mean_square", length(&ReturnDistance::root_mean_square)},
                {"log10_largest_return_distance", logarithm(&ReturnDistance::log10_largest)},
                {"log10_root_mean_square", logarithm(&ReturnDistance::log10_root_mean_square)},
                {"events",
                 {{"out", report.events_out},
                  {"back", report.events_back ? Json(*report.events_back) : Json()}}}};
}

Facts reversals(const RunReport& report) {
    Json list = Json::array();
    Facts facts;
    for (const ReversalReport& one : report.reversals) {
        list.push_back(reversal(one, report.bits));
        facts.push_back({"", nullptr, fmt::format("reversed at {}", one.at), way_back(one)});
    }
    facts.push_back({"reversals", std::move(list)});
    return facts;
}

std::string species_rows(const Scene& scene, const RunSummary& summary) {
    std::size_t width = 7;
    for (const Species& species : scene.gas.species)
        width = std::max(width, static_cast<std::size_t>(code_points(species.name)));
    std::string text = fmt::format("  {:<{}}  {:>10}  {:>12}  {:>12}\n", "species", width,
                                   "particles", "mean energy", "mean speed");
    for (std::size_t s = 0; s < summary.species.size(); ++s) {
        const std::string& name = scene.gas.species[s].name;
        const std::string padding(width - static_cast<std::size_t>(code_points(name)), ' ');
        const SpeciesMeans& means = summary.species[s];
        text += fmt::format("  {}{}  {:>10}  {:>12}  {:>12}\n", name, padding, means.count,
                            number(means.energy), number(means.speed));
    }
    return text;
}

Fact species(const Scene& scene, const RunSummary& summary) {
    Json list = Json::array();
    for (std::size_t s = 0; s < summary.species.size(); ++s)
        list.push_back(Json{{"name", scene.gas.species[s].name},
                            {"count", summary.species[s].count},
                            {"mean_energy", energy(summary.species[s].energy)},
                            {"mean_speed", Amount{summary.species[s].speed, quantities::speed}}});
    return {"species", std::move(list), "", "\n" + species_rows(scene, summary) + "\n"};
}

// The number of bins that contain all but 0.5 % of the counts.
std::size_t shown_bins(const BinnedCounts& bins) {
    const std::int64_t total =
        std::accumulate(bins.counts.begin(), bins.counts.end(), std::int64_t{0});
    std::int64_t seen = 0;
    std::size_t shown = 0;
    while (shown < bins.counts.size() && 200 * (total - seen) > total) seen += bins.counts[shown++];
    return std::max<std::size_t>(1, shown);
}

// A histogram in one line: 0 ▂▆█▇▅▃▂▁ 6.5
std::string bars(const BinnedCounts& bins) {
    constexpr std::size_t most_columns = 40;
    constexpr const char* heights[] = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    const std::size_t shown = shown_bins(bins);
    const std::size_t together = (shown + most_columns - 1) / most_columns;
    std::vector<std::int64_t> columns((shown + together - 1) / together);
    for (std::size_t bin = 0; bin < shown; ++bin) columns[bin / together] += bins.counts[bin];
    const auto tallest = static_cast<double>(*std::ranges::max_element(columns));
    std::string text = "0 ";
    for (const std::int64_t count : columns)
        text +=
            heights[tallest > 0.0
                        ? static_cast<int>(std::ceil(8.0 * static_cast<double>(count) / tallest))
                        : 0];
    const std::size_t end = std::min(columns.size() * together, bins.counts.size());
    return text + fmt::format(" {:.4g}", bins.edges[end]);
}

Json histogram(const BinnedCounts& bins, const Quantity& quantity) {
    Json edges = Json::array();
    for (const double edge : bins.edges) edges.push_back(Amount{edge, quantity});
    return Json{{"edges", std::move(edges)}, {"counts", bins.counts}};
}

Facts histograms(const RunSummary& summary) {
    return {{"", nullptr, "speeds", bars(summary.speeds)},
            {"", nullptr, "energies", bars(summary.energies)},
            {"histograms", Json{{"speed", histogram(summary.speeds, quantities::speed)},
                                {"energy", histogram(summary.energies, quantities::energy)}}}};
}

std::string heading(const Scene& scene, const RunReport& report) {
    return fmt::format("{}\n{}: {} in {}, time 0 to {}, {} samples, seed {}\n\n",
                       printable(scene.title), printable(scene.source.path),
                       counted(report.particles, "particle"),
                       scene.gas.box.dimension == 1 ? "one dimension" : "two dimensions",
                       scene.run.until, grouped(report.samples), scene.seed);
}

Facts facts_of(const Scene& scene, const RunReport& report) {
    const RunSummary& summary = report.summary;
    const auto events = static_cast<double>(events_of(report.collisions));
    const Amount temperature{summary.temperature, quantities::temperature};
    return joined<Fact>(
        {{{"carom", CAROM_VERSION, "", heading(scene, report)},
          {"scene", scene.source.path},
          {"seed", scene.seed},
          {"dimension", scene.gas.box.dimension},
          {"particles", report.particles},
          {"time", Amount{scene.run.until, quantities::time}},
          collisions(report),
          ties_fact(report.collisions.ties),
          energies(report),
          momentum(summary),
          {"temperature", temperature, "temperature", number(temperature)},
          pressure(report, scene.gas.box.dimension),
          overlap(summary.largest_overlap),
          precision(scene, report.bits),
          {"state", report.state}},
         reversals(report),
         {species(scene, summary)},
         surfaces(report, scene.gas.box.dimension),
         histograms(summary),
         {{"seconds", Json{{"total", report.seconds.total},
                           {"events_per_second", events / report.seconds.simulate}}}}});
}

}  // namespace

std::string run_table(const Scene& scene, const RunReport& report) {
    constexpr int label_width = 15;
    return text_table(facts_of(scene, report), label_width);
}

// A line for each key: long lists of numbers do not fill the screen.
std::string run_json(const Scene& scene, const RunReport& report) {
    const Json object = json_of(facts_of(scene, report));
    std::string text;
    for (const auto& [name, value] : object.items())
        text += (text.empty() ? "{\n  " : ",\n  ") + text_of(name) + ": " + text_of(value);
    return text + "\n}\n";
}

std::string run_timings(const RunReport& report) {
    const RunSeconds& seconds = report.seconds;
    const auto events = static_cast<double>(events_of(report.collisions));
    const auto line = [](const char* stage, double time, const std::string& words) {
        return fmt::format("  {:<10} {:>8.2f} s   {}\n", stage, time, words);
    };
    return line("prepare", seconds.prepare, "placement and equilibration") +
           line("simulate", seconds.simulate,
                fmt::format("{:.3g} events/s", events / seconds.simulate)) +
           line("samples", seconds.samples,
                fmt::format("{:.3g} ms a sample",
                            1e3 * seconds.samples / static_cast<double>(report.samples))) +
           line("total", seconds.total, "");
}

}  // namespace carom
