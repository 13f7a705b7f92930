// What users are likely to get wrong in calls of the program: each ends with exit code 2, says
// where the mistake is and what to write instead, and writes nothing.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene = R"(title: A gas
box: {size: [40, 30]}
gas: [{name: a, count: 20, radius: 0.5, temperature: 1}]
run: {until: 10}
film: {seconds: 1, size: [128, 72], panels: [speed-histogram]}
figures: [{name: f, kind: speed-histogram, at: 5}]
)";

using Slip = std::pair<std::string, std::string>;  ///< the call, and a part of the message

const std::vector<Slip>& slips() {
    static const std::vector<Slip> all{
        {"render s.yml", "did you mean s.yaml?"},
        {"render s", "did you mean s.yaml?"},
        {"render S.yaml", "did you mean s.yaml?"},
        {"render nothere.yaml", "name a scene, for instance s.yaml"},
        {"render dir", "it is a folder"},
        {"render s.yaml film2.mp4",
         "film2.mp4 is no scene: write carom render s.yaml -o film2.mp4"},
        {"render film2.mp4 s.yaml", "write carom render SCENE -o film2.mp4"},
        {"render s.yaml -o", "--output needs a value: the film (.mp4, "},
        {"render s.yaml -o film.avi", "a film ends in .mp4, .webm, .gif or .pdf"},
        {"render s.yaml -o film", "a folder of PNG frames ends in a slash"},
        {"render s.yaml -o s.yaml", "this would overwrite the scene"},
        {"render s.yaml --format mp4 -o a.gif", "the name ends in .gif, but --format is mp4"},
        {"render s.yaml s.yaml -o a.mp4", "several scenes need a folder; name one"},
        {"render s.yaml fps=30", "fps=30 is no scene: write carom render s.yaml --fps 30"},
        {"render s.yaml film.fps=30", "write carom render s.yaml --set film.fps=30"},
        {"render s.yaml --fps:30", "did you mean --fps?"},
        {"render s.yaml --fp 30", "did you mean --fps?"},
        {"render s.yaml -fps 30", "did you mean --fps?"},
        {"render s.yaml --fps 0", "hint: the smallest is 1"},
        {"render s.yaml --fps 29.97", "hint: write `29` or `30`"},
        {"render s.yaml --fps abc", "hint: for instance `30`"},
        {"render s.yaml --size 4k", "4K is `2160p`"},
        {"render s.yaml --size HD", "HD is `720p`, full HD is `1080p`"},
        {"render s.yaml --size 1080x", "for instance 1080x608"},
        {"render s.yaml --size 1920,1080", "for instance 1920x1080"},
        {"render s.yaml --size 1920:1080", "for instance 1920x1080"},
        {"render s.yaml --size 10x10", "the smallest is 64"},
        {"render s.yaml --resolution 1080p", "did you mean --size?"},
        {"render s.yaml --seconds 10s",
         "write `10`: numbers have units only in a scene with `units: real`"},
        {"render s.yaml --seconds 1:30", "write `90`"},
        {"render s.yaml --duration 10", "the end of the run is --set run.until=T"},
        {"render s.yaml --until 5", "the end of the run is --set run.until=T"},
        {"render s.yaml --set until=5", "`until` is a key of"},
        {"render s.yaml --set run.until:5", "expected KEY.PATH=VALUE, for instance run.until=5"},
        {"render s.yaml --set run/until=5", "the keys of a path are separated by points"},
        {"render s.yaml --set gas[0].count=5", "write `gas.0.count`"},
        {"render s.yaml --set gas.0.cuont=5", "did you mean `count`?"},
        {"render s.yaml --set film.size=1920x1080", "write `[1920, 1080]`"},
        {"render s.yaml --seed random", "expected a whole number of at least 0 for `seed`"},
        {"render s.yaml --seed -1", "write `1`, without the minus sign"},
        {"render s.yaml --theme black", "did you mean `dark`?"},
        {"render s.yaml --theme Dark", "did you mean `dark`?"},
        {"render s.yaml --language german", "did you mean `de`?"},
        {"render s.yaml --quality high", "expected draft, standard or final"},
        {"render s.yaml --from 3 --to 1", "write --from 1 --to 3"},
        {"render s.yaml --sound", "--set film.sound=collisions adds sound"},
        {"render s.yaml -q", "did you mean --quiet?"},
        {"render s.yaml -j 4", "did you mean --threads?"},
        {"render s.yaml --overwrite", "files that carom wrote are replaced without being asked"},
        {"render s.yaml --max-size 5XB", "for instance 5MB or 800kB"},
        {"render --", "write carom render SCENE..."},
        {"still s.yaml --time 3", "did you mean --at?"},
        {"still s.yaml --at 50", "the scene runs from 0 to 10"},
        {"still s.yaml --at 3s", "write `3`"},
        {"still s.yaml --at 3,5", "write `3.5`, with a point"},
        {"still s.yaml --at 1 -o a.jpg", "the name must end in .png, .svg or .pdf"},
        {"still s.yaml --at 1 a.png", "write -o a.png"},
        {"still s.yaml --width 8cm", "carom figure SCENE --kind gas --width 8cm draws a figure"},
        {"figures s.yaml --only g", "it has f"},
        {"figures s.yaml --formats jpg", "expected svg, pdf, png or csv"},
        {"figures s.yaml --formats SVG", "did you mean svg?"},
        {"figures s.yaml --format svg", "did you mean --formats?"},
        {"figures s.yaml -o notes.txt", "name a folder, for instance notes/"},
        {"figures s.yaml -o plot.png", "name a folder, for instance plot/"},
        {"figures s.yaml --page word", "expected markdown, html or latex"},
        {"figures s.yaml --width 8cm", "carom figure SCENE --kind KIND --width 8cm"},
        {"figure s.yaml --kind histogram", "there are `speed-histogram`, `energy-histogram`"},
        {"figure s.yaml --kind speeds", "there are `speed-histogram`, `speed-classes`"},
        {"figure s.yaml --kind gas --width wide", "for instance 8cm"},
        {"run s.yaml -o x.csv", "samples go to --csv PATH"},
        {"run s.yaml x.csv", "write --csv x.csv"},
        {"run s.yaml --csv x --json x", "would both be written to x"},
        {"run s.yaml --seeds 1:5", "carom plan SCENE --seeds 1:100"},
        {"check notes.txt", "`carom new NAME` writes a scene to start from"},
        {"new s", "give another name"},
        {"plan s.yaml -o plan.mp4", "name a folder, for instance plan/"},
        {"plan s.yaml --seeds 1-5", "for instance 1:100"},
        {"gallery nothere", "expected a folder of scenes"},
        {"--verison", "did you mean --version?"},
        {"-v", "did you mean --version?"},
        {"version", "write --version"},
        {"help rendr", "did you mean `render`?"},
    };
    return all;
}

std::size_t files_in(const fs::path& folder) {
    std::size_t number = 0;
    for (auto file = fs::recursive_directory_iterator(folder); file != fs::end(file); ++file)
        ++number;
    return number;
}

}  // namespace

TEST_CASE("each mistaken call is refused with what to write instead") {
    const TemporaryFolder folder;
    folder.write("s.yaml", scene);
    folder.write("notes.txt", "words");
    fs::create_directory(folder.path() / "dir");
    const std::size_t files = files_in(folder.path());
    CHECK(slips().size() >= 80);
    for (const auto& [call, part] : slips()) {
        CAPTURE(call);
        const Outcome outcome = shell("'" + program + "' " + call, folder.path());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        const std::string all = outcome.out + outcome.err;  // check reports on standard output
        CHECK(has(all, part));
        CHECK(files_in(folder.path()) == files);
    }
}
