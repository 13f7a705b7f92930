// Numbers for which words of a scene ask: what is marked, what is refused, and what is known.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "panels/registry.h"
#include "scene/numbers/known_numbers.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

const std::string gas =
    "title: T\nbox: {size: [40, 30]}\n"
    "gas: [{name: light, count: 20, radius: 0.3, temperature: 1},"
    " {name: the heavy ones, count: 10, radius: 0.5, mass: 4, temperature: 1}]\n";

std::string with_caption(const std::string& words, const std::string& more = "") {
    return gas + "run: {until: 20, events: [{at: 5, caption: '" + words + "'}]}\n" + more +
           "film: {seconds: 20, panels: []}\n";
}

Scene captioned(const std::string& words, const std::string& more = "") {
    return test::scene_from(with_caption(words, more));
}

// "message / hint"; empty: no error.
std::string error_of(const std::string& text) {
    try {
        test::scene_from(text);
    } catch (const SceneError& error) {
        const Diagnostic& first = error.diagnostics().front();
        return first.message + " / " + first.hint;
    }
    return "";
}

std::string shown(const std::string& words) {
    return with_usual_numbers(captioned(words).captions.front().words);
}

std::vector<std::string> names(const std::vector<KnownNumber>& numbers) {
    std::vector<std::string> all;
    for (const KnownNumber& number : numbers) all.push_back(number.name);
    return all;
}

bool has(const std::vector<std::string>& all, const std::string& name) {
    return std::ranges::find(all, name) != all.end();
}

}  // namespace

TEST_CASE("words are marked where they ask for numbers, and nowhere else") {
    CHECK(shown("T = {temperature}, E = { light.mean_energy at 3 :.2f }.") ==
          "T = 0.123, E = 0.123.");
    CHECK(shown("a {{set}} of {{{temperature}}}") == "a {set} of {0.123}");
    CHECK(shown("\\$5 and $\\frac{m v^2}{2}$ is {temperature}") ==
          "\\$5 and $\\frac{m v^2}{2}$ is 0.123");
    CHECK(shown("none") == "none");
    CHECK(captioned("none").numbers.empty());
}

TEST_CASE("what stands between braces is a name, a time and digits") {
    const NumberInWords number = captioned("{the heavy ones.mean_speed at 2.5:.4}").numbers.front();
    CHECK(number.name == "the heavy ones.mean_speed");
    CHECK(number.at == 2.5);
    CHECK(number.digits == 4);
    CHECK(!number.are_decimals);
    REQUIRE(number.reader.has_value());
    CHECK(number.reader->instrument.of.front().species == std::size_t{1});
    const NumberInWords other = captioned("{pressure.left:.1f}").numbers.front();
    CHECK(!other.at);
    CHECK(other.digits == 1);
    CHECK(other.are_decimals);
}

TEST_CASE("a particle, a surface and an instrument of the scene can be asked for") {
    CHECK(captioned("{3.speed}").numbers.front().reader->instrument.of.front().particle == 3);
    CHECK(captioned("{top.pressure}").numbers.front().reader->instrument.kind == "pressure");
    CHECK(captioned("{the heavy ones.mean_energy}").numbers.front().reader->line ==
          "the heavy ones");
    const Scene scene = captioned(
        "{late heat}", "measure: [{kind: temperature, over: {window: 2}, title: late heat}]\n");
    CHECK(scene.numbers.front().reader->instrument.over->window == 2.0);
}

TEST_CASE("words that ask for no number of the scene are refused") {
    CHECK(error_of(with_caption("{temprature}")) ==
          "there is no number `temprature` / did you mean `temperature`?");
    CHECK(error_of(with_caption("{lite.temperature}")) ==
          "there is no number `lite.temperature` / did you mean `light.temperature`?");
    CHECK(error_of(with_caption("{30.speed}")).starts_with("there is no number `30.speed`"));
    CHECK(error_of(with_caption("{position}")).starts_with("there is no number `position`"));
    CHECK(error_of(with_caption("{temperature at 21}")) ==
          "`{temperature at 21}` asks for a time outside of the run / give a time from 0 to 20");
    CHECK(error_of(with_caption("{temperature at noon}")).find("no time after `at`") !=
          std::string::npos);
    CHECK(error_of(with_caption("{temperature:.x}")).find("has no format") != std::string::npos);
    CHECK(error_of(with_caption("{temperature:2f}")).find("has no format") != std::string::npos);
    CHECK(error_of(with_caption("{temperature:.0}")).find("has no format") != std::string::npos);
    CHECK(error_of(with_caption("{}")).find("names no number") != std::string::npos);
    for (const char* words : {"a { b", "a } b", "{a {temperature}}"})
        CHECK(error_of(with_caption(words)).starts_with("a single `"));
}

TEST_CASE("the length of a caption counts a number as it is shown") {
    const std::string long_name = "{the heavy ones.mean_energy at 12.5:.2f}";
    CHECK(error_of(with_caption(long_name + " and " + long_name)).empty());
    CHECK(error_of(with_caption(std::string(56, 'a') + long_name)).find("61 characters") !=
          std::string::npos);
}

TEST_CASE("figures ask for what they show, those of several runs for nothing of one of them") {
    const auto figure = [](const std::string& more, const std::string& caption) {
        return gas + "run: {until: 20}\nfigures: [{name: f, " + more + ", caption: '" + caption +
               "'}]\n";
    };
    CHECK(error_of(figure("kind: speed-histogram", "{mean}, {temperature at 3}")).empty());
    CHECK(error_of(figure("kind: entropy", "{mean}")).starts_with("there is no number `mean`"));
    CHECK(error_of(figure("kind: speed-histogram", "{mean at 3}")).find("has no `at`") !=
          std::string::npos);
    CHECK(error_of(figure("kind: speed-histogram, seeds: 3", "{mean}")).empty());
    CHECK(error_of(figure("kind: speed-histogram, seeds: 3", "{temperature}"))
              .find("shows several runs") != std::string::npos);
    CHECK(error_of(figure("kind: text, words: \"{temperature}\"", "c")).find("caption") !=
          std::string::npos);
}

TEST_CASE("every number that is known can be asked for") {
    const Scene scene = captioned("none");
    const std::vector<std::string> all = names(known_numbers(scene, panel_kinds()));
    for (const char* name : {"temperature", "collisions", "the heavy ones.mean_speed",
                             "pressure.left", "light.mean_energy", "mean_free_path"})
        CHECK(has(all, name));
    CHECK(!has(all, "position"));
    for (const std::string& name : all) {
        CAPTURE(name);
        CHECK(error_of(with_caption("{" + name + "}")).empty());
    }
    const Scene piston = test::scene_from(
        "title: T\nbox: {size: [20, 10], walls: {right: {mass: 20, force: -2}}}\n"
        "gas: [{count: 10, radius: 0.2, speed: 1}]\nrun: {until: 2}\n");
    const std::vector<std::string> with_piston = names(known_numbers(piston, panel_kinds()));
    CHECK(has(with_piston, "position"));
    CHECK(has(with_piston, "position.right"));
    CHECK(!has(with_piston, "position.left"));
}
