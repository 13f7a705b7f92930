// The surfaces of a box during a run: their present behaviour, the positions of those that move,
// and the times at which two of them meet. For doubles and for multiprecision. Independent of
// particles.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/surface.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/mover.h"

namespace carom {

/// The part of the state of a surface that events can change, at one time.
template <typename Scalar>
struct SurfaceControl {
    Behaviour behaviour = Reflecting{};
    bool is_open = false;
    bool is_held = false;   ///< a piston that stands still
    Scalar velocity = 0.0;  ///< along its normal

    template <class Archive>
    void archive(Archive& archive) {
        archive(behaviour, is_open, is_held, velocity);
    }
};

/// `Dimension` is that of Barrier.
template <typename Scalar, int Dimension>
class MovingSurfaces {
  public:
    static constexpr std::size_t axes = Dimension;
    using Vector = std::array<Scalar, axes>;
    using Lengths = std::array<double, axes>;
    using Barrier = carom::Barrier<Dimension>;

    /// Barriers have images outside a periodic box up to a distance of `reach`. A mover is
    /// registered again whenever it has moved by `registered` along its axis.
    MovingSurfaces(const Box& box, double reach, const Lengths& registered);

    /// All barriers, including those of open partitions, numbered from 0; the numbering does not
    /// change during a run.
    const std::vector<Barrier>& barriers() const { return barriers_; }
    const Barrier& barrier(std::int32_t k) const { return barriers_[static_cast<std::size_t>(k)]; }

    /// Whether the barrier is present (its partition is not open), and whether it may move.
    bool is_there(const Barrier& barrier) const;
    bool is_mobile(const Barrier& barrier) const { return mover_of(barrier) != nullptr; }
    /// Whether collisions change the motion of its surface.
    bool can_be_pushed(const Barrier& barrier) const {
        const auto* mover = mover_of(barrier);
        return mover != nullptr && mover->inverse_mass > 0.0;
    }
    /// Whether collisions change the motion of any surface.
    bool has_pistons() const {
        return std::ranges::any_of(movers_, [](const auto& m) { return m.inverse_mass > 0.0; });
    }
    /// Whether particles leave it in random directions.
    bool is_random(const Barrier& barrier) const {
        return carom::is_random(behaviours_[static_cast<std::size_t>(barrier.surface)]);
    }
    /// The axis along which its surface can move.
    std::size_t axis_of(const Barrier& barrier) const {
        return movers_[static_cast<std::size_t>(barrier.surface)].axis;
    }
    /// Whether it lets all particles of this species pass.
    bool lets_pass(const Barrier& barrier, std::int32_t species) const;
    /// Number of changes of its motion, in the form stored in predictions.
    std::uint32_t changes_of(const Barrier& barrier) const;

    Vector velocity_of(const Barrier& barrier, const Scalar& now) const;

    /// Movers are the sides and partitions, with the same numbers as surfaces; obstacles cannot
    /// move.
    std::size_t mover_count() const { return movers_.size(); }
    const Mover<Scalar>& mover(std::size_t k) const { return movers_[k]; }

    /// The time at which a mover reaches another surface or must be registered again.
    Scalar mover_event(std::size_t k) const;
    /// Processes that event; returns the other mover whose motion it changed, if any. Throws
    /// SurfaceError if a driven surface reaches another one that does not yield.
    std::optional<std::size_t> process_mover(std::size_t k, const Scalar& now);

    /// The control of a surface, and a function that sets it from `now` on.
    SurfaceControl<Scalar> control(std::int32_t surface, const Scalar& now) const;
    void set_control(std::int32_t surface, const SurfaceControl<Scalar>& control,
                     const Scalar& now);

    /// Sets the velocity of a piston that contacts have pushed.
    void push(std::size_t mover, const Scalar& velocity, const Scalar& now) {
        movers_[mover].advance(now);
        movers_[mover].velocity = velocity;
        ++movers_[mover].changes;
    }

    /// Registers all movers at the present.
    void register_all(const Scalar& now);

    /// Operations on all movers: advance them to a time, shift the time origin by `shift`, reverse
    /// their motion.
    void advance(const Scalar& now);
    void shift_epoch(const Scalar& shift);
    void reverse();

    template <class Archive>
    void archive(Archive& archive) {
        archive(behaviours_, is_open_, is_held_, movers_, driven_work_, most_work_);
    }

  protected:
    static auto& at(auto& things, std::integral auto i) {
        return things[static_cast<std::size_t>(i)];
    }
    const Mover<Scalar>* mover_of(const Barrier& barrier) const;
    Vector place_of(const Barrier& barrier, const Scalar& now) const;

    Box box_;
    double slack_;                       ///< distances up to this are attributed to round-off
    std::vector<Behaviour> behaviours_;  ///< behaviour of each surface
    std::vector<bool> is_open_, is_held_;
    std::vector<Barrier> barriers_;
    std::vector<Mover<Scalar>> movers_;
    double driven_work_ = 0.0;  ///< work of driven surfaces on particles and pistons, and of events
                                ///< on pistons
    double most_work_ = never<double>;  ///< largest work that is possible without crushing the gas
                                        ///< or a piston

  private:
    double energy_of_piston(std::size_t mover) const;
    void set_motion(std::size_t mover, const Scalar& velocity);
    void register_mover(Mover<Scalar>& mover) const;
    Scalar next_obstacle(const Mover<Scalar>& mover, std::int32_t& other) const;
    static void move_exactly_to(Mover<Scalar>& mover, const Scalar& place);
    void bounce_off(Mover<Scalar>& mover, std::int32_t other, const Scalar& now);

    Lengths registered_;
};

extern template class MovingSurfaces<double, 2>;
extern template class MovingSurfaces<double, 3>;
extern template class MovingSurfaces<Real, 2>;
extern template class MovingSurfaces<Real, 3>;

}  // namespace carom
