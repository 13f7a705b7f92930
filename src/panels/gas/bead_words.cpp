#include "panels/gas/bead_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom {
namespace {

constexpr double half_cap_height = 0.36;  // ems
constexpr double rim = 0.95;              // of the radius, that letters may reach

}  // namespace

std::string mass_text(Language language, double inverse_mass) {
    if (!(inverse_mass > 0.0)) return "∞";
    const double mass = 1.0 / inverse_mass, whole = std::round(mass);
    if (mass < 1e6 && std::abs(mass - whole) < 1e-6 * mass) return fmt::format("{:.0f}", whole);
    return mass < 1000.0 ? localised(language, fmt::format("{:.3g}", mass))
                         : three_digits(language, mass);
}

std::string shorter_number(const std::string& words) {
    const std::size_t point = words.find_first_of(".,");
    const bool plain = words.find_first_not_of("0123456789.,") == std::string::npos;
    if (!plain || point == std::string::npos || point + 2 >= words.size()) return words;
    std::string number = words;
    number[point] = '.';
    number = fmt::format("{:.{}f}", std::stod(number), words.size() - point - 2);
    if (point < number.size()) number[point] = words[point];
    return number;
}

std::string words_on(const PanelContext& context, Eigen::Index particle, Labels labels) {
    if (labels == Labels::mass)
        return mass_text(context.language(), context.particles.inverse_mass[particle]);
    return labels == Labels::index ? std::to_string(particle) : "";
}

std::optional<FittingWords> fitting_words(const DrawContext& dc, double radius,
                                          const std::string& words) {
    if (radius < half_cap_height * dc.unit) return {};
    TextStyle style = label_style(dc);
    style.align = Align::center;
    style.weight = 600;
    const double large = std::clamp(0.65 * radius, dc.unit, 2.0 * dc.unit);
    const std::string shorter = shorter_number(words);
    for (const std::string& text : {words, shorter, shorter_number(shorter)})
        for (const double size : {large, dc.unit}) {
            style.size = size;
            const double half_width = 0.5 * measure_text(text, style).width;
            if (std::hypot(half_width, half_cap_height * size) <= rim * radius)
                return FittingWords{text, style};
        }
    return {};
}

void draw_words_on(Canvas& canvas, const DrawContext& dc, Point center, double radius,
                   const std::string& words, Color bead) {
    if (words.empty()) return;
    auto fitting = fitting_words(dc, radius, words);
    if (!fitting) return;
    fitting->style.color = letters_on(bead, dc.theme);
    const double down = half_cap_height * fitting->style.size;
    draw_text(canvas, {center.x, center.y + down}, fitting->text, fitting->style);
}

}  // namespace carom
