#include "app/film/film_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "panels/chosen.h"
#include "util/formula/formula.h"
#include "util/text.h"

namespace carom {
namespace {

std::string words_of(const Scene& scene, const View& view) {
    if (const auto* followed = std::get_if<Followed>(&view))
        return fmt::format("The camera follows {}", name_of(scene, followed->what));
    const auto* part = std::get_if<Region>(&view);
    if (part == nullptr) return "The camera shows the whole box";
    if (scene.gas.box.dimension == 1)
        return fmt::format("The camera shows a part of the line, from {} to {}", part->low[0],
                           part->high[0]);
    return fmt::format("The camera shows a part of the box, from ({}, {}) to ({}, {})",
                       part->low[0], part->low[1], part->high[0], part->high[1]);
}

}  // namespace

std::string name_of(const PanelSpec& panel) {
    std::string name = panel.title.value_or(panel.kind);
    if (!panel.title) std::ranges::replace(name, '-', ' ');
    return name;
}

std::vector<FilmNote> film_notes(const Scene& scene) {
    std::vector<FilmNote> notes;
    for (const PanelSpec& panel : scene.film.panels) {
        if (panel.show.from > 0.0)
            notes.push_back(
                {panel.show.from, fmt::format("The panel “{}” appears", name_of(panel))});
        if (panel.show.until)
            notes.push_back(
                {*panel.show.until, fmt::format("The panel “{}” goes", name_of(panel))});
    }
    for (const Spotlight& spotlight : scene.film.spotlights) {
        std::vector<std::string> names;
        for (const Chosen& one : spotlight.on) names.push_back(name_of(scene, one));
        notes.push_back(
            {spotlight.time.from, fmt::format("All are dimmed but {}", listed(names, "and"))});
        if (spotlight.time.until)
            notes.push_back({*spotlight.time.until, "All particles have their full colours again"});
    }
    for (const Callout& callout : scene.film.callouts) {
        std::string what;
        if (const auto* particle = std::get_if<std::int64_t>(&callout.on))
            what = fmt::format("Particle {}", *particle);
        else
            what = fmt::format("“{}”",
                               name_of(scene.film.panels[std::get<PlotPoint>(callout.on).panel]));
        notes.push_back({callout.at, fmt::format("{} is pointed out: “{}”", what,
                                                 formula::spoken_text(callout.words))});
    }
    for (const CameraMove& move : scene.film.camera)
        notes.push_back({move.at, words_of(scene, move.view)});
    return notes;
}

}  // namespace carom
