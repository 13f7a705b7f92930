#include "figures/page_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "draw/style.h"
#include "panels/panel.h"
#include "scene/film.h"
#include "scene/style/style.h"

namespace carom {
namespace {

// Dark enough for white letters.
Color under_white(Color color) {
    constexpr Color white = rgb(0xFFFFFF), black = rgb(0x000000);
    for (double share = 0.0; share < 1.0; share += 0.05)
        if (const Color shade = mix(color, black, share);
            contrast(shade, white) >= least_contrast_of_words)
            return shade;
    return black;
}

// A name without quotation marks, as CSS takes it; empty if it needs them.
std::string plain_family(const Style& style) {
    const auto is_plain = [](char c) {
        return c == ' ' || c == '-' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
               (c >= 'a' && c <= 'z');
    };
    const std::string& family = style.fonts.text;
    const bool begins_with_letter =
        !family.empty() && (family.front() < '0' || family.front() > '9');
    return begins_with_letter && std::ranges::all_of(family, is_plain) ? family : "";
}

}  // namespace

std::string style_properties_of(const Film& film) {
    if (film.style == nullptr) return "";
    const Theme& theme = theme_of(film, film.style->base);
    const Color link =
        legible(theme.series.empty() ? theme.highlight : theme.series.front(), theme);
    std::string text = fmt::format("color-scheme: {};", theme.dark ? "dark" : "light");
    for (const auto& [name, color] : {std::pair{"page", theme.page},
                                      {"ink", theme.ink},
                                      {"quiet", theme.muted},
                                      {"line", theme.grid},
                                      {"edge", edge_of(theme.muted, theme)},
                                      {"link", link},
                                      {"band", under_white(link)},
                                      {"here", mix(theme.page, link, 0.12)}})
        text += fmt::format(" --{}: {};", name, hex_of(color));
    if (const std::string family = plain_family(*film.style); !family.empty())
        text += fmt::format(" --family: {};", family);
    return text;
}

}  // namespace carom
