// A frame of the surfaces of a box while it is drawn: what the implementation files share.
// surface_drawing.cpp draws sides, partitions and obstacles of a plane, surfaces_in_space.cpp those
// of a box in space, surface_labels.cpp the words about them.
#pragma once

#include <string>
#include <vector>

#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_view.h"
#include "physics/gas.h"
#include "physics/surfaces/behaviours.h"

namespace carom {

// A frame being drawn.
struct SurfaceView::Brush {
    static constexpr double hatch_apart = 0.55;  // units

    const SurfaceView& view;
    Canvas& canvas;
    const DrawContext& dc;
    const BoxMap& map;
    const std::vector<SurfaceState>& states;
    const Box& box = view.gas_.box;
    const Theme& theme = dc.theme;
    double u = dc.unit;
    Rect room = map.rect(view.room(states));

    struct SurfaceLabel {
        double middle;
        std::string words;
        bool is_of_side = false;
        Color color = {};
    };

    struct SideLabel {
        std::string words;
        bool has_arrow = false;
        double shift = 0.0;  // of the arrow from the middle to the left, and of the words with it
    };

    const Behaviour& behaviour(std::size_t k) const { return states[k].behaviour; }
    bool is_imposed(std::size_t k) const { return driven_of(behaviour(k)) || states[k].is_held; }

    // Of a side, outside of the room, in units.
    double thickness(std::size_t side) const { return thickness_of_side(behaviour(side)); }

    Color bath_color(const Bath& bath) const { return view.bath_color(bath.temperature, theme); }

    // In the direction in which it grows along an axis, on the picture.
    Point upwards(int axis) const { return axis == 0 ? Point{1.0, 0.0} : Point{0.0, -1.0}; }

    Color fill_of_obstacle() const { return mix(theme.ground, theme.wall, 0.3); }
    double length_of_unit() const { return u / map.scale; }
    Color fill_of_sheet(std::size_t k, double opacity) const;
    void draw_edges(bool in_front) const;
    void draw_walls(bool in_front) const;
    void draw_sheet(std::size_t k, std::size_t axis, double at, const Region& part,
                    double opacity) const;
    void draw_border(std::size_t k, const Vec& corner, const Vec& along, const Vec& inward) const;
    void draw_block_in_space(const Obstacle::Cuboid& block) const;
    void draw_ball_in_space(const Obstacle::Ball& ball) const;
    void draw_arrow_in_space(std::size_t k) const;
    void draw_names_of_axes() const;
    Rect outside(std::size_t side, double offset, double depth) const;
    void draw_outline() const;
    void draw_obstacle(const Obstacle& obstacle, Point shift) const;
    void draw_images(const Obstacle& obstacle) const;
    void draw_obstacles() const;
    void draw_side(std::size_t side) const;
    void draw_bar(std::size_t side) const;
    void draw_side_arrow(std::size_t side) const;
    SideLabel label_beside(std::size_t side) const;
    void draw_side_label(std::size_t side) const;
    void draw_line(Point from, Point to, std::size_t k) const;
    void draw_partition(std::size_t k) const;
    void draw_ends(std::size_t k) const;
    bool has_block(std::size_t k) const;
    void draw_block(const Rect& block, std::size_t k) const;
    std::string words_in_space(std::size_t k) const;
    double row_over_side(double from, double to) const;
    Color label_color(std::size_t k) const;
    void draw_labels() const;
    void draw_gravity() const;
};

}  // namespace carom
