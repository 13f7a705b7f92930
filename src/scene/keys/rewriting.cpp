#include "scene/keys/rewriting.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "scene/keys/hints.h"
#include "scene/yaml/scalar.h"

namespace carom {
namespace {

using Texts = std::vector<std::string>;

const Form* number_form(const std::vector<Form>& forms) {
    const Form* form = form_of(forms, Shape::number);
    return form != nullptr ? form : form_of(forms, Shape::integer);
}

// Returns whether a text is a number that the form allows.
bool is_number_of(const std::string& text, const Form& form) {
    const auto value = parse_number(text);
    return value && *value >= form.range.low && *value <= form.range.most.value;
}

bool is_word_of(const std::string& text, const std::vector<Form>& forms) {
    return std::ranges::any_of(forms, [&](const Form& form) {
        return std::ranges::find(form.words, text) != form.words.end();
    });
}

// Returns the parts between separators, which may have spaces around them.
Texts parts_of(std::string text, const std::vector<std::string_view>& separators) {
    for (const std::string_view separator : separators)
        for (std::size_t at; (at = text.find(separator)) != text.npos;)
            text.replace(at, separator.size(), "\n");
    Texts parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string part = text.substr(at, end - at);
        const std::size_t first = part.find_first_not_of(" ()");
        if (first != part.npos)
            parts.push_back(part.substr(first, part.find_last_not_of(" ()") + 1 - first));
        at = end + 1;
    }
    return parts;
}

// Returns a list of exactly so many numbers as the form wants; empty if they are not right for it.
std::string list_of_numbers(const Texts& numbers, const Form& list) {
    const Form* number = number_form(list.items);
    const bool is_right =
        number != nullptr && numbers.size() == list.shortest &&
        list.most.value == static_cast<double>(list.shortest) &&
        std::ranges::all_of(numbers, [&](const auto& one) { return is_number_of(one, *number); });
    return is_right ? fmt::format("[{}]", fmt::join(numbers, ", ")) : "";
}

// "40 x 30", "40, 30"; "time, collisions" where words are listed; one item of a list.
std::string scalar_as_list(const std::string& text, const std::vector<Form>& forms) {
    const Form* list = form_of(forms, Shape::list);
    if (list == nullptr) return "";
    const Texts parts = parts_of(text, {",", ";", "×", "x", "X", "*", ":", "/", " by "});
    if (const std::string numbers = list_of_numbers(parts, *list); !numbers.empty()) return numbers;
    if (forms.size() > 1 || list->shortest > 1)
        return list->shortest == 0 && text == "none" ? "[]" : "";
    const Texts words = parts_of(text, {",", ";", " + ", " and "});
    const bool are_words = !words.empty() && std::ranges::all_of(words, [&](const auto& word) {
        return is_word_of(word, list->items);
    });
    if (are_words) return fmt::format("[{}]", fmt::join(words, ", "));
    if (text == "none" && list->shortest == 0) return "[]";
    return form_of(list->items, Shape::text) != nullptr ? "[" + text + "]" : "";
}

// "0.4-0.6" and "0.5 +- 0.1" where a number may have a distribution.
std::string as_distribution(const std::string& text, const std::vector<Form>& forms) {
    const Form *number = number_form(forms), *mapping = form_of(forms, Shape::mapping);
    if (number == nullptr || mapping == nullptr) return "";
    const auto pair = [&](const char* key,
                          const std::vector<std::string_view>& separators) -> std::string {
        const Texts ends = parts_of(text, separators);
        const bool has_key = mapping->section->index(key) < mapping->section->keys.size();
        if (!has_key || ends.size() != 2 || !is_number_of(ends[0], *number) ||
            !is_number_of(ends[1], *number))
            return "";
        return fmt::format("{{{}: [{}, {}]}}", key, ends[0], ends[1]);
    };
    const std::string normal = pair("normal", {"+-", "+/-", "±"});
    return normal.empty() ? pair("uniform", {" to ", "..", "–", "-"}) : normal;
}

// A list of one item where the item alone is allowed.
std::string item_alone(const Node& list, const std::vector<Form>& forms) {
    if (list.items.size() != 1 || !list.items[0].is_scalar()) return "";
    const std::string& text = list.items[0].text;
    const Form* number = number_form(forms);
    const bool is_right = is_word_of(text, forms) ||
                          (number != nullptr && is_number_of(text, *number)) ||
                          (form_of(forms, Shape::flag) != nullptr && flag_in(list.items[0]));
    return is_right ? text : "";
}

}  // namespace

std::string rewritten(const Node& node, const std::vector<Form>& forms) {
    if (node.is_scalar()) {
        const std::string list = scalar_as_list(node.text, forms);
        return list.empty() ? as_distribution(node.text, forms) : list;
    }
    if (node.is_list()) return item_alone(node, forms);
    const Form* list = form_of(forms, Shape::list);
    if (!node.is_mapping() || list == nullptr) return "";
    Texts values;  // {width: 40, height: 30} for [40, 30]
    for (const Node& value : node.items) values.push_back(value.text);
    return list_of_numbers(values, *list);
}

}  // namespace carom
