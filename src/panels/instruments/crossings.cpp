#include "panels/instruments/crossings.h"

#include "util/text.h"

namespace carom {

CrossedLine crossed_line(const Box& box, const PanelSpec& spec, std::size_t surface) {
    if (spec.line) return {spec.line->axis, spec.line->at, spec.line->between};
    const std::int32_t number = spec.surfaces.at(surface);
    return {box.surfaces.axis_of(number), box.place_of(number)};
}

std::string name_of_line(const Box& box, const PanelSpec& spec, std::size_t surface) {
    if (!spec.line)
        return box.surfaces.names()[static_cast<std::size_t>(spec.surfaces.at(surface))];
    return (spec.line->axis == 0 ? "x = " : "y = ") + plain_number(spec.line->at);
}

std::array<Phrase, 2> ways_across(int axis) {
    if (axis == 0) return {Phrase{"to the right"}, Phrase{"to the left"}};
    return {Phrase{"upwards"}, Phrase{"downwards"}};
}

std::array<std::string, 2> arrows_across(int axis) {
    if (axis == 0) return {"→", "←"};
    return {"↑", "↓"};
}

}  // namespace carom
