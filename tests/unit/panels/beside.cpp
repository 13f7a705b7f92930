// Two runs side by side in one film: a box of each with one scale of colours, plots of both.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "draw/text.h"
#include "panels/line/line_panel.h"
#include "panels/plot/layers.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

std::string text_of(const std::string& beside, const std::string& film = "") {
    return "title: T\nbox: {size: [20, 15]}\n"
           "gas: [{name: disks, count: 30, radius: 0.4, temperature: 1}]\n"
           "run: {until: 6}\n"
           "film: {size: [640, 360], fps: 10, seconds: 4, panels: [speed-histogram, "
           "temperature], " +
           film + beside + "}\n";
}

constexpr const char* hot =
    "beside: {own_label: cold run, label: hot run, "
    "set: gas.0.temperature=9}";

// The panels of a set by the run that they see.
std::vector<std::size_t> boxes_of(const PanelSet& panels) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < panels.panels().size(); ++i)
        if (found.empty() || (found.size() == 1 && panels.panels()[i].run == 1)) found.push_back(i);
    return found;
}

Table table_at(const test::Shot& shot, std::size_t frame, std::size_t panel) {
    const Theme& theme = theme_of(shot.scene.film.theme);
    return shot.panels->panels()[panel].panel->table(*shot.frames[frame].states[panel], theme);
}

std::vector<TableCell> column(const Table& table, const std::string& name) {
    const auto found = std::ranges::find_if(
        table.columns, [&](const Heading& one) { return one.name.starts_with(name); });
    REQUIRE(found != table.columns.end());
    std::vector<TableCell> cells;
    for (const auto& row : table.rows)
        cells.push_back(row[std::size_t(found - table.columns.begin())]);
    return cells;
}

}  // namespace

TEST_CASE("each of two boxes shows its own run, as its film alone would") {
    const test::Shot both(test::scene_from(text_of(hot)));
    const test::Shot cold(test::scene_from(text_of("")));
    Scene warm = test::scene_from(
        text_of("").replace(text_of("").find("temperature: 1"), 14, "temperature: 9"));
    const test::Shot alone(warm);
    const std::vector<std::size_t> boxes = boxes_of(*both.panels);
    REQUIRE(boxes.size() == 2);
    for (const std::size_t frame : {0U, 17U, 39U}) {
        CAPTURE(frame);
        for (const std::string axis : {"x", "y"}) {
            CHECK(column(table_at(both, frame, boxes[0]), axis) ==
                  column(table_at(cold, frame, 0), axis));
            CHECK(column(table_at(both, frame, boxes[1]), axis) ==
                  column(table_at(alone, frame, 0), axis));
        }
    }
}

TEST_CASE("two boxes have one scale of colours, that of both runs") {
    const test::Shot both(test::scene_from(text_of(hot)));
    const test::Shot cold(test::scene_from(text_of("")));
    const std::vector<std::size_t> boxes = boxes_of(*both.panels);
    // In the scale of a gas three times as fast the colours of a cold one are others, and fewer;
    // two disks of one speed have one colour in both boxes.
    const auto colors = [](const test::Shot& shot, std::size_t panel) {
        std::set<std::string> all;
        for (const TableCell& cell : column(table_at(shot, 20, panel), "colour"))
            all.insert(std::get<std::string>(cell));
        return all;
    };
    const std::set<std::string> alone = colors(cold, 0), slow = colors(both, boxes[0]),
                                fast = colors(both, boxes[1]);
    const ColorMap map = color_map_on("viridis", theme_of(both.scene.film.theme));
    const auto highest = [&](const std::set<std::string>& some) {
        int rank = 0;
        for (int i = 0; i < 256; ++i)
            if (some.contains(hex_of(map.at(i / 255.0)))) rank = i;
        return rank;
    };
    CHECK(highest(alone) > 150);
    CHECK(highest(fast) > 150);
    CHECK(highest(slow) < highest(alone) / 2);
}

TEST_CASE("a film shows as many runs as it lists, each in a box and in every plot") {
    Scene scene = test::scene_from(text_of(hot));
    scene.film.runs.others.push_back(scene.film.runs.others.front());
    scene.film.runs.others.back().label = "hot again";
    for (const bool is_overlaid : {false, true}) {
        scene.film.runs.is_overlaid = is_overlaid;
        const test::Shot shot(scene);
        const std::vector<PanelSet::Placed>& panels = shot.panels->panels();
        CHECK(shot.panels->boxes(Grid(scene.film.layout, scene.film.size)).size() == 3);
        const Table table = table_at(shot, 30, panels.size() - 1);
        const std::vector<TableCell> names = column(table, "run"), values = column(table, "temp");
        std::map<std::string, std::vector<TableCell>> lines;
        for (std::size_t row = 0; row < names.size(); ++row)
            lines[std::get<std::string>(names[row])].push_back(values[row]);
        REQUIRE(lines.size() == 3);
        CHECK(lines.at("hot again") == lines.at("hot run"));
        CHECK(lines.at("hot again") != lines.at("cold run"));
        FramePainter painter(*shot.panels);
        const TextLog log;
        painter.paint(shot.frames[30]);
        CHECK(painter.cut_words().empty());
    }
}

TEST_CASE("panels show both runs with their labels, and the words under the boxes name them") {
    const test::Shot both(test::scene_from(text_of(hot)));
    const std::size_t count = both.panels->panels().size();
    for (const std::size_t panel : {count - 2, count - 1}) {
        const Table table = table_at(both, 30, panel);
        std::set<std::string> runs;
        for (const TableCell& cell : column(table, "run")) runs.insert(std::get<std::string>(cell));
        CHECK(runs == std::set<std::string>{"cold run", "hot run"});
    }
    FramePainter painter(*both.panels);
    painter.paint(both.frames[30]);
    const TextLog log;
    FramePainter(*both.panels).paint(both.frames[30]);
    for (const std::string label : {"cold run", "hot run"})
        CHECK(std::ranges::count_if(log.lines, [&](const auto& line) {
                  return line.markup.find(label) != std::string::npos;
              }) >= 2);  // below its box, and in a legend
}

TEST_CASE("the run beside may be another scene's, and one in fixed steps") {
    const test::Shot both(test::scene_from(
        text_of("beside: {own_label: exact, label: steps, set: run.time_step=0.05}",
                "monitors: [overlap], ")));
    const std::vector<std::size_t> boxes = boxes_of(*both.panels);
    CHECK(column(table_at(both, 0, boxes[0]), "x") == column(table_at(both, 0, boxes[1]), "x"));
    CHECK(column(table_at(both, 39, boxes[0]), "x") != column(table_at(both, 39, boxes[1]), "x"));
    // The line of numbers of each run stands behind its box.
    const auto overlap = [&](std::size_t box) {
        return std::get<double>(column(table_at(both, 39, box + 1), "value").front());
    };
    CHECK(overlap(boxes[0]) < 1e-9);
    CHECK(overlap(boxes[1]) > 1.0);
}

TEST_CASE("beads on a wire stand one above the other") {
    const test::Shot both(
        test::scene_from("title: T\nbox: {length: 12}\ngas: [{count: 6, radius: 0.1, speed: 1}]\n"
                         "run: {until: 8}\nfilm: {size: [640, 360], fps: 10, seconds: 2, panels: "
                         "[velocity-histogram],"
                         " beside: {own_label: a, label: b, set: seed=7}}\n"));
    const std::vector<std::size_t> boxes = boxes_of(*both.panels);
    const Slot &first = both.panels->panels()[boxes[0]].slot,
               &second = both.panels->panels()[boxes[1]].slot;
    CHECK(first.x == second.x);
    CHECK(second.y >= first.y + first.height);
    FramePainter painter(*both.panels);
    painter.paint(both.frames.back());
}

// At 1080p a unit is 30 pixels: 260 pixels of world lines.
TEST_CASE("world lines of two wires are high, and of one span of time") {
    for (const std::string layout : {"wide-gas", "side-by-side"}) {
        CAPTURE(layout);
        const test::Shot both(test::scene_from(
            "title: T\nbox: {length: 12}\ngas: [{count: 6, radius: 0.1, speed: 1}]\nrun: {until: "
            "40}\nfilm: {fps: 4, seconds: 8, panels: [], beside: {own_label: a, label: b, set: "
            "gas.0.speed=5}, template: " +
            layout + "}\n"));
        const std::vector<std::size_t> boxes = boxes_of(*both.panels);
        const auto memory = [&](std::size_t box) {
            return dynamic_cast<const LinePanel&>(*both.panels->panels()[boxes[box]].panel)
                .memory();
        };
        CHECK(memory(0) == memory(1));
        const Grid grid(both.scene.film.layout, both.scene.film.size);
        const double overhead = 8.0;  // units: the wire, its beads and the words
        for (const std::size_t box : boxes)
            CHECK(grid.place(both.panels->panels()[box].slot).height - overhead * grid.unit() >=
                  260.0);
        const TextLog log;
        FramePainter(*both.panels).paint(both.frames.back());
        CHECK(std::ranges::count(log.lines, "time before now", &DrawnLine::markup) == 2);
    }
}

TEST_CASE("two runs in one box have one place and the colours that they have in plots") {
    const test::Shot both(
        test::scene_from(text_of("beside: {own_label: a, label: b, set: seed=7, overlaid: true}")));
    const std::vector<std::size_t> boxes = boxes_of(*both.panels);
    const std::vector<Rect> places =
        both.panels->boxes(Grid(both.scene.film.layout, both.scene.film.size));
    REQUIRE(places.size() == 2);
    CHECK(places[0].x == places[1].x);
    CHECK(places[0].width == places[1].width);
    const Theme& theme = theme_of(both.scene.film.theme);
    for (const std::size_t run : {0U, 1U}) {
        const std::string own = hex_of(plot::color_of(plot::stroke_of_run(run).role, theme));
        for (const TableCell& cell : column(table_at(both, 20, boxes[run]), "colour"))
            CHECK(std::get<std::string>(cell) == own);
    }
    CHECK(column(table_at(both, 20, boxes[0]), "x") != column(table_at(both, 20, boxes[1]), "x"));
}

TEST_CASE("a reversal is announced over the runs that are reversed") {
    for (const auto& [set, runs] : {std::pair{"seed=7", 2}, std::pair{"\"run.events=[]\"", 1}}) {
        CAPTURE(set);
        const test::Shot both(test::scene_from(
            "title: T\nbox: {size: [20, 15]}\n"
            "gas: [{name: disks, count: 30, radius: 0.4, temperature: 1}]\n"
            "run: {until: 6, events: [{at: 2, reverse: velocities}]}\n"
            "film: {size: [640, 360], fps: 10, seconds: 20, panels: [], template: side-by-side, "
            "beside: {own_label: a, label: b, set: " +
            std::string(set) + "}}\n"));
        const auto stopped = std::ranges::find_if(both.frames, [](const FrameData& frame) {
            return frame.tick.phase == Phase::reversing;
        });
        REQUIRE(stopped != both.frames.end());
        const TextLog log;
        FramePainter(*both.panels).paint(*stopped);
        CHECK(std::ranges::count(log.lines, "velocities reversed", &DrawnLine::markup) == runs);
    }
}
