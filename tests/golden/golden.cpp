// Small pictures of scenes, of those here that show what the scenes do not, and of figures, against
// those kept here, with the fonts kept here. On a difference of more than 2 in a channel the
// picture and a map of the difference are left in build/golden/; a vector picture is compared as
// text. CAROM_UPDATE_GOLDEN=1 makes the kept ones anew.
//
// The kept ones are Cairo 1.16's. From 1.18 on it sets letters at fractions of a pixel and writes
// an SVG with other attributes: there means over blocks of pixels are compared, which tell of a
// word or a line that has moved or has another colour, and of an SVG what another program draws.
#include <cairo.h>
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "support/files.h"
#include "support/library.h"
#include "support/process.h"
#include "support/test_root.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

constexpr int tolerance =
    2;  // letters and rims may be rounded otherwise by another machine's pixman

bool is_cairo_of_the_kept() { return cairo_version() < CAIRO_VERSION_ENCODE(1, 17, 4); }
constexpr int block = 16;            // pixels
constexpr int block_tolerance = 10;  // of a mean over a block, of 255; letters alone make up to 7

struct Picture {
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface;
    int width, height, stride;
    unsigned char* data;

    explicit Picture(const fs::path& path)
        : surface(cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy) {
        REQUIRE(cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS);
        width = cairo_image_surface_get_width(surface.get());
        height = cairo_image_surface_get_height(surface.get());
        stride = cairo_image_surface_get_stride(surface.get());
        data = cairo_image_surface_get_data(surface.get());
    }
};

// The largest difference of any channel; where it is more than the tolerance, `map` is written with
// those channels white.
int difference(const Picture& expected, const Picture& found, const fs::path& map) {
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, found.width, found.height),
        cairo_surface_destroy);
    unsigned char* white = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    int largest = 0;
    for (int y = 0; y < found.height; ++y)
        for (int x = 0; x < 4 * found.width; ++x) {
            if (x % 4 == 3) continue;  // the unused byte
            const int apart =
                std::abs(expected.data[y * expected.stride + x] - found.data[y * found.stride + x]);
            white[y * stride + x] = apart > tolerance ? 255 : 0;
            largest = std::max(largest, apart);
        }
    cairo_surface_mark_dirty(surface.get());
    if (largest > tolerance) cairo_surface_write_to_png(surface.get(), map.c_str());
    return largest;
}

// The largest difference of the means over blocks, of any channel.
int difference_of_blocks(const Picture& expected, const Picture& found) {
    int largest = 0;
    for (int y = 0; y + block <= found.height; y += block)
        for (int x = 0; x + block <= found.width; x += block)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int row = y; row < y + block; ++row)
                    for (int byte = 4 * x + channel; byte < 4 * (x + block); byte += 4)
                        sum += expected.data[row * expected.stride + byte] -
                               found.data[row * found.stride + byte];
                largest = std::max(largest, std::abs(sum) / (block * block));
            }
    return largest;
}

/// A picture as it is kept, and as it is drawn.
struct Pair {
    fs::path kept, drawn;
};

// The letters of fonts/, whatever fonts are installed.
void pin_fonts() {
    const fs::path fonts = carom::test::checkout() / "tests/golden/fonts/fonts.conf";
    REQUIRE(fs::exists(fonts));
    REQUIRE(setenv("FONTCONFIG_FILE", fonts.c_str(), 1) == 0);
}

Pair pair_of(const std::string& name, const fs::path& drawn) {
    return {carom::test::checkout() / "tests/golden" / name, drawn};
}

/// Where pictures are made anew the drawn one is the kept one too.
void keep(const Pair& pair) {
    if (std::getenv("CAROM_UPDATE_GOLDEN") != nullptr)
        fs::copy_file(pair.drawn, pair.kept, fs::copy_options::overwrite_existing);
    REQUIRE(fs::exists(pair.kept));
}

/// Draws a frame of a scene.
Pair draw(const std::string& scene, const std::string& at, const std::string& theme,
          const std::string& format) {
    const std::string name = scene + "-" + at + "-" + theme + "." + format;
    CAPTURE(name);
    pin_fonts();
    const Pair pair = pair_of(name, fs::path(CAROM_GOLDEN_OUTPUT) / name);
    fs::path file = carom::test::checkout() / "tests/golden" / (scene + ".yaml");
    if (!fs::exists(file)) file = carom::test::library_file(scene);
    const Outcome outcome = run({CAROM_PROGRAM, "still", file.string(), "--at", at, "--theme",
                                 theme, "--size", "480x270", "-o", pair.drawn.string(), "--quiet"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    keep(pair);
    return pair;
}

// An SVG as another program than Cairo draws it.
Picture rasterized(const fs::path& svg) {
    const fs::path png = fs::path(CAROM_GOLDEN_OUTPUT) / (svg.filename().string() + ".png");
    REQUIRE(run({"rsvg-convert", "-o", png.string(), svg.string()}).exit_code == 0);
    return Picture(png);
}

void compare_blocks(const Picture& expected, const Picture& found) {
    REQUIRE(expected.width == found.width);
    REQUIRE(expected.height == found.height);
    CHECK(difference_of_blocks(expected, found) <= block_tolerance);
}

// A copy beside an SVG in build/golden/, without the fingerprint of all of it in each id: otherwise
// one number that differs would make nearly all lines differ.
fs::path without_fingerprint(const fs::path& svg, const fs::path& copy) {
    std::ofstream(copy) << std::regex_replace(contents(svg), std::regex("\\bp[0-9a-f]{12}-"), "");
    return copy;
}

void compare_text(const Pair& pair) {
    CAPTURE(pair.drawn.string());
    if (!is_cairo_of_the_kept()) {
        compare_blocks(rasterized(pair.kept), rasterized(pair.drawn));
        return;
    }
    const fs::path kept = without_fingerprint(pair.kept, pair.drawn.string() + ".kept.txt");
    const fs::path drawn = without_fingerprint(pair.drawn, pair.drawn.string() + ".txt");
    const Outcome lines = run({"diff", "-u", kept.string(), drawn.string()});
    const bool same = lines.exit_code == 0;
    CAPTURE(lines.err);
    CHECK_MESSAGE(same, lines.out);
    fs::remove(kept);
    fs::remove(drawn);
    if (same) fs::remove(pair.drawn);
}

void compare_pixels(const Pair& pair) {
    CAPTURE(pair.drawn.string());
    const Picture expected(pair.kept);
    const Picture found(pair.drawn);
    if (!is_cairo_of_the_kept()) {
        compare_blocks(expected, found);
        return;
    }
    REQUIRE(expected.width == found.width);
    REQUIRE(expected.height == found.height);
    const int largest = difference(expected, found, pair.drawn.string() + ".difference.png");
    CHECK(largest <= tolerance);
    if (largest <= tolerance) fs::remove(pair.drawn);
}

void compare(const std::string& scene, const std::string& at, const std::string& theme) {
    compare_pixels(draw(scene, at, theme, "png"));
}

/// Draws the figures of a scene here and compares files of them, by name.
void compare_figures(const std::string& scene, const std::vector<std::string>& files) {
    pin_fonts();
    const fs::path folder = fs::path(CAROM_GOLDEN_OUTPUT) / scene;
    fs::remove_all(folder);
    const Outcome outcome =
        run({CAROM_PROGRAM, "figures",
             (carom::test::checkout() / "tests/golden" / (scene + ".yaml")).string(), "-o",
             folder.string(), "--formats", "svg,png", "--quiet"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    for (const std::string& file : files) {
        CAPTURE(file);
        const Pair pair = pair_of("figure-" + file, folder / file);
        keep(pair);
        if (pair.drawn.extension() == ".svg")
            compare_text(pair);
        else
            compare_pixels(pair);
    }
}

}  // namespace

TEST_CASE("small pictures of the scenes are as they were") {
    compare("one-hot-particle", "1", "dark");
    compare("one-hot-particle", "12", "light");
    compare("mixed-masses", "30", "dark");
    compare("time-reversal", "2", "dark");
    compare("time-reversal", "190", "print");
    compare("two-to-one", "6", "light");
    compare("tonks-gas", "40", "dark");
    compare("words", "2.1", "light");
    compare("words", "11", "dark");
    compare("wire", "9", "dark");
    compare("ring", "14", "light");
    compare("single-collision", "7", "light");
    compare("walls", "5", "print");
    compare("pistons", "8", "dark");
}

TEST_CASE("a vector picture is as it was, line by line") {
    compare_text(draw("vector", "2", "light", "svg"));
}

TEST_CASE("figures of several kinds are as they were") {
    compare_figures("figures", {"histogram.png", "series.svg", "strip.png"});
    compare_figures("pair", {"collision.png", "contact.png"});
    compare_figures("maps", {"map.svg", "map-of-a-wall.png", "walk.svg"});
}
