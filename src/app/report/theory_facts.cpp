#include "app/report/theory_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace carom {
namespace {

// The quantity whose law a panel shows, if it depends on the kind only.
std::optional<LawOf> law_of_kind(const std::string& kind) {
    static const std::map<std::string, LawOf> known{
        {"speed-histogram", LawOf::distribution},
        {"energy-histogram", LawOf::distribution},
        {"velocity-histogram", LawOf::distribution},
        {"energy-by-species", LawOf::mean_energy},
        {"pressure-volume", LawOf::isotherm},
        {"piston", LawOf::piston},
        {"piston-histogram", LawOf::piston},
        {"mean-squared-displacement", LawOf::displacement},
        {"velocity-autocorrelation", LawOf::autocorrelation},
        {"pair-correlation", LawOf::contact},
        {"free-path", LawOf::memoryless},
        {"free-time", LawOf::memoryless},
        {"return-distance", LawOf::error_growth}};
    const auto found = known.find(kind);
    return found == known.end() ? std::nullopt : std::optional(found->second);
}

std::vector<LawOf> laws_of(const PanelSpec& panel) {
    if (const auto one = law_of_kind(panel.kind)) return {*one};
    if (panel.kind == "entropy" && panel.entropy_of == EntropyOf::velocities)
        return {LawOf::velocity_entropy};
    if (panel.kind == "entropy" && panel.entropy_of == EntropyOf::positions)
        return {LawOf::position_entropy};
    if (panel.kind == "entropy") return {LawOf::velocity_entropy, LawOf::position_entropy};
    if (panel.kind == "pressure" && panel.surfaces.empty()) return {LawOf::pressure};
    if (panel.kind == "sides" && panel.regions.empty()) {
        if (panel.measure == PartMeasure::count) return {LawOf::side_count};
        if (panel.measure == PartMeasure::mean_energy) return {LawOf::side_energy};
        if (panel.measure == PartMeasure::temperature) return {LawOf::side_temperature};
    }
    return {};
}

void add(const std::string& name, const PanelSpec& panel, const Scene& scene, const BoxedGas& gas,
         std::vector<std::string>& lines) {
    if (!panel.theory || (panel.kind == "energy-by-species" && scene.gas.species.size() < 2))
        return;
    const std::int32_t surface = panel.surfaces.empty() ? 0 : panel.surfaces.front();
    for (const LawOf quantity : laws_of(panel)) {
        const Law found = law(gas, quantity, {.cells = 1, .surface = surface});
        if (!found.none) continue;
        std::string line =
            fmt::format("{}: {}", name, to_text(Language::english, *found.none, scene.gas.species));
        if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
    }
}

}  // namespace

std::vector<std::string> missing_theory(const Scene& scene, const BoxedGas& gas) {
    std::vector<std::string> lines;
    for (const PanelSpec& panel : scene.film.panels) add(panel.kind, panel, scene, gas, lines);
    for (const FigureSpec& figure : scene.figures)
        add(figure.name, figure.panel, scene, gas, lines);
    return lines;
}

}  // namespace carom
