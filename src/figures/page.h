// Pages that show figures: a template with placeholders, and what stands in for them. Knows no
// files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "figures/escaping.h"
#include "scene/yaml/node.h"
#include "util/language.h"

namespace carom {

/// The names of placeholders: under "" those of the page itself, under the name of a list those
/// inside it.
using Placeholders = std::map<std::string, std::vector<std::string>>;

/// What stands in for the placeholders of a place: words, names of files (in LaTeX as they are,
/// elsewhere as parts of an address), files inside of the page, and lists of places.
struct PageFields {
    std::map<std::string, std::string> words = {};
    std::map<std::string, std::string> formulated = {};  ///< words with formulae
    std::map<std::string, std::string> files = {};
    std::map<std::string, std::string> inlined = {};  ///< addresses, as data_address() makes them
    std::map<std::string, std::vector<PageFields>> lists = {};
    Language language = Language::english;  ///< of the page itself, for words of the program
};

/// The placeholders of pages of figures.
const Placeholders& placeholders();

/// Fills a template. `{{name}}` is a text; `{{#name}}…{{/name}}` stays for each item of a list, or
/// if there is such a text; `{{^name}}…{{/name}}` if there is none; `{{! words}}` is left out. A
/// line that holds nothing but one of the last four leaves none. `{{_Figure}}` is a word of the
/// program in the language of the page. Throws SceneError with the places
/// of names that are not among `names` and of what is not closed.
std::string filled_page(const Source& page, PageKind kind, const PageFields& fields,
                        const Placeholders& names = placeholders());

}  // namespace carom
