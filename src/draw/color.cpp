#include "draw/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace carom {
namespace {

std::uint32_t to_byte(double channel) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(channel, 0.0, 1.0) * 255.0));
}

// The transfer function of sRGB (IEC 61966-2-1), from code value to light.
double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

// The same from light to code value.
double encoded(double light) {
    const double inside = std::clamp(light, 0.0, 1.0);
    return inside <= 0.0031308 ? 12.92 * inside : 1.055 * std::pow(inside, 1.0 / 2.4) - 0.055;
}

}  // namespace

std::optional<Color> parse_color(std::string_view text) {
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    std::uint32_t hex = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 1, end, hex, 16);
    if (error != std::errc() || stop != end) return std::nullopt;
    return rgb(hex);
}

Color mix(Color a, Color b, double share) {
    const auto between = [share](double from, double to) { return from + (to - from) * share; };
    return {between(a.red, b.red), between(a.green, b.green), between(a.blue, b.blue),
            between(a.alpha, b.alpha)};
}

std::uint32_t to_pixel(Color color) {
    return 0xFF000000U | to_byte(color.red) << 16 | to_byte(color.green) << 8 | to_byte(color.blue);
}

double relative_luminance(Color color) {
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

Oklab oklab(Color color) {
    const double r = linear(color.red), g = linear(color.green), b = linear(color.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Color from_oklab(const Oklab& color) {
    const auto cubed = [&](double a, double b) {
        const double root = color.lightness + a * color.a + b * color.b;
        return root * root * root;
    };
    const double l = cubed(0.3963377774, 0.2158037573), m = cubed(-0.1055613458, -0.0638541728),
                 s = cubed(-0.0894841775, -1.2914855480);
    return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

double difference(const Oklab& one, const Oklab& other) {
    return std::hypot(one.lightness - other.lightness, one.a - other.a, one.b - other.b);
}

double difference(Color one, Color other) { return difference(oklab(one), oklab(other)); }

double contrast(Color a, Color b) {
    return contrast_of_luminances(relative_luminance(a), relative_luminance(b));
}

double contrast_of_luminances(double a, double b) {
    const auto [darker, lighter] = std::minmax(a, b);
    return (lighter + 0.05) / (darker + 0.05);
}

std::string hex_of(Color color) { return fmt::format("#{:06x}", to_pixel(color) & 0xFFFFFF); }

}  // namespace carom
