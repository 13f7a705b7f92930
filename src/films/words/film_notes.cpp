#include "films/words/film_notes.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "panels/chosen.h"
#include "panels/field/field_layer.h"
#include "panels/registry.h"
#include "scene/scene.h"
#include "scene/time/showing.h"
#include "util/formula/formula.h"

namespace carom {
namespace {

constexpr double never_ends = std::numeric_limits<double>::infinity();

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

// Whenever the set of active spotlights changes, one note lists everything that they light.
void add_spotlights(const Scene& scene, std::vector<FilmNote>& notes) {
    const Language language = scene.film.language;
    std::set<double> changes;
    for (const Spotlight& spotlight : scene.film.spotlights) {
        changes.insert(spotlight.time.from);
        if (spotlight.time.until) changes.insert(*spotlight.time.until);
    }
    for (auto at = changes.begin(); at != changes.end(); ++at) {
        std::vector<std::string> names;
        for (const Spotlight& spotlight : scene.film.spotlights)
            if (spotlight.time.from <= *at && *at < spotlight.time.until.value_or(never_ends))
                for (const Chosen& one : spotlight.on)
                    if (const std::string name = name_of(scene, one);
                        std::ranges::find(names, name) == names.end())
                        names.push_back(name);
        if (names.empty())
            notes.push_back(
                {*at, say(language, "All particles have their full colours again"), *at});
        else
            notes.push_back(
                {*at, say(language, "All particles are dimmed except: {}", listed(language, names)),
                 std::next(at) == changes.end() ? never_ends : *std::next(at)});
    }
}

}  // namespace

std::vector<FilmNote> film_notes(const Scene& scene, const std::vector<Tick>& ticks) {
    const Language language = scene.film.language;
    std::vector<FilmNote> notes;
    if (const FilmRuns& runs = scene.film.runs; runs.count() > 1)
        notes.push_back({0.0, say(language,
                                  "Two runs are shown side by side: “{}” and “{}”; the numbers are "
                                  "those of the first",
                                  runs.own_label, runs.others.front().label)});
    if (scene.film.field) notes.push_back({0.0, words_of_field(scene)});
    for (const PanelSpec& panel : scene.film.panels) {
        if (panel.show.from > 0.0)
            notes.push_back({panel.show.from,
                             say(language, "The panel “{}” appears", name_of_panel(scene, panel)),
                             panel.show.from});
        if (panel.show.until)
            notes.push_back(
                {*panel.show.until,
                 say(language, "The panel “{}” disappears", name_of_panel(scene, panel)),
                 *panel.show.until});
    }
    add_spotlights(scene, notes);
    for (const Callout& callout : scene.film.callouts) {
        std::string what;
        if (const auto* particle = std::get_if<std::int64_t>(&callout.on))
            what = say(language, "Particle {}", *particle);
        else
            what =
                say(language, "“{}”",
                    name_of_panel(scene, scene.film.panels[std::get<PlotPoint>(callout.on).panel]));
        const Showing shown = showing(ticks, scene.film, {.from = callout.at}, callout.seconds);
        notes.push_back(
            {callout.at,
             say(language, "{}: “{}”", what, formula::spoken_text(language, callout.words)),
             shown.until});
    }
    const std::vector<CameraMove>& moves = scene.film.camera;
    for (std::size_t k = 0; k < moves.size(); ++k) {
        notes.push_back(
            {moves[k].at, moves[k].view ? words_of(scene, *moves[k].view)
                                        : say(language, "The box is seen from another viewpoint")});
        if (k + 1 < moves.size()) notes.back().until = moves[k + 1].at;
    }
    return notes;
}

}  // namespace carom
