#include "panels/gas/gas_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "panels/chosen.h"
#include "panels/means/thinning.h"
#include "panels/plot/layers.h"
#include "physics/gas.h"
#include "physics/membership.h"
#include "scene/film.h"
#include "stats/speed_classes.h"
#include "util/archive.h"
#include "util/text.h"

namespace carom {
namespace {

// Shades: those of the scale or of the classes of speed, then these, then the species.
constexpr std::uint16_t scale_shades = 256;
constexpr std::uint16_t infinite_shade = scale_shades, resting_shade = scale_shades + 1,
                        first_species = scale_shades + 2;

std::pair<Phrase, const char*> scale_title(ColorBy color_by) {
    switch (color_by) {
        case ColorBy::energy:
            return {Phrase{"energy"}, "<i>E</i>"};
        case ColorBy::mass:
            return {Phrase{"mass"}, "<i>m</i>"};
        default:
            return {Phrase{"speed"}, "<i>v</i>"};
    }
}

std::string scale_name(const Film& film) {
    return film.color_by == ColorBy::direction ? "direction" : film.palette.value_or("viridis");
}

}  // namespace

ColorMap scale_colors(const Film& film, const Theme& theme) {
    const std::string name = scale_name(film);
    if (name == "direction") return direction_map(theme);
    if (!film.palette && !theme.ramp.empty()) return ramp_map(theme);
    if (!film.palette && theme.kind == ThemeKind::print) return grey_map();
    return name == "netlogo" ? netlogo_map(theme.dark) : color_map_on(name, theme);
}

namespace {

std::vector<Color> speed_class_colors(const Theme& theme) {
    return {speed_class_color(0, theme), speed_class_color(1, theme), speed_class_color(2, theme)};
}

// Of infinite masses. NetLogo's green and red have all hues between them: there is no such colour.
Color color_beside_scale(const Film& film, const Theme& theme) {
    const std::string name = scale_name(film);
    const bool has_one = film.palette || (theme.kind != ThemeKind::print && theme.ramp.empty());
    return has_one && name != "netlogo" && name != "direction" ? color_beside(name, theme)
                                                               : theme.ink;
}

}  // namespace

std::vector<std::string> palette_names() {
    const std::span<const std::string> maps = color_map_names();
    std::vector<std::string> names(maps.begin(), maps.end());
    names.emplace_back("netlogo");
    return names;
}

Color kind_in(const Film& film, std::size_t index, const Theme& theme) {
    const ColorBy by = film.color_by;
    if (by == ColorBy::species || theme.kind == ThemeKind::print) return kind_color(index, theme);
    if (!theme.series.empty()) return kind_color(index, theme);
    // A set for each map and theme, made once: searching it takes a while.
    using Key = std::pair<std::string, const Theme*>;
    static std::mutex mutex;
    static std::map<Key, std::vector<Color>> sets;
    const std::scoped_lock lock(mutex);
    const std::string scale = by == ColorBy::speed_class ? "classes" : scale_name(film);
    std::vector<Color>& set = sets[{scale, &theme}];
    if (set.empty())
        set = by == ColorBy::speed_class
                  ? kind_colors_beside(speed_class_colors(theme), theme)
                  : kind_colors_beside(scale_colors(film, theme).samples(), theme);
    return set[index % set.size()];
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

double ring_line(double radius, double unit) {
    return std::clamp(0.4 * radius, 1.5, std::max(1.5, 0.13 * unit));
}

// Whether there are infinite masses is determined only once, since it is needed for every disk of
// every frame.
GasColors::GasColors(const PanelContext& context)
    : context_(context),
      tells_infinite_(context.film().color_by == ColorBy::mass &&
                      (context.particles.inverse_mass == 0.0).any()),
      is_plain_(context.film().field && context.film().color_by == ColorBy::speed &&
                context.box().dimension > 1) {
    const auto [title, symbol] = scale_title(context.film().color_by);
    scale_.title = say(context.language(), title);
    scale_.symbol = symbol;
    scale_.language = context.language();
}

double GasColors::value(Eigen::Index i, double speed) const {
    switch (context_.film().color_by) {
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
        if (!is_present(input.sample, i)) return;
        const double its = value(i, input.speed[i]);
        if (std::isfinite(its)) pool_.push_back(its);
    });
}

void GasColors::fix_scale() {
    constexpr Eigen::Index few = 10;  // particles
    constexpr double share_above = 0.05;
    const bool is_whole =
        context_.film().color_by == ColorBy::mass || context_.particles.count() <= few;
    if (!pool_.empty()) fix_top(scale_, pool_, is_whole ? 0.0 : share_above);
    pool_ = {};
    shades_ = make_shades(theme_of(context_.film()));
}

void GasColors::archive(Archive& archive) {
    archive(scale_);
    shades_ = make_shades(theme_of(context_.film()));
}

std::uint16_t GasColors::shade(Eigen::Index i, const Motion& motion,
                               const Membership* membership) const {
    const auto species = static_cast<std::size_t>(species_in(membership, context_.particles)[i]);
    if (context_.film().color_by == ColorBy::species || has_own_color(species))
        return static_cast<std::uint16_t>(first_species + species);
    const auto on_scale = [](double share) {
        return static_cast<std::uint16_t>(std::lround(share * (scale_shades - 1)));
    };
    if (context_.film().color_by == ColorBy::speed_class)
        return static_cast<std::uint16_t>(speed_class(motion.speed, motion.mean_speed));
    if (context_.film().color_by == ColorBy::direction) {
        if (motion.speed == 0.0) return resting_shade;
        const double turns =
            std::atan2(motion.direction[1], motion.direction[0]) / (2.0 * std::numbers::pi);
        return on_scale(turns - std::floor(turns));
    }
    if (tells_infinite() && context_.particles.inverse_mass[i] == 0.0) return infinite_shade;
    return on_scale(std::clamp(value(i, motion.speed) / scale_.top, 0.0, 1.0));
}

bool GasColors::is_of_species(std::uint16_t shade) { return shade >= first_species; }

bool GasColors::is_of_infinite(std::uint16_t shade) { return shade == infinite_shade; }

bool GasColors::has_own_color(std::size_t species) const {
    return context_.run_in_box || context_.looks()[species].color.has_value();
}

// Making shades includes a search for where the scale begins to stand out from the ground, so it is
// not done in every frame.
std::vector<Color> GasColors::of_shades(const Theme& theme) const {
    const bool known = !shades_.empty() && &theme == &theme_of(context_.film());
    return known ? shades_ : make_shades(theme);
}

std::vector<Color> GasColors::make_shades(const Theme& theme) const {
    std::vector<Color> colors(first_species, theme.ink);
    if (context_.film().color_by == ColorBy::speed_class) {
        std::ranges::copy(speed_class_colors(theme), colors.begin());
    } else if (!is_plain_) {
        const ColorMap map = scale_colors(context_.film(), theme);
        for (std::size_t i = 0; i < scale_shades; ++i)
            colors[i] = map.at(double(i) / (scale_shades - 1));
        colors[infinite_shade] = color_beside_scale(context_.film(), theme);
        colors[resting_shade] = theme.ground;  // nothing but a rim
    }
    for (std::size_t k = 0; k < context_.species().size(); ++k)
        colors.push_back(plot::color_of(species_role(context_, k), theme));
    return colors;
}

namespace {

Point point_around(Point center, double turns, double distance) {
    const double angle = 2.0 * std::numbers::pi * turns;
    return {center.x + distance * std::cos(angle), center.y - distance * std::sin(angle)};
}

void draw_ring_of_directions(Canvas& canvas, Point center, double radius, const ColorMap& map) {
    constexpr int steps = 96;
    for (int i = 0; i < steps; ++i) {
        const double from = (i - 0.6) / steps, to = (i + 0.6) / steps;
        const std::vector<Point> part{
            point_around(center, from, radius), point_around(center, to, radius),
            point_around(center, to, 0.62 * radius), point_around(center, from, 0.62 * radius)};
        canvas.fill_polygon(part, map.at(double(i) / steps));
    }
}

}  // namespace

struct GasColors::Entry {
    Color color;
    std::string name;
    bool is_hatched = false, is_ring = false;
};

// The named colours of the legend; species are included only if they are distinguished by the
// film's colouring or by their own colours.
std::vector<GasColors::Entry> GasColors::entries(const Theme& theme) const {
    const std::vector<Color> colors = of_shades(theme);
    const Language language = context_.language();
    const ColorBy by = context_.film().color_by;
    std::vector<Entry> all;
    if (context_.run_in_box) return all;  // the runs are named under the box
    if (by == ColorBy::speed_class)
        all = {{colors[0], say(language, "slow")},
               {colors[1], say(language, "medium")},
               {colors[2], say(language, "fast")}};
    if (by == ColorBy::direction && context_.box().dimension == 1)
        all = {{colors[0], say(language, "to the right")},
               {colors[scale_shades / 2], say(language, "to the left")}};
    if (tells_infinite()) all.push_back({colors[infinite_shade], say(language, "infinite"), true});
    for (std::size_t k = 0; k < context_.species().size(); ++k)
        if (by == ColorBy::species || has_own_color(k))
            all.push_back({colors[first_species + k], context_.species()[k].name, false,
                           !context_.looks()[k].fill});
    return all;
}

bool GasColors::has_bar() const {
    const ColorBy by = context_.film().color_by;
    return !is_plain_ && !context_.run_in_box &&
           (by == ColorBy::speed || by == ColorBy::energy || by == ColorBy::mass);
}

double GasColors::key_height(const DrawContext& dc, bool has_ramp) const {
    const double names = 2.4 * dc.unit * static_cast<double>(entries(dc.theme).size());
    const bool is_tall = (has_bar() && has_ramp) ||
                         context_.film().color_by == ColorBy::direction ||
                         context_.film().color_by == ColorBy::speed_class;
    return is_tall ? 0.5 * dc.area.height : std::min(names, 0.6 * dc.area.height);
}

void GasColors::draw_key(Canvas& canvas, const DrawContext& dc, bool has_ramp) const {
    const double u = dc.unit;
    const ColorBy by = context_.film().color_by;
    const double entries_height = 2.4 * u * static_cast<double>(entries(dc.theme).size());
    double y = dc.area.y + 0.9 * u;
    if (by == ColorBy::direction && context_.box().dimension == 2) {
        draw_wheel(canvas, dc);
        y += 8.4 * u;
    } else if (has_bar() && has_ramp) {
        const double bottom = std::max(dc.area.y + least_bar * u,
                                       dc.area.bottom() - std::min(entries_height, 6.0 * u));
        DrawContext bar = dc;
        bar.area.height = bottom - dc.area.y;
        draw_color_bar(canvas, bar, scale_colors(context_.film(), dc.theme), scale_);
        y = bottom + 1.9 * u;
    }
    y = draw_entries(canvas, dc, y);
    if (by != ColorBy::speed_class) return;
    TextStyle style = label_style(dc);
    style.max_width = dc.area.width;
    const std::string classes = say(context_.language(), "below ½, above 1½ of the mean");
    for (const std::string& line : wrapped(classes, style, 5)) {
        draw_text(canvas, {dc.area.x, y}, escape_markup(line), style);
        y += 1.5 * u;
    }
}

// The disks' names before the scale: they are more to the point.
void GasColors::add_key(KeyRow& row, bool has_ramp) const {
    const DrawContext dc = row.context();
    const ColorBy by = context_.film().color_by;
    const TextStyle style = label_style(dc);
    for (const Entry& entry : entries(dc.theme)) {
        const std::string name = escape_markup(entry.name);
        const double disk = 1.3 * dc.unit;
        row.add(disk + measure_text(name, style).width, [=](Canvas& canvas, Point at) {
            draw_swatch(canvas, dc, {at.x + 0.5 * dc.unit, at.y - 0.35 * dc.unit}, entry);
            draw_text(canvas, {at.x + disk, at.y}, name, style);
        });
    }
    if (by == ColorBy::speed_class)
        row.add_words(say(context_.language(), "below ½, above 1½ of the mean"));
    if (by == ColorBy::direction && context_.box().dimension == 2) {
        row.add_words(say(context_.language(), "direction"));
        const double radius = 0.9 * dc.unit;
        const ColorMap map = scale_colors(context_.film(), dc.theme);
        row.add(2.0 * radius, [=](Canvas& canvas, Point at) {
            draw_ring_of_directions(canvas, {at.x + radius, dc.area.y + radius}, radius, map);
        });
    }
    if (has_bar() && has_ramp) row.add_ramp(scale_colors(context_.film(), dc.theme), scale_);
}

// A ring of the colours, and arrows to all sides.
void GasColors::draw_wheel(Canvas& canvas, const DrawContext& dc) const {
    const double u = dc.unit, radius = 2.2 * u;
    const Point center{dc.area.x + radius + 0.4 * u, dc.area.y + 1.5 * u + radius};
    const ColorMap map = scale_colors(context_.film(), dc.theme);
    draw_text(canvas, {dc.area.x, dc.area.y + 0.9 * u}, say(context_.language(), "direction"),
              label_style(dc));
    const auto at = [&](double turns, double distance) {
        return point_around(center, turns, distance);
    };
    draw_ring_of_directions(canvas, center, radius, map);
    for (const double turns : {0.0, 0.25, 0.5, 0.75}) {
        canvas.stroke_line(center, at(turns, 0.5 * radius), 0.1 * u, dc.theme.muted);
        const std::vector<Point> head{at(turns, 0.56 * radius), at(turns + 0.06, 0.4 * radius),
                                      at(turns - 0.06, 0.4 * radius)};
        canvas.fill_polygon(head, dc.theme.muted);
    }
}

// A disk as it is drawn in the box.
void GasColors::draw_swatch(Canvas& canvas, const DrawContext& dc, Point center,
                            const Entry& entry) {
    const double u = dc.unit, outer = 0.45 * u;
    if (entry.is_hatched) {
        canvas.fill_circle(center, 0.62 * u, entry.color);
        draw_hatching(canvas, dc, center, 0.62 * u);
        return;
    }
    const Color edge = edge_of(entry.color, dc.theme);
    if (entry.is_ring) {
        const double line = ring_line(outer, u);
        canvas.stroke_circle(center, outer - 0.5 * line, line, edge);
        return;
    }
    canvas.fill_circle(center, outer, edge);
    canvas.fill_circle(center, 0.38 * u, entry.color);
}

// Draws as many entries as there is room for, from the baseline `y` on; returns the baseline of the
// next one.
double GasColors::draw_entries(Canvas& canvas, const DrawContext& dc, double y) const {
    const double u = dc.unit;
    const std::vector<Entry> all = entries(dc.theme);
    TextStyle style = label_style(dc);
    style.max_width = dc.area.width - 1.4 * u;
    // Names go below their swatches where a word of one is too long to stand beside it.
    const bool is_below = std::ranges::any_of(all, [&](const Entry& entry) {
        return std::ranges::any_of(wrapped(entry.name, style, 9), [&](const std::string& line) {
            return line != entry.name && entry.name.find(line + " ") == std::string::npos &&
                   entry.name.find(" " + line) == std::string::npos;
        });
    });
    const Point offset = is_below ? Point{0.0, 1.4 * u} : Point{1.4 * u, 0.0};
    if (is_below) style.max_width = dc.area.width;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Entry& entry = all[k];
        const std::vector<std::string> lines = wrapped(entry.name, style, 2);
        const double end = y + offset.y + 1.4 * u * static_cast<double>(lines.size() - 1);
        const double last = k + 1 == all.size() ? 0.0 : 1.8 * u;  // room for how many more
        if (k > 1 && end + last > dc.area.bottom()) {
            draw_text(canvas, {dc.area.x, y},
                      say(context_.language(), "and {} more", all.size() - k), label_style(dc));
            break;
        }
        draw_swatch(canvas, dc, {dc.area.x + 0.5 * u, y - 0.35 * u}, entry);
        for (std::size_t line = 0; line < lines.size(); ++line)
            draw_text(canvas,
                      {dc.area.x + offset.x, y + offset.y + 1.4 * u * static_cast<double>(line)},
                      escape_markup(lines[line]), style);
        y = end + 1.8 * u;
    }
    return y;
}

}  // namespace carom
