#include "films/cost/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "films/cost/panel_seconds.h"
#include "films/cost/work_parts.h"
#include "physics/theory/collision_rate.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

// CPU seconds, measured with one core of the machine of docs/encoding.md; docs/limits.md compares
// estimates with whole commands.
constexpr double of_collision = 0.28e-6, of_crossing = 0.13e-6;  // in doubles
constexpr double of_surfaces = 1.4;      // factor where surfaces act or there is gravity
constexpr double of_row = 0.3e-6;        // of a row of a table for each particle
constexpr double of_event_row = 1.2e-6;  // of a row for each collision

// A collision in arithmetic of so many bits, from measured runs of 64 to 4,096 bits.
double seconds_of_collision(int bits) {
    if (bits <= bits_of_double) return of_collision;
    return 4e-6 * (1.0 + std::pow(bits / 500.0, 1.3));
}

// A particle in a time step, from runs of 100 to 20,000 disks that cover 0.016 to 0.34 of the box:
// more neighbours are looked at in dense gases, and memory is slower in large ones.
double seconds_of_step(const Scene& scene) {
    constexpr double of_few = 0.04e-6, few = 100.0;
    const auto [gas, sample] = draw_gas(scene.gas);
    const double neighbours = 0.4 + 3.0 * packing_fraction(scene.gas.box, gas);
    return of_few * neighbours * std::pow(std::max(1.0, count_of(scene) / few), 0.42);
}

// Once from the start of a run to its end, and, where its precision is found by trials, these.
double simulation_seconds(const Scene& scene, const RunCounts& counts) {
    if (scene.run.time_step) return counts.events * seconds_of_step(scene);
    const double longer = 1.0 + scene.run.equilibrate / scene.run.until;
    const double collisions = collisions_of(counts);
    double seconds = collisions * seconds_of_collision(counts.bits) +
                     std::max(0.0, counts.events - collisions) * of_crossing;
    if (!scene.gas.box.surfaces.are_plain()) seconds *= of_surfaces;
    constexpr double trials = 1.2;  // on average, beyond the run itself
    if (!scene.run.bits && counts.bits > bits_of_double) seconds *= 1.0 + trials;
    return longer * seconds;
}

// A particle in a sample of `carom run`; large gases without surfaces are followed by changes.
double seconds_of_sample(const Scene& scene, int bits) {
    constexpr double many = 1000.0;
    if (bits > bits_of_double) return seconds_of_look(bits);
    if (!scene.gas.box.surfaces.are_plain()) return 0.2e-6;
    return count_of(scene) < many ? 0.05e-6 : 0.01e-6;
}

// To read a scene and to begin its run.
double loading(const Scene& scene) {
    constexpr double of_run = 2e-3, of_byte = 0.3e-6;
    return of_run + of_byte * static_cast<double>(scene.source.text.size());
}

}  // namespace

double samples_of(const Run& run) { return 1.0 + std::ceil(run.until / run.sample_every); }

double seconds_of_look(int bits) {
    return bits > bits_of_double ? 0.4e-6 * (1.0 + bits / 600.0) : 0.0;
}

WorkPart simulation_part(const Scene& scene, const RunCounts& counts, double times) {
    const std::string what =
        scene.run.time_step
            ? fmt::format("{} time steps of particles", about(counts.events))
            : fmt::format("{} collisions and crossings of cells{}", about(counts.events),
                          counts.bits > bits_of_double
                              ? fmt::format(" in numbers of {} bits", counts.bits)
                              : std::string());
    return {
        .what = what + (times > 1.0 ? fmt::format(", in each of {:.0f} runs", times) : ""),
        .reduce = std::string(times > 1.0 ? "`seeds`, " : "") +
                  (counts.bits > bits_of_double ? "`run.until`, `run.precision` or the particles"
                                                : "`run.until` or the particles"),
        .seconds = times * simulation_seconds(scene, counts),
        .place = {}};
}

std::string about(double value) {
    if (value >= 1e15) return three_digits(value);
    if (value < 0.01) return value > 0.0 ? "less than 0.01" : "0";
    if (value < 10.0) return fmt::format("{:.2g}", value);
    const double digits = std::floor(std::log10(value)) - 1.0;
    const double unit = std::pow(10.0, std::max(0.0, digits));
    return grouped(static_cast<long long>(unit * std::round(value / unit)));
}

double Work::seconds() const {
    return std::accumulate(parts.begin(), parts.end(), 0.0,
                           [](double sum, const WorkPart& part) { return sum + part.seconds; });
}

const WorkPart& Work::largest() const {
    return *std::ranges::max_element(parts, {}, &WorkPart::seconds);
}

Work together(const Work& first, const Work& second) {
    Work both = first;
    both.parts.insert(both.parts.end(), second.parts.begin(), second.parts.end());
    if (second.memory > first.memory) {
        both.memory = second.memory;
        both.reduces_memory = second.reduces_memory;
    }
    if (second.bytes > first.bytes) both.reduces_bytes = second.reduces_bytes;
    both.bytes += second.bytes;
    return both;
}

Work work_of_run(const Scene& scene, const RunCounts& counts, const RunTables& tables) {
    constexpr double of_sample_row = 105.0, of_place_row = 95.0, of_collision_row = 300.0;  // bytes
    const double rows = samples_of(scene.run) * count_of(scene);
    const double collisions = tables.collisions ? collisions_of(counts) : 0.0;
    const double files = (tables.samples ? 1.0 : 0.0) + (tables.trajectory ? 1.0 : 0.0);
    Work work{.parts = {simulation_part(scene, counts, 1.0)},
              .memory = bytes_of_program + bytes_of_particle * count_of(scene),
              .reduces_memory = "the particles",
              .reduces_bytes = "`run.sample_every`, `run.until` or the particles"};
    work.parts.push_back(
        {.what = fmt::format("{} samples of {} particles", about(samples_of(scene.run)),
                             about(count_of(scene))),
         .reduce = "`run.sample_every` or the particles",
         .seconds = rows * (seconds_of_sample(scene, counts.bits) + files * of_row) +
                    collisions * of_event_row});
    for (const PanelSpec& spec : scene.measure)
        work.parts.push_back(
            {.what = fmt::format("the instrument `{}`", spec.kind),
             .reduce = reduces_panel(spec, scene.run),
             .seconds = panel_seconds(scene, spec, samples_of(scene.run), 1.0, counts),
             .place = spec.place});
    work.bytes =
        rows * ((tables.samples ? of_sample_row : 0.0) + (tables.trajectory ? of_place_row : 0.0)) +
        collisions * of_collision_row;
    return work;
}

Work work_of_sweep(const Sweep& sweep, const SceneAtPoint& scene_at) {
    constexpr std::int64_t usual = 100;
    const std::shared_ptr<const Scene> first = scene_at(0);
    Work work{.parts = {{.what = counted(sweep.runs(), "run") + " of a sweep",
                         .reduce = "the seeds and values, `run.until` or the particles",
                         .seconds = static_cast<double>(sweep.runs()) * loading(*first)}}};
    const bool is_limited = first->source.is_held_to_classroom;
    if (is_limited && work.seconds() > most_classroom_work.value) return work;
    const std::int64_t tried = is_limited ? sweep.points() : std::min(usual, sweep.points());
    const double share = 1.0 / static_cast<double>(tried);
    for (std::int64_t k = 0; k < tried; ++k) {
        throw_if_interrupted();
        const std::int64_t point = tried > 1 ? k * (sweep.points() - 1) / (tried - 1) : 0;
        const std::shared_ptr<const Scene> scene = scene_at(point);
        const Work run = work_of_run(*scene, counts_of(*scene, {}, share));
        work.parts.front().seconds += share * static_cast<double>(sweep.runs()) * run.seconds();
        work.memory = std::max(work.memory, run.memory);
        work.reduces_memory = run.reduces_memory;
    }
    return work;
}

void refuse_much_sweep(const Sweep& sweep, const SceneAtPoint& scene_at) {
    const std::shared_ptr<const Scene> first = scene_at(0);
    if (!first->source.is_held_to_classroom) return;
    refuse_much_work(work_of_sweep(sweep, scene_at), first->source);
}

void refuse_much_work(const Work& work, const SceneSource& source) {
    if (!source.is_held_to_classroom) return;
    Diagnostic error;
    error.span.file = source.path;
    std::vector<Diagnostic> errors;
    const auto refuse = [&](const std::string& message, const Limit& limit,
                            const std::string& reduce) {
        error.message = message;
        error.hint = fmt::format("{}; reduce {}", to_text(limit), reduce);
        errors.push_back(error);
    };
    if (work.seconds() > most_classroom_work.value) {
        const WorkPart& most = work.largest();
        if (!most.place.span.file.empty()) error = most.place;
        refuse(fmt::format("this takes about {} seconds of CPU time, {} of them for {}",
                           about(work.seconds()), about(most.seconds), most.what),
               most_classroom_work, most.reduce);
        error = {};
        error.span.file = source.path;
    }
    if (1e-6 * work.memory > most_classroom_memory.value)
        refuse(fmt::format("this takes up to {} MB of memory", about(1e-6 * work.memory)),
               most_classroom_memory, work.reduces_memory);
    if (1e-6 * work.bytes > most_classroom_bytes.value)
        refuse(fmt::format("this writes about {} MB", about(1e-6 * work.bytes)),
               most_classroom_bytes, work.reduces_bytes);
    if (!errors.empty()) throw SceneError(std::move(errors));
}

}  // namespace carom
