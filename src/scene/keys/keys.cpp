#include "scene/keys/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

std::string range_phrase(std::string_view what, const Range& range) {
    const bool open_below = range.low <= -largest_quantity.value;
    const bool open_above = range.most.value >= largest_quantity.value;
    if (range.low == smallest_quantity.value && open_above)
        return fmt::format("a positive {}", what);
    if (open_below && open_above) return fmt::format("a {}", what);
    if (open_above) return fmt::format("a {} of at least {}", what, number_text(range.low));
    return fmt::format("a {} from {} to {}", what, number_text(range.low),
                       number_text(range.most.value));
}

}  // namespace

std::size_t Section::index(std::string_view key) const {
    const auto found = std::ranges::find(keys, key, &Key::name);
    return static_cast<std::size_t>(found - keys.begin());
}

const Section* section_in(const std::vector<Form>& forms) {
    const std::vector<const Section*> sections = sections_in(forms);
    return sections.empty() ? nullptr : sections.front();
}

std::vector<const Section*> sections_in(const std::vector<Form>& forms) {
    std::vector<const Section*> sections;
    for (const Form& form : forms) {
        if (form.section) sections.push_back(form.section.get());
        for (const Section* inner : sections_in(form.items)) sections.push_back(inner);
    }
    return sections;
}

const Section& section_of(const Section& parent, std::string_view key) {
    const Section* section = section_in(parent.keys.at(parent.index(key)).forms);
    assert(section != nullptr);
    return *section;
}

namespace {

struct UnitOfLength {
    LengthUnit unit;
    std::string_view name;
    double points;
};

constexpr std::array units{
    UnitOfLength{LengthUnit::cm, "cm", 72.0 / 2.54},
    UnitOfLength{LengthUnit::mm, "mm", 72.0 / 25.4}, UnitOfLength{LengthUnit::in, "in", 72.0},
    UnitOfLength{LengthUnit::pt, "pt", 1.0}, UnitOfLength{LengthUnit::px, "px", 0.75}};

const UnitOfLength& entry_of(LengthUnit unit) { return units.at(static_cast<std::size_t>(unit)); }

}  // namespace

std::optional<double> parse_length(std::string_view text, LengthUnit unit) {
    for (const UnitOfLength& its : units) {
        if (!text.ends_with(its.name)) continue;
        std::string_view number = text.substr(0, text.size() - its.name.size());
        while (number.ends_with(' ')) number.remove_suffix(1);
        const auto value = parse_number(number);
        if (!value) return std::nullopt;
        return its.unit == unit ? *value : *value * its.points / entry_of(unit).points;
    }
    return std::nullopt;
}

std::vector<std::string> length_units() {
    std::vector<std::string> names;
    for (const UnitOfLength& unit : units) names.emplace_back(unit.name);
    return names;
}

std::string length_example(const Form& form) {
    return form.unit == LengthUnit::pt ? "8 pt" : "8 cm";
}

std::string phrase(const Form& form) {
    if (!form.phrase.empty()) return form.phrase;
    switch (form.shape) {
        case Shape::number:
            return range_phrase("number", form.range);
        case Shape::integer:
            return range_phrase("whole number", form.range);
        case Shape::length:
            return fmt::format("a length such as `{}`", length_example(form));
        case Shape::flag:
            return "`true` or `false`";
        case Shape::text:
            return form.shortest > 0 ? "a text that is not empty" : "a text";
        case Shape::word:
            return listed(form.words, "or", "`");
        case Shape::color:
            return "a colour (a name or \"#rrggbb\")";
        case Shape::list:
            return "a list";
        case Shape::mapping:
            return "a mapping";
    }
    return "a value";
}

}  // namespace carom
