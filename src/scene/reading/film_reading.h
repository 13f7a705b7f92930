// The keys of `film` and of its templates, and the rules between them: the number of frames, and
// enough places in the layout for the panels.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/film.h"
#include "scene/keys/made_once.h"
#include "scene/panel_kind.h"
#include "scene/reading/overlay_reading.h"

namespace carom {

/// A film as read from the file. Holds pointers to its nodes, which must outlive it.
struct FilmDraft : Film {
    std::optional<double> given_seconds;
    double pace = 1.0;
    std::vector<Placed<SlowSpan>> spans;
    std::vector<CalloutDraft> written_callouts;
    const Node* layout_node = nullptr;         ///< in a template only
    std::optional<std::int64_t> usual_panels;  ///< in a template only
};

/// The table of keys of `film`. For `kinds`, here and below, see MadeOnce.
const FixedTable<FilmDraft>& film_table(PanelKinds kinds);

/// The table of keys of a template: those of `film` except `template`, and in addition `layout` and
/// `usual_panels`.
const FixedTable<FilmDraft>& template_table(PanelKinds kinds);

/// The mappings that a film is read from. Their form has been checked.
struct FilmNodes {
    const Node& film;  ///< the scene's `film`, completed by its template
    const Node& template_file;
    const Node& root;        ///< the scene
    bool has_length = true;  ///< false: a length that is not given is not checked (Wanted::figures)
};

/// Reads the film of a scene whose gas and run are known. `pauses` come from the run's events. If
/// the film does not give its length, it follows from the run's. A film may list more panels than
/// the template has places: if the command line chose the template, the surplus panels are left
/// out; otherwise they are an error, whose message names the templates in the folder `templates`
/// that have enough places.
Film read_film(const FilmNodes& nodes, const std::string& template_name, PanelKinds kinds,
               const std::filesystem::path& templates, const std::vector<Placed<Pause>>& pauses,
               Reading& reading);

}  // namespace carom
