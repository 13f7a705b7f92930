#include "panels/instruments/crossings.h"

#include <fmt/format.h>

#include "physics/box.h"
#include "physics/vec.h"
#include "scene/keys/check.h"
#include "util/text.h"

namespace carom {

std::vector<Binding<CrossedAt>> crossed_keys() {
    return {bind_within(&CrossedAt::surfaces, surfaces_key()),
            bind_within(&CrossedAt::line, line_key())};
}

void check_line(const Node& node, Reading& reading) {
    if (is_written(node, "surfaces"))
        refuse_together(reading.errors, place_of_surfaces(node), {"surfaces", "line"});
}

SuitableSurface passable_surfaces(const Reading& reading) {
    return {[&](std::int32_t surface) { return lets_through(reading, surface); },
            "a partition that lets particles through and does not move",
            reading.box().dimension == 1
                ? "count at `line: {x: PLACE}`"
                : "give a partition `gaps` or `passes`, let an event open it, or count at `line: "
                  "{x: PLACE}`"};
}

CrossedLine crossed_line(const Box& box, const CrossedAt& at, std::size_t surface) {
    if (at.line) return {at.line->axis, at.line->at, at.line->between};
    const std::int32_t number = at.surfaces.at(surface);
    return {box.surfaces.axis_of(number), box.place_of(number)};
}

std::string name_of_line(const Box& box, const CrossedAt& at, std::size_t surface) {
    if (!at.line) return box.surfaces.names()[static_cast<std::size_t>(at.surfaces.at(surface))];
    return fmt::format("{} = {}", name_of_axis(at.line->axis), plain_number(at.line->at));
}

std::array<std::string, 2> arrows_across(int axis) {
    if (axis == 0) return {"→", "←"};
    if (axis == 1) return {"↑", "↓"};
    return {"↙", "↗"};
}

}  // namespace carom
