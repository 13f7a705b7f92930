// The scene language as data: sections of keys with their forms, ranges, defaults and meanings.
// Made from the bindings (binding.h), which define each key once. The check, the schema, the
// reference page and the starter scene see the keys only in this form.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/units/quantity.h"
#include "scene/limits.h"

namespace carom {

enum class Shape { number, integer, length, flag, text, word, color, list, mapping };

/// Units of lengths on paper, after a number or apart from it: 8 cm, 8cm.
enum class LengthUnit { cm, mm, in, pt, px };

/// Allowed numbers, both ends included.
struct Range {
    double low = -largest_quantity.value;
    Limit most = largest_quantity;
};

inline constexpr Range any_number{};
inline constexpr Range not_negative{0.0};
inline constexpr Range positive{smallest_quantity.value};

struct Section;

/// A word that a form does not take, though users are likely to try it, and a hint on what to do
/// instead.
struct Elsewhere {
    std::string word, hint;
};

/// One form that a value may take. The shape determines which of the members are used.
struct Form {
    Shape shape = Shape::text;
    Range range = {};                       ///< number, integer, length
    LengthUnit unit = LengthUnit::cm;       ///< length: of the range
    std::vector<std::string> words = {};    ///< word: those allowed; text: one as an example
    std::vector<Elsewhere> elsewhere = {};  ///< word: others that users are likely to try
    bool lines = false;                     ///< text: whether it may have line breaks
    bool formulas = false;                  ///< text: whether it may hold formulae
    std::vector<Form> items = {};           ///< list: what each item may be
    std::size_t shortest = 1;               ///< list, text: least length
    Limit most = {0};                       ///< list, text: greatest length
    std::string list_hint = {};  ///< for a list of another length or a mapping; no list: any list
    std::shared_ptr<const Section> section = {};  ///< mapping
    std::string phrase = {};                      ///< how a message calls it; empty: by the shape
    /// What a number is, which in real units has a unit; none: a plain number. Of a text: what it
    /// is if it is a number.
    std::optional<Quantity> quantity = {};
    bool takes_any_quantity = false;  ///< instead: known only when the whole mapping has been read
};

struct Key {
    std::string name;
    std::string meaning;  ///< one sentence, as in a reference
    std::vector<Form> forms;
    bool required = false;
    std::string default_value = {};       ///< as written in a scene; empty: none
    std::string default_text = {};        ///< the default in words, if it is not a fixed value
    std::vector<std::string> kinds = {};  ///< of panels that take it; empty: all
    std::string formerly = {};            ///< its name in earlier versions, still read, with a note
    std::vector<std::string> tried = {};  ///< other names that users are likely to try
};

/// Keys that cannot be combined.
struct Choice {
    std::vector<std::string> names;
    bool required = false;  ///< one of them must be there
};

/// A key that scenes from elsewhere may have and this program refuses, and the reason.
struct Refused {
    std::string name, reason, hint;
};

/// The keys of one mapping.
struct Section {
    std::string name;  ///< as in "an item of `gas`"
    std::vector<Key> keys;
    std::vector<Choice> choices = {};
    std::vector<Refused> refused = {};

    /// Returns the index of a key; the number of keys if none has that name.
    std::size_t index(std::string_view name) const;
};

/// Returns the section of the mapping that is the value of `key`: section_of(scene, "film").
const Section& section_of(const Section& parent, std::string_view key);

/// Returns the section of the mapping among these forms, or among the items of their lists; null if
/// there is none.
const Section* section_in(const std::vector<Form>& forms);

/// Returns all sections of mappings among these forms, in order.
std::vector<const Section*> sections_in(const std::vector<Form>& forms);

/// Returns the length that a text with a number and a unit gives, in `unit`; nothing for another
/// text. A pixel is 1/96 inch.
std::optional<double> parse_length(std::string_view text, LengthUnit unit);

/// Returns a length as a scene might write it.
std::string length_example(const Form& form);

/// Returns the names of the units.
std::vector<std::string> length_units();

/// Returns the name of a form in messages: "a positive number", "`light`, `dark` or `print`".
std::string phrase(const Form& form);

/// Returns the colour names of CSS that color_hex() knows.
std::vector<std::string> color_names();

/// Returns the colour of a name as #rrggbb; `name` itself if it has the form #rrggbb; empty
/// otherwise.
std::string color_hex(std::string_view name);

}  // namespace carom
