#include "panels/gas/gas_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "panels/chosen.h"
#include "panels/plot/layers.h"
#include "stats/histogram.h"
#include "stats/speed_classes.h"
#include "stats/thinning.h"
#include "util/archive.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr std::uint8_t last_shade = 255;

bool by_kind(ColorBy color_by) {
    return color_by == ColorBy::species || color_by == ColorBy::speed_class;
}

ColorMap scale_colors(const Scene& scene, const Theme& theme) {
    if (!scene.film.palette && theme.kind == ThemeKind::print) return grey_map();
    const std::string name = scene.film.palette.value_or("viridis");
    return name == "netlogo" ? netlogo_map(theme.dark) : color_map_on(name, theme);
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

std::vector<std::string> palette_names() {
    const std::span<const std::string> maps = color_map_names();
    std::vector<std::string> names(maps.begin(), maps.end());
    names.emplace_back("netlogo");
    return names;
}

std::vector<Color> speed_class_colors(const Scene& scene, const Theme& theme) {
    const ColorMap map = scale_colors(scene, theme);
    return {map.at(0.0), map.at(0.5), map.at(1.0)};
}

void draw_hatching(Canvas& canvas, const DrawContext& dc, Point center, double radius) {
    const double apart = 0.42 * dc.unit, inside = radius - 0.1 * dc.unit;
    if (inside < apart) return;
    const double most = std::floor(inside / apart - 0.5) + 0.5;
    for (double line = -most; line <= most; line += 1.0) {
        const double off = line * apart, half = std::sqrt(inside * inside - off * off);
        // Rising to the right; `off` is the distance of the line from the centre.
        const double x = center.x + off * std::numbers::sqrt2 / 2,
                     y = center.y + off * std::numbers::sqrt2 / 2;
        const double reach = half * std::numbers::sqrt2 / 2;
        canvas.stroke_line({x - reach, y + reach}, {x + reach, y - reach}, 0.12 * dc.unit,
                           dc.theme.ground);
    }
}

// Every disk of every frame asks whether there are infinite masses: they are looked for once.
GasColors::GasColors(const PanelContext& context)
    : context_(context),
      tells_infinite_(context.scene.film.color_by == ColorBy::mass &&
                      (context.particles.inverse_mass == 0.0).any()) {}

double GasColors::value(Eigen::Index i, double speed) const {
    switch (context_.scene.film.color_by) {
        case ColorBy::energy:
            return speed > 0.0 ? 0.5 * speed * speed / context_.particles.inverse_mass[i] : 0.0;
        case ColorBy::mass:
            return 1.0 / context_.particles.inverse_mass[i];
        default:
            return speed;
    }
}

void GasColors::survey(const FrameInput& input) {
    const Eigen::Index n = context_.particles.count();
    for_each_kept(n, static_cast<double>(n), surveyed_++, context_.frames, [&](Eigen::Index i) {
        const double its = value(i, input.speed[i]);
        if (std::isfinite(its)) pool_.push_back(its);
    });
}

void GasColors::fix_scale() {
    // A quarter above the 95th percentile: the 99th of a Maxwell-Boltzmann gas, but deaf to a start
    // far from it.
    const double top = pool_.empty() ? 0.0 : 1.25 * quantile(pool_, 0.95);
    scale_top_ = top > 0.0 ? round_up_for_axis(top) : 1.0;
    pool_ = {};
    shades_ = make_shades(theme_of(context_.scene.film.theme));
}

void GasColors::archive(Archive& archive) {
    archive(scale_top_);
    shades_ = make_shades(theme_of(context_.scene.film.theme));
}

std::uint8_t GasColors::shade(Eigen::Index i, double speed, double mean_speed) const {
    switch (context_.scene.film.color_by) {
        case ColorBy::species:
            return static_cast<std::uint8_t>(context_.particles.species[i]);
        case ColorBy::speed_class:
            return static_cast<std::uint8_t>(speed_class(speed, mean_speed));
        default: {
            const double its = value(i, speed);
            if (!std::isfinite(its)) return last_shade;
            const double share = std::clamp(its / scale_top_, 0.0, 1.0);
            return static_cast<std::uint8_t>(
                std::lround(share * (tells_infinite() ? last_shade - 1 : last_shade)));
        }
    }
}

// A scale is searched for where it begins to stand out from the ground: not in every frame.
std::vector<Color> GasColors::of_shades(const Theme& theme) const {
    const bool known = !shades_.empty() && &theme == &theme_of(context_.scene.film.theme);
    return known ? shades_ : make_shades(theme);
}

std::vector<Color> GasColors::make_shades(const Theme& theme) const {
    std::vector<Color> colors;
    if (context_.scene.film.color_by == ColorBy::species) {
        for (std::size_t k = 0; k < context_.scene.gas.species.size(); ++k)
            colors.push_back(plot::color_of(species_role(context_, k), theme));
        return colors;
    }
    if (context_.scene.film.color_by == ColorBy::speed_class)
        return speed_class_colors(context_.scene, theme);
    const ColorMap map = scale_colors(context_.scene, theme);
    const int last = tells_infinite() ? last_shade - 1 : last_shade;
    for (int i = 0; i <= last; ++i) colors.push_back(map.at(double(i) / last));
    if (tells_infinite()) colors.push_back(theme.ink);
    return colors;
}

bool GasColors::is_told_infinite(Eigen::Index particle) const {
    return tells_infinite() && context_.particles.inverse_mass[particle] == 0.0;
}

void GasColors::draw_key(Canvas& canvas, const DrawContext& dc) const {
    if (by_kind(context_.scene.film.color_by))
        draw_legend(canvas, dc);
    else
        draw_scale(canvas, dc);
}

void GasColors::draw_scale(Canvas& canvas, const DrawContext& dc) const {
    const double u = dc.unit;
    const double below = tells_infinite() ? 2.4 * u : 0.0;
    const double height = std::max(6.0 * u, dc.area.height - 1.8 * u - below);
    const double middle = dc.area.y + dc.area.height / 2;
    const Rect bar{dc.area.x, std::max(dc.area.y + 1.8 * u, middle - height / 2), 0.8 * u, height};
    const ColorMap map = scale_colors(context_.scene, dc.theme);
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) {
        const double top = bar.bottom() - bar.height * (i + 1) / steps;
        canvas.fill({bar.x, std::floor(top), bar.width, std::ceil(bar.height / steps) + 1.0},
                    map.at(i / (steps - 1.0)));
    }
    draw_text(canvas, {dc.area.x, bar.y - 0.9 * u}, scale_title(context_.scene.film.color_by),
              label_style(dc));
    const Scale scale{0.0, scale_top_, bar.bottom(), bar.y};
    for (const TickMark& tick : ticks(0.0, scale_top_, 3))
        draw_text(canvas,
                  {bar.right() + 0.4 * u,
                   std::clamp(scale(tick.value) + 0.36 * u, bar.y + 0.72 * u, bar.bottom())},
                  tick.label, label_style(dc));
    if (!tells_infinite()) return;
    const Point infinite{bar.x + 0.6 * u, bar.bottom() + 1.6 * u};
    canvas.fill_circle(infinite, 0.7 * u, dc.theme.ink);
    draw_hatching(canvas, dc, infinite, 0.7 * u);
    draw_text(canvas, {infinite.x + 1.0 * u, infinite.y + 0.36 * u}, "infinite", label_style(dc));
}

void GasColors::draw_legend(Canvas& canvas, const DrawContext& dc) const {
    const double u = dc.unit;
    std::vector<std::string> names{"slow", "medium", "fast"};
    if (context_.scene.film.color_by == ColorBy::species) {
        names.clear();
        for (const Species& species : context_.scene.gas.species) names.push_back(species.name);
    }
    const std::vector<Color> colors = of_shades(dc.theme);
    TextStyle style = label_style(dc);
    style.max_width = dc.area.width - 1.4 * u;
    double y = dc.area.y + 0.9 * u;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::vector<std::string> lines = wrapped(names[k], style, 2);
        const double end = y + 1.4 * u * static_cast<double>(lines.size() - 1);
        const double last = k + 1 == names.size() ? 0.0 : 1.8 * u;  // room for how many more
        if (k > 1 && end + last > dc.area.bottom()) {
            draw_text(canvas, {dc.area.x, y}, fmt::format("and {} more", names.size() - k),
                      label_style(dc));
            break;
        }
        const Point swatch{dc.area.x + 0.5 * u, y - 0.35 * u};
        canvas.fill_circle(swatch, 0.45 * u, edge_of(colors[k], dc.theme));
        canvas.fill_circle(swatch, 0.38 * u, colors[k]);
        for (std::size_t line = 0; line < lines.size(); ++line)
            draw_text(canvas, {dc.area.x + 1.4 * u, y + 1.4 * u * static_cast<double>(line)},
                      escape_markup(lines[line]), style);
        y = end + 1.8 * u;
    }
    if (context_.scene.film.color_by != ColorBy::speed_class) return;
    const std::array bounds{"below ½,", "above 1½", "of the", "mean"};
    for (std::size_t k = 0; k < bounds.size(); ++k)
        draw_text(canvas, {dc.area.x, dc.area.y + (7.2 + 1.5 * double(k)) * u}, bounds[k],
                  label_style(dc));
}

}  // namespace carom
