// Applies an event of the run to a surface: determines the control that the surface has from then
// on.
#pragma once

#include <variant>

#include "physics/run.h"
#include "physics/surfaces/surface_set.h"
#include "util/overloaded.h"

namespace carom {

using SurfaceAction = std::variant<SetOpen, MoveSurface, HoldPiston, ReleasePiston, ChangeSurface>;

inline std::int32_t surface_of(const SurfaceAction& action) {
    return std::visit([](const auto& its) { return its.surface; }, action);
}

/// Whether it opens or closes the surface; all others change how it acts or moves.
inline bool sets_opening(const SurfaceAction& action) {
    return std::visit(
        Overloaded{[](const SetOpen&) { return true; }, [](const MoveSurface&) { return false; },
                   [](const HoldPiston&) { return false; },
                   [](const ReleasePiston&) { return false; },
                   [](const ChangeSurface&) { return false; }},
        action);
}

/// The control of a surface after an event at the simulated time `time`.
template <typename Scalar>
SurfaceControl<Scalar> control_after(SurfaceControl<Scalar> control, const SurfaceAction& action,
                                     double time) {
    const auto hold = [&](bool is_held) {
        control.is_held = is_held;
        control.velocity = 0.0;
    };
    std::visit(Overloaded{[&](const SetOpen& opening) { control.is_open = opening.is_open; },
                          [&](const MoveSurface& motion) {
                              control.behaviour = Driven{.velocity = motion.velocity};
                              control.velocity = motion.velocity;
                          },
                          [&](const HoldPiston&) { hold(true); },
                          [&](const ReleasePiston&) { hold(false); },
                          [&](const ChangeSurface& change) {
                              control = {.behaviour = change.behaviour,
                                         .is_open = control.is_open,
                                         .velocity = velocity_from(change.behaviour, time)};
                          }},
               action);
    return control;
}

}  // namespace carom
