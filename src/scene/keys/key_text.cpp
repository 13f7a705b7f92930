#include "scene/keys/key_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

// Returns the wanted number if it is allowed, otherwise the smallest number allowed.
std::string example_number(const Range& range, double wanted = 1.0) {
    const bool is_allowed = range.low <= wanted && range.most.value >= wanted;
    return number_text(is_allowed ? wanted : range.low);
}

bool is_number(const Form& form) {
    return form.shape == Shape::number || form.shape == Shape::integer;
}

std::string example_list(const Form& form) {
    const std::size_t length = std::max<std::size_t>(1, form.shortest);
    const Form& item = form.items.front();
    std::string text;
    for (std::size_t i = 0; i < length; ++i)  // numbers increase: many lists are ends of ranges
        text += (i > 0 ? ", " : "") +
                (is_number(item) ? example_number(item.range, 1.0 + static_cast<double>(i))
                                 : example_text(item));
    return "[" + text + "]";
}

bool is_first_of_needed(const Section& section, const std::string& name) {
    return std::ranges::any_of(section.choices, [&](const Choice& choice) {
        return choice.required && choice.names.front() == name;
    });
}

std::string example_mapping(const Section& section) {
    std::string text;
    for (const Key& key : section.keys)
        if (key.required || is_first_of_needed(section, key.name))
            text += (text.empty() ? "" : ", ") + key.name + ": " + example_text(key);
    if (text.empty()) text = section.keys.front().name + ": " + example_text(section.keys.front());
    return "{" + text + "}";
}

std::string form_text(const Form& form) {
    if (is_number(form) && form.range.low == form.range.most.value)
        return number_text(form.range.low);
    const std::string words = phrase(form);
    return form.section && words == "a mapping" ? "a mapping, see " + form.section->name : words;
}

}  // namespace

std::string forms_text(const Key& key) {
    std::string text;
    for (std::size_t i = 0; i < key.forms.size(); ++i) {
        if (i > 0) text += i + 1 == key.forms.size() ? "; or " : "; ";
        text += form_text(key.forms[i]);
    }
    return text;
}

std::string example_text(const Key& key) {
    return key.default_value.empty() ? example_text(key.forms.front()) : key.default_value;
}

std::string example_text(const Form& form) {
    switch (form.shape) {
        case Shape::number:
        case Shape::integer:
            return example_number(form.range);
        case Shape::length:
            return length_example(form);
        case Shape::flag:
            return "true";
        case Shape::text:
            return form.words.empty() ? "words" : form.words.front();
        case Shape::word:
            return form.words.front();
        case Shape::color:
            return "teal";
        case Shape::list:
            return example_list(form);
        case Shape::mapping:
            return example_mapping(*form.section);
    }
    return "";
}

}  // namespace carom
