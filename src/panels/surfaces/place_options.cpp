#include "panels/surfaces/place_options.h"

#include "scene/instruments/instrument_reading.h"

namespace carom {

Binding<SurfaceNumbers> surfaces_key() {
    return bind_value("surfaces", surfaces_notation(),
                      "The walls or partitions where it measures: `left`, `right`, `bottom`, "
                      "`top`, in space `back` and `front`, or the names of partitions. A histogram "
                      "shows the particles on each side of "
                      "the partition that it names.")
        .default_text(
            "all walls together for a pressure; none for a histogram; else what moves, or the only "
            "partition");
}

Binding<std::vector<NamedRegion>> regions_key() {
    return bind_value("regions", regions_notation(),
                      "Parts of the box: `sides` shows them instead of the sides of a partition, a "
                      "thermometer instead of particles by `of`, and a histogram those particles "
                      "that are in each at the time.")
        .default_text("none");
}

Binding<std::optional<CountingLine>> line_key() {
    const auto fill = [](std::optional<CountingLine>& into, const CountingLine& line) {
        into = line;
    };
    return bind_with<std::optional<CountingLine>>(
               "line", fill, counting_line_notation(),
               "A line or, in space, a plane that particles cross, instead of a partition.")
        .default_text("none");
}

std::vector<Binding<MeasuredAt>> part_keys() {
    return {bind_within(&MeasuredAt::surfaces, surfaces_key()),
            bind_within(&MeasuredAt::regions, regions_key())};
}

}  // namespace carom
