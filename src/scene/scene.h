// The Scene: a plain, complete, validated value. Nothing after loading knows YAML, defaults or
// templates.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/run.h"
#include "physics/units/number_text.h"
#include "scene/figure_spec.h"
#include "scene/file_texts.h"
#include "scene/film.h"
#include "scene/keys/numbers_in_words.h"
#include "scene/looks.h"
#include "scene/panel_spec.h"
#include "scene/sweep.h"
#include "util/diagnostics.h"
#include "util/language.h"

namespace carom {

struct NamedGas;

/// The positions of all particles at a moment, kept visible until the next mark.
struct Mark {
    double at = 0.0;  ///< simulated time
    std::string words;
};

/// A text under the gas, shown until the next caption or for a limited time.
struct Caption {
    double at = 0.0;                     ///< simulated time
    std::string words;                   ///< empty: no caption from then on
    std::optional<double> seconds = {};  ///< of film, at most; none: until the next
};

/// Where a scene came from.
struct SceneSource {
    std::string path;                    ///< as the user gave it
    std::string text;                    ///< the whole file, as read
    std::string template_text;           ///< the template of its film, as read
    std::vector<std::string> overrides;  ///< values set on the command line, as KEY.PATH=VALUE
    std::string physics = {};            ///< its run_fingerprint(), including the overrides
    FileTexts files = {};                ///< texts of the other files it names: templates, scenes
    bool is_held_to_classroom = false;   ///< whether the limits of classroom.h apply
    std::string look_text = {};          ///< its style, and the set that gives it defaults, as read
};

/// Returns the bytes of a scene's file and its template, which are read again whenever the scene is
/// reloaded.
inline std::size_t read_bytes(const SceneSource& source) {
    return source.text.size() + source.template_text.size();
}

struct Scene {
    std::string title;
    std::string subtitle;
    std::string description;
    std::uint64_t seed = 1;  ///< equal to gas.seed
    /// Reduced, or real: then lengths are in nanometres, masses in atomic mass units, times in
    /// picoseconds and temperatures in units of 1 u nm2/ps2 / k, and are shown with their units.
    UnitSystem units = UnitSystem::reduced;
    Gas gas;
    std::vector<SpeciesLook> looks;  ///< one for each species
    /// One for each species, from which it has what it does not give itself; null: none.
    std::vector<const NamedGas*> named_gases = {};
    std::optional<double> asked_pressure = {};  ///< for which the box has its size
    Run run;
    std::vector<Mark> marks;        ///< in order of time; equal times in the order listed
    std::vector<Caption> captions;  ///< in order of time; equal times in the order listed
    Film film;
    std::vector<FigureSpec> figures;
    std::vector<std::string> figure_formats = {};  ///< file formats of the figures; empty: all
    std::vector<PanelSpec> measure;      ///< instruments whose last readings are numbers of the run
    std::vector<NumberInWords> numbers;  ///< for which its words ask: captions, callouts, texts of
                                         ///< panels, the end card, words of figures
    SceneSource source;
    std::vector<Diagnostic> notes;  ///< what is valid in its files but should be written in another
                                    ///< way, and what was left out
    std::vector<Diagnostic> surface_places;  ///< of each surface of the box; for sides that are not
                                             ///< in the file, the place of the box
    Diagnostic surfaces_place;   ///< of the first that does more than reflect, or of gravity
    Diagnostic precision_place;  ///< of `precision` in the file; not given: of the scene
    Diagnostic ceiling_place;    ///< of `most_collisions`; not given: of the run
    std::vector<Diagnostic> event_places;   ///< one for each of run.events
    std::vector<Diagnostic> species_spans;  ///< one for each species: its place in the file with an
                                            ///< empty message, for errors found later
};

/// How the numbers in its pictures and texts are written.
inline Wording wording_of(const Scene& scene) { return {scene.film.language, scene.units}; }

/// The scenes of the runs that the film of a scene shows, in the order of FilmRuns.
inline std::vector<const Scene*> scenes_of_film(const Scene& scene) {
    std::vector<const Scene*> all{&scene};
    for (const ComparedRun& run : scene.film.runs.others) all.push_back(run.scene.get());
    return all;
}

/// A scene as `carom check` sees it.
struct LoadedScene {
    Scene scene;
    std::vector<Diagnostic> no_film = {};  ///< why no film can be made of it; empty: one can
};

}  // namespace carom
