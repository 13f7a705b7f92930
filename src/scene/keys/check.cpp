#include "scene/keys/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/keys/hints.h"
#include "scene/keys/key_text.h"
#include "scene/keys/numbers_in_words.h"
#include "scene/yaml/scalar.h"
#include "scene/yaml/yaml_text.h"
#include "util/text.h"

namespace carom {
namespace {

/// What the check of a value needs: the name of the value for messages, the section of the whole
/// file, the list of errors, and the default of the key.
struct Context {
    const std::string& what;
    const Section& whole;
    Errors& errors;
    std::string usual = "";
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

void mismatch(Node& node, const std::vector<Form>& forms, Context context) {
    refuse(node,
           fmt::format("expected {} for {}, found {}", expected(node, forms), context.what,
                       described(node)),
           hint_for(node, forms, context.usual), context.errors);
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

bool is_word(const Node& node, const std::vector<Form>& forms) {
    return std::ranges::any_of(forms,
                               [&](const Form& form) { return contains(form.words, node.text); });
}

bool in_range(double value, const Form& form) {
    const bool whole = form.shape != Shape::integer || value == std::floor(value);
    return whole && value >= form.range.low && value <= form.range.most.value;
}

// Refuses a backslash of a formula that YAML has taken for an escape, as in "$\nu$": a line break
// and a u.
bool check_formulas(Node& node, Context context) {
    const std::string& text = node.source->text;
    const std::size_t at = escape_in_formula(text, node.offset);
    if (at == std::string::npos) return true;
    const std::string command = text.substr(at, command_bytes(text, at));
    node.valid = false;
    context.errors.add(
        *node.source, at,
        fmt::format("in double quotes `{}` is an escape of YAML, no command of a formula",
                    text.substr(at, 2)),
        fmt::format("write the text in single quotes, or the backslash twice: `\\{}`", command));
    return false;
}

void check_text(Node& node, const Form& form, Context context) {
    const int length =
        form.formulas ? letters_with_usual_numbers(node.text) : code_points(node.text);
    if (length > form.most.value)
        return refuse(node, fmt::format("{} has {} characters", context.what, length),
                      to_text(form.most), context.errors);
    const std::size_t end = node.text.find_last_not_of(" \t\n") + 1;
    if (end == 0 && form.shortest > 0) return mismatch(node, {form}, context);
    if (form.formulas && !check_formulas(node, context)) return;
    for (std::size_t i = 0; i < end;) {
        const std::size_t next = next_code_point(node.text, i);
        const std::string_view letter = std::string_view{node.text}.substr(i, next - i);
        if (letter == "\n" && !form.lines)
            return refuse(node, fmt::format("{} is one line, found several", context.what),
                          lines_hint(node), context.errors);
        if (is_control(letter) && letter != "\n")
            return refuse(node, fmt::format("{} contains a control character", context.what),
                          control_hint(node), context.errors);
        i = next;
    }
}

void check_scalar(Node& node, const std::vector<Form>& forms, Context context) {
    if (const Form* form = form_of(forms, Shape::text)) return check_text(node, *form, context);
    if (is_word(node, forms)) return;
    if (form_of(forms, Shape::color) && !color_hex(node.text).empty()) return;
    if (form_of(forms, Shape::flag) && flag_in(node)) return;
    if (const Form* length = form_of(forms, Shape::length); length != nullptr && !node.quoted)
        if (const auto value = parse_length(node.text, length->unit))
            if (in_range(*value, *length)) return;
    const Form* form = form_of(forms, Shape::number);
    if (form == nullptr) form = form_of(forms, Shape::integer);
    if (const auto value = number_in(node); form != nullptr && value)
        if (in_range(*value, *form)) return;
    mismatch(node, forms, context);
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
    if (length >= form.shortest && length <= form.most.count()) return;
    mismatch(node, forms, context);
}

void check_list(Node& node, const std::vector<Form>& forms, Context context) {
    auto form = std::ranges::find_if(
        forms, [&](const Form& candidate) { return fits_items(node, candidate); });
    if (form == forms.end()) form = std::ranges::find(forms, Shape::list, &Form::shape);
    if (form == forms.end()) return mismatch(node, forms, context);
    check_length(node, *form, forms, context);
    if (!node.valid) return;
    const bool independent = form_of(form->items, Shape::mapping) != nullptr;
    const std::string what = "an item of " + context.what;
    for (Node& item : node.items) {
        check_value(item, form->items, {what, context.whole, context.errors});
        if (!item.valid && !independent) node.valid = false;
    }
}

void check_value(Node& node, const std::vector<Form>& forms, Context context) {
    if (!node.valid) return;  // its unit has been refused
    switch (node.kind) {
        case Node::Kind::scalar:
            return check_scalar(node, forms, context);
        case Node::Kind::list:
            return check_list(node, forms, context);
        case Node::Kind::mapping:
            if (const Form* form = form_of(forms, Shape::mapping))
                return check_section(node, *form->section, context.whole, context.errors);
            return mismatch(node, forms, context);
        case Node::Kind::null:
            return mismatch(node, forms, context);
    }
}

void unknown_key(const Node& key, const Section& section, const Section& whole, Errors& errors) {
    if (errors.is_full()) return errors.add(key, "", "");
    if (key.text == "<<")
        return errors.add(key, "YAML's merge keys (`<<`) are not read", "write the keys out");
    const auto refused = std::ranges::find(section.refused, key.text, &Refused::name);
    if (refused != section.refused.end()) return errors.add(key, refused->reason, refused->hint);
    errors.add(key, fmt::format("{} is not a key of {}", in_quotes(key.text), section.name),
               hint_for_unknown(key, section, whole));
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
        errors.add(node, fmt::format("{} needs {}", section.name, listed(choice.names, "or", "`")),
                   fmt::format("for instance `{}: {}`", choice.names.front(),
                               example_text(section.keys.at(section.index(choice.names.front())))));
}

// Returns whether an unknown key, which has been reported, was probably meant as the key `name`.
bool is_meant(const Node& node, const Section& section, const std::string& name) {
    const std::vector<std::string> names = key_names(section);
    return std::ranges::any_of(node.keys, [&](const Node& key) {
        if (section.index(key.text) < names.size()) return false;
        const bool refused =
            std::ranges::find(section.refused, key.text, &Refused::name) != section.refused.end();
        return refused || names.size() == 1 || meant_key(key.text, section) == name;
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

// Gives keys with a former name their present one, with a note. Beside the present name, the later
// origin wins.
void rename_former(Node& node, const Section& section, Errors& errors) {
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        Node& key = node.keys[i];
        if (section.index(key.text) < section.keys.size()) continue;
        const auto now = std::ranges::find(section.keys, key.text, &Key::formerly);
        if (now == section.keys.end() || key.text.empty()) continue;
        const auto other = std::ranges::find(node.keys, now->name, &Node::text);
        if (other == node.keys.end()) {
            errors.add_note(key, fmt::format("`{}` is now called `{}`", key.text, now->name),
                            "the former name is read by this version for the last time");
            key.text = now->name;
            continue;
        }
        const Origin origin = key.source->origin, other_origin = other->source->origin;
        if (origin == other_origin) refuse_together(errors, key, {now->name, key.text});
        const auto index = static_cast<std::size_t>(other - node.keys.begin());
        const bool replaces = origin > other_origin;
        if (replaces) key.text = now->name;
        erase_key(node, replaces ? index : i);
        --i;
    }
}

void check_section(Node& node, const Section& section, const Section& whole, Errors& errors) {
    rename_former(node, section, errors);
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const std::size_t index = section.index(node.keys[i].text);
        if (index == section.keys.size()) {
            unknown_key(node.keys[i], section, whole, errors);
            continue;
        }
        const Key& key = section.keys[index];
        check_value(node.items[i], key.forms,
                    {"`" + key.name + "`", whole, errors, key.default_value});
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
