#include "draw/style.h"

#include <cassert>

namespace carom {
namespace {

constexpr Theme light_theme = {.page = rgb(0xFBFAF7),
                               .ground = rgb(0xFFFFFF),
                               .ink = rgb(0x1B1F24),
                               .muted = rgb(0x5B6470),
                               .accent = rgb(0xC2410C),
                               .bar = rgb(0x64748B),
                               .wall = rgb(0x7D8793),
                               .trail = rgb(0x5B6470),
                               .highlight = rgb(0x0B63A5),
                               .dark = false};

constexpr Theme dark_theme = {.page = rgb(0x101418),
                              .ground = rgb(0x161B21),
                              .ink = rgb(0xE9EDF1),
                              .muted = rgb(0x9AA5B1),
                              .accent = rgb(0xFF9F43),
                              .bar = rgb(0x8092A6),
                              .wall = rgb(0x6B7785),
                              .trail = rgb(0x9AA5B1),
                              .highlight = rgb(0x7CC7FF),
                              .dark = true};

constexpr Theme print_theme = {.page = rgb(0xFFFFFF),
                               .ground = rgb(0xFFFFFF),
                               .ink = rgb(0x000000),
                               .muted = rgb(0x4A4A4A),
                               .accent = rgb(0x000000),
                               .bar = rgb(0x757575),
                               .wall = rgb(0x4A4A4A),
                               .trail = rgb(0x6E6E6E),
                               .highlight = rgb(0x000000),
                               .dark = false};

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

}  // namespace carom
