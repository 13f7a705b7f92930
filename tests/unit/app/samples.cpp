// The samples of a run as tables and trajectories, when particles change their species or are
// absent.
#include <doctest/doctest.h>

#include <memory>
#include <string>

#include "app/report/samples_csv.h"
#include "app/report/samples_xyz.h"
#include "physics/gas.h"
#include "support/files.h"

using namespace carom;

namespace {

struct Run {
    Gas gas;
    Particles particles;

    Run() {
        gas.box.size = {8.0, 4.0};
        gas.species = {{.name = "a", .count = 2, .radius = 0.5}, {.name = "b", .count = 1}};
        particles.radius = Eigen::ArrayXd::Constant(3, 0.5);
        particles.inverse_mass = Eigen::ArrayXd::Ones(3);
        particles.species = Eigen::Array3i(0, 0, 1);
    }
    Sample sample(double time, std::shared_ptr<const Membership> membership) const {
        return {time, Eigen::ArrayXXd::Ones(3, 2), Eigen::ArrayXXd::Zero(3, 2),
                std::move(membership)};
    }
    // The second particle is a `b`, and the third is absent.
    std::shared_ptr<const Membership> changed() const {
        Membership its = *membership_at_start(particles);
        its.species[1] = 1;
        its.is_present[2] = false;
        return std::make_shared<const Membership>(its);
    }
    template <class Samples>
    std::string written() const {
        const test::TemporaryFolder folder;
        const std::string path = (folder.path() / "samples").string();
        Output output(path);
        Samples samples(gas, output);
        samples.add(particles, sample(0.0, membership_at_start(particles)));
        samples.add(particles, sample(1.0, changed()));
        samples.add(particles, sample(2.0, membership_at_start(particles)));
        samples.finish();
        output.settle();
        output.commit();
        return test::contents(path);
    }
};

}  // namespace

TEST_CASE("the rows of a sample are those of present particles, with the species of the time") {
    CHECK(Run().written<SamplesCsv>() ==
          "time,particle,species,mass,radius,x,y,vx,vy\n"
          "0,0,a,1,0.5,1,1,0,0\n0,1,a,1,0.5,1,1,0,0\n0,2,b,1,0.5,1,1,0,0\n"
          "1,0,a,1,0.5,1,1,0,0\n1,1,b,1,0.5,1,1,0,0\n"
          "2,0,a,1,0.5,1,1,0,0\n2,1,a,1,0.5,1,1,0,0\n2,2,b,1,0.5,1,1,0,0\n");
}

TEST_CASE("a trajectory has as many particles in a frame as are present") {
    const std::string all = Run().written<SamplesXyz>();
    const std::size_t second = all.find("\n2\n");
    REQUIRE(second != std::string::npos);
    CHECK(all.starts_with("3\n"));
    const std::size_t first = all.find('\n', second + 3) + 1;
    CHECK(all.substr(first, all.find("\n3\n", first) - first) ==
          "H 1 1 0 0 0 0 0.5 1 0\nHe 1 1 0 0 0 0 0.5 1 1");
}
