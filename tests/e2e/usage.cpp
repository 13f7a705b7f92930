// What a newcomer is likely to write, and what carom says to write instead.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;

namespace {

const std::string plain = library_scene("one-hot-particle");

struct Mistake {
    std::string call, said;
};

Outcome call(const std::string& arguments) {
    return shell("'" + program + "' " + arguments, std::filesystem::temp_directory_path());
}

// Of a scene with these lines for box, gas and film.
Outcome check_lines(const std::string& lines) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: A scene\n" + lines + "run: {until: 1}\n");
    return shell("'" + program + "' check scene.yaml", folder.path());
}

}  // namespace

TEST_CASE("each mistake on the command line is told with what to write instead") {
    const std::vector<Mistake> mistakes{
        {"render", "write carom render SCENE...;"},
        {"figure", "write carom figure SCENE;"},
        {"new", "write carom new NAME;"},
        {"run --json", "--json needs a value: "},
        {"'" + plain + "' render", "the command comes first: carom render " + plain + "\n"},
        {"run '" + plain + "' -o x.csv", "has no option -o; samples go to --csv PATH"},
        {"run '" + plain + "' --output=x.csv", "has no option --output; samples go to --csv PATH"},
        {"check '" + plain + "' --sett a=1", "did you mean --set?"},
        {"--list", "carom has no option --list; carom --help lists the commands"},
        {"check -dash.yaml",
         "has no option -dash.yaml; a file of that name is written ./-dash.yaml"},
        {"check -z", "carom check has no option -z; carom check --help lists the options"},
        {"new a b", "carom new does not take the word b"},
        {"new a -- b c", "carom new does not take the word b"},
        {"still -- a.yaml -b", "carom still has no option -b"},
        {"still '" + plain + "' --size 8cm", "carom figure --width takes centimetres"},
        {"still '" + plain + "' --size 640", "expected WIDTHxHEIGHT, for instance 640x360"},
        {"still '" + plain + "' --size 12320742750583006852", "for instance 1280x720"},
        {"still '" + plain + "' --size 9000", "for instance 1280x720"},
        {"still '" + plain + "' --size 5", "for instance 1280x720"},
        {"check '" + plain + "' --set gas.nobody.count=1",
         "items are counted from 0, or named: `the 200 others`, `the fast disk`"},
        {"render '" + plain + "' --seed 2 --seed 3", "--seed is given more than once: 2 and 3;"},
        {"still '" + plain + "' --at five", "--at: expected a number, found `five`;"},
        {"render '" + plain + "' --threads 0",
         "--threads: expected a whole number from 1 to 1024, found `0`;"},
        {"render '" + plain + "' --threads 2x", "found `2x`;"},
        {"figures '" + plain + "' --formats svg,pgn",
         "--formats: expected svg, pdf, png or csv, found `pgn`; did you mean png?"},
        {"check '" + plain + "' --template .", "hint: a name, or a file that ends in .yaml"},
        {"check '" + plain + "' --set film.template=lectur", "did you mean `lecture`?"},
        {"check '" + plain + "' --fps 9999",
         "--fps 9999: error: expected a whole number from 1 to 120 for `fps`, found `9999`\n"
         "      | --fps 9999\n"
         "      |       ^^^^\n"},
        {"still '" + plain + "' --at 1 --theme=blue --set film.theme=red",
         "--set film.theme=red: error: "},
        {"still '" + plain + "' --at 1 --theme=blue --set film.fps=30",
         "      | --theme blue\n"
         "      |         ^^^^\n"},
        {"still '" + plain + "' --size 10x10 --theme light",
         "--size 10x10: error: expected a whole number from 64 to 8192 for an item of `size`, "
         "found `10`\n"
         "      | --size 10x10\n"
         "      |        ^^^^^\n"},
    };
    for (const Mistake& mistake : mistakes) {
        CAPTURE(mistake.call);
        const Outcome outcome = call(mistake.call);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, mistake.said));
    }
}

TEST_CASE("--set takes several values, and items of lists by their names") {
    const auto facts = [](const std::string& arguments) {
        const Outcome outcome = call("check '" + plain + "' " + arguments);
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return outcome.out;
    };
    const std::string both = facts("--set gas.0.count=7 --set film.seconds=5");
    CHECK(has(both, "7 the 200 others"));
    CHECK(has(both, "0:05 at 30 a second"));
    CHECK(facts("--set gas.0.count=7 film.seconds=5") == both);
    CHECK(facts("--set 'gas.the 200 others.count=7' film.seconds=5") == both);
}

TEST_CASE("a value that a newcomer would write is told with the right one") {
    const std::string box = "box: {size: [20, 15]}\n";
    const auto gas = [](const std::string& keys) {
        return "gas: [{count: 5, radius: 0.4, " + keys + "}]\n";
    };
    const std::vector<Mistake> mistakes{
        {"box: {size: [20, 15}\n" + gas("speed: 1"),
         "scene.yaml:2:13: error: not valid YAML: this `[` is not closed before the `}` of line 2, "
         "column 20"},
        {box + gas("velocity: 0"), "hint: two numbers: [x, y]"},
        {box + gas("velocity: 2"), "hint: two numbers: [x, y]"},
        {box + gas("speed: 5mm"),
         "write `5`: numbers have units only in a scene with `units: real`"},
        {box + gas("speed: 2.5 m/s"),
         "write `2.5`: numbers have units only in a scene with `units: real`"},
        {box + gas("speed: 1") + "film: {panels: [sped-histogram]}\n",
         "hint: did you mean `speed-histogram`?"},
        {box + gas("speed: 1") + "film: {panels: [histogram-of-energies]}\n",
         "hint: there are `speed-histogram`, `energy-histogram`, "},
    };
    for (const Mistake& mistake : mistakes) {
        CAPTURE(mistake.call);
        const Outcome outcome = check_lines(mistake.call);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, mistake.said));
        CHECK_FALSE(has(outcome.err, "`stopwatch`"));  // not all the names
    }
}

TEST_CASE("carom figure draws a figure that the scene does not list") {
    const TemporaryFolder folder;
    const std::string call = "'" + program + "' figure '" + plain + "' --kind gas --at 5 ";
    CHECK(shell(call + "--width 8cm --formats svg,png", folder.path()).exit_code == 0);
    const std::filesystem::path made = folder.path() / "out/one-hot-particle-gas";
    CHECK(has(contents(made / "gas.svg"), "width=\"302px\""));  // 8 cm at 96 dots an inch
    CHECK(contents(made / "gas.png").starts_with("\x89PNG"));
    CHECK_FALSE(std::filesystem::exists(made / "gas.pdf"));
    CHECK(shell("'" + program + "' figure '" + plain +
                    "' --kind speed-histogram --of 'the fast disk,3' --over 2,5 --theme dark "
                    "--formats svg,csv -o dark",
                folder.path())
              .exit_code == 0);
    const auto words = nlohmann::json::parse(contents(folder.path() / "dark/captions.json"));
    const auto& figure = words.at("figures").at(0);
    CHECK(figure.at("times") == nlohmann::json{5.0});
    CHECK(figure.at("over") == nlohmann::json{2.0, 5.0});
    CHECK(has(figure.at("alt").get<std::string>(), "from time 2 to 5"));
    const std::string svg = contents(folder.path() / "dark/speed-histogram.svg");
    CHECK(has(svg, "fill:rgb(5.490196%,6.666667%,8.627451%)"));  // #0e1116, that of films
    const std::string csv = contents(folder.path() / "dark/speed-histogram.csv");
    CHECK(has(csv, "the fast disk"));
    CHECK(has(csv, "particle 3"));
    const Outcome wrong = shell(call + "--width 8em", folder.path());
    CHECK(wrong.exit_code == 2);
    CHECK(has(wrong.err, "expected a width in centimetres"));
    const Outcome narrow = shell(call + "--width 8mm", folder.path());
    CHECK(narrow.exit_code == 2);
    CHECK(has(narrow.err, "--width 8mm"));
    CHECK(has(narrow.err, "found `8mm`"));
}

TEST_CASE("mistakes in what carom figure is asked for are shown at the option that was typed") {
    const TemporaryFolder folder;
    const std::string call = "'" + program + "' figure '" + plain + "' --kind ";
    for (const auto& [asked, said] :
         {std::pair{"text",
                    "--kind text: error: a panel of kind `text` needs `words`\n"
                    "      | --kind text\n      |        ^^^^\n"},
          {"sped", "--kind sped: error: expected one of"},
          {"gas --at 1000", "--at 1000: error: expected a time from 0 to "},
          {"gas --width 900cm", "      | --width 900cm\n      |         ^^^^^\n"},
          {"gas --width 8 --at [1", "--at: expected a number, found `[1`"},
          {"gas --theme paper", "--theme"},
          {"speed-histogram --of fsat", "      | --of fsat\n      |      ^^^^\n"},
          {"speed-histogram --of \"all', title: 'T\"", "--of all',title: 'T: error: "},
          {"speed-histogram --over begin", "      | --over begin\n      |        ^^^^^\n"},
          {"speed-histogram --over 5,2", "--over 5,2: error: expected [from, to] with from < to"},
          {"speed-histogram --over '{window: 5}'", "--over {window: 5}: expected now, start, a"},
          {"Speed-histogram", "--kind Speed-histogram: expected a name such as speed-histogram"},
          {"'gas, title: T'", "--kind gas, title: T: expected a name such as speed-histogram"}}) {
        const Outcome outcome = shell(call + asked, folder.path());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, said));
        CHECK_FALSE(has(outcome.err, "--set"));
    }
}
