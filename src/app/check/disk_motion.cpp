#include "app/check/disk_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/gas/drawn_radius.h"
#include "runs/number_json.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double most_diameters = 0.5;
constexpr double pixels_to_follow = 12.0;  // in a picture of `usual_lines`
constexpr double usual_lines = 1080.0;

double least_width_of(const Film& film) {
    return pixels_to_follow * std::min(film.size.width, film.size.height) / usual_lines;
}

// The mean speed of a species at a time: the last one known.
double speed_at(const std::vector<MeanSpeeds>& speeds, double time, std::size_t species) {
    const auto next = std::ranges::upper_bound(speeds, time, {}, &MeanSpeeds::time);
    return (next == speeds.begin() ? *next : *std::prev(next)).of_species[species];
}

// The longest mean way of a species from frame to frame, and when it is first about as long.
DiskMotion fastest(const std::vector<Tick>& ticks, const std::vector<MeanSpeeds>& speeds,
                   std::size_t species) {
    constexpr double about_as_long = 0.95;
    std::vector<double> ways{0.0};
    for (std::size_t k = 1; k < ticks.size(); ++k)
        ways.push_back((ticks[k].time - ticks[k - 1].time) *
                       speed_at(speeds, ticks[k - 1].time, species));
    DiskMotion found;
    found.diameters = std::ranges::max(ways);
    const auto first = std::ranges::find_if(
        ways, [&](double way) { return way >= about_as_long * found.diameters; });
    found.time = ticks[static_cast<std::size_t>(first - ways.begin())].time;
    return found;
}

std::string name_of(const DiskMotion& disk) {
    return disk.run.empty() ? disk.species : disk.species + " (" + disk.run + ")";
}

// "light 1.2, heavy 0.7".
std::string list_of(const std::vector<DiskMotion>& disks, double DiskMotion::*value) {
    std::vector<std::string> words;
    for (const DiskMotion& disk : disks)
        words.push_back(fmt::format("{} {:.2g}", printable(name_of(disk)), disk.*value));
    return fmt::format("{}", fmt::join(words, ", "));
}

// What makes the way of disks shorter.
std::string remedies(const Film& film, const Run& run, double diameters) {
    const double moving = static_cast<double>(moving_steps(film, run)) / film.fps;
    const double seconds = std::ceil(film.seconds + moving * (diameters / most_diameters - 1.0));
    std::string words = "give `streaks: true`";
    if (film.fps < 60) words += fmt::format(", `fps: 60` ({:.2g})", diameters * film.fps / 60.0);
    if (seconds <= most_seconds.value)
        words += fmt::format(" or `seconds: {:.0f}`", seconds);
    else
        words += " or a shorter run";
    return words;
}

std::vector<DiskMotion> those(const std::vector<DiskMotion>& disks, const auto& are) {
    std::vector<DiskMotion> chosen;
    std::ranges::copy_if(disks, std::back_inserter(chosen), are);
    return chosen;
}

}  // namespace

std::vector<DiskMotion> disk_motion(const Scene& scene, const Particles& drawn,
                                    const std::vector<MeanSpeeds>& speeds, double scale) {
    const std::vector<Tick> ticks = timeline(scene);
    const Eigen::ArrayXd radius = drawn_radius(scene.looks, drawn, drawn.species);
    std::vector<DiskMotion> all;
    for (std::size_t k = 0; k < scene.gas.species.size(); ++k) {
        const auto is_its = (drawn.species == static_cast<int>(k)).cast<double>();
        const double count = is_its.sum();
        const double diameter = 2.0 * (is_its * radius).sum() / std::max(1.0, count);
        if (scene.gas.box.dimension == 1 || count == 0.0 || diameter <= 0.0) continue;
        DiskMotion disk = speeds.empty() ? DiskMotion{} : fastest(ticks, speeds, k);
        disk.species = scene.gas.species[k].name;
        disk.pixels = diameter * scale;
        disk.diameters /= diameter;
        all.push_back(std::move(disk));
    }
    return all;
}

Json motion_value(const std::vector<DiskMotion>& disks) {
    Json list = Json::array();
    for (const DiskMotion& disk : disks) {
        list.push_back({{"species", disk.species},
                        {"pixels", Amount{disk.pixels, quantities::number}},
                        {"diameters_a_frame", Amount{disk.diameters, quantities::number}},
                        {"time", Amount{disk.time, quantities::time}}});
        if (!disk.run.empty()) list.back()["run"] = disk.run;
    }
    return list;
}

Facts motion_rows(const Scene& scene, const std::vector<DiskMotion>& disks) {
    const Film& film = scene.film;
    const bool is_deep = scene.gas.box.dimension == 3;
    const char* body = is_deep ? "sphere" : "disk";
    Facts rows;
    const std::vector<DiskMotion> fast =
        those(disks, [](const DiskMotion& disk) { return disk.diameters > most_diameters; });
    if (!fast.empty() && !film.streaks) {
        const DiskMotion& first = *std::ranges::max_element(fast, {}, &DiskMotion::diameters);
        rows.push_back(for_people(
            "motion",
            fmt::format(
                "diameters that a {} travels from frame to frame where the film is "
                "fastest (t = {:.3g}), on average: {}; with more than {} it seems to jump: {}",
                body, first.time, list_of(fast, &DiskMotion::diameters), most_diameters,
                remedies(film, scene.run, first.diameters))));
    }
    const double least = least_width_of(film);
    const std::vector<DiskMotion> small =
        those(disks, [&](const DiskMotion& disk) { return disk.pixels < least - 0.05; });
    if (!small.empty())
        rows.push_back(for_people(
            is_deep ? "small spheres" : "small disks",
            fmt::format("pixels that a {} is wide: {}; fewer than {:.2g} are hard to follow: give "
                        "larger radii or a smaller box",
                        body, list_of(small, &DiskMotion::pixels), least)));
    return rows;
}

}  // namespace carom
