#include "draw/disks/small_disks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "draw/disks/disks.h"
#include "support/pixels.h"
#include "util/random.h"

using namespace carom;
using test::pixels_of;

namespace {

constexpr PixelSize size = {60, 50};
constexpr Rect everywhere = {0, 0, 1e6, 1e6};
constexpr std::uint32_t ground = 0x161B21;

void draw(Canvas& canvas, const std::vector<Disk>& disks, Rect clip = everywhere) {
    SmallDisks small;
    small.begin(canvas.size(), clip);
    for (const Disk& disk : disks) small.add(disk);
    small.draw(canvas);
}

// On a lattice that is wide enough for the largest, each as far off its place as keeps it clear of
// the others; the radii and colours are random.
std::vector<Disk> parted_disks(double least_radius, double most_radius, double packing) {
    Random random(5, "small disks of a test");
    const double apart = most_radius * std::sqrt(std::numbers::pi / packing);
    std::vector<Disk> disks;
    for (double y = -2; y < size.height + 2; y += apart)
        for (double x = -2; x < size.width + 2; x += apart) {
            const double radius = random.uniform(least_radius, most_radius);
            const double free = 0.5 * apart - radius;
            disks.push_back({static_cast<float>(x + random.uniform(-free, free)),
                             static_cast<float>(y + random.uniform(-free, free)),
                             static_cast<float>(radius),
                             static_cast<std::uint32_t>(random.below(1 << 24))});
        }
    return disks;
}

// The mean colour of each pixel by 64 x 64 samples: blue, green, red.
std::vector<std::array<double, 3>> sampled(const std::vector<Disk>& disks) {
    constexpr int samples = 64;
    const auto levels = [](std::uint32_t color) {
        return std::array<double, 3>{double(color & 0xFF), double(color >> 8 & 0xFF),
                                     double(color >> 16 & 0xFF)};
    };
    std::vector<std::array<double, 3>> means(static_cast<std::size_t>(size.width * size.height),
                                             levels(ground));
    for (const Disk& disk : disks) {
        const double x = disk.x, y = disk.y, radius = disk.radius;
        const auto begin = [](double at) { return std::max(0, int(std::floor(at * samples))); };
        const auto end = [](double at, int most) {
            return std::min(most * samples, int(std::ceil(at * samples)));
        };
        for (int row = begin(y - radius); row < end(y + radius, size.height); ++row)
            for (int column = begin(x - radius); column < end(x + radius, size.width); ++column) {
                const double dx = (column + 0.5) / samples - x, dy = (row + 0.5) / samples - y;
                if (dx * dx + dy * dy >= radius * radius) continue;
                auto& mean =
                    means[static_cast<std::size_t>(row / samples * size.width + column / samples)];
                for (std::size_t k = 0; k < 3; ++k)
                    mean.at(k) +=
                        (levels(disk.color).at(k) - levels(ground).at(k)) / (samples * samples);
            }
    }
    return means;
}

// Without overlaps, and clear of the edges of the picture.
std::vector<Disk> white_disks(double radius) {
    std::vector<Disk> disks = parted_disks(radius, radius, 0.4);
    std::erase_if(disks, [](const Disk& disk) {
        return disk.x < 2 || disk.y < 2 || disk.x > size.width - 2 || disk.y > size.height - 2;
    });
    for (Disk& disk : disks) disk.color = 0xFFFFFF;
    return disks;
}

double light_of(const Canvas& canvas) {
    double light = 0.0;
    for (const std::uint32_t pixel : pixels_of(canvas)) light += (pixel & 0xFF) / 255.0;
    return light;
}

}  // namespace

TEST_CASE("small disks give the picture of many samples in each pixel") {
    struct Case {
        double least_radius, most_radius, packing;
    };
    for (const Case& one : {Case{0.1, 0.1, 0.3}, Case{0.33, 0.33, 0.7}, Case{0.5, 0.5, 0.3},
                            Case{0.7, 0.7, 0.5}, Case{1.2, 1.2, 0.6}, Case{0.05, 1.2, 0.6}}) {
        CAPTURE(one.least_radius);
        CAPTURE(one.most_radius);
        const std::vector<Disk> disks =
            parted_disks(one.least_radius, one.most_radius, one.packing);
        Canvas canvas(size);
        canvas.fill_all(rgb(ground));
        draw(canvas, disks);
        const auto expected = sampled(disks);
        const std::vector<std::uint32_t> found = pixels_of(canvas);
        double largest = 0.0, sum = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const double off = std::abs(double(found[i] >> (8 * k) & 0xFF) - expected[i].at(k));
                largest = std::max(largest, off);
                sum += off;
            }
        // An edge is right to 1/64 pixel: 1/128 of its place and 1/128 of its radius. Across a
        // pixel that is 4 levels where the colours are black and white. Rounding is a quarter of a
        // level on average.
        CHECK(largest <= 4.5);
        CHECK(sum / static_cast<double>(3 * found.size()) < 0.6);
    }
}

TEST_CASE("small disks cover their area, wherever they lie and whatever their radius") {
    for (const double radius : {0.02, 0.1, 0.247, 0.5, 0.613, 1.0, 1.2, 1.5}) {
        CAPTURE(radius);
        const double area = std::numbers::pi * radius * radius;
        Canvas alone(size);
        draw(alone, {{20.3F, 20.7F, static_cast<float>(radius), 0xFFFFFF}});
        CHECK(std::abs(light_of(alone) - area) <= 16 * 0.5 / 255);  // half a level in each pixel
        const std::vector<Disk> disks = white_disks(radius);
        Canvas canvas(size);
        draw(canvas, disks);
        // Levels of many disks are rounded up as often as down.
        CHECK(light_of(canvas) ==
              doctest::Approx(static_cast<double>(disks.size()) * area).epsilon(0.004));
    }
}

TEST_CASE("small disks that overlap are mixed by their shares and never cover more than all") {
    Canvas canvas(size);
    draw(canvas, std::vector<Disk>(300, {20.5F, 20.5F, 0.4F, 0x0000FF}));
    CHECK((pixels_of(canvas)[20 * 60 + 20] & 0xFFFFFF) == 0x0000FF);
    std::vector<Disk> both(300, {20.5F, 20.5F, 0.4F, 0x00FF00});
    both.resize(400, {20.5F, 20.5F, 0.4F, 0xFF0000});
    draw(canvas, both);
    CHECK((pixels_of(canvas)[20 * 60 + 20] & 0xFFFFFF) == 0x40BF00);
}

TEST_CASE("small disks stay within their clip, and what has no size or place is left out") {
    const std::vector<Disk> disks = parted_disks(0.5, 0.5, 0.5);
    Canvas canvas(size), whole(size);
    canvas.fill_all(rgb(ground));
    whole.fill_all(rgb(ground));
    const std::vector<std::uint32_t> before = pixels_of(canvas);
    draw(canvas, disks, {10, 12, 30, 20});
    draw(whole, disks);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto i = static_cast<std::size_t>(y * size.width + x);
            const bool inside = x >= 10 && x < 40 && y >= 12 && y < 32;
            CHECK(pixels_of(canvas)[i] == (inside ? pixels_of(whole)[i] : before[i]));
        }
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), much = 1e30F;
    const std::vector<std::uint32_t> drawn = pixels_of(canvas);
    draw(canvas, {{nan, 9, 1, 0},
                  {9, nan, 1, 0},
                  {9, 9, nan, 0},
                  {9, 9, 0, 0},
                  {9, 9, -1, 0},
                  {much, 9, 1, 0},
                  {9, -much, 1, 0},
                  {9, 9, much, 0}});
    CHECK(pixels_of(canvas) == drawn);
}

TEST_CASE("a picture of small disks does not depend on what was drawn before it") {
    const std::vector<Disk> disks = parted_disks(0.05, 1.2, 0.6);
    Canvas first(size), second(size), fresh(size);
    DiskPainter painter;
    for (Canvas* canvas : {&first, &second}) {
        SmallDisks& small = painter.small_disks();
        small.begin(canvas->size(), everywhere);
        for (const Disk& disk : disks) small.add(disk);
        small.draw(*canvas);
    }
    draw(fresh, disks);
    CHECK(pixels_of(first) == pixels_of(fresh));
    CHECK(pixels_of(second) == pixels_of(fresh));
}

TEST_CASE("small disks cover a transparent ground by their share") {
    Canvas canvas(size, Backdrop::transparent);
    draw(canvas, {{20.5F, 20.5F, 0.4F, 0xFF8000}});
    const std::uint32_t pixel = pixels_of(canvas)[20 * 60 + 20];
    const double share = 0.16 * std::numbers::pi;
    CHECK(std::abs(static_cast<double>(pixel >> 24) - 255 * share) <= 1.0);
    CHECK(std::abs(static_cast<double>(pixel >> 16 & 0xFF) - 255 * share) <= 1.0);
    CHECK(std::abs(static_cast<double>(pixel >> 8 & 0xFF) - 128 * share) <= 1.0);
    CHECK((pixel & 0xFF) == 0);
}
