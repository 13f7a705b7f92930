#include "physics/cells/plain_space.h"

#include "physics/cells/axis_lanes.h"

namespace carom {
template class PairSearch<BodyState<2>>;
template class PairSearch<BodyState<3>>;

template <int Dimension>
PlainSpace<Dimension>::PlainSpace(const Box& box, const Particles& particles, const Arithmetic&)
    : Base(box, particles, {}) {
    for (std::size_t a = 0; a < axes; ++a) {
        const double size = box.length(a);
        const bool periodic = box.is_periodic(a);
        cell_size_[a] = grid_.cell_size()[a];
        overhang_[a] = grid_.overhang()[a];
        last_cell_[a] = grid_.last_cell()[a];
        box_size_[a] = size;
        solid_[a] = periodic ? 0 : -1;
        has_walls_ |= !periodic;
    }
}

template <int Dimension>
auto PlainSpace<Dimension>::bodies_of(const Particles& particles) -> Bodies {
    return Bodies(static_cast<std::size_t>(particles.count()));
}

template <int Dimension>
bool PlainSpace<Dimension>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                    Contact<Dimension>& contact) const {
    return Base::collide(bodies, i, j, {properties_[i].inverse_mass, properties_[j].inverse_mass},
                         contact);
}

// The contact, or the first of the borders ahead on each axis: of the cell with its overhang, or of
// the box. A large body reaches the wall while it is still several cells away.
template <int Dimension>
[[gnu::always_inline]] inline double PlainSpace<Dimension>::next_event(
    Body& b, double radius, double now, const FirstContact& contact) {
    const Lanes zero{}, none = zero + never<double>, one = zero + 1.0;
    const Lanes v = lanes_of(b.v), x = lanes_of(b.x), cell = lanes_of(b.cell);
    const Masks up = v > 0.0;
    Lanes border = cell_size_ * (cell + select(up, one, zero)) + select(up, overhang_, -overhang_);
    Masks kind;
    set_lower_sides(kind);
    kind = kind + first_cell_side - up;
    if (has_walls_) {
        const Lanes wall = select(up, box_size_ - radius, zero + radius);
        const Lanes last = select(up, last_cell_, zero);
        // both the other way round for those that go down, so that one comparison is enough
        const Lanes before = select(up, wall, border), behind = select(up, border, wall);
        const Masks at_wall = solid_ & ((cell == last) | (before <= behind));
        border = select(at_wall, wall, border);
        kind -= at_wall & first_cell_side;
    }
    const Lanes ahead = (border - (x + v * (now - b.time))) / v;
    Lanes border_time = now + select(v == 0.0, none, select(ahead > 0.0, ahead, zero));
    take_first(border_time, kind);
    const Lanes contact_time = zero + contact.time;
    if (coincidences_.may_coincide(contact.time, border_time[0])) [[unlikely]]
        coincidences_.note(contact.time);
    b.prediction = {.contact_time = contact.time,
                    .partner = contact.partner(),
                    .partner_collisions = contact.collisions() & most_collisions,
                    .border = static_cast<std::uint32_t>(kind[0]) & most_border};
    return select(contact_time < border_time, contact_time, border_time)[0];
}

template <int Dimension>
double PlainSpace<Dimension>::predict(Bodies& bodies, std::int32_t i, double now) {
    return next_event(at(bodies, i), properties_[i].radius, now,
                      this->first_contact(bodies, i, now));
}

template <int Dimension>
bool PlainSpace<Dimension>::predict_both(Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                                         std::array<double, 2>& when) {
    std::array<FirstContact, 2> contacts;
    if (!this->first_contacts(bodies, i, j, now, contacts)) return false;
    when = {next_event(at(bodies, i), properties_[i].radius, now, contacts[0]),
            next_event(at(bodies, j), properties_[j].radius, now, contacts[1])};
    return true;
}

template <int Dimension>
double PlainSpace<Dimension>::predict_after_crossing(Bodies& bodies, std::int32_t i, int side,
                                                     double now) {
    return next_event(at(bodies, i), properties_[i].radius, now,
                      this->first_contact_after_crossing(bodies, i, side, now));
}

template class PlainSpace<2>;
template class PlainSpace<3>;

}  // namespace carom
