// How an HTML page follows the style of its pictures.
#pragma once

#include <string>

namespace carom {

struct Film;

/// Properties of CSS for the root element of a page of the film or of the figures of a scene: the
/// colours and the font of its style; empty without one. The templates of pages use them.
std::string style_properties_of(const Film& film);

}  // namespace carom
