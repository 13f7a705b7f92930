// Pictures and instruments of a gas in space.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "panels/field/field_layer.h"
#include "panels/frame.h"
#include "panels/gas/gas_colors.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/plots/histogram_panel.h"
#include "panels/surfaces/surface_view.h"
#include "panels/surfaces/surface_words.h"
#include "support/scene_text.h"
#include "support/seen_panel.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

TEST_CASE("surfaces of a box in space are described by their places") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 20, 20], walls: {back: {temperature: 1}, front: {mass: 5}}}\n"
        "partitions: [{name: far, z: 15}]\n"
        "gas: [{name: a, count: 1, radius: 0.5, position: [2, 2, 2]}]\nrun: {until: 1}\n");
    Simulation simulation(scene.gas, scene.run);
    const std::string words = words_at_present(Language::english, scene.gas, simulation.surfaces());
    for (const char* part : {"The back wall is a heat bath of temperature 1",
                             "The partition “far” stands still, at z = 15",
                             "The front wall is a piston of mass 5, at z = 20"})
        CHECK_MESSAGE(words.find(part) != std::string::npos, words);
}

TEST_CASE("a surface in space has an area, without its gaps and between its neighbours") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10, 8], walls: {front: {velocity: -1}}}\n"
        "partitions: [{name: a, x: 4, gaps: [[2, 1, 5, 3], [0, 6, 10, 8]]}, {name: b, z: 2}]\n"
        "gas: [{name: a, count: 1, radius: 0.5, position: [2, 2, 1]}]\nrun: {until: 4}\n");
    Simulation run(scene.gas, scene.run);
    const Box& box = scene.gas.box;
    const auto areas = [&] {
        std::vector<double> all;
        for (const std::int32_t k : {0, 2, 4, 6, 7})
            all.push_back(size_of_surface(box, run.surfaces(), k));
        return all;
    };
    // left 10 x 8, bottom 20 x 8, back 20 x 10; the sheet across x without 3 x 2 and 10 x 2.
    CHECK(areas() == std::vector<double>{80.0, 160.0, 200.0, 54.0, 200.0});
    CHECK(enclosed_content(box, run.surfaces()) == 1600.0);
    run.advance_to(1.0);  // the front is at 7: of the second gap 10 x 1 is left
    CHECK(areas() == std::vector<double>{70.0, 140.0, 200.0, 54.0, 200.0});
    CHECK(enclosed_content(box, run.surfaces()) == 1400.0);
}

TEST_CASE("a field in space is the mean along z") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [8, 4, 2]}\ngas: [{name: a, count: 4, radius: 0.4, position: "
        "[[1, 1, 0.5], [1, 1, 1.5], [3, 1, 1], [7, 3, 1]]}]\nrun: {until: 1}\n"
        "film: {seconds: 1, fps: 2, panels: [], field: {of: density, cells: 4, over: 1}}\n");
    const Cells cells = cells_of_field(scene);
    CHECK(cells.count[0] == 4);
    CHECK(cells.count[1] == 2);
    CHECK(cells.count[2] == 1);
    CHECK(cells.content() == 2.0 * 2.0 * 2.0);
    Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    const PanelContext context{scene, simulation.particles(), 2, none};
    CellQuantity density(context, cells, FieldOf::density, {}, 1.0);
    const Sample sample = simulation.sample();
    const Eigen::ArrayXd speed = speeds(sample);
    const AdvanceResult nothing;
    density.see({{}, sample, speed, speed, nothing});
    const Eigen::ArrayXd values = density.values(0, 0.0);
    const std::vector<double> expected{0.25, 0.125, 0, 0, 0, 0, 0, 0.125};
    REQUIRE(values.size() == 8);
    for (Eigen::Index k = 0; k < 8; ++k) CHECK(values[k] == expected[static_cast<std::size_t>(k)]);
}

TEST_CASE("the table of a picture in space has three coordinates and three velocities") {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [8, 4, 2]}\ngas: [{name: a, count: 1, radius: 0.4, position: [1, 2, "
        "0.5], "
        "velocity: [3, 4, 5]}]\nrun: {until: 0.01}\n"
        "film: {seconds: 1, fps: 2, panels: [], velocities: true}\n");
    const Shot shot(scene);
    const FrameData& frame = shot.frames.at(0);
    const Table table = shot.panels->gas().table(*frame.states.at(0), theme_of(shot.scene.film));
    CHECK(column_names(table) ==
          std::vector<std::string>{"part", "particle", "species", "x (length)", "y (length)",
                                   "z (length)", "radius (length)", "colour", "label",
                                   "velocity x (length/time)", "velocity y (length/time)",
                                   "velocity z (length/time)"});
    const std::vector<TableCell>& row = table.rows.at(0);
    CHECK(std::get<std::string>(row[0]) == "sphere");
    CHECK(std::get<float>(row[5]) == 0.5f);
    CHECK(std::get<float>(row[11]) == 5.0f);
}

TEST_CASE("a histogram of speeds counts the motion along an axis, in a plane or in space") {
    const auto scene_with = [](const std::string& options) {
        return test::scene_from(
            "title: T\nbox: {size: [20, 18, 16]}\ngravity: [0, -0.3, 0]\n"
            "gas: [{count: 90, radius: 0.4, temperature: 1}]\nrun: {until: 6}\n"
            "film: {seconds: 1, panels: [{kind: speed-histogram, bins: 20, "
            "range: [0, 5]" +
            options + "}]}\n");
    };
    const std::vector<std::pair<std::string, std::vector<int>>> parts{
        {"", {0, 1, 2}},         {", component: all", {0, 1, 2}}, {", component: y", {1}},
        {", component: z", {2}}, {", component: xy", {0, 1}},     {", component: yz", {1, 2}}};
    for (const auto& [component, axes] : parts) {
        CAPTURE(component);
        // At the end: what each bar holds, counted one by one.
        const test::SeenPanel seen(scene_with(component), 12);
        Simulation simulation(seen.scene.gas, seen.scene.run);
        simulation.advance_to(6.0);
        std::vector<double> expected(20, 0.0);
        for (Eigen::Index i = 0; i < 90; ++i) {
            double square = 0.0;
            for (const int axis : axes)
                square +=
                    simulation.sample().velocity(i, axis) * simulation.sample().velocity(i, axis);
            const auto bar = static_cast<std::size_t>(4.0 * std::sqrt(square));
            if (bar < 20) ++expected[bar];
        }
        const auto last = seen.last_state();
        CHECK(HistogramPanel::histograms(*last).front().counts == expected);
        // Over a time: the exact means, against those of 2400 moments. A sphere that changes its
        // bar between two of these is wrong by at most half of their distance; that happens less
        // than 96 times in each bar.
        const test::SeenPanel over(scene_with(component + ", over: {window: 3}"), 12);
        const auto mean = over.last_state();
        Simulation again(over.scene.gas, over.scene.run);
        std::vector<double> means(20, 0.0);
        constexpr int moments = 2400;
        for (int k = 0; k < moments; ++k) {
            again.advance_to(3.0 + 3.0 * (k + 0.5) / moments);
            const Eigen::ArrayXd speeds =
                again.sample().velocity(Eigen::all, axes).square().rowwise().sum().sqrt();
            for (const double speed : speeds)
                if (speed < 5.0) means[static_cast<std::size_t>(4.0 * speed)] += 1.0 / moments;
        }
        const std::vector<double>& exact = HistogramPanel::histograms(*mean).front().counts;
        REQUIRE(exact.size() == 20);
        for (std::size_t bar = 0; bar < 20; ++bar)
            CHECK(std::abs(exact[bar] - means[bar]) < 96.0 * 0.5 / moments);
    }
}
