#include "physics/reversal/mirrored_events.h"

#include "physics/surfaces/mirrored_schedule.h"
#include "util/overloaded.h"

namespace carom {
namespace {

struct EventOnWay {
    std::size_t event;
    bool is_undone;
};

void invert(EventOnWay& its) { its.is_undone = !its.is_undone; }

}  // namespace

std::optional<RunEvent> opposite_of(const RunEvent& event) {
    using Opposite = std::optional<RunEvent>;
    const auto with = [&](const RunAction& action) {
        return Opposite({event.at, action, event.is_mirrored});
    };
    return std::visit(
        Overloaded{[](const ReverseVelocities&) { return Opposite(); },
                   [](const Perturbation&) { return Opposite(); },
                   [&](const SetOpen& its) {
                       return with(SetOpen{its.surface, !its.is_open});
                   },
                   [](const MoveSurface&) { return Opposite(); },
                   [&](const HoldPiston& its) { return with(ReleasePiston{its.surface}); },
                   [&](const ReleasePiston& its) { return with(HoldPiston{its.surface}); },
                   [](const ChangeSurface&) { return Opposite(); },
                   [&](const Heat& its) {
                       const double* energy = std::get_if<double>(&its.amount);
                       return energy != nullptr ? with(Heat{its.species, -*energy}) : Opposite();
                   }},
        event.action);
}

std::vector<MirroredEvent> mirrored_events(const Run& run) {
    MirroredSchedule<double, EventOnWay> schedule;
    std::vector<MirroredEvent> mirrored;
    const auto go_to = [&](double time) {
        while (schedule.next_time() <= time) {
            const auto entry = schedule.take_next();
            mirrored.push_back({entry.time, entry.what.event, entry.what.is_undone});
            schedule.add_behind(entry);
        }
    };
    for (std::size_t k = 0; k < run.events.size(); ++k) {
        const RunEvent& event = run.events[k];
        go_to(event.at);
        if (reverses(event))
            schedule.reverse(event.at);
        else if (event.is_mirrored && acts_on_box(event))
            schedule.add_behind({event.at, {k, false}});
    }
    go_to(run.until);
    return mirrored;
}

}  // namespace carom
