// The samples of a run as tables and trajectories, when particles change their species or are
// absent.
#include <doctest/doctest.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/report/collisions_csv.h"
#include "app/report/samples_csv.h"
#include "app/report/samples_xyz.h"
#include "app/report/surfaces_csv.h"
#include "physics/gas.h"
#include "support/files.h"

using namespace carom;

namespace {

struct Run {
    Gas gas;
    Particles particles;
    Eigen::ArrayXXd position = Eigen::ArrayXXd::Ones(3, 2);
    Eigen::ArrayXXd velocity = Eigen::ArrayXXd::Zero(3, 2);

    Run() {
        gas.box.size = {8.0, 4.0};
        gas.species = {{.name = "a", .count = 2, .radius = 0.5}, {.name = "b", .count = 1}};
        particles.radius = Eigen::ArrayXd::Constant(3, 0.5);
        particles.inverse_mass = Eigen::ArrayXd::Ones(3);
        particles.species = Eigen::Array3i(0, 0, 1);
    }
    Sample sample(double time, std::shared_ptr<const Membership> membership) const {
        return {time, position, velocity, std::move(membership)};
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

TEST_CASE("in space samples and trajectories have three coordinates, and a box of three lengths") {
    Run run;
    run.gas.box.dimension = 3;
    run.gas.box.size = {8.0, 4.0, 2.5};
    run.gas.box.walls = {Wall::solid, Wall::solid, Wall::periodic};
    run.position = Eigen::ArrayXXd::Ones(3, 3);
    run.position.col(2) << 0.25, 0.5, 2.0;
    run.velocity = -2.0 * run.position;
    const std::string table = run.written<SamplesCsv>();
    CHECK(
        table.starts_with("time,particle,species,mass,radius,x,y,z,vx,vy,vz\n"
                          "0,0,a,1,0.5,1,1,0.25,-2,-2,-0.5\n"));
    const std::string trajectory = run.written<SamplesXyz>();
    CHECK(trajectory.starts_with("3\nLattice=\"8 0 0 0 4 0 0 0 2.5\" "));
    CHECK(trajectory.find(" pbc=\"F F T\" ") != std::string::npos);
    CHECK(trajectory.find("\nHe 1 1 2 -2 -2 -4 0.5 1 2\n") != std::string::npos);
}

TEST_CASE("collisions and surfaces in space have three components") {
    Box box;
    box.dimension = 3;
    box.size = {8.0, 4.0, 2.5};
    box.surfaces.side_count = 6;
    const auto written = [](const auto& write) {
        const test::TemporaryFolder folder;
        const std::string path = (folder.path() / "rows").string();
        Output output(path);
        write(output);
        output.settle();
        output.commit();
        return test::contents(path);
    };
    Particles particles;
    particles.radius = Eigen::ArrayXd::Constant(1, 0.5);
    particles.inverse_mass = Eigen::ArrayXd::Constant(1, 0.5);
    particles.species = Eigen::ArrayXi::Zero(1);
    const Collision hit{.time = 2.0,
                        .first = 0,
                        .second = Partner::of_surface(5),
                        .first_position = {1.0, 2.0, 2.0},
                        .second_position = {1.0, 2.0, 2.5},
                        .first_before = {0.5, 0.0, 3.0},
                        .second_before = {0.0, 0.0, 0.0},
                        .first_after = {0.5, 0.0, -3.0},
                        .second_after = {0.0, 0.0, 0.0}};
    CHECK(written([&](Output& output) {
              CollisionsCsv rows(box, output);
              rows.add(particles, std::span(&hit, 1));
              rows.finish();
          }) ==
          "time,particle,partner,surface,x,y,z,partner_x,partner_y,partner_z,vx_before,vy_before,"
          "vz_before,partner_vx_before,partner_vy_before,partner_vz_before,vx_after,vy_after,"
          "vz_after,partner_vx_after,partner_vy_after,partner_vz_after,impulse_x,impulse_y,"
          "impulse_z\n2,0,,front,1,2,2,1,2,2.5,0.5,0,3,0,0,0,0.5,0,-3,0,0,0,0,0,12\n");
    std::vector<SurfaceState> states(6);
    states[5].hits = 1;
    states[5].impulse = {0.0, 0.0, 12.0};
    const std::string rows = written([&](Output& output) {
        SurfacesCsv surfaces(box, output);
        surfaces.add(2.0, states);
    });
    CHECK(rows.starts_with(
        "time,surface,position,velocity,hits,impulse_x,impulse_y,impulse_z,work,heat\n"));
    CHECK(rows.ends_with("2,front,,,1,0,0,12,0,0\n"));
}
