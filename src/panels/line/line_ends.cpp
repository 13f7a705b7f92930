#include "panels/line/line_ends.h"

#include <algorithm>

#include "panels/surfaces/side_extent.h"
#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_words.h"
#include "physics/gas.h"
#include "physics/surfaces/behaviours.h"
#include "util/overloaded.h"

namespace carom {
namespace {

constexpr double half_of_end = 2.2;  // units, as other ends of a wire

}  // namespace

LineEnds::LineEnds(const PanelContext& context)
    : gas_(context.gas_in_scene()),
      run_(context.run()),
      language_(context.language()),
      look_(context),
      length_(context.box().size[0]),
      extent_{0.0, length_} {}

void LineEnds::survey(const FrameInput& input) { widen_to_sides(extent_, gas_.box, 0, input); }

std::vector<LineEnds::End> LineEnds::see(const FrameInput& input, double memory) {
    const std::vector<SurfaceState>& states = input.advanced.surfaces;
    std::vector<End> ends;
    for (std::size_t side = 0; side < 2 && states.size() > 1 && !is_plain(); ++side) {
        End& end = ends.emplace_back(End{states[side], place_of_surface(gas_.box, states, side)});
        if (!end.state.motion) continue;
        std::deque<Point>& path = paths_[side];
        path.push_back({input.tick.time, end.place});
        while (path.size() > 2 && path[1].x < input.tick.time - memory) path.pop_front();
        end.path.assign(path.begin(), path.end());
    }
    return ends;
}

void LineEnds::draw(Canvas& canvas, const DrawContext& dc, const End& end, std::size_t side,
                    double x, double y) const {
    const double u = dc.unit, out = side == 0 ? -1.0 : 1.0;
    const auto band = [&](double offset, double depth) {
        const double from = x + out * offset * u, to = from + out * depth * u;
        return Rect{std::min(from, to), y - half_of_end * u, depth * u, 2.0 * half_of_end * u};
    };
    const Behaviour& behaviour = end.state.behaviour;
    const auto* piston = piston_of(behaviour);
    const bool is_imposed = end.state.is_held || (piston == nullptr && end.state.motion);
    const auto draw_end = [&] {
        canvas.fill(band(0.0, 0.5), end.state.motion ? dc.theme.muted : dc.theme.wall);
    };
    std::visit(
        Overloaded{[&](const Reflecting&) { draw_end(); },
                   [&](const Bath& bath) {
                       draw_bath(canvas, dc, band(0.0, SurfaceSize::bath), true,
                                 look_.bath_color(bath.temperature, dc.theme));
                   },
                   [&](const Driven&) { draw_end(); }, [&](const Piston&) { draw_end(); },
                   [&](const Membrane&) { draw_end(); }, [&](const Diffuse&) { draw_end(); }},
        behaviour);
    if (is_imposed) draw_ticks(canvas, dc, band(0.5, 0.4), side);
    const double along = piston != nullptr ? piston->force
                         : is_imposed      ? end.state.motion->velocity
                                           : 0.0;
    if (along != 0.0) {
        const double length = along > 0.0 ? 1.8 * u : -1.8 * u;
        const double middle = x + out * (is_imposed ? 2.0 : 1.6) * u;
        draw_surface_arrow(canvas, dc, {middle - length / 2, y}, {length, 0.0});
    }
    const std::string words = label_of_surface(language_, gas_, behaviour, 0);
    if (words.empty()) return;
    TextStyle style = label_style(dc);
    style.color = dc.theme.ink;
    style.align = side == 0 ? Align::left : Align::right;
    draw_text(canvas, {x + out * SurfaceSize::bath * u, y - (half_of_end + 0.4) * u},
              escape_markup(words), style);
}

bool LineEnds::has_words(std::size_t side) const {
    const auto in_time = behaviours_in_time(gas_.box.surfaces, run_);
    return std::ranges::any_of(in_time[side], [&](const Behaviour& behaviour) {
        return !label_of_surface(language_, gas_, behaviour, 0).empty();
    });
}

// The arrow is at an end without a label, since labels move with their end; in the middle if both
// ends have labels.
void LineEnds::draw_gravity(Canvas& canvas, const DrawContext& dc, const Rect& line) const {
    const double g = gas_.box.surfaces.gravity[0], u = dc.unit;
    if (g == 0.0) return;
    const double middle = !has_words(1)   ? line.right() - 3.0 * u
                          : !has_words(0) ? line.x + 1.5 * u
                                          : line.x + 0.5 * line.width;
    const double length = g > 0.0 ? 2.0 * u : -2.0 * u;
    draw_surface_arrow(canvas, dc, {middle - length / 2, line.bottom() - 0.36 * u}, {length, 0.0});
    TextStyle style = label_style(dc);
    style.color = dc.theme.ink;
    draw_text(canvas, {middle + 1.5 * u, line.bottom()}, "<i>g</i>", style);
}

}  // namespace carom
