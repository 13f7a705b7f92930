#include "draw/style.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace carom {
namespace {

constexpr Theme light_theme = {.page = rgb(0xFFFFFF),
                               .ground = rgb(0xFFFFFF),
                               .ink = rgb(0x1B1F24),
                               .second = rgb(0x3A424C),
                               .muted = rgb(0x5B6470),
                               .grid = rgb(0xD6DAE0),
                               .accent = rgb(0x7D5002),
                               .bar = rgb(0x64748B),
                               .wall = rgb(0x7D8793),
                               .trail = rgb(0x5B6470),
                               .highlight = rgb(0x4C1D95),
                               .kind = ThemeKind::light,
                               .dark = false};

constexpr Theme dark_theme = {.page = rgb(0x0E1116),
                              .ground = rgb(0x151A21),
                              .ink = rgb(0xE9EDF2),
                              .second = rgb(0xC6CED8),
                              .muted = rgb(0x97A3B0),
                              .grid = rgb(0x2A323D),
                              .accent = rgb(0xFFB454),
                              .bar = rgb(0x7486A0),
                              .wall = rgb(0x5A6776),
                              .trail = rgb(0x97A3B0),
                              .highlight = rgb(0xCDBDFF),
                              .kind = ThemeKind::dark,
                              .dark = true};

constexpr Theme print_theme = {.page = rgb(0xFFFFFF),
                               .ground = rgb(0xFFFFFF),
                               .ink = rgb(0x000000),
                               .second = rgb(0x262626),
                               .muted = rgb(0x4A4A4A),
                               .grid = rgb(0xD9D9D9),
                               .accent = rgb(0x000000),
                               .bar = rgb(0x757575),
                               .wall = rgb(0x4A4A4A),
                               .trail = rgb(0x6E6E6E),
                               .highlight = rgb(0x000000),
                               .kind = ThemeKind::print,
                               .dark = false};

// With channels of eight bits.
Color as_drawn(Color color) {
    const double alpha = color.alpha;
    color = rgb(to_pixel(color) & 0xFFFFFF);
    color.alpha = alpha;
    return color;
}

}  // namespace

const Theme& theme(ThemeKind kind) {
    switch (kind) {
        case ThemeKind::light:
            return light_theme;
        case ThemeKind::dark:
            return dark_theme;
        case ThemeKind::print:
            return print_theme;
    }
    assert(false);
    return dark_theme;
}

Color toward_ink(Color color, const Theme& theme, std::span<const Color> behind, double least) {
    // Luminances of the background are computed only once, as they take most of the time.
    std::vector<double> luminances_behind;
    for (const Color other : behind) luminances_behind.push_back(relative_luminance(other));
    const auto stands_out = [&](Color shade) {
        const double luminance = relative_luminance(shade);
        return std::ranges::all_of(luminances_behind, [&](double other) {
            return contrast_of_luminances(luminance, other) >= least;
        });
    };
    constexpr int steps = 20;
    for (int i = 0; i < steps; ++i)
        if (const Color shade = as_drawn(mix(color, theme.ink, double(i) / steps));
            stands_out(shade))
            return shade;
    return theme.ink;
}

Color edge_of(Color color, const Theme& theme) {
    return toward_ink(color, theme, std::array{theme.page, theme.ground}, least_contrast_of_marks);
}

Color legible(Color color, const Theme& theme) {
    return toward_ink(color, theme, std::array{theme.page, theme.ground}, least_contrast_of_words);
}

// Of black and white, one always has a contrast of at least √21, i.e. 4.58.
Color letters_on(Color fill, const Theme& theme) {
    const auto better = [&](Color a, Color b) {
        return contrast(fill, a) > contrast(fill, b) ? a : b;
    };
    const Color own = better(theme.page, theme.ink);
    if (contrast(fill, own) >= least_contrast_of_words) return own;
    return better(rgb(0x000000), rgb(0xFFFFFF));
}

}  // namespace carom
