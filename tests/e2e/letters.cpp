// Words in letters that no font has are refused wherever they stand.
#include <doctest/doctest.h>

#include <string>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;

namespace {

// All places of words that are drawn as they stand there, numbered.
const std::string words_everywhere = R"(title: T <01>
subtitle: S <02>
box: {size: [10, 10]}
partitions: [{name: "wall <03>", x: 5, gaps: [[4, 6]]}]
gas:
  - {name: "red <04>", label: "<05>", count: 4, speed: 1}
run:
  until: 4
  events:
    - {at: 1, mark: "here <06>"}
    - {at: 2, caption: "then <07>"}
film:
  seconds: 40
  end_card: "end <08>"
  panels:
    - {kind: text, title: "<09>", words: "words <10> $\\text{in <11>}$"}
    - {kind: sides, regions: [{name: "<12>", within: [0, 0, 5, 10]}, {name: B, within: [5, 0, 10, 10]}]}
  callouts: [{at: 1, points_to: 0, text: "<13>"}]
  beside: {label: "<14>", own_label: "own <15>", set: seed=2}
figures:
  - {name: f, kind: speed-histogram, title: "<16>", compare: [{label: "<17>", set: seed=1}, {label: b, set: seed=2}]}
)";

// With a letter that no font has in one place, `a` in the others.
std::string with_odd_letter(int place) {
    std::string text = words_everywhere;
    for (int i = 1; i <= 17; ++i) {
        const std::string mark = "<" + std::to_string(100 + i).substr(1) + ">";
        text.replace(text.find(mark), mark.size(), i == place ? "\u2fe0" : "a");
    }
    return text;
}

}  // namespace

TEST_CASE("letters that no font has are refused in all words, by check as by still") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", with_odd_letter(0));
    const Outcome good = run({program, "check", "scene.yaml"}, folder.path());
    CAPTURE(good.err);
    REQUIRE(good.exit_code == 0);
    for (int place = 1; place <= 17; ++place) {
        CAPTURE(place);
        folder.write("scene.yaml", with_odd_letter(place));
        const Outcome check = run({program, "check", "scene.yaml"}, folder.path());
        CHECK(check.exit_code == 2);
        CHECK(check.err ==
              "scene.yaml: error: no font on this machine has \u2fe0\n"
              "  hint: install one (fonts-noto-cjk has the letters of Chinese, Japanese and "
              "Korean, fonts-noto-core those of most other scripts)\n");
        const Outcome still = run({program, "still", "scene.yaml"}, folder.path());
        CHECK(still.exit_code == 1);
        CHECK(has(still.err, "no font on this machine has \u2fe0: install one"));
    }
}

TEST_CASE("so are letters in the words of a set, which stand on the cards of its film") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [20, 15]}\ngas: [{count: 4, speed: 1}]\nrun: {until: 1}\n"
                 "figures: [{name: one, kind: gas}]\n");
    for (int place = 0; place <= 3; ++place) {
        CAPTURE(place);
        const auto word = [&](int its) { return std::string(its == place ? "\u2fe0" : "a"); };
        folder.write("set.yaml", "title: " + word(1) + "\ndescription: " + word(2) +
                                     "\nscenes: [{scene: scene.yaml, title: " + word(3) + "}]\n");
        const Outcome check = run({program, "check", "set.yaml"}, folder.path());
        CHECK(check.exit_code == (place == 0 ? 0 : 2));
        if (place > 0)
            CHECK(has(check.err, "set.yaml: error: no font on this machine has \u2fe0\n"));
    }
}
