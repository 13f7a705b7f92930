// The drawing of a wire: its beads, ghosts, arrows and words, and their world lines below.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/line/line_panel.h"
#include "panels/line/line_state.h"

namespace carom {
namespace {

constexpr double rods_from = 2.0;   // units of radius: longer beads are drawn as rods
constexpr double rods_fill = 0.15;  // of the wire, from which beads of true length are rods
constexpr double rod_half_height = 1.3;
constexpr double ring_line = 0.13;
constexpr double arrows_below = 1.15;  // units, from the beads to the middle of their arrows
constexpr double arrows_apart = 0.9;   // units, from those to the right to those to the left
constexpr double arrows_height = 2.0;  // units, that they take from the world lines

void draw_rod(Canvas& canvas, const DrawContext& dc, Point center, double radius, Color color,
              bool filled) {
    const double u = dc.unit;
    const Rect rod{center.x - radius + 0.04 * u, center.y - rod_half_height * u,
                   2.0 * radius - 0.08 * u, 2.0 * rod_half_height * u};
    const Color edge = edge_of(color, dc.theme);
    canvas.fill(rod, edge);
    const double line = std::max(1.5, ring_line * u);
    if (!filled || to_pixel(edge) != to_pixel(color))
        canvas.fill({rod.x + line, rod.y + line, rod.width - 2.0 * line, rod.height - 2.0 * line},
                    filled ? color : dc.theme.page);
}

}  // namespace

// Where things are, in pixels.
struct WirePanel::View {
    Rect plot;      // of the world lines
    double wire_y;  // the height of the wire
    double scale;   // pixels of a length
    Scale time;     // time before now
    double unit;
    bool rods;         // beads of true length are drawn as rods, else as disks
    bool larger_rods;  // and those drawn larger than they are
    double x(double place) const { return plot.x + place * scale; }
};

// Small beads stay visible, chosen ones above all.
double WirePanel::shown_radius(Eigen::Index i, const View& v) const {
    return std::max((stands_out(context_, i) ? 0.4 : 0.15) * v.unit, map_->radius(i) * v.scale);
}

bool WirePanel::is_rod(Eigen::Index i, const View& v) const {
    return map_->is_true(i) ? v.rods : v.larger_rods;
}

double WirePanel::half_height(Eigen::Index i, const View& v) const {
    return is_rod(i, v) ? rod_half_height * v.unit : shown_radius(i, v);
}

WirePanel::View WirePanel::view(const DrawContext& dc) const {
    const double u = dc.unit;
    View view;
    view.unit = u;
    view.wire_y = dc.area.y + 3.4 * u;
    const double arrows = arrows_.shown() ? arrows_height * u : 0.0;
    view.plot = {dc.area.x + 3.4 * u, dc.area.y + 7.6 * u + arrows, dc.area.width - 4.0 * u,
                 dc.area.height - 8.0 * u - arrows};
    view.scale = view.plot.width / map_->length();
    view.time = {0.0, memory_, view.plot.y, view.plot.bottom()};
    double filled = 0.0, longest = 0.0, longest_larger = 0.0;
    for (Eigen::Index i = 0; i < context_.particles.count(); ++i) {
        const double radius = map_->radius(i);
        double& most = map_->is_true(i) ? longest : longest_larger;
        most = std::max(most, radius * view.scale);
        if (map_->is_true(i)) filled += 2.0 * radius;
    }
    view.rods = longest > rods_from * u || filled > rods_fill * map_->length();
    view.larger_rods = longest_larger > rods_from * u;
    return view;
}

void WirePanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const View v = view(dc);
    const double u = dc.unit;
    canvas.fill(v.plot, dc.theme.ground);
    for (const double side : {-1.0, 1.0}) draw_end(canvas, dc, side);
    canvas.stroke_line({v.plot.x, v.wire_y}, {v.plot.right(), v.wire_y}, 0.12 * u, dc.theme.wall);
    draw_y_axis(canvas, v.plot, v.time, axis_style(dc));
    draw_captions(canvas, dc);
}

// A wall and its world line, or where a ring is cut open.
void WirePanel::draw_end(Canvas& canvas, const DrawContext& dc, double side) const {
    const View v = view(dc);
    const double u = dc.unit;
    const double x = side < 0.0 ? v.plot.x : v.plot.right();
    const double top = v.wire_y - 2.2 * u, bottom = v.wire_y + 2.2 * u;
    if (is_ring()) {
        canvas.stroke_line({x, top}, {x, bottom}, 0.1 * u, dc.theme.wall, 0.4 * u);
        canvas.stroke_line({x, v.plot.y}, {x, v.plot.bottom()}, 0.1 * u, dc.theme.wall, 0.4 * u);
    } else {
        const double thick = 0.5 * u;
        canvas.fill({side < 0.0 ? x - thick : x, top, thick, bottom - top}, dc.theme.wall);
        canvas.stroke_line({x, v.plot.y}, {x, v.plot.bottom()}, 0.1 * u, dc.theme.wall);
    }
}

// What the axis is, what the lines are, and that beads are not as large as they look.
void WirePanel::draw_captions(Canvas& canvas, const DrawContext& dc) const {
    const View v = view(dc);
    const double u = dc.unit;
    const double baseline = v.plot.y - 0.8 * u;
    TextStyle words = label_style(dc);
    draw_text(canvas, {dc.area.x, baseline}, "time ago", words);
    const bool all = lines_->count() == static_cast<std::size_t>(context_.particles.count());
    const double end = v.plot.x + 1.6 * u +
                       draw_text(canvas, {v.plot.x + 1.6 * u, baseline},
                                 all ? "where each bead was"
                                     : fmt::format("where {} of the beads were", lines_->count()),
                                 words)
                           .width;
    const bool larger = map_->length() > context_.scene.gas.box.size[0];
    words.align = Align::right;
    const std::string remark = "beads drawn larger than they are";
    if (larger && end + u + measure_text(remark, words).width < v.plot.right())
        draw_text(canvas, {v.plot.right(), baseline}, remark, words);
}

void WirePanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const View v = view(dc);
    canvas.clip_to(v.plot);
    draw_lines(canvas, dc, state);
    draw_reversals(canvas, dc, state);
    canvas.release_clip();
    canvas.clip_to({v.plot.x, dc.area.y, v.plot.width, v.plot.y - dc.area.y});
    draw_ghosts(canvas, dc, state);
    draw_beads(canvas, dc, state);
    draw_flashes(canvas, dc, state);
    canvas.release_clip();
    draw_remark(canvas, dc, {v.plot.right(), v.plot.bottom()}, v.plot.width, flashes_.remarks());
    draw_arrows(canvas, dc, state);
    draw_words(canvas, dc, state);
    const auto& now = static_cast<const WireState&>(state);
    if (now.ghosts)
        draw_ghost_words(canvas, dc, {v.plot.x + 0.3 * dc.unit, dc.area.y + 0.9 * dc.unit},
                         v.plot.width - 0.6 * dc.unit, *now.ghosts, now.ghost_words);
}

// Where a bead is seen: on a ring more than once, where it reaches over the cut.
std::vector<Point> WirePanel::seen_at(double place, double radius, const View& v) const {
    double x = place * v.scale;
    if (is_ring()) x -= v.plot.width * std::floor(x / v.plot.width);
    std::vector<Point> seen;
    for (const double shift : {0.0, -v.plot.width, v.plot.width}) {
        const Point at{v.plot.x + x + shift, v.wire_y};
        if (shift != 0.0 && !is_ring()) continue;
        if (at.x + radius > v.plot.x && at.x - radius < v.plot.right()) seen.push_back(at);
    }
    return seen;
}

void WirePanel::draw_ghosts(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const WireState&>(state);
    if (!now.ghosts) return;
    const View v = view(dc);
    const double line = ghost_line(dc);
    for (std::size_t i = 0; i < now.ghosts->x.size(); ++i) {
        const auto particle = static_cast<Eigen::Index>(i);
        const double radius = shown_radius(particle, v);
        for (const Point& at : seen_at(double(now.ghosts->x[i]), radius, v)) {
            const double half = rod_half_height * dc.unit;
            if (is_rod(particle, v))
                canvas.stroke_rect({at.x - radius, at.y - half, 2.0 * radius, 2.0 * half}, line,
                                   dc.theme.muted);
            else
                canvas.stroke_circle(at, radius, line, dc.theme.muted);
        }
    }
}

void WirePanel::draw_lines(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const double apart = view(dc).plot.width / static_cast<double>(lines_->count());
    const double width = std::clamp(0.3 * apart, 0.08 * dc.unit, 0.26 * dc.unit);
    for (std::size_t line = 0; line < lines_->count(); ++line) draw_band(canvas, dc, state, line);
    for (std::size_t line = 0; line < lines_->count(); ++line)
        if (!stands_out(context_, lines_->particle(line)))
            draw_line(canvas, dc, state, line, std::nullopt, width);
    for (std::size_t line = 0; line < lines_->count(); ++line) {
        if (!stands_out(context_, lines_->particle(line))) continue;
        draw_line(canvas, dc, state, line, dc.theme.ink, width + 0.24 * dc.unit);
        draw_line(canvas, dc, state, line, std::nullopt, width + 0.08 * dc.unit);
    }
}

// As wide as the bead is drawn, so that those of neighbours touch where they meet.
void WirePanel::draw_band(Canvas& canvas, const DrawContext& dc, const PanelState& state,
                          std::size_t line) const {
    const auto& now = static_cast<const WireState&>(state);
    const std::vector<WorldLines::Bend>& bends = now.lines[line];
    const View v = view(dc);
    const double radius = map_->radius(lines_->particle(line)) * v.scale;
    if (radius < 0.2 * dc.unit) return;
    const std::vector<Color> colors = colors_.of_shades(dc.theme);
    const bool ring = is_ring();
    for (std::size_t k = 1; k < bends.size(); ++k) {
        const Color color = mix(dc.theme.ground, colors[bends[k].shade % colors.size()], 0.3);
        const double left = std::min(bends[k - 1].place, bends[k].place);
        const double right = std::max(bends[k - 1].place, bends[k].place);
        const double r = map_->radius(lines_->particle(line)), whole = map_->length();
        const double first = ring ? std::floor((left - r) / whole) : 0.0;
        const double last = ring ? std::floor((right + r) / whole) : 0.0;
        for (double turn = first; turn <= last; turn += 1.0) {
            const double from = v.x(bends[k - 1].place - turn * whole);
            const double to = v.x(bends[k].place - turn * whole);
            // Whole pixels: half-covered rows would show as seams.
            const double low = std::round(v.time(now.time - bends[k - 1].time));
            const double high = std::round(v.time(now.time - bends[k].time));
            canvas.fill_polygon(std::array{Point{from - radius, low}, Point{from + radius, low},
                                           Point{to + radius, high}, Point{to - radius, high}},
                                color);
        }
    }
}

// In one colour, or in those of the speeds. Drawn again wherever a turn round a ring brings it into
// view.
void WirePanel::draw_line(Canvas& canvas, const DrawContext& dc, const PanelState& state,
                          std::size_t line, std::optional<Color> color, double width) const {
    const auto& now = static_cast<const WireState&>(state);
    const std::vector<WorldLines::Bend>& bends = now.lines[line];
    const View v = view(dc);
    const std::vector<Color> colors = colors_.of_shades(dc.theme);
    const auto own = [&](std::uint8_t shade) {
        return edge_of(colors[shade % colors.size()], dc.theme);
    };
    const auto [least, most] = std::minmax_element(
        bends.begin(), bends.end(),
        [](const WorldLines::Bend& a, const WorldLines::Bend& b) { return a.place < b.place; });
    const bool ring = is_ring();
    const double first = ring ? std::floor(least->place / map_->length()) : 0.0;
    const double last = ring ? std::floor(most->place / map_->length()) : 0.0;
    for (double turn = first; turn <= last; turn += 1.0) {
        std::vector<Point> path;
        for (std::size_t k = 0; k < bends.size(); ++k) {
            const Point at{v.x(bends[k].place - turn * map_->length()),
                           v.time(now.time - bends[k].time)};
            const bool other = !color && k > 1 && bends[k].shade != bends[k - 1].shade;
            if (other) {
                canvas.stroke_path(path, width, own(bends[k - 1].shade));
                path = {path.back()};
            }
            path.push_back(at);
        }
        canvas.stroke_path(path, width, color ? *color : own(bends.back().shade));
    }
}

void WirePanel::draw_reversals(Canvas& canvas, const DrawContext& dc,
                               const PanelState& state) const {
    const auto& now = static_cast<const WireState&>(state);
    const View v = view(dc);
    for (const double time : now.reversals) {
        const double y = v.time(now.time - time);
        canvas.stroke_line({v.plot.x, y}, {v.plot.right(), y}, 0.1 * dc.unit, dc.theme.muted);
        TextStyle style = label_style(dc);
        style.align = Align::right;
        const double width = measure_text("reversed", style).width + dc.unit;
        // Under the line: there the word is whole as soon as the line is seen.
        canvas.fill({v.plot.right() - width, y + 0.05 * dc.unit, width, 1.35 * dc.unit},
                    with_alpha(dc.theme.ground, plate_alpha));
        draw_text(canvas, {v.plot.right() - 0.5 * dc.unit, y + 1.05 * dc.unit}, "reversed", style);
    }
}

void WirePanel::draw_beads(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const WireState&>(state);
    const View v = view(dc);
    const double u = dc.unit;
    const std::vector<Color> colors = colors_.of_shades(dc.theme);
    std::vector<Disk> disks;
    std::vector<std::pair<Point, double>> rings;
    for (std::size_t i = 0; i < now.places.size(); ++i) {
        const auto particle = static_cast<Eigen::Index>(i);
        const double radius = shown_radius(particle, v);
        const Color color = colors[now.shades[i] % colors.size()];
        const Color edge = edge_of(color, dc.theme);
        for (const Point& at : seen_at(double(now.places[i]), radius, v)) {
            if (stands_out(context_, particle)) rings.push_back({at, radius});
            if (is_rod(particle, v))
                draw_rod(canvas, dc, at, radius, color, is_filled(particle));
            else
                disks.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                                 static_cast<float>(radius), to_pixel(edge) & 0xFFFFFF});
            const double line = std::max(1.5, ring_line * u);
            const Color inside = is_filled(particle) ? color : dc.theme.page;
            if (!is_rod(particle, v) && radius > 2.0 * line && to_pixel(inside) != to_pixel(edge))
                disks.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                                 static_cast<float>(radius - line), to_pixel(inside) & 0xFFFFFF});
        }
    }
    dc.disks.draw(canvas, disks, {v.plot.x, dc.area.y, v.plot.width, v.plot.y - dc.area.y});
}

void WirePanel::draw_flashes(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const View v = view(dc);
    for (const Flash& flash : static_cast<const WireState&>(state).flashes)
        for (const Point& at : seen_at(flash.place.x, flash_reach * dc.unit, v))
            draw_flash(canvas, dc, at, flash.share);
}

// Under the beads, those to the right above those to the left: on the wire, or in one row, those of
// neighbours would lie upon one another.
void WirePanel::draw_arrows(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const WireState&>(state);
    if (now.velocities.empty()) return;
    const View v = view(dc);
    double half = 0.0;
    for (Eigen::Index i = 0; i < context_.particles.count(); ++i) {
        half = std::max(half, half_height(i, v));
    }
    const double y = v.wire_y + half + arrows_below * v.unit;
    const ArrowField field{
        {v.plot.x, y - v.unit, v.plot.width, 2.0 * v.unit}, v.scale, {is_ring(), false}};
    canvas.clip_to(VelocityArrows::bounds(dc, field));
    for (std::size_t i = 0; i < now.places.size(); ++i) {
        double x = static_cast<double>(now.places[i]) * v.scale;
        if (is_ring()) x -= v.plot.width * std::floor(x / v.plot.width);
        const double row = (now.velocities[i] > 0.0F ? -0.5 : 0.5) * arrows_apart * v.unit;
        arrows_.draw(canvas, dc, field, {v.plot.x + x, y + row}, 0.0,
                     {double(now.velocities[i]), 0.0}, dc.theme.page);
    }
    canvas.release_clip();
}

void WirePanel::draw_key(Canvas& canvas, const DrawContext& dc, const DrawContext& own) const {
    const Rect left = arrows_.draw_key(canvas, dc, view(own).scale);
    colors_.draw_key(canvas, {left, dc.unit, dc.theme, dc.disks});
}

void WirePanel::draw_name(Canvas& canvas, const DrawContext& dc, Eigen::Index particle,
                          double place, double alpha) const {
    const std::string name = single_name(context_, particle);
    if (name.empty()) return;
    const View v = view(dc);
    TextStyle style = title_style(dc);
    style.align = Align::center;
    style.color = with_alpha(dc.theme.ink, alpha);
    style.max_width = v.plot.width - 0.8 * dc.unit;
    const double half = measure_text(escape_markup(name), style).width / 2.0 + 0.4 * dc.unit;
    const double x = std::clamp(v.x(place), v.plot.x + half, v.plot.right() - half);
    const double top = v.wire_y - half_height(particle, v);
    draw_text(canvas, {x, top - 0.7 * dc.unit}, escape_markup(name), style);
}

bool WirePanel::is_filled(Eigen::Index particle) const {
    return context_.scene.looks[static_cast<std::size_t>(context_.particles.species[particle])]
        .fill;
}

bool WirePanel::words_fit(const DrawContext& dc, Labels labels, const View& v) const {
    for (Eigen::Index i = 0; i < context_.particles.count(); ++i) {
        const std::string words = words_on(context_, i, labels);
        if (!words.empty() && !fitting_words(dc, map_->radius(i) * v.scale, words)) return false;
    }
    return true;
}

// Words on all beads if all are large enough; the names of chosen beads, at the start.
void WirePanel::draw_words(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const WireState&>(state);
    const View v = view(dc);
    const std::vector<Color> colors = colors_.of_shades(dc.theme);
    const Labels labels = words_fit(dc, shown_labels(), v) ? shown_labels() : Labels::none;
    for (std::size_t i = 0; i < now.places.size(); ++i) {
        const auto particle = static_cast<Eigen::Index>(i);
        double place = static_cast<double>(now.places[i]);
        place -= map_->length() * std::floor(place / map_->length());
        const Color color =
            is_filled(particle) ? colors[now.shades[i] % colors.size()] : dc.theme.page;
        draw_words_on(canvas, dc, {v.x(place), v.wire_y}, map_->radius(particle) * v.scale,
                      words_on(context_, particle, labels), color);
        if (now.label_alpha > 0.0 && stands_out(context_, particle))
            draw_name(canvas, dc, particle, place, now.label_alpha);
    }
}

}  // namespace carom
