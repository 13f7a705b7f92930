// Figures that compare runs, against those runs made one by one.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "draw/style.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "panels/plot/notes.h"
#include "panels/plot/plot_panel.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/series_panel.h"
#include "scene/limits.h"
#include "support/figure_run.h"
#include "support/relative.h"
#include "support/scene_text.h"
#include "util/text.h"

using namespace carom;
using test::run_of;

namespace {

constexpr std::optional<VectorFormat> pixels{};

Scene scene_of(const std::string& figures, const std::string& gas = "count: 60, temperature: 2",
               const std::string& run = "until: 6", const Overrides& overrides = {}) {
    return test::scene_from("title: A gas\nseed: 5\nbox: {size: [40, 30]}\ngas: [{radius: 0.4, " +
                                gas + "}]\nrun: {" + run + "}\nfilm: {seconds: 2}\nfigures:\n" +
                                figures,
                            overrides);
}

const PanelState& state_of(const FigureRun& run, std::size_t index = 0) {
    return *run.figures()[index].moments.front().state;
}

std::string message_of(const std::string& figures) {
    try {
        scene_of(figures);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

const std::string bars = "  - {name: a, kind: speed-histogram, at: 3, bins: 9, range: [0, 6]";
const std::string warmer =
    ", compare: [{label: cold}, {label: warm, set: gas.0.temperature=4}, "
    "{label: few, set: [gas.0.count=20, seed=9]}]}\n";

// The rows of a table that are of one run, without its name.
std::vector<std::vector<TableCell>> rows_of(const Table& table, const std::string& run) {
    std::vector<std::vector<TableCell>> rows;
    for (const std::vector<TableCell>& row : table.rows)
        if (std::get<std::string>(row.front()) == run)
            rows.emplace_back(row.begin() + 1, row.end());
    return rows;
}

double number(const TableCell& cell) { return std::get<double>(cell); }

}  // namespace

TEST_CASE("runs of several seeds side by side are the runs of these seeds") {
    const FigureRun together = run_of(scene_of(bars + ", compare: {seeds: 3}}\n"));
    const std::vector<MeanHistogram>& shown = HistogramPanel::histograms(state_of(together));
    REQUIRE(shown.size() == 3);
    Scene scene = scene_of(bars + "}\n");
    for (std::uint64_t k = 0; k < 3; ++k) {
        scene.seed = scene.gas.seed = 5 + k;
        const FigureRun one = run_of(scene);
        CHECK(HistogramPanel::histograms(state_of(one)).front().counts == shown[k].counts);
        const FigureSide& side = together.figures()[0].sides.at(k);
        CHECK(side.label == "seed " + std::to_string(5 + k));
        CHECK(side.particles == 60);
        CHECK(side.time == 3.0);
        CHECK(side.collisions.particle == one.figures()[0].moments[0].collisions.particle);
        CHECK(side.account == "mean " + three_digits(shown[k].mean));
    }
}

TEST_CASE("a run with other values is that of a scene with these values") {
    const FigureRun together = run_of(scene_of(bars + warmer));
    const std::vector<MeanHistogram>& shown = HistogramPanel::histograms(state_of(together));
    const Scene warm =
        scene_of(bars + "}\n", "count: 60, temperature: 2", "until: 6", {"gas.0.temperature=4"});
    const Scene few = scene_of(bars + "}\n", "count: 60, temperature: 2", "until: 6",
                               {"gas.0.count=20", "seed=9"});
    // Of 60 particles and of 20: shares in per cent.
    for (const auto& [scene, k, count] :
         {std::tuple{&warm, std::size_t{1}, 60}, {&few, std::size_t{2}, 20}}) {
        const FigureRun one = run_of(*scene);
        const MeanHistogram& its = HistogramPanel::histograms(state_of(one)).front();
        double sum = shown[k].below + shown[k].above;
        for (std::size_t i = 0; i < its.counts.size(); ++i) {
            CHECK(shown[k].counts[i] == doctest::Approx(100.0 * its.counts[i] / count));
            sum += shown[k].counts[i];
        }
        CHECK(sum == doctest::Approx(100.0));
        CHECK(shown[k].mean == its.mean);
    }
}

TEST_CASE("the table names the run of each row, and has the numbers of that run") {
    const FigureRun together =
        run_of(scene_of(bars + warmer + "  - {name: b, kind: entropy" + warmer));
    const Table table = table_of(together.figures()[0]), series = table_of(together.figures()[1]);
    CHECK(column_names(table).front() == "run");
    CHECK(column_names(table).back() == "value (per cent)");
    for (const std::string run : {"cold", "warm", "few"}) {
        double bars_sum = 0.0, curve = 0.0;
        for (const std::vector<TableCell>& row : rows_of(table, run)) {
            const std::string part = std::get<std::string>(row[0]);
            if (part == "bar" || part == "above" || part == "below") bars_sum += number(row[4]);
            if (part == "curve") curve = std::max(curve, number(row[4]));
            CHECK(part.find("mean") == std::string::npos);  // none is drawn
        }
        CHECK(bars_sum == doctest::Approx(100.0));
        CHECK(curve > 5.0);
        CHECK(curve < 50.0);
    }
    const FigureRun alone = run_of(scene_of("  - {name: b, kind: entropy}\n"));
    const Table own = table_of(alone.figures()[0]);
    const std::vector<std::vector<TableCell>> cold = rows_of(series, "cold");
    CHECK(cold == own.rows);
    CHECK(rows_of(series, "warm").size() == own.rows.size());
    for (const Table* one : {&table, &series})
        for (const auto& row : one->rows) CHECK(row.size() == one->columns.size());
}

TEST_CASE("ways back in numbers of more and more bits, each as a run of its own") {
    const std::string run = "until: 24, precision: 192, events: [{at: 12, reverse: velocities}]";
    const std::string kind = "  - {name: a, kind: return-distance, against: collisions";
    const FigureRun together = run_of(
        scene_of(kind +
                     ", compare: [{label: 53 bits, set: run.precision=double}, {label: 113 bits, "
                     "set: run.precision=113}, {label: 192 bits}]}\n",
                 "count: 260, temperature: 2", run),
        3);
    const Figure& figure = together.figures()[0];
    const Table table = table_of(figure);
    double first = 0.0;
    for (const auto& [label, bits] :
         {std::pair{"53 bits", "double"}, {"113 bits", "113"}, {"192 bits", "192"}}) {
        const FigureRun alone = run_of(scene_of(kind + "}\n", "count: 260, temperature: 2", run,
                                                {std::string("run.precision=") + bits}));
        std::vector<std::vector<TableCell>> own;
        for (const std::vector<TableCell>& row : table_of(alone.figures()[0]).rows)
            if (std::get<std::string>(row[1]) != "root mean square" &&
                std::get<std::string>(row[0]) != "level")
                own.push_back(row);
        std::vector<std::vector<TableCell>> its = rows_of(table, label);
        std::erase_if(its,
                      [](const auto& row) { return std::get<std::string>(row[0]) == "level"; });
        REQUIRE(its.size() > 20);
        CHECK(its == own);
        const auto step = std::ranges::find_if(its, [](const std::vector<TableCell>& row) {
            return std::get<std::string>(row[0]) == "line" && number(row[5]) > 2.0;
        });
        REQUIRE(step != its.end());
        if (first != 0.0) CHECK(number((*step)[6]) < first - 15.0);
        first = number((*step)[6]);
    }
    CHECK(figure.sides[0].account.starts_with("one radius away after "));
    CHECK(figure.sides[2].account.find("\u207B") != std::string::npos);  // a small power of ten
    CHECK(figure.sides[2].account.find("return error ") != std::string::npos);
    const FigureWords words = words_of(together, figure);
    CHECK(words.caption.find("53 bits (precision double; 260 disks, ") != std::string::npos);
    CHECK(words.caption.find("Upper estimate of the growth: small distances double ") !=
          std::string::npos);
    for (const auto& format : {pixels, std::optional(VectorFormat::svg)})
        CHECK(draw_figure(together, figure, format, {"t", "d"}).file().size() > 1000);
}

// A column of gas, one twice as hot, and one in a box half as high again.
TEST_CASE("profiles of runs side by side are those of each, with its law and its height") {
    const auto scene = [](const std::string& compare, const Overrides& overrides = {}) {
        return test::scene_from(
            "title: A gas\nseed: 5\nbox: {size: [20, 40]}\ngravity: [0, -0.05]\n"
            "gas: [{count: 60, radius: 0.1, temperature: {exact: 1}}]\nrun: {until: 6}\n"
            "film: {seconds: 2}\nfigures:\n  - {name: a, kind: profile, component: y, cells: 5" +
                compare + "}\n",
            overrides);
    };
    const FigureRun together =
        run_of(scene(", compare: [{label: one}, {label: hot, set: gas.0.temperature.exact=2}, "
                     "{label: high, set: \"box.size=[20, 60]\"}]"));
    const Table table = table_of(together.figures()[0]);
    std::size_t k = 0;
    struct Compared {
        const char *label, *set;
        double height;
    };
    for (const Compared& compared : {Compared{"one", "seed=5", 40.0},
                                     {"hot", "gas.0.temperature.exact=2", 40.0},
                                     {"high", "box.size=[20, 60]", 60.0}}) {
        const auto& [label, set, height] = compared;
        CAPTURE(compared.label);
        const FigureRun alone = run_of(scene("", {set}));
        const std::vector<std::vector<TableCell>> its = rows_of(table, label);
        CHECK(its == table_of(alone.figures()[0]).rows);
        double top = 0.0, sum = 0.0;
        for (const std::vector<TableCell>& row : its) {
            if (std::get<std::string>(row[0]) != "profile") continue;
            top = std::max(top, number(row[4]));
            sum += 0.5 * number(row[3]) * 20.0 * height / 5.0;  // each slab has two ends
        }
        CHECK(top == doctest::Approx(height));
        CHECK(sum == doctest::Approx(60.0));
        CHECK(together.figures()[0].sides[k++].account.starts_with("between "));
    }
}

// Longer and shorter lags, larger and smaller disks, more and fewer rings.
TEST_CASE("curves of runs side by side are those of each, on its own points") {
    const std::string gas = "count: 300, temperature: 4";  // dense: velocities are forgotten
    struct Compared {
        const char *figure, *part, *first, *second;
    };
    for (const auto& [figure, part, first, second] :
         {Compared{"pair-correlation", "bar", "gas.0.radius=0.3", "gas.0.radius=0.6"},
          Compared{"pair-correlation, to: 3.7", "bar", "gas.0.radius=0.3", "gas.0.radius=0.7"},
          Compared{"velocity-autocorrelation", "curve", "run.until=4", "run.until=10"},
          Compared{"mean-squared-displacement, origins: all", "curve", "run.until=10",
                   "run.until=4"}}) {
        CAPTURE(figure);
        const std::string begin = "  - {name: a, kind: " + std::string(figure);
        const FigureRun together =
            run_of(scene_of(begin + ", compare: [{label: one, set: " + first +
                                "}, {label: other, set: " + second + "}]}\n",
                            gas));
        const Figure& both = together.figures()[0];
        std::size_t k = 0;
        for (const auto& [label, set] : {std::pair{"one", first}, std::pair{"other", second}}) {
            CAPTURE(label);
            const FigureRun alone =
                run_of(scene_of(begin + "}\n", gas, "until: 6", {std::string(set)}));
            const auto of_part = [&](std::vector<std::vector<TableCell>> rows) {
                std::erase_if(rows, [&](const std::vector<TableCell>& row) {
                    return std::get<std::string>(row.front()) != part;
                });
                return rows;
            };
            const auto its = of_part(rows_of(table_of(both), label));
            CHECK(its.size() > 10);
            CHECK(its == of_part(table_of(alone.figures()[0]).rows));
            const std::string account = capitalised(both.sides[k++].account) + ".";
            const std::string alt = words_of(alone, alone.figures()[0]).alt;
            CHECK_MESSAGE(alt.find(account) != std::string::npos, alt, account);
        }
    }
}

TEST_CASE("the mean of runs with other disks is over the rings of the first run") {
    const std::string begin = "  - {name: a, kind: pair-correlation",
                      gas = "count: 60, temperature: 2";
    const auto edges = [&](const std::string& seeds) {
        const FigureRun run = run_of(scene_of(begin + seeds + "}\n", gas, "until: 6",
                                              {"gas.0.radius={uniform: [0.2, 0.6]}"}));
        std::vector<std::pair<double, double>> all;
        for (const std::vector<TableCell>& row : table_of(run.figures()[0]).rows)
            if (std::get<std::string>(row[0]) == "bar")
                all.emplace_back(number(row[2]), number(row[3]));
        return all;
    };
    CHECK(edges("").size() > 10);
    CHECK(edges(", seeds: 3") == edges(""));
}

TEST_CASE("all runs find room on the axes") {
    // The second gas is four times as fast: an axis for the first alone would end far below it.
    const std::string fast =
        ", compare: [{label: slow}, {label: fast, set: gas.0.temperature=32}]}\n";
    const FigureRun together = run_of(scene_of("  - {name: a, kind: speed-histogram, at: 3" + fast +
                                               "  - {name: b, kind: temperature" + fast));
    for (const MeanHistogram& one : HistogramPanel::histograms(state_of(together)))
        CHECK(one.above <= 3.0);
    const auto& panel = dynamic_cast<const HistogramPanel&>(*together.figures()[0].panel);
    for (const std::vector<TableCell>& row : table_of(together.figures()[0]).rows)
        if (std::get<std::string>(row[1]) == "curve") CHECK(number(row[5]) <= panel.tallest());
    const Canvas low = draw_figure(together, together.figures()[1], pixels, {"", ""});
    const FigureRun alone = run_of(scene_of("  - {name: b, kind: temperature}\n"));
    CHECK(low.size().width ==
          draw_figure(alone, alone.figures()[0], pixels, {"", ""}).size().width);
}

TEST_CASE("each run may end at its own time, and is told to") {
    const FigureRun together = run_of(
        scene_of("  - {name: b, kind: temperature, compare: [{label: long}, {label: short, set: "
                 "run.until=2}]}\n"
                 "  - {name: other, kind: gas, at: 5}\n"));  // which the short run does not have
    const Figure& figure = together.figures()[0];
    CHECK(figure.sides[0].time == 6.0);
    CHECK(figure.sides[1].time == 2.0);
    CHECK(number(rows_of(table_of(figure), "short").back()[2]) == 2.0);
    CHECK(number(rows_of(table_of(figure), "long").back()[2]) == 6.0);
    const FigureWords words = words_of(together, figure);
    CHECK(words.caption.starts_with(
        "A gas. Temperature of 2 runs, each at its end: long (60 disks, "));
    CHECK(words.caption.find(figure.sides[1].account + ", at time 2)") != std::string::npos);
    CHECK(figure.sides[1].account.starts_with("temperature "));
}

TEST_CASE("titles do not give the first run's time to runs that end at others") {
    const auto title_of = [](const std::string& kind, const std::string& second) {
        const FigureRun run =
            run_of(scene_of("  - {name: b, kind: " + kind +
                            ", compare: [{label: a}, {label: c, set: " + second + "}]}\n"));
        const auto& panel = dynamic_cast<const PlotPanel&>(*run.figures()[0].panel);
        std::string title;
        const plot::Plot plot = panel.plot(&state_of(run));
        for (const auto& piece : plot.titles.at(0).pieces) title += piece.markup;
        return title;
    };
    for (const std::string kind : {"speed-histogram", "pair-correlation"}) {
        CAPTURE(kind);
        const std::string one = title_of(kind + ", over: start", "run.until=6");
        CHECK(one.find("until time 6") != std::string::npos);
        const std::string apart = title_of(kind + ", over: start", "run.until=2");
        CHECK(apart.find("until the end") != std::string::npos);
        CHECK(title_of(kind + ", over: {window: 1}", "run.until=2").find("last 1") !=
              std::string::npos);
        CHECK(title_of(kind + ", over: now", "run.until=2").find("at the end") !=
              std::string::npos);
    }
}

TEST_CASE("captions and alternative texts have the numbers of every run") {
    const FigureRun together = run_of(scene_of(bars + warmer));
    const FigureWords words = words_of(together, together.figures()[0]);
    for (const FigureSide& side : together.figures()[0].sides) {
        const std::string differs = side.label == "warm"  ? "temperature 4; "
                                    : side.label == "few" ? "number of particles 20; "
                                                          : "";
        const std::string words_of_it =
            fmt::format("{} ({}{} disks, {} collision", side.label, differs, side.particles,
                        grouped(side.collisions.particle));
        const std::size_t begin = words.caption.find(words_of_it);
        REQUIRE(begin != std::string::npos);
        CHECK(words.caption.find(" between them, " + side.account + ")", begin) <
              words.caption.find(')', begin));
        CHECK(words.alt.find(side.label + ", " + side.account) != std::string::npos);
    }
    CHECK(words.caption.starts_with("A gas. Speed histogram at time 3 of 3 runs: cold ("));
    CHECK(words.caption.ends_with("; reduced units."));
}

TEST_CASE("a caption gives a change that its label does not, a number as a whole") {
    const auto caption = [](const std::string& label, const std::string& set) {
        const FigureRun run = run_of(scene_of(
            "  - {name: b, kind: temperature, compare: [{label: as it is}, {label: " + label +
            ", set: " + set + "}]}\n"));
        return words_of(run, run.figures()[0]).caption;
    };
    CHECK(caption("10 of them", "gas.0.temperature=1").find("(temperature 1; ") !=
          std::string::npos);
    CHECK(caption("T 1.5", "gas.0.temperature=5").find("(temperature 5; ") != std::string::npos);
    CHECK(caption("T = 15", "gas.0.temperature=15").find("temperature 15;") == std::string::npos);
    CHECK(caption("(15)", "gas.0.temperature=15").find("temperature 15;") == std::string::npos);
}

TEST_CASE("a comparison changes no other figure, and threads change nothing") {
    const std::string other = "  - {name: z, kind: energy-histogram}\n";
    const std::string both = other + bars + warmer + "  - {name: y, kind: gas}\n";
    const FigureRun alone = run_of(scene_of(other)), one = run_of(scene_of(both)),
                    four = run_of(scene_of(both), 4);
    REQUIRE(one.figures().size() == 3);
    CHECK(one.figures()[1].spec->name == "a");
    CHECK(one.figures()[2].spec->name == "y");
    const auto bytes = [](const FigureRun& run, std::size_t index,
                          std::optional<VectorFormat> format) {
        return draw_figure(run, run.figures()[index], format, {"t", "d"}).file();
    };
    CHECK(bytes(alone, 0, pixels) == bytes(one, 0, pixels));
    for (const auto& format :
         {pixels, std::optional(VectorFormat::svg), std::optional(VectorFormat::pdf)})
        CHECK(bytes(one, 1, format) == bytes(four, 1, format));
    CHECK(csv(table_of(one.figures()[1])) == csv(table_of(four.figures()[1])));
}

TEST_CASE(
    "every run has a line of its own by its dashes alone, and by its colour alone but in print") {
    DiskPainter disks;
    for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark, ThemeKind::print}) {
        const Theme& colors = theme(kind);
        const DrawContext dc{{0, 0, 400, 300}, 10, colors, disks};
        std::set<std::vector<double>> dashes;
        std::set<std::uint32_t> inks;
        for (std::size_t k = 0; k < most_compared.count(); ++k) {
            const plot::Stroke stroke = plot::stroke_of_run(k);
            dashes.insert(dashes_of(stroke, dc));
            inks.insert(to_pixel(color_of(stroke, colors)));
            CHECK(contrast(color_of(stroke, colors), colors.page) >= 3.0 - 1e-9);
        }
        CHECK(dashes.size() == most_compared.count());
        const std::size_t greys = 4;  // no more are told apart; dashes tell all
        CHECK(inks.size() == (kind == ThemeKind::print ? greys : most_compared.count()));
    }
}

TEST_CASE("a key that is longer than a column takes several rows") {
    DiskPainter disks;
    const DrawContext dc{{0, 0, 360, 300}, 10, theme(ThemeKind::print), disks};
    const auto rows = [&](const std::vector<std::string>& names) {
        plot::Plot plot;
        name_runs(plot, names);
        return height_of_rows(plot, dc, false) / note_height;
    };
    CHECK(rows({}) == 0);
    CHECK(rows({"one", "two", "three"}) == 1);
    CHECK(rows({"a name of some length", "another name like it", "and a third"}) == 2);
    CHECK(rows({std::string(200, 'x'), "short"}) == 2);
}

TEST_CASE(
    "a key has one row where two leave too little to the plot, and none where that cuts much") {
    DiskPainter disks;
    const auto rows = [&](double height, const std::vector<std::string>& names) {
        const DrawContext dc{{0, 0, 360, height}, 10, theme(ThemeKind::print), disks};
        plot::Plot plot;
        plot.notes = {{.wraps = true, .of_last_titles = 1}};
        for (const std::string& name : names)
            plot.notes.front().entries.push_back({.words = {plot::Text(name)}});
        return height_of_rows(plot, dc, false) / note_height;
    };
    std::vector<std::string> names{"light", "heavy"};  // just too long for one row
    while (rows(300, names) < 2)
        for (std::string& name : names) name += "e";
    const std::vector<std::string> longer{std::string(60, 'x'), std::string(60, 'y')};
    CHECK(rows(300, longer) == 2);
    // The heights at which two rows are too many and one is not.
    std::set<double> seen, of_longer;
    for (double height = 20; height < 300; height += 1) {
        seen.insert(rows(height, names));
        of_longer.insert(rows(height, longer));
    }
    CHECK(seen == std::set<double>{0, 1, 2});
    CHECK(of_longer == std::set<double>{0, 2});
}

TEST_CASE("pressure and area of two runs are two paths, with theory where they begin alike") {
    for (const auto& changed :
         {std::pair{"box.walls.top.velocity=-0.1", true}, std::pair{"gas.0.count=10", false}}) {
        const std::string change = changed.first;
        const bool alike = changed.second;
        CAPTURE(change);
        const FigureRun run = run_of(test::scene_from(
            "title: T\nbox: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
            "gas: [{name: a, count: 20, radius: 0.1, temperature: {exact: 2}}]\n"
            "run: {until: 8}\nfilm: {seconds: 2}\n"
            "figures: [{name: f, kind: pressure-volume, at: 8, compare: [{label: fast}, {label: "
            "other, set: " +
            std::string(change) + "}]}]\n"));
        const Table table = table_of(run.figures()[0]);
        const auto of = [&](const std::string& part, const std::string& name) {
            std::vector<std::vector<TableCell>> rows = rows_of(table, name);
            std::erase_if(rows,
                          [&](const auto& row) { return std::get<std::string>(row[0]) != part; });
            return rows;
        };
        CHECK(number(of("path", "fast").back()[2]) == test::relative(100.0, 1e-12));
        CHECK(number(of("path", "other").back()[2]) ==
              test::relative(alike ? 132.0 : 100.0, 1e-12));
        CHECK(of("theory", "fast").empty() == !alike);
    }
}

TEST_CASE("the isotherm of two runs is drawn only if it holds for both") {
    const std::string falls = "gravity=[0, -0.2]";
    for (const std::string& order :
         {"{label: one}, {label: other, set: \"" + falls + "\"}",
          "{label: one, set: \"" + falls + "\"}, {label: other}",
          std::string("{label: one}, {label: other, set: box.walls.top.velocity=-0.1}")}) {
        CAPTURE(order);
        const FigureRun run = run_of(
            test::scene_from("title: T\nbox: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
                             "gas: [{name: a, count: 20, radius: 0.1, temperature: {exact: 2}}]\n"
                             "run: {until: 8}\nfilm: {seconds: 2}\n"
                             "figures: [{name: f, kind: pressure-volume, at: 8, compare: [" +
                             order + "]}]\n"));
        const Table table = table_of(run.figures()[0]);
        const bool has_theory = std::ranges::any_of(rows_of(table, "one"), [](const auto& row) {
            return std::get<std::string>(row[0]) == "theory";
        });
        CHECK(has_theory == order.ends_with("-0.1}"));
    }
}

TEST_CASE("mean squared displacements side by side have a law each, that of their own walls") {
    const std::string periodic = "box.walls=periodic", walls = "box.walls=solid";
    for (const bool are_walls_first : {false, true})
        for (const bool all_origins : {false, true}) {
            CAPTURE(are_walls_first);
            CAPTURE(all_origins);
            const FigureRun run = run_of(test::scene_from(fmt::format(
                "title: A gas\nbox: {{size: [20, 20]}}\n"
                "gas: [{{count: 60, radius: 0.5, temperature: 4}}]\nrun: {{until: 60}}\n"
                "film: {{seconds: 6}}\nfigures:\n"
                "  - {{name: f, kind: mean-squared-displacement, {}compare: [{{label: first, set: "
                "{}}}, {{label: second, set: {}}}]}}\n",
                all_origins ? "origins: all, lags: 10, " : "", are_walls_first ? walls : periodic,
                are_walls_first ? periodic : walls)));
            const Figure& figure = run.figures()[0];
            const std::string account = figure.panel->account(state_of(run));
            CAPTURE(account);
            const std::string bounded = are_walls_first ? "first" : "second";
            const std::string free = are_walls_first ? "second" : "first";
            if (all_origins) {
                for (const FigureSide& side : figure.sides) {
                    CAPTURE(side.account);
                    CHECK(side.account.starts_with(side.label == bounded
                                                       ? "no diffusion coefficient: the walls limit"
                                                       : "D = "));
                }
                continue;
            }
            CHECK(account.find("has D = " + free + " ") != std::string::npos);
            CHECK(account.find("No diffusion coefficient of " + bounded + ": the walls limit") !=
                  std::string::npos);
            const Table table = table_of(figure);
            const auto has_fit = [&](const std::string& name) {
                return std::ranges::any_of(rows_of(table, name), [](const auto& row) {
                    return std::get<std::string>(row[0]) == "fit";
                });
            };
            CHECK(has_fit(free));
            CHECK_FALSE(has_fit(bounded));
        }
}

TEST_CASE("what cannot be compared is refused with the reason") {
    CHECK(message_of("  - {name: a, kind: gas, compare: {seeds: 2}}\n") ==
          "test:8:26: error: `compare` does not apply to a panel of kind `gas`\n"
          "    8 |   - {name: a, kind: gas, compare: {seeds: 2}}\n"
          "      |                          ^^^^^^^\n"
          "  hint: it applies to `speed-histogram`, `energy-histogram`, `velocity-histogram`, "
          "`position-histogram`, `temperature`, `entropy`, `pressure`, `thermometer`, "
          "`stopwatch`, `counter`, `pressure-volume`, `piston`, `piston-histogram`, `sides`, "
          "`flux`, `energy-account`, `particle-speed`, `mean-free-path`, `halves`, "
          "`mean-squared-displacement`, `velocity-autocorrelation`, "
          "`pair-correlation`, `free-path`, `free-time`, `orientational-order`, "
          "`return-distance`, `run-distance` or `profile`");
    CHECK(message_of(bars + ", compare: {seeds: 2}, seeds: 3}\n")
              .find("`compare` and `seeds` cannot be combined") != std::string::npos);
    CHECK(
        message_of(bars + ", compare: {seeds: 1}}\n").find("expected a whole number from 2 to 6") !=
        std::string::npos);
    CHECK(message_of(bars + ", compare: [{label: one}]}\n")
              .find("a list of two or more {label, set}") != std::string::npos);
    CHECK(message_of(bars + ", of: [0, 1], compare: {seeds: 2}}\n")
              .find("a comparison shows one line for each run") != std::string::npos);
    CHECK(message_of(bars + ", compare: [{label: x}, {label: x, set: seed=2}]}\n")
              .find("there is another run with the label `x`") != std::string::npos);
    CHECK(message_of(bars + ", compare: [{label: x}, {label: y, set: seed}]}\n")
              .find("expected KEY.PATH=VALUE, found `seed`") != std::string::npos);
    const std::string invalid =
        message_of(bars + ", compare: [{label: x}, {label: y, set: gas.0.radius=-1}]}\n");
    CHECK(invalid.find(
              "test:8:91: error: with this change the scene is not valid: expected a positive "
              "number") != std::string::npos);
    CHECK(message_of(bars + ", compare: [{label: x}, {label: y, set: figures.0.kind=gas}]}\n")
              .find("with this change the scene") != std::string::npos);
}
