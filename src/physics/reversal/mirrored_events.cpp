#include "physics/reversal/mirrored_events.h"

#include "physics/surfaces/mirrored_schedule.h"

namespace carom {
namespace {

struct EventOnWay {
    std::size_t event;
    bool is_undone;
};

void invert(EventOnWay& its) { its.is_undone = !its.is_undone; }

}  // namespace

std::optional<RunEvent> opposite_of(const RunEvent& event) {
    RunEvent opposite = event;
    if (auto* set = std::get_if<SetOpen>(&opposite.action))
        set->is_open = !set->is_open;
    else if (const auto* hold = std::get_if<HoldPiston>(&event.action))
        opposite.action = ReleasePiston{hold->surface};
    else if (const auto* release = std::get_if<ReleasePiston>(&event.action))
        opposite.action = HoldPiston{release->surface};
    else if (auto* heat = std::get_if<Heat>(&opposite.action);
             heat != nullptr && std::holds_alternative<double>(heat->amount))
        heat->amount = -std::get<double>(heat->amount);
    else
        return {};
    return opposite;
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
        const auto& [at, action, is_mirrored] = run.events[k];
        go_to(at);
        if (std::holds_alternative<ReverseVelocities>(action))
            schedule.reverse(at);
        else if (is_mirrored && !std::holds_alternative<Perturbation>(action))
            schedule.add_behind({at, {k, false}});
    }
    go_to(run.until);
    return mirrored;
}

}  // namespace carom
