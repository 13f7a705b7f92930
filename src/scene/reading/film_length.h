// How long a film is: its slow motion, pauses and length, and whether they fit one another.
#pragma once

#include <string>
#include <vector>

#include "scene/reading/film_reading.h"

namespace carom {

/// Returns what the user changes to make a film longer, for messages: `film.seconds`, or, if `film`
/// gives a `pace`, a smaller one.
std::string key_of_length(const Node& film);

/// Gives a film whose keys have been read its slow motion, pauses and length, and reports what does
/// not fit into that length. `node`: its mapping, completed by its template.
void complete_length(FilmDraft& film, const std::vector<Placed<Pause>>& pauses,
                     const FilmNodes& nodes, const Node& node, Reading& reading);

}  // namespace carom
