// What events have changed in a run, so that a reversed run changes it back: the changes behind the
// present and those ahead of it, which are known because the run comes back to them or because a
// driven wall stops by itself. Reversing the run exchanges the two.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "physics/collision/pair_collision.h"
#include "physics/surfaces/surface_set.h"

namespace carom {

/// Velocities are multiplied by `factor` about `mean`; of one species, or of all particles.
template <typename Scalar>
struct Scaling {
    std::optional<std::int32_t> species;
    Scalar factor;
    std::array<Scalar, 2> mean;
};

/// A surface is changed from one control to another.
template <typename Scalar>
struct SurfaceChange {
    std::int32_t surface;
    SurfaceControl<Scalar> before, after;
};

template <typename Scalar>
struct Change {
    Scalar time;  ///< local
    std::variant<SurfaceChange<Scalar>, Scaling<Scalar>> what;
};

template <typename Scalar>
class ChangeHistory {
  public:
    void add_ahead(Change<Scalar> change) {
        const auto later = [&](const auto& one) { return one.time > change.time; };
        ahead_.insert(std::ranges::find_if(ahead_, later), std::move(change));
    }
    void add_behind(Change<Scalar> change) { behind_.push_back(std::move(change)); }

    /// When the next change is due, `never` if there is none.
    Scalar next_time() const { return ahead_.empty() ? Scalar(never<double>) : ahead_[0].time; }

    /// Takes the next change, which is behind the run from now on.
    Change<Scalar> take_next() {
        Change<Scalar> change = std::move(ahead_.front());
        ahead_.erase(ahead_.begin());
        behind_.push_back(change);
        return change;
    }

    void shift_epoch(const Scalar& shift) {
        for (auto* changes : {&ahead_, &behind_})
            for (auto& change : *changes) change.time -= shift;
    }

    /// The run goes back at `now`: what was behind it comes again, the other way round.
    void reverse(const Scalar& now) {
        ahead_.swap(behind_);
        for (auto* changes : {&ahead_, &behind_}) {
            std::ranges::reverse(*changes);
            for (auto& change : *changes) {
                change.time = now + (now - change.time);
                std::visit([](auto& what) { invert(what); }, change.what);
            }
        }
    }

  private:
    static void invert(SurfaceChange<Scalar>& change) {
        std::swap(change.before, change.after);
        for (auto* control : {&change.before, &change.after})
            control->velocity = -control->velocity;
    }
    static void invert(Scaling<Scalar>& scaling) {
        scaling.factor = 1.0 / scaling.factor;
        for (Scalar& v : scaling.mean) v = -v;
    }

    std::vector<Change<Scalar>> ahead_, behind_;
};

}  // namespace carom
