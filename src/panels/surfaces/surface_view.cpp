#include "panels/surfaces/surface_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_words.h"
#include "physics/gas.h"
#include "physics/surfaces/behaviours.h"
#include "scene/film.h"
#include "util/overloaded.h"

namespace carom {
namespace {

constexpr double rim_in_space = 0.3;  // units, around the picture: for the lines at its edges

// How far the drawing of a side extends outward, in units.
double depth_of(const Gas& gas, const Behaviour& behaviour, std::size_t side) {
    const bool is_labelled_here =
        side / 2 == 1;  // labels of the left and the right stand above the box
    const double label =
        is_labelled_here && !label_of_surface(Language::english, gas, behaviour, 1).empty()
            ? SurfaceSize::label
            : 0.0;
    constexpr double bar = SurfaceSize::bar + SurfaceSize::hatch;
    return std::visit(Overloaded{[](const Reflecting&) { return 0.0; },
                                 [&](const Bath&) { return SurfaceSize::bath + label; },
                                 [](const Driven&) { return bar + SurfaceSize::arrow; },
                                 [&](const Piston& its) {
                                     return bar + (its.force != 0.0 ? SurfaceSize::arrow : label);
                                 },
                                 [](const Membrane&) { return 0.0; },
                                 [](const Diffuse&) { return SurfaceSize::teeth; }},
                      behaviour);
}

// Whether a partition has something at its ends outside of the box, or room for it.
bool has_ends(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return false; }, [](const Bath&) { return true; },
                   [](const Driven&) { return true; }, [](const Piston&) { return true; },
                   [](const Membrane&) { return true; }, [](const Diffuse&) { return false; }},
        behaviour);
}

bool names_axis(const std::vector<PanelSpec>& panels) {
    return std::ranges::any_of(panels, [](const PanelSpec& panel) {
        return panel.component && *panel.component != Component::both;
    });
}

}  // namespace

double thickness_of_side(const Behaviour& behaviour) {
    return std::visit(Overloaded{[](const Reflecting&) { return SurfaceSize::line; },
                                 [](const Bath&) { return SurfaceSize::bath; },
                                 [](const Driven&) { return SurfaceSize::bar; },
                                 [](const Piston&) { return SurfaceSize::bar; },
                                 [](const Membrane&) { return SurfaceSize::line; },
                                 [](const Diffuse&) { return SurfaceSize::teeth; }},
                      behaviour);
}

Rect BoxMap::rect(const Region& region) const {
    const Point corner = pixel({region.low[0], region.high[1]});
    return {corner.x, corner.y, (region.high[0] - region.low[0]) * scale,
            (region.high[1] - region.low[1]) * scale};
}

SurfaceView::SurfaceView(const PanelContext& context, std::vector<Viewpoint> viewpoints)
    : gas_(context.gas_in_scene()),
      language_(context.language()),
      plain_(context.box().surfaces.are_plain() && !change_behaviours(context.run().events)),
      behaviours_(behaviours_in_time(context.box().surfaces, context.run())),
      extent_{Vec(), context.box().size},
      viewpoints_(std::move(viewpoints)) {
    for (std::size_t side = 0; side < gas_.box.surfaces.numbered_sides().size(); ++side)
        still_ = still_ && !may_move(side);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    temperatures_ = {infinite, -infinite};
    for (const auto& list : behaviours_)
        for (const Behaviour& behaviour : list)
            if (const auto* bath = bath_of(behaviour))
                temperatures_ = {std::min(temperatures_[0], bath->temperature),
                                 std::max(temperatures_[1], bath->temperature)};
    names_axes_ = is_deep() && (!plain_ || names_axis(context.film().panels));
    if (!plain_ || names_axes_) margins_ = is_deep() ? margins_in_space() : margins_of();
    if (is_deep()) return;
    for (const int axis : {0, 1}) {
        if (!context.box().is_periodic(axis)) continue;
        for (double* margin : axis == 0 ? std::array{&margins_.left, &margins_.right}
                                        : std::array{&margins_.top, &margins_.bottom})
            *margin = std::max(*margin, SurfaceSize::chevron);
    }
}

// The largest thickness that a side ever has.
double SurfaceView::thickness_of(std::size_t side) const {
    double most = SurfaceSize::line;
    for (const Behaviour& behaviour : behaviours_[side])
        most = std::max(most, thickness_of_side(behaviour));
    return most;
}

bool SurfaceView::may_move(std::size_t k) const {
    return std::ranges::any_of(behaviours_[k], moves);
}

SurfaceView::Margins SurfaceView::margins_of() const {
    const Gas& gas = gas_;
    std::array<double, 4> depth{};
    for (std::size_t side = 0; side < 4; ++side)
        for (const Behaviour& behaviour : behaviours_[side])
            depth[side] = std::max(depth[side], depth_of(gas, behaviour, side));
    std::array<double, 4> blocks{};
    double names = 0.0;
    for (std::size_t k = 0; k < behaviours_.size(); ++k) {
        const int axis = gas.box.surfaces.axis_of(k);
        for (const Behaviour& behaviour : behaviours_[k]) {
            if (axis == 0 && !label_of_surface(Language::english, gas, behaviour, axis).empty())
                names = SurfaceSize::label;
            if (gas.box.surfaces.is_side(k) || !has_ends(behaviour)) continue;
            const auto first = static_cast<std::size_t>(axis == 0 ? 2 : 0);
            for (const std::size_t end : {first, first + 1}) blocks[end] = SurfaceSize::block;
        }
    }
    for (std::size_t side = 0; side < 4; ++side)
        if (blocks[side] > 0.0)
            depth[side] = std::max(depth[side], thickness_of(side) + blocks[side]);
    const bool falls = gas.box.surfaces.has_gravity();
    return {depth[0] + (falls ? SurfaceSize::gravity : 0.0), depth[1], depth[2], depth[3] + names};
}

void SurfaceView::survey(const FrameInput& input) {
    const Region now = room(input.advanced.surfaces);
    extent_ = {lower(extent_.low, now.low), upper(extent_.high, now.high)};
}

std::vector<SurfaceState> SurfaceView::states(const FrameInput& input) const {
    if (plain_) return {};
    const std::vector<SurfaceState>& all = input.advanced.surfaces;
    const std::size_t drawn = std::min(all.size(), behaviours_.size());
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(drawn)};
}

Region SurfaceView::room(const std::vector<SurfaceState>& states) const {
    const Box& box = gas_.box;
    const auto place = [&](std::size_t k) { return place_of_surface(box, states, k); };
    if (is_deep()) return {{place(0), place(2), place(4)}, {place(1), place(3), place(5)}};
    return {{place(0), place(2)}, {place(1), place(3)}};
}

BoxMap SurfaceView::map_in(const Rect& area, double unit, bool centered) const {
    const double rim = is_deep() ? rim_in_space * unit : 0.0;
    const Rect seen = is_deep() ? rect_around(extent_, viewpoints_) : Rect{};
    const Vec size = is_deep() ? Vec{seen.width, seen.height} : extent_.high - extent_.low;
    const double left = margins_.left * unit, top = margins_.top * unit;
    const double around = left + margins_.right * unit + 2.0 * rim,
                 above = top + margins_.bottom * unit + 2.0 * rim;
    const double scale = std::min((area.width - around) / size[0], (area.height - above) / size[1]);
    const double width = size[0] * scale, height = size[1] * scale;
    const double across = centered ? (area.width - around - width) / 2 : 0.0;
    const double down = centered ? (area.height - above - height) / 2 : 0.0;
    BoxMap map{{area.x + across + left, area.y + down + top, width + 2.0 * rim, height + 2.0 * rim},
               extent_.low,
               scale};
    if (is_deep())
        map.space.emplace(
            viewpoints_.front(), extent_,
            Point{map.frame.x + rim - scale * seen.x, map.frame.y + rim - scale * seen.y}, scale);
    return map;
}

Rect SurfaceView::whole(const BoxMap& map, double unit) const {
    const double left = margins_.left * unit, top = margins_.top * unit;
    return {map.frame.x - left, map.frame.y - top, map.frame.width + left + margins_.right * unit,
            map.frame.height + top + margins_.bottom * unit};
}

// The scale is logarithmic, since ratios of temperatures matter.
Color SurfaceView::bath_color(double temperature, const Theme& theme) const {
    const auto [low, high] = temperatures_;
    const double share =
        high > low ? std::clamp(std::log(temperature / low) / std::log(high / low), 0.0, 1.0) : 1.0;
    if (theme.kind == ThemeKind::print) return mix(rgb(0x8C8C8C), rgb(0x1A1A1A), share);
    const Color cold = theme.dark ? rgb(0x4E9BE6) : rgb(0x1F6FC0);
    const Color hot = theme.dark ? rgb(0xF0603C) : rgb(0xC8341B);
    return mix(cold, hot, share);
}

}  // namespace carom
