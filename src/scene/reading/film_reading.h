// The keys of `film` and of its templates, and what they mean together: frames, panels for the
// slots there are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/keys/made_once.h"
#include "scene/panel_kind.h"
#include "scene/reading/overlay_reading.h"
#include "scene/scene.h"

namespace carom {

/// A film as it is written. Refers to its nodes.
struct FilmDraft : Film {
    std::optional<double> given_seconds;
    double pace = 1.0;
    std::vector<Placed<SlowSpan>> spans;
    std::vector<CalloutDraft> written_callouts;
    const Node* layout_node = nullptr;         ///< of a template
    std::optional<std::int64_t> usual_panels;  ///< of a template
};

/// The keys of `film`. `kinds` as MadeOnce takes them, here and below.
const FixedTable<FilmDraft>& film_table(PanelKinds kinds);

/// The keys of `film` but `template`, and `layout`.
const FixedTable<FilmDraft>& template_table(PanelKinds kinds);

/// What a film is read from: mappings, checked for form.
struct FilmNodes {
    const Node& film;  ///< the scene's, laid over the template's
    const Node& template_file;
    const Node& root;  ///< the scene
};

/// What makes a film longer, for messages: `seconds`, or where `film` has a `pace` a smaller one.
std::string key_of_length(const Node& film);

/// The film of a scene, of which the gas and the run are known, with the pauses that the run asks
/// for. Its run gives the length where the film does not. A scene's panels may be more than the
/// places of a template that the command line asks for: the first are shown. Where they are too
/// many, the message names those of `templates` that have places for them.
Film read_film(const FilmNodes& nodes, const std::string& template_name, PanelKinds kinds,
               const std::filesystem::path& templates, const std::vector<Placed<Pause>>& pauses,
               Reading& reading);

}  // namespace carom
