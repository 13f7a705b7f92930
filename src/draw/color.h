// Colours in sRGB, and measures of how they are perceived.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace carom {

/// sRGB, each channel in [0, 1]; alpha 1 is opaque.
struct Color {
    double red = 0, green = 0, blue = 0, alpha = 1;
};

/// A colour from 0xRRGGBB.
constexpr Color rgb(std::uint32_t hex) {
    return {static_cast<double>((hex >> 16) & 0xFF) / 255.0,
            static_cast<double>((hex >> 8) & 0xFF) / 255.0, static_cast<double>(hex & 0xFF) / 255.0,
            1.0};
}

constexpr Color with_alpha(Color color, double alpha) {
    color.alpha = alpha;
    return color;
}

/// Parses #rrggbb; none if `text` has another form.
std::optional<Color> parse_color(std::string_view text);

/// Mixes in sRGB: 0 gives `a`, 1 gives `b`.
Color mix(Color a, Color b, double share);

/// 0xAARRGGBB, opaque colours only (alpha is taken as 1), channels rounded to nearest.
std::uint32_t to_pixel(Color color);

/// #rrggbb, without the alpha.
std::string hex_of(Color color);

/// Relative luminance of WCAG 2.2, dimensionless in [0, 1].
double relative_luminance(Color color);

/// A colour in Oklab (Ottosson 2020, "A perceptual color space for image processing"): lightness in
/// [0, 1], `a` from green to red, `b` from blue to yellow.
struct Oklab {
    double lightness = 0, a = 0, b = 0;
};
Oklab oklab(Color color);

/// The nearest sRGB colour, channel by channel.
Color from_oklab(const Oklab& color);

/// The perceptual difference of two colours, their distance in Oklab: about 0.02 is just noticeable
/// side by side.
double difference(const Oklab& one, const Oklab& other);
double difference(Color one, Color other);

/// Contrast ratio of WCAG 2.2, dimensionless in [1, 21].
double contrast(Color a, Color b);

/// The contrast ratio of two colours with these relative luminances.
double contrast_of_luminances(double a, double b);

}  // namespace carom
