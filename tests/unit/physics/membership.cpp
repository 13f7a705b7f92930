// Which species a particle belongs to, and whether it is present, as part of the state.
#include <doctest/doctest.h>

#include <memory>

#include "physics/archived.h"
#include "physics/gas.h"
#include "physics/simulation.h"
#include "util/archive.h"

using namespace carom;

namespace {

Gas two_species() {
    Gas gas;
    gas.box.size = {30.0, 20.0};
    gas.species = {{.name = "a", .count = 3, .velocity = Speed{1.0}},
                   {.name = "b", .count = 4, .velocity = Speed{2.0}}};
    return gas;
}

bool is_of(const Membership& its, const Particles& particles) {
    return its.species.size() == particles.count() && its.is_present.size() == particles.count() &&
           (its.species == particles.species).all() && its.is_present.all();
}

}  // namespace

TEST_CASE("all samples of a run share the membership of the start while nothing changes it") {
    Simulation simulation(two_species(), {});
    const std::shared_ptr<const Membership> start = simulation.sample().membership;
    REQUIRE(start != nullptr);
    CHECK(is_of(*start, simulation.particles()));
    CHECK(start->species[2] == 0);
    CHECK(start->species[3] == 1);
    simulation.advance_to(20.0);
    CHECK(simulation.sample().membership == start);
    CHECK(simulation.sample_of_positions().membership == start);
    CHECK(simulation.sample_of_velocities().membership == start);
    Simulation copy = simulation;
    copy.advance_to(30.0);
    CHECK(copy.sample().membership == start);
}

TEST_CASE("a membership is written and read back, absent particles and all") {
    Membership its{Eigen::ArrayXi::LinSpaced(4, 0, 3),
                   Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(4, true)};
    its.is_present[2] = false;
    Archive written;
    archive_parts(written, its);
    Membership read;
    Archive bytes(written.finished(), "the membership");
    archive_parts(bytes, read);
    bytes.expect_end();
    REQUIRE(read.species.size() == 4);
    REQUIRE(read.is_present.size() == 4);
    CHECK((read.species == its.species).all());
    CHECK((read.is_present == its.is_present).all());
}
