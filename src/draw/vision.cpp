#include "draw/vision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carom::vision {
namespace {

Triple times(const Matrix& m, const Triple& v) {
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

// Linear light of an sRGB code value, IEC 61966-2-1.
double light_of(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

}  // namespace

Triple seen_by(const Vision& vision, Color color) {
    Triple light =
        times(vision.matrix, {light_of(color.red), light_of(color.green), light_of(color.blue)});
    for (double& channel : light) channel = std::clamp(channel, 0.0, 1.0);
    return light;
}

Triple lab_of(const Triple& light) {
    constexpr Matrix to_xyz = {{{0.4124564, 0.3575761, 0.1804375},
                                {0.2126729, 0.7151522, 0.0721750},
                                {0.0193339, 0.1191920, 0.9503041}}};
    const Triple xyz = times(to_xyz, light), white = times(to_xyz, {1, 1, 1});
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f(xyz[0] / white[0]), y = f(xyz[1] / white[1]), z = f(xyz[2] / white[2]);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double ciede2000(const Triple& one, const Triple& two) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    const auto power7 = [](double x) { return std::pow(x, 7); };
    const double chroma = (std::hypot(one[1], one[2]) + std::hypot(two[1], two[2])) / 2;
    const double g = 0.5 * (1 - std::sqrt(power7(chroma) / (power7(chroma) + power7(25))));
    const double a1 = (1 + g) * one[1], a2 = (1 + g) * two[1];
    const double c1 = std::hypot(a1, one[2]), c2 = std::hypot(a2, two[2]);
    const auto hue = [&](double b, double a) {
        if (a == 0.0 && b == 0.0) return 0.0;
        const double angle = std::atan2(b, a) * degrees;
        return angle < 0.0 ? angle + 360.0 : angle;
    };
    const double h1 = hue(one[2], a1), h2 = hue(two[2], a2);
    double turn = 0.0, middle = h1 + h2;
    if (c1 * c2 != 0.0) {
        turn = h2 - h1;
        if (turn > 180.0) turn -= 360.0;
        if (turn < -180.0) turn += 360.0;
        if (std::abs(h1 - h2) > 180.0) middle += h1 + h2 < 360.0 ? 360.0 : -360.0;
        middle /= 2;
    }
    const double dl = two[0] - one[0], dc = c2 - c1;
    const double dh = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2 / degrees);
    const double l = (one[0] + two[0]) / 2, c = (c1 + c2) / 2;
    const auto cosine = [&](double angle) { return std::cos(angle / degrees); };
    const double t = 1 - 0.17 * cosine(middle - 30) + 0.24 * cosine(2 * middle) +
                     0.32 * cosine(3 * middle + 6) - 0.20 * cosine(4 * middle - 63);
    const double theta = 30 * std::exp(-std::pow((middle - 275) / 25, 2));
    const double sl = 1 + 0.015 * std::pow(l - 50, 2) / std::sqrt(20 + std::pow(l - 50, 2));
    const double sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
    const double rt =
        -2 * std::sqrt(power7(c) / (power7(c) + power7(25))) * std::sin(2 * theta / degrees);
    const double x = dl / sl, y = dc / sc, z = dh / sh;
    return std::sqrt(x * x + y * y + z * z + rt * y * z);
}

double distance(const Vision& vision, Color a, Color b) {
    return ciede2000(lab_of(seen_by(vision, a)), lab_of(seen_by(vision, b)));
}

double lightness(Color color) { return lab_of(seen_by(visions[0], color))[0]; }

}  // namespace carom::vision
