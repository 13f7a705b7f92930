// The drawing of the gas: ghosts, trails, disks, their labels, rings and names, flashes and arrows.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "draw/raster/trail_lines.h"
#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/disk_names.h"
#include "panels/gas/gas_panel.h"
#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_strokes.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double followed_line = 0.14;  // units: around disks with a trail, and others
constexpr double rim_line = 0.09;       // of disks that would fade into the ground
constexpr double least_radius = 1.2;    // pixels: smaller disks are no longer round

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
    BoxMap whole = panel.map_in(dc);
    BoxMap map = gas.view ? panel.part_of(whole, *gas.view) : whole;
    Rect frame =
        gas.surfaces.empty() || gas.view ? map.frame : map.rect(panel.surfaces_.room(gas.surfaces));
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
        if (gas.view) return for_each_in_view(place, reach, draw);
        const double across = image_shift(box, 0, place.x, reach);
        const double up = image_shift(box, 1, place.y, reach);
        draw(pixel(place));
        if (across != 0.0) draw(pixel({place.x + across, place.y}));
        if (up != 0.0) draw(pixel({place.x, place.y + up}));
        if (across != 0.0 && up != 0.0) draw(pixel({place.x + across, place.y + up}));
    }

    // The same in a part of the box, which may lie across a periodic side.
    template <class Draw>
    void for_each_in_view(Point place, double reach, const Draw& draw) const {
        for_each_turn([&](Point shift) {
            const Point at = pixel({place.x + shift.x, place.y + shift.y});
            const double around = reach * scale + dc.unit;
            if (at.x > frame.x - around && at.x < frame.right() + around &&
                at.y > frame.y - around && at.y < frame.bottom() + around)
                draw(at);
        });
    }

    // With the shift of each image of the box that may be seen.
    template <class Draw>
    void for_each_turn(const Draw& draw) const {
        const int across = gas.view && box.is_periodic(0), up = gas.view && box.is_periodic(1);
        for (int i = -across; i <= across; ++i)
            for (int k = -up; k <= up; ++k) draw(Point{i * box.size[0], k * box.size[1]});
    }

    void draw() const;
    void draw_box() const;
    void draw_contents() const;
    void draw_where_it_is() const;
    void draw_callouts() const;
    void draw_field() const;
    void draw_outlines() const;
    void draw_ghosts() const;
    void draw_disks() const;
    void draw_infinite() const;
    void draw_arrows() const;
    bool labels_fit() const;
    void draw_labels() const;
    void add_trail(std::vector<Taper>& tapers, std::size_t followed, Point shift) const;
    void draw_trails() const;
    void draw_followed() const;
    void draw_flashes() const;
    void draw_remarks() const;
};

void GasPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    if (camera_.moves()) return;
    const BoxMap map = map_in(dc);
    if (!surfaces_.is_plain()) {
        if (surfaces_.is_still()) surfaces_.draw_room(canvas, dc, map, {});
        return;
    }
    canvas.fill(map.frame, dc.theme.ground);
    const Box& box = context_.scene.gas.box;
    draw_box_outline(canvas, dc, map.frame, {box.is_periodic(0), box.is_periodic(1)});
}

void GasPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    Drawing{*this, canvas, dc, static_cast<const State&>(state)}.draw();
}

// Where the camera moves, all of the box changes.
void GasPanel::Drawing::draw_box() const {
    const SurfaceView& surfaces = panel.surfaces_;
    if (!panel.camera_.moves()) {
        if (!surfaces.is_still()) surfaces.draw_room(canvas, dc, map, gas.surfaces);
        return;
    }
    if (gas.view) canvas.fill(frame, dc.theme.page);
    if (!surfaces.is_plain()) return surfaces.draw_room(canvas, dc, map, gas.surfaces);
    Rect inside = map.rect({{0.0, 0.0}, box.size});
    const std::array<bool, 2> joined{box.is_periodic(0), box.is_periodic(1)};
    if (!gas.view) {
        canvas.fill(inside, dc.theme.ground);
        return draw_box_outline(canvas, dc, inside, joined);
    }
    // A joined side lies anywhere: a view goes on beyond it.
    const double line = SurfaceSize::line * dc.unit;
    if (joined[0]) inside.x = frame.x - line, inside.width = frame.width + 2.0 * line;
    if (joined[1]) inside.y = frame.y - line, inside.height = frame.height + 2.0 * line;
    canvas.fill(inside, dc.theme.ground);
    draw_box_outline(canvas, dc, inside, {false, false});
}

void GasPanel::Drawing::draw() const {
    if (gas.view) canvas.clip_to(frame);
    draw_box();
    draw_contents();
    if (gas.view) {
        canvas.release_clip();
        draw_where_it_is();
    }
    draw_callouts();
}

// A thin line around what is seen, and where that is in the box.
void GasPanel::Drawing::draw_where_it_is() const {
    const double zoom = map.scale / whole.scale;
    const double share = std::clamp(std::log(zoom) / std::log(1.3), 0.0, 1.0);
    canvas.stroke_rect(frame, 0.07 * dc.unit, dc.theme.muted);
    const Point corner = whole.pixel({map.low[0], map.low[1] + frame.height / map.scale});
    const Rect part{(corner.x - frame.x) / frame.width, (corner.y - frame.y) / frame.height,
                    1.0 / zoom, 1.0 / zoom};
    draw_where(canvas, dc, frame, part, frame.height / frame.width, map.scale, share,
               panel.context_.language());
}

// The words stand still; where the camera moves they keep clear of where it shows the particle.
void GasPanel::Drawing::draw_callouts() const {
    std::vector<Rect> taken;
    for (const Callouts::Present& one : gas.callouts) {
        std::vector<Point> way;
        double reach = 0.0;
        for (const Callouts::Step& step : panel.callouts_.way(one)) {
            const auto view = panel.camera_.at(static_cast<std::size_t>(step.frame));
            const BoxMap then = view ? panel.part_of(whole, *view) : whole;
            way.push_back(then.pixel({step.x, step.y}));
            reach = std::max(reach, radius[one.particle] * then.scale);
        }
        const CalloutPlate plate = callout_plate(dc, panel.callouts_.words(one),
                                                 std::min(17.0 * dc.unit, 0.5 * frame.width));
        taken.push_back(free_place(dc, whole.frame, plate, way, reach, taken));
        const double shown = std::max(least_radius, radius[one.particle] * scale);
        Point target = pixel(one.particle);  // or its image that the camera shows
        for_each_image(place_of(gas.place, one.particle), 0.0, [&](Point at) {
            const auto off = [&](Point to) {
                return std::hypot(to.x - frame.x - frame.width / 2,
                                  to.y - frame.y - frame.height / 2);
            };
            if (off(at) < off(target)) target = at;
        });
        canvas.clip_to(frame);
        draw_callout(canvas, dc, taken.back(), plate, target, shown, one.share);
        canvas.release_clip();
    }
}

void GasPanel::Drawing::draw_contents() const {
    const SurfaceView& surfaces = panel.surfaces_;
    canvas.clip_to(frame);
    if (gas.field) {
        draw_field();
        surfaces.draw_obstacles(canvas, dc, map, gas.surfaces);
    }
    draw_ghosts();
    surfaces.draw_partitions(canvas, dc, map, gas.surfaces);
    draw_trails();
    gas.field ? draw_outlines() : draw_disks();
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

void GasPanel::Drawing::draw_field() const {
    for_each_turn([&](Point shift) {
        panel.field_.draw(canvas, dc, *gas.field, [&](const Region& region) {
            const Eigen::Array2d by{shift.x, shift.y};
            return map.rect({region.low + by, region.high + by});
        });
    });
}

// Nothing is hidden of what they lie over.
void GasPanel::Drawing::draw_outlines() const {
    const double line = std::max(1.0, 0.08 * dc.unit);
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const Color color = gas.seen(edge_of(colors[shade(i)], dc.theme), i, dc.theme.ground);
        const double shown = std::max(least_radius, radius[i] * scale);
        for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
            if (shown < 2.0 * line)
                canvas.fill_circle(at, shown, color);
            else
                canvas.stroke_circle(at, shown - 0.5 * line, line, color);
        });
    }
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
    const auto dimmed = [&](std::uint32_t color, Eigen::Index i) {
        return gas.light.empty() ? color : rgb_of(gas.seen(rgb(color), i, dc.theme.ground));
    };
    const double rim = std::max(2.0, rim_line * dc.unit);
    const auto add = [&](Eigen::Index i) {
        const auto shown = static_cast<float>(std::max(least_radius, radius[i] * scale));
        const std::uint32_t color = dimmed(pixels[shade(i)], i), edge = dimmed(edges[shade(i)], i);
        const bool is_filled = panel.is_filled(i);
        double inside = 0.0;
        if (!is_filled || edge != color)
            inside = inside_ring(double{shown}, is_filled ? rim : ring_line(shown, dc.unit));
        for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
            add_disk(disks, at, shown, edge, inside, is_filled ? color : ground);
        });
    };
    for (Eigen::Index i = 0; i < radius.size(); ++i) add(i);
    for (const Followed& one : panel.followed_) {
        const double ring = radius[one.particle] * scale + followed_line * dc.unit;
        for_each_image(place_of(gas.place, one.particle), radius[one.particle], [&](Point at) {
            add_disk(disks, at, static_cast<float>(ring), rgb_of(dc.theme.ink), 0.0, 0);
        });
        add(one.particle);
    }
    dc.disks.draw(canvas, disks, frame);
}

void GasPanel::Drawing::draw_infinite() const {
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        if (!panel.colors_.is_told_infinite(i) || !panel.is_disk(i)) continue;
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
// left out make it look calmer. Labels that have no room are not forgotten.
void GasPanel::Drawing::draw_remarks() const {
    double foot = frame.bottom();
    if (draw_remark(canvas, dc, {frame.right(), foot}, frame.width, panel.flashes_.remarks()))
        foot -= 1.5 * dc.unit;
    if (!labels_fit() &&
        draw_remark(canvas, dc, {frame.right(), foot}, frame.width,
                    {say(panel.context_.language(), "No room for labels on the disks")}))
        foot -= 1.5 * dc.unit;
    const double smallest = radius.minCoeff();
    if (!(smallest * scale < least_radius)) return;
    const double largest = (radius * scale < least_radius).select(radius, smallest).maxCoeff();
    const Language language = panel.context_.language();
    const std::string low = three_digits(language, smallest),
                      high = three_digits(language, largest);
    std::vector<std::string> words{
        largest > smallest
            ? say(language, "Disks enlarged for visibility; radii {} to {}", low, high)
            : say(language, "Disks enlarged for visibility; radius {}", low)};
    words.push_back(say(language, "Disks enlarged for visibility"));
    draw_remark(canvas, dc, {frame.right(), foot}, frame.width, words);
}

void GasPanel::Drawing::draw_arrows() const {
    if (gas.velocity.size() == 0) return;
    ArrowField field{frame, whole.scale, {box.is_periodic(0), box.is_periodic(1)}};
    if (gas.view) field.joined = {false, false};
    canvas.clip_to(VelocityArrows::bounds(dc, field));
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        if (!panel.arrows_.is_drawn(i)) continue;
        const Point velocity = place_of(gas.velocity, i);
        const double light = gas.light.empty() ? 1.0 : double(gas.light[std::size_t(i)]);
        const auto draw_one = [&](Point at) {
            panel.arrows_.draw(canvas, dc, field, at, radius[i] * scale, {velocity.x, -velocity.y},
                               dc.theme.ground, light);
        };
        if (gas.view)
            for_each_in_view(place_of(gas.place, i), radius[i], draw_one);
        else
            draw_one(pixel(i));
    }
    canvas.release_clip();
}

// Whether any of the disks has the label that is asked for.
bool GasPanel::Drawing::labels_fit() const {
    const Labels asked = scene.film.labels;
    if (asked == Labels::none) return true;
    for (Eigen::Index i = 0; i < radius.size(); ++i)
        if (fitting_words(dc, radius[i] * scale, words_on(panel.context_, i, asked))) return true;
    return false;
}

void GasPanel::Drawing::draw_labels() const {
    for (Eigen::Index i = 0; i < radius.size(); ++i)
        draw_words_on(
            canvas, dc, pixel(i), radius[i] * scale, words_on(panel.context_, i, scene.film.labels),
            panel.is_disk(i) ? gas.seen(colors[shade(i)], i, dc.theme.ground) : dc.theme.ground);
}

void GasPanel::Drawing::add_trail(std::vector<Taper>& tapers, std::size_t followed,
                                  Point shift) const {
    const Trail& trail = gas.trails[followed];
    const auto [particle, seconds] = panel.followed_[followed];
    const Color own = panel.colors_.is_of_species(gas.shades[static_cast<std::size_t>(particle)])
                          ? edge_of(colors[shade(particle)], dc.theme)
                          : dc.theme.ink;
    const Color ink = gas.seen(own, particle, dc.theme.ground);
    const auto place = [&](std::size_t i, double across, double up) {
        const Point& at = trail.places[i];
        const double age = static_cast<double>(trail.ages[i]) / seconds;
        return TrailPlace{pixel({at.x + shift.x + across, at.y + shift.y + up}),
                          1.0 - std::clamp(age, 0.0, 1.0)};
    };
    std::vector<TrailPlace> way;
    way.reserve(trail.places.size());
    for (std::size_t i = 0; i < trail.places.size(); ++i) {
        double across = 0.0, up = 0.0;
        if (i > 0) {
            // A step goes through a periodic side rather than through more than half the box.
            const Point &from = trail.places[i - 1], &to = trail.places[i];
            across = box.size[0] * box.turns(0, from.x - to.x);
            up = box.size[1] * box.turns(1, from.y - to.y);
        }
        if (across != 0.0 || up != 0.0) {
            way.push_back(place(i, across, up));
            add_trail_lines(tapers, way, dc.theme.ground, ink, dc.unit);
            way = {place(i - 1, -across, -up)};  // and on from the opposite side
        }
        way.push_back(place(i, 0.0, 0.0));
    }
    add_trail_lines(tapers, way, dc.theme.ground, ink, dc.unit);
}

void GasPanel::Drawing::draw_trails() const {
    std::vector<Taper> tapers;
    for (std::size_t k = 0; k < gas.trails.size(); ++k)
        for_each_turn([&](Point shift) { add_trail(tapers, k, shift); });
    draw_tapers(canvas, tapers, frame);
}

void GasPanel::Drawing::draw_followed() const {
    std::vector<Disk> disks;  // for a name to keep clear of
    const Eigen::Index count = panel.context_.in_film ? 0 : radius.size();
    for (Eigen::Index i = 0; i < count; ++i)
        add_disk(disks, pixel(i), static_cast<float>(std::max(least_radius, radius[i] * scale)), 0,
                 0.0, 0);
    for (const Spotlights::Ring& ring : gas.rings) {
        const double shown = std::max(least_radius, radius[ring.particle] * scale);
        const double line = followed_line * dc.unit;
        for_each_image(place_of(gas.place, ring.particle), radius[ring.particle], [&](Point at) {
            canvas.stroke_circle(at, shown + 0.5 * line, line,
                                 with_alpha(dc.theme.ink, ring.share));
        });
    }
    for (const Followed& one : panel.followed_) {
        const Eigen::Index i = one.particle;
        const double shown = radius[i] * scale, line = followed_line * dc.unit;
        if (gas.field)  // else it was drawn with the disk
            for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
                canvas.stroke_circle(at, shown + 0.5 * line, line, dc.theme.ink);
            });
        if (gas.label_alpha <= 0.0) continue;
        const std::string name = single_name(panel.context_, i);
        if (name.empty()) continue;
        const Point at = pixel(i);
        const Rect disk{at.x - shown, at.y - shown, 2.0 * shown, 2.0 * shown};
        draw_name(canvas, dc, frame, disk, escape_markup(name), gas.label_alpha,
                  panel.context_.in_film ? nullptr : &disks);
    }
}

}  // namespace carom
