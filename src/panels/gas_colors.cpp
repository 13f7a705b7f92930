#include "panels/gas_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "stats/histogram.h"
#include "stats/speed_classes.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr std::size_t pool_size = 200'000;

bool by_kind(ColorBy color_by) {
    return color_by == ColorBy::species || color_by == ColorBy::speed_class;
}

// On a dark ground the slow end is dark, on a light one light: fast disks stand out. Cut where it
// would fade into the ground.
ColorMap scale_colors(const Scene& scene, bool dark) {
    const std::string name = scene.film.palette.value_or("viridis");
    if (name == "netlogo") return netlogo_map(dark);
    return dark ? color_map(name, 0.33, 1.0) : color_map(name, 0.58, 0.0);
}

std::string scale_title(ColorBy color_by) {
    switch (color_by) {
        case ColorBy::energy:
            return "energy";
        case ColorBy::mass:
            return "mass";
        default:
            return "speed";
    }
}

}  // namespace

std::vector<Color> speed_class_colors(const Scene& scene, bool dark_ground) {
    const ColorMap map = scale_colors(scene, dark_ground);
    return {map.at(0.0), map.at(0.5), map.at(1.0)};
}

double GasColors::value(Eigen::Index i, double speed) const {
    switch (cast_.scene.film.color_by) {
        case ColorBy::energy:
            return speed > 0.0 ? 0.5 * speed * speed / cast_.particles.inverse_mass[i] : 0.0;
        case ColorBy::mass:
            return 1.0 / cast_.particles.inverse_mass[i];
        default:
            return speed;
    }
}

void GasColors::survey(const Observation& observation) {
    const Eigen::Index n = cast_.particles.count();
    const auto stride = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(static_cast<double>(n) * cast_.frames / pool_size));
    for (Eigen::Index i = surveyed_ % stride; i < n; i += stride) {
        const double its = value(i, observation.speed[i]);
        if (std::isfinite(its)) pool_.push_back(its);
    }
    ++surveyed_;
}

void GasColors::settle() {
    // A quarter above the 95th percentile: the 99th of a Maxwell-Boltzmann gas, but deaf to a start
    // far from it.
    const double top = pool_.empty() ? 0.0 : 1.25 * quantile(pool_, 0.95);
    scale_top_ = top > 0.0 ? round_up_for_axis(top) : 1.0;
    pool_ = {};
}

std::uint8_t GasColors::shade(Eigen::Index i, double speed, double mean_speed) const {
    switch (cast_.scene.film.color_by) {
        case ColorBy::species:
            return static_cast<std::uint8_t>(cast_.particles.species[i]);
        case ColorBy::speed_class:
            return static_cast<std::uint8_t>(speed_class(speed, mean_speed));
        default: {
            const double share = value(i, speed) / scale_top_;
            return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
        }
    }
}

std::vector<Color> GasColors::of_shades(const Theme& theme) const {
    std::vector<Color> colors;
    if (cast_.scene.film.color_by == ColorBy::species) {
        for (std::size_t k = 0; k < cast_.scene.gas.species.size(); ++k)
            colors.push_back(species_color(cast_, k, theme));
        return colors;
    }
    const ColorMap map = scale_colors(cast_.scene, theme.dark);
    if (cast_.scene.film.color_by == ColorBy::speed_class)
        return speed_class_colors(cast_.scene, theme.dark);
    for (int i = 0; i < 256; ++i) colors.push_back(map.at(i / 255.0));
    return colors;
}

void GasColors::draw_key(Canvas& canvas, const Page& page) const {
    if (by_kind(cast_.scene.film.color_by))
        draw_legend(canvas, page);
    else
        draw_scale(canvas, page);
}

void GasColors::draw_scale(Canvas& canvas, const Page& page) const {
    const double u = page.unit;
    const double height = std::max(6.0 * u, page.area.height - 1.8 * u);
    const double middle = page.area.y + page.area.height / 2;
    const Rect bar{page.area.x, std::max(page.area.y + 1.8 * u, middle - height / 2), 0.8 * u,
                   height};
    const ColorMap map = scale_colors(cast_.scene, page.theme.dark);
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) {
        const double top = bar.bottom() - bar.height * (i + 1) / steps;
        canvas.fill({bar.x, std::floor(top), bar.width, std::ceil(bar.height / steps) + 1.0},
                    map.at(i / (steps - 1.0)));
    }
    draw_text(canvas, {page.area.x, bar.y - 0.9 * u}, scale_title(cast_.scene.film.color_by),
              label_style(page));
    const Scale scale{0.0, scale_top_, bar.bottom(), bar.y};
    for (const TickMark& tick : ticks(0.0, scale_top_, 3))
        draw_text(canvas,
                  {bar.right() + 0.4 * u,
                   std::clamp(scale(tick.value) + 0.36 * u, bar.y + 0.72 * u, bar.bottom())},
                  tick.label, label_style(page));
}

void GasColors::draw_legend(Canvas& canvas, const Page& page) const {
    const double u = page.unit;
    std::vector<std::string> names{"slow", "medium", "fast"};
    if (cast_.scene.film.color_by == ColorBy::species) {
        names.clear();
        for (const Species& species : cast_.scene.gas.species) names.push_back(species.name);
    }
    const std::vector<Color> colors = of_shades(page.theme);
    const auto rows = static_cast<std::size_t>(std::max(2.0, page.area.height / (1.8 * u)));
    if (names.size() > rows) {
        const std::size_t more = names.size() - (rows - 1);
        names.resize(rows - 1);
        draw_text(canvas, {page.area.x, page.area.y + (0.9 + 1.8 * double(rows - 1)) * u},
                  fmt::format("and {} more", more), label_style(page));
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        const double y = page.area.y + (0.9 + 1.8 * static_cast<double>(k)) * u;
        canvas.fill_circle({page.area.x + 0.5 * u, y - 0.35 * u}, 0.45 * u, colors[k]);
        TextStyle style = label_style(page);
        style.max_width = page.area.width - 1.4 * u;
        draw_text(canvas, {page.area.x + 1.4 * u, y}, escape_markup(names[k]), style);
    }
    if (cast_.scene.film.color_by != ColorBy::speed_class) return;
    const std::array bounds{"below ½,", "above 1½", "of the", "mean"};
    for (std::size_t k = 0; k < bounds.size(); ++k)
        draw_text(canvas, {page.area.x, page.area.y + (7.2 + 1.5 * double(k)) * u}, bounds[k],
                  label_style(page));
}

}  // namespace carom
