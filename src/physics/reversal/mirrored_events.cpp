#include "physics/reversal/mirrored_events.h"

#include <algorithm>

namespace carom {

std::vector<MirroredEvent> mirrored_events(const Run& run) {
    std::vector<MirroredEvent> behind, ahead, mirrored;  // `ahead` with the next one last
    const auto go_to = [&](double time) {
        for (; !ahead.empty() && ahead.back().at <= time; ahead.pop_back()) {
            behind.push_back(ahead.back());
            mirrored.push_back(ahead.back());
        }
    };
    for (std::size_t k = 0; k < run.events.size(); ++k) {
        const auto& [at, action, is_mirrored] = run.events[k];
        go_to(at);
        if (std::holds_alternative<ReverseVelocities>(action)) {
            // The latest behind comes next, and what was ahead is the latest behind.
            ahead.swap(behind);
            for (auto* events : {&ahead, &behind})
                for (MirroredEvent& one : *events) {
                    one.at = 2.0 * at - one.at;
                    one.is_undone = !one.is_undone;
                }
        } else if (is_mirrored && !std::holds_alternative<Perturbation>(action)) {
            behind.push_back({at, k, false});
        }
    }
    go_to(run.until);
    return mirrored;
}

}  // namespace carom
