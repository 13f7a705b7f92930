#include "physics/surfaces/open_line.h"

#include <array>
#include <utility>

namespace carom {

template <typename Scalar>
OpenLine<Scalar>::OpenLine(const Box& box, const Particles& particles, const Arithmetic& arithmetic)
    : Base(box, particles, arithmetic),
      surfaces_(box, 0.0, {never<double>, never<double>}, arithmetic.bits) {}

template <typename Scalar>
void OpenLine<Scalar>::enter(Bodies& bodies) {
    Base::enter(bodies);
    resettle(bodies);
}

template <typename Scalar>
void OpenLine<Scalar>::resettle(Bodies& bodies) {
    for (Body& body : bodies) surfaces_.settle_at_rest(body);
    if (!bodies.empty()) surfaces_.enter(bodies, bodies[0].time);
}

// Only the bead next to a wall can reach it.
template <typename Scalar>
Scalar OpenLine<Scalar>::predict(Bodies& bodies, std::int32_t i, const Scalar& now) {
    Event<Scalar> first;
    this->predict_neighbours(bodies, i, now, first);
    Body& body = bodies[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < surfaces_.barriers().size(); ++k) {
        const auto& end = surfaces_.barriers()[k];
        if (i != (end.surface == 0 ? 0 : this->last())) continue;
        const Scalar time = now + surfaces_.time_to(body, static_cast<std::int32_t>(k), now);
        first.notice(time);
        if (!(time < first.time)) continue;
        first.time = time;
        first.contact_time = rounded_down(time);
        first.partner = -1 - static_cast<std::int32_t>(k);
        first.partner_collisions = surfaces_.changes_of(end) & most_collisions;
    }
    if (this->is_periodic()) this->predict_end(bodies, i, now, first);
    return this->take(first, body);
}

template <typename Scalar>
bool OpenLine<Scalar>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                               Contact<1>& contact) {
    if (!Base::collide(bodies, i, j, contact)) return false;
    for (const std::int32_t k : {i, j})
        surfaces_.path_has_changed(bodies[static_cast<std::size_t>(k)]);
    return true;
}

template <typename Scalar>
void OpenLine<Scalar>::look_for_hits(Bodies& bodies, std::size_t k, const Scalar& now,
                                     const Agenda<Scalar>& agenda) const {
    for (std::size_t b = 0; b < surfaces_.barriers().size() && !bodies.empty(); ++b) {
        if (surfaces_.barriers()[b].surface != static_cast<std::int32_t>(k)) continue;
        const std::int32_t i = k == 0 ? 0 : this->last();
        Body& body = bodies[static_cast<std::size_t>(i)];
        const Scalar time = now + surfaces_.time_to(body, static_cast<std::int32_t>(b), now);
        if (!agenda.move_forward(i, time)) continue;
        body.prediction.contact_time = rounded_down(time);
        body.prediction.partner = -1 - static_cast<std::int32_t>(b);
        body.prediction.partner_collisions = surfaces_.mover(k).changes & most_collisions;
    }
}

template class OpenLine<double>;
template class OpenLine<Real>;

}  // namespace carom
