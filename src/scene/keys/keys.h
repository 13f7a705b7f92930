// The key table: every key of the scene language with its forms, ranges, default, ceiling and
// meaning. The only place where these are written down: the loader checks and reads by it, and
// what else describes the language is made from it.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/limits.h"
#include "scene/yaml/node.h"

namespace carom {

enum class Shape { number, integer, flag, text, word, color, list, mapping };

/// Allowed numbers, both ends included; the ends that are ceilings say so.
struct Range {
    double low = -largest_quantity.value;
    double high = largest_quantity.value;
    std::string_view ceiling = largest_quantity.meaning;  ///< what `high` counts; may be empty
};

struct Section;

/// A word that is not among those of a form, and what to do instead.
struct Elsewhere {
    std::string word, hint;
};

/// One form that a value may take. Which members count depends on the shape.
struct Form {
    Shape shape = Shape::text;
    Range range = {};                             ///< number, integer
    std::vector<std::string> words = {};          ///< word
    std::vector<Elsewhere> elsewhere = {};        ///< word: others that are likely to be tried
    bool lines = false;                           ///< text: may it have line breaks
    std::vector<Form> items = {};                 ///< list: what each item may be
    std::size_t shortest = 1;                     ///< list, text: least length
    std::size_t longest = 0;                      ///< list, text: greatest length
    std::string_view ceiling = {};                ///< list: what `longest` counts
    std::string instead_of_list = {};             ///< no list: what to do where one is given
    std::shared_ptr<const Section> section = {};  ///< mapping
    std::string phrase = {};                      ///< how a message calls it; empty: by the shape
};

struct Key {
    std::string name;
    std::string meaning;  ///< one sentence, as in a reference
    std::vector<Form> forms;
    bool required = false;
    std::string preset = {};             ///< the default as it would be written; empty: none
    std::string preset_note = {};        ///< where the default comes from when it is no fixed value
    std::vector<std::string> with = {};  ///< only beside these words of `kind`; empty: always
};

/// Keys that exclude one another.
struct Choice {
    std::vector<std::string> names;
    bool required = false;  ///< one of them must be there
};

/// A key that other scenes may have and this program refuses, and why.
struct Refused {
    std::string name, reason, hint;
};

/// The keys of one mapping.
struct Section {
    std::string name;  ///< as in "an item of `gas`"
    std::vector<Key> keys;
    std::vector<Choice> choices = {};
    std::vector<Refused> refused = {};
    std::vector<Node> presets = {};  ///< one for each key: its default as a value, or null

    /// The index of a key; the number of keys if there is none of that name.
    std::size_t index(std::string_view name) const;
};

/// A whole scene with a box of one dimension or of two.
const Section& scene_section(int dimension = 2);

/// A template: the keys of `film` but `template`, and `layout`.
const Section& template_section();

/// A figure set: a file that lists scenes.
const Section& set_section();

/// The sections inside one another by the name of their key: section_of(scene_section(), "film").
const Section& section_of(const Section& parent, std::string_view key);

/// The section of a mapping among these forms, or of one in their lists; null if there is none.
const Section* section_in(const std::vector<Form>& forms);

/// All of these sections, each as it comes.
std::vector<const Section*> sections_in(const std::vector<Form>& forms);

/// The kinds of panel that a film's `panels` may name.
std::span<const std::string> panel_kinds();

/// The version of the scene format that this program reads.
inline constexpr int scene_format = 1;

/// How a message calls a form: "a positive number", "`light`, `dark` or `print`".
std::string phrase(const Form& form);

/// A bound as a message writes it: 2000000, 1e12.
std::string number_text(double value);

/// The colour names of CSS 2.1 as #rrggbb; `name` itself if it is #rrggbb; empty otherwise.
std::string color_hex(std::string_view name);

}  // namespace carom
