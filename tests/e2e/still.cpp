// Stills as vectors: drawn by programs that share nothing with Cairo's writers, they are the PNG.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

constexpr int width = 960, height = 540;

struct Still {
    std::string scene, at;
};
// Two dimensions with arrows and a wire with rods and world lines.
const std::vector<Still> stills{
    {"two-to-one", "6"}, {"one-hot-particle", "6"}, {"tonks-gas", "40"}};

Outcome draw(const Still& still, const std::string& output, const fs::path& folder) {
    return run({program, "still", library_scene(still.scene), "--at", still.at, "--size", "960x540",
                "--quiet", "-o", output},
               folder);
}

/// The grey levels of a PNG, row by row.
std::vector<std::uint8_t> greys(const fs::path& png) {
    const Outcome outcome = run({"ffmpeg", "-v", "error", "-i", png.string(), "-vf", "format=gray",
                                 "-f", "rawvideo", "-pix_fmt", "gray", "-"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.out.size() == std::size_t{width} * height);
    return {outcome.out.begin(), outcome.out.end()};
}

struct Difference {
    double mean = 0;           ///< of the pixels, in 255 levels
    double largest_block = 0;  ///< of the mean levels of blocks of 12 x 12 pixels
};

// Only letters and rims may differ: on pixels baselines lie on whole rows, in vectors up to half a
// pixel from there, and Cairo's PDF rounds the widths of letters, by which long lines end a pixel
// or two early. Stems are one or two pixels wide, so most of a letter's ink stays in its block. A
// disk that is missing, of another colour or elsewhere changes a block by some 50 levels, a missing
// scale, panel or line of text by more than twice what is allowed.
constexpr Difference of_svg{1.5, 12.0};
constexpr Difference of_pdf{3.0, 25.0};

Difference difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    constexpr int side = 12;
    Difference found;
    for (int top = 0; top < height; top += side)
        for (int left = 0; left < width; left += side) {
            int sum = 0;
            for (int y = top; y < top + side; ++y)
                for (int x = left; x < left + side; ++x) {
                    const auto i = static_cast<std::size_t>(y * width + x);
                    const int apart = int{a[i]} - int{b[i]};
                    sum += apart;
                    found.mean += std::abs(apart) / (double(width) * height);
                }
            found.largest_block =
                std::max(found.largest_block, std::abs(sum) / (double(side) * side));
        }
    return found;
}

}  // namespace

TEST_CASE("SVG and PDF show what the PNG shows") {
    for (const Still& still : stills) {
        CAPTURE(still.scene);
        const TemporaryFolder folder;
        for (const std::string kind : {"png", "svg", "pdf"})
            REQUIRE(draw(still, "still." + kind, folder.path()).exit_code == 0);
        REQUIRE(run({"rsvg-convert", "still.svg", "-o", "svg.png"}, folder.path()).exit_code == 0);
        REQUIRE(
            run({"pdftoppm", "-png", "-singlefile", "-r", "96", "still.pdf", "pdf"}, folder.path())
                .exit_code == 0);
        const std::vector<std::uint8_t> expected = greys(folder.path() / "still.png");
        for (const std::string kind : {"svg", "pdf"}) {
            CAPTURE(kind);
            const Difference found = difference(expected, greys(folder.path() / (kind + ".png")));
            const Difference most = kind == "svg" ? of_svg : of_pdf;
            CHECK(found.mean <= most.mean);
            CHECK(found.largest_block <= most.largest_block);
        }
    }
}

TEST_CASE("an SVG of a still says what it is; two runs give the same bytes") {
    const TemporaryFolder folder;
    for (const std::string kind : {"svg", "pdf"}) {
        CAPTURE(kind);
        const Outcome outcome = draw(stills[0], "new/one." + kind, folder.path());
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.out.empty());
        // In another second: a date would tell.
        REQUIRE(
            shell("now=$(date +%s); while [ $(date +%s) = $now ]; do sleep 0.05; done").exit_code ==
            0);
        REQUIRE(draw(stills[0], "new/two." + kind, folder.path()).exit_code == 0);
        const std::string one = contents(folder.path() / "new" / ("one." + kind));
        CHECK(one.size() > 5'000);
        CHECK(contents(folder.path() / "new" / ("two." + kind)) == one);
    }
    const Outcome words = run({"python3", "-c",
                               "import sys, xml.etree.ElementTree as tree\n"
                               "svg = tree.parse(sys.argv[1]).getroot()\n"
                               "print(svg.tag, svg.get('role'))\n"
                               "for part in list(svg)[:2]: print(part.tag, part.text)\n",
                               "new/one.svg"},
                              folder.path());
    const std::string space = "{http://www.w3.org/2000/svg}";
    CHECK(words.out.find(space + "svg img\n" + space +
                         "title One collision of masses two and one\n" + space +
                         "desc The frame at time 6.005. ") == 0);
    const Outcome title = run({"pdfinfo", "new/one.pdf"}, folder.path());
    CHECK(title.out.find("One collision of masses two and one") != std::string::npos);
}

TEST_CASE("a quick still says that it knows the run from some frames only") {
    const TemporaryFolder folder;
    const auto draw_one = [&](const std::vector<std::string>& options) {
        std::vector<std::string> command{program,   "still", library_scene("one-hot-particle"),
                                         "--at",    "6",     "--size",
                                         "960x540", "-o",    "one.svg"};
        command.insert(command.end(), options.begin(), options.end());
        return run(command, folder.path());
    };
    const auto remark = [&] {
        const std::string svg = contents(folder.path() / "one.svg");
        const std::size_t begin = svg.find("<desc>"), end = svg.find("</desc>");
        const std::string words = svg.substr(begin, end - begin);
        const std::size_t at = words.find(" Axes, ");
        return at == std::string::npos ? "" : words.substr(at);
    };
    const Outcome quick = draw_one({"--quick"});
    CHECK(quick.err.find("32 of the film's 1260 frames (--quick)") != std::string::npos);
    CHECK(remark() ==
          " Axes, curves, averages and trails are computed from 32 of the film’s 1260 frames.");
    const Outcome whole = draw_one({});
    CHECK(whole.err.find("--quick") == std::string::npos);
    CHECK(remark() == "");
    draw_one({"--quick", "--set", "film.fps=1"});  // a film of no more frames is seen whole
    CHECK(remark() == "");
}

TEST_CASE("a still of an unknown kind is refused with the kinds there are") {
    const TemporaryFolder folder;
    for (const std::string output : {"still.gif", "still.mp4", "still", "still.svg.gz"}) {
        const Outcome outcome = draw(stills[0], output, folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err == "carom: -o " + output + ": the name must end in .png, .svg or .pdf\n");
        CHECK(folder.names().empty());
    }
}

TEST_CASE("a still appears whole or not at all") {
    const TemporaryFolder folder;
    folder.write("file", "x");
    for (const std::string kind : {"svg", "pdf"}) {
        CAPTURE(kind);
        const Outcome nowhere = draw(stills[0], "file/still." + kind, folder.path());
        CHECK(nowhere.exit_code == 1);
        CHECK(nowhere.err.find("file") != std::string::npos);
        CHECK(contents(folder.path() / "file") == "x");

        // Larger than files may be: an earlier one stays.
        const std::string name = "still." + kind;
        folder.write(name, "earlier");
        const Outcome limited =
            shell("ulimit -f 4; '" + program + "' still '" + library_scene("two-to-one") +
                      "' --at 6 --size 960x540 -o " + name,
                  folder.path());
        CHECK(limited.exit_code == 1);
        CHECK(limited.err.find(name) != std::string::npos);
        CHECK(contents(folder.path() / name) == "earlier");
    }
    CHECK(folder.names() == std::vector<std::string>{"file", "still.pdf", "still.svg"});
}

TEST_CASE("a title in letters that no font has is refused before any work") {
    const TemporaryFolder folder;
    const Outcome outcome =
        run({program, "still", library_scene("two-to-one"), "--set", "title=A \u2fe0 title"},
            folder.path());
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.find("no font on this machine has \u2fe0") != std::string::npos);
    CHECK(outcome.err.find("fonts-noto") != std::string::npos);
    CHECK(fs::is_empty(folder.path()));
}
