// The colours that scenes can name: those of CSS, in groups; and hints for texts that name no
// colour. For a single colour see color_hex() in keys.h.
#pragma once

#include <string>
#include <vector>

namespace carom {

/// Returns a hint on what to write instead of a text that names no colour.
std::string color_hint(const std::string& text);

/// A colour and all its names: #808080 is `gray` and `grey`.
struct NamedColor {
    std::string hex;
    std::vector<std::string> names;
};

/// Colours of similar hue, from dark to light.
struct ColorGroup {
    std::string name;
    std::vector<NamedColor> colors;
};

/// Returns all named colours, each in one group.
std::vector<ColorGroup> color_groups();

}  // namespace carom
