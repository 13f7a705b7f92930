#include "scene/keys/unit_conversion.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "scene/keys/hints.h"
#include "scene/words.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

bool has_quantity(const Form& form) { return form.quantity || form.takes_any_quantity; }

bool is_numeric(const Form& form) {
    return form.shape == Shape::number || form.shape == Shape::integer;
}

void refuse_unit(Node& node, std::string message, std::string hint, Errors& errors) {
    node.valid = false;
    errors.add(node, std::move(message), std::move(hint));
}

std::string example_of(const Form& form) {
    return form.quantity ? fmt::format("it is {}: for instance `{}`",
                                       quantity_words(*form.quantity), unit_example(*form.quantity))
                         : "for instance `400 m/s`";
}

// Degrees Celsius are no multiple of a kelvin.
std::string celsius_hint(const NumberWithUnit& written) {
    constexpr double zero = 273.15;
    if (!std::ranges::count(std::vector<std::string_view>{"C", "°C", "degC", "Celsius", "celsius"},
                            written.unit))
        return "";
    return fmt::format("write `{:.10g} K`", parse_number(written.number).value_or(0.0) + zero);
}

std::string unit_hint(const NumberWithUnit& written, const Form& form) {
    if (std::string hint = celsius_hint(written); !hint.empty()) return hint;
    std::vector<std::string> names, fitting;
    for (const Unit& unit : all_units()) {
        names.emplace_back(unit.name);
        if (form.quantity && measures(unit, *form.quantity)) fitting.emplace_back(unit.name);
    }
    for (const std::vector<std::string>& from : {fitting, names})
        if (const auto near = nearest_spelling(written.unit, from))
            return fmt::format("did you mean `{}`?", *near);
    return fitting.empty()
               ? example_of(form)
               : fmt::format("the units of {} are {}", quantity_words(*form.quantity).substr(2),
                             listed(fitting, "and", "`"));
}

// A number whose digits a double cannot hold, as displacements may have, keeps them where its unit
// is one of those in which the scene is calculated.
std::string text_in_base_units(const NumberWithUnit& written, const Unit& unit, double value) {
    constexpr auto most_digits = 15;
    const std::string_view mantissa = written.number.substr(0, written.number.find_first_of("eE"));
    const auto digits =
        std::ranges::count_if(mantissa, [](char c) { return c >= '0' && c <= '9'; });
    return unit.factor == 1.0 && unit.power == 0 && digits > most_digits
               ? std::string(written.number)
               : fmt::format("{}", value);
}

void convert(Node& node, const NumberWithUnit& written, const Form& form, const std::string& what,
             Errors& errors) {
    const Unit* unit = unit_named(written.unit);
    if (unit == nullptr)
        return refuse_unit(node, fmt::format("{} is not a unit of carom", in_quotes(written.unit)),
                           unit_hint(written, form), errors);
    if (form.quantity && !measures(*unit, *form.quantity))
        return refuse_unit(node,
                           fmt::format("expected {} for {}, found {}",
                                       quantity_words(*form.quantity), what, described(node)),
                           fmt::format("for instance `{}`", unit_example(*form.quantity)), errors);
    const auto value = in_base_units(written.number, *unit);
    if (!value)
        return refuse_unit(node, fmt::format("{} is too large or too small", described(node)),
                           example_of(form), errors);
    std::string text = text_in_base_units(written, *unit, *value);
    node.written = std::exchange(node.text, std::move(text));
}

void convert_scalar(Node& node, const std::vector<Form>& forms, const std::string& what,
                    Errors& errors) {
    if (node.quoted || !node.written.empty()) return;
    const auto with_quantity = std::ranges::find_if(forms, has_quantity);
    const auto written = number_with_unit(node.text);
    if (with_quantity != forms.end()) {
        if (written) return convert(node, *written, *with_quantity, what, errors);
        const auto value = parse_number(node.text);
        const bool is_word = std::ranges::any_of(forms, [&](const Form& form) {
            return std::ranges::find(form.words, node.text) != form.words.end();
        });
        if (value && *value != 0.0 && !is_word)
            refuse_unit(node, fmt::format("{} needs a unit, found {}", what, described(node)),
                        example_of(*with_quantity), errors);
        return;
    }
    const bool is_number = std::ranges::any_of(forms, is_numeric) &&
                           form_of(forms, Shape::length) == nullptr &&
                           form_of(forms, Shape::text) == nullptr;
    if (is_number && written && unit_named(written->unit) != nullptr)
        refuse_unit(node, fmt::format("{} has no unit, found {}", what, described(node)),
                    fmt::format("write `{}`", written->number), errors);
}

void convert_value(Node& node, const std::vector<Form>& forms, const std::string& what,
                   Errors& errors) {
    if (node.is_scalar()) return convert_scalar(node, forms, what, errors);
    if (node.is_mapping()) {
        for (const Form& form : forms)
            if (form.shape == Shape::mapping && form.section)
                return convert_units(node, *form.section, errors);
        return;
    }
    // Of several lists that which has lists in it where the node has; numbers may stand in both.
    const Form* fitting = nullptr;
    for (const Form& form : forms) {
        if (form.shape != Shape::list) continue;
        const bool nests = form_of(form.items, Shape::list) != nullptr;
        if (fitting == nullptr || (!node.items.empty() && node.items.front().is_list() == nests))
            fitting = &form;
    }
    if (fitting == nullptr) return;
    const std::string item_words = "an item of " + what;
    for (Node& item : node.items) convert_value(item, fitting->items, item_words, errors);
}

}  // namespace

std::optional<NumberWithUnit> number_with_unit(std::string_view text) {
    // A number ends with a digit or a point; the `e` after it may begin its power or its unit.
    constexpr std::size_t longest_end = 2;  // of what may belong to either: `e+`
    std::size_t length = std::min(text.find_first_not_of("0123456789+-.eE"), text.size());
    for (std::size_t k = 0; k <= longest_end && length > 0; ++k, --length) {
        if (length == text.size() || !parse_number(text.substr(0, length))) continue;
        std::string_view unit = text.substr(length);
        while (unit.starts_with(' ')) unit.remove_prefix(1);
        while (unit.ends_with(' ')) unit.remove_suffix(1);
        const auto letter = static_cast<unsigned char>(unit.empty() ? ' ' : unit.front());
        const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
        const bool is_sign = unit.starts_with("µ") || unit.starts_with("μ") ||
                             unit.starts_with("Å") || unit.starts_with("Å") ||
                             unit.starts_with("°") || unit.starts_with("1/");
        if (!is_letter && !is_sign) return std::nullopt;
        return NumberWithUnit{text.substr(0, length), unit};
    }
    return std::nullopt;
}

UnitSystem units_of(const Node& root) {
    const Node* units = find(root, "units");
    const bool is_reduced = units == nullptr || units->text == word_of(UnitSystem::reduced);
    return is_reduced ? UnitSystem::reduced : UnitSystem::real;
}

void convert_units(Node& mapping, const Section& section, Errors& errors) {
    if (!mapping.is_mapping()) return;
    for (std::size_t i = 0; i < mapping.keys.size(); ++i) {
        const std::string& name = mapping.keys[i].text;
        auto key = std::ranges::find(section.keys, name, &Key::name);
        if (key == section.keys.end()) key = std::ranges::find(section.keys, name, &Key::formerly);
        if (key == section.keys.end() || name.empty()) continue;
        convert_value(mapping.items[i], key->forms, "`" + key->name + "`", errors);
    }
}

std::string in_unit_of(const Node& node, double value) {
    const auto written = number_with_unit(node.written);
    const Unit* unit = written ? unit_named(written->unit) : nullptr;
    if (unit == nullptr) return number_text(value);
    return fmt::format("{:.6g} {}", from_base_units(value, *unit), written->unit);
}

}  // namespace carom
