#include "draw/disks/disks.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "draw/disks/disk_mask.h"
#include "support/pixels.h"
#include "util/random.h"

using namespace carom;
using test::pixels_of;

namespace {

constexpr Rect everywhere = {0, 0, 1e6, 1e6};

int level(const Canvas& canvas, int x, int y) {
    const PixelView pixels = canvas.pixels();
    return static_cast<int>(pixels.data[y * pixels.stride + x] & 0xFF);
}

void draw_one(Canvas& canvas, const Disk& disk) {
    DiskPainter painter;
    painter.draw(canvas, {&disk, 1}, everywhere);
}

struct Blob {
    double area = 0, x = 0, y = 0;
};

Blob blob_of(const Canvas& canvas) {
    Blob blob;
    for (int y = 0; y < canvas.size().height; ++y)
        for (int x = 0; x < canvas.size().width; ++x) {
            const double share = level(canvas, x, y) / 255.0;
            blob.area += share;
            blob.x += share * (x + 0.5);
            blob.y += share * (y + 0.5);
        }
    blob.x /= blob.area;
    blob.y /= blob.area;
    return blob;
}

// The share of a pixel inside a disk, by 32 x 32 samples.
double sampled_coverage(const Disk& disk, int x, int y) {
    constexpr int samples = 32;
    int inside = 0;
    for (int i = 0; i < samples * samples; ++i) {
        const double dx = x + (i % samples + 0.5) / samples - disk.x;
        const double dy = y + (i / samples + 0.5) / samples - disk.y;
        inside += dx * dx + dy * dy < static_cast<double>(disk.radius) * disk.radius;
    }
    return inside / static_cast<double>(samples * samples);
}

std::vector<Disk> random_disks(int count, double least_radius, double most_radius, PixelSize size) {
    Random random(7, "disks of a test");
    std::vector<Disk> disks(static_cast<std::size_t>(count));
    for (Disk& disk : disks)
        disk = {static_cast<float>(random.uniform(-20, size.width + 20)),
                static_cast<float>(random.uniform(-20, size.height + 20)),
                static_cast<float>(random.uniform(least_radius, most_radius)),
                static_cast<std::uint32_t>(random.below(1 << 24))};
    return disks;
}

}  // namespace

TEST_CASE("a disk has its area and lies where it is") {
    Random random(3, "positions");
    for (const float radius :
         {1.2F, 1.7F, 2.0F, 2.9F, 4.0F, 5.0F, 7.99F, 8.01F, 13.3F, 40.6F, 70.0F}) {
        for (int i = 0; i < 20; ++i) {
            Canvas canvas({160, 160});
            const Disk disk{static_cast<float>(random.uniform(75, 85)),
                            static_cast<float>(random.uniform(75, 85)), radius, 0xFFFFFF};
            draw_one(canvas, disk);
            const Blob blob = blob_of(canvas);
            CAPTURE(radius);
            CHECK(blob.area == doctest::Approx(std::numbers::pi * radius * radius).epsilon(0.005));
            CHECK(std::abs(blob.x - disk.x) < 1.0 / 16);
            CHECK(std::abs(blob.y - disk.y) < 1.0 / 16);
        }
    }
}

TEST_CASE("a speck smaller than a pixel keeps its share of light") {
    for (const float radius : {0.25F, 0.5F}) {
        Canvas canvas({20, 20});
        draw_one(canvas, {10.0F, 10.5F, radius, 0xFFFFFF});
        // Levels of one or two pixels are whole: half a level each.
        CHECK(std::abs(blob_of(canvas).area - std::numbers::pi * radius * radius) < 0.02);
    }
}

TEST_CASE("coverages are those of samples") {
    // On the grid of phases and radii, so that only the coverage itself is compared.
    for (const Disk& disk :
         {Disk{20.0F, 20.0F, 10.0F, 0xFFFFFF}, Disk{20.5625F, 19.3125F, 3.5F, 0xFFFFFF},
          Disk{20.25F, 20.9375F, 1.25F, 0xFFFFFF}, Disk{20.0625F, 20.125F, 15.125F, 0xFFFFFF}}) {
        Canvas canvas({40, 40});
        draw_one(canvas, disk);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                // 32 x 32 samples are right to about 2/255 on an edge, 16 lines to 2/255.
                CHECK(std::abs(level(canvas, x, y) - 255 * sampled_coverage(disk, x, y)) <= 4.0);
    }
}

TEST_CASE("the picture is close to Cairo's own arcs") {
    const PixelSize size = {300, 200};
    const std::vector<Disk> disks = random_disks(60, 2, 25, size);
    Canvas ours(size), cairos(size);
    DiskPainter painter;
    painter.draw(ours, disks, everywhere);
    for (const Disk& disk : disks)
        cairos.fill_circle({disk.x, disk.y}, disk.radius, rgb(disk.color));
    double difference = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            difference += std::abs(level(ours, x, y) - level(cairos, x, y));
    // Up to 1/32 pixel between the centres moves the levels of the rims, a tenth of all pixels
    // here.
    CHECK(difference / (size.width * size.height) < 0.5);
}

TEST_CASE("touching disks touch and parted ones are parted") {
    for (const float radius : {3.0F, 6.5F, 10.0F, 24.0F}) {
        Canvas canvas({120, 60});
        DiskPainter painter;
        const Disk touching[] = {{60 - radius, 30.5F, radius, 0xFFFFFF},
                                 {60 + radius, 30.5F, radius, 0xFFFFFF}};
        painter.draw(canvas, touching, everywhere);
        // The chord a pixel's depth below the pole is longer than a pixel from radius 3 on.
        CHECK(level(canvas, 59, 30) > 230);
        CHECK(level(canvas, 60, 30) > 230);
        canvas.fill_all(rgb(0));
        const Disk parted[] = {{59 - radius, 30.5F, radius, 0xFFFFFF},
                               {61 + radius, 30.5F, radius, 0xFFFFFF}};
        painter.draw(canvas, parted, everywhere);
        CHECK(level(canvas, 59, 30) == 0);
        CHECK(level(canvas, 60, 30) == 0);
    }
}

TEST_CASE("later disks lie over earlier ones, in their very colour") {
    Canvas canvas({60, 60});
    DiskPainter painter;
    const Disk disks[] = {{25, 30, 12, 0x123456}, {35, 30, 12, 0xFEDCBA}};
    painter.draw(canvas, disks, everywhere);
    const PixelView pixels = canvas.pixels();
    CHECK(pixels.data[30 * pixels.stride + 30] == 0xFFFEDCBAU);
    CHECK(pixels.data[30 * pixels.stride + 18] == 0xFF123456U);
}

TEST_CASE("a clip cuts and changes nothing else") {
    const PixelSize size = {150, 110};
    const Rect clip = {31, 17, 70, 60};
    for (const double radius : {3.0, 30.0}) {
        const std::vector<Disk> disks = random_disks(80, 0.7 * radius, radius, size);
        Canvas whole(size), cut(size);
        DiskPainter painter;
        painter.draw(whole, disks, everywhere);
        painter.draw(cut, disks, clip);
        const PixelView all = whole.pixels(), part = cut.pixels();
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const bool inside = x >= 31 && x < 101 && y >= 17 && y < 77;
                const std::uint32_t expected = inside ? all.data[y * all.stride + x] : 0;
                CHECK((part.data[y * part.stride + x] & 0xFFFFFF) == (expected & 0xFFFFFF));
            }
    }
}

TEST_CASE("what is remembered does not show") {
    const PixelSize size = {400, 300};
    const std::vector<Disk> disks = random_disks(6000, 1, 70, size);
    Canvas first(size), again(size);
    DiskPainter painter;
    painter.draw(first, disks, everywhere);
    painter.draw(again, disks, everywhere);
    painter.draw(again, disks, everywhere);
    CHECK(pixels_of(first) == pixels_of(again));
}

TEST_CASE("disks that make no sense are left out") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    Canvas canvas({50, 50});
    DiskPainter painter;
    const Disk disks[] = {{nan, 10, 5, 0xFFFFFF},       {10, nan, 5, 0xFFFFFF},
                          {10, 10, nan, 0xFFFFFF},      {infinite, 10, 5, 0xFFFFFF},
                          {10, 10, infinite, 0xFFFFFF}, {1e30F, -1e30F, 5, 0xFFFFFF},
                          {10, 10, 0, 0xFFFFFF},        {10, 10, -3, 0xFFFFFF}};
    painter.draw(canvas, disks, everywhere);
    CHECK(blob_of(canvas).area == 0);
    const Disk huge = {25, -9000, 9030, 0xFFFFFF};
    painter.draw(canvas, {&huge, 1}, everywhere);
    CHECK(level(canvas, 25, 28) == 255);
    CHECK(level(canvas, 25, 31) == 0);
}

TEST_CASE("a mask that is dropped leaves no trace in its store") {
    MaskStore store;
    const DiskMask kept = store.add({.phase_x = 3, .phase_y = 9, .radius = 2000});
    const std::size_t bytes = store.bytes();
    const DiskMask dropped = store.add({.phase_x = 1, .phase_y = 2, .radius = 7000});
    CHECK(store.bytes() > bytes);
    store.truncate_to(dropped);
    CHECK(store.bytes() == bytes);
    CHECK(store.rows(kept)[kept.height / 2].left_groups > 0);
}

TEST_CASE(
    "a lit sphere covers what a disk covers, brightest at the upper left, in all formats alike") {
    const Disk disk{64.0F, 64.0F, 40.0F, 0x4080C0};
    Canvas lit({128, 128}), flat({128, 128});
    DiskPainter painter;
    painter.draw_lit(lit, {&disk, 1}, everywhere);
    painter.draw(flat, {&disk, 1}, everywhere);
    const auto lit_pixels = pixels_of(lit), flat_pixels = pixels_of(flat);
    for (std::size_t i = 0; i < lit_pixels.size(); ++i)
        CHECK((lit_pixels[i] == flat_pixels[64 * 128]) ==
              (flat_pixels[i] == flat_pixels[64 * 128]));
    // Along the diagonal through the highlight, from there on.
    int before = 256;
    for (int k = 52; k < 91; ++k) {
        CHECK(level(lit, k, k) <= before);
        before = level(lit, k, k);
    }
    CHECK(level(lit, 52, 52) > 0xC0);
    CHECK(level(lit, 90, 90) < 0x80);
    // Circles around the highlight have one colour: (52, 52) is the nearest pixel to it.
    CHECK(std::abs(level(lit, 72, 52) - level(lit, 52, 72)) <= 1);
    CHECK(std::abs(level(lit, 32, 52) - level(lit, 52, 32)) <= 1);
    // A document has a gradient.
    Canvas document({128, 128}, VectorFormat::svg, {"T", "D"});
    painter.draw_lit(document, {&disk, 1}, everywhere);
    const auto bytes = document.file();
    const std::string text(bytes.begin(), bytes.end());
    CHECK(text.find("radialGradient") != std::string::npos);
}

TEST_CASE("a lit sphere does not depend on those that were drawn before it") {
    const std::vector<Disk> many = random_disks(3000, 1.0, 30.0, {200, 200});
    Canvas once({200, 200}), again({200, 200});
    DiskPainter fresh, used;
    used.draw_lit(again, many, everywhere);
    for (Canvas* canvas : {&once, &again}) canvas->fill_all(rgb(0x000000));
    used.draw_lit(again, many, {20, 20, 150, 150});
    fresh.draw_lit(once, many, {20, 20, 150, 150});
    CHECK(pixels_of(once) == pixels_of(again));
}
