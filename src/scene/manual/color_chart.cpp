#include "scene/manual/color_chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/keys/colors.h"
#include "util/text.h"

namespace carom {
namespace {

// Lengths in the picture, in its own units.
constexpr int columns = 3, column_width = 240, margin = 12, line = 20, head = 34;
constexpr int swatch_width = 36, swatch_height = 15;

int height_of(const ColorGroup& group) {
    return head + line * static_cast<int>(group.colors.size());
}

// Returns the smallest height at which the groups fit into the columns, unbroken and in order.
int height_of(const std::vector<ColorGroup>& groups) {
    const auto columns_at = [&](int most) {
        int used = 1, height = 0;
        for (const ColorGroup& group : groups) {
            if (height > 0 && height + height_of(group) > most) {
                ++used;
                height = 0;
            }
            height += height_of(group);
        }
        return used;
    };
    int height = 0;
    for (const ColorGroup& group : groups) height = std::max(height, height_of(group));
    while (columns_at(height) > columns) height += line;
    return height;
}

std::string drawn(const ColorGroup& group, int x, int y) {
    std::string text = fmt::format("<text x=\"{}\" y=\"{}\" font-weight=\"bold\">{}</text>\n", x,
                                   y + head - 12, capitalised(group.name));
    y += head;
    for (const NamedColor& color : group.colors) {
        text += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
            "stroke=\"#999999\" stroke-width=\"0.5\"/><text x=\"{}\" y=\"{}\">{}</text>\n",
            x, y - swatch_height + 12, swatch_width, swatch_height, color.hex, x + swatch_width + 8,
            y + 9, fmt::join(color.names, ", "));
        y += line;
    }
    return text;
}

std::string row(const ColorGroup& group) {
    std::string names;
    for (const NamedColor& color : group.colors)
        for (const std::string& name : color.names)
            names += (names.empty() ? "`" : ", `") + name + "`";
    return fmt::format("| {} | {} |\n", group.name, names);
}

}  // namespace

std::string color_chart() {
    const std::vector<ColorGroup> groups = color_groups();
    const int height = height_of(groups), width = columns * column_width;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Inter, sans-serif\" font-size=\"13\" "
        "fill=\"#222222\">\n<title>The colours that a scene can name</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        width, height + 2 * margin);
    int x = margin, y = margin;
    for (const ColorGroup& group : groups) {
        if (y > margin && y + height_of(group) > margin + height) {
            x += column_width;
            y = margin;
        }
        text += drawn(group, x, y);
        y += height_of(group);
    }
    return text + "</svg>\n";
}

std::string color_section() {
    std::string text =
        "## Colours\n\nA colour is a name of CSS in small letters, or `\"#rrggbb\"` in quotes: "
        "red, green and blue, each as two hexadecimal digits. The names, from dark to light; two "
        "spellings of grey, `aqua` and `cyan`, and `fuchsia` and `magenta` are the same "
        "colours:\n\n![Every named colour beside its name](colors.svg)\n\n"
        "| group | names |\n| --- | --- |\n";
    for (const ColorGroup& group : color_groups()) text += row(group);
    return text + "\n";
}

}  // namespace carom
