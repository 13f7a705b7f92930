// A frame of the gas while it is drawn: what the two implementation files share. gas_drawing.cpp
// draws the box and what lies around disks, gas_disks.cpp the disks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "draw/raster/trail_lines.h"
#include "panels/gas/gas_panel.h"
#include "panels/gas/marks/view_map.h"
#include "scene/film.h"

namespace carom {

/// The shift along `axis` to the second image of a disk that reaches across a periodic side; 0 if
/// it reaches across none.
inline double image_shift(const Box& box, int axis, double at, double radius) {
    if (!box.is_periodic(axis)) return 0.0;
    if (at < radius) return box.size[axis];
    return at > box.size[axis] - radius ? -box.size[axis] : 0.0;
}

/// A frame being drawn.
struct GasPanel::Drawing {
    static constexpr double followed_line = 0.14;  ///< units: around disks with a trail, and others
    static constexpr double least_radius = 1.2;    ///< pixels: smaller disks are no longer round

    const GasPanel& panel;
    Canvas& canvas;
    const DrawContext& dc;
    const State& gas;
    const Film& film = panel.context_.film();
    const Box& box = panel.context_.box();
    const Eigen::ArrayXd& radius = gas.radii->of;  ///< NaN of a particle that is absent
    BoxMap whole = panel.map_in(dc);
    BoxMap map = gas.view ? panel.part_of(whole, *gas.view) : whole;
    Rect frame =
        gas.surfaces.empty() || gas.view ? map.frame : map.rect(panel.surfaces_.room(gas.surfaces));
    double scale = map.scale;
    std::vector<Color> colors = panel.colors_.of_shades(dc.theme);
    double least_shown = radius_in_crowd();  ///< of disks that are smaller, in pixels

    Point pixel(const Point& place) const { return map.pixel(place); }
    static Point place_of(const Eigen::ArrayXXf& all, Eigen::Index i) {
        return {static_cast<double>(all(i, 0)), static_cast<double>(all(i, 1))};
    }
    Point pixel(Eigen::Index i) const { return pixel(place_of(gas.place, i)); }
    std::size_t shade(Eigen::Index i) const {
        return gas.shades[static_cast<std::size_t>(i)] % colors.size();
    }

    /// Whether this is one of the disks below `least_radius`, if they are too many to be
    /// distinguished.
    bool is_in_crowd(Eigen::Index i) const {
        return least_shown < least_radius && radius[i] * scale < least_radius;
    }
    /// The radius of a disk that is drawn individually, in pixels.
    double shown_radius(Eigen::Index i) const { return std::max(least_radius, radius[i] * scale); }

    /// Calls `draw` with the position on the canvas of a disk, and of each periodic image that
    /// reaches into the box.
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

    /// The same for a view of a part of the box, which may extend across a periodic side.
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

    /// Calls `draw` with the shift of each periodic image of the box that may be visible.
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
    ViewMap map_of(const BoxMap& view) const;
    void draw_callouts() const;
    Rect place_of_callout(const std::vector<Callouts::Step>& steps, Eigen::Index particle,
                          const CalloutPlate& plate, std::span<const Rect> others) const;
    void draw_field() const;
    bool are_outlines() const { return gas.field || panel.context_.is_laid_over(); }
    void draw_outlines() const;
    double radius_in_crowd() const;
    template <class ColorOf>
    void draw_crowd(const Eigen::ArrayXXf& places, const ColorOf& color_of) const;
    void draw_ghosts() const;
    template <class Draw>
    void for_each_streak(Eigen::Index i, const Draw& draw) const;
    void draw_streaks() const;
    /// What disks are drawn with: the colours of the shades as they are, legible, and of rims.
    struct Inks {
        std::vector<std::uint32_t> pixels = {}, edges = {}, rims = {};
        std::uint32_t ground = 0;
        double rim = 0.0;  ///< pixels
    };
    Inks inks() const;
    bool is_deep() const { return box.dimension == 3; }
    std::vector<Eigen::Index> back_to_front(const Eigen::ArrayXXf& places) const;
    void sort_by_depth(std::vector<Eigen::Index>& order, const Eigen::ArrayXXf& places) const;
    std::uint32_t dimmed(std::uint32_t color, Eigen::Index i) const;
    void add_body(std::vector<Disk>& disks, Eigen::Index i, const Inks& its) const;
    void add_ring(std::vector<Disk>& disks, Eigen::Index i) const;
    void draw_disks() const;
    void draw_spheres(const std::vector<Eigen::Index>& order, const Inks& its) const;
    bool has_mark(Eigen::Index i) const;
    void draw_mark(Eigen::Index i) const;
    void draw_marks() const;
    void draw_arrows() const;
    bool labels_fit() const;
    void add_trail(std::vector<Taper>& tapers, std::size_t followed, Point shift) const;
    void draw_seed_paths() const;
    void draw_trails() const;
    void draw_followed() const;
    void draw_flashes() const;
    Remarks remarks() const;
};

}  // namespace carom
