// CPU time of drawing disks and text at 1080p: the median of repeated frames, as a table.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/text.h"
#include "util/random.h"

namespace {

using namespace carom;

constexpr PixelSize full_hd = {1920, 1080};

double thread_ms() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double median_ms(const std::function<void(int frame)>& draw) {
    constexpr int frames = 31;
    std::vector<double> times;
    for (int frame = 0; frame < frames; ++frame) {
        const double start = thread_ms();
        draw(frame);
        times.push_back(thread_ms() - start);
    }
    std::ranges::nth_element(times, times.begin() + frames / 2);
    return times[frames / 2];
}

// Random disks in the square that a lecture film gives to its gas.
std::vector<Disk> random_disks(int count, double least_radius, double most_radius) {
    Random random(1, "benchmark disks");
    std::vector<Disk> disks(static_cast<std::size_t>(count));
    for (Disk& disk : disks)
        disk = {static_cast<float>(random.uniform(10, 1070)),
                static_cast<float>(random.uniform(10, 1070)),
                static_cast<float>(random.uniform(least_radius, most_radius)),
                static_cast<std::uint32_t>(random.below(1 << 24))};
    return disks;
}

// CPU milliseconds per frame. Each frame moves the disks by a fraction of a pixel, as in a film.
double disks_ms(int count, double least_radius, double most_radius) {
    Canvas canvas(full_hd);
    DiskPainter painter;
    std::vector<Disk> disks = random_disks(count, least_radius, most_radius);
    return median_ms([&](int) {
        for (Disk& disk : disks) disk.x += 0.37F;
        painter.draw(canvas, disks, {0, 0, full_hd.width, full_hd.height});
    });
}

double texts_ms(bool is_new_each_time) {
    constexpr int count = 100;
    Canvas canvas(full_hd);
    const TextStyle style{.size = 37, .weight = 500, .color = rgb(0xFFFFFF)};
    return median_ms([&](int frame) {
        for (int i = 0; i < count; ++i)
            draw_text(canvas, {100, 100 + 8.0 * i},
                      fmt::format("{:.3f}", 0.1 * i + (is_new_each_time ? 100 * frame : 0)), style);
    });
}

void print_row(const std::string& what, double ms) { fmt::print("{:<44} {:8.3f} ms\n", what, ms); }

}  // namespace

int main() {
    print_row("100 disks, radius 20", disks_ms(100, 20, 20));
    for (const double radius : {5.0, 10.0, 20.0})
        print_row(fmt::format("1,000 disks, radius {}", radius), disks_ms(1000, radius, radius));
    print_row("1,000 disks, 1,000 radii from 5 to 20", disks_ms(1000, 5, 20));
    for (const double radius : {2.0, 3.2, 5.0})
        print_row(fmt::format("10,000 disks, radius {}", radius), disks_ms(10000, radius, radius));
    print_row("10,000 disks, many radii from 2 to 5", disks_ms(10000, 2, 5));
    print_row("100,000 disks, radius 1.2", disks_ms(100000, 1.2, 1.2));
    print_row("100 texts, the same ones", texts_ms(false));
    print_row("100 texts, new ones", texts_ms(true));
    Canvas canvas(full_hd);
    const Canvas layer(full_hd);
    print_row("copy of a layer", median_ms([&](int) {
                  canvas.touch({0, 0, 1920, 1080});
                  canvas.restore(layer);
              }));
}
