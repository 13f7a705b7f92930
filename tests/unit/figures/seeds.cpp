// Figures of the mean of several runs, against those runs made one by one.
#include <doctest/doctest.h>

#include <cmath>
#include <mutex>
#include <set>
#include <thread>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/series_panel.h"
#include "stats/means/mean_error.h"
#include "support/figure_run.h"
#include "support/scene_text.h"

using namespace carom;
using test::run_of;

namespace {

constexpr std::optional<VectorFormat> pixels{};

Scene scene_of(const std::string& figures, const std::string& count = "60") {
    return test::scene_from("title: A gas\nseed: 5\nbox: {size: [40, 30]}\ngas: [{count: " + count +
                            ", radius: 0.4, temperature: 2}]\n"
                            "run: {until: 6, events: [{at: 3, reverse: velocities}]}\n"
                            "film: {seconds: 2}\nfigures:\n" +
                            figures);
}

const HistogramPanel& histogram_of(const FigureRun& run, std::size_t index = 0) {
    return dynamic_cast<const HistogramPanel&>(*run.figures()[index].panel);
}

const PanelState& state_of(const FigureRun& run, std::size_t index = 0) {
    return *run.figures()[index].moments.front().state;
}

const std::string bars = "  - {name: a, kind: speed-histogram, at: 3, bins: 9, range: [0, 6]";

}  // namespace

TEST_CASE("the error of a mean is that of the textbook") {
    // Values 2, 4, 4, 4, 5, 5, 7, 9: mean 5, sum of squares about it 32.
    const MeanError of_eight = mean_error({2, 4, 4, 4, 5, 5, 7, 9});
    CHECK(of_eight.mean == 5.0);
    CHECK(of_eight.error == doctest::Approx(std::sqrt(32.0 / 7.0 / 8.0)));
    const double nan = std::nan("");
    CHECK(mean_error({nan, 1, 3}).mean == 2.0);
    CHECK(mean_error({nan, 1, 3}).error == doctest::Approx(1.0));
    CHECK(std::isnan(mean_error({nan, 3}).error));
    CHECK(std::isnan(mean_error({}).mean));
}

TEST_CASE("bars of several seeds are the means of the runs of these seeds, with their errors") {
    const FigureRun together = run_of(scene_of(bars + ", seeds: 5}\n"));
    std::vector<std::vector<double>> counts(9);
    std::vector<double> means, squares;
    Scene scene = scene_of(bars + "}\n");
    for (std::uint64_t seed = 5; seed < 10; ++seed) {
        scene.seed = scene.gas.seed = seed;
        const FigureRun one = run_of(scene);
        const MeanHistogram& its = HistogramPanel::histograms(state_of(one)).front();
        for (std::size_t i = 0; i < 9; ++i) counts[i].push_back(its.counts[i]);
        means.push_back(its.mean);
        squares.push_back(its.deviation * its.deviation + its.mean * its.mean);
    }
    const MeanHistogram& all = HistogramPanel::histograms(state_of(together)).front();
    const std::vector<double>& errors = HistogramPanel::errors(state_of(together)).front();
    double sum = all.below + all.above;
    for (std::size_t i = 0; i < 9; ++i) {
        const MeanError expected = mean_error(counts[i]);
        CHECK(all.counts[i] == doctest::Approx(expected.mean));
        CHECK(errors[i] == doctest::Approx(expected.error));
        sum += all.counts[i];
    }
    CHECK(sum == doctest::Approx(60.0));
    CHECK(all.mean == doctest::Approx(mean_error(means).mean));
    CHECK(all.deviation ==
          doctest::Approx(std::sqrt(mean_error(squares).mean - all.mean * all.mean)));
}

TEST_CASE("lines of several seeds are means with errors, and none without seeds") {
    const std::string line = "  - {name: a, kind: energy-by-species";
    const FigureRun together = run_of(scene_of(line + ", seeds: 4}\n"));
    const auto& panel = dynamic_cast<const SeriesPanel&>(*together.figures()[0].panel);
    Scene scene = scene_of(line + "}\n");
    std::vector<std::vector<double>> lines;
    for (std::uint64_t seed = 5; seed < 9; ++seed) {
        scene.seed = scene.gas.seed = seed;
        const FigureRun one = run_of(scene);
        lines.push_back(
            dynamic_cast<const SeriesPanel&>(*one.figures()[0].panel).record().runs.front().y[0]);
    }
    REQUIRE(panel.record().runs.front().y[0].size() == lines[0].size());
    for (std::size_t i = 0; i < lines[0].size(); ++i) {
        const MeanError expected = mean_error({lines[0][i], lines[1][i], lines[2][i], lines[3][i]});
        CHECK(panel.record().runs.front().y[0][i] == doctest::Approx(expected.mean));
        CHECK(panel.record().runs.front().error[0][i] == doctest::Approx(expected.error));
        CHECK(expected.error > 0.0);  // drawn velocities: energies differ
    }
}

TEST_CASE("tables have the errors, captions say of how many runs") {
    const FigureRun run =
        run_of(scene_of(bars + ", seeds: 3}\n  - {name: b, kind: entropy, seeds: 3}\n" +
                        "  - {name: c, kind: speed-histogram}\n"));
    const Table histogram = table_of(run.figures()[0]), series = table_of(run.figures()[1]);
    CHECK(column_names(histogram).back() == "standard error (count)");
    CHECK(column_names(series).back() == "standard error of entropy (1)");
    CHECK(column_names(table_of(run.figures()[2])).back() == "value (count)");
    CHECK(std::get<double>(histogram.rows[3].back()) ==
          HistogramPanel::errors(state_of(run))[0][3]);
    CHECK(std::holds_alternative<double>(series.rows[3].back()));
    for (const Table* table : {&histogram, &series})
        for (const std::vector<TableCell>& row : table->rows)
            CHECK(row.size() == table->columns.size());
    CHECK(words_of(run, run.figures()[0])
              .caption.find("mean of 3 independent runs of 60 disks each") != std::string::npos);
}

TEST_CASE("captions and alternative texts say once that a figure is a mean") {
    const FigureRun run =
        run_of(scene_of(bars + ", seeds: 3}\n  - {name: b, kind: entropy, at: 3, seeds: 3}\n"
                               "  - {name: c, kind: thermometer, at: 3, seeds: 3}\n"));
    const FigureWords histogram = words_of(run, run.figures()[0]),
                      entropy = words_of(run, run.figures()[1]),
                      dial = words_of(run, run.figures()[2]);
    CHECK(histogram.alt.starts_with("Speed histogram at time 3, mean of 3 independent runs. "));
    CHECK(entropy.alt.starts_with("Entropy at time 3, mean of 3 independent runs. Entropy "));
    CHECK(entropy.alt.find(" ± ") != std::string::npos);
    CHECK(dial.alt.starts_with("Thermometer at time 3, mean of 3 independent runs. Temperature "));
    for (const std::string& words : {dial.alt, dial.caption}) {
        const std::size_t first = words.find("mean of 3");
        REQUIRE(first != std::string::npos);
        CHECK(words.find("mean of 3", first + 1) == std::string::npos);
        CHECK(words.find(" ± ") != std::string::npos);
    }
}

TEST_CASE("seeds do not change the other figures, and threads change nothing") {
    const std::string other = "  - {name: z, kind: energy-histogram}\n";
    const std::string both = bars + ", seeds: 6, fit: true}\n" + other;
    const FigureRun alone = run_of(scene_of(other)), one = run_of(scene_of(both)),
                    two = run_of(scene_of(both), 4);
    const auto bytes = [](const FigureRun& run, std::size_t index) {
        return draw_figure(run, run.figures()[index], pixels, {"t", "d"}).file();
    };
    CHECK(bytes(alone, 0) == bytes(one, 1));
    CHECK(bytes(one, 0) == bytes(two, 0));
    CHECK(csv(table_of(one.figures()[0])) == csv(table_of(two.figures()[0])));
}

TEST_CASE("runs of several seeds take no more threads than they are given") {
    for (const int threads : {1, 2}) {
        std::mutex mutex;
        std::set<std::thread::id> seen;
        const Scene scene = scene_of(bars + ", seeds: 8}\n");
        const FigureRun run(scene, threads, {.advance = [&](double) {
                                const std::lock_guard lock(mutex);
                                seen.insert(std::this_thread::get_id());
                            }});
        CHECK(seen.size() <= static_cast<std::size_t>(threads));
        if (threads == 1) CHECK(seen.contains(std::this_thread::get_id()));
    }
}

TEST_CASE("all runs together tell how far they have come, each of its two passes") {
    const std::string two = ", compare: [{label: a, set: seed=7}, {label: b, set: run.until=8}]}\n";
    const std::string later =
        ", compare: [{label: a, set: run.equilibrate=3}, {label: b, set: seed=7}]}\n";
    for (const auto& asked : {std::pair{bars + "}\n", 12.0},
                              {bars + ", seeds: 4}\n", 48.0},
                              {bars + two, 28.0},
                              {bars + later, 27.0}}) {
        const std::string& figures = asked.first;
        const double expected = asked.second;
        CAPTURE(figures);
        std::mutex mutex;
        double all = 0.0, done = 0.0;
        const Scene scene = scene_of(figures);
        const FigureRun run(scene, 2,
                            {.begin = [&](double time) { all = time; },
                             .advance =
                                 [&](double time) {
                                     const std::lock_guard lock(mutex);
                                     done += time;
                                 }});
        CHECK(all == expected);
        CHECK(done == doctest::Approx(expected));
    }
}

TEST_CASE("a test of several runs counts all their particles") {
    const FigureRun few = run_of(scene_of(bars + ", seeds: 8, test: true}\n", "20"));
    const ChiSquared test = histogram_of(few).test(state_of(few), 0).value();
    CHECK(test.classes >= 6);  // of 160 values; a run of 20 has two or three
    CHECK(test.p > 1e-4);
}

// 100 particles in slabs 5 wide and 40 high.
TEST_CASE("a profile of several seeds is the mean of theirs, with its errors") {
    const std::string profile = "  - {name: a, kind: profile, cells: 4, over: [1, 3]";
    const auto column = [](const FigureRun& run, std::size_t index, const std::string& part) {
        std::vector<double> values;
        for (const std::vector<TableCell>& row : table_of(run.figures()[0]).rows)
            if (std::get<std::string>(row[0]) == part)
                values.push_back(std::get<double>(row[index]));
        return values;
    };
    const FigureRun together = run_of(scene_of(profile + ", seeds: 4}\n"));
    const Table table = table_of(together.figures()[0]);
    CHECK(column_names(table).back() == "standard error of density (1/length^2)");
    const std::vector<double> means = column(together, 4, "profile"),
                              errors = column(together, 5, "profile");
    REQUIRE(means.size() == 8);  // the ends of four slabs
    Scene scene = scene_of(profile + "}\n");
    std::vector<std::vector<double>> each;
    for (std::uint64_t seed = 5; seed < 9; ++seed) {
        scene.seed = scene.gas.seed = seed;
        each.push_back(column(run_of(scene), 4, "profile"));
    }
    for (std::size_t i = 0; i < means.size(); ++i) {
        const MeanError expected = mean_error({each[0][i], each[1][i], each[2][i], each[3][i]});
        CHECK(means[i] == doctest::Approx(expected.mean));
        CHECK(errors[i] == doctest::Approx(expected.error));
        CHECK(expected.error > 0.0);
    }
}

TEST_CASE("the mean of counts is no whole number") {
    const std::string counter = "  - {name: a, kind: counter, at: 1.5";
    const auto counted = [](const FigureRun& run) {
        return std::get<double>(table_of(run.figures()[0]).rows[0][2]);
    };
    std::vector<double> counts;
    for (int seed = 5; seed < 8; ++seed) {
        Scene scene = scene_of(counter + "}\n");
        scene.seed = scene.gas.seed = static_cast<std::uint64_t>(seed);
        const FigureRun one = run_of(scene);
        counts.push_back(
            static_cast<double>(std::get<std::int64_t>(table_of(one.figures()[0]).rows[0][2])));
    }
    const MeanError expected = mean_error(counts);
    REQUIRE(std::floor(expected.mean) != expected.mean);
    const FigureRun mean = run_of(scene_of(counter + ", seeds: 3}\n"));
    CHECK(counted(mean) == doctest::Approx(expected.mean));
    const Table table = table_of(mean.figures()[0]);
    CHECK(column_names(table)[3] == "standard error");
    CHECK(std::get<double>(table.rows[0][3]) == doctest::Approx(expected.error));
}

TEST_CASE("a mean begins no earlier than the run, and one since the start at 0") {
    const FigureRun run =
        run_of(scene_of("  - {name: a, kind: speed-histogram, over: {window: 100}, at: 2}\n"
                        "  - {name: b, kind: speed-histogram, over: start, at: 2}\n"
                        "  - {name: c, kind: speed-histogram, at: 2}\n"));
    const auto alt = [&](std::size_t k) { return words_of(run, run.figures()[k]).alt; };
    CHECK(alt(0).starts_with("Speed histogram from time 0 to 2"));
    CHECK(alt(1).starts_with("Speed histogram from time 0 to 2"));
    CHECK(alt(2).starts_with("Speed histogram at time 2"));
}
