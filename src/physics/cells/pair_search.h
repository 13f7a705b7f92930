// Finds which disk or sphere one of them touches first: contact_search.h searches those in the
// surrounding cells (cell_grid.h), and the data that a search will need are prefetched. Also
// handles the order of bodies in memory and their moves between cells. Independent of walls, event
// queue and clock.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "physics/cells/body_state.h"
#include "physics/cells/cell_grid.h"
#include "physics/cells/contact_search.h"
#include "physics/cells/images.h"
#include "physics/cells/order_of_cells.h"
#include "physics/collision/coincidences.h"
#include "physics/collision/contact_rule.h"
#include "physics/collision/loop_types.h"

namespace carom {

/// The bodies are BodyStates or derive from them. Only bodies of doubles are searched and sorted in
/// memory.
template <typename BodyType>
class PairSearch {
  public:
    using Body = BodyType;
    using Bodies = LargeVector<Body>;
    static constexpr std::size_t axes = Body::axes;
    static constexpr int dimension = static_cast<int>(axes);
    using Grid = CellGrid<dimension>;
    using Cell = CellOf<dimension>;
    using Point = std::array<double, axes>;
    using Pairing = carom::Pairing<dimension>;

    PairSearch(const Box& box, const Particles& particles, const Point& gravity)
        : box_(box),
          grid_(box, particles.radius),
          properties_(particles),
          nearest_(Pairing::nearest(box)),
          only_(Pairing::shifted({})) {
        if (properties_.alike()) nearest_.sigma = only_.sigma = 2.0 * particles.radius[0];
        nearest_.gravity = only_.gravity = gravity;
        for (std::size_t a = 0; a < axes; ++a)
            surely_nearest_[a] = grid_.narrow()[a]    ? -1.0
                                 : box.is_periodic(a) ? 0.5 * box.length(a)
                                                      : never<double>;
    }

    /// The constant properties of body i.
    const Properties& properties(const Bodies&, std::size_t i) const { return properties_[i]; }

    /// Whether this number of bodies is re-sorted from time to time.
    static bool is_resorted(std::size_t count) {
        return of_doubles && count >= least_in_order_of_cells;
    }

    /// The order in which bodies should be stored: along a Z-order curve through the cells, so that
    /// neighbours in the box are neighbours in memory. A small number of bodies, which fits into
    /// the cache, keeps its order. The properties stored here are sorted accordingly.
    std::vector<std::int32_t> order(const Bodies& bodies) {
        std::vector<std::int32_t> numbers = order_of_cells(grid_, origin_, bodies);
        if (is_resorted(bodies.size())) properties_.renumber(numbers);
        return numbers;
    }

    /// Enters sorted bodies at time 0 into the grid.
    void enter(Bodies& bodies) {
        for (Body& body : bodies) {
            Point x;
            for (std::size_t a = 0; a < axes; ++a)
                x[a] = static_cast<double>(body.x[a]) - origin_[a];
            body.cell = grid_.cell_at(x);
        }
        fill_grid(bodies);
    }

    /// Updates the grid for the same bodies in another order, at any individual times: body k is
    /// the one that had the number before[k].
    void renumber(Bodies& bodies, const std::vector<std::int32_t>& before) {
        renumber_partners(bodies, before);
        fill_grid(bodies);
    }

    /// When contacts may coincide; set_margin() forgets what was noted.
    Coincidences& coincidences() { return coincidences_; }
    void set_margin(double margin) {
        coincidences_.reset(margin);
        nearest_.margin = only_.margin = margin;
    }

    /// Calls see(j, shift, 0) for the images of all other bodies that may touch body i.
    template <typename See>
    void for_each_neighbour(const Bodies& bodies, std::int32_t i, const See& see) {
        grid_.for_each_neighbour(i, properties_[i].radius, at(bodies, i).cell, near_, see);
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(grid_, origin_, properties_, coincidences_);
        nearest_.margin = only_.margin = coincidences_.margin();
    }

    /// Moves the body to the next cell.
    template <typename Time>
    void cross(Bodies& bodies, std::int32_t i, int side, const Time& now);

    /// Prefetch the data needed for the event of body i at `time`, to be called in this order, each
    /// after the previous data have arrived: the body itself; its partner, by the same call; the
    /// cells around both; the bodies in these cells.
    void fetch_body_ahead(const Bodies& bodies, std::int32_t i) const {
        constexpr std::size_t cache_line = 64;
        const auto* begin = reinterpret_cast<const char*>(&at(bodies, i));
        for (std::size_t k = 0; k < sizeof(Body); k += cache_line) __builtin_prefetch(begin + k);
    }
    void fetch_cells_ahead(const Bodies& bodies, std::int32_t i, double time) const;
    void fetch_neighbours_ahead(const Bodies& bodies, std::int32_t i, double time);

    /// The other body in the event of body i at `time`, or i if there is none.
    static std::int32_t partner_ahead(const Bodies& bodies, std::int32_t i, double time);

  protected:
    using Scalar = typename decltype(Body::x)::value_type;
    using Motion = RelativeMotion<Scalar, axes>;
    static constexpr bool of_doubles = std::is_same_v<Scalar, double>;
    static auto& at(auto& bodies, std::int32_t i) { return bodies[static_cast<std::size_t>(i)]; }

    double radius_of(std::int32_t i) const { return properties_[i].radius; }

    /// The earliest contact of a body.
    FirstContact first_contact(const Bodies& bodies, std::int32_t i, double now);
    /// The same for two bodies that have just collided. Returns false without a result if they
    /// might meet again before either meets a third.
    bool first_contacts(const Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                        std::array<FirstContact, 2>& contacts);
    /// The same for a body that has just crossed the side of a cell: the contact predicted before
    /// remains valid.
    FirstContact first_contact_after_crossing(const Bodies& bodies, std::int32_t i, int side,
                                              double now);

    /// Changes the velocities of two bodies in contact that have been advanced to the same time;
    /// `inverse_mass` is that of each. Returns false if they do not approach (a grazing contact,
    /// due to round-off).
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                 const std::array<Scalar, 2>& inverse_mass, Contact<dimension>& contact) const;

    /// Creates a new grid for all bodies over the part of space that begins at `origin` and has the
    /// size and walls of `part`. The bodies must be entered again.
    void set_grid(const Point& origin, const Box& part, std::size_t count) {
        Eigen::ArrayXd radii(static_cast<Eigen::Index>(count));
        for (std::size_t k = 0; k < count; ++k)
            radii[static_cast<Eigen::Index>(k)] = properties_[k].radius;
        origin_ = origin;
        grid_ = Grid(part, radii);
    }

    Box box_;
    Grid grid_;
    Coincidences coincidences_;
    Point origin_{};  ///< lower corner of the grid
    std::vector<std::int32_t> near_ =
        std::vector<std::int32_t>(4 * Grid::spare);  ///< scratch: the bodies to be examined
    BodyProperties properties_;

  private:
    static bool crosses_cells(const Prediction& prediction, double time) {
        return (prediction.contact_time > time) & (prediction.border >= first_cell_side);
    }
    static int cell_side(const Prediction& prediction) {
        return static_cast<int>(prediction.border - first_cell_side);
    }
    /// The motion, relative to a, of the image of b that is in contact with it, with both at the
    /// same time: the nearest image, or in a narrow periodic box, where two images may touch a, the
    /// one that a approaches. Returns false if a approaches none.
    bool motion_at_contact(const Body& a, const Body& b, double sigma, Motion& m) const;
    /// Replaces the separation by that of this image.
    bool choose_image(double sigma, Motion& m) const;
    void fill_grid(const Bodies& bodies);
    void fill_up_lanes(std::int32_t i);
    bool search(const Bodies& bodies, std::int32_t i, double now, const Pairing& pairing,
                FirstContact& first);
    auto search_slots(const Bodies& bodies, std::int32_t i, double now, FirstContact& first,
                      bool& may_coincide);
    const Pairing& pairing_near(Cell cell) const;
    template <std::size_t usual>
    void fetch_listed(const Bodies& bodies);

    Pairing nearest_, only_;  ///< for several images, and for a single one
    Point surely_nearest_{};  ///< an image closer than this is the one in contact
    std::size_t near_count_ = 0;
};

template <typename Body>
void PairSearch<Body>::fill_grid(const Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k)
        grid_.add(static_cast<std::int32_t>(k), properties_[k].radius, bodies[k].cell);
}

template <typename Body>
template <typename Time>
void PairSearch<Body>::cross(Bodies& bodies, std::int32_t i, int side, const Time& now) {
    Body& body = at(bodies, i);
    const Cell from = body.cell;
    body.cell = grid_.next_cell(from, side);
    if (grid_.is_last(from, side)) [[unlikely]] {
        // leaves a periodic box, and enters at the other side
        const auto axis = static_cast<std::size_t>(side / 2);
        advance_body(body, now);
        body.x[axis] += side % 2 == 1 ? -box_.length(axis) : box_.length(axis);
    }
    grid_.move(i, properties_[i].radius, from, body.cell);
}

template <typename Body>
[[gnu::always_inline]] inline bool PairSearch<Body>::motion_at_contact(const Body& a, const Body& b,
                                                                       double sigma,
                                                                       Motion& m) const {
    bool is_nearest = true;
    for (std::size_t k = 0; k < axes; ++k) {
        m.r[k] = b.x[k] - a.x[k];
        m.v[k] = b.v[k] - a.v[k];
        is_nearest = is_nearest && std::abs(static_cast<double>(m.r[k])) <= surely_nearest_[k];
    }
    if (is_nearest) [[likely]]
        return scalar_product(m.r, m.v) < 0.0;
    return choose_image(sigma, m);
}

template <typename Body>
bool PairSearch<Body>::choose_image(double sigma, Motion& m) const {
    std::array<std::array<Scalar, 2>, axes> along{};
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const double size = box_.length(axis);
        const Scalar nearest = m.r[axis] - size * box_.turns(axis, static_cast<double>(m.r[axis]));
        along[axis] = {nearest, nearest > 0.0 ? Scalar(nearest - size) : Scalar(nearest + size)};
    }
    double best = never<double>;
    for_each_image(grid_.narrow(), [&](const std::array<std::size_t, axes>& which) {
        std::array<Scalar, axes> image;
        for (std::size_t axis = 0; axis < axes; ++axis) image[axis] = along[axis][which[axis]];
        if (!(scalar_product(image, m.v) < 0.0)) return;
        const double misfit =
            std::abs(static_cast<double>(Scalar(scalar_product(image, image) - sigma * sigma)));
        if (misfit >= best) return;
        best = misfit;
        m.r = image;
    });
    return std::isfinite(best);
}

template <typename Body>
[[gnu::always_inline]] inline bool PairSearch<Body>::collide(
    Bodies& bodies, std::int32_t i, std::int32_t j, const std::array<Scalar, 2>& inverse_mass,
    Contact<dimension>& contact) const {
    Body &a = at(bodies, i), &b = at(bodies, j);
    const double sigma = radius_of(i) + radius_of(j);
    Motion m;
    if (!motion_at_contact(a, b, sigma, m)) return false;
    static_assert(ContactRule::keeps_species);
    const Unrounded<Scalar> factor = ContactRule::impulse(m, inverse_mass[0], inverse_mass[1]);
    accelerate(a, product_of(inverse_mass[0], factor), m.r);
    accelerate(b, Scalar(-product_of(inverse_mass[1], factor)), m.r);
    contact = contact_of(m, factor.value, sigma);
    return true;
}

// Pads the list to whole groups with the body itself, which it never collides with; afterwards
// there is at least one group.
template <typename Body>
inline void PairSearch<Body>::fill_up_lanes(std::int32_t i) {
    for (std::size_t k = 0; k < lanes; ++k) near_[near_count_ + k] = i;
    near_count_ = std::max(lanes, (near_count_ + lanes - 1) / lanes * lanes);
}

// The earliest contact with one of the listed bodies. Returns whether two contacts may coincide.
template <typename Body>
[[gnu::always_inline]] inline bool PairSearch<Body>::search(const Bodies& bodies, std::int32_t i,
                                                            double now, const Pairing& pairing,
                                                            FirstContact& first) {
    fill_up_lanes(i);
    const std::size_t count = near_count_;
    near_count_ = 0;
    std::size_t k = 0;
    bool may_coincide = false;
    do {
        may_coincide |= search_contact(bodies, properties_, i, now, &near_[k],
                                       std::min(count - k, most_searched), pairing, first);
        k += most_searched;
    } while (k < count);
    return may_coincide;
}

// The pairing for bodies in the surrounding cells.
template <typename Body>
[[gnu::always_inline]] inline auto PairSearch<Body>::pairing_near(Cell cell) const
    -> const Pairing& {
    bool is_inner = true;
    for (std::size_t a = 0; a < axes; ++a)
        is_inner &= cell[a] - grid_.inner()[a].first < grid_.inner()[a].count;
    return is_inner ? only_ : nearest_;
}

// Returns early for empty cells: it is called for every cell, and most cells around a large body
// are empty.
template <typename Body>
inline auto PairSearch<Body>::search_slots(const Bodies& bodies, std::int32_t i, double now,
                                           FirstContact& first, bool& may_coincide) {
    return [&, i, now](const typename Grid::Slots& slots, const Point& shift) {
        grid_.append(slots, near_, near_count_);
        if (near_count_ == 0) return;
        auto pairing = Pairing::shifted(shift);
        pairing.gravity = only_.gravity;
        pairing.margin = only_.margin;
        may_coincide |= search(bodies, i, now, pairing, first);
    };
}

template <typename Body>
[[gnu::always_inline]] inline FirstContact PairSearch<Body>::first_contact(const Bodies& bodies,
                                                                           std::int32_t i,
                                                                           double now) {
    const Cell cell = at(bodies, i).cell;
    const double radius = properties_[i].radius;
    FirstContact first;
    bool may_coincide = false;
    if (grid_.plain(radius)) {
        grid_.append_around(cell, near_, near_count_);
        may_coincide = search(bodies, i, now, pairing_near(cell), first);
    } else {
        grid_.for_each_near(radius, cell, search_slots(bodies, i, now, first, may_coincide));
    }
    if (may_coincide) [[unlikely]]
        coincidences_.note(first.time);
    return first;
}

// The nearest image of the other body recedes, and no other image is relevant.
template <typename Body>
[[gnu::always_inline]] inline bool PairSearch<Body>::first_contacts(
    const Bodies& bodies, std::int32_t i, std::int32_t j, double now,
    std::array<FirstContact, 2>& contacts) {
    const Cell a = at(bodies, i).cell, b = at(bodies, j).cell;
    if (!grid_.plain(properties_[i].radius) || !grid_.plain(properties_[j].radius)) return false;
    grid_.append_around(a, near_, near_count_);
    fill_up_lanes(i);
    const std::size_t split = near_count_;
    grid_.append_around(b, near_, near_count_);
    fill_up_lanes(j);
    const std::size_t count = near_count_;
    near_count_ = 0;
    if (count > most_searched) return false;
    const bool at_edge = pairing_near(a).several_images || pairing_near(b).several_images;
    if (search_two_contacts(bodies, properties_, {i, j}, now, near_.data(), split, count,
                            at_edge ? nearest_ : only_, contacts)) [[unlikely]] {
        coincidences_.note(contacts[0].time);
        coincidences_.note(contacts[1].time);
    }
    return true;
}

template <typename Body>
[[gnu::always_inline]] inline FirstContact PairSearch<Body>::first_contact_after_crossing(
    const Bodies& bodies, std::int32_t i, int side, double now) {
    const Body& a = at(bodies, i);
    const Prediction& before = a.prediction;
    FirstContact first(before.contact_time, before.partner, before.partner_collisions);
    const double radius = properties_[i].radius;
    bool may_coincide = false;
    if (grid_.plain(radius)) {
        grid_.append_newly_around(a.cell, side, near_, near_count_);
        may_coincide = search(bodies, i, now, pairing_near(a.cell), first);
    } else {
        grid_.for_each_newly_near(radius, a.cell, side,
                                  search_slots(bodies, i, now, first, may_coincide));
    }
    if (may_coincide) [[unlikely]]
        coincidences_.note(first.time);
    return first;
}

// Negative partners are not bodies.
template <typename Body>
inline std::int32_t PairSearch<Body>::partner_ahead(const Bodies& bodies, std::int32_t i,
                                                    double time) {
    const Prediction& prediction = at(bodies, i).prediction;
    const std::int32_t meets = prediction.contact_time <= time ? -1 : 0;
    const std::int32_t no_body = prediction.partner >> 31;
    return i ^ ((i ^ prediction.partner) & meets & ~no_body);
}

// The processor cannot predict the length of the list, so at least `usual` entries are prefetched,
// the last of them possibly left from an earlier list; longer lists are rare.
template <typename Body>
template <std::size_t usual>
inline void PairSearch<Body>::fetch_listed(const Bodies& bodies) {
#pragma GCC unroll 32
    for (std::size_t k = 0; k < usual; ++k) __builtin_prefetch(&at(bodies, near_[k]));
    for (std::size_t k = usual; k < near_count_; ++k) __builtin_prefetch(&at(bodies, near_[k]));
    near_count_ = 0;
}

// Branchless: the processor cannot predict which kind of event comes.
template <typename Body>
inline void PairSearch<Body>::fetch_cells_ahead(const Bodies& bodies, std::int32_t i,
                                                double time) const {
    const Body& a = at(bodies, i);
    const bool is_crossing = crosses_cells(a.prediction, time);
    const Cell next = grid_.next_cell(a.cell, is_crossing ? cell_side(a.prediction) : 0);
    const unsigned crosses = is_crossing ? ~0U : 0U;
    Cell about;
    for (std::size_t k = 0; k < axes; ++k)
        about[k] = static_cast<std::uint16_t>(a.cell[k] ^ ((a.cell[k] ^ next[k]) & crosses));
    grid_.fetch_around(about);
    grid_.fetch_around(at(bodies, partner_ahead(bodies, i, time)).cell);
}

template <typename Body>
inline void PairSearch<Body>::fetch_neighbours_ahead(const Bodies& bodies, std::int32_t i,
                                                     double time) {
    if (!grid_.plain(properties_[i].radius)) return;
    const Body& a = at(bodies, i);
    if (crosses_cells(a.prediction, time)) {
        const int side = cell_side(a.prediction);
        grid_.append_newly_around(grid_.next_cell(a.cell, side), side, near_, near_count_);
        fetch_listed<dimension == 2 ? 4 : 10>(bodies);
    } else {
        grid_.append_around(a.cell, near_, near_count_);
        grid_.append_around(at(bodies, partner_ahead(bodies, i, time)).cell, near_, near_count_);
        fetch_listed<dimension == 2 ? 20 : 56>(bodies);
    }
}

}  // namespace carom
