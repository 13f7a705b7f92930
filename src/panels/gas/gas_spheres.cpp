// The spheres of a gas in space, in perspective, with all that stands among them: obstacles,
// partitions, trails and arrows. Drawn from the back to the front: of two spheres, that with the
// smaller power of the eye is in front (Perspective::power); what is beyond a partition is behind
// it; a cuboid hides what is beyond those of its faces that the eye does not see.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "panels/gas/gas_drawing.h"

namespace carom {
namespace {

constexpr double most_faded = 0.5;  // toward the page: of what is farthest back
constexpr int fades = 32;           // steps: two of them can hardly be told apart

using Body = SurfaceView::Body;
using Sheet = SurfaceView::Sheet;

const Obstacle::Cuboid& block_of(const Body& body) {
    return std::get<Obstacle::Cuboid>(body.obstacle->shape);
}

Vec middle_of(const Obstacle::Cuboid& block) { return 0.5 * (block.low + block.high); }

// Whether a place outside of a cuboid is on the eye's side of the face plane that it is farthest
// beyond.
bool is_before(const Vec& place, const Obstacle::Cuboid& block, const Perspective& seen) {
    std::size_t axis = 0;
    double farthest = -1.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double beyond = std::max(block.low[k] - place[k], place[k] - block.high[k]);
        if (k == 0 || beyond > farthest) axis = k, farthest = beyond;
    }
    return place[axis] > middle_of(block)[axis] ? seen.is_beyond(axis, block.high[axis])
                                                : !seen.is_beyond(axis, block.low[axis]);
}

}  // namespace

struct GasPanel::Drawing::Spheres {
    /// A sphere, a piece of a trail or a spherical obstacle, by its number.
    enum class Kind : std::uint8_t { sphere, trail, ball };
    struct Item {
        double power;
        Vec at;
        std::uint32_t number;
        Kind kind;
    };

    explicit Spheres(const Drawing& drawing) : d(drawing), seen(*drawing.map.space) {
        is_flat = d.dc.theme.kind == ThemeKind::print;
        inks.assign(d.colors.size() * fades, unknown);
    }

    void draw() {
        std::vector<Item> items;
        for (const Eigen::Index i : d.with_marks(d.gas.place)) {
            const Vec at = d.place_of(d.gas.place, i);
            items.push_back(
                {seen.power(at, d.radius[i]), at, static_cast<std::uint32_t>(i), Kind::sphere});
        }
        add_trails(items);
        std::vector<Body> blocks;
        for (const Body& body : d.panel.surfaces_.bodies()) {
            bodies.push_back(body);
            if (const auto* ball = std::get_if<Obstacle::Ball>(&body.obstacle->shape))
                items.push_back({seen.power(ball->center, ball->radius), ball->center,
                                 static_cast<std::uint32_t>(bodies.size() - 1), Kind::ball});
            else
                blocks.push_back(body);
        }
        std::ranges::sort(items, {}, [](const Item& item) {
            return std::tuple(-item.power, item.kind, item.number);
        });
        draw(items, d.panel.surfaces_.sheets(d.gas.surfaces), std::move(blocks),
             d.panel.surfaces_.room(d.gas.surfaces));
        flush();
    }

  private:
    static constexpr std::uint32_t unknown = 0xFFFFFFFF;

    // A partition divides what lies in a part of the box into what is behind it and the rest.
    void draw(std::span<Item> items, std::vector<Sheet> sheets, std::vector<Body> blocks,
              const Region& part) {
        if (sheets.empty()) return draw(items, std::move(blocks));
        const Sheet sheet = sheets.back();
        sheets.pop_back();
        const std::size_t axis = sheet.axis;
        if (sheet.at < part.low[axis] || sheet.at > part.high[axis])
            return draw(items, std::move(sheets), std::move(blocks), part);
        const bool eye_is_beyond = seen.is_beyond(axis, sheet.at);
        const auto is_behind = [&](const Vec& at) {
            return (at[axis] > sheet.at) != eye_is_beyond;
        };
        const auto middle = std::stable_partition(
            items.begin(), items.end(), [&](const Item& item) { return is_behind(item.at); });
        const auto count = static_cast<std::size_t>(middle - items.begin());
        Region low = part, high = part;
        low.high[axis] = high.low[axis] = sheet.at;
        const auto blocks_there = [&](bool behind) {
            std::vector<Body> some;
            for (const Body& body : blocks)
                if (is_behind(middle_of(block_of(body))) == behind) some.push_back(body);
            return some;
        };
        draw(items.first(count), sheets, blocks_there(true), eye_is_beyond ? low : high);
        flush();
        d.panel.surfaces_.draw_sheet(d.canvas, d.dc, d.map, d.gas.surfaces, sheet, part);
        draw(items.subspan(count), std::move(sheets), blocks_there(false),
             eye_is_beyond ? high : low);
    }

    void draw(std::span<Item> items, std::vector<Body> blocks) {
        if (blocks.empty()) {
            for (const Item& item : items) draw(item);
            return;
        }
        const Body body = blocks.back();
        blocks.pop_back();
        const Obstacle::Cuboid& block = block_of(body);
        const auto is_behind = [&](const Vec& at) { return !is_before(at, block, seen); };
        const auto middle = std::stable_partition(
            items.begin(), items.end(), [&](const Item& item) { return is_behind(item.at); });
        const auto count = static_cast<std::size_t>(middle - items.begin());
        const auto first_before = std::stable_partition(
            blocks.begin(), blocks.end(),
            [&](const Body& other) { return is_behind(middle_of(block_of(other))); });
        std::vector<Body> before(first_before, blocks.end());
        blocks.erase(first_before, blocks.end());
        draw(items.first(count), std::move(blocks));
        flush();
        d.panel.surfaces_.draw_body(d.canvas, d.dc, d.map, body);
        draw(items.subspan(count), std::move(before));
    }

    void draw(const Item& item) {
        switch (item.kind) {
            case Kind::sphere:
                return draw_sphere(static_cast<Eigen::Index>(item.number));
            case Kind::trail:
                flush(Batch::tapers);
                tapers.push_back(trail[item.number]);
                return;
            case Kind::ball:
                flush();
                return d.panel.surfaces_.draw_body(d.canvas, d.dc, d.map, bodies[item.number]);
        }
    }

    // With the ring around it if it has a trail, with what is written on it and its arrow.
    void draw_sphere(Eigen::Index i) {
        const GasPanel& panel = d.panel;
        if (d.are_outlines()) return;
        if (!panel.trail_of_.empty() && panel.trail_of_[static_cast<std::size_t>(i)] >= 0) {
            flush(Batch::flat);
            d.add_ring(disks, i);
        }
        const double shown = d.shown_radius(i);
        const Point at = d.pixel(i);
        const std::uint32_t color = d.dimmed(ink(i), i);
        const bool is_filled = panel.is_filled(i, d.gas);
        const auto add = [&](double radius, std::uint32_t its) {
            disks.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                             static_cast<float>(radius), its});
        };
        if (is_filled && !is_flat) {
            flush(Batch::lit);
            add(shown, color);
        } else {
            flush(Batch::flat);
            const double line =
                is_filled ? std::max(1.5, 0.09 * d.dc.unit) : ring_line(shown, d.dc.unit);
            // Against others of its own grey: light around a dark one, and dark around a light one.
            const Color edge = is_filled ? letters_on(rgb(color), d.dc.theme) : rgb(color);
            add(shown, to_pixel(edge) & 0xFFFFFF);
            if (shown > 2.0 * line) add(shown - line, is_filled ? color : page());
        }
        if (d.has_mark(i)) {
            flush();
            d.draw_mark(i);
        }
        if (d.gas.velocity.size() > 0 && panel.arrows_.is_drawn(i)) {
            flush();
            d.draw_arrow_of(i);
        }
    }

    std::uint32_t page() const { return to_pixel(d.ground) & 0xFFFFFF; }

    // The colour of a sphere at its depth.
    std::uint32_t ink(Eigen::Index i) {
        const double depth = seen.depth(d.place_of(d.gas.place, i));
        const auto step = static_cast<std::size_t>(std::lround(depth * (fades - 1)));
        std::uint32_t& its = inks[d.shade(i) * fades + step];
        if (its == unknown)
            its = to_pixel(mix(d.colors[d.shade(i)], d.ground,
                               most_faded * static_cast<double>(step) / (fades - 1))) &
                  0xFFFFFF;
        return its;
    }

    // The pieces of trails, from each place to the next. A step of more than half the box is taken
    // to go across a periodic side.
    void add_trails(std::vector<Item>& items) {
        for (std::size_t k = 0; k < d.gas.trails.size(); ++k) {
            const Trail& its = d.gas.trails[k];
            const double seconds = d.panel.followed_[k].trail_seconds;
            const Color color = d.ink_of_trail(k);
            const auto place = [&](std::size_t i) {
                return TrailPlace{
                    seen.at(its.places[i]),
                    1.0 - std::clamp(static_cast<double>(its.ages[i]) / seconds, 0.0, 1.0)};
            };
            for (std::size_t i = 1; i < its.places.size(); ++i) {
                const Vec step = its.places[i - 1] - its.places[i];
                if (!on_each_axis(3,
                                  [&](int axis) { return d.box.turns(axis, step[axis]) == 0.0; }))
                    continue;
                const Vec middle = 0.5 * (its.places[i - 1] + its.places[i]);
                const std::size_t before = trail.size();
                add_trail_lines(trail, std::array{place(i - 1), place(i)}, d.ground,
                                d.faded(color, middle), d.dc.unit);
                for (std::size_t piece = before; piece < trail.size(); ++piece)
                    items.push_back({seen.power(middle, 0.0), middle,
                                     static_cast<std::uint32_t>(piece), Kind::trail});
            }
        }
    }

    // What is drawn together: flush() draws what has gathered, if it is of another sort.
    enum class Batch { none, lit, flat, tapers };

    void flush(Batch next = Batch::none) {
        if (next == batch && next != Batch::none) return;
        if (batch == Batch::lit) d.dc.disks.draw_lit(d.canvas, disks, d.frame);
        if (batch == Batch::flat) d.dc.disks.draw(d.canvas, disks, d.frame);
        if (batch == Batch::tapers) draw_tapers(d.canvas, tapers, d.frame);
        disks.clear();
        tapers.clear();
        batch = next;
    }

    const Drawing& d;
    const Perspective& seen;
    bool is_flat = false;
    std::vector<std::uint32_t> inks;  // of each shade at each step of depth
    std::vector<Taper> trail;
    std::vector<Body> bodies;
    Batch batch = Batch::none;
    std::vector<Disk> disks;
    std::vector<Taper> tapers;
};

// Spheres of the crowd are drawn below all others, except those with a ring, a callout or a trail.
void GasPanel::Drawing::draw_spheres() const {
    if (are_outlines()) {
        draw_outlines();
        draw_marks();
    } else {
        draw_crowd_of_spheres();
    }
    Spheres(*this).draw();
}

// What is at a place fades toward the page with its depth.
Color GasPanel::Drawing::faded(Color color, const Vec& place) const {
    return mix(color, ground, most_faded * map.space->depth(place));
}

// In the direction in which the sphere moves in the picture.
void GasPanel::Drawing::draw_arrow_of(Eigen::Index i) const {
    const Vec at = place_of(gas.place, i);
    const Perspective::Image its = map.space->image(at);
    const double light = gas.light.empty() ? 1.0 : double(gas.light[std::size_t(i)]);
    panel.arrows_.draw(canvas, dc, {frame, its.scale * whole.scale / scale, {}}, its.at,
                       radius[i] * its.scale, map.space->velocity(at, place_of(gas.velocity, i)),
                       ground, light);
}

}  // namespace carom
