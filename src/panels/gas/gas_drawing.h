// A frame of the gas while it is drawn: what the implementation files share. gas_drawing.cpp draws
// the box and what lies around disks, gas_disks.cpp the disks, gas_spheres.cpp the spheres of a box
// in space with all that stands among them.
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
    BoxMap whole = panel.map_from(dc, gas.viewpoint);
    BoxMap map = gas.view ? panel.part_of(whole, *gas.view) : whole;
    Rect frame = gas.surfaces.empty() || gas.view || map.space
                     ? map.frame
                     : map.rect(panel.surfaces_.room(gas.surfaces));
    double scale = map.scale;
    Color ground = map.space ? dc.theme.page : dc.theme.ground;  ///< behind the particles
    std::vector<Color> colors = panel.colors_.of_shades(dc.theme);
    double least_shown = radius_in_crowd();  ///< of disks that are smaller, in pixels

    Perspective::Image image(const Vec& place) const {
        if (map.space) return map.space->image(place);
        return {map.pixel({place[0], place[1]}), scale};
    }
    Point pixel(const Vec& place) const { return image(place).at; }
    Vec place_of(const Eigen::ArrayXXf& all, Eigen::Index i) const {
        return {static_cast<double>(all(i, 0)), static_cast<double>(all(i, 1)),
                is_deep() ? static_cast<double>(all(i, 2)) : 0.0};
    }
    Point pixel(Eigen::Index i) const { return pixel(place_of(gas.place, i)); }
    /// Pixels for each unit of length where a particle is.
    double scale_at(const Eigen::ArrayXXf& all, Eigen::Index i) const {
        return map.space ? map.space->image(place_of(all, i)).scale : scale;
    }
    std::size_t shade(Eigen::Index i) const {
        return gas.shades[static_cast<std::size_t>(i)] % colors.size();
    }

    /// Whether this is one of the disks below `least_radius`, if they are too many to be
    /// distinguished.
    bool is_in_crowd(Eigen::Index i) const {
        return least_shown < least_radius && radius[i] * scale < least_radius;
    }
    /// The radius of a particle that is drawn individually, in pixels.
    double shown_radius(Eigen::Index i) const { return shown_radius(gas.place, i); }
    double shown_radius(const Eigen::ArrayXXf& all, Eigen::Index i) const {
        return std::max(least_radius, radius[i] * scale_at(all, i));
    }

    /// Calls `draw` with the position on the canvas of a disk, and of each periodic image that
    /// reaches into the box. A sphere has one image, that of its middle in the box.
    template <class Draw>
    void for_each_image(const Vec& place, double reach, const Draw& draw) const {
        if (map.space) return draw(pixel(place));
        if (gas.view) return for_each_in_view(place, reach, draw);
        const double across = image_shift(box, 0, place[0], reach);
        const double up = image_shift(box, 1, place[1], reach);
        draw(pixel(place));
        if (across != 0.0) draw(pixel({place[0] + across, place[1]}));
        if (up != 0.0) draw(pixel({place[0], place[1] + up}));
        if (across != 0.0 && up != 0.0) draw(pixel({place[0] + across, place[1] + up}));
    }

    /// The same for a view of a part of the box, which may extend across a periodic side.
    template <class Draw>
    void for_each_in_view(const Vec& place, double reach, const Draw& draw) const {
        for_each_turn([&](Point shift) {
            const Point at = pixel({place[0] + shift.x, place[1] + shift.y});
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
    void draw_contents_of_space() const;
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
    /// What disks are drawn with: the colours of the shades as they are, and legible.
    struct Inks {
        std::vector<std::uint32_t> pixels = {}, edges = {};
        std::uint32_t ground = 0;
        double rim = 0.0;  ///< pixels
    };
    Inks inks() const;
    bool is_deep() const { return box.dimension == 3; }
    std::vector<Eigen::Index> drawn_alone(const Eigen::ArrayXXf& places) const;
    std::vector<Eigen::Index> with_marks(const Eigen::ArrayXXf& places) const;
    std::uint32_t dimmed(std::uint32_t color, Eigen::Index i) const;
    void add_body(std::vector<Disk>& disks, Eigen::Index i, const Inks& its) const;
    void add_ring(std::vector<Disk>& disks, Eigen::Index i) const;
    void draw_disks() const;
    struct Spheres;
    void draw_spheres() const;
    void draw_crowd_of_spheres() const;
    Color faded(Color color, const Vec& place) const;
    void draw_arrow_of(Eigen::Index i) const;
    Color ink_of_trail(std::size_t followed) const;
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
