#include "scene/keys/colors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <utility>

#include "scene/keys/css_colors.h"
#include "scene/keys/keys.h"
#include "util/text.h"

namespace carom {
namespace {

bool is_hex_digit(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

std::string hex_text(std::uint32_t color) { return fmt::format("#{:06x}", color); }

// Returns the words of a text in lower case: "light" and "blue" for "Light-Blue".
std::vector<std::string> small_words(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : lower(text)) {
        if (c >= 'a' && c <= 'z')
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

// Returns a hint for a text after "#". "#fb0" is short for "#ffbb00" in CSS; other such texts have
// the wrong number of digits, or other characters.
std::string digits_hint(std::string_view digits) {
    if (digits.size() == 3 && std::ranges::all_of(digits, is_hex_digit))
        return fmt::format("write it with six digits: \"#{0}{0}{1}{1}{2}{2}\"", digits[0],
                           digits[1], digits[2]);
    return "write six digits after `#`, 0 to 9 or a to f, for instance \"#ffa500\"";
}

// Returns names that begin with the same letters, most similar first.
std::vector<std::string> names_that_begin_so(std::string_view word) {
    std::vector<std::pair<int, std::string>> ranked;
    for (const std::string& name : color_names()) {
        const auto end = std::ranges::mismatch(word, name).in1;
        const int common = static_cast<int>(end - word.begin());
        const int longer = static_cast<int>(name.size()) - static_cast<int>(word.size());
        if (common > 0) ranked.emplace_back(std::abs(longer) - 2 * common, name);
    }
    std::ranges::sort(ranked);
    std::vector<std::string> names;
    for (const auto& [rank, name] : ranked) names.push_back(name);
    return names;
}

// Returns names contained in the text, the longest first; then names that share a word with it.
std::vector<std::string> names_in_common(const std::vector<std::string>& words) {
    constexpr std::size_t shortest = 3;
    std::vector<std::string> inside, around;
    for (const std::string& name : color_names()) {
        const auto has_name = [&](const std::string& word) { return word.find(name) != word.npos; };
        const auto is_in_name = [&](const std::string& word) {
            return word.size() >= shortest && name.find(word) != name.npos;
        };
        if (std::ranges::any_of(words, has_name))
            inside.push_back(name);
        else if (std::ranges::any_of(words, is_in_name))
            around.push_back(name);
    }
    std::ranges::stable_sort(inside, std::ranges::greater{}, &std::string::size);
    inside.insert(inside.end(), around.begin(), around.end());
    return inside;
}

struct Channels {
    int red, green, blue;
    int least() const { return std::min({red, green, blue}); }
    int most() const { return std::max({red, green, blue}); }
};

Channels channels(std::uint32_t color) {
    const auto byte = [&](int shift) { return static_cast<int>((color >> shift) & 0xFFU); };
    return {byte(16), byte(8), byte(0)};
}

// Returns the hue of a colour that is not grey, in degrees: 0 is red, 120 green, 240 blue.
double hue(const Channels& of) {
    const double range = of.most() - of.least();
    if (of.most() == of.red) {
        const double angle = 60.0 * (of.green - of.blue) / range;
        return angle < 0.0 ? angle + 360.0 : angle;
    }
    return of.most() == of.green ? 120.0 + 60.0 * (of.blue - of.red) / range
                                 : 240.0 + 60.0 * (of.red - of.green) / range;
}

// Returns a measure of the perceived lightness of a colour, with the weights of ITU-R BT.709.
double lightness(std::uint32_t color) {
    const Channels of = channels(color);
    return 0.2126 * of.red + 0.7152 * of.green + 0.0722 * of.blue;
}

struct HueGroup {
    std::string_view name;
    double end;  // in degrees
};

constexpr std::array hue_groups{
    HueGroup{"reds and pinks", 14.0}, HueGroup{"oranges and browns", 45.0},
    HueGroup{"yellows", 70.0},        HueGroup{"greens", 160.0},
    HueGroup{"cyans", 190.0},         HueGroup{"blues", 255.0},
    HueGroup{"purples", 305.0}};
constexpr std::string_view pale_group = "almost white", grey_group = "black to white";

std::string_view group_of(std::uint32_t color) {
    const Channels of = channels(color);
    if (of.least() == of.most()) return grey_group;
    constexpr int pale = 0xCD;
    if (of.least() >= pale) return pale_group;
    const double angle = hue(of);
    const auto found =
        std::ranges::find_if(hue_groups, [&](const HueGroup& group) { return angle < group.end; });
    return found == hue_groups.end() ? hue_groups.front().name : found->name;
}

}  // namespace

std::vector<std::string> color_names() {
    std::vector<std::string> names;
    for (const auto& [name, hex] : css_colors) names.emplace_back(name);
    return names;
}

std::string color_hex(std::string_view name) {
    for (const auto& [word, hex] : css_colors)
        if (word == name) return hex_text(hex);
    const bool hex = name.size() == 7 && name[0] == '#' &&
                     std::all_of(name.begin() + 1, name.end(), is_hex_digit);
    return hex ? std::string{name} : std::string{};
}

// rgb(255, 0, 0), or 255,0,0
std::string channels_hint(const std::string& text) {
    std::vector<int> numbers;
    for (std::size_t at = 0; (at = text.find_first_of("0123456789", at)) != text.npos;) {
        const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
        if (end - at > 3 || numbers.size() == 3) return "";
        numbers.push_back(std::stoi(text.substr(at, end - at)));
        at = end;
    }
    const bool is_color = numbers.size() == 3 &&
                          text.find_first_not_of("rgbRGB(), 0123456789") == text.npos &&
                          std::ranges::all_of(numbers, [](int channel) { return channel <= 255; });
    return is_color
               ? fmt::format("write `\"#{:02x}{:02x}{:02x}\"`", numbers[0], numbers[1], numbers[2])
               : "";
}

std::string color_hint(const std::string& text) {
    if (const std::string hint = channels_hint(text); !hint.empty()) return hint;
    if (text.starts_with('#')) return digits_hint(std::string_view{text}.substr(1));
    if (const std::string hex = "#" + text; !color_hex(hex).empty())
        return fmt::format("write `#` before the digits, in quotes: \"{}\"", hex);
    constexpr std::size_t longest_compared = 64;  // what is longer is no misspelt name
    const std::vector<std::string> words = small_words(text.substr(0, longest_compared));
    const std::vector<std::string> names = color_names();
    const std::string small = fmt::format("{}", fmt::join(words, ""));
    if (const auto near = nearest_spelling(small, names))
        return fmt::format("did you mean `{}`?", *near);
    std::vector<std::string> alike = names_in_common(words);
    if (alike.empty()) alike = names_that_begin_so(small);
    if (alike.empty()) alike = {"red", "darkblue", "orange", "teal"};
    alike.resize(std::min<std::size_t>(alike.size(), 4));
    return fmt::format("names are {} and others; docs/scene-reference.md lists all",
                       fmt::format("`{}`", fmt::join(alike, "`, `")));
}

std::vector<ColorGroup> color_groups() {
    std::vector<ColorGroup> groups;
    for (const HueGroup& group : hue_groups) groups.push_back({std::string(group.name), {}});
    groups.push_back({std::string(pale_group), {}});
    groups.push_back({std::string(grey_group), {}});
    std::map<std::pair<double, std::uint32_t>, std::vector<std::string>> from_dark;
    for (const auto& [name, hex] : css_colors) from_dark[{lightness(hex), hex}].emplace_back(name);
    for (const auto& [place, names] : from_dark)
        std::ranges::find(groups, group_of(place.second), &ColorGroup::name)
            ->colors.push_back({hex_text(place.second), names});
    return groups;
}

}  // namespace carom
