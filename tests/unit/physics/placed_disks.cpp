// Disks that have found their places, against a look at all of them.
#include "physics/placement/placed_disks.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "util/random.h"

using namespace carom;

namespace {

struct Disk {
    Vec centre;
    double radius;
};

std::optional<std::int32_t> first_overlapped(const Box& box, const std::vector<Disk>& disks,
                                             const Disk& asked) {
    for (std::size_t i = 0; i < disks.size(); ++i) {
        const double contact = (disks[i].radius + asked.radius) * (1.0 - touching_tolerance);
        if (square(box.nearest(disks[i].centre - asked.centre)) < contact * contact)
            return static_cast<std::int32_t>(i);
    }
    return {};
}

}  // namespace

TEST_CASE("overlaps are found in boxes of any size, where disks are close together and far apart") {
    Random random(5, "places");
    for (const double size : {12.0, 400.0, 1e6, 1e12})
        for (const double across : {10.0, size}) {
            CAPTURE(size);
            CAPTURE(across);
            Box box;
            box.size = {size, 0.75 * size};
            box.walls = {Wall::periodic, Wall::solid};
            Eigen::ArrayXd radii(300);
            for (double& radius : radii) radius = random.uniform() < 0.02 ? 2.0 : 0.05;
            PlacedDisks placed(box, radii);
            std::vector<Disk> disks;
            int overlapped = 0;
            for (const double radius : radii) {
                Disk disk{{across * (random.uniform() - 0.5), 0.7 * across * random.uniform()},
                          radius};
                if (disk.centre[0] < 0.0) disk.centre[0] += size;  // on both sides of the border
                const auto expected = first_overlapped(box, disks, disk);
                CHECK(placed.overlapped(disk.centre, radius) == expected);
                overlapped += expected.has_value();
                placed.add(static_cast<std::int32_t>(disks.size()), disk.centre, radius);
                disks.push_back(disk);
            }
            if (across == 10.0) CHECK(overlapped > 20);
        }
}

TEST_CASE("a disk much larger than a periodic box overlaps all others") {
    for (const Wall wall : {Wall::periodic, Wall::solid}) {
        Box box;
        box.size = {10.0, 10.0};
        box.walls = {wall, Wall::periodic};
        PlacedDisks placed(box, Eigen::ArrayXd::Constant(20, 0.1));
        placed.add(7, {5.0, 5.0}, 0.1);
        for (const double radius : {6.0, 1e10, 1e200}) {  // beyond the integers too
            CAPTURE(radius);
            CHECK(placed.overlapped({1.0, 1.0}, radius) == 7);
        }
    }
}

TEST_CASE("disks in one corner of a huge box are compared with those beside them only") {
    constexpr std::int32_t count = 20'000;
    for (const bool in_a_row : {true, false}) {
        Box box;
        box.size = {1e6, 1e6};
        PlacedDisks placed(box, Eigen::ArrayXd::Constant(count, 0.4));
        for (std::int32_t i = 0; i < count; ++i) {
            const Vec place = in_a_row ? Vec{1.0 + i, 7.0} : Vec{1.0 + i % 140, 1.0 + i / 140};
            CHECK_FALSE(placed.overlapped(place, 0.4));
            placed.add(i, place, 0.4);
        }
        // A cell has the room of ten disks a unit apart, squared; and shares its list with others.
        CHECK(placed.compared() < 100 * count);
    }
}
