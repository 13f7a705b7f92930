#include "runs/run_progress.h"

#include <fmt/format.h>

#include <utility>

namespace carom {

TrialCallback shown_trials(const Scene& scene, Progress& progress) {
    return [&progress, run = scene.run, trying = 0](int bits, double time) mutable {
        if (bits != std::exchange(trying, bits))
            progress.begin(
                bits == bits_of_double ? "trying doubles" : fmt::format("trying {} bits", bits),
                run.equilibrate + run.until, "time units");
        progress.reach(run.equilibrate + time);
    };
}

TrialCallback shown_start(const Scene& asked, Progress& progress) {
    if (!asked.run.bits) return shown_trials(asked, progress);
    const double all = asked.run.equilibrate;
    if (all > 0.0) progress.begin("equilibrating", all, "time units");
    return [&progress, all](int, double time) { progress.reach(all + time); };
}

RunCallbacks shown_run(const Scene& asked, Progress& progress) {
    return {
        .start = shown_start(asked, progress),
        .started = [&progress,
                    until = asked.run.until] { progress.begin("simulating", until, "time units"); },
        .reached = [&progress](double now) { progress.reach(now); }};
}

StartedScene start_scene(const Scene& asked, Progress& progress) {
    return start_scene(asked, shown_start(asked, progress));
}

}  // namespace carom
