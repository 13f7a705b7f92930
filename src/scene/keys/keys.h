// The scene language as data: sections of keys with their forms, ranges, defaults and meanings.
// Made from the bindings (binding.h), which say each key once; the check, the schema, the reference
// page and the scene to start from know keys only like this.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/limits.h"

namespace carom {

enum class Shape { number, integer, flag, text, word, color, list, mapping };

/// Allowed numbers, both ends included.
struct Range {
    double low = -largest_quantity.value;
    Limit most = largest_quantity;
};

inline constexpr Range any_number{};
inline constexpr Range not_negative{0.0};
inline constexpr Range positive{smallest_quantity.value};

struct Section;

/// A word that is not among those of a form, and what to do instead.
struct Elsewhere {
    std::string word, hint;
};

/// One form that a value may take. Which members count depends on the shape.
struct Form {
    Shape shape = Shape::text;
    Range range = {};                             ///< number, integer
    std::vector<std::string> words = {};          ///< word; text: one for an example
    std::vector<Elsewhere> elsewhere = {};        ///< word: others that are likely to be tried
    bool lines = false;                           ///< text: may it have line breaks
    std::vector<Form> items = {};                 ///< list: what each item may be
    std::size_t shortest = 1;                     ///< list, text: least length
    Limit most = {0};                             ///< list, text: greatest length
    std::string instead_of_list = {};             ///< no list: what to do where one is given
    std::shared_ptr<const Section> section = {};  ///< mapping
    std::string phrase = {};                      ///< how a message calls it; empty: by the shape
};

struct Key {
    std::string name;
    std::string meaning;  ///< one sentence, as in a reference
    std::vector<Form> forms;
    bool required = false;
    std::string default_value = {};       ///< as it would be written; empty: none
    std::string default_text = {};        ///< the default in words, where it is no fixed value
    std::vector<std::string> kinds = {};  ///< of panels that take it; empty: all
};

/// Keys that cannot be combined.
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

    /// The index of a key; the number of keys if there is none of that name.
    std::size_t index(std::string_view name) const;
};

/// The sections inside one another by the name of their key: section_of(scene, "film").
const Section& section_of(const Section& parent, std::string_view key);

/// The section of a mapping among these forms, or of one in their lists; null if there is none.
const Section* section_in(const std::vector<Form>& forms);

/// All of these sections, each as it comes.
std::vector<const Section*> sections_in(const std::vector<Form>& forms);

/// How a message calls a form: "a positive number", "`light`, `dark` or `print`".
std::string phrase(const Form& form);

/// The colour names of CSS that color_hex() knows.
std::vector<std::string> color_names();

/// The colour of a name as #rrggbb; `name` itself if it is #rrggbb; empty otherwise.
std::string color_hex(std::string_view name);

}  // namespace carom
