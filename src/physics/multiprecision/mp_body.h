// The state of a multiprecision disk or sphere in the event loop, together with its values rounded
// to doubles.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "physics/cells/cell_grid.h"
#include "physics/collision/loop_types.h"
#include "physics/multiprecision/multiprecision.h"

namespace carom {

template <int Dimension>
struct alignas(64) MpBody {
    static constexpr std::size_t axes = static_cast<std::size_t>(Dimension);
    /// The values rounded to doubles, in one cache line in the plane: most pairs are tested with
    /// these only.
    struct Shadow {
        std::array<double, axes> x{}, v{};
        double time = 0.0;
        double radius = 0.0;
        double distance = 0.0;  ///< |x| + |y| + ... and
        double speed = 0.0;     ///< |vx| + |vy| + ...: scales for error bounds

        template <class Archive>
        void archive(Archive& archive) {
            archive(x, v, time, radius, distance, speed);
        }
    };
    Shadow shadow;
    double radius = 0.0;
    double inverse_mass = 0.0;
    Prediction prediction;    ///< a contact only if it is the next event
    double event_late = 0.0;  ///< upper bound of event_time, a double
    std::uint32_t collisions = 0;
    CellOf<Dimension> cell{};
    Real event_time;           ///< exact time of the next event
    std::array<Real, axes> x;  ///< at the body's own time; may lie a little outside a periodic box
    std::array<Real, axes> v;
    Real time;

    template <class Archive>
    void archive(Archive& archive) {
        archive(shadow, radius, inverse_mass, prediction, event_late, collisions, cell, event_time,
                x, v, time);
    }
};
static_assert(sizeof(MpBody<2>::Shadow) == 64);

template <int Dimension>
inline void advance_body(MpBody<Dimension>& d, const Real& now) {
    const Real age = now - d.time;
    Real way = age;
    for (std::size_t a = 0; a < d.x.size(); ++a) {
        way.set_product(d.v[a], age);
        d.x[a].set_sum(d.x[a], way);
    }
    d.time = now;
}

template <int Dimension>
inline void body_has_changed(MpBody<Dimension>& d) {
    auto& s = d.shadow;
    s.distance = s.speed = 0.0;
    for (std::size_t a = 0; a < d.x.size(); ++a) {
        s.x[a] = static_cast<double>(d.x[a]);
        s.v[a] = static_cast<double>(d.v[a]);
        s.distance += std::abs(s.x[a]);
        s.speed += std::abs(s.v[a]);
    }
    s.time = static_cast<double>(d.time);
    s.radius = d.radius;
}

}  // namespace carom
