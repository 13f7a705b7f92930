// The history of changes made by events of a run, so that a reversed run can undo them, and the
// times at which driven walls stop by themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "physics/collision/pair_collision.h"
#include "physics/surfaces/mirrored_schedule.h"
#include "physics/surfaces/surface_set.h"

namespace carom {

/// Velocities, relative to `mean`, are multiplied by `factor`; of one species or of all particles.
template <typename Scalar, std::size_t Axes>
struct Scaling {
    std::optional<std::int32_t> species;
    Scalar factor;
    std::array<Scalar, Axes> mean;

    template <class Archive>
    void archive(Archive& archive) {
        archive(species, factor, mean);
    }
};

/// A surface is changed from one control to another. Only one part of the control is changed,
/// because other events may have changed the other parts since the change was recorded.
template <typename Scalar>
struct SurfaceChange {
    enum class Part {
        opening,
        motion,  ///< the behaviour, whether it is held, and the velocity
        end      ///< a driven surface stops by itself: the velocity
    };
    std::int32_t surface;
    Part part;
    SurfaceControl<Scalar> before, after;
    bool is_pending = false;  ///< an end that has yet to come and becomes void if the motion is
                              ///< changed

    template <class Archive>
    void archive(Archive& archive) {
        archive(surface, part, before, after, is_pending);
    }

    SurfaceControl<Scalar> applied_to(SurfaceControl<Scalar> control) const {
        if (part == Part::opening) {
            control.is_open = after.is_open;
            return control;
        }
        control.velocity = after.velocity;
        if (part == Part::motion) {
            control.behaviour = after.behaviour;
            control.is_held = after.is_held;
        }
        return control;
    }
};

template <typename Scalar, std::size_t Axes>
using ChangeAction = std::variant<SurfaceChange<Scalar>, Scaling<Scalar, Axes>>;

template <typename Scalar, std::size_t Axes>
void invert(std::variant<SurfaceChange<Scalar>, Scaling<Scalar, Axes>>& action) {
    if (auto* change = std::get_if<SurfaceChange<Scalar>>(&action)) {
        std::swap(change->before, change->after);
        for (auto* control : {&change->before, &change->after})
            control->velocity = -control->velocity;
    } else {
        auto& scaling = std::get<Scaling<Scalar, Axes>>(action);
        scaling.factor = 1.0 / scaling.factor;
        for (Scalar& v : scaling.mean) v = -v;
    }
}

/// Times in the history are local.
template <typename Scalar, std::size_t Axes>
using ChangeHistory = MirroredSchedule<Scalar, ChangeAction<Scalar, Axes>>;

template <typename Scalar, std::size_t Axes>
using Change = typename ChangeHistory<Scalar, Axes>::Entry;

}  // namespace carom
