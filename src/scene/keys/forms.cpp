#include "scene/keys/forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "util/text.h"

namespace carom {
namespace {

const Source& preset_source() {
    static const Source source{"default", "", Origin::preset};
    return source;
}

std::string range_phrase(std::string_view what, const Range& range) {
    const bool open_below = range.low <= -largest_quantity.value;
    const bool open_above = range.high >= largest_quantity.value;
    if (range.low == smallest_quantity.value && open_above)
        return fmt::format("a positive {}", what);
    if (open_below && open_above) return fmt::format("a {}", what);
    if (open_above) return fmt::format("a {} of at least {}", what, number_text(range.low));
    return fmt::format("a {} from {} to {}", what, number_text(range.low), number_text(range.high));
}

Section law(Range range) {
    const Range spread{0.0, range.high, range.ceiling};
    return complete({.name = "a law",
                     .keys = {{"uniform",
                               "Evenly spread between two numbers.",
                               {list_of({number(range)}, 2, 2, "[low, high]")}},
                              {"normal",
                               "A normal law with this mean and standard deviation.",
                               {list_of({number(spread)}, 2, 2, "[mean, deviation]")}}},
                     .choices = {{{"uniform", "normal"}, true}}});
}

using NamedColor = std::pair<std::string_view, std::string_view>;

constexpr std::array<NamedColor, 18> color_names{{{"black", "#000000"},
                                                  {"silver", "#c0c0c0"},
                                                  {"gray", "#808080"},
                                                  {"grey", "#808080"},
                                                  {"white", "#ffffff"},
                                                  {"maroon", "#800000"},
                                                  {"red", "#ff0000"},
                                                  {"purple", "#800080"},
                                                  {"fuchsia", "#ff00ff"},
                                                  {"green", "#008000"},
                                                  {"lime", "#00ff00"},
                                                  {"olive", "#808000"},
                                                  {"yellow", "#ffff00"},
                                                  {"navy", "#000080"},
                                                  {"blue", "#0000ff"},
                                                  {"teal", "#008080"},
                                                  {"aqua", "#00ffff"},
                                                  {"orange", "#ffa500"}}};

bool is_hex(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

}  // namespace

Form number(Range range) { return {.shape = Shape::number, .range = range}; }

Form integer(double low, Limit most) {
    return {.shape = Shape::integer, .range = {low, most.value, most.meaning}};
}

Form flag() { return {.shape = Shape::flag}; }

Form one_of(std::vector<std::string> words) {
    return {.shape = Shape::word, .words = std::move(words)};
}

Form color() {
    Form form{.shape = Shape::color};
    for (const auto& [name, hex] : color_names) form.words.emplace_back(name);
    return form;
}

Form text(std::size_t shortest, Limit most) {
    return {.shape = Shape::text,
            .shortest = shortest,
            .longest = most.count(),
            .ceiling = most.meaning};
}

Form lines(std::size_t shortest, Limit most) {
    Form form = text(shortest, most);
    form.lines = true;
    return form;
}

Form list_of(std::vector<Form> items, std::size_t shortest, std::size_t longest,
             std::string phrase) {
    return {.shape = Shape::list,
            .items = std::move(items),
            .shortest = shortest,
            .longest = longest,
            .phrase = std::move(phrase)};
}

Form list_of(std::vector<Form> items, std::size_t shortest, Limit most, std::string phrase) {
    Form form = list_of(std::move(items), shortest, most.count(), std::move(phrase));
    form.ceiling = most.meaning;
    return form;
}

Form mapping(Section section, std::string phrase) {
    return {.shape = Shape::mapping,
            .section = std::make_shared<const Section>(std::move(section)),
            .phrase = std::move(phrase)};
}

std::vector<Form> quantity(Range range) {
    Form list = list_of({number(range)}, 1, most_particles, "a list of numbers");
    Form drawn = mapping(law(range), "{uniform: [low, high]} or {normal: [mean, deviation]}");
    return {number(range), std::move(list), std::move(drawn)};
}

Key required(Key key) {
    key.required = true;
    return key;
}

Key otherwise(std::string preset, Key key) {
    key.preset = std::move(preset);
    return key;
}

Key left_to(std::string note, Key key) {
    key.preset_note = std::move(note);
    return key;
}

Key only_with(std::vector<std::string> kinds, Key key) {
    key.with = std::move(kinds);
    return key;
}

Section complete(Section section) {
    for (const Key& key : section.keys) {
        Node node;
        node.source = &preset_source();
        if (!key.preset.empty()) {
            node.kind = Node::Kind::scalar;
            node.text = key.preset;
        }
        section.presets.push_back(std::move(node));
    }
    return section;
}

std::size_t Section::index(std::string_view key) const {
    const auto found = std::find_if(keys.begin(), keys.end(),
                                    [&](const Key& candidate) { return candidate.name == key; });
    return static_cast<std::size_t>(found - keys.begin());
}

const Section* section_in(const std::vector<Form>& forms) {
    for (const Form& form : forms) {
        if (form.section) return form.section.get();
        if (const Section* inner = section_in(form.items)) return inner;
    }
    return nullptr;
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

std::string phrase(const Form& form) {
    if (!form.phrase.empty()) return form.phrase;
    switch (form.shape) {
        case Shape::number:
            return range_phrase("number", form.range);
        case Shape::integer:
            return range_phrase("whole number", form.range);
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

std::string number_text(double value) {
    std::string text = fmt::format("{}", value);
    if (value >= 1e9 && text.ends_with("000000000")) text = fmt::format("{:g}", value);
    std::erase(text, '+');
    return text;
}

std::string color_hex(std::string_view name) {
    for (const auto& [word, hex] : color_names)
        if (word == name) return std::string{hex};
    const bool hex =
        name.size() == 7 && name[0] == '#' && std::all_of(name.begin() + 1, name.end(), is_hex);
    return hex ? std::string{name} : std::string{};
}

}  // namespace carom
