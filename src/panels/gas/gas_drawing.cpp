// The drawing of the gas: ghosts, trails, disks, their labels, rings and names, flashes and arrows.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/gas_panel.h"
#include "panels/gas/gas_state.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double ring_line = 0.13;    // units
constexpr double rim_line = 0.09;     // of disks that would fade into the ground
constexpr double trail_shades = 64;   // that are hardly told apart
constexpr double least_radius = 1.2;  // pixels: smaller disks are no longer round

// From scene units, y up, to pixels, y down.
struct Mapping {
    Rect box;
    double scale;
    Point operator()(double x, double y) const {
        return {box.x + x * scale, box.bottom() - y * scale};
    }
};

Mapping mapping(const GasPanel& panel, const DrawContext& dc, const Box& box) {
    const Rect rect = panel.frame_in(dc.area);
    return {rect, rect.width / box.size[0]};
}

// How far away a disk that reaches over a periodic side is seen again; 0 if it is not.
double image_shift(const Box& box, int axis, double at, double radius) {
    if (!box.is_periodic(axis)) return 0.0;
    if (at < radius) return box.size[axis];
    return at > box.size[axis] - radius ? -box.size[axis] : 0.0;
}

// Calls `draw` with the place of a disk and of each image of it that reaches into a periodic box.
template <class Draw>
void for_each_image(const Box& box, Point place, double radius, const Draw& draw) {
    const double across = image_shift(box, 0, place.x, radius);
    const double up = image_shift(box, 1, place.y, radius);
    draw(place);
    if (across != 0.0) draw(Point{place.x + across, place.y});
    if (up != 0.0) draw(Point{place.x, place.y + up});
    if (across != 0.0 && up != 0.0) draw(Point{place.x + across, place.y + up});
}

// What is left of a disk's radius inside a ring; disks too small for one are filled.
double inside_ring(double radius, double line) { return radius > 2.0 * line ? radius - line : 0.0; }

// Above the disk if there is room, else below, else upon it; inside the box.
Point usual_foot(const Rect& box, const Rect& disk, double half, double u) {
    const double center = disk.x + disk.width / 2;
    Point foot{std::max(box.x + half, std::min(center, box.right() - half)), disk.y - 0.7 * u};
    if (foot.y - 1.2 * u < box.y) foot.y = disk.bottom() + 1.7 * u;
    if (foot.y + 0.4 * u > box.bottom())
        foot.y = std::clamp(disk.y + disk.height / 2, box.y + 1.2 * u, box.bottom() - 0.4 * u);
    return foot;
}

// How many of the disks lie under a name, but for its own.
int disks_under(const std::vector<Disk>& disks, const Rect& name, const Rect& own) {
    int under = 0;
    for (const Disk& disk : disks) {
        const double x = static_cast<double>(disk.x), y = static_cast<double>(disk.y);
        if (std::hypot(x - own.x - own.width / 2, y - own.y - own.height / 2) < own.width / 2)
            continue;
        const double across = x - std::clamp(x, name.x, name.right());
        const double up = y - std::clamp(y, name.y, name.bottom());
        under += std::hypot(across, up) < static_cast<double>(disk.radius);
    }
    return under;
}

// In a picture that stands still a name may keep clear of the disks around it: of the places around
// its own disk, from above on, the first that covers the fewest.
Point free_foot(const Rect& box, const Rect& disk, double half, double u,
                const std::vector<Disk>& disks) {
    constexpr int directions = 24;
    const double high = 1.4 * u, wide = 2.0 * half - 0.4 * u;
    Point best = usual_foot(box, disk, half, u);
    int least = std::numeric_limits<int>::max();
    for (int k = 0; k < 2 * directions; ++k) {
        const int step = k % directions;  // to the right and to the left in turn
        const double turn = step % 2 == 0 ? 0.5 * step : -0.5 * (step + 1);
        const double angle = 2.0 * std::numbers::pi * turn / directions;
        const double x = std::sin(angle), y = -std::cos(angle);
        const double gap = (k < directions ? 0.2 : 0.8) * u + disk.width / 2;
        const double away = std::min((gap + 0.5 * wide) / std::max(1e-9, std::abs(x)),
                                     (gap + 0.5 * high) / std::max(1e-9, std::abs(y)));
        const Rect name{disk.x + disk.width / 2 + away * x - 0.5 * wide,
                        disk.y + disk.height / 2 + away * y - 0.5 * high, wide, high};
        if (name.x < box.x || name.y < box.y || name.right() > box.right() ||
            name.bottom() > box.bottom())
            continue;
        const int under = disks_under(disks, name, disk);
        if (under >= least) continue;
        least = under;
        best = {name.x + 0.5 * wide, name.y + 1.1 * u};
    }
    return best;
}

// With an edge of the ground, so that it can be read over disks and hides little of them. `disks`:
// to keep clear of.
void draw_name(Canvas& canvas, const DrawContext& dc, const Rect& box, const Rect& disk,
               const std::string& markup, double alpha, const std::vector<Disk>* disks) {
    const double u = dc.unit;
    TextStyle style = title_style(dc);
    style.align = Align::center;
    style.color = with_alpha(dc.theme.ink, alpha);
    style.max_width = box.width - 0.8 * u;
    style.halo = 0.16 * u;
    style.behind = with_alpha(dc.theme.ground, alpha);
    const double half = measure_text(markup, style).width / 2 + 0.4 * u;
    const Point foot =
        disks == nullptr ? usual_foot(box, disk, half, u) : free_foot(box, disk, half, u, *disks);
    draw_text(canvas, foot, markup, style);
}

}  // namespace

void GasPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const Rect box = frame_in(dc.area);
    canvas.fill(box, dc.theme.ground);
    const double line = 0.11 * dc.unit;
    const Rect edge{box.x - line / 2, box.y - line / 2, box.width + line, box.height + line};
    canvas.stroke_rect(edge, line, dc.theme.wall);
}

void GasPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    canvas.clip_to(frame_in(dc.area));
    draw_ghosts(canvas, dc, state);
    draw_trails(canvas, dc, state);
    draw_disks(canvas, dc, state);
    if (context_.scene.film.labels == Labels::none) draw_infinite(canvas, dc, state);
    if (context_.scene.film.labels != Labels::none) draw_labels(canvas, dc, state);
    draw_chosen(canvas, dc, state);
    draw_flashes(canvas, dc, state);
    draw_remarks(canvas, dc);
    canvas.release_clip();
    draw_arrows(canvas, dc, state);
    const auto& gas = static_cast<const GasState&>(state);
    const Rect box = frame_in(dc.area);
    if (gas.ghosts)
        draw_ghost_words(canvas, dc, {box.x + 0.3 * dc.unit, box.y + 1.6 * dc.unit},
                         box.width - 0.6 * dc.unit, *gas.ghosts, gas.ghost_words);
}

void GasPanel::draw_ghosts(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& gas = static_cast<const GasState&>(state);
    if (!gas.ghosts) return;
    const Box& box = context_.scene.gas.box;
    const Mapping to_pixels = mapping(*this, dc, box);
    const std::uint32_t outline = to_pixel(dc.theme.muted) & 0xFFFFFF;
    const std::uint32_t ground = to_pixel(dc.theme.ground) & 0xFFFFFF;
    std::vector<Disk> disks;
    disks.reserve(2 * gas.ghosts->x.size());
    for (std::size_t i = 0; i < gas.ghosts->x.size(); ++i) {
        const double radius = context_.particles.radius[static_cast<Eigen::Index>(i)];
        const double shown = std::max(least_radius, radius * to_pixels.scale);
        const Point place{double(gas.ghosts->x[i]), double(gas.ghosts->y[i])};
        for_each_image(box, place, radius, [&](Point image) {
            const Point at = to_pixels(image.x, image.y);
            const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
            disks.push_back({x, y, static_cast<float>(shown), outline});
            const double inside = inside_ring(shown, ghost_line(dc));
            if (inside > 0.0) disks.push_back({x, y, static_cast<float>(inside), ground});
        });
    }
    dc.disks.draw(canvas, disks, to_pixels.box);
}

void GasPanel::draw_disks(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& gas = static_cast<const GasState&>(state);
    const Box& box = context_.scene.gas.box;
    const Mapping to_pixels = mapping(*this, dc, box);
    const std::vector<Color> colors = colors_.of_shades(dc.theme);
    std::vector<std::uint32_t> pixels, edges;
    for (const Color& color : colors) {
        pixels.push_back(to_pixel(color) & 0xFFFFFF);
        edges.push_back(to_pixel(edge_of(color, dc.theme)) & 0xFFFFFF);
    }

    std::vector<Disk> disks;
    disks.reserve(gas.x.size() + chosen_.size());
    const std::uint32_t ground = to_pixel(dc.theme.ground) & 0xFFFFFF;
    const double line = std::max(1.5, ring_line * dc.unit);
    const double rim = std::max(2.0, rim_line * dc.unit);
    const auto add = [&](std::size_t i) {
        const double radius = context_.particles.radius[static_cast<Eigen::Index>(i)];
        const auto shown = static_cast<float>(std::max(least_radius, radius * to_pixels.scale));
        const std::uint32_t color = pixels[gas.shades[i] % pixels.size()];
        const std::uint32_t edge = edges[gas.shades[i] % edges.size()];
        double inside = 0.0;
        if (!is_filled(i)) inside = inside_ring(double(shown), line);
        if (is_filled(i) && edge != color) inside = inside_ring(double(shown), rim);
        for_each_image(box, {double(gas.x[i]), double(gas.y[i])}, radius, [&](Point place) {
            const Point at = to_pixels(place.x, place.y);
            const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
            disks.push_back({x, y, shown, edge});
            if (inside > 0.0)
                disks.push_back({x, y, static_cast<float>(inside), is_filled(i) ? color : ground});
        });
    };
    for (std::size_t i = 0; i < gas.x.size(); ++i) add(i);
    for (const Chosen& chosen : chosen_) add(static_cast<std::size_t>(chosen.particle));
    dc.disks.draw(canvas, disks, to_pixels.box);
}

void GasPanel::draw_infinite(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    if (!colors_.tells_infinite()) return;
    const auto& gas = static_cast<const GasState&>(state);
    const Mapping to_pixels = mapping(*this, dc, context_.scene.gas.box);
    for (std::size_t i = 0; i < gas.x.size(); ++i) {
        const auto particle = static_cast<Eigen::Index>(i);
        if (!colors_.is_told_infinite(particle) || !is_filled(i)) continue;
        const double radius = context_.particles.radius[particle];
        for_each_image(
            context_.scene.gas.box, {double(gas.x[i]), double(gas.y[i])}, radius, [&](Point place) {
                draw_hatching(canvas, dc, to_pixels(place.x, place.y), radius * to_pixels.scale);
            });
    }
}

void GasPanel::draw_flashes(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const Box& box = context_.scene.gas.box;
    const Mapping to_pixels = mapping(*this, dc, box);
    const double reach = flash_reach * dc.unit / to_pixels.scale;
    for (const Flash& flash : static_cast<const GasState&>(state).flashes)
        for_each_image(box, flash.place, reach, [&](Point image) {
            draw_flash(canvas, dc, to_pixels(image.x, image.y), flash.share);
        });
}

// Disks that are drawn larger than they are make a gas look denser than it is, and flashes that are
// left out make it look calmer.
void GasPanel::draw_remarks(Canvas& canvas, const DrawContext& dc) const {
    const Rect box = frame_in(dc.area);
    double foot = box.bottom();
    if (draw_remark(canvas, dc, {box.right(), foot}, box.width, flashes_.remarks()))
        foot -= 1.5 * dc.unit;
    const double scale = mapping(*this, dc, context_.scene.gas.box).scale;
    const Eigen::ArrayXd& radius = context_.particles.radius;
    const double smallest = radius.minCoeff();
    if (!(smallest * scale < least_radius)) return;
    const double largest = (radius * scale < least_radius).select(radius, smallest).maxCoeff();
    std::vector<std::string> words{"disks drawn larger than their radius of " +
                                   three_digits(smallest)};
    if (largest > smallest)
        words = {"disks drawn larger than their radii of " + three_digits(smallest) + " to " +
                 three_digits(largest)};
    words.emplace_back("disks drawn larger than they are");
    draw_remark(canvas, dc, {box.right(), foot}, box.width, words);
}

void GasPanel::draw_arrows(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& gas = static_cast<const GasState&>(state);
    if (gas.vx.empty()) return;
    const Box& box = context_.scene.gas.box;
    const Mapping to_pixels = mapping(*this, dc, box);
    const ArrowField field{
        to_pixels.box, to_pixels.scale, {box.is_periodic(0), box.is_periodic(1)}};
    canvas.clip_to(VelocityArrows::bounds(dc, field));
    for (std::size_t i = 0; i < gas.vx.size(); ++i) {
        const double radius = context_.particles.radius[static_cast<Eigen::Index>(i)];
        arrows_.draw(canvas, dc, field, to_pixels(double(gas.x[i]), double(gas.y[i])),
                     radius * to_pixels.scale, {double(gas.vx[i]), -double(gas.vy[i])},
                     dc.theme.ground);
    }
    canvas.release_clip();
}

void GasPanel::draw_key(Canvas& canvas, const DrawContext& dc, const DrawContext& own) const {
    const double scale = mapping(*this, own, context_.scene.gas.box).scale;
    const Rect left = arrows_.draw_key(canvas, dc, scale);
    colors_.draw_key(canvas, {left, dc.unit, dc.theme, dc.disks});
}

bool GasPanel::is_filled(std::size_t particle) const {
    const auto i = static_cast<Eigen::Index>(particle);
    return context_.scene.looks[static_cast<std::size_t>(context_.particles.species[i])].fill;
}

void GasPanel::draw_labels(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    if (context_.scene.film.labels == Labels::none) return;
    const auto& gas = static_cast<const GasState&>(state);
    const Mapping to_pixels = mapping(*this, dc, context_.scene.gas.box);
    const std::vector<Color> colors = colors_.of_shades(dc.theme);
    for (std::size_t i = 0; i < gas.x.size(); ++i) {
        const auto particle = static_cast<Eigen::Index>(i);
        const Color color = is_filled(i) ? colors[gas.shades[i] % colors.size()] : dc.theme.ground;
        draw_words_on(canvas, dc, to_pixels(double(gas.x[i]), double(gas.y[i])),
                      context_.particles.radius[particle] * to_pixels.scale,
                      words_on(context_, particle, context_.scene.film.labels), color);
    }
}

// In pieces of one strength, whose round ends lie over one another: steps with square ends of their
// own would show as ribs where they are short, and as notches where the path turns.
void GasPanel::draw_trails(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& gas = static_cast<const GasState&>(state);
    const Box& box = context_.scene.gas.box;
    const Mapping to_pixels = mapping(*this, dc, box);
    for (std::size_t k = 0; k < gas.trails.size(); ++k) {
        const GasState::Trail& trail = gas.trails[k];
        std::vector<Point> piece;
        double strength = 0.0;
        const auto draw_piece = [&] {
            if (piece.size() > 1)
                canvas.stroke_path(piece, (0.1 + 0.25 * strength) * dc.unit,
                                   mix(dc.theme.ground, dc.theme.ink, 0.75 * strength));
            piece.clear();
        };
        for (std::size_t i = 1; i < trail.places.size(); ++i) {
            const Point& from = trail.places[i - 1];
            const Point& to = trail.places[i];
            const double age = static_cast<double>(trail.ages[i]) / chosen_[k].trail_seconds;
            const double now =
                std::round((1.0 - std::clamp(age, 0.0, 1.0)) * trail_shades) / trail_shades;
            if (now != strength) draw_piece();
            strength = now;
            if (piece.empty()) piece.push_back(to_pixels(from.x, from.y));
            // A step goes through a periodic side rather than through more than half the box.
            const double across = box.size[0] * box.turns(0, from.x - to.x);
            const double up = box.size[1] * box.turns(1, from.y - to.y);
            piece.push_back(to_pixels(to.x + across, to.y + up));
            if (across == 0.0 && up == 0.0) continue;
            draw_piece();  // and on from the opposite side
            piece = {to_pixels(from.x - across, from.y - up), to_pixels(to.x, to.y)};
        }
        draw_piece();
    }
}

void GasPanel::draw_chosen(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& gas = static_cast<const GasState&>(state);
    const Mapping to_pixels = mapping(*this, dc, context_.scene.gas.box);
    std::vector<Disk> disks;  // for a name to keep clear of
    const std::size_t count = context_.in_film ? 0 : gas.x.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Point at = to_pixels(double(gas.x[i]), double(gas.y[i]));
        const double radius =
            context_.particles.radius[static_cast<Eigen::Index>(i)] * to_pixels.scale;
        disks.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                         static_cast<float>(std::max(least_radius, radius)), 0});
    }
    for (const Chosen& chosen : chosen_) {
        const auto i = static_cast<std::size_t>(chosen.particle);
        const Point place{static_cast<double>(gas.x[i]), static_cast<double>(gas.y[i])};
        const Point at = to_pixels(place.x, place.y);
        const double radius = context_.particles.radius[chosen.particle] * to_pixels.scale;
        const double line = 0.14 * dc.unit;
        for_each_image(context_.scene.gas.box, place, context_.particles.radius[chosen.particle],
                       [&](Point image) {
                           canvas.stroke_circle(to_pixels(image.x, image.y), radius + 0.5 * line,
                                                line, dc.theme.ink);
                       });

        const std::string name = single_name(context_, chosen.particle);
        if (gas.label_alpha <= 0.0F || name.empty()) continue;
        const Rect disk{at.x - radius, at.y - radius, 2.0 * radius, 2.0 * radius};
        draw_name(canvas, dc, to_pixels.box, disk, escape_markup(name),
                  static_cast<double>(gas.label_alpha), context_.in_film ? nullptr : &disks);
    }
}

}  // namespace carom
