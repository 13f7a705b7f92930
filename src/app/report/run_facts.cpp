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
Facts account_terms(const EnergyAccount& account) {
    Facts terms{number_fact("kinetic", "kinetic", energy(account.kinetic))};
    const auto add = [&](const char* name, double value) {
        terms.push_back(number_fact(name, value == 0.0 ? "" : name, energy(value)));
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
        const Facts terms = account_terms(*report.account);
        fact.value["account"] = json_of(terms);
        fact.words = account_words(terms, report.account->relative_error);
    } else {
        fact.words = energy_words(summary);
    }
    return fact;
}

std::vector<std::optional<double>> impulse_of(const SurfaceTotals& its, int dimension) {
    std::vector<std::optional<double>> components;
    for (int axis = 0; axis < dimension; ++axis) components.emplace_back(its.impulse[axis]);
    return components;
}

Fact position_fact(const std::optional<SurfaceReport::Position>& position) {
    if (!position) return {"position", nullptr, "position", "—"};
    const auto value_of = [](double value) { return Amount{value, quantities::position}; };
    return {"position",
            Json{{"mean", value_of(position->mean)},
                 {"deviation", value_of(position->deviation)},
                 {"last", value_of(position->last)}},
            "position",
            fmt::format("{} ± {}, {} at the end", number(position->mean),
                        number(position->deviation), number(position->last))};
}

// In a box with surfaces that act, obstacles or gravity.
Facts surfaces(const RunReport& report, int dimension) {
    if (report.surfaces.empty()) return {};
    std::vector<Facts> rows;
    for (const SurfaceReport& surface : report.surfaces) {
        const SurfaceTotals& its = surface.totals;
        const std::vector<std::optional<double>> impulse = impulse_of(its, dimension);
        rows.push_back(
            {{"name", surface.name, "surface", surface.name},
             {"hits", its.hits, "hits", fmt::format("{}", its.hits)},
             {"impulse", vector_value(impulse, quantities::momentum), "impulse", vector(impulse)},
             number_fact("work", "work", energy(its.work)),
             number_fact("heat", "heat", energy(its.heat)),
             position_fact(surface.position)});
    }
    return {table("surfaces", rows, {9, 23, 10, 10, 0})};
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

Fact species(const Scene& scene, const RunSummary& summary) {
    std::vector<Facts> rows;
    for (std::size_t s = 0; s < summary.species.size(); ++s) {
        const std::string& name = scene.gas.species[s].name;
        const SpeciesMeans& means = summary.species[s];
        rows.push_back({{"name", name, "species", name},
                        {"count", means.count, "particles", fmt::format("{}", means.count)},
                        number_fact("mean_energy", "mean energy", energy(means.energy)),
                        number_fact("mean_speed", "mean speed", {means.speed, quantities::speed})});
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
                        number_fact("value", "reading", {reading.value, quantity})});
        if (has_errors)
            rows.back().push_back(
                number_fact("error", "standard error", {reading.error, quantity}));
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
                       words_of_dimension(scene.gas.box.dimension), scene.run.until,
                       grouped(report.samples), scene.seed);
}

Facts facts_of(const Scene& scene, const RunReport& report) {
    const RunSummary& summary = report.summary;
    const auto events = static_cast<double>(events_of(report.collisions));
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
          number_fact("temperature", "temperature", {summary.temperature, quantities::temperature}),
          pressure(report, scene.gas.box.dimension),
          overlap(summary.largest_overlap),
          precision(scene, report.bits),
          {"state", report.state}},
         reversals(report),
         {species(scene, summary)},
         surfaces(report, scene.gas.box.dimension),
         readings(report),
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
