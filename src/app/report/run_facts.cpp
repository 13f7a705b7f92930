#include "app/report/run_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "app/report/facts.h"
#include "physics/units/number_text.h"
#include "physics/units/unit_table.h"
#include "runs/number_json.h"
#include "scene/scene.h"
#include "util/joined.h"
#include "util/text.h"

namespace carom {
namespace {

std::string number(std::optional<double> value) {
    return value && std::isfinite(*value) ? fmt::format("{:.5g}", *value) : "—";
}

std::string number(const Amount& amount) {
    if (!amount.value || !std::isfinite(*amount.value) || amount.units != UnitSystem::real)
        return number(amount.value);
    const ShownUnit unit = shown_unit(amount.quantity, amount.units, *amount.value);
    return number(unit.factor * *amount.value) +
           unit_after_number(amount.units, amount.quantity, *amount.value);
}

// An error or an overlap over what it is compared with.
Amount relative(std::optional<double> value) { return {value, quantities::number}; }

Amount energy(std::optional<double> value, UnitSystem units) {
    return {value, quantities::energy, units};
}

/// The components of a vector.
struct Amounts {
    std::vector<std::optional<double>> values;
    Quantity quantity;
    UnitSystem units;
};

std::string vector(const Amounts& components) {
    if (components.values.size() == 1)
        return number({components.values[0], components.quantity, components.units});
    double largest = 0.0;
    for (const auto& value : components.values)
        largest = std::max(largest, std::abs(value.value_or(0.0)));
    const double factor = components.units == UnitSystem::real
                              ? shown_unit(components.quantity, components.units, largest).factor
                              : 1.0;
    std::vector<std::string> words;
    for (const auto& value : components.values)
        words.push_back(value ? number(factor * *value) : number(value));
    return fmt::format("({}){}", fmt::join(words, ", "),
                       unit_after_number(components.units, components.quantity, largest));
}

Json vector_value(const Amounts& components) {
    Json list = Json::array();
    for (const auto& value : components.values)
        list.push_back(Amount{value, components.quantity, components.units});
    return list;
}

Fact number_fact(const char* name, const char* label, const Amount& amount) {
    return {name, amount, label, number(amount)};
}

// A table of things with the same facts, of which the first is the name: for programs a list, for
// people a column below each label, with this least width.
Fact table(const char* name, const std::vector<Facts>& rows, const std::vector<int>& widths) {
    Fact fact{name, Json::array()};
    if (rows.empty()) return fact;
    int width = code_points(rows.front().front().label);
    for (const Facts& row : rows) width = std::max(width, code_points(row.front().words));
    const auto add_line = [&](const Facts& row, std::string Fact::*cell) {
        const std::string& first = row.front().*cell;
        fact.words +=
            "  " + first + std::string(static_cast<std::size_t>(width - code_points(first)), ' ');
        for (std::size_t k = 1; k < row.size(); ++k)
            fact.words += fmt::format("  {:>{}}", row[k].*cell, widths[k - 1]);
        fact.words += "\n";
    };
    add_line(rows.front(), &Fact::label);
    for (const Facts& row : rows) {
        add_line(row, &Fact::words);
        fact.value.push_back(json_of(row));
    }
    fact.words += "\n";
    return fact;
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

// The terms of the energy balance, for runs in which surfaces act; in words only those that are
// there.
Facts account_terms(const EnergyAccount& account, UnitSystem units) {
    Facts terms{number_fact("kinetic", "kinetic", energy(account.kinetic, units))};
    const auto add = [&](const char* name, double value) {
        terms.push_back(number_fact(name, value == 0.0 ? "" : name, energy(value, units)));
    };
    add("potential", account.potential);
    add("pistons", account.pistons);
    add("work", account.work);
    add("heat", account.heat);
    terms.push_back({"relative_error", relative(account.relative_error)});
    return terms;
}

std::string account_words(const Facts& terms, std::optional<double> relative_error) {
    std::vector<std::string> parts;
    for (const Fact& term : terms)
        if (!term.label.empty()) parts.push_back(term.label + " " + term.words);
    const std::string error = relative_error
                                  ? fmt::format(", relative error {:.1e}", *relative_error)
                                  : fmt::format("; {}", no_error);
    return fmt::format("{} at the end{}", fmt::join(parts, ", "), error);
}

std::string energy_words(const RunReport& report) {
    const RunSummary& summary = report.summary;
    const std::string initial = number(energy(summary.energy_initial, report.units));
    if (!summary.largest_energy_error) return no_error;
    if (*summary.largest_energy_error == 0.0) return initial + ", exactly conserved";
    return fmt::format("{}, relative error {:.1e}", initial, *summary.largest_energy_error);
}

Fact energies(const RunReport& report) {
    const RunSummary& summary = report.summary;
    Fact fact{"energy",
              Json{{"initial", energy(summary.energy_initial, report.units)},
                   {"final", energy(summary.energy_final, report.units)},
                   {"largest_relative_error", relative(summary.largest_energy_error)}},
              "energy", ""};
    if (report.account) {
        const Facts terms = account_terms(*report.account, report.units);
        fact.value["account"] = json_of(terms);
        fact.words = account_words(terms, report.account->relative_error);
    } else {
        fact.words = energy_words(report);
    }
    return fact;
}

std::vector<std::optional<double>> impulse_of(const SurfaceTotals& its, int dimension) {
    std::vector<std::optional<double>> components;
    for (int axis = 0; axis < dimension; ++axis) components.emplace_back(its.impulse[axis]);
    return components;
}

Fact position_fact(const std::optional<SurfaceReport::Position>& position, UnitSystem units) {
    if (!position) return {"position", nullptr, "position", "—"};
    const auto value_of = [units](double value) {
        return Amount{value, quantities::position, units};
    };
    return {"position",
            Json{{"mean", value_of(position->mean)},
                 {"deviation", value_of(position->deviation)},
                 {"last", value_of(position->last)}},
            "position",
            fmt::format("{} ± {}, {} at the end", number(value_of(position->mean)),
                        number(value_of(position->deviation)), number(value_of(position->last)))};
}

// In a box with surfaces that act, obstacles or gravity.
Facts surfaces(const RunReport& report, int dimension) {
    if (report.surfaces.empty()) return {};
    std::vector<Facts> rows;
    for (const SurfaceReport& surface : report.surfaces) {
        const SurfaceTotals& its = surface.totals;
        const Amounts impulse{impulse_of(its, dimension), quantities::momentum, report.units};
        rows.push_back({{"name", surface.name, "surface", surface.name},
                        {"hits", its.hits, "hits", fmt::format("{}", its.hits)},
                        {"impulse", vector_value(impulse), "impulse", vector(impulse)},
                        number_fact("work", "work", energy(its.work, report.units)),
                        number_fact("heat", "heat", energy(its.heat, report.units)),
                        position_fact(surface.position, report.units)});
    }
    return {table("surfaces", rows, {9, 23, 10, 10, 0})};
}

Fact momentum(const RunReport& report) {
    const auto of = [&](const std::vector<std::optional<double>>& components) {
        return Amounts{components, quantities::momentum, report.units};
    };
    const Amounts initial = of(report.summary.momentum_initial),
                  last = of(report.summary.momentum_final);
    return {"momentum", Json{{"initial", vector_value(initial)}, {"final", vector_value(last)}},
            "momentum",
            fmt::format("{} at the start, {} at the end", vector(initial), vector(last))};
}

std::string pressure_words(const RunReport& report, const Quantity& pressure) {
    const RunSummary& summary = report.summary;
    const auto words = [&](std::optional<double> value) {
        return number({value, pressure, report.units});
    };
    if (!report.surfaces.empty()) {
        if (!summary.wall_pressure)
            return "differs from surface to surface; see what each has received";
        const double since = summary.pressure_since.value_or(0.0);
        return words(summary.wall_pressure) + " on the walls" +
               (since > 0.0 ? fmt::format(", from time {} on",
                                          plain_number({Language::english, report.units},
                                                       quantities::time, since))
                            : "");
    }
    const std::string wall = summary.wall_pressure ? words(summary.wall_pressure) + " on the walls"
                                                   : "no solid walls to press on";
    if (!summary.virial_pressure) return wall;
    return fmt::format("{}, {} by the virial", wall, words(summary.virial_pressure));
}

Fact pressure(const RunReport& report, int dimension) {
    const RunSummary& summary = report.summary;
    const Quantity pressure = quantities::pressure(dimension);
    return {"pressure",
            Json{{"wall", Amount{summary.wall_pressure, pressure, report.units}},
                 {"virial", Amount{summary.virial_pressure, pressure, report.units}},
                 {"since", Amount{summary.pressure_since, quantities::time, report.units}}},
            dimension == 1 ? "force" : "pressure", pressure_words(report, pressure)};
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
std::string length(double value, double log10, UnitSystem units) {
    if (units == UnitSystem::real && (value > 1e-300 || std::isinf(log10)))
        return number_words(units, quantities::length, value);
    if (units == UnitSystem::real) return length(value, log10, UnitSystem::reduced) + " nm";
    if (value > 1e-300 || std::isinf(log10)) return fmt::format("{:.2g}", value);
    return fmt::format("{:.1f}e{:.0f}", std::pow(10.0, log10 - std::floor(log10)),
                       std::floor(log10));
}

std::string way_back(const ReversalReport& report, UnitSystem units) {
    if (!report.events_back) return "the run ends before the gas can return";
    const std::string events = fmt::format("{} out, {} back", counted(report.events_out, "event"),
                                           grouped(*report.events_back));
    if (report.home == report.at) return "the gas does not retrace its path at all";
    if (!report.distance) return "another reversal comes before the gas is back; " + events;
    const ReturnDistance& d = *report.distance;
    const bool is_left = report.home < 2.0 * report.at;
    return fmt::format(
        "return error {} (r.m.s. {}){}; {}", length(d.largest, d.log10_largest, units),
        length(d.root_mean_square, d.log10_root_mean_square, units),
        is_left
            ? fmt::format(" at time {}, where the gas stops retracing its path",
                          plain_number({Language::english, units}, quantities::time, report.home))
            : "",
        events);
}

Json reversal(const ReversalReport& report, int bits, UnitSystem units) {
    const auto length = [&](double ReturnDistance::*member) {
        return report.distance ? Amount{(*report.distance).*member, quantities::length, units}
                               : Amount{};
    };
    const auto logarithm = [&](double ReturnDistance::*member) {
        return Amount{length(member).value, quantities::length.logarithm(), units};
    };
    return Json{{"at", Amount{report.at, quantities::time, units}},
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
        list.push_back(reversal(one, report.bits, report.units));
        facts.push_back(
            {"", nullptr,
             fmt::format("reversed at {}", number_words(report.units, quantities::time, one.at)),
             way_back(one, report.units)});
    }
    facts.push_back({"reversals", std::move(list)});
    return facts;
}

Fact species(const Scene& scene, const RunReport& report) {
    const RunSummary& summary = report.summary;
    std::vector<Facts> rows;
    for (std::size_t s = 0; s < summary.species.size(); ++s) {
        const std::string& name = scene.gas.species[s].name;
        const SpeciesMeans& means = summary.species[s];
        rows.push_back(
            {{"name", name, "species", name},
             {"count", means.count, "particles", fmt::format("{}", means.count)},
             number_fact("mean_energy", "mean energy", energy(means.energy, report.units)),
             number_fact("mean_speed", "mean speed",
                         {means.speed, quantities::speed, report.units})});
    }
    Fact fact = table("species", rows, {10, 12, 12});
    fact.words.insert(0, "\n");
    return fact;
}

Facts readings(const RunReport& report) {
    if (report.readings.empty()) return {};
    const bool has_errors = std::ranges::any_of(
        report.readings, [](const LastReading& reading) { return std::isfinite(reading.error); });
    std::vector<Facts> rows;
    for (const LastReading& reading : report.readings) {
        const auto& [name, quantity] = reading.number;
        rows.push_back({{"name", name, "instrument", name},
                        number_fact("value", "reading", {reading.value, quantity, report.units})});
        if (has_errors)
            rows.back().push_back(
                number_fact("error", "standard error", {reading.error, quantity, report.units}));
    }
    return {table("readings", rows, has_errors ? std::vector{12, 14} : std::vector{12})};
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
std::string bars(const BinnedCounts& bins, const Quantity& quantity, UnitSystem units) {
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
    if (units == UnitSystem::real) return text + " " + number({bins.edges[end], quantity, units});
    return text + fmt::format(" {:.4g}", bins.edges[end]);
}

Json histogram(const BinnedCounts& bins, const Quantity& quantity, UnitSystem units) {
    Json edges = Json::array();
    for (const double edge : bins.edges) edges.push_back(Amount{edge, quantity, units});
    return Json{{"edges", std::move(edges)}, {"counts", bins.counts}};
}

Facts histograms(const RunReport& report) {
    const BinnedCounts &speeds = report.summary.speeds, &energies = report.summary.energies;
    return {
        {"", nullptr, "speeds", bars(speeds, quantities::speed, report.units)},
        {"", nullptr, "energies", bars(energies, quantities::energy, report.units)},
        {"histograms", Json{{"speed", histogram(speeds, quantities::speed, report.units)},
                            {"energy", histogram(energies, quantities::energy, report.units)}}}};
}

std::string heading(const Scene& scene, const RunReport& report) {
    return fmt::format("{}\n{}: {} in {}, time 0 to {}, {} samples, seed {}\n\n",
                       printable(scene.title), printable(scene.source.path),
                       counted(report.particles, "particle"),
                       words_of_dimension(scene.gas.box.dimension),
                       number_words(scene.units, quantities::time, scene.run.until),
                       grouped(report.samples), scene.seed);
}

Facts facts_of(const Scene& scene, const RunReport& report) {
    const RunSummary& summary = report.summary;
    const auto events = static_cast<double>(events_of(report.collisions));
    Facts units;
    if (scene.units == UnitSystem::real)
        units.push_back({"units", std::string(words_of(UnitSystem::si))});
    return joined<Fact>(
        {{{"carom", CAROM_VERSION, "", heading(scene, report)}, {"scene", scene.source.path}},
         units,
         {{"seed", scene.seed},
          {"dimension", scene.gas.box.dimension},
          {"particles", report.particles},
          {"time", Amount{scene.run.until, quantities::time, scene.units}},
          collisions(report),
          ties_fact(report.collisions.ties),
          energies(report),
          momentum(report),
          number_fact("temperature", "temperature",
                      {summary.temperature, quantities::temperature, report.units}),
          pressure(report, scene.gas.box.dimension),
          overlap(summary.largest_overlap),
          precision(scene, report.bits),
          {"state", report.state}},
         reversals(report),
         {species(scene, report)},
         surfaces(report, scene.gas.box.dimension),
         readings(report),
         histograms(report),
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
