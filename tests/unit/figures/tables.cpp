// The tables beside figures: read back by a reader of this file's own, they say what is drawn.
#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "draw/color.h"
#include "figures/figure_drawing.h"
#include "panels/plots/histogram_panel.h"
#include "support/csv.h"
#include "support/figure_run.h"
#include "support/pixels.h"
#include "support/scene_text.h"

using namespace carom;
using test::quoted_rows;
using test::run_of;

namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::string& text) {
    const auto lines = quoted_rows(text);
    std::vector<Row> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        REQUIRE(lines[i].size() == lines[0].size());
        Row& row = rows.emplace_back();
        for (std::size_t k = 0; k < lines[0].size(); ++k) row[lines[0][k]] = lines[i][k];
    }
    return rows;
}

std::vector<Row> part(const std::vector<Row>& rows, const std::string& name) {
    std::vector<Row> some;
    std::ranges::copy_if(rows, std::back_inserter(some),
                         [&](const Row& row) { return row.at("part") == name; });
    return some;
}

double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

Scene scene_of(const std::string& figures) {
    return test::scene_from(
        "title: A mixture\nbox: {size: [40, 30]}\n"
        "gas: [{name: \"light, cold\", count: 90, radius: 0.4, speed: 2},\n"
        "      {name: heavy, count: 9, radius: 0.8, mass: 4, speed: 3},\n"
        "      {name: hot, count: 1, radius: 0.5, mass: 2, speed: 9, label: \"\\\"H\\\"\"}]\n"
        "run: {until: 10, events: [{at: 5, reverse: velocities}]}\nfilm: {seconds: 3}\n"
        "figures:\n" +
        figures);
}

std::vector<Row> table(const FigureRun& run, std::size_t index) {
    return rows_of(csv(table_of(run.figures()[index])));
}

}  // namespace

TEST_CASE("fields are quoted as RFC 4180 wants them, numbers keep every bit") {
    const Table table{{{"a", quantities::number}, "b"},
                      {{0.1, "plain"}, {{}, "a \"b\", c\nd"}, {std::int64_t{-7}, 0.1F}}};
    CHECK(csv(table) == "a (1),b\n0.1,plain\n,\"a \"\"b\"\", c\nd\"\n-7,0.1\n");
    CHECK(quoted_rows(csv(table))[2][1] == "a \"b\", c\nd");
}

TEST_CASE("a histogram's bars are redrawn from its table") {
    const Scene scene = scene_of(
        "  - {name: a, kind: speed-histogram, at: 4, theory: false, mean_now: false,\n"
        "     mean_start: false, bins: 12, range: [0, 6]}\n");
    const FigureRun run = run_of(scene);
    const Figure& figure = run.figures()[0];
    const auto rows = table(run, 0);
    const auto bars = part(rows, "bar");
    const auto& counts = HistogramPanel::histograms(*figure.moments[0].state).front().counts;
    REQUIRE(bars.size() == counts.size());
    REQUIRE(bars.size() > 5);
    double sum = number(part(rows, "above").at(0), "value (count)") +
                 number(part(rows, "below").at(0), "value (count)");
    for (std::size_t k = 0; k < bars.size(); ++k) {
        CHECK(bars[k].at("of") == "all");
        CHECK(number(bars[k], "value (count)") == counts[k]);
        if (k > 0)
            CHECK(bars[k].at("speed from (length/time)") ==
                  bars[k - 1].at("speed to (length/time)"));
        sum += counts[k];
    }
    CHECK(sum == 100.0);
    CHECK(rows.size() == bars.size() + 2);  // and no curve or mark that is not drawn

    // The picture: pixels of the bars' colour in the middle of each.
    const Canvas canvas = draw_figure(run, figure, std::nullopt, {"t", "d"});
    const PixelView view = canvas.pixels();
    const std::uint32_t color = to_pixel(theme_of(figure.spec->theme).bar);
    const auto height = [&](int x) {
        int pixels = 0;
        for (int y = view.height / 4; y < view.height; ++y)  // the title's words have the colour
            pixels += view.data[y * view.stride + x] == color;
        return pixels;
    };
    int first = 0, last = view.width - 1;
    while (height(first) < 3) ++first;
    while (height(last) < 3) --last;
    std::size_t low = 0, high = bars.size() - 1;
    while (counts[low] == 0.0) ++low;
    while (counts[high] == 0.0) --high;
    const double width = (last + 1 - first) / static_cast<double>(high + 1 - low);
    // Two of them give the scale (the axis hides their feet), and all others follow.
    const double most = dynamic_cast<const HistogramPanel&>(*figure.panel).tallest();
    std::vector<std::pair<double, double>> seen;  // count and height
    for (std::size_t k = low; k <= high; ++k)
        if (counts[k] > 0.0 && counts[k] <= most)
            seen.emplace_back(counts[k],
                              height(first + static_cast<int>((double(k - low) + 0.5) * width)));
    const auto [least, largest] = std::ranges::minmax_element(seen);
    REQUIRE(largest->first > least->first + 3.0);
    const double scale = (largest->second - least->second) / (largest->first - least->first);
    CHECK(scale > 5.0);  // pixels for each particle
    CHECK(seen.size() > 5);
    for (const auto& [count, tall] : seen)
        CHECK(std::abs(tall - least->second - scale * (count - least->first)) < 2.0);
}

TEST_CASE("curves, fits and means are in the table as they are drawn") {
    const Scene scene = scene_of(
        "  - {name: a, kind: speed-histogram, of: [\"light, cold\", 99], over: [2, 4], fit: "
        "true}\n");
    const FigureRun run = run_of(scene);
    const auto rows = table(run, 0);
    const auto bars = part(rows, "bar"), curve = part(rows, "curve"), fit = part(rows, "fit"),
               above = part(rows, "above");
    const double width =
        number(bars[0], "speed to (length/time)") - number(bars[0], "speed from (length/time)");
    for (const auto& [of, count] : {std::pair{"light, cold", 90.0}, {"particle 99", 1.0}}) {
        double in_bars = 0.0, under_curve = 0.0;
        for (const auto* all : {&bars, &above})
            for (const Row& row : *all)
                if (row.at("of") == of) in_bars += number(row, "value (count)");
        CHECK(in_bars == doctest::Approx(count));
        Row before;
        for (const Row& row : curve) {
            if (row.at("of") != of) continue;
            if (!before.empty())
                under_curve += 0.5 *
                               (number(row, "value (count)") + number(before, "value (count)")) *
                               (number(row, "speed from (length/time)") -
                                number(before, "speed from (length/time)")) /
                               width;
            before = row;
        }
        CHECK(under_curve > 0.9 * count);
        CHECK(under_curve < 1.001 * count);
    }
    CHECK(fit.size() == 2 * 121);
    CHECK(part(rows, "mean").size() == 2);
    const auto start = part(rows, "mean at start");
    CHECK(number(start.at(0), "speed from (length/time)") == doctest::Approx(2.0));
    CHECK(number(start.at(1), "speed from (length/time)") == doctest::Approx(9.0));
}

TEST_CASE("a strip of the gas lists every disk of every picture, where it was") {
    const Scene scene = scene_of("  - {name: a, kind: gas, strip: [0, 2.5]}\n");
    const FigureRun run = run_of(scene);
    const auto disks = part(table(run, 0), "disk");
    REQUIRE(disks.size() == 200);
    Simulation simulation(scene.gas, scene.run);
    for (std::size_t moment = 0; moment < 2; ++moment) {
        simulation.advance_to(2.5 * double(moment));
        const Sample sample = simulation.sample();
        for (std::size_t i = 0; i < 100; ++i) {
            const Row& row = disks[100 * moment + i];
            const auto particle = static_cast<Eigen::Index>(i);
            CHECK(number(row, "picture at (time)") == 2.5 * double(moment));
            CHECK(number(row, "particle") == double(i));
            CHECK(std::stof(row.at("x (length)")) ==
                  static_cast<float>(sample.position(particle, 0)));
            CHECK(std::stof(row.at("y (length)")) ==
                  static_cast<float>(sample.position(particle, 1)));
            CHECK(row.at("species") == (i < 90 ? "light, cold" : i < 99 ? "heavy" : "hot"));
            CHECK(number(row, "radius (length)") == (i < 90 ? 0.4 : i < 99 ? 0.8 : 0.5));
            CHECK(parse_color(row.at("colour")).has_value());
            CHECK(row.at("label") == (i == 99 ? "\"H\"" : ""));
        }
        // Slow and fast are told apart, equal speeds are not.
        if (moment == 0) CHECK(disks[0].at("colour") == disks[89].at("colour"));
        if (moment == 0) CHECK(disks[0].at("colour") != disks[99].at("colour"));
    }
}

TEST_CASE("lines of a series go on in elapsed time after a reversal, which is marked") {
    const Scene scene = scene_of(
        "  - {name: a, kind: energy-by-species}\n  - {name: b, kind: energy-by-species, at: 2}\n");
    const FigureRun run = run_of(scene);
    const auto rows = table(run, 0);
    const auto lines = part(rows, "line");
    const std::string energy = "mean energy (mass length^2/time^2)", time = "elapsed time (time)";
    const auto first = std::ranges::find(lines, "heavy", [](const Row& r) { return r.at("of"); });
    CHECK(number(*first, time) == 0.0);
    CHECK(number(*first, energy) == doctest::Approx(0.5 * 4 * 9));
    // The time goes on where the clock turns back: two flanks, and the reversal between them.
    std::vector<double> times;
    for (const Row& row : lines)
        if (row.at("of") == "heavy") times.push_back(number(row, time));
    CHECK(std::ranges::is_sorted(times));
    CHECK(times.back() == 10.0);
    CHECK(number(part(rows, "reversal").at(0), time) == 5.0);
    const auto level = part(rows, "reference");
    REQUIRE(level.size() == 2);
    CHECK(number(level[0], energy) ==
          doctest::Approx((90 * 2.0 + 9 * 18.0 + 81.0) / 100.0));  // all have shared
    for (const Row& row : part(table(run, 1), "line")) CHECK(number(row, time) <= 2.0);
}

TEST_CASE("every kind has a table with a name for each column and a cell for each name") {
    const Scene scene = scene_of(
        "  - {name: a, kind: velocity-histogram}\n  - {name: b, kind: position-histogram}\n"
        "  - {name: c, kind: energy-histogram}\n  - {name: d, kind: speed-classes}\n"
        "  - {name: e, kind: temperature}\n  - {name: f, kind: entropy}\n"
        "  - {name: g, kind: pressure}\n  - {name: h, kind: return-distance}\n"
        "  - {name: i, kind: phase, of: [hot, heavy]}\n  - {name: j, kind: positions, of: [0, 1]}\n"
        "  - {name: k, kind: monitors}\n  - {name: l, kind: single-collision}\n"
        "  - {name: m, kind: contact-time}\n  - {name: n, kind: gas}\n"
        "  - {name: o, kind: text, words: Nothing}\n");
    const FigureRun run = run_of(scene);
    for (std::size_t k = 0; k < 14; ++k) {
        CAPTURE(scene.figures[k].panel.kind);
        const Table of_figure = table_of(run.figures()[k]);
        REQUIRE(!of_figure.rows.empty());
        CHECK(column_names(of_figure).front() == "part");
        for (const std::vector<TableCell>& row : of_figure.rows) {
            REQUIRE(row.size() == of_figure.columns.size());
            REQUIRE(std::holds_alternative<std::string>(row.front()));
        }
        for (const Heading& column : of_figure.columns) CHECK(!column.name.empty());
    }
    CHECK(table_of(run.figures()[14]).columns.empty());
}

TEST_CASE("beads and their world lines: the last bend of each is the bead") {
    const Scene scene = test::scene_from(
        "title: A wire\nbox: {length: 10}\ngas: [{count: 6, temperature: 1}]\n"
        "run: {until: 10}\nfilm: {seconds: 3}\nfigures: [{name: a, kind: gas, at: 6}]\n");
    const FigureRun run = run_of(scene);
    const auto rows = table(run, 0);
    const auto beads = part(rows, "bead"), lines = part(rows, "world line");
    REQUIRE(beads.size() == 6);
    for (const Row& bead : beads) {
        Row last;
        for (const Row& bend : lines)
            if (bend.at("particle") == bead.at("particle")) last = bend;
        CHECK(number(last, "time (time)") == 6.0);
        CHECK(number(bead, "time (time)") == 6.0);
        CHECK(number(last, "x as drawn (length)") ==
              doctest::Approx(number(bead, "x as drawn (length)")).epsilon(1e-6));
    }
}

// Disks of radius 2 whose centres are 9 apart along the motion, and 2 across it.
TEST_CASE("the quadratic equation of a contact has the two times as its roots") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [24, 18]}\n"
        "gas: [{name: a, position: [4, 9], radius: 2, velocity: [1, 0]},\n"
        "      {name: b, position: [13, 7], radius: 2}]\n"
        "run: {until: 12}\nfigures: [{name: a, kind: contact-time}]\n");
    const FigureRun run = run_of(scene);
    const auto rows = table(run, 0);
    const auto parabola = part(rows, "parabola");
    REQUIRE(parabola.size() == 1);
    const double rr = number(parabola[0], "squared distance (length^2)"),
                 rv = number(parabola[0], "r.v (length^2/time)"),
                 vv = number(parabola[0], "v.v (length^2/time^2)");
    CHECK(number(parabola[0], "time (time)") == 0.0);
    CHECK(rr == doctest::Approx(81.0 + 4.0).epsilon(1e-14));
    CHECK(rv == doctest::Approx(-9.0).epsilon(1e-14));
    CHECK(vv == 1.0);
    const double at_contact = number(part(rows, "level").at(0), "squared distance (length^2)");
    CHECK(at_contact == 16.0);
    const double root = std::sqrt(rv * rv - vv * (rr - at_contact));
    const auto points = part(rows, "mark");
    CHECK(number(points.at(0), "time (time)") == doctest::Approx((-rv - root) / vv).epsilon(1e-13));
    CHECK(number(points.at(1), "time (time)") == doctest::Approx((-rv + root) / vv).epsilon(1e-13));
}

TEST_CASE("the matrix of a collision maps the velocities before to those after") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {length: 26}\ngas:\n  - {name: a, position: 4, velocity: 0.5}\n"
        "  - {name: b, position: 14, mass: 9, velocity: -1}\nrun: {until: 26}\nfigures:\n"
        "  - {name: plain, kind: collision-map}\n"
        "  - {name: scaled, kind: collision-map, scaled: true}\n"
        "  - {name: walk, kind: collision-map, walk: true, scaled: false}\n"
        "  - {name: wall, kind: collision-map, masses: [1, infinite], velocities: [1, -0.5]}\n");
    const FigureRun run = run_of(scene);
    const auto matrix = [&](std::size_t figure, const std::array<std::string, 2>& names) {
        const auto rows = part(table(run, figure), "matrix");
        REQUIRE(rows.size() == 2);
        Eigen::Matrix2d all;
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(rows[i].at("of") == names[i]);
            for (std::size_t k = 0; k < 2; ++k)
                all(Eigen::Index(i), Eigen::Index(k)) =
                    number(rows[i], "coefficient of " + names[k] + " (number)");
        }
        return all;
    };
    // Masses 1 and 9: v0' = (-8 v0 + 18 v1) / 10, v1' = (2 v0 + 8 v1) / 10.
    const Eigen::Matrix2d exact{{-0.8, 1.8}, {0.2, 0.8}};
    for (const std::size_t figure : {0U, 2U})
        CHECK(matrix(figure, {"v0", "v1"}).isApprox(exact, 1e-15));
    // A reflection: symmetric, and its own inverse.
    const Eigen::Matrix2d scaled = matrix(1, {"sqrt(m0) v0", "sqrt(m1) v1"});
    CHECK(scaled.isApprox(Eigen::Matrix2d{{-0.8, 0.6}, {0.6, 0.8}}, 1e-15));
    CHECK(matrix(3, {"v1", "v2"}).isApprox(Eigen::Matrix2d{{-1.0, 2.0}, {0.0, 1.0}}, 1e-15));
    const auto points = part(table(run, 0), "point");
    const Eigen::Vector2d before{0.5, -1.0}, after = exact * before;
    CHECK(number(points.at(1), "v0 (length/time)") == doctest::Approx(after[0]));
    CHECK(number(points.at(1), "v1 (length/time)") == doctest::Approx(after[1]));
}

TEST_CASE("a curve has enough points that no corner is seen where it turns") {
    const Scene scene = test::scene_from(
        "title: Beads\nbox: {length: 9}\n"
        "gas: [{name: a, position: 3, mass: 10, velocity: 2.6}, "
        "{name: b, position: [2, 4, 5, 6, 7, 8], mass: 1, velocity: -3}]\nrun: {until: 60}\n"
        "film: {seconds: 20}\n"
        "figures:\n  - {name: f, kind: velocity-histogram, of: [a, b], over: [0, 60]}\n");
    const FigureRun run = run_of(scene);
    std::map<std::string, std::vector<double>> heights;
    for (const Row& row : part(table(run, 0), "curve"))
        heights[row.at("of")].push_back(number(row, "value (count)"));
    CHECK(heights.size() == 2);
    for (const auto& [of, y] : heights) {
        const double top = *std::ranges::max_element(y);
        for (std::size_t i = 1; i + 1 < y.size(); ++i)  // how far the chord is from the curve
            CHECK(std::abs(y[i - 1] - 2.0 * y[i] + y[i + 1]) / 8.0 < 0.002 * top);
    }
}
