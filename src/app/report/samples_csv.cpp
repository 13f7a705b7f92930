#include "app/report/samples_csv.h"

#include <cstddef>
#include <iterator>

#include "physics/mechanics.h"
#include "util/csv.h"

namespace carom {
namespace {

constexpr std::size_t most_buffered = 1 << 20;

}  // namespace

SamplesCsv::SamplesCsv(const Gas& gas, Output& output) : output_(output) {
    for (const Species& species : gas.species) species_.push_back(csv_field(species.name));
    output_.write(gas.box.dimension == 1 ? "time,particle,species,mass,radius,x,vx\n"
                                         : "time,particle,species,mass,radius,x,y,vx,vy\n");
}

void SamplesCsv::name_rows(const Particles& particles) {
    const Eigen::ArrayXd mass = masses(particles);
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        labels_.push_back(fmt::format(",{},{},{:.17g},{:.17g}", i,
                                      species_[static_cast<std::size_t>(particles.species[i])],
                                      mass[i], particles.radius[i]));
}

void SamplesCsv::add(const Particles& particles, const Sample& sample) {
    if (labels_.empty()) name_rows(particles);
    const std::string time = csv_number(sample.time);
    const auto out = std::back_inserter(buffer_);
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        fmt::format_to(out, "{}{}", time, labels_[static_cast<std::size_t>(i)]);
        for (const double x : sample.position.row(i)) fmt::format_to(out, ",{:.17g}", x);
        for (const double v : sample.velocity.row(i)) fmt::format_to(out, ",{:.17g}", v);
        buffer_.push_back('\n');
        if (buffer_.size() >= most_buffered) finish();
    }
}

void SamplesCsv::finish() {
    output_.write({buffer_.data(), buffer_.size()});
    buffer_.clear();
}

}  // namespace carom
