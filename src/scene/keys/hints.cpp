#include "scene/keys/hints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/keys/colors.h"
#include "scene/keys/key_text.h"
#include "scene/keys/rewriting.h"
#include "scene/keys/unit_conversion.h"
#include "scene/yaml/scalar.h"
#include "scene/yaml/yaml_text.h"
#include "util/text.h"

namespace carom {
namespace {

bool has_word(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

// Returns whether a comment follows where a key's value is expected.
bool is_comment_behind(const Node& nothing) {
    constexpr std::size_t far_enough = 200;
    std::string_view line =
        std::string_view{nothing.source->text}.substr(nothing.offset, far_enough);
    line = line.substr(0, line.find('\n'));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return false;
    const std::size_t next = line.find_first_not_of(' ', colon + 1);
    return next != std::string_view::npos && line[next] == '#';
}

char first_byte(const Node& node) {
    const std::string& text = node.source->text;
    return node.offset < text.size() ? text[node.offset] : ' ';
}

std::string keys_hint(const Section& section, const std::string& of = "") {
    const std::vector<std::string> names = key_names(section);
    const std::string subject = names.size() == 1 ? "key" : "keys",
                      verb = names.size() == 1 ? "is" : "are";
    return (of.empty() ? "its " + subject : fmt::format("the {} of {}", subject, of)) + " " + verb +
           " " + listed(names, "and");
}

// Returns a word without capitals, spaces, hyphens and underscores.
std::string letters_of(std::string_view word) {
    std::string letters = lower(std::string(word));
    std::erase_if(letters, [](char c) { return c == ' ' || c == '-' || c == '_'; });
    return letters;
}

// Returns the words of a name, between hyphens, spaces or underscores.
std::vector<std::string> name_parts(std::string_view name) {
    constexpr std::size_t shortest = 4;
    std::vector<std::string> words;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t end = std::min(name.find_first_of("- _", at), name.size());
        if (end - at >= shortest) words.push_back(letters_of(name.substr(at, end - at)));
        at = end + 1;
    }
    return words;
}

// Returns whether a name contains a word of `text`, or one of similar spelling.
bool has_word_of(std::string_view text, std::string_view name) {
    const std::vector<std::string> own = name_parts(name);
    return std::ranges::any_of(name_parts(text), [&](const std::string& word) {
        return name.find(word) != name.npos || nearest_spelling(word, own).has_value();
    });
}

std::string word_hint(const Node& node, const std::vector<Form>& forms) {
    for (const Form& form : forms)
        for (const Elsewhere& other : form.elsewhere)
            if (letters_of(other.word) == letters_of(node.text)) return other.hint;
    std::vector<std::string> words;
    for (const Form& form : forms) words.insert(words.end(), form.words.begin(), form.words.end());
    const auto near = nearest_spelling(node.text, words);
    if (near) return fmt::format("did you mean `{}`?", *near);
    constexpr std::size_t few = 12;  // all stand in the message
    if (words.size() <= few) return "";
    std::vector<std::string> alike;
    for (const std::string& word : words)
        if (has_word_of(node.text, word)) alike.push_back(word);
    return "there are " + fmt::format("`{}`", fmt::join(alike.empty() ? words : alike, "`, `"));
}

bool is_in(double value, const Range& range) {
    return value >= range.low && value <= range.most.value;
}

// Returns a hint for a number outside of the range of a form, or with decimals where it is whole.
std::string range_hint(const Node& node, double value, const Form& form) {
    const Range& range = form.range;
    if (!node.written.empty()) {  // the range is that of the converted number
        const bool is_low = value < range.low;
        if (is_low && value != 0.0 && is_in(-value, range))
            return fmt::format("write `{}`, without the minus sign", node.written.substr(1));
        if (is_low || value > range.most.value)
            return fmt::format("the {} is {}", is_low ? "smallest" : "largest",
                               in_unit_of(node, is_low ? range.low : range.most.value));
    }
    if (value > range.most.value && !range.most.meaning.empty()) return to_text(range.most);
    if (value > range.most.value)
        return fmt::format("the largest is {}", number_text(range.most.value));
    if (value > 0.0 && value < range.low && range.low == smallest_quantity.value)
        return fmt::format("the smallest is {}", smallest_quantity.value);
    if (value < range.low && value != 0.0 && is_in(-value, range))
        return fmt::format("write `{}`, without the minus sign", number_text(-value));
    if (value < range.low && range.low != smallest_quantity.value)
        return fmt::format("the smallest is {}", number_text(range.low));
    if (value < range.low) return "for instance `1`, or any other number above 0";
    if (form.shape != Shape::integer || value == std::floor(value)) return "";
    std::vector<std::string> whole;
    for (const double near : {std::floor(value), std::ceil(value)})
        if (is_in(near, range)) whole.push_back(number_text(near));
    return "write " + listed(whole, "or", "`");
}

// Returns the length of the lists of a form if it is a fixed number of numbers; otherwise 0.
std::size_t numbers_in(const Form& list) {
    const bool is_fixed = list.most.value == static_cast<double>(list.shortest);
    return is_fixed && form_of(list.items, Shape::number) != nullptr ? list.shortest : 0;
}

// Returns the name of the last number of a list: "z" of "[x, y, z]".
std::string last_name(const Form& list) {
    const std::string names = phrase(list);
    const std::size_t begin = names.rfind(' ') + 1;
    return names.substr(begin, names.rfind(']') - begin);
}

// Returns a vector or the corners of a plane with letters for what is missing in space:
// "[20, 22, z]", "[1, 2, z0, 9, 8, z1]"; empty for other lists, and where none is missing.
std::string with_depth(const Node& node, const Form& list) {
    const std::size_t length = numbers_in(list);
    if (!node.is_list() || (length != 3 && length != 6) || 3 * node.items.size() != 2 * length ||
        !std::ranges::all_of(node.items,
                             [](const Node& item) { return number_in(item).has_value(); }))
        return "";
    std::vector<std::string> numbers;
    for (std::size_t k = 0; k < node.items.size(); ++k) {
        numbers.push_back(node.items[k].text);
        if (k % 2 == 1)
            numbers.push_back(length == 3 ? last_name(list) : fmt::format("z{}", k / 2));
    }
    return fmt::format("[{}]", fmt::join(numbers, ", "));
}

// Returns what else a scalar may be replaced by: a list, or a mapping.
std::string structure_instead(const Node& node, const std::vector<Form>& forms) {
    if (forms.size() == 1 && forms[0].section) return keys_hint(*forms[0].section);
    if (forms.size() < 2) return "";
    std::vector<std::string> others;
    for (const Form& form : forms) {
        if (form.shape == Shape::list) others.push_back(phrase(form));
        if (form.shape != Shape::mapping) continue;
        const bool is_named = phrase(form) != "a mapping";
        others.push_back(is_named ? phrase(form)
                                  : "a mapping with " + listed(key_names(*form.section), "and"));
    }
    const bool has_scalar = node.is_scalar() && others.size() < forms.size();
    if (others.empty() || !has_scalar) return "";
    const bool has_number =
        form_of(forms, Shape::number) != nullptr || form_of(forms, Shape::integer) != nullptr;
    return (has_number ? "write a number, or give " : "or give ") + listed(others, "or");
}

// Returns a hint for a mark that means nothing to YAML where it stands, or something else.
std::string mark_hint(const std::string& text, const std::vector<Form>& forms) {
    for (const std::string_view quote : {"“", "”", "„", "‘", "’", "«", "»"})
        if (text.find(quote) != std::string::npos)
            return "YAML takes typographic quotation marks for letters: write straight ones";
    if (text.starts_with('(')) return "lists are written in brackets: [1, 2]";
    const Form* mapping = form_of(forms, Shape::mapping);
    const std::size_t colon = text.find(':');
    if (mapping == nullptr || colon == std::string::npos) return "";
    const std::string key = text.substr(0, colon);
    if (mapping->section->index(key) == mapping->section->keys.size()) return "";
    return fmt::format("put a space after the colon: `{}: {}`", key, text.substr(colon + 1));
}

std::string scalar_hint(const Node& node, const std::vector<Form>& forms) {
    if (const std::string hint = mark_hint(node.text, forms); !hint.empty()) return hint;
    if (const std::string text = rewritten(node, forms); !text.empty())
        return fmt::format("write `{}`", text);
    if (form_of(forms, Shape::color) != nullptr) return color_hint(node.text);
    if (const std::string hint = word_hint(node, forms); !hint.empty()) return hint;
    if (form_of(forms, Shape::flag))
        if (const std::string hint = flag_hint(node); !hint.empty()) return hint;
    const Form* number = form_of(forms, Shape::number);
    if (number == nullptr) number = form_of(forms, Shape::integer);
    const auto value = number_in(node);
    const bool has_unit = !value && parse_number(node.text.substr(0, 1)).has_value();
    if (const Form* length = form_of(forms, Shape::length); length != nullptr && has_unit)
        return fmt::format("the units of lengths are {}: `{}`", listed(length_units()),
                           length_example(*length));
    if (number != nullptr)
        if (const std::string hint = value ? range_hint(node, *value, *number) : number_hint(node);
            !hint.empty())
            return hint;
    const Form* list = form_of(forms, Shape::list);
    if (const std::size_t length = list != nullptr ? numbers_in(*list) : 0;
        (length == 2 || length == 3) && value && number == nullptr)
        return fmt::format("{} numbers: {}", length == 2 ? "two" : "three", phrase(*list));
    return structure_instead(node, forms);
}

std::string structure_hint(const Node& node, const std::vector<Form>& forms) {
    if (node.kind == Node::Kind::null && is_comment_behind(node))
        return "`#` begins a comment; put the value in quotes";
    if (const std::string text = rewritten(node, forms); !text.empty())
        return fmt::format("write `{}`", text);
    if (node.is_list() && form_of(forms, Shape::color) != nullptr) {
        std::vector<std::string> channels;
        for (const Node& item : node.items) channels.push_back(item.text);
        return color_hint(fmt::format("{}", fmt::join(channels, ",")));
    }
    const Form* list = form_of(forms, Shape::list);
    if (const std::string text = list != nullptr ? with_depth(node, *list) : ""; !text.empty())
        return fmt::format("a box with three lengths needs {}: write `{}`", phrase(*list), text);
    if (node.is_mapping() && list && form_of(list->items, Shape::mapping))
        return "begin each item of the list with `- `, or put brackets around it: [{...}]";
    if (node.is_mapping() && list != nullptr && !list->list_hint.empty()) return list->list_hint;
    const char begin = first_byte(node);
    if (form_of(forms, Shape::text) && (begin == '[' || begin == '{'))
        return fmt::format("a text that begins with `{}` needs quotes", begin);
    if (!node.is_list() || forms.empty()) return "";
    for (const Node& item : node.items)
        if (item.is_scalar() && item.text.find(';') != std::string::npos)
            return "a comma separates the items of a list";
    const Form& form = list != nullptr ? *list : forms.front();
    const bool is_long = list != nullptr && node.items.size() > list->most.count();
    return form.list_hint.empty() && is_long ? to_text(list->most) : form.list_hint;
}

// Returns an example of a value: the usual one, or one of the form that is most like what was
// written.
std::string example_hint(const Node& node, const std::vector<Form>& forms,
                         const std::string& usual) {
    if (forms.empty()) return "";
    if (!usual.empty() && !node.is_list() && !node.is_mapping())
        return fmt::format("for instance `{}`", usual);
    const Form* like = node.is_list()      ? form_of(forms, Shape::list)
                       : node.is_mapping() ? form_of(forms, Shape::mapping)
                                           : nullptr;
    return fmt::format("for instance `{}`", example_text(like != nullptr ? *like : forms.front()));
}

// Returns the names of the sections that have a key, searching inside `whole` and stopping at the
// outermost level that has any.
std::vector<std::string> owners_of(const std::string& key, const Section& whole) {
    std::vector<const Section*> level{&whole};
    std::vector<std::string> owners;
    while (owners.empty() && !level.empty()) {
        std::vector<const Section*> inner;
        for (const Section* section : level)
            for (const Key& one : section->keys)
                for (const Section* its : sections_in(one.forms)) inner.push_back(its);
        for (const Section* section : inner)
            if (section->index(key) < section->keys.size() && !has_word(owners, section->name))
                owners.push_back(section->name);
        level = std::move(inner);
    }
    return owners;
}

// Returns where a key belongs, if only in a few places: inside this section, at the top level of
// the file, or elsewhere in it.
std::string place_of_key(const std::string& key, const Section& section, const Section& whole) {
    constexpr std::size_t few = 3;
    std::vector<std::string> owners = owners_of(key, section);
    if (owners.empty() && whole.index(key) < whole.keys.size())
        return fmt::format("`{}` stands at the top level of the file", key);
    if (owners.empty()) owners = owners_of(key, whole);
    if (owners.empty() || owners.size() > few) return "";
    return fmt::format("`{}` is a key of {}", key, listed(owners, "and"));
}

// Returns the key whose former name programs that read YAML 1.1 have turned into this word: they
// take `on` for true.
const Key* key_read_as_flag(const std::string& word, const Section& section) {
    if (word != "true" && word != "True") return nullptr;
    const auto found = std::ranges::find(section.keys, "on", &Key::formerly);
    return found == section.keys.end() ? nullptr : &*found;
}

// Returns whether the section has a key `kind` of which this is a value.
bool is_kind(const std::string& word, const Section& section) {
    const std::size_t kind = section.index("kind");
    return kind < section.keys.size() &&
           std::ranges::any_of(section.keys[kind].forms,
                               [&](const Form& form) { return has_word(form.words, word); });
}

}  // namespace

const Form* form_of(const std::vector<Form>& forms, Shape shape) {
    const auto found = std::ranges::find(forms, shape, &Form::shape);
    return found == forms.end() ? nullptr : &*found;
}

std::vector<std::string> key_names(const Section& section) {
    std::vector<std::string> names;
    for (const Key& key : section.keys) names.push_back(key.name);
    return names;
}

std::optional<std::string> meant_key(const std::string& name, const Section& section) {
    if (const Key* key = key_read_as_flag(name, section)) return key->name;
    if (is_kind(name, section)) return "kind";
    for (const Key& key : section.keys)
        if (has_word(key.tried, name)) return key.name;
    return nearest_spelling(name, key_names(section));
}

std::string hint_for(const Node& node, const std::vector<Form>& forms, const std::string& usual) {
    if (const std::string hint = node.is_scalar() ? odd_space_hint(node.text) : ""; !hint.empty())
        return hint;
    const std::string hint =
        node.is_scalar() ? scalar_hint(node, forms) : structure_hint(node, forms);
    return hint.empty() ? example_hint(node, forms, usual) : hint;
}

std::string control_hint(const Node& node) {
    if (first_byte(node) == '"')
        return "in double quotes a backslash begins an escape of YAML: write the text in single "
               "quotes";
    return "write a space instead";
}

std::string lines_hint(const Node& node) {
    if (first_byte(node) == '"') return "leave out the `\\n`";
    return first_byte(node) == '|' ? "`>` instead of `|` joins the lines to one"
                                   : "leave out the empty line";
}

std::string hint_for_unknown(const Node& key, const Section& section, const Section& whole) {
    const std::string& name = key.text;
    if (const std::string hint = odd_space_hint(name); !hint.empty()) return hint;
    if (name.find_first_not_of("0123456789") == std::string::npos)  // {radius: 0,7}
        return name.size() == 3 ? "a comma separates keys; write thousands without it: 1000"
                                : "a comma separates keys; write decimals with a point: 0.5";
    if (const Key* meant = key_read_as_flag(name, section))
        return fmt::format(
            "write `{}`: a program that reads YAML 1.1 has taken the key `on` for `true`",
            meant->name);
    if (const std::size_t sign = name.find('='); sign != std::string::npos) {
        const auto trimmed = [](std::string text) {
            text.erase(0, text.find_first_not_of(' '));
            return text.substr(0, text.find_last_not_of(' ') + 1);
        };
        return fmt::format("write `{}: {}`", trimmed(name.substr(0, sign)),
                           trimmed(name.substr(sign + 1)));
    }
    if (is_kind(name, section)) return fmt::format("write `kind: {}`", name);
    constexpr std::size_t few = 17;
    const std::string place = place_of_key(name, section, whole);
    if (const auto meant = meant_key(name, section))
        return fmt::format("did you mean `{}`?{}", *meant, place.empty() ? "" : " Or, " + place);
    if (place.empty()) return keys_hint(section);
    return section.keys.size() > few ? place : place + "; " + keys_hint(section, section.name);
}

}  // namespace carom
