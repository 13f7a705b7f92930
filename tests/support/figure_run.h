// The figures of a scene without their files.
#pragma once

#include "figures/figure_run.h"

namespace carom::test {

inline FigureRun run_of(const Scene& scene, int threads = 1) {
    return {scene,
            [](const Scene& one, const TimeCallback& on_progress) {
                return Simulation(one.gas, one.run, on_progress);
            },
            threads};
}

}  // namespace carom::test
