#include "app/report/surfaces_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/csv_header.h"
#include "util/csv.h"

namespace carom {

SurfacesCsv::SurfacesCsv(const Box& box, Output& output, UnitSystem units)
    : components_(std::max(2, box.dimension)), output_(output) {
    const std::vector<std::string> names = box.surfaces.names();
    for (std::size_t k = 0; k < names.size(); ++k)
        names_.push_back(box.has_surface(k) ? csv_field(names[k]) : "");
    std::vector<Heading> columns{quantities::time,
                                 "surface",
                                 quantities::position,
                                 quantities::velocity,
                                 {"hits", quantities::count}};
    add_components(columns, "impulse_", quantities::momentum, components_);
    columns.emplace_back("work", quantities::energy);
    columns.emplace_back("heat", quantities::energy);
    output_.write(csv_header(columns, units));
}

void SurfacesCsv::add(double time, const std::vector<SurfaceState>& surfaces) {
    std::string rows;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        if (names_[k].empty()) continue;
        const SurfaceState& its = surfaces[k];
        rows += fmt::format("{},{},", csv_number(time), names_[k]);
        rows += its.motion ? fmt::format("{},{}", its.motion->place, its.motion->velocity) : ",";
        rows += fmt::format(",{}", its.hits);
        for (int axis = 0; axis < components_; ++axis)
            rows += fmt::format(",{}", its.impulse[axis]);
        rows += fmt::format(",{},{}\n", its.work, its.heat);
    }
    output_.write(rows);
}

}  // namespace carom
