#include "app/report/collisions_csv.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "app/report/csv_header.h"
#include "physics/mechanics.h"
#include "util/csv.h"

namespace carom {
namespace {

std::string header(int dimension, UnitSystem units) {
    std::vector<Heading> columns{quantities::time, "particle", "partner", "surface"};
    for (const std::string whose : {"", "partner_"})
        add_components(columns, whose, quantities::length, dimension);
    for (const char* when : {"_before", "_after"})
        for (const std::string whose : {"", "partner_"})
            add_components(columns, whose + "v", quantities::velocity, dimension, when);
    add_components(columns, "impulse_", quantities::momentum, dimension);
    return csv_header(columns, units);
}

}  // namespace

CollisionsCsv::CollisionsCsv(const Box& box, Output& output, UnitSystem units)
    : dimension_(box.dimension), rows_(output) {
    for (const std::string& name : box.surfaces.names()) surfaces_.push_back(csv_field(name));
    output.write(header(dimension_, units));
}

void CollisionsCsv::add(const Vec& value) {
    auto out = rows_.end();
    for (Eigen::Index axis = 0; axis < dimension_; ++axis)
        if (std::isnan(value[axis]))
            *out = ',';
        else
            fmt::format_to(out, FMT_COMPILE(",{}"), value[axis]);
}

void CollisionsCsv::add(const Particles& particles, std::span<const Collision> collisions) {
    auto out = rows_.end();
    for (const Collision& its : collisions) {
        if (its.second.is_particle())
            fmt::format_to(out, "{},{},{},", csv_number(its.time), its.first,
                           its.second.particle());
        else
            fmt::format_to(out, "{},{},,{}", csv_number(its.time), its.first,
                           surfaces_[static_cast<std::size_t>(its.second.surface())]);
        for (const Vec& value :
             {its.first_position, its.second_position, its.first_before, its.second_before,
              its.first_after, its.second_after, impulse_of(particles, its)})
            add(value);
        *out = '\n';
        rows_.end_row();
    }
}

}  // namespace carom
