// The drawing of a line: its beads, ghosts, arrows and words, and their world lines below.
#include "panels/line/line_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "scene/film.h"

namespace carom {
namespace {

constexpr double rods_from = 2.0;      // units of radius, beyond which beads are drawn as rods
constexpr double rods_fill = 0.15;     // filled share of the line, from which true beads are rods
constexpr double arrows_below = 1.15;  // units, from the beads to the middle of their arrows
constexpr double arrows_apart = 0.9;   // units, from those to the right to those to the left
constexpr double arrows_height = 2.0;  // units, that they take from the world lines
constexpr double least_history = 2.5;  // units of height, from which world lines are drawn

void draw_rod(Canvas& canvas, const DrawContext& dc, Point center, double radius, Color color,
              bool filled) {
    const double u = dc.unit;
    const Rect rod{center.x - radius + 0.04 * u, center.y - rod_half_height * u,
                   2.0 * radius - 0.08 * u, 2.0 * rod_half_height * u};
    const Color edge = edge_of(color, dc.theme);
    canvas.fill(rod, edge);
    const double line = ring_line(rod_half_height * u, u);
    if (!filled || to_pixel(edge) != to_pixel(color))
        canvas.fill({rod.x + line, rod.y + line, rod.width - 2.0 * line, rod.height - 2.0 * line},
                    filled ? color : dc.theme.page);
}

}  // namespace

LinePanel::View LinePanel::whole_view(const DrawContext& dc) const {
    const double u = dc.unit;
    const double arrows = arrows_.shown() ? arrows_height * u : 0.0;
    View view{};
    const double below = dc.area.height - 8.0 * u - arrows;
    view.has_lines = below >= least_history * u;
    view.line_y = dc.area.y + (view.has_lines ? 3.4 * u : 0.5 * dc.area.height);
    view.plot = {dc.area.x + 3.4 * u, dc.area.y + 7.6 * u + arrows, dc.area.width - 4.0 * u,
                 view.has_lines ? below : 0.0};
    if (!ends_.is_plain()) view.plot.width -= 2.6 * u;  // for what is outside of the right end
    view.low = -ends_.before();
    view.scale = view.plot.width / drawn_length();
    view.time = {0.0, memory_, view.plot.y, view.plot.bottom()};
    double filled = 0.0;
    for (Eigen::Index i = 0; i < context_.particles.count(); ++i) {
        const double radius = map_->radius(i);
        double& most = map_->is_true(i) ? view.longest : view.longest_larger;
        most = std::max(most, radius * view.scale);
        if (map_->is_true(i)) filled += 2.0 * radius;
    }
    view.rods = view.longest > rods_from * u || filled > rods_fill * map_->length();
    view.larger_rods = view.longest_larger > rods_from * u;
    return view;
}

// The length of the line as drawn, with all places that its ends ever reach.
double LinePanel::drawn_length() const { return map_->length() + ends_.before() + ends_.beyond(); }

// The part of the drawn line that the camera shows. A length of the box is drawn longer by the same
// factor as the whole line.
LinePanel::View LinePanel::part_of(const View& whole, const CameraView& seen,
                                   const DrawContext& dc) const {
    View view = whole;
    const Region extent = ends_.extent();
    const double length = extent.high[0] - extent.low[0], longer = drawn_length() / length;
    view.zoom = length / seen.width;
    view.scale *= view.zoom;
    view.rods = view.rods || view.longest * view.zoom > rods_from * dc.unit;
    view.larger_rods = view.longest_larger * view.zoom > rods_from * dc.unit;
    view.low += (seen.middle[0] - extent.low[0]) * longer - 0.5 * view.plot.width / view.scale;
    return view;
}

LinePanel::View LinePanel::view(const DrawContext& dc, const State& state) const {
    const View whole = whole_view(dc);
    return state.view ? part_of(whole, *state.view, dc) : whole;
}

double LinePanel::scale_in(const DrawContext& own) const { return whole_view(own).scale; }

void LinePanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const State none;
    Drawing{*this, canvas, dc, none}.draw_ground();
}

void LinePanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    Drawing{*this, canvas, dc, static_cast<const State&>(state)}.draw();
}

void LinePanel::Drawing::draw_ground() const {
    canvas.fill(v.plot, dc.theme.ground);
    if (panel.ends_.is_plain() && !panel.camera_.moves()) draw_ends();
    if (!panel.ends_.is_plain())
        panel.ends_.draw_gravity(canvas, dc, {v.plot.x, dc.area.y, v.plot.width, 0.9 * u});
    canvas.stroke_line({v.plot.x, v.line_y}, {v.plot.right(), v.line_y}, 0.12 * u, dc.theme.wall);
    if (!v.has_lines) return;
    AxisStyle axis = axis_style(dc);
    axis.language = context.language();
    draw_y_axis(canvas, v.plot, v.time, axis);
    if (!panel.camera_.moves()) draw_captions();
}

void LinePanel::Drawing::draw_ends() const {
    for (const double side : {-1.0, 1.0}) draw_end(side);
}

// A wall and its world line, or where a ring is cut open.
void LinePanel::Drawing::draw_end(double side) const {
    const double x = side < 0.0 ? v.x(0.0) : v.x(map.length());
    if (x < v.plot.x - 1.0 || x > v.plot.right() + 1.0) return;
    const double top = v.line_y - 2.2 * u, bottom = v.line_y + 2.2 * u;
    const double thick = 0.5 * u, dash = is_ring ? 0.4 * u : 0.0;
    if (is_ring)
        canvas.stroke_line({x, top}, {x, bottom}, 0.1 * u, dc.theme.wall, dash);
    else
        canvas.fill({side < 0.0 ? x - thick : x, top, thick, bottom - top}, dc.theme.wall);
    canvas.stroke_line({x, v.plot.y}, {x, v.plot.bottom()}, 0.1 * u, dc.theme.wall, dash);
}

// Draws ends that do more than reflect, and the world lines of moving ends. The length that beads
// gain by being enlarged lies between the two ends.
void LinePanel::Drawing::draw_acting_ends() const {
    const double growth = map.length() - context.box().size[0];
    for (std::size_t side = 0; side < now.ends.size(); ++side) {
        const LineEnds::End& end = now.ends[side];
        const double off = side == 0 ? 0.0 : growth, x = v.x(end.place + off);
        panel.ends_.draw(canvas, dc, end, side, x, v.line_y);
        std::vector<Point> path;
        for (const Point& at : end.path)
            path.push_back({v.x(at.y + off), v.time(std::min(now.time - at.x, panel.memory_))});
        if (path.size() < 2) path = {{x, v.plot.y}, {x, v.plot.bottom()}};
        canvas.stroke_path(path, 0.1 * u, dc.theme.wall);
    }
}

// Draws the titles of axis and lines, and remarks that beads are enlarged, or have no room for
// their labels in the camera's view.
void LinePanel::Drawing::draw_captions() const {
    const Language language = context.language();
    const double baseline = v.plot.y - 0.8 * u;
    TextStyle words = label_style(dc);
    const double axis =
        draw_text(canvas, {dc.area.x, baseline}, say(language, "time before now"), words).width;
    const double left = std::max(v.plot.x + 1.6 * u, dc.area.x + axis + 1.2 * u);
    const std::size_t lines = panel.lines_->count();
    const std::string what = lines == static_cast<std::size_t>(count())
                                 ? say(language, "world lines")
                                 : say(language, "world lines of {} beads", lines);
    const double end = left + draw_text(canvas, {left, baseline}, what, words).width;
    const bool larger = map.length() > context.box().size[0];
    words.align = Align::right;
    const Labels asked = context.film().labels;
    const bool has_room = asked == Labels::none || words_fit(asked);
    if (!larger && has_room) return;
    const std::string remark = has_room ? say(language, "beads enlarged for visibility")
                                        : say(language, "no room for labels on the beads");
    if (end + u + measure_text(remark, words).width < v.plot.right())
        draw_text(canvas, {v.plot.right(), baseline}, remark, words);
}

void LinePanel::Drawing::draw() const {
    if (panel.ends_.is_plain() && panel.camera_.moves()) draw_ends();
    if (now.view) canvas.clip_to({v.plot.x, dc.area.y, v.plot.width, dc.area.height});
    draw_acting_ends();
    if (now.view) canvas.release_clip();
    if (v.has_lines) {
        if (panel.camera_.moves()) draw_captions();
        canvas.clip_to(v.plot);
        draw_lines();
        draw_reversals();
        canvas.release_clip();
    }
    canvas.clip_to({v.plot.x, dc.area.y, v.plot.width, v.plot.y - dc.area.y});
    if (now.field) draw_field();
    draw_ghosts();
    draw_beads();
    draw_rings();
    draw_flashes();
    canvas.release_clip();
    remarks_in(v, now.view.has_value()).draw(canvas);
    draw_arrows();
    draw_words();
    if (now.ghosts)
        draw_ghost_words(canvas, dc, {v.plot.x, dc.area.y + 0.9 * u}, v.plot.width, *now.ghosts,
                         now.ghost_words);
    if (now.view) draw_where_it_is();
    draw_callouts();
}

// The places at which a bead is visible: on a ring more than one, if it reaches across the cut.
std::vector<Point> LinePanel::Drawing::seen_at(double place, double radius) const {
    const double x = around_once((place - v.low) * v.scale);
    std::vector<Point> seen;
    for (const double shift : {0.0, -period(), period()}) {
        const Point at{v.plot.x + x + shift, v.line_y};
        if (shift != 0.0 && !is_ring) continue;
        if (at.x + radius > v.plot.x && at.x - radius < v.plot.right()) seen.push_back(at);
    }
    return seen;
}

// Calls `draw` with each shift by whole turns around a ring that brings a part of the range from
// `least` to `most` into view.
template <class Draw>
void LinePanel::Drawing::for_each_turn(double least, double most, const Draw& draw) const {
    const double end = v.low + v.plot.width / v.scale;
    const double first = is_ring ? std::ceil((least - end) / map.length()) : 0.0;
    const double last = is_ring ? std::floor((most - v.low) / map.length()) : 0.0;
    for (double turn = first; turn <= last; turn += 1.0) draw(turn * map.length());
}

// Draws the field as a strip behind the beads; its cells are stretched as the drawn line, which is
// longer than the true one.
void LinePanel::Drawing::draw_field() const {
    const double longer = map.length() / context.box().size[0];
    for_each_turn(0.0, map.length(), [&](double back) {
        panel.field_.draw(canvas, dc, *now.field, [&](const Region& region) {
            const double from = v.x(region.low[0] * longer - back);
            const double to = v.x(region.high[0] * longer - back);
            return Rect{from, v.line_y - 1.8 * u, to - from, 3.6 * u};
        });
    });
}

void LinePanel::Drawing::draw_lines() const {
    const std::size_t lines = panel.lines_->count();
    const auto is_chosen = [&](std::size_t line) {
        return stands_out(context, panel.lines_->particle(line));
    };
    const double apart = v.plot.width / static_cast<double>(lines);
    const double width = std::clamp(0.3 * apart, 0.08 * u, 0.26 * u);
    for (std::size_t line = 0; line < lines; ++line) draw_band(line);
    for (std::size_t line = 0; line < lines; ++line)
        if (!is_chosen(line)) draw_line(line, std::nullopt, width);
    for (std::size_t line = 0; line < lines; ++line) {
        if (!is_chosen(line)) continue;
        draw_line(line, dc.theme.ink, width + 0.24 * u);
        draw_line(line, std::nullopt, width + 0.08 * u);
    }
}

// As wide as the bead is drawn, so that those of neighbours touch where they meet.
void LinePanel::Drawing::draw_band(std::size_t line) const {
    const std::vector<WorldLines::Bend>& bends = now.lines[line];
    const double length = map.radius(panel.lines_->particle(line)), radius = length * v.scale;
    if (radius < 0.2 * u) return;
    for (std::size_t k = 1; k < bends.size(); ++k) {
        const WorldLines::Bend &before = bends[k - 1], &bend = bends[k];
        const Color tint = now.seen(mix(dc.theme.ground, color_of(bend.shade), 0.3),
                                    panel.lines_->particle(line), dc.theme.ground);
        const auto [left, right] = std::minmax(before.place, bend.place);
        // Whole pixels: half-covered rows would show as seams.
        const double low = std::round(v.time(now.time - before.time));
        const double high = std::round(v.time(now.time - bend.time));
        for_each_turn(left - length, right + length, [&](double back) {
            const double from = v.x(before.place - back), to = v.x(bend.place - back);
            canvas.fill_polygon(std::array{Point{from - radius, low}, Point{from + radius, low},
                                           Point{to + radius, high}, Point{to - radius, high}},
                                tint);
        });
    }
}

// In one colour, or in those of the speeds.
void LinePanel::Drawing::draw_line(std::size_t line, std::optional<Color> one, double width) const {
    const std::vector<WorldLines::Bend>& bends = now.lines[line];
    if (bends.empty()) return;
    const Eigen::Index bead = panel.lines_->particle(line);
    const auto own = [&](std::uint16_t shade) {
        return now.seen(edge_of(color_of(shade), dc.theme), bead, dc.theme.ground);
    };
    const auto [least, most] = std::ranges::minmax(bends, {}, &WorldLines::Bend::place);
    for_each_turn(least.place, most.place, [&](double back) {
        std::vector<Point> path;
        for (std::size_t k = 0; k < bends.size(); ++k) {
            if (!one && k > 1 && bends[k].shade != bends[k - 1].shade) {
                canvas.stroke_path(path, width, own(bends[k - 1].shade));
                path = {path.back()};
            }
            path.push_back({v.x(bends[k].place - back), v.time(now.time - bends[k].time)});
        }
        canvas.stroke_path(path, width,
                           one ? now.seen(*one, bead, dc.theme.ground) : own(bends.back().shade));
    });
}

void LinePanel::Drawing::draw_reversals() const {
    const std::string word = say(context.language(), "reversed");
    TextStyle style = label_style(dc);
    style.align = Align::right;
    for (const double time : now.reversals) {
        const double y = v.time(now.time - time);
        canvas.stroke_line({v.plot.x, y}, {v.plot.right(), y}, 0.1 * u, dc.theme.muted);
        const double width = measure_text(word, style).width + u;
        // Under the line: there the word is whole as soon as the line is seen.
        canvas.fill({v.plot.right() - width, y + 0.05 * u, width, 1.35 * u},
                    with_alpha(dc.theme.ground, plate_alpha));
        draw_text(canvas, {v.plot.right() - 0.5 * u, y + 1.05 * u}, word, style);
    }
}

void LinePanel::Drawing::draw_beads() const {
    std::vector<Disk> disks;
    const auto add = [&](const Point& at, double radius, Color color) {
        disks.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                         static_cast<float>(radius), to_pixel(color) & 0xFFFFFF});
    };
    for (Eigen::Index i = 0; i < count(); ++i) {
        if (!now.is_shown(i)) continue;
        const double radius = shown_radius(i), line = ring_line(radius, u);
        const Color edge = edge_of(color(i), dc.theme);
        const Color inside = panel.is_filled(i, now) ? color(i) : dc.theme.page;
        for (const Point& at : seen_at(place(i), radius)) {
            if (is_rod(i)) {
                draw_rod(canvas, dc, at, radius, color(i), panel.is_filled(i, now));
                continue;
            }
            add(at, radius, edge);
            if (radius > 2.0 * line && to_pixel(inside) != to_pixel(edge))
                add(at, radius - line, inside);
        }
    }
    dc.disks.draw(canvas, disks, {v.plot.x, dc.area.y, v.plot.width, v.plot.y - dc.area.y});
}

void LinePanel::Drawing::draw_flashes() const {
    for (const Flash& flash : now.flashes)
        for (const Point& at : seen_at(flash.place[0], flash_reach * u))
            draw_flash(canvas, dc, at, flash.share);
}

// Velocity arrows are below the beads, those to the right above those to the left: on the line
// itself, or in a single row, arrows of neighbours would overlap.
void LinePanel::Drawing::draw_arrows() const {
    if (now.velocity.size() == 0) return;
    double half = 0.0;
    for (Eigen::Index i = 0; i < count(); ++i) half = std::max(half, half_height(i));
    const double y = v.line_y + half + arrows_below * u;
    const ArrowField field{
        {v.plot.x, y - u, v.plot.width, 2.0 * u}, v.scale / v.zoom, {is_ring && !now.view, false}};
    canvas.clip_to(VelocityArrows::bounds(dc, field));
    for (Eigen::Index i = 0; i < count(); ++i) {
        if (!panel.arrows_.is_drawn(i) || !now.is_shown(i)) continue;
        const auto velocity = static_cast<double>(now.velocity(i, 0));
        const double row = (velocity > 0.0 ? -0.5 : 0.5) * arrows_apart * u;
        const double light = now.light.empty() ? 1.0 : double(now.light[std::size_t(i)]);
        panel.arrows_.draw(canvas, dc, field,
                           {v.plot.x + around_once((place(i) - v.low) * v.scale), y + row}, 0.0,
                           {velocity, 0.0}, dc.theme.page, light);
    }
    canvas.release_clip();
}

void LinePanel::Drawing::draw_name(Eigen::Index particle, double place) const {
    const std::string name = escape_markup(single_name(context, particle));
    if (name.empty()) return;
    TextStyle style = title_style(dc);
    style.align = Align::center;
    style.color = with_alpha(dc.theme.ink, now.label_alpha);
    style.max_width = v.plot.width - 0.8 * u;
    const double half = measure_text(name, style).width / 2.0 + 0.4 * u;
    const double x = std::max(v.plot.x + half, std::min(v.x(place), v.plot.right() - half));
    const double top = v.line_y - half_height(particle);
    draw_text(canvas, {x, top - 0.7 * u}, name, style);
}

bool LinePanel::Drawing::words_fit(Labels labels) const {
    for (Eigen::Index i = 0; i < count(); ++i) {
        const std::string words = words_on(context, i, labels);
        if (!words.empty() && !fitting_words(dc, map.radius(i) * v.scale, words)) return false;
    }
    return true;
}

// Draws labels on all beads if all are large enough, and the names of chosen beads at the start of
// the film.
void LinePanel::Drawing::draw_words() const {
    const Labels labels = words_fit(panel.shown_labels()) ? panel.shown_labels() : Labels::none;
    for (Eigen::Index i = 0; i < count(); ++i) {
        if (!now.is_shown(i)) continue;
        const double turns = is_ring ? std::floor((place(i) - v.low) / map.length()) : 0.0;
        const double at = place(i) - map.length() * turns;
        if (now.view && (v.x(at) < v.plot.x || v.x(at) > v.plot.right())) continue;
        draw_words_on(canvas, dc, {v.x(at), v.line_y}, map.radius(i) * v.scale,
                      words_on(context, i, labels),
                      panel.is_filled(i, now) ? color(i) : dc.theme.page);
        if (now.label_alpha > 0.0 && stands_out(context, i)) draw_name(i, at);
    }
}

}  // namespace carom
