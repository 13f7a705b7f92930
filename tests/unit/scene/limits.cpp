// docs/limits.md lists the limits as they are; what is at a limit is let in, what is over it is
// refused with the limit.
#include "scene/limits.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/yaml/yaml.h"
#include "support/files.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;

namespace {

// All of them, in the order of the page.
constexpr std::array limits{most_file_bytes,
                            most_nesting,
                            most_page_nesting,
                            most_values,
                            most_letters,
                            most_title_letters,
                            most_caption_letters,
                            most_words_letters,
                            most_name_letters,
                            most_seconds,
                            most_sound_seconds,
                            most_trail_seconds,
                            most_overrides,
                            most_errors_shown,
                            largest_quantity,
                            smallest_quantity,
                            largest_seed,
                            most_seeds,
                            most_runs,
                            most_points,
                            most_particles,
                            most_returning,
                            most_in_both_runs,
                            most_seed_paths,
                            most_species,
                            most_events,
                            most_partitions,
                            most_gaps,
                            most_obstacles,
                            most_corners,
                            most_samples,
                            most_time_steps,
                            most_run_collisions,
                            most_pairs_compared,
                            most_frames,
                            most_frames_per_second,
                            smallest_side,
                            largest_side,
                            most_panels,
                            most_slow_spans,
                            most_overlays,
                            most_field_cells,
                            most_monitors,
                            most_bins,
                            most_chosen,
                            largest_grid,
                            most_figures,
                            most_set_scenes,
                            most_strip,
                            most_compared,
                            most_read_again,
                            most_changes,
                            largest_figure,
                            smallest_figure,
                            most_precise,
                            most_classroom_seconds,
                            most_classroom_frames,
                            most_classroom_work,
                            most_classroom_memory,
                            most_classroom_bytes,
                            most_classroom_side,
                            most_classroom_particles,
                            most_classroom_samples,
                            most_classroom_steps,
                            most_classroom_collisions,
                            most_classroom_precise_collisions};

std::string text_of(const std::string& path) {
    return test::contents(carom::test::checkout().string() + path);
}

std::vector<std::string> rows_of_table(const std::string& text) {
    std::vector<std::string> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("| ") && !line.starts_with("| ---") && !line.starts_with("| limit"))
            rows.push_back(line);
    return rows;
}

// What is wrong with a scene, or nothing.
std::string complaint(const std::string& text, const Overrides& overrides = {}) {
    try {
        test::scene_from(text, overrides);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

std::string scene_with(const std::string& gas, const std::string& run = "until: 10",
                       const std::string& film = "seconds: 1") {
    return "title: T\nbox: {size: [1000, 1000]}\ngas: [" + gas + "]\nrun: {" + run + "}\nfilm: {" +
           film + "}\n";
}

bool names(const std::string& complaint, const Limit& limit) {
    return complaint.find(to_text(limit)) != std::string::npos;
}

std::string repeated(const std::string& part, std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += part;
    return text;
}

}  // namespace

TEST_CASE("a file may be as long as the limit, and not a byte longer") {
    const std::string scene = scene_with("{count: 2}");
    const std::string padding(most_file_bytes.count() - scene.size() - 2, 'x');
    CHECK(complaint(scene + "#" + padding + "\n").empty());
    CHECK(names(complaint(scene + "#x" + padding + "\n"), most_file_bytes));
}

// Each run would be a scene of its own, 1,200 of them.
TEST_CASE("figures may compare so many runs as the bytes that are read for them allow") {
    const auto scene = [](std::size_t figures, std::size_t comment) {
        std::string text = scene_with("{count: 2}") + "figures:\n";
        for (std::size_t k = 0; k < figures; ++k)
            text += fmt::format(
                "  - {{name: f{}, kind: speed-histogram, at: 1, compare: {{seeds: 6}}}}\n", k);
        return text + "#" + std::string(comment, 'x') + "\n";
    };
    CHECK(complaint(scene(10, 25'000)).empty());
    CHECK(names(complaint(scene(10, 40'000)), most_read_again));
    CHECK(names(complaint(scene(200, 100'000)), most_read_again));
}

TEST_CASE("a file may hold as many values as the limit, lists and mappings too") {
    const auto complaint_of = [](std::size_t numbers) {
        const Source source{"test", "[" + repeated("1,", numbers) + "]", Origin::scene};
        Errors errors;
        read_yaml(source, errors);
        try {
            errors.throw_if_any();
        } catch (const SceneError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    CHECK(complaint_of(most_values.count() - 1).empty());
    CHECK(names(complaint_of(most_values.count()), most_values));
}

// The parser takes memory for all of a bracket before it tells of it: 1 GB for 4 MiB of `[`.
TEST_CASE("a file of nothing but structure is refused before it is parsed") {
    for (const std::string part : {"[", "{", "[{", "[]", "{},", "1,", "{a: ", "a:\n", "? a\n", ": ",
                                   "{\"a\":", "\"\":", "[#\n", "k: 1, "}) {
        CAPTURE(part);
        const std::string text = "[" + repeated(part, most_values.count() + 1);
        CHECK(names(complaint(text), most_values));
    }
}

TEST_CASE("brackets and commas in comments are no values") {
    const std::string scene = scene_with("{count: 2}");
    const std::string comments = repeated("  # [{,,,: }]\n", most_values.count() / 4);
    CHECK(complaint(scene + comments).empty());
    CHECK(names(complaint(scene + "x: " + repeated(",,,,", most_values.count() / 4)), most_values));
}

TEST_CASE("species may have as many particles together as the limit") {
    const auto two = [](const std::string& rest) {
        return scene_with(
            "{name: a, count: 1999999, radius: 0.001}, {name: b, radius: 0.001, count: " + rest +
            "}");
    };
    CHECK(complaint(two("1")).empty());
    CHECK(names(complaint(two("2")), most_particles));
}

TEST_CASE("a command line may set as many values as the limit") {
    const std::string scene = scene_with("{count: 2}");
    Overrides overrides(most_overrides.count(), "seed=1");
    CHECK(complaint(scene, overrides).empty());
    overrides.emplace_back("seed=1");
    CHECK(names(complaint(scene, overrides), most_overrides));
}

TEST_CASE("a box may have as many partitions and obstacles as the limits") {
    const auto scene = [](const std::string& key, const std::string& item, int count) {
        std::string list;
        for (int i = 0; i < count; ++i) list += item + ", ";
        return scene_with("{count: 2}") + key + ": [" + list + "]\n";
    };
    const std::string partition = "{x: 500}", obstacle = "{disk: [500, 500], radius: 1}";
    CHECK(complaint(scene("partitions", partition, 64)).empty());
    CHECK(names(complaint(scene("partitions", partition, 65)), most_partitions));
    CHECK(complaint(scene("obstacles", obstacle, 1000)).empty());
    CHECK(names(complaint(scene("obstacles", obstacle, 1001)), most_obstacles));
}

TEST_CASE("a run may have as many samples as the limit, a film as many frames") {
    CHECK(complaint(scene_with("{count: 2}", "until: 10, sample_every: 1e-6")).empty());
    CHECK(names(complaint(scene_with("{count: 2}", "until: 10, sample_every: 0.999e-6")),
                most_samples));
    CHECK(names(complaint(scene_with("{count: 2}", "until: 10, time_step: 0.999e-6")),
                most_time_steps));
    CHECK(complaint(scene_with("{count: 2}", "until: 10", "seconds: 3600, fps: 30")).empty());
    CHECK(names(complaint(scene_with("{count: 2}", "until: 10", "seconds: 3600.04, fps: 30")),
                most_frames));
}

// The last two of so many disks in a tower overlap. A large disk beside it makes the cells of the
// search wide: where the others crowd in a few, the loader has compared enough by then, and the
// placement will find it.
TEST_CASE("places are compared up to the limit") {
    const auto tower = [](int disks, double step, const std::string& beside = "") {
        std::string places;
        for (int i = 0; i + 1 < disks; ++i) places += fmt::format("[500, {}], ", 1.0 + step * i);
        return scene_with("{name: a, radius: 0.001, position: [" + places +
                          fmt::format("[500, {}]", 1.0005 + step * (disks - 2)) + "]}" + beside);
    };
    const std::string large = ", {name: b, radius: 100, position: [[200, 500]]}";
    CHECK(complaint(tower(7000, 0.01, large)).find("particle 6999 (a) overlaps particle 6998") !=
          std::string::npos);
    CHECK(complaint(tower(30'000, 0.0025)).find("particle 29999 (a) overlaps particle 29998") !=
          std::string::npos);
    CHECK(complaint(tower(30'000, 0.0025, large)).empty());
}

// Each at its limit and one over it. Of collisions it is the run's ceiling that is lowered.
TEST_CASE("a classroom has limits of its own") {
    SceneResources resources = test::resources();
    resources.is_classroom = true;
    const auto loaded = [&](const std::string& text) {
        return load_scene_text(text, "test", resources);
    };
    const auto said = [&](const std::string& text) -> std::string {
        try {
            loaded(text);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    };
    const auto film = [&](const std::string& keys) {
        return said(scene_with("{count: 2}", "until: 10", keys));
    };
    CHECK(film("seconds: 120, fps: 60, size: [3840, 2160]").empty());
    CHECK(names(film("seconds: 120.1"), most_classroom_seconds));
    CHECK(names(film("seconds: 120, fps: 61"), most_classroom_frames));
    CHECK(names(film("seconds: 1, size: [100, 3841]"), most_classroom_side));
    CHECK(film("seconds: 121, size: [100, 3841]").find("test:5:17") != std::string::npos);
    const std::string small = "radius: 0.1}";
    CHECK(said(scene_with("{count: 20000, " + small)).empty());
    CHECK(names(
        said(scene_with("{name: a, count: 9000, " + small + ", {name: b, count: 11001, " + small)),
        most_classroom_particles));
    // Of 2 particles.
    CHECK(said(scene_with("{count: 2}", "until: 10, sample_every: 1.001e-6")).empty());
    CHECK(names(said(scene_with("{count: 200}", "until: 10, sample_every: 9e-6")),
                most_classroom_samples));
    CHECK(names(said(scene_with("{count: 200}", "until: 10, time_step: 9e-6")),
                most_classroom_steps));
    CHECK(loaded(scene_with("{count: 2}")).run.most_collisions == 100'000'000);
    CHECK(loaded(scene_with("{count: 2}", "until: 10, most_collisions: 7")).run.most_collisions ==
          7);
    CHECK(loaded(scene_with("{count: 2}", "until: 10, precision: 64")).run.most_collisions ==
          200'000);
    CHECK_FALSE(test::scene_from(scene_with("{count: 2}")).run.most_collisions.has_value());
}

TEST_CASE("the page of limits is current") {
    std::vector<std::string> expected;
    for (const Limit& limit : limits)
        expected.push_back(fmt::format("| {} | {} |", number_text(limit.value), limit.meaning));
    CHECK(rows_of_table(text_of("/docs/limits.md")) == expected);
}

TEST_CASE("the list of limits is whole") {
    const std::string header = text_of("/src/scene/limits.h");
    std::size_t declared = 0;
    for (std::size_t at = 0; (at = header.find("inline constexpr Limit ", at)) != std::string::npos;
         ++at)
        ++declared;
    CHECK(declared == limits.size());
}
