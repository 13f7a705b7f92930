// What surfaces in space cannot be, and the room that a driven wall leaves there.
#include <doctest/doctest.h>

#include <string>

#include "physics/box.h"
#include "physics/run.h"
#include "physics/surfaces/surface_problem.h"
#include "support/relative.h"
#include "support/space.h"

using namespace carom;
using test::relative;

TEST_CASE("what a surface in space cannot be is refused in words") {
    const auto message = [](const Box& box) {
        const auto problems = surface_problems(box, {});
        if (problems.empty()) return std::string("none");
        return to_text(problems[0], box).message + "; " + to_text(problems[0], box).hint;
    };
    const auto with = [](const Partition& partition) {
        Box box = test::cube_of(10.0);
        box.surfaces.partitions = {partition};
        return box;
    };
    const auto around = [](const Obstacle& obstacle, Wall wall = Wall::solid) {
        Box box = test::cube_of(10.0, wall);
        box.surfaces.obstacles = {obstacle};
        return box;
    };
    CHECK(message(with(test::window(1, 4.0, {{1.0, 2.0}, {3.0, 4.0}}))) == "none");
    CHECK(message(with(test::window(3, 4.0, {{1.0, 2.0}, {3.0, 4.0}}))) ==
          "`window` is perpendicular to an axis that the box does not have; "
          "the axes of space are x, y and z");
    CHECK(message(with(test::window(2, 11.0, {{1.0, 2.0}, {3.0, 4.0}}))) ==
          "`window` at z = 11 is not in the box; the box goes from 0 to 10");
    CHECK(message(with(test::window(1, 4.0, {{1.0, 2.0}, {3.0, 11.0}}))) ==
          "the gap from (1, 2) to (3, 11) is not in the box; "
          "gaps of `window` lie between x = 0 and 10, and between z = 0 and 10");
    CHECK(message(with(test::window(1, 4.0, {{1.0, 2.0}, {3.0, 2.0}}))) ==
          "the gap from (1, 2) to (3, 2) ends where it begins, or before; "
          "give the lower corner of a gap first");
    Partition two = test::window(0, 4.0, {{1.0, 2.0}, {3.0, 4.0}});
    two.gaps.push_back({{3.0, 2.0}, {5.0, 4.0}});
    CHECK(message(with(two)) == "none");
    two.gaps.push_back({{2.0, 3.0}, {4.0, 5.0}});
    CHECK(message(with(two)) ==
          "the gap from (2, 3) to (4, 5) overlaps the gap from (1, 2) to (3, 4); "
          "make them smaller, or let them touch: gaps that touch are one opening");
    CHECK(message(around({"lines", Obstacle::Lines{{{1.0, 1.0}, {2.0, 2.0}}}})) ==
          "`lines` consists of lines, which have no meaning in space; give a sphere or a cuboid");
    CHECK(message(around({"block", Obstacle::Cuboid{{1.0, 1.0, 1.0}, {2.0, 1.0, 2.0}}})) ==
          "`block` ends where it begins along an axis, or before; "
          "give the lower corner of a cuboid first");
    CHECK(message(around({"block", Obstacle::Cuboid{{1.0, 1.0, 11.0}, {2.0, 2.0, 12.0}}})) ==
          "`block` lies outside the box; "
          "the box goes from x = 0 to 10 and from y = 0 to 10 and from z = 0 to 10");
    CHECK(message(around({"ball", Obstacle::Ball{{1.0, 1.0, 1.0}, 6.0}}, Wall::periodic)) ==
          "`ball` is wider than the periodic box, and would overlap itself; "
          "make it smaller, or the box solid");
    CHECK(message(around({"pole", Obstacle::Cuboid{{1.0, 1.0, 0.0}, {2.0, 2.0, 10.0}}},
                         Wall::periodic)) == "none");
    Box plane{2, {10.0, 10.0}, {Wall::solid, Wall::solid}};
    plane.surfaces.obstacles = {{"block", Obstacle::Cuboid{{1.0, 1.0}, {2.0, 2.0, 1.0}}}};
    CHECK(message(plane) ==
          "`block` is a cuboid, which has no meaning in a plane; "
          "give a disk, a rectangle, a polygon or a segment");
    plane.surfaces.obstacles.clear();
    plane.surfaces.partitions = {test::window(2, 4.0, {1.0, 2.0})};
    CHECK(message(plane) ==
          "`window` is perpendicular to an axis that the box does not have; "
          "the axes of a plane are x and y");
}

TEST_CASE("a driven wall in space leaves room for the densest packing of spheres") {
    Box box = test::space_of({10.0, 4.0, 5.0});
    box.surfaces.sides[1] = Driven{-0.5};
    const double volume = 40.0;
    Run run;
    run.until = 100.0;
    const auto problems = surface_problems(box, run, volume);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].kind == SurfaceProblem::Kind::leaves_no_room);
    // 0.7405 of the room are filled.
    CHECK(problems[0].room == relative(volume / 0.74048048969306 / 20.0, 1e-12));
    CHECK(problems[0].value == relative((10.0 - problems[0].room) / 0.5, 1e-12));
}
