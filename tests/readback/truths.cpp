// Scenes whose numbers can be worked out by hand: pictures and tables are compared with these.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "readback/checks.h"
#include "support/test_root.h"

using namespace carom::test;

namespace {

constexpr double rounding = 1e-9;

const DrawnFigure& drawn(const std::string& name) {
    static const std::map<std::string, DrawnFigure> all =
        figures_of(checkout() / "tests" / "readback" / "scenes" / "set.yaml");
    return all.at(name);
}

void check_none(const Problems& problems) {
    for (const std::string& problem : problems) {
        MESSAGE(problem);
        CHECK(problem.empty());
    }
}

std::vector<double> column(const std::vector<Row>& rows, const std::string& name) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(number(row, name));
    return values;
}

void check_equal(const std::vector<double>& values, const std::vector<double>& expected) {
    REQUIRE(values.size() == expected.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(values[i] - expected[i]) <= rounding);
    }
}

}  // namespace

// The disk starts at 3 with speed 2, its centre meets the wall at 19, and it is back at 15 in the
// end.
TEST_CASE("a disk is drawn where it has come to") {
    const DrawnFigure& figure = drawn("disk");
    check_none(gas_problems(figure, 20.0, 10.0));
    const std::vector<Row> rows = rows_of(figure, "disk");
    check_equal(column(rows, "x (length)"), {15.0});
    check_equal(column(rows, "y (length)"), {5.0});
}

// Hits of the right wall at the times 8, 26, ..., 98; of the left one at 17, 35, ..., 89.
TEST_CASE("counters show the hits of two walls") {
    const DrawnFigure& figure = drawn("hits");
    check_none(counter_problems(figure));
    check_equal(column(figure.table, "value"), {5.0, 6.0});
}

TEST_CASE("numbers in words are those of one disk") {
    const DrawnFigure& figure = drawn("numbers");
    check_none(monitor_problems(figure));
    check_equal(column(figure.table, "value"), {10.0, 1.0, 2.0, 2.0});
}

// Each end receives the momentum 4 twice in the last time interval of 36.
TEST_CASE("the needle of a gauge shows the mean force of one bead") {
    const DrawnFigure& figure = drawn("gauge");
    check_none(needle_problems(figure));
    check_equal(column(figure.table, "value"), {2.0 * 4.0 / 36.0});
}

// The beads meet at time 5, the first at 8 and the second at 9.
TEST_CASE("two equal beads exchange velocities, colours and energies") {
    const DrawnFigure& beads = drawn("beads");
    check_none(line_problems(beads, 20.0));
    check_equal(column(rows_of(beads, "bead"), "x as drawn (length)"), {8.0, 12.0});
    const std::vector<Row> bends = rows_of(beads, "world line");
    check_equal(column(bends, "x as drawn (length)"), {3.0, 8.0, 8.0, 9.0, 9.0, 12.0});
    check_equal(column(bends, "time (time)"), {0.0, 5.0, 8.0, 0.0, 5.0, 8.0});
    CHECK(bends[1].at("colour") == bends[5].at("colour"));  // of the segment that ends here
    CHECK(bends[2].at("colour") == bends[4].at("colour"));

    const DrawnFigure& energies = drawn("energies");
    check_none(plot_problems(energies, {"time (time)", "mean energy (mass length^2/time^2)"}));
    for (const Row& row : rows_of(energies, "line")) {
        const bool moves = (number(row, "time (time)") < 5.0) == (row.at("of") == "first");
        CHECK(number(row, "mean energy (mass length^2/time^2)") == (moves ? 0.5 : 0.0));
    }

    const DrawnFigure& states = drawn("states");
    check_none(plot_problems(states, {"position (length)", "velocity (length/time)"}));
    check_equal(column(states.table, "position (length)"), {8.0, 12.0});
    check_equal(column(states.table, "velocity (length/time)"), {0.0, 1.0});

    const DrawnFigure& path = drawn("path");
    const PlotColumns columns{"position of particle 0 (length)", "position of particle 1 (length)"};
    check_none(plot_problems(path, columns));
    for (const Row& row : rows_of(path, "path"))  // only one of the two moves
        CHECK((number(row, columns.x) == doctest::Approx(8.0) ||
               number(row, columns.y) == doctest::Approx(9.0)));
}

TEST_CASE("bars, slabs and sides hold the disks that lie there") {
    const DrawnFigure& places = drawn("places");
    check_none(plot_problems(places, {"position along x from (length)", "value (count)",
                                      "position along x to (length)"}));
    check_equal(column(rows_of(places, "bar"), "value (count)"), {2, 0, 1, 0, 0, 0, 0, 1, 0, 0});

    const DrawnFigure& density = drawn("density");
    check_none(plot_problems(density, {"x (length)", "density (1/length^2)"}));
    // Counts divided by the area of a slab, listed at both of its ends; a row that repeats the one
    // before is omitted.
    check_equal(column(rows_of(density, "profile"), "density (1/length^2)"),
                {0.2, 0.2, 0, 0, 0.1, 0.1, 0, 0, 0, 0, 0, 0.1, 0.1, 0, 0, 0});

    const DrawnFigure& halves = drawn("halves");
    check_none(plot_problems(halves, {"time (time)", "particles (1)"}));
    for (const Row& row : rows_of(halves, "line"))
        CHECK(number(row, "particles (1)") == (row.at("of") == "left" ? 3.0 : 1.0));
}

TEST_CASE("a histogram of three speeds has its bars and its mean in place") {
    const DrawnFigure& speeds = drawn("speeds");
    check_none(plot_problems(
        speeds, {"speed from (length/time)", "value (count)", "speed to (length/time)"}));
    check_equal(column(rows_of(speeds, "bar"), "value (count)"), {0, 2, 1, 0});
    check_equal(column(rows_of(speeds, "mean"), "speed from (length/time)"), {4.5 / 3.0});
}

TEST_CASE("the colours in the cells of a field have the means that the key has for their numbers") {
    const DrawnFigure& field = drawn("field");
    check_none(field_problems(field, 10.0, "density (1/length^2)"));
    const std::vector<Row> cells = rows_of(field, "cell");
    REQUIRE(cells.size() == 4);
    CHECK(number(cells[0], "density (1/length^2)") == doctest::Approx(6.0 / 25.0));
    CHECK(number(cells[1], "density (1/length^2)") == doctest::Approx(5.0 / 25.0));
    CHECK(number(cells[3], "density (1/length^2)") == doctest::Approx(3.0 / 25.0));
    CHECK(cells[2].at("density (1/length^2)").empty());  // fewer than 3 show nothing
}

TEST_CASE("disks of a gas have their places in the run, and the colours of their speeds") {
    const std::filesystem::path scene = checkout() / "docs" / "panels" / "gas.yaml";
    const DrawnFigure figure = figures_of(scene).at("gas");
    const std::vector<Row> disks = rows_of(figure, "disk"),
                           samples = samples_of(scene, disks.size());
    REQUIRE(samples.size() == disks.size());
    for (std::size_t i = 0; i < disks.size(); ++i) {
        CAPTURE(i);
        for (const std::string axis : {"x", "y"})  // the table has single precision
            CHECK(std::stof(disks[i].at(axis + " (length)")) == std::stof(samples[i].at(axis)));
        const double speed = std::hypot(number(samples[i], "vx"), number(samples[i], "vy"));
        CHECK(is_near_color(paint_of(disks[i].at("colour")), key_color(figure.picture, speed)));
    }
}

TEST_CASE("spheres have their places in the run, and those in front are drawn over those behind") {
    const std::filesystem::path scene =
        checkout() / "tests" / "readback" / "scenes" / "spheres.yaml";
    DrawnFigure figure = figures_of(scene).at("gas");
    const std::array<double, 3> size{12.0, 8.0, 9.0};
    check_none(sphere_problems(figure, size, {30.0, 20.0, 1.5}));
    CHECK(sphere_problems(figure, size, {31.0, 20.0, 1.5}).size() > 10);
    const std::vector<Row> spheres = rows_of(figure, "sphere"),
                           samples = samples_of(scene, spheres.size());
    REQUIRE(spheres.size() == 40);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        CAPTURE(i);
        for (const std::string axis : {"x", "y", "z"})  // the table has single precision
            CHECK(std::stof(spheres[i].at(axis + " (length)")) == std::stof(samples[i].at(axis)));
        const double speed = std::hypot(number(samples[i], "vx"), number(samples[i], "vy"),
                                        number(samples[i], "vz"));
        CHECK(is_near_color(paint_of(spheres[i].at("colour")), key_color(figure.picture, speed)));
    }
    for (Row& row : figure.table)
        if (row.at("part") == "sphere")
            row.at("z (length)") = std::to_string(9.0 - number(row, "z (length)"));
    CHECK(sphere_problems(figure, size, {30.0, 20.0, 1.5}).size() > 30);  // seen from behind
}

TEST_CASE("bars of errors reach as far as the table says") {
    DrawnFigure figure = drawn("errors");
    const PlotColumns columns{"radius", "virial pressure (energy/area)"};
    check_none(plot_problems(figure, columns));
    CHECK(rows_of(figure, "mean").size() == 3);
    for (Row& row : figure.table) {
        std::string& error = row.at("standard error of " + columns.y);
        if (!error.empty()) error = std::to_string(4.0 * std::stod(error));
    }
    CHECK(plot_problems(figure, columns).size() == 3);
}

TEST_CASE("bars beside thermometers and arcs on gauges reach as far as the table's errors") {
    using Check = Problems (*)(const DrawnFigure&);
    const std::map<std::string, Check> checks{{"warm", thermometer_problems},
                                              {"pressed", needle_problems}};
    for (const auto& [name, problems_of] : checks) {
        CAPTURE(name);
        DrawnFigure figure = drawn(name);
        check_none(problems_of(figure));
        REQUIRE(!figure.table.empty());
        for (Row& row : figure.table) {
            std::string& error = row.at("standard error");
            error = std::to_string(0.5 * std::stod(error));
        }
        CHECK(problems_of(figure).size() == figure.table.size());
    }
}
