// Pages that show figures: fills a template with placeholders. Does no file access.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/escaping.h"
#include "scene/yaml/node.h"
#include "util/language.h"

namespace carom {

/// The names of placeholders: under the key "" those of the page itself, under the name of a list
/// those inside that list.
using Placeholders = std::map<std::string, std::vector<std::string>>;

/// The values of the placeholders at one level of the page: words, names of files (in LaTeX as they
/// are, elsewhere as parts of a URL), files embedded in the page, and lists, whose items have
/// values of their own.
struct PageFields {
    std::map<std::string, std::string> words = {};
    std::map<std::string, std::string> formulated = {};  ///< words with formulae
    std::map<std::string, std::string> files = {};
    std::map<std::string, std::string> inlined = {};  ///< addresses, as data_address() makes them
    std::map<std::string, std::vector<PageFields>> lists = {};
    /// Of the program's own words; none: as around it, or English for the page itself.
    std::optional<Language> language = {};
};

/// The placeholders of pages of figures.
const Placeholders& placeholders();

/// Fills a template. `{{name}}` is replaced by a text. `{{#name}}…{{/name}}` is repeated for each
/// item of a list, or kept if the text is not empty; `{{^name}}…{{/name}}` is kept if there is no
/// such item or text; `{{! words}}` is a comment and is left out. A line that contains only a tag
/// beginning with `#`, `^`, `/` or `!` is removed. `{{_Figure}}` is a word of the program in the
/// language of the page. Throws SceneError with the places of names that are not among `names`, and
/// of tags that are not closed.
std::string filled_page(const Source& page, PageKind kind, const PageFields& fields,
                        const Placeholders& names = placeholders());

}  // namespace carom
