#include "scene/manual/key_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/keys/key_text.h"
#include "scene/manual/sections.h"
#include "util/text.h"

namespace carom {
namespace {

std::string cell(std::string text) {
    for (std::size_t i = text.find('|'); i != std::string::npos; i = text.find('|', i + 2))
        text.insert(i, "\\");
    return text;
}

std::string meaning_in_words(const Key& key) {
    constexpr std::size_t few = 4;
    std::string meaning = key.meaning;
    if (key.kinds.size() > 1 && key.kinds.size() <= few)
        meaning += " Applies to " + listed(key.kinds, "and", "`") + ".";
    if (!key.formerly.empty()) meaning += " Formerly `" + key.formerly + "`, which is still read.";
    return meaning;
}

std::string values_in_words(const Key& key) {
    constexpr std::size_t many = 30;
    const Form& first = key.forms.front();
    if (first.shape == Shape::word && first.words.size() > many)
        return "the name of one of the [panels](#panels)";
    const bool has_color =
        std::ranges::find(key.forms, Shape::color, &Form::shape) != key.forms.end();
    return forms_text(key) + (has_color ? ", see [Colours](#colours)" : "");
}

}  // namespace

std::string key_row(const Section& section, const Key& key) {
    return fmt::format("| `{}` | {} | {} | {} |\n", key.name, cell(meaning_in_words(key)),
                       cell(values_in_words(key)), cell(default_of(section, key)));
}

bool are_told_alike(const Section& section, const Key& key, const Section& other,
                    const Key& its_key) {
    return key.name == its_key.name && key.meaning == its_key.meaning &&
           values_in_words(key) == values_in_words(its_key) &&
           default_of(section, key) == default_of(other, its_key);
}

std::string key_table(const std::string& rows) {
    return "| key | meaning | values | default |\n| --- | --- | --- | --- |\n" + rows + "\n";
}

}  // namespace carom
