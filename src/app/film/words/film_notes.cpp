#include "app/film/words/film_notes.h"

#include "panels/chosen.h"
#include "panels/field/field_layer.h"
#include "panels/registry.h"
#include "util/formula/formula.h"

namespace carom {
namespace {

std::string words_of(const Scene& scene, const View& view) {
    const Language language = scene.film.language;
    if (const auto* followed = std::get_if<Followed>(&view))
        return say(language, "The camera follows: {}", name_of(scene, followed->what));
    const auto* part = std::get_if<Region>(&view);
    if (part == nullptr) return say(language, "The camera shows the whole box");
    if (scene.gas.box.dimension == 1)
        return say(language, "The camera shows a part of the wire, x = {} to {}", part->low[0],
                   part->high[0]);
    return say(language, "The camera shows a part of the box, x = {} to {} and y = {} to {}",
               part->low[0], part->high[0], part->low[1], part->high[1]);
}

}  // namespace

std::vector<FilmNote> film_notes(const Scene& scene) {
    const Language language = scene.film.language;
    std::vector<FilmNote> notes;
    if (const auto& beside = scene.film.beside)
        notes.push_back(
            {0.0,
             say(language,
                 "Two runs are seen side by side: “{}” and “{}”; numbers are told of the first",
                 beside->own_label, beside->label)});
    if (scene.film.field) notes.push_back({0.0, words_of_field(scene)});
    for (const PanelSpec& panel : scene.film.panels) {
        if (panel.show.from > 0.0)
            notes.push_back({panel.show.from, say(language, "The panel “{}” appears",
                                                  name_of_panel(language, panel))});
        if (panel.show.until)
            notes.push_back({*panel.show.until, say(language, "The panel “{}” disappears",
                                                    name_of_panel(language, panel))});
    }
    for (const Spotlight& spotlight : scene.film.spotlights) {
        std::vector<std::string> names;
        for (const Chosen& one : spotlight.on) names.push_back(name_of(scene, one));
        notes.push_back({spotlight.time.from,
                         say(language, "All are dimmed but: {}", listed(language, names))});
        if (spotlight.time.until)
            notes.push_back({*spotlight.time.until,
                             say(language, "All particles have their full colours again")});
    }
    for (const Callout& callout : scene.film.callouts) {
        std::string what;
        if (const auto* particle = std::get_if<std::int64_t>(&callout.on))
            what = say(language, "Particle {}", *particle);
        else
            what = say(
                language, "“{}”",
                name_of_panel(language, scene.film.panels[std::get<PlotPoint>(callout.on).panel]));
        notes.push_back({callout.at, say(language, "{}: “{}”", what,
                                         formula::spoken_text(language, callout.words))});
    }
    for (const CameraMove& move : scene.film.camera)
        notes.push_back({move.at, words_of(scene, move.view)});
    return notes;
}

}  // namespace carom
