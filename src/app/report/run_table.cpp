#include "app/report/run_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "util/text.h"

namespace carom {
namespace {

std::string row(const char* name, const std::string& words) {
    return fmt::format("  {:<15} {}\n", name, words);
}

std::string number(std::optional<double> value) {
    return value && std::isfinite(*value) ? fmt::format("{:.5g}", *value) : "—";
}

std::string counted(std::int64_t count, const char* one, const char* several) {
    return fmt::format("{} {}", grouped(count), count == 1 ? one : several);
}

std::string vector(const std::vector<std::optional<double>>& components) {
    if (components.size() == 1) return number(components[0]);
    std::vector<std::string> words;
    for (const auto& component : components) words.push_back(number(component));
    return fmt::format("({})", fmt::join(words, ", "));
}

std::string collisions(const RunReport& report) {
    const CollisionCounts& counts = report.collisions;
    const double of_each =
        2.0 * static_cast<double>(counts.particle) / static_cast<double>(report.particles);
    return fmt::format("{} between particles ({:.3g} for each), {} with walls",
                       grouped(counts.particle), of_each, grouped(counts.wall));
}

std::string energy(const RunSummary& summary) {
    if (!summary.largest_energy_error) return "not conserved: an infinite mass moves";
    if (*summary.largest_energy_error == 0.0)
        return number(summary.energy_initial) + ", kept exactly";
    return fmt::format("{}, kept to {:.1e} of it", number(summary.energy_initial),
                       *summary.largest_energy_error);
}

std::string pressure(const RunSummary& summary) {
    const std::string wall = summary.wall_pressure ? number(summary.wall_pressure) + " on the walls"
                                                   : "no solid walls to press on";
    if (!summary.virial_pressure) return wall;
    return fmt::format("{}, {} by the virial", wall, number(summary.virial_pressure));
}

// Below round-off of the coordinates nothing can be told from touching.
std::string overlap(double largest) {
    if (largest == 0.0) return "none";
    return fmt::format("at most {:.1e} of a contact distance", largest);
}

// Also of one for which there is no double.
std::string length(double value, double log10) {
    if (value > 1e-300 || std::isinf(log10)) return fmt::format("{:.2g}", value);
    return fmt::format("{:.1f}e{:.0f}", std::pow(10.0, log10 - std::floor(log10)),
                       std::floor(log10));
}

std::string way_back(const ReversalReport& report) {
    if (!report.events_back) return "the run ends before the gas could be home";
    const std::string events =
        fmt::format("{} out, {} back", counted(report.events_out, "event", "events"),
                    grouped(*report.events_back));
    if (!report.distance) return "another reversal comes between; " + events;
    const ReturnDistance& d = *report.distance;
    return fmt::format("home to within {} (r.m.s. {}); {}", length(d.largest, d.log10_largest),
                       length(d.root_mean_square, d.log10_root_mean_square), events);
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

// The bins that hold all but a two-hundredth of the counts.
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

std::string heading(const Scene& scene, const RunReport& report) {
    return fmt::format("{}\n{}: {} in {}, time 0 to {}, {} samples, seed {}\n\n", scene.title,
                       scene.source.path, counted(report.particles, "particle", "particles"),
                       scene.gas.box.dimension == 1 ? "one dimension" : "two dimensions",
                       scene.run.until, grouped(report.samples), scene.seed);
}

}  // namespace

std::string run_table(const Scene& scene, const RunReport& report) {
    const RunSummary& summary = report.summary;
    std::string text = heading(scene, report);
    text += row("collisions", collisions(report));
    text += row("energy", energy(summary));
    text += row("momentum",
                fmt::format("{} at the start, {} at the end", vector(summary.momentum_initial),
                            vector(summary.momentum_final)));
    text += row("temperature", number(summary.temperature));
    text += row(scene.gas.box.dimension == 1 ? "force" : "pressure", pressure(summary));
    text += row("overlap", overlap(summary.largest_overlap));
    if (report.bits > bits_of_double)
        text += row("numbers", fmt::format("of {} bits{}", report.bits,
                                           scene.run.bits ? "" : ", found by trying"));
    for (const ReversalReport& reversal : report.reversals)
        text += row(fmt::format("reversed at {}", reversal.at).c_str(), way_back(reversal));
    text += "\n" + species_rows(scene, summary) + "\n";
    text += row("speeds", bars(summary.speeds));
    return text + row("energies", bars(summary.energies));
}

std::string run_timings(const RunReport& report) {
    const RunSeconds& seconds = report.seconds;
    const auto events = static_cast<double>(report.collisions.particle + report.collisions.wall);
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
