// Numbers in the words of films and figures: they are those of the run at their time.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/style.h"
#include "figures/figure_words.h"
#include "films/first_pass.h"
#include "panels/words/word_numbers.h"
#include "physics/mechanics.h"
#include "runs/run.h"
#include "support/figure_run.h"
#include "support/process.h"
#include "support/scene_text.h"
#include "util/text.h"

using namespace carom;

namespace {

const std::string gas =
    "title: T\nbox: {size: [40, 30]}\n"
    "gas: [{name: light, count: 40, radius: 0.3, temperature: 2},"
    " {name: heavy, count: 10, radius: 0.5, mass: 4, temperature: 0.5}]\n";

Scene filmed(const std::string& events, const std::string& film = "", int fps = 20) {
    return test::scene_from(
        gas + "run: {until: 16, sample_every: 0.25, events: [" + events +
        "]}\nfilm: {seconds: 16, size: [320, 180], fps: " + std::to_string(fps) + ", " +
        (film.empty() ? "panels: []" : film) + "}\n");
}

Scene with_words(const Scene& scene, const std::filesystem::path& cache = {}) {
    Progress silent(Progress::Form::silent, "");
    FilmOptions options;
    options.output = "film.mp4";
    options.cache = cache;
    return prepare(scene, options, silent).scene;
}

// What the run gives at its samples, independently of instruments.
struct Truth {
    double light_energy;
    double deviation;  ///< of the energies
    double collisions;
};

Truth truth_at(double time) {
    Truth truth{NAN, NAN, 0.0};
    const auto samples = [&](const Particles& particles, const Sample& sample,
                             const std::vector<SurfaceState>&) {
        if (sample.time != time) return;
        const Eigen::ArrayXd energy = kinetic_energies(particles, sample).head(40);
        truth.light_energy = energy.mean();
        truth.deviation = std::sqrt((energy - energy.mean()).square().mean());
    };
    const auto collisions = [&](const Particles&, std::span<const Collision> all) {
        for (const Collision& one : all)
            if (one.second.is_particle() && one.time <= time) truth.collisions += 1.0;
    };
    run_physics(filmed(""), {.sample = samples, .collisions = collisions});
    return truth;
}

}  // namespace

TEST_CASE("captions, callouts, texts and the end card have the numbers of their time") {
    const Scene scene = with_words(filmed(
        "{at: 4, caption: \"{light.mean_energy:.6f} {collisions} {light.mean_energy at 12:.6f}\"}, "
        "{at: 12, caption: \"{collisions}\"}",
        "end_card: \"{collisions}\", callouts: [{at: 4, points_to: 0, text: \"{collisions}\"}], "
        "panels: [{kind: text, words: \"{collisions at 12} {light.mean_energy:.6f}\"}]"));
    const Truth start = truth_at(0.0), early = truth_at(4.0), late = truth_at(12.0),
                end = truth_at(16.0);
    REQUIRE(early.collisions > 5.0);
    REQUIRE(end.collisions > late.collisions);
    CHECK(scene.captions[0].words ==
          fmt::format("{:.6f} {} {:.6f}", early.light_energy, early.collisions, late.light_energy));
    CHECK(scene.captions[1].words == fmt::format("{}", late.collisions));
    CHECK(scene.film.end_card == fmt::format("{}", end.collisions));
    CHECK(scene.film.callouts.front().words == fmt::format("{}", early.collisions));
    const PanelSpec& text = scene.film.panels.front();
    CHECK(kind_of(text).text(text) ==
          fmt::format("{} {:.6f}", late.collisions, start.light_energy));
}

TEST_CASE("numbers in words do not depend on the frames where the run has a sample") {
    const std::string event = "{at: 12, caption: \"{temperature:.8f} {mean_free_path:.8f}\"}";
    const std::string words = with_words(filmed(event)).captions.front().words;
    CHECK(with_words(filmed(event, "", 7)).captions.front().words == words);
}

TEST_CASE("numbers in words come back from a cache") {
    const test::TemporaryFolder folder;
    const Scene asked = filmed("{at: 4, caption: \"{light.mean_energy:.6f}\"}");
    const std::string first = with_words(asked, folder.path()).captions.front().words;
    CHECK(with_words(asked, folder.path()).captions.front().words == first);
    CHECK(first == fmt::format("{:.6f}", truth_at(4.0).light_energy));
}

TEST_CASE("a number that the run does not have is an error at its words") {
    std::string message, hint;
    int line = 0;
    try {
        with_words(filmed("{at: 12, caption: \"{diffusion_coefficient}\"}"));
    } catch (const SceneError& error) {
        message = error.diagnostics().front().message;
        hint = error.diagnostics().front().hint;
        line = static_cast<int>(error.diagnostics().front().span.line);
    }
    CHECK(message == "`{diffusion_coefficient}` has no value at time 12");
    CHECK(hint.starts_with("ask for another time, or for another number"));
    CHECK(line == 4);
}

TEST_CASE("numbers are written in the language of the scene") {
    const Scene scene = with_words(
        filmed("{at: 4, caption: \"{light.mean_energy:.2f}\"}", "language: de, panels: []"));
    CHECK(scene.captions.front().words.find(',') != std::string::npos);
    const Quantity& energy = quantities::energy;
    const auto words = [&](double value, int digits, bool are_decimals) {
        return number_words({Language::english},
                            {.name = "x", .digits = digits, .are_decimals = are_decimals}, energy,
                            value);
    };
    CHECK(words(1.23456, 3, false) == "1.23");
    CHECK(words(1.23456, 5, false) == "1.2346");
    CHECK(words(-12.5, 1, true) == "\u221212.5");
    CHECK(words(-0.001, 1, true) == "0.0");
    CHECK(words(123456.0, 2, false) == "123456");
    CHECK(number_words({Language::english}, {.name = "x"}, quantities::count, 12345.0) ==
          grouped(12345));
}

TEST_CASE("the words of figures have the numbers of their time, and what they show") {
    const FigureRun run =
        test::run_of(test::scene_from(
            gas + "run: {until: 16, sample_every: 0.25}\nfigures:\n"
                  "  - {name: e, kind: energy-histogram, at: 12, of: light, fit: true, caption: "
                  "'{light.mean_energy:.6f} {mean:.6f} {fit.mean:.6f} {collisions at 4}', alt: "
                  "'{deviation:.6f}'}\n"));
    const FigureWords words = words_of(run, run.figures().front());
    const Truth late = truth_at(12.0);
    CHECK(words.caption ==
          fmt::format("{0:.6f} {0:.6f} {0:.6f} {1}", late.light_energy, truth_at(4.0).collisions));
    CHECK(words.alt == fmt::format("{:.6f}", late.deviation));
    // What the fit found stands in the table, too.
    const Figure& figure = run.figures().front();
    const Table table = figure.panel->table(*figure.moments.back().state, theme(ThemeKind::light));
    const auto found = std::ranges::find_if(table.rows, [](const std::vector<TableCell>& row) {
        return std::get<std::string>(row.front()) == "fit mean";
    });
    REQUIRE(found != table.rows.end());
    CHECK(std::ranges::any_of(*found, [&](const TableCell& cell) {
        const double* number = std::get_if<double>(&cell);
        return number != nullptr && *number == doctest::Approx(late.light_energy).epsilon(1e-12);
    }));
}
