// The cost of a film of very many disks. Fails if drawing them by their pixel coverage takes more
// than half as long as drawing masks of the smallest visible size, or if the film takes more memory
// than was announced before.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "bench/process_cost.h"
#include "draw/disks/disks.h"
#include "draw/disks/small_disks.h"
#include "films/cost/film_cost.h"
#include "films/film_plan.h"
#include "films/render.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "util/random.h"

using namespace carom;

namespace {

constexpr double most_of_masks = 0.5, packing = 0.3;
constexpr int threads = 2;

std::vector<Disk> disks_in(const Rect& box, std::int64_t count, double radius) {
    Random random(1, "disks of a benchmark");
    std::vector<Disk> disks(static_cast<std::size_t>(count));
    for (Disk& disk : disks)
        disk = {static_cast<float>(random.uniform(box.x, box.right())),
                static_cast<float>(random.uniform(box.y, box.bottom())), static_cast<float>(radius),
                static_cast<std::uint32_t>(random.below(1 << 24))};
    return disks;
}

// CPU seconds: the minimum of some frames.
template <typename Draw>
double seconds_of(const Draw& draw) {
    constexpr int frames = 7;
    double least = std::numeric_limits<double>::infinity();
    for (int frame = 0; frame < frames; ++frame) {
        const double begin = test::cpu_seconds();
        draw();
        least = std::min(least, test::cpu_seconds() - begin);
    }
    return least;
}

// The gas fills the square that a lecture film at 1080p gives to it.
bool drawing_is_cheap(std::int64_t count) {
    constexpr double smallest_visible = 1.2;
    const Rect box{40, 145, 815, 815};
    const double radius = std::sqrt(packing * box.width * box.height /
                                    (std::numbers::pi * static_cast<double>(count)));
    const std::vector<Disk> as_they_are = disks_in(box, count, radius),
                            enlarged = disks_in(box, count, smallest_visible);
    Canvas canvas({1920, 1080});
    DiskPainter painter;
    const double shares = seconds_of([&] {
        SmallDisks& small = painter.small_disks();
        small.begin(canvas.size(), box);
        for (const Disk& disk : as_they_are) small.add(disk);
        small.draw(canvas);
    });
    const double masks = seconds_of([&] { painter.draw(canvas, enlarged, box); });
    const double ratio = shares / masks;
    fmt::print(
        "{} disks of {:.2f} pixels: {:.1f} ms a frame ({:.0f} ns a disk); as masks {:.1f} ms; "
        "ratio {:.2f} (at most {})\n",
        count, radius, 1e3 * shares, 1e9 * shares / static_cast<double>(count), 1e3 * masks, ratio,
        most_of_masks);
    return ratio <= most_of_masks;
}

bool film_keeps_its_memory(std::int64_t count, double seconds) {
    const double side = std::sqrt(static_cast<double>(count) * 0.25 * std::numbers::pi / packing);
    const Scene scene =
        load_scene_text(fmt::format("title: T\nbox: {{size: [{0}, {0}]}}\ngas:\n"
                                    "  - {{name: gas, count: {1}, radius: 0.5, temperature: 1}}\n"
                                    "run: {{until: 0.1}}\nfilm: {{seconds: {2}}}\n",
                                    side, count, seconds),
                        "bench", scene_resources());
    const FilmOptions options{
        .output = "film.mp4", .threads = threads, .take = [](const FilmWriter&) {}};
    const test::Cost cost = test::cost_of([&] {
        const double begin = test::cpu_seconds();
        Progress silent(Progress::Form::silent, "");
        render(scene, options, silent);
        return begin;
    });
    const auto named = static_cast<double>(
        memory_of_film(scene, format_of_film(options.output), count, {}, threads));
    const int frames = frame_count(scene.film);
    fmt::print(
        "film of {} disks, {} frames: {:.1f} s of CPU ({:.0f} ns a disk and frame), {:.0f} MB; "
        "named {:.0f} MB\n",
        count, frames, cost.seconds, 1e9 * cost.seconds / static_cast<double>(count * frames),
        1e-6 * cost.bytes, 1e-6 * named);
    return cost.bytes <= named;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const bool cheap = drawing_is_cheap(quick ? 1'000'000 : 2'000'000);
    return film_keeps_its_memory(quick ? 200'000 : 1'000'000, quick ? 1.0 : 3.0) && cheap ? 0 : 1;
}
