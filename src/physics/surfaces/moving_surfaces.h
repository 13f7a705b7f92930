// The surfaces of a box during a run: what each does at present, where those are that move, and
// when two of them meet. For doubles and for many bits. Knows no disks.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/surface.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/mover.h"

namespace carom {

/// What events change of a surface, at one time.
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

template <typename Scalar>
class MovingSurfaces {
  public:
    using Vector = std::array<Scalar, 2>;

    /// Barriers have their images about a periodic box as far as `reach`. A mover is registered
    /// anew whenever it has moved by `registered` along its axis.
    MovingSurfaces(const Box& box, double reach, const std::array<double, 2>& registered);

    /// All barriers, those of open partitions too, numbered from 0; the same in the whole run.
    const std::vector<Barrier>& barriers() const { return barriers_; }
    const Barrier& barrier(std::int32_t k) const { return barriers_[static_cast<std::size_t>(k)]; }

    /// Whether it is in the box at present, and whether it may move.
    bool is_there(const Barrier& barrier) const;
    bool is_mobile(const Barrier& barrier) const { return mover_of(barrier) != nullptr; }
    /// Along which its surface moves, if it does.
    std::size_t axis_of(const Barrier& barrier) const {
        return movers_[static_cast<std::size_t>(barrier.surface)].axis;
    }
    /// Whether it lets all disks of a species through.
    bool lets_pass(const Barrier& barrier, std::int32_t species) const;
    /// How often its motion has changed, as predictions count it.
    std::uint32_t changes_of(const Barrier& barrier) const;

    Vector velocity_of(const Barrier& barrier, const Scalar& now) const;

    /// Sides and partitions may move, numbered as surfaces; obstacles may not.
    std::size_t mover_count() const { return movers_.size(); }
    const Mover<Scalar>& mover(std::size_t k) const { return movers_[k]; }

    /// When a mover reaches another surface, or must be registered anew.
    Scalar mover_event(std::size_t k) const;
    /// Carries that out; returns the other mover that it changed, if any. Throws SurfaceError where
    /// a driven surface reaches another.
    std::optional<std::size_t> process_mover(std::size_t k, const Scalar& now);

    /// What events have set, and sets it from a time on.
    SurfaceControl<Scalar> control(std::int32_t surface, const Scalar& now) const;
    void set_control(std::int32_t surface, const SurfaceControl<Scalar>& control,
                     const Scalar& now);

    /// Registers all movers at the present.
    void register_all(const Scalar& now);

    /// Moves all on to a time; counts all times from `shift` later on; reverses all motion.
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
    double least_radius_;                ///< that surfaces see, so that points have a side of them
    std::vector<Behaviour> behaviours_;  ///< of each surface
    std::vector<bool> is_open_, is_held_;
    std::vector<Barrier> barriers_;
    std::vector<Mover<Scalar>> movers_;
    double driven_work_ = 0.0;          ///< of driven surfaces, and of events on pistons
    double most_work_ = never<double>;  ///< that is not done by crushing

  private:
    double energy_of_piston(std::size_t mover) const;
    void set_motion(std::size_t mover, const Scalar& velocity);
    void register_mover(Mover<Scalar>& mover) const;
    Scalar next_obstacle(const Mover<Scalar>& mover, std::int32_t& other) const;
    static void move_exactly_to(Mover<Scalar>& mover, const Scalar& place);
    void bounce_off(Mover<Scalar>& mover, std::int32_t other, const Scalar& now);

    std::array<double, 2> registered_;
};

extern template class MovingSurfaces<double>;
extern template class MovingSurfaces<Real>;

}  // namespace carom
