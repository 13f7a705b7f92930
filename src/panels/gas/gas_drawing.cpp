// The drawing of the gas: the box, trails, labels, rings and names of disks, flashes and arrows.
#include "panels/gas/gas_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/disk_names.h"
#include "panels/gas/marks/view_map.h"
#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_strokes.h"
#include "scene/film.h"
#include "util/text.h"

namespace carom {

void GasPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    if (camera_.moves() || context_.box().dimension == 3) return;
    const BoxMap map = map_in(dc);
    if (!surfaces_.is_plain()) {
        if (surfaces_.is_still()) surfaces_.draw_room(canvas, dc, map, {});
        return;
    }
    canvas.fill(map.frame, dc.theme.ground);
    const Box& box = context_.box();
    draw_box_outline(canvas, dc, map.frame, {box.is_periodic(0), box.is_periodic(1)});
}

void GasPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    Drawing{*this, canvas, dc, static_cast<const State&>(state)}.draw();
}

// With a moving camera, all of the box changes from frame to frame.
void GasPanel::Drawing::draw_box() const {
    const SurfaceView& surfaces = panel.surfaces_;
    if (panel.context_.is_laid_over() || map.space) return;
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
    // A periodic side has no edge: a view continues beyond it.
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

// A thin frame around the view, and the map that shows its place in the box.
void GasPanel::Drawing::draw_where_it_is() const {
    const double zoom = map.scale / whole.scale;
    canvas.stroke_rect(frame, 0.07 * dc.unit, dc.theme.muted);
    Point corner{};
    if (map.space) {
        const Point before = whole.space->origin(), now = map.space->origin();
        corner = {before.x + (frame.x - now.x) / zoom, before.y + (frame.y - now.y) / zoom};
    } else {
        corner = whole.pixel({map.low[0], map.low[1] + frame.height / map.scale});
    }
    const Rect part{(corner.x - frame.x) / frame.width, (corner.y - frame.y) / frame.height,
                    1.0 / zoom, 1.0 / zoom};
    draw_view_map(canvas, dc, map_of(map), part, view_map_share(zoom), panel.context_.language());
}

ViewMap GasPanel::Drawing::map_of(const BoxMap& view) const {
    return view_map(dc, whole.frame, whole.frame.height / whole.frame.width, view.scale);
}

// The fixed place of a callout. With a moving camera it keeps clear of all places at which the
// particle is shown, of the map and of remarks.
Rect GasPanel::Drawing::place_of_callout(const std::vector<Callouts::Step>& steps,
                                         Eigen::Index particle, const CalloutPlate& plate,
                                         std::span<const Rect> others) const {
    std::vector<Point> way;
    std::vector<Rect> taken(others.begin(), others.end());
    double reach = 0.0, scale_before = 0.0;
    for (const Callouts::Step& step : steps) {
        const auto view = panel.camera_.at(static_cast<std::size_t>(step.frame));
        BoxMap then = whole;
        const Viewpoint from = panel.camera_.viewpoint_at(static_cast<std::size_t>(step.frame));
        if (then.space) then.space = then.space->seen_from(from);
        if (view) then = panel.part_of(then, *view);
        Vec at = step.at;
        if (view) at = view->middle + box.nearest(at - view->middle);
        if (scale_before != then.scale) {
            State seen;
            seen.view = view;
            seen.radii = gas.radii;
            seen.viewpoint = from;
            Drawing{panel, canvas, dc, seen}.remarks().take_places(taken);
        }
        scale_before = then.scale;
        const Perspective::Image image =
            then.space ? then.space->image(at)
                       : Perspective::Image{then.pixel({at[0], at[1]}), then.scale};
        way.push_back(image.at);
        reach = std::max(reach, radius[particle] * image.scale);
    }
    return free_place(dc, whole.frame, plate, way, reach, taken);
}

void GasPanel::Drawing::draw_callouts() const {
    const auto place = std::bind_front(&Drawing::place_of_callout, this);
    std::vector<DrawnCallout> drawn;
    for (const Callouts::Standing& its : panel.callouts_.standing(
             gas.callouts, dc, std::min(17.0 * dc.unit, 0.5 * whole.frame.width), place)) {
        const Eigen::Index particle = its.callout.particle;
        const double shown = shown_radius(particle);
        Point target = pixel(particle);  // or its image that the camera shows
        for_each_image(place_of(gas.place, particle), 0.0, [&](Point at) {
            const auto off = [&](Point to) {
                return std::hypot(to.x - frame.x - frame.width / 2,
                                  to.y - frame.y - frame.height / 2);
            };
            if (off(at) < off(target)) target = at;
        });
        drawn.push_back({its.place, its.plate, target, shown, its.callout.share});
    }
    canvas.clip_to(frame);
    carom::draw_callouts(canvas, dc, drawn);
    canvas.release_clip();
}

void GasPanel::Drawing::draw_contents() const {
    if (map.space) return draw_contents_of_space();
    const SurfaceView& surfaces = panel.surfaces_;
    canvas.clip_to(frame);
    if (gas.field) {
        draw_field();
        surfaces.draw_obstacles(canvas, dc, map, gas.surfaces);
    }
    draw_ghosts();
    draw_seed_paths();
    draw_streaks();
    surfaces.draw_partitions(canvas, dc, map, gas.surfaces);
    draw_trails();
    if (are_outlines()) {
        draw_outlines();
        draw_marks();
    } else {
        draw_disks();
    }
    draw_followed();
    draw_flashes();
    remarks().draw(canvas);
    canvas.release_clip();
    surfaces.draw_around(canvas, dc, map, gas.surfaces);
    draw_arrows();
    if (gas.ghosts)
        draw_ghost_words(canvas, dc, {frame.x, frame.y + 1.6 * dc.unit}, frame.width, *gas.ghosts,
                         gas.ghost_words);
}

// What is behind the gas, the spheres with what stands among them, what is in front of them.
void GasPanel::Drawing::draw_contents_of_space() const {
    const SurfaceView& surfaces = panel.surfaces_;
    canvas.clip_to(frame);
    if (gas.field) draw_field();
    surfaces.draw_behind(canvas, dc, map, gas.surfaces);
    draw_ghosts();
    draw_spheres();
    surfaces.draw_in_front(canvas, dc, map, gas.surfaces);
    draw_followed();
    draw_flashes();
    remarks().draw(canvas);
    canvas.release_clip();
    surfaces.draw_around(canvas, dc, map, gas.surfaces);
    if (gas.ghosts)
        draw_ghost_words(canvas, dc, {frame.x, frame.y + 1.6 * dc.unit}, frame.width, *gas.ghosts,
                         gas.ghost_words);
}

// In space it lies on the wall at the back or, if the box is seen from behind, on the front one.
void GasPanel::Drawing::draw_field() const {
    if (map.space) {
        const double depth = map.space->is_beyond(2, 0.0) ? 0.0 : box.size[2];
        const auto on_wall = [&](const Vec& at) { return map.space->at({at[0], at[1], depth}); };
        return panel.field_.draw(
            canvas, dc, *gas.field,
            [&](const Region& region) {
                const Point at = on_wall(0.5 * (region.low + region.high));
                const Vec size = scale * (region.high - region.low);
                return Rect{at.x - size[0] / 2, at.y - size[1] / 2, size[0], size[1]};
            },
            on_wall);
    }
    for_each_turn([&](Point shift) {
        panel.field_.draw(canvas, dc, *gas.field, [&](const Region& region) {
            const Vec by{shift.x, shift.y};
            return map.rect({region.low + by, region.high + by});
        });
    });
}

void GasPanel::Drawing::draw_flashes() const {
    for (const Flash& flash : gas.flashes)
        for_each_image(flash.place, flash_reach * dc.unit / scale,
                       [&](Point at) { draw_flash(canvas, dc, at, flash.share); });
}

void GasPanel::Drawing::draw_arrows() const {
    if (gas.velocity.size() == 0) return;
    ArrowField field{frame, whole.scale, {box.is_periodic(0), box.is_periodic(1)}};
    if (gas.view) field.joined = {false, false};
    canvas.clip_to(VelocityArrows::bounds(dc, field));
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        if (!panel.arrows_.is_drawn(i) || !gas.is_shown(i)) continue;
        const Vec velocity = place_of(gas.velocity, i);
        const double light = gas.light.empty() ? 1.0 : double(gas.light[std::size_t(i)]);
        const auto draw_one = [&](Point at) {
            panel.arrows_.draw(canvas, dc, field, at, radius[i] * scale,
                               {velocity[0], -velocity[1]}, dc.theme.ground, light);
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
    const Labels asked = film.labels;
    if (asked == Labels::none) return true;
    for (Eigen::Index i = 0; i < radius.size(); ++i)
        if (!std::isnan(radius[i]) &&
            fitting_words(dc, radius[i] * scale, words_on(panel.context_, i, asked)))
            return true;
    return false;
}

Color GasPanel::Drawing::ink_of_trail(std::size_t followed) const {
    const Eigen::Index particle = panel.followed_[followed].particle;
    const Color own = panel.colors_.is_of_species(gas.shades[static_cast<std::size_t>(particle)])
                          ? edge_of(colors[shade(particle)], dc.theme)
                          : dc.theme.ink;
    return gas.seen(own, particle, ground);
}

void GasPanel::Drawing::add_trail(std::vector<Taper>& tapers, std::size_t followed,
                                  Point shift) const {
    const Trail& trail = gas.trails[followed];
    const double seconds = panel.followed_[followed].trail_seconds;
    const Color ink = ink_of_trail(followed);
    const auto place = [&](std::size_t i, double across, double up) {
        const Vec& at = trail.places[i];
        const double age = static_cast<double>(trail.ages[i]) / seconds;
        return TrailPlace{pixel({at[0] + shift.x + across, at[1] + shift.y + up}),
                          1.0 - std::clamp(age, 0.0, 1.0)};
    };
    std::vector<TrailPlace> way;
    way.reserve(trail.places.size());
    for (std::size_t i = 0; i < trail.places.size(); ++i) {
        double across = 0.0, up = 0.0;
        if (i > 0) {
            // A step of more than half the box is taken to go across a periodic side.
            const Vec step = trail.places[i - 1] - trail.places[i];
            across = box.size[0] * box.turns(0, step[0]);
            up = box.size[1] * box.turns(1, step[1]);
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

// Those so far, one after the other.
void GasPanel::Drawing::draw_seed_paths() const {
    constexpr double width = 0.06, share = 0.3;  // units; of the colour of names
    const Color color = mix(dc.theme.ground, dc.theme.muted, share);
    for (const SeedPath& path : panel.seed_paths_) {
        std::vector<Point> way;
        const auto draw_way = [&] {
            if (way.size() > 1) canvas.stroke_path(way, width * dc.unit, color);
            way.clear();
        };
        for (std::size_t i = 0; i < path.time.size() && path.time[i] <= gas.time; ++i) {
            if (i > 0 && path.piece[i] != path.piece[i - 1]) draw_way();
            way.push_back(map.pixel(path.place[i]));
        }
        draw_way();
    }
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
    for (Eigen::Index i = 0; i < count; ++i) {
        if (!gas.is_shown(i)) continue;
        const Point at = pixel(i);
        disks.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                         static_cast<float>(shown_radius(i))});
    }
    for (const Spotlights::Ring& ring : gas.rings) {
        const double shown = shown_radius(ring.particle);
        const double line = followed_line * dc.unit;
        for_each_image(place_of(gas.place, ring.particle), radius[ring.particle], [&](Point at) {
            canvas.stroke_circle(at, shown + 0.5 * line, line,
                                 with_alpha(dc.theme.ink, ring.share));
        });
    }
    for (const TrailedParticle& one : panel.followed_) {
        const Eigen::Index i = one.particle;
        if (!gas.is_shown(i)) continue;
        const double shown = radius[i] * scale_at(gas.place, i), line = followed_line * dc.unit;
        if (gas.field)  // a disk was drawn with it; the other run's has it
            for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
                canvas.stroke_circle(at, shown + 0.5 * line, line, dc.theme.ink);
            });
        if (gas.label_alpha <= 0.0 || panel.context_.run_in_box) continue;  // runs have names
        const std::string name = single_name(panel.context_, i);
        if (name.empty()) continue;
        const Point at = pixel(i);
        const Rect disk{at.x - shown, at.y - shown, 2.0 * shown, 2.0 * shown};
        draw_name(canvas, dc, frame, disk, escape_markup(name), gas.label_alpha,
                  panel.context_.in_film ? nullptr : &disks);
    }
}

}  // namespace carom
