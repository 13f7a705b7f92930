#include "scene/keys/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/keys/colors.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

/// What the check of a value needs: the name of the value for messages, the section of the whole
/// file, and the list of errors.
struct Context {
    const std::string& what;
    const Section& whole;
    Errors& errors;
};

void refuse(Node& node, std::string message, std::string hint, Errors& errors) {
    node.valid = false;
    errors.add(node, std::move(message), std::move(hint));
}

Node::Kind kind_of(const Form& form) {
    if (form.shape == Shape::list) return Node::Kind::list;
    return form.shape == Shape::mapping ? Node::Kind::mapping : Node::Kind::scalar;
}

// Returns the phrases of a form; each word separately, so that all can be in one list.
std::vector<std::string> phrases(const Form& form) {
    std::vector<std::string> words = form.words;
    if (form.shape == Shape::flag) words = {"true", "false"};
    if (!form.phrase.empty() || (form.shape != Shape::flag && form.shape != Shape::word))
        return {phrase(form)};
    for (std::string& word : words) word = "`" + word + "`";
    return words;
}

// Returns the forms that the value was probably meant to have: those of its kind of node, or all if
// there are none.
std::string expected(const Node& node, const std::vector<Form>& forms) {
    std::vector<std::string> near, all;
    for (const Form& form : forms)
        for (const std::string& one : phrases(form)) {
            all.push_back(one);
            if (kind_of(form) == node.kind) near.push_back(one);
        }
    const std::vector<std::string>& shown = near.empty() ? all : near;
    constexpr std::size_t most_shown = 12;
    if (shown.size() > most_shown) return fmt::format("one of {} names", shown.size());
    return listed(shown, "or");
}

void mismatch(Node& node, const std::vector<Form>& forms, std::string hint, Context context) {
    refuse(node,
           fmt::format("expected {} for {}, found {}", expected(node, forms), context.what,
                       described(node)),
           std::move(hint), context.errors);
}

const Form* form_of(const std::vector<Form>& forms, Shape shape) {
    const auto found = std::ranges::find(forms, shape, &Form::shape);
    return found == forms.end() ? nullptr : &*found;
}

bool in_range(double value, const Form& form) {
    const bool whole = form.shape != Shape::integer || value == std::floor(value);
    return whole && value >= form.range.low && value <= form.range.most.value;
}

void check_number(Node& node, double value, const Form& form, const std::vector<Form>& forms,
                  Context context) {
    if (in_range(value, form)) return;
    std::string hint;
    if (value > form.range.most.value)
        hint = to_text(form.range.most);
    else if (value > 0.0 && value < form.range.low && form.range.low == smallest_quantity.value)
        hint = fmt::format("the smallest is {}", smallest_quantity.value);
    mismatch(node, forms, hint, context);
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

void check_text(Node& node, const Form& form, Context context) {
    const int length = code_points(node.text);
    if (length > form.most.value)
        return refuse(node, fmt::format("{} has {} characters", context.what, length),
                      to_text(form.most), context.errors);
    const std::size_t end = node.text.find_last_not_of(" \t\n") + 1;
    if (end == 0 && form.shortest > 0) return mismatch(node, {form}, "", context);
    for (std::size_t i = 0; i < end;) {
        const std::size_t next = next_code_point(node.text, i);
        const std::string_view letter = std::string_view{node.text}.substr(i, next - i);
        if (letter == "\n" && !form.lines)
            return refuse(node, fmt::format("{} is one line, found several", context.what), "",
                          context.errors);
        if (is_control(letter) && letter != "\n")
            return refuse(node, fmt::format("{} contains a control character", context.what), "",
                          context.errors);
        i = next;
    }
}

std::vector<std::string> key_names(const Section& section) {
    std::vector<std::string> names;
    for (const Key& key : section.keys) names.push_back(key.name);
    return names;
}

std::string keys_hint(const Section& section, const std::string& of = "") {
    const std::vector<std::string> names = key_names(section);
    const std::string subject = names.size() == 1 ? "key" : "keys",
                      verb = names.size() == 1 ? "is" : "are";
    return (of.empty() ? "its " + subject : fmt::format("the {} of {}", subject, of)) + " " + verb +
           " " + listed(names, "and");
}

// Returns whether a name contains a word of `text`; hyphens separate the words of a name.
bool has_word_of(std::string_view text, std::string_view name) {
    constexpr std::size_t shortest = 4;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("- _", at), text.size());
        if (end - at >= shortest && name.find(text.substr(at, end - at)) != name.npos) return true;
        at = end + 1;
    }
    return false;
}

std::string word_hint(const Node& node, const std::vector<Form>& forms) {
    for (const Form& form : forms)
        for (const Elsewhere& other : form.elsewhere)
            if (other.word == node.text) return other.hint;
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

bool is_vector(const Form& list) {
    return list.phrase == "[x, y]" && form_of(list.items, Shape::number) != nullptr;
}

std::string scalar_hint(const Node& node, const std::vector<Form>& forms) {
    if (form_of(forms, Shape::color) != nullptr) return color_hint(node.text);
    if (const std::string hint = word_hint(node, forms); !hint.empty()) return hint;
    const bool numbers = form_of(forms, Shape::number) || form_of(forms, Shape::integer);
    if (numbers) return number_hint(node);
    if (form_of(forms, Shape::flag)) return flag_hint(node);
    if (forms.size() == 1 && forms[0].section) return keys_hint(*forms[0].section);
    const Form* list = form_of(forms, Shape::list);
    if (list != nullptr && is_vector(*list) && number_in(node))
        return "one number for each direction: [x, y]";
    return list != nullptr && forms.size() > 1 ? "or give " + phrase(*list) : "";
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

bool is_word(const Node& node, const std::vector<Form>& forms) {
    return std::ranges::any_of(forms,
                               [&](const Form& form) { return contains(form.words, node.text); });
}

void check_scalar(Node& node, const std::vector<Form>& forms, Context context) {
    if (const Form* form = form_of(forms, Shape::text)) return check_text(node, *form, context);
    if (is_word(node, forms)) return;
    if (form_of(forms, Shape::color) && !color_hex(node.text).empty()) return;
    if (form_of(forms, Shape::flag) && flag_in(node)) return;
    const Form* form = form_of(forms, Shape::number);
    if (form == nullptr) form = form_of(forms, Shape::integer);
    if (const auto value = number_in(node); form && value)
        return check_number(node, *value, *form, forms, context);
    mismatch(node, forms, scalar_hint(node, forms), context);
}

void check_value(Node& node, const std::vector<Form>& forms, Context context);
void check_section(Node& node, const Section& section, const Section& whole, Errors& errors);

bool fits_items(const Node& node, const Form& form) {
    if (form.shape != Shape::list) return false;
    if (node.items.empty()) return true;
    const bool lists = form_of(form.items, Shape::list) != nullptr;
    return node.items.front().is_list() == lists;
}

void check_length(Node& node, const Form& form, const std::vector<Form>& forms, Context context) {
    const std::size_t length = node.items.size();
    const bool too_long = length > form.most.count();
    if (length >= form.shortest && !too_long) return;
    mismatch(node, forms, too_long ? to_text(form.most) : "", context);
}

void check_list(Node& node, const std::vector<Form>& forms, Context context) {
    auto form = std::ranges::find_if(
        forms, [&](const Form& candidate) { return fits_items(node, candidate); });
    if (form == forms.end()) form = std::ranges::find(forms, Shape::list, &Form::shape);
    if (form == forms.end())
        return mismatch(node, forms, forms.empty() ? "" : forms.front().instead_of_list, context);
    check_length(node, *form, forms, context);
    if (!node.valid) return;
    const bool independent = form_of(form->items, Shape::mapping) != nullptr;
    const std::string what = "an item of " + context.what;
    for (Node& item : node.items) {
        check_value(item, form->items, {what, context.whole, context.errors});
        if (!item.valid && !independent) node.valid = false;
    }
}

std::string structure_hint(const Node& node, const std::vector<Form>& forms) {
    if (node.kind == Node::Kind::null && is_comment_behind(node))
        return "`#` begins a comment; put the value in quotes";
    const Form* list = form_of(forms, Shape::list);
    if (node.is_mapping() && list && form_of(list->items, Shape::mapping))
        return "begin each item of the list with `- `, or put brackets around it: [{...}]";
    return "";
}

void check_value(Node& node, const std::vector<Form>& forms, Context context) {
    switch (node.kind) {
        case Node::Kind::scalar:
            return check_scalar(node, forms, context);
        case Node::Kind::list:
            return check_list(node, forms, context);
        case Node::Kind::mapping:
            if (const Form* form = form_of(forms, Shape::mapping))
                return check_section(node, *form->section, context.whole, context.errors);
            return mismatch(node, forms, structure_hint(node, forms), context);
        case Node::Kind::null:
            return mismatch(node, forms, structure_hint(node, forms), context);
    }
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
            if (section->index(key) < section->keys.size() && !contains(owners, section->name))
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

std::string hint_for_unknown(const std::string& key, const Section& section, const Section& whole) {
    if (key.find_first_not_of("0123456789") == std::string::npos)  // {radius: 0,7}
        return "a comma separates keys; write decimals with a point: 0.5";
    constexpr std::size_t few = 13;
    const std::string place = place_of_key(key, section, whole);
    if (const auto near = nearest_spelling(key, key_names(section)))
        return fmt::format("did you mean `{}`?{}", *near, place.empty() ? "" : " Or, " + place);
    if (place.empty()) return keys_hint(section);
    return section.keys.size() > few ? place : place + "; " + keys_hint(section, section.name);
}

void unknown_key(const Node& key, const Section& section, const Section& whole, Errors& errors) {
    if (errors.is_full()) return errors.add(key, "");
    if (key.text == "<<")
        return errors.add(key, "YAML's merge keys (`<<`) are not read", "write the keys out");
    const auto refused = std::ranges::find(section.refused, key.text, &Refused::name);
    if (refused != section.refused.end()) return errors.add(key, refused->reason, refused->hint);
    errors.add(key, fmt::format("{} is not a key of {}", in_quotes(key.text), section.name),
               hint_for_unknown(key.text, section, whole));
}

bool knows_all(const Section& section, const Node& mapping) {
    return std::ranges::all_of(mapping.keys, [&](const Node& key) {
        return section.index(key.text) < section.keys.size();
    });
}

// Returns those of the names that a mapping has, in the order of the mapping.
std::vector<std::string> given_in(const Node& node, const std::vector<std::string>& names) {
    std::vector<std::string> given;
    for (const Node& key : node.keys)
        if (contains(names, key.text)) given.push_back(key.text);
    return given;
}

// If several of the keys are given, those of the latest origin win; two or more of the same origin
// are an error.
void check_choice(Node& node, const Choice& choice, const Section& section, Errors& errors) {
    Node* kept = nullptr;
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        if (!contains(choice.names, node.keys[i].text)) continue;
        Node& value = node.items[i];
        const Origin origin = node.keys[i].source->origin;
        if (kept == nullptr) {
            kept = &value;
        } else if (origin > kept->source->origin) {
            std::exchange(kept, &value)->valid = false;
        } else {
            if (origin == kept->source->origin)
                refuse_together(errors, node.keys[i], given_in(node, choice.names));
            value.valid = false;
        }
    }
    if (choice.required && kept == nullptr && knows_all(section, node))
        errors.add(node, fmt::format("{} needs {}", section.name, listed(choice.names, "or", "`")));
}

// Returns whether an unknown key, which has been reported, was probably meant as the key `name`.
bool is_meant(const Node& node, const Section& section, const std::string& name) {
    const std::vector<std::string> names = key_names(section);
    return std::ranges::any_of(node.keys, [&](const Node& key) {
        if (section.index(key.text) < names.size()) return false;
        const bool refused =
            std::ranges::find(section.refused, key.text, &Refused::name) != section.refused.end();
        return refused || names.size() == 1 || nearest_spelling(key.text, names) == name;
    });
}

void check_presence(const Node& node, const Section& section, Errors& errors) {
    for (const Key& key : section.keys) {
        const bool missing = key.required && find(node, key.name) == nullptr;
        if (missing && !is_meant(node, section, key.name))
            errors.add(node, fmt::format("{} needs `{}`", section.name, key.name),
                       fmt::format("`{}`: {}", key.name, key.meaning));
    }
}

// Reports keys that the panel's kind does not take.
void check_kind(Node& node, const Section& section, Errors& errors) {
    const Node* kind = find(node, "kind");
    if (kind == nullptr || !kind->valid) return;
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const std::size_t index = section.index(node.keys[i].text);
        if (index == section.keys.size()) continue;
        const std::vector<std::string>& kinds = section.keys[index].kinds;
        if (kinds.empty() || contains(kinds, kind->text)) continue;
        errors.add(node.keys[i],
                   fmt::format("`{}` does not apply to a panel of kind `{}`", node.keys[i].text,
                               kind->text),
                   "it applies to " + listed(kinds, "or", "`"));
        node.items[i].valid = false;
    }
}

void check_section(Node& node, const Section& section, const Section& whole, Errors& errors) {
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const std::size_t index = section.index(node.keys[i].text);
        if (index == section.keys.size()) {
            unknown_key(node.keys[i], section, whole, errors);
            continue;
        }
        const Key& key = section.keys[index];
        check_value(node.items[i], key.forms, {"`" + key.name + "`", whole, errors});
    }
    for (const Choice& choice : section.choices) check_choice(node, choice, section, errors);
    check_presence(node, section, errors);
    check_kind(node, section, errors);
}

}  // namespace

void check_mapping(Node& node, const Section& section, Errors& errors) {
    check_section(node, section, section, errors);
}

void refuse_together(Errors& errors, const Node& place, const std::vector<std::string>& keys) {
    errors.add(place, fmt::format("{} cannot be combined", listed(keys, "and", "`")),
               "keep one of them");
}

}  // namespace carom
