// The drawing of the gas: ghosts, trails, disks, their labels, rings and names, flashes and arrows.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/gas_panel.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double ring_line = 0.13;    // units
constexpr double rim_line = 0.09;     // of disks that would fade into the ground
constexpr double trail_shades = 64;   // that are hardly told apart
constexpr double least_radius = 1.2;  // pixels: smaller disks are no longer round

// How far away a disk that reaches over a periodic side is seen again; 0 if it is not.
double image_shift(const Box& box, int axis, double at, double radius) {
    if (!box.is_periodic(axis)) return 0.0;
    if (at < radius) return box.size[axis];
    return at > box.size[axis] - radius ? -box.size[axis] : 0.0;
}

std::uint32_t rgb_of(Color color) { return to_pixel(color) & 0xFFFFFF; }

// A disk of one colour, and where `inside` is positive one of another within it.
void add_disk(std::vector<Disk>& disks, Point at, float radius, std::uint32_t edge, double inside,
              std::uint32_t color) {
    const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
    disks.push_back({x, y, radius, edge});
    if (inside > 0.0) disks.push_back({x, y, static_cast<float>(inside), color});
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

// A frame being drawn.
struct GasPanel::Drawing {
    const GasPanel& panel;
    Canvas& canvas;
    const DrawContext& dc;
    const State& gas;
    const Scene& scene = panel.context_.scene;
    const Box& box = scene.gas.box;
    const Eigen::ArrayXd& radius = panel.context_.particles.radius;
    BoxMap map = panel.map_in(dc);
    Rect frame = gas.surfaces.empty() ? map.frame : map.rect(panel.surfaces_.room(gas.surfaces));
    double scale = map.scale;
    std::vector<Color> colors = panel.colors_.of_shades(dc.theme);

    Point pixel(const Point& place) const { return map.pixel(place); }
    static Point place_of(const Eigen::ArrayXXf& all, Eigen::Index i) {
        return {static_cast<double>(all(i, 0)), static_cast<double>(all(i, 1))};
    }
    Point pixel(Eigen::Index i) const { return pixel(place_of(gas.place, i)); }
    std::size_t shade(Eigen::Index i) const {
        return gas.shades[static_cast<std::size_t>(i)] % colors.size();
    }

    // Calls `draw` with the pixel of a disk and of each image of it that reaches into a periodic
    // box.
    template <class Draw>
    void for_each_image(Point place, double reach, const Draw& draw) const {
        const double across = image_shift(box, 0, place.x, reach);
        const double up = image_shift(box, 1, place.y, reach);
        draw(pixel(place));
        if (across != 0.0) draw(pixel({place.x + across, place.y}));
        if (up != 0.0) draw(pixel({place.x, place.y + up}));
        if (across != 0.0 && up != 0.0) draw(pixel({place.x + across, place.y + up}));
    }

    void draw() const;
    void draw_ghosts() const;
    void draw_disks() const;
    void draw_infinite() const;
    void draw_arrows() const;
    void draw_labels() const;
    void draw_trail(const Trail& trail, double seconds) const;
    void draw_followed() const;
    void draw_flashes() const;
    void draw_remarks() const;
};

void GasPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const BoxMap map = map_in(dc);
    if (!surfaces_.is_plain()) {
        if (surfaces_.is_still()) surfaces_.draw_room(canvas, dc, map, {});
        return;
    }
    const Rect box = map.frame;
    canvas.fill(box, dc.theme.ground);
    const double line = 0.11 * dc.unit;
    const Rect edge{box.x - line / 2, box.y - line / 2, box.width + line, box.height + line};
    canvas.stroke_rect(edge, line, dc.theme.wall);
}

void GasPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    Drawing{*this, canvas, dc, static_cast<const State&>(state)}.draw();
}

void GasPanel::Drawing::draw() const {
    const SurfaceView& surfaces = panel.surfaces_;
    if (!surfaces.is_still()) surfaces.draw_room(canvas, dc, map, gas.surfaces);
    canvas.clip_to(frame);
    draw_ghosts();
    surfaces.draw_partitions(canvas, dc, map, gas.surfaces);
    for (std::size_t k = 0; k < gas.trails.size(); ++k)
        draw_trail(gas.trails[k], panel.followed_[k].trail_seconds);
    draw_disks();
    if (scene.film.labels == Labels::none)
        draw_infinite();
    else
        draw_labels();
    draw_followed();
    draw_flashes();
    draw_remarks();
    canvas.release_clip();
    surfaces.draw_around(canvas, dc, map, gas.surfaces);
    draw_arrows();
    if (gas.ghosts)
        draw_ghost_words(canvas, dc, {frame.x + 0.3 * dc.unit, frame.y + 1.6 * dc.unit},
                         frame.width - 0.6 * dc.unit, *gas.ghosts, gas.ghost_words);
}

void GasPanel::Drawing::draw_ghosts() const {
    if (!gas.ghosts) return;
    std::vector<Disk> disks;
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const double shown = std::max(least_radius, radius[i] * scale);
        for_each_image(place_of(gas.ghosts->place, i), radius[i], [&](Point at) {
            add_disk(disks, at, static_cast<float>(shown), rgb_of(dc.theme.muted),
                     inside_ring(shown, ghost_line(dc)), rgb_of(dc.theme.ground));
        });
    }
    dc.disks.draw(canvas, disks, frame);
}

void GasPanel::Drawing::draw_disks() const {
    std::vector<std::uint32_t> pixels, edges;
    for (const Color& color : colors) {
        pixels.push_back(rgb_of(color));
        edges.push_back(rgb_of(edge_of(color, dc.theme)));
    }
    std::vector<Disk> disks;
    disks.reserve(gas.shades.size() + panel.followed_.size());
    const std::uint32_t ground = rgb_of(dc.theme.ground);
    const double line = std::max(1.5, ring_line * dc.unit);
    const double rim = std::max(2.0, rim_line * dc.unit);
    const auto add = [&](Eigen::Index i) {
        const auto shown = static_cast<float>(std::max(least_radius, radius[i] * scale));
        const std::uint32_t color = pixels[shade(i)], edge = edges[shade(i)];
        const bool is_filled = panel.is_filled(i);
        double inside = 0.0;
        if (!is_filled || edge != color)
            inside = inside_ring(static_cast<double>(shown), is_filled ? rim : line);
        for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
            add_disk(disks, at, shown, edge, inside, is_filled ? color : ground);
        });
    };
    for (Eigen::Index i = 0; i < radius.size(); ++i) add(i);
    for (const Followed& one : panel.followed_) add(one.particle);
    dc.disks.draw(canvas, disks, frame);
}

void GasPanel::Drawing::draw_infinite() const {
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        if (!panel.colors_.is_told_infinite(i) || !panel.is_filled(i)) continue;
        for_each_image(place_of(gas.place, i), radius[i],
                       [&](Point at) { draw_hatching(canvas, dc, at, radius[i] * scale); });
    }
}

void GasPanel::Drawing::draw_flashes() const {
    for (const Flash& flash : gas.flashes)
        for_each_image(flash.place, flash_reach * dc.unit / scale,
                       [&](Point at) { draw_flash(canvas, dc, at, flash.share); });
}

// Disks that are drawn larger than they are make a gas look denser than it is, and flashes that are
// left out make it look calmer.
void GasPanel::Drawing::draw_remarks() const {
    double foot = frame.bottom();
    if (draw_remark(canvas, dc, {frame.right(), foot}, frame.width, panel.flashes_.remarks()))
        foot -= 1.5 * dc.unit;
    const double smallest = radius.minCoeff();
    if (!(smallest * scale < least_radius)) return;
    const double largest = (radius * scale < least_radius).select(radius, smallest).maxCoeff();
    std::vector<std::string> words{"disks drawn larger than their radius of " +
                                   three_digits(smallest)};
    if (largest > smallest)
        words = {"disks drawn larger than their radii of " + three_digits(smallest) + " to " +
                 three_digits(largest)};
    words.emplace_back("disks drawn larger than they are");
    draw_remark(canvas, dc, {frame.right(), foot}, frame.width, words);
}

void GasPanel::Drawing::draw_arrows() const {
    if (gas.velocity.size() == 0) return;
    const ArrowField field{frame, scale, {box.is_periodic(0), box.is_periodic(1)}};
    canvas.clip_to(VelocityArrows::bounds(dc, field));
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const Point velocity = place_of(gas.velocity, i);
        panel.arrows_.draw(canvas, dc, field, pixel(i), radius[i] * scale,
                           {velocity.x, -velocity.y}, dc.theme.ground);
    }
    canvas.release_clip();
}

void GasPanel::Drawing::draw_labels() const {
    for (Eigen::Index i = 0; i < radius.size(); ++i)
        draw_words_on(canvas, dc, pixel(i), radius[i] * scale,
                      words_on(panel.context_, i, scene.film.labels),
                      panel.is_filled(i) ? colors[shade(i)] : dc.theme.ground);
}

// In pieces of one strength, whose round ends lie over one another: steps with square ends of their
// own would show as ribs where they are short, and as notches where the path turns.
void GasPanel::Drawing::draw_trail(const Trail& trail, double seconds) const {
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
        const double age = static_cast<double>(trail.ages[i]) / seconds;
        const double now =
            std::round((1.0 - std::clamp(age, 0.0, 1.0)) * trail_shades) / trail_shades;
        if (now != strength) draw_piece();
        strength = now;
        if (piece.empty()) piece.push_back(pixel(from));
        // A step goes through a periodic side rather than through more than half the box.
        const double across = box.size[0] * box.turns(0, from.x - to.x);
        const double up = box.size[1] * box.turns(1, from.y - to.y);
        piece.push_back(pixel({to.x + across, to.y + up}));
        if (across == 0.0 && up == 0.0) continue;
        draw_piece();  // and on from the opposite side
        piece = {pixel({from.x - across, from.y - up}), pixel(to)};
    }
    draw_piece();
}

void GasPanel::Drawing::draw_followed() const {
    std::vector<Disk> disks;  // for a name to keep clear of
    const Eigen::Index count = panel.context_.in_film ? 0 : radius.size();
    for (Eigen::Index i = 0; i < count; ++i)
        add_disk(disks, pixel(i), static_cast<float>(std::max(least_radius, radius[i] * scale)), 0,
                 0.0, 0);
    for (const Followed& one : panel.followed_) {
        const Eigen::Index i = one.particle;
        const double shown = radius[i] * scale, line = 0.14 * dc.unit;
        for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
            canvas.stroke_circle(at, shown + 0.5 * line, line, dc.theme.ink);
        });
        const std::string name = single_name(panel.context_, i);
        if (gas.label_alpha <= 0.0 || name.empty()) continue;
        const Point at = pixel(i);
        const Rect disk{at.x - shown, at.y - shown, 2.0 * shown, 2.0 * shown};
        draw_name(canvas, dc, frame, disk, escape_markup(name), gas.label_alpha,
                  panel.context_.in_film ? nullptr : &disks);
    }
}

}  // namespace carom
