#include "scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

/// A value on its way through the check: what it is for, and where to report.
struct Context {
    const std::string& key;
    Errors& errors;
};

void refuse(Node& node, std::string message, std::string hint, Errors& errors) {
    node.valid = false;
    errors.add(node, std::move(message), std::move(hint));
}

std::string joined(const std::vector<Form>& forms) {
    std::string text;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        if (i > 0) text += i + 1 == forms.size() ? " or " : ", ";
        text += phrase(forms[i]);
    }
    return text;
}

void mismatch(Node& node, const std::vector<Form>& forms, std::string hint, Context context) {
    refuse(
        node,
        fmt::format("expected {} for `{}`, found {}", joined(forms), context.key, described(node)),
        std::move(hint), context.errors);
}

const Form* form_of(const std::vector<Form>& forms, Shape shape) {
    const auto found = std::find_if(forms.begin(), forms.end(),
                                    [&](const Form& form) { return form.shape == shape; });
    return found == forms.end() ? nullptr : &*found;
}

bool in_range(double value, const Form& form) {
    const bool whole = form.shape != Shape::integer || value == std::floor(value);
    return whole && value >= form.range.low && value <= form.range.high;
}

void check_number(Node& node, double value, const Form& form, const std::vector<Form>& forms,
                  Context context) {
    if (in_range(value, form)) return;
    std::string hint;
    if (value > form.range.high && !form.range.ceiling.empty())
        hint = fmt::format("the ceiling is {} {}", form.range.high, form.range.ceiling);
    else if (value > 0.0 && value < form.range.low && form.range.low == smallest_quantity.value)
        hint = fmt::format("the smallest is {}", smallest_quantity.value);
    mismatch(node, forms, hint, context);
}

bool is_comment_behind(const Node& key_of_nothing) {
    const std::string& text = key_of_nothing.source->text;
    const std::size_t end = std::min(text.find('\n', key_of_nothing.offset), text.size());
    const std::string line = text.substr(key_of_nothing.offset, end - key_of_nothing.offset);
    const std::size_t colon = line.find(':');
    return colon != std::string::npos &&
           line.find_first_not_of(' ', colon + 1) == line.find('#', colon + 1) &&
           line.find('#', colon + 1) != std::string::npos;
}

void check_text(Node& node, const Form& form, Context context) {
    const int length = code_points(node.text);
    if (static_cast<std::size_t>(length) > form.longest)
        return refuse(node, fmt::format("`{}` has {} characters", context.key, length),
                      fmt::format("the ceiling is {}", form.longest), context.errors);
    if (node.text.find_first_not_of(" \t\n") == std::string::npos && form.shortest > 0)
        return mismatch(node, {form}, "", context);
    for (std::size_t i = 0; i < node.text.size(); i = next_code_point(node.text, i)) {
        const auto code = static_cast<unsigned char>(node.text[i]);
        const bool c1 = code == 0xC2 && i + 1 < node.text.size() &&
                        static_cast<unsigned char>(node.text[i + 1]) < 0xA0;
        const bool end = i + 1 == node.text.size();  // folded texts end in a line break
        const bool line_break = code == '\n' && (form.lines || end);
        if ((code < 0x20 && !line_break) || code == 0x7F || c1)
            return refuse(node,
                          code == '\n' ? fmt::format("`{}` is one line, found several", context.key)
                                       : fmt::format("`{}` holds a control character", context.key),
                          "", context.errors);
    }
}

std::string word_hint(const Node& node, const std::vector<Form>& forms) {
    std::vector<std::string> words;
    for (const Form& form : forms) words.insert(words.end(), form.words.begin(), form.words.end());
    const auto near = nearest_spelling(node.text, words);
    return near ? fmt::format("did you mean `{}`?", *near) : "";
}

std::string scalar_hint(const Node& node, const std::vector<Form>& forms) {
    if (const std::string hint = word_hint(node, forms); !hint.empty()) return hint;
    const bool numbers = form_of(forms, Shape::number) || form_of(forms, Shape::integer);
    if (numbers) return number_hint(node);
    if (form_of(forms, Shape::flag)) return flag_hint(node);
    if (form_of(forms, Shape::color)) {
        std::string names;
        for (const std::string& word : form_of(forms, Shape::color)->words)
            names += (names.empty() ? "" : ", ") + word;
        return "names: " + names;
    }
    return "";
}

bool is_word(const Node& node, const std::vector<Form>& forms) {
    return std::any_of(forms.begin(), forms.end(), [&](const Form& form) {
        return std::find(form.words.begin(), form.words.end(), node.text) != form.words.end();
    });
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

bool fits_items(const Node& node, const Form& form) {
    if (form.shape != Shape::list) return false;
    if (node.items.empty()) return true;
    const bool lists = form_of(form.items, Shape::list) != nullptr;
    return node.items.front().is_list() == lists;
}

void check_length(Node& node, const Form& form, const std::vector<Form>& forms, Context context) {
    const std::size_t length = node.items.size();
    if (length >= form.shortest && length <= form.longest) return;
    std::string hint;
    if (length > form.longest && !form.ceiling.empty())
        hint = fmt::format("the ceiling is {} {}", form.longest, form.ceiling);
    mismatch(node, forms, hint, context);
}

void check_list(Node& node, const std::vector<Form>& forms, Context context) {
    auto form = std::find_if(forms.begin(), forms.end(),
                             [&](const Form& candidate) { return fits_items(node, candidate); });
    if (form == forms.end()) form = forms.begin();
    while (form != forms.end() && form->shape != Shape::list) ++form;
    if (form == forms.end()) return mismatch(node, forms, "", context);
    check_length(node, *form, forms, context);
    if (!node.valid) return;
    const bool independent = form_of(form->items, Shape::mapping) != nullptr;
    for (Node& item : node.items) {
        check_value(item, form->items, context);
        if (!item.valid && !independent) node.valid = false;
    }
}

void check_value(Node& node, const std::vector<Form>& forms, Context context) {
    switch (node.kind) {
        case Node::Kind::scalar:
            return check_scalar(node, forms, context);
        case Node::Kind::list:
            return check_list(node, forms, context);
        case Node::Kind::mapping:
            if (const Form* form = form_of(forms, Shape::mapping))
                return check_mapping(node, *form->section, context.errors);
            return mismatch(node, forms, "", context);
        case Node::Kind::null:
            return mismatch(
                node, forms,
                is_comment_behind(node) ? "`#` begins a comment; put the value in quotes" : "",
                context);
    }
}

void unknown_key(const Node& key, const Section& section, Errors& errors) {
    for (const Refused& refused : section.refused)
        if (refused.name == key.text) return errors.add(key, refused.reason, refused.hint);
    std::vector<std::string> names;
    std::string list;
    for (const Key& known : section.keys) {
        names.push_back(known.name);
        list += (list.empty() ? "" : ", ") + known.name;
    }
    const auto near = nearest_spelling(key.text, names);
    errors.add(key, fmt::format("{} is not a key of {}", in_quotes(key.text), section.name),
               near ? fmt::format("did you mean `{}`?", *near) : "its keys are " + list);
}

std::string quoted_list(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += "`" + names[i] + "`";
    }
    return text;
}

// Where several are given, those of the latest origin count; two of these are one too many.
void check_choice(Node& node, const Choice& choice, const Section& section, Errors& errors) {
    Node* kept = nullptr;
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const auto& names = choice.names;
        if (std::find(names.begin(), names.end(), node.keys[i].text) == names.end()) continue;
        Node& value = node.items[i];
        const Origin origin = node.keys[i].source->origin;
        if (kept == nullptr) {
            kept = &value;
        } else if (origin > kept->source->origin) {
            std::exchange(kept, &value)->valid = false;
        } else {
            if (origin == kept->source->origin)
                errors.add(node.keys[i],
                           fmt::format("{} exclude one another, found a second one",
                                       quoted_list(choice.names)),
                           "keep one of them");
            value.valid = false;
        }
    }
    if (choice.required && kept == nullptr)
        errors.add(node, fmt::format("{} needs {}", section.name, quoted_list(choice.names)));
}

void check_presence(const Node& node, const Section& section, Errors& errors) {
    for (const Key& key : section.keys)
        if (key.required && find(node, key.name) == nullptr)
            errors.add(node, fmt::format("{} needs `{}`", section.name, key.name),
                       fmt::format("`{}`: {}", key.name, key.meaning));
}

// A key that only some kinds of panel have.
void check_kind(Node& node, const Section& section, Errors& errors) {
    const Node* kind = find(node, "kind");
    if (kind == nullptr || !kind->valid) return;
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const std::size_t index = section.index(node.keys[i].text);
        if (index == section.keys.size()) continue;
        const std::vector<std::string>& with = section.keys[index].with;
        if (with.empty() || std::find(with.begin(), with.end(), kind->text) != with.end()) continue;
        errors.add(node.keys[i],
                   fmt::format("`{}` has no meaning for a panel of kind `{}`", node.keys[i].text,
                               kind->text),
                   "it goes with " + quoted_list(with));
        node.items[i].valid = false;
    }
}

}  // namespace

void check_mapping(Node& node, const Section& section, Errors& errors) {
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const std::size_t index = section.index(node.keys[i].text);
        if (index == section.keys.size()) {
            unknown_key(node.keys[i], section, errors);
            continue;
        }
        const Key& key = section.keys[index];
        check_value(node.items[i], key.forms, {key.name, errors});
    }
    for (const Choice& choice : section.choices) check_choice(node, choice, section, errors);
    check_presence(node, section, errors);
    check_kind(node, section, errors);
}

}  // namespace carom
