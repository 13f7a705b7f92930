#include "app/check/theory_facts.h"

#include <fmt/format.h>

#include <algorithm>

#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {
namespace {

void add(const std::string& name, const PanelSpec& panel, const Scene& scene, const BoxedGas& gas,
         std::vector<std::string>& lines) {
    const PanelKind& kind = kind_of(panel);
    if (!panel.theory || !kind.laws) return;
    const SurfaceNumbers surfaces = places_of(panel).surfaces;
    const std::int32_t surface = surfaces.empty() ? 0 : surfaces.front();
    for (const LawOf quantity : kind.laws(panel, scene.gas)) {
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
