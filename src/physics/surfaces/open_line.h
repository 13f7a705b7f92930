// The line of line.h with active ends and gravity along it: which beads touch, which ends they
// reach, and when. For doubles and for multiprecision. Independent of the event queue and the
// clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "physics/collision/loop_types.h"
#include "physics/line/line.h"
#include "physics/surfaces/open_space.h"

namespace carom {

/// Its beads are disks of which only the first coordinate is used.
template <typename Scalar>
class OpenLine : public Line<Scalar, FallingBody<Scalar, 2>> {
  public:
    using Base = Line<Scalar, FallingBody<Scalar, 2>>;
    using Body = FallingBody<Scalar, 2>;
    using Bodies = LargeVector<Body>;

    OpenLine(const Box& box, const Particles& particles, const Arithmetic& arithmetic = {});

    static Bodies bodies_of(const Particles& particles) {
        return falling_bodies_of<Scalar, 2>(particles);
    }

    SurfaceSet<Scalar, 2>& surfaces() { return surfaces_; }
    const SurfaceSet<Scalar, 2>& surfaces() const { return surfaces_; }

    // As the functions of Line and OpenSpace.
    bool fits_grid(const Scalar&) const { return true; }
    void enter(Bodies& bodies);
    void resettle(Bodies& bodies);
    Scalar predict(Bodies& bodies, std::int32_t i, const Scalar& now);
    Scalar predict_after_crossing(Bodies& bodies, std::int32_t i, int, const Scalar& now) {
        return predict(bodies, i, now);
    }
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<1>& contact);
    void look_for_hits(Bodies& bodies, std::size_t mover, const Scalar& now,
                       const Agenda<Scalar>& agenda) const;

    /// Calls see(k) for the barriers that body i may touch.
    template <typename See>
    void for_each_barrier(const Bodies&, std::int32_t i, const See& see) const {
        for (std::size_t k = 0; k < surfaces_.barriers().size(); ++k)
            if (i == (surfaces_.barriers()[k].surface == 0 ? 0 : this->last()))
                see(static_cast<std::int32_t>(k));
    }

    template <class Archive>
    void archive(Archive& archive) {
        Base::archive(archive);
        archive(surfaces_);
    }

  private:
    SurfaceSet<Scalar, 2> surfaces_;
};

extern template class OpenLine<double>;
extern template class OpenLine<Real>;

}  // namespace carom
