#include "physics/plane/plane.h"

#include "physics/collision/contact_rule.h"
#include "util/threads/processors.h"

namespace carom {

template class PairSearch<DiskState>;

Plane::Plane(const Box& box, const Particles& particles, const Arithmetic&)
    : PairSearch(box, particles, {}) {
    cell_size_ = load_two(grid_.cell_size().data());
    overhang_ = load_two(grid_.overhang().data());
    for (std::size_t a = 0; a < 2; ++a) {
        const double size = box.length(a);
        const bool periodic = box.is_periodic(a);
        last_cell_[a] = grid_.last_cell()[a];
        box_size_[a] = size;
        solid_[a] = periodic ? 0 : -1;
        has_walls_ |= !periodic;
    }
}

Plane::Bodies Plane::bodies_of(const Particles& particles) {
    return Bodies(static_cast<std::size_t>(particles.count()));
}

CAROM_FOR_PROCESSORS_WITH_FMA
bool Plane::collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const {
    Body &a = at(bodies, i), &b = at(bodies, j);
    const Properties &first = properties_[i], &second = properties_[j];
    const double sigma = first.radius + second.radius;
    RelativeMotion<double> m{0.0, 0.0, b.v[0] - a.v[0], b.v[1] - a.v[1]};
    if (!separation_at_contact(a, b, sigma, m.x, m.y)) return false;
    static_assert(ContactRule::keeps_species);
    const Unrounded<double> factor =
        ContactRule::impulse(m, first.inverse_mass, second.inverse_mass);
    const TwoLanes r{m.x, m.y};
    store_two(load_two(a.v.data()) + product_of(first.inverse_mass, factor) * r, a.v.data());
    store_two(load_two(b.v.data()) - product_of(second.inverse_mass, factor) * r, b.v.data());
    contact = contact_of(m, factor.value, sigma);
    return true;
}

// The contact, or the first of the borders ahead on each axis: of the cell with its overhang, or of
// the box. A large disk reaches the wall while it is still several cells away.
[[gnu::always_inline]] inline double Plane::next_event(Body& d, double radius, double now,
                                                       const FirstContact& contact) {
    const TwoLanes none = both(never<double>), zero{};
    const TwoLanes v = load_two(d.v.data()), x = load_two(d.x.data());
    const TwoLanes cell{static_cast<double>(d.cell[0]), static_cast<double>(d.cell[1])};
    const TwoMasks up = v > 0.0;
    TwoLanes border =
        cell_size_ * (cell + select(up, both(1.0), zero)) + select(up, overhang_, -overhang_);
    TwoMasks kind = TwoMasks{0, 2} + first_cell_side - up;
    if (has_walls_) {
        const TwoLanes wall = select(up, box_size_ - radius, both(radius));
        const TwoLanes last = select(up, last_cell_, zero);
        // both the other way round for those that go down, so that one comparison is enough
        const TwoLanes before = select(up, wall, border), behind = select(up, border, wall);
        const TwoMasks at_wall = solid_ & ((cell == last) | (before <= behind));
        border = select(at_wall, wall, border);
        kind -= at_wall & first_cell_side;
    }
    const TwoLanes ahead = (border - (x + v * (now - d.time))) / v;
    const TwoLanes time = now + select(v == 0.0, none, select(ahead > 0.0, ahead, zero));
    // all in lanes: the processor cannot predict which is first
    const TwoMasks other_first = swapped(time) < time;
    const TwoMasks first_kind = other_first ? swapped(kind) : kind;
    const TwoLanes border_time = select(other_first, swapped(time), time);
    const TwoLanes contact_time = both(contact.time);
    if (coincidences_.may_coincide(contact.time, border_time[0])) [[unlikely]]
        coincidences_.note(contact.time);
    d.prediction = {.contact_time = contact.time,
                    .partner = contact.partner(),
                    .partner_collisions = contact.collisions() & most_collisions,
                    .border = static_cast<std::uint32_t>(first_kind[0]) & most_border};
    return select(contact_time < border_time, contact_time, border_time)[0];
}

CAROM_FOR_PROCESSORS_WITH_FMA
double Plane::predict(Bodies& bodies, std::int32_t i, double now) {
    return next_event(at(bodies, i), properties_[i].radius, now, first_contact(bodies, i, now));
}

CAROM_FOR_PROCESSORS_WITH_FMA
bool Plane::predict_both(Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                         std::array<double, 2>& when) {
    std::array<FirstContact, 2> contacts;
    if (!first_contacts(bodies, i, j, now, contacts)) return false;
    when = {next_event(at(bodies, i), properties_[i].radius, now, contacts[0]),
            next_event(at(bodies, j), properties_[j].radius, now, contacts[1])};
    return true;
}

CAROM_FOR_PROCESSORS_WITH_FMA
double Plane::predict_after_crossing(Bodies& bodies, std::int32_t i, int side, double now) {
    return next_event(at(bodies, i), properties_[i].radius, now,
                      first_contact_after_crossing(bodies, i, side, now));
}

}  // namespace carom
