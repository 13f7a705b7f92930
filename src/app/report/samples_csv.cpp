#include "app/report/samples_csv.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstddef>

#include "app/report/csv_header.h"
#include "physics/gas.h"
#include "physics/mechanics.h"
#include "util/csv.h"

namespace carom {

SamplesCsv::SamplesCsv(const Gas& gas, Output& output, UnitSystem units) : rows_(output) {
    for (const Species& species : gas.species) species_.push_back(csv_field(species.name));
    std::vector<Heading> columns{
        quantities::time, "particle", "species", quantities::mass, {"radius", quantities::length}};
    add_components(columns, "", quantities::length, gas.box.dimension);
    add_components(columns, "v", quantities::velocity, gas.box.dimension);
    output.write(csv_header(columns, units));
}

void SamplesCsv::name_rows(const Particles& particles, const Sample& sample) {
    const Eigen::ArrayXd mass = masses(particles);
    const Eigen::ArrayXi& species = species_at(sample, particles);
    labels_.clear();
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        labels_.push_back(fmt::format(",{},{},{},{}", i,
                                      species_[static_cast<std::size_t>(species[i])], mass[i],
                                      particles.radius[i]));
}

void SamplesCsv::add(const Particles& particles, const Sample& sample) {
    if (membership_.see(sample, particles) || labels_.empty()) name_rows(particles, sample);
    const std::string time = csv_number(sample.time);
    auto out = rows_.end();
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        if (!is_present(sample, i)) continue;
        fmt::format_to(out, "{}{}", time, labels_[static_cast<std::size_t>(i)]);
        for (const double x : sample.position.row(i)) fmt::format_to(out, FMT_COMPILE(",{}"), x);
        for (const double v : sample.velocity.row(i)) fmt::format_to(out, FMT_COMPILE(",{}"), v);
        *out = '\n';
        rows_.end_row();
    }
}

}  // namespace carom
