// Small pictures of scenes, and of those here that show what the scenes do not, against those kept
// here, with the fonts kept here. On a difference of more than 2 in a channel the picture and a map
// of the difference are left in build/golden/; a vector picture is compared as text, and the lines
// that differ are left there. CAROM_UPDATE_GOLDEN=1 makes the kept ones anew.
#include <cairo.h>
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "support/files.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

constexpr int tolerance =
    2;  // letters and rims may be rounded otherwise by another machine's pixman

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

/// A picture as it is kept, and as it is drawn.
struct Pair {
    fs::path kept, drawn;
};

// The letters of fonts/, whatever fonts are installed.
void pin_fonts() {
    const fs::path fonts = fs::path(CAROM_TEST_ROOT) / "tests/golden/fonts/fonts.conf";
    REQUIRE(fs::exists(fonts));
    REQUIRE(setenv("FONTCONFIG_FILE", fonts.c_str(), 1) == 0);
}

/// Draws a frame of a scene; where pictures are made anew it is the kept one too.
Pair draw(const std::string& scene, const std::string& at, const std::string& theme,
          const std::string& format) {
    const std::string name = scene + "-" + at + "-" + theme + "." + format;
    CAPTURE(name);
    pin_fonts();
    const Pair pair{fs::path(CAROM_TEST_ROOT) / "tests/golden" / name,
                    fs::path(CAROM_GOLDEN_OUTPUT) / name};
    fs::path file = fs::path(CAROM_TEST_ROOT) / "scenes" / (scene + ".yaml");
    if (!fs::exists(file)) file = fs::path(CAROM_TEST_ROOT) / "tests/golden" / (scene + ".yaml");
    const Outcome outcome = run({CAROM_PROGRAM, "still", file.string(), "--at", at, "--theme",
                                 theme, "--size", "480x270", "-o", pair.drawn.string(), "--quiet"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    if (std::getenv("CAROM_UPDATE_GOLDEN") != nullptr)
        fs::copy_file(pair.drawn, pair.kept, fs::copy_options::overwrite_existing);
    REQUIRE(fs::exists(pair.kept));
    return pair;
}

void compare_text(const std::string& scene, const std::string& at, const std::string& theme) {
    const auto [kept, drawn] = draw(scene, at, theme, "svg");
    CAPTURE(drawn.string());
    const bool same = contents(kept) == contents(drawn);
    const fs::path lines = drawn.string() + ".difference.txt";
    if (!same) std::ofstream(lines) << run({"diff", "-u", kept.string(), drawn.string()}).out;
    CHECK(same);
    if (same) fs::remove(drawn);
}

void compare(const std::string& scene, const std::string& at, const std::string& theme) {
    const auto [kept, drawn] = draw(scene, at, theme, "png");
    CAPTURE(drawn.string());
    const Picture expected(kept);
    const Picture found(drawn);
    REQUIRE(expected.width == found.width);
    REQUIRE(expected.height == found.height);
    const int largest = difference(expected, found, drawn.string() + ".difference.png");
    CHECK(largest <= tolerance);
    if (largest <= tolerance) fs::remove(drawn);
}

}  // namespace

TEST_CASE("small pictures of the scenes are as they were") {
    compare("one-hot-particle", "1", "dark");
    compare("one-hot-particle", "12", "light");
    compare("mixed-masses", "30", "dark");
    compare("time-reversal", "3", "dark");
    compare("time-reversal", "24", "print");
    compare("two-to-one", "6", "light");
    compare("tonks-gas", "40", "dark");
    compare("words", "2.1", "light");
    compare("words", "11", "dark");
    compare("wire", "9", "dark");
    compare("ring", "14", "light");
    compare("single-collision", "7", "light");
}

TEST_CASE("a vector picture is as it was, line by line") { compare_text("vector", "2", "light"); }
