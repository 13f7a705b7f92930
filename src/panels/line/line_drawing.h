// The state while a line is drawn, shared by line_drawing.cpp and line_overlays.cpp only.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "panels/chosen.h"
#include "panels/gas/marks/view_map.h"
#include "panels/line/line_panel.h"

namespace carom {

inline constexpr double rod_half_height = 1.3;  // units

// The layout of the picture, in pixels.
struct LinePanel::View {
    Rect plot;         // of the world lines
    double line_y;     // the height of the line
    double scale;      // pixels per unit length
    double low;        // the place at the left end
    Scale time;        // time before now
    bool has_lines;    // there is room for world lines
    bool rods;         // beads of true length are drawn as rods, else as disks
    bool larger_rods;  // the same for beads drawn larger than they are
    double zoom = 1.0;
    double longest, longest_larger;  // of both kinds of beads, pixels
    double x(double place) const { return plot.x + (place - low) * scale; }
};

// A picture being drawn.
struct LinePanel::Drawing {
    const LinePanel& panel;
    Canvas& canvas;
    const DrawContext& dc;
    const State& now;
    View v = panel.view(dc, now);
    double u = dc.unit;
    const PanelContext& context = panel.context_;
    const LineMap& map = *panel.map_;
    bool is_ring = panel.is_ring();
    std::vector<Color> colors = panel.colors_.of_shades(dc.theme);

    Eigen::Index count() const { return context.particles.count(); }
    double place(Eigen::Index i) const { return static_cast<double>(now.place(i, 0)); }
    Color color_of(std::uint16_t shade) const { return colors[shade % colors.size()]; }
    Color color(Eigen::Index i) const {
        return now.seen(color_of(now.shades[static_cast<std::size_t>(i)]), i, dc.theme.page);
    }
    bool is_rod(Eigen::Index i) const { return map.is_true(i) ? v.rods : v.larger_rods; }

    // Small beads have a least radius; it is larger for beads that the film is about and for
    // points.
    double shown_radius(Eigen::Index i) const {
        const bool is_dot = stands_out(context, i) || map.radius(i) == 0.0;
        return std::max((is_dot ? 0.4 : 0.15) * u, map.radius(i) * v.scale);
    }
    double half_height(Eigen::Index i) const {
        return is_rod(i) ? rod_half_height * u : shown_radius(i);
    }
    double period() const { return v.plot.width * v.zoom; }  // of a ring, pixels
    double around_once(double x) const {                     // of pixels from the left edge
        return is_ring ? x - period() * std::floor(x / period()) : x;
    }

    void draw_ground() const;
    void draw_end(double side) const;
    void draw_acting_ends() const;
    void draw_captions() const;
    void draw_ends() const;
    void draw_rings() const;
    void draw_callouts() const;
    Rect place_of_callout(const std::vector<Callouts::Step>& steps, Eigen::Index,
                          const CalloutPlate& plate, std::span<const Rect> others) const;
    void draw_where_it_is() const;
    ViewMap map_of(const View& view) const;
    Remarks remarks_in(const View& view, bool has_map) const;

    void draw() const;
    std::vector<Point> seen_at(double place, double radius) const;
    template <class Draw>
    void for_each_turn(double least, double most, const Draw& draw) const;
    void draw_lines() const;
    void draw_line(std::size_t line, std::optional<Color> one, double width) const;
    void draw_band(std::size_t line) const;
    void draw_reversals() const;
    void draw_field() const;
    void draw_ghosts() const;
    void draw_beads() const;
    void draw_flashes() const;
    void draw_arrows() const;
    void draw_name(Eigen::Index particle, double place) const;
    bool words_fit(Labels labels) const;
    void draw_words() const;
};

}  // namespace carom
