#include "app/simulate.h"

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

StartedScene start_scene(const Scene& asked, Progress& progress) {
    if (!asked.run.bits) return start_scene(asked, shown_trials(asked, progress));
    const double all = asked.run.equilibrate;
    if (all > 0.0) progress.begin("equilibrating", all, "time units");
    return start_scene(asked, [&](int, double time) { progress.reach(all + time); });
}

}  // namespace carom
