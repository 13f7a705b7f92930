// Applies an event of the run to a surface: determines the control that the surface has from then
// on.
#pragma once

#include <stdexcept>
#include <type_traits>
#include <variant>

#include "physics/run.h"
#include "physics/surfaces/surface_set.h"

namespace carom {

using SurfaceAction = std::variant<SetOpen, MoveSurface, HoldPiston, ReleasePiston, ChangeSurface>;

inline std::int32_t surface_of(const SurfaceAction& action) {
    return std::visit([](const auto& its) { return its.surface; }, action);
}

/// Throws std::logic_error if this event does not change a surface.
inline SurfaceAction surface_action(const decltype(RunEvent::action)& action) {
    return std::visit(
        [](const auto& its) -> SurfaceAction {
            if constexpr (std::is_constructible_v<SurfaceAction, decltype(its)>)
                return its;
            else
                throw std::logic_error("this event does not change a surface");
        },
        action);
}

/// The control of a surface after an event at the simulated time `time`.
template <typename Scalar>
SurfaceControl<Scalar> control_after(SurfaceControl<Scalar> control, const SurfaceAction& action,
                                     double time) {
    if (const auto* its = std::get_if<SetOpen>(&action)) {
        control.is_open = its->is_open;
    } else if (const auto* moved = std::get_if<MoveSurface>(&action)) {
        control.behaviour = Driven{.velocity = moved->velocity};
        control.velocity = moved->velocity;
    } else if (const auto* changed = std::get_if<ChangeSurface>(&action)) {
        control = {.behaviour = changed->behaviour, .is_open = control.is_open};
        if (const auto* driven = std::get_if<Driven>(&changed->behaviour))
            control.velocity = driven->velocity_at(time);
        if (const auto* piston = std::get_if<Piston>(&changed->behaviour))
            control.velocity = piston->velocity;
    } else {
        control.is_held = std::holds_alternative<HoldPiston>(action);
        control.velocity = 0.0;
    }
    return control;
}

}  // namespace carom
