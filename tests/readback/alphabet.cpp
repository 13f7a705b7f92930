#include "readback/alphabet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/canvas.h"
#include "draw/text.h"

namespace carom::test {
namespace {

// Each is a single outline. If two look alike, the first one is read.
constexpr std::array letters{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "−", ".", "×", "%",
                             "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁻", "–", ",", ":",
                             "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n",
                             "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z", "A", "B",
                             "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N", "O", "P",
                             "Q", "R", "S", "T", "U", "V", "W", "X", "Y", "Z"};
constexpr std::array superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

// The largest deviation between two outlines, in pixels, after the second has been scaled to fit
// best.
double apart(const Outline& a, const Outline& b) {
    double ab = 0.0, bb = 0.0, most = 0.0;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        ab += a.points[i].x * b.points[i].x + a.points[i].y * b.points[i].y;
        bb += b.points[i].x * b.points[i].x + b.points[i].y * b.points[i].y;
    }
    const double scale = ab / bb;
    for (std::size_t i = 0; i < a.points.size(); ++i)
        most = std::max({most, std::abs(a.points[i].x - scale * b.points[i].x),
                         std::abs(a.points[i].y - scale * b.points[i].y)});
    return most;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

}  // namespace

Alphabet::Alphabet() {
    constexpr double em = 64.0;
    for (const int weight : {400, 500, 600})
        for (const char* letter : letters) {
            Canvas canvas({200, 200}, VectorFormat::svg, {});
            draw_text(canvas, {50, 100}, letter, {.size = em, .weight = weight});
            const std::vector<std::uint8_t> bytes = canvas.file();
            const SvgPicture drawn = svg_picture(std::string(bytes.begin(), bytes.end()));
            const Outline& outline = drawn.texts.at(0).all.at(0).outline;
            known_.emplace(outline.commands, Known{letter, outline});
        }
}

std::string Alphabet::read(const Outline& outline) const {
    if (outline.points.empty()) return " ";
    constexpr double rounding = 0.04;  // pixels: FreeType rounds to 1/64 pixel
    double least = rounding;
    std::string found = "?";
    const auto [first, last] = known_.equal_range(outline.commands);
    for (auto next = first; next != last; ++next) {
        const double distance = apart(outline, next->second.outline);
        if (distance < least) least = distance, found = next->second.letter;
    }
    return found;
}

std::string Alphabet::read(const Letters& text) const {
    std::string words;
    for (const Letter& letter : text.all) words += read(letter.outline);
    return words;
}

std::optional<double> number_in(const std::string& text) {
    std::string plain = replaced(replaced(text, "−", "-"), " ", "");
    double factor = 1.0;
    std::size_t power = plain.find("×10");
    std::size_t digits = power + std::string("×10").size();
    if (power == std::string::npos && plain.starts_with("10") && plain.size() > 2 &&
        (plain[2] & 0x80) != 0) {
        power = 0;
        digits = 2;
    }
    if (power != std::string::npos) {
        std::string exponent = replaced(plain.substr(digits), "⁻", "-");
        for (std::size_t i = 0; i < superscripts.size(); ++i)
            exponent = replaced(exponent, superscripts[i], std::to_string(i));
        plain = power == 0 ? "1" : plain.substr(0, power);
        const std::optional<double> of_ten = number_in(exponent);
        if (!of_ten) return {};
        factor = std::pow(10.0, *of_ten);
    }
    if (plain.empty() || plain.find_first_not_of("-.0123456789") != std::string::npos ||
        plain.find_first_of("0123456789") == std::string::npos)
        return {};
    return factor * std::stod(plain);
}

double rounding_of(const std::string& text) {
    const std::size_t point = text.find('.');
    if (point == std::string::npos) return 0.5;
    return 0.5 * std::pow(10.0, -static_cast<double>(text.size() - point - 1));
}

}  // namespace carom::test
