#include "app/report/surfaces_csv.h"

#include <fmt/format.h>

#include "util/csv.h"

namespace carom {

SurfacesCsv::SurfacesCsv(const Box& box, Output& output) : output_(output) {
    const std::vector<std::string> names = box.surfaces.names();
    for (std::size_t k = 0; k < names.size(); ++k)
        names_.push_back(box.has_surface(k) ? csv_field(names[k]) : "");
    output_.write("time,surface,position,velocity,hits,impulse_x,impulse_y,work,heat\n");
}

void SurfacesCsv::add(double time, const std::vector<SurfaceState>& surfaces) {
    std::string rows;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        if (names_[k].empty()) continue;
        const SurfaceState& its = surfaces[k];
        rows += fmt::format("{},{},", csv_number(time), names_[k]);
        rows += its.motion ? fmt::format("{},{}", its.motion->place, its.motion->velocity) : ",";
        rows += fmt::format(",{},{},{},{},{}\n", its.hits, its.impulse[0], its.impulse[1], its.work,
                            its.heat);
    }
    output_.write(rows);
}

}  // namespace carom
