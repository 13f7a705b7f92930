#include "physics/cells/contact_search.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/collision/loop_types.h"
#include "physics/collision/pair_collision.h"
#include "util/threads/processors.h"

namespace carom {
namespace {

// The searching body at the present, and the time up to which contacts matter.
template <std::size_t axes>
struct Viewer {
    std::array<double, axes> x, v;
    Properties properties;
    double latest;
};

// The input of a search: all bodies, the numbers of those to test, and the images of them.
template <typename BodyType, bool may_fall>
struct Scope {
    using Body = BodyType;
    static constexpr bool falls = may_fall;
    static constexpr std::size_t axes = Body::axes;
    const Body* bodies;
    const BodyProperties& properties;
    const PairingOf<Body>& pairing;
    const std::int32_t* near;
    double now;
    /// Earlier than now by more than the rounding error of a contact time.
    double just_before = now - 8 * std::numeric_limits<double>::epsilon() * std::abs(now);

    [[gnu::always_inline]] const Body& body(std::size_t k) const { return bodies[near[k]]; }
    [[gnu::always_inline]] const Properties& properties_of(std::size_t k) const {
        return properties[near[k]];
    }

    [[gnu::always_inline]] Viewer<axes> viewer(std::int32_t i, const FirstContact& first) const {
        const Body& b = bodies[i];
        const double age = now - b.time;
        Viewer<axes> viewer{b.x, b.v, properties[i], first.time};
        for (std::size_t axis = 0; axis < axes; ++axis) {
            move(viewer.x[axis], viewer.v[axis], age, axis);
            viewer.x[axis] -= pairing.shift[axis];
        }
        return viewer;
    }

    // Advances a coordinate and a velocity component by `age`.
    template <typename Number>
    [[gnu::always_inline]] void move(Number& x, Number& v, const Number& age,
                                     std::size_t axis) const {
        if constexpr (falls) {
            const Number gain = pairing.gravity[axis] * age;
            x = x + (v + 0.5 * gain) * age;
            v = v + gain;
        } else {
            x = x + v * age;
        }
    }
};

template <int Dimension>
[[gnu::always_inline]] inline FourLanes nearest(const FourLanes& x,
                                                const Pairing<Dimension>& pairing,
                                                std::size_t axis) {
    const FourLanes size = FourLanes{} + pairing.size[axis];
    const FourLanes lower = select(x > pairing.half[axis], size, FourLanes{});
    const FourLanes higher = select(x < -pairing.half[axis], size, FourLanes{});
    return (x - lower) + higher;
}

// Relative motion of the pairs at the present.
template <std::size_t axes>
struct Pairs {
    template <typename T>
    using Each = std::array<T, most_searched>;
    alignas(sizeof(FourLanes)) std::array<Each<double>, axes> r, v;
    alignas(sizeof(FourLanes)) Each<double> sigma;
};

// What a test needs of four bodies, a lane for each.
template <std::size_t axes>
struct FourBodies {
    RelativeMotion<FourLanes, axes> motion;  ///< their places and velocities
    FourLanes time, latest;                  ///< their times, and those of their next contacts
};

// Of a disk x and y are adjacent in memory, and so are vx and vy: they are transposed, two pairs at
// a time.
[[gnu::always_inline]] inline FourBodies<2> load_four(const BodyState<2>& b0,
                                                      const BodyState<2>& b1,
                                                      const BodyState<2>& b2,
                                                      const BodyState<2>& b3) {
    const FourLanes x02 = load_two_and_two(b0.x.data(), b2.x.data());
    const FourLanes x13 = load_two_and_two(b1.x.data(), b3.x.data());
    const FourLanes v02 = load_two_and_two(b0.v.data(), b2.v.data());
    const FourLanes v13 = load_two_and_two(b1.v.data(), b3.v.data());
    FourBodies<2> all;
    all.motion.r[0] = __builtin_shufflevector(x02, x13, 0, 4, 2, 6);
    all.motion.r[1] = __builtin_shufflevector(x02, x13, 1, 5, 3, 7);
    all.motion.v[0] = __builtin_shufflevector(v02, v13, 0, 4, 2, 6);
    all.motion.v[1] = __builtin_shufflevector(v02, v13, 1, 5, 3, 7);
    all.time = FourLanes{b0.time, b1.time, b2.time, b3.time};
    all.latest = FourLanes{b0.prediction.contact_time, b1.prediction.contact_time,
                           b2.prediction.contact_time, b3.prediction.contact_time};
    return all;
}

// Transposes four vectors of four numbers.
[[gnu::always_inline]] inline void transpose(FourLanes& a, FourLanes& b, FourLanes& c,
                                             FourLanes& d) {
    const FourLanes ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const FourLanes ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const FourLanes cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const FourLanes cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

// The first cache line of a sphere holds x, y, z, vx, and vy, vz, its time and that of its contact.
[[gnu::always_inline]] inline FourBodies<3> load_four(const BodyState<3>& b0,
                                                      const BodyState<3>& b1,
                                                      const BodyState<3>& b2,
                                                      const BodyState<3>& b3) {
    const std::array<const double*, 4> from{
        reinterpret_cast<const double*>(&b0), reinterpret_cast<const double*>(&b1),
        reinterpret_cast<const double*>(&b2), reinterpret_cast<const double*>(&b3)};
    FourLanes x = load_lanes(from[0]), y = load_lanes(from[1]), z = load_lanes(from[2]),
              vx = load_lanes(from[3]);
    transpose(x, y, z, vx);
    FourLanes vy = load_lanes(from[0] + 4), vz = load_lanes(from[1] + 4),
              time = load_lanes(from[2] + 4), latest = load_lanes(from[3] + 4);
    transpose(vy, vz, time, latest);
    return {{{{x, y, z}}, {{vx, vy, vz}}}, time, latest};
}

// Which of four other bodies might be touched: a mask, one lane for each.
template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline FourMasks might_touch(const Scope& scope,
                                                    const Viewer<Scope::axes>& a, std::size_t k,
                                                    Pairs<Scope::axes>& pairs) {
    using Body = typename Scope::Body;
    constexpr std::size_t axes = Scope::axes;
    const Body &b0 = scope.body(k), &b1 = scope.body(k + 1), &b2 = scope.body(k + 2),
               &b3 = scope.body(k + 3);
    auto [motion, times, others_latest] = load_four(b0, b1, b2, b3);
    const FourLanes age = scope.now - times;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        scope.move(motion.r[axis], motion.v[axis], age, axis);
        motion.r[axis] -= a.x[axis];
        if (several_images) motion.r[axis] = nearest(motion.r[axis], scope.pairing, axis);
        motion.v[axis] -= a.v[axis];
    }
    FourLanes sigma = FourLanes{} + scope.pairing.sigma;
    if (!alike) {
        sigma = FourLanes{scope.properties_of(k).radius, scope.properties_of(k + 1).radius,
                          scope.properties_of(k + 2).radius, scope.properties_of(k + 3).radius} +
                a.properties.radius;
        store_lanes(sigma, &pairs.sigma[k]);
    }
    // Three steps of a loop would be unrolled too late: the vectors would pass through memory.
    const auto store = [&]<std::size_t... axis>(std::index_sequence<axis...>)
        __attribute__((always_inline)) {
        (store_lanes(motion.r[axis], &pairs.r[axis][k]), ...);
        (store_lanes(motion.v[axis], &pairs.v[axis][k]), ...);
    };
    store(std::make_index_sequence<axes>());
    const auto look = quick_look(motion, sigma);
    const FourLanes latest =
        select(others_latest < a.latest, others_latest, FourLanes{} + a.latest);
    return (look.approach > 0.0) & (look.slack >= 0.0) &
           might_touch_within(motion, sigma, look.approach, latest - scope.just_before);
}

[[gnu::always_inline]] inline std::uint64_t bits_of(const FourMasks& mask) {
    const FourMasks half = mask | __builtin_shufflevector(mask, mask, 2, 3, 0, 1);
    return static_cast<std::uint64_t>(half[0] | half[1]);
}

// Replaces `first` by a contact at `time` (possibly never, or not a number) if that comes first,
// and updates the time of the second. Branchless, because the processor could not predict the
// branches.
[[gnu::always_inline]] inline void consider(double time, std::int32_t other,
                                            std::uint32_t collisions, FirstContact& first,
                                            double& second) {
    const bool lower = other < first.partner();
    const double later = first.time > time ? first.time : time;
    second = later < second ? later : second;
    const bool take = (time < first.time) | ((time <= first.time) & lower);
    const std::uint64_t mask = -static_cast<std::uint64_t>(take);
    const auto bits = std::bit_cast<std::uint64_t>(first.time);
    first.time = std::bit_cast<double>(bits ^ ((bits ^ std::bit_cast<std::uint64_t>(time)) & mask));
    first.who ^= (first.who ^ FirstContact(time, other, collisions).who) & mask;
}

// Two candidates, by their positions in `near`: the second may be the first again.
struct Two {
    std::size_t k, l;
    std::uint64_t same;  ///< a mask
};

// Removes the lowest set bit and returns its index.
[[gnu::always_inline]] inline std::size_t next_of(std::uint64_t& bits) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bits));
    bits &= bits - 1;
    return k;
}

[[gnu::always_inline]] inline Two next_two_of(std::uint64_t& bits) {
    const std::size_t k = next_of(bits);
    const std::uint64_t none = bits == 0 ? ~std::uint64_t{0} : 0;
    const std::size_t l = next_of(bits);
    return {k, (l & ~none) | (k & none), none};
}

// The exact times of two contacts: of a with the body at position k in `near`, and of b with that
// at l.
template <bool alike, typename Scope>
[[gnu::always_inline]] inline void solve(const Scope& scope, const Viewer<Scope::axes>& a,
                                         const Viewer<Scope::axes>& b, const Pairs<Scope::axes>& p,
                                         const Two& two, FirstContact& first_of_a,
                                         FirstContact& first_of_b, double& second_of_a,
                                         double& second_of_b) {
    const auto [k, l, same] = two;
    const auto &c = scope.body(k), &d = scope.body(l);
    constexpr std::size_t axes = Scope::axes;
    RelativeMotion<TwoLanes, axes> motion;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        motion.r[axis] = TwoLanes{p.r[axis][k], p.r[axis][l]};
        motion.v[axis] = TwoLanes{p.v[axis][k], p.v[axis][l]};
    }
    TwoLanes sigma = both(scope.pairing.sigma);
    if (!alike) sigma = TwoLanes{p.sigma[k], p.sigma[l]};
    std::array<TwoLanes, axes> v, others_v;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        keep_together(motion.r[axis]);
        keep_together(motion.v[axis]);
        v[axis] = TwoLanes{a.v[axis], b.v[axis]};
        if constexpr (Scope::falls)
            others_v[axis] = motion.v[axis] + v[axis];
        else
            others_v[axis] = TwoLanes{c.v[axis], d.v[axis]};
    }
    keep_together(sigma);
    const TwoLanes round_off = approach_round_off(motion, v, others_v);
    const TwoLanes met = scope.now + contact_time(motion, sigma, round_off);
    const TwoLanes latest{c.prediction.contact_time, d.prediction.contact_time};
    TwoMasks possible = met <= latest;
    if (!alike) {
        const TwoLanes weight =
            TwoLanes{a.properties.inverse_mass, b.properties.inverse_mass} +
            TwoLanes{scope.properties_of(k).inverse_mass, scope.properties_of(l).inverse_mass};
        possible &= (weight > 0.0) & (sigma > 0.0);
    }
    const TwoLanes time = select(possible, met, both(never<double>));
    const auto another = std::bit_cast<double>(std::bit_cast<std::uint64_t>(time[1]) | same);
    consider(time[0], scope.near[k], c.collisions, first_of_a, second_of_a);
    consider(another, scope.near[l], d.collisions, first_of_b, second_of_b);
}

template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline FourMasks all_that_might_touch(const Scope& scope,
                                                             const Viewer<Scope::axes>& a,
                                                             std::size_t begin, std::size_t end,
                                                             Pairs<Scope::axes>& pairs) {
    FourMasks found{};
    FourMasks bits = FourMasks{1, 2, 4, 8} << static_cast<std::int64_t>(begin);
    for (std::size_t k = begin; k < end; k += lanes) {
        found |= might_touch<several_images, alike>(scope, a, k, pairs) & bits;
        bits <<= lanes;
    }
    return found;
}

// Search for one body.
template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline bool search(const Scope& scope, std::int32_t i, std::size_t count,
                                          FirstContact& first) {
    const Viewer<Scope::axes> a = scope.viewer(i, first);
    Pairs<Scope::axes> pairs;
    std::uint64_t bits =
        bits_of(all_that_might_touch<several_images, alike>(scope, a, 0, count, pairs));
    if (bits == 0) return false;
    FirstContact best = first;
    double second = never<double>;
    do {
        solve<alike>(scope, a, a, pairs, next_two_of(bits), best, best, second, second);
    } while (bits != 0);
    first = best;
    return second - best.time <= scope.pairing.margin;
}

// Search for two bodies.
template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline bool search(const Scope& scope,
                                          const std::array<std::int32_t, 2>& both,
                                          std::size_t split, std::size_t count,
                                          std::array<FirstContact, 2>& firsts) {
    const std::array viewers{scope.viewer(both[0], firsts[0]), scope.viewer(both[1], firsts[1])};
    Pairs<Scope::axes> pairs;
    std::uint64_t bits = bits_of(
        all_that_might_touch<several_images, alike>(scope, viewers[0], 0, split, pairs) |
        all_that_might_touch<several_images, alike>(scope, viewers[1], split, count, pairs));
    std::array<double, 2> second{never<double>, never<double>};
    while (bits != 0) {
        const Two two = next_two_of(bits);
        const std::size_t of_k = two.k >= split ? 1 : 0, of_l = two.l >= split ? 1 : 0;
        solve<alike>(scope, viewers[of_k], viewers[of_l], pairs, two, firsts[of_k], firsts[of_l],
                     second[of_k], second[of_l]);
    }
    return (second[0] - firsts[0].time <= scope.pairing.margin) |
           (second[1] - firsts[1].time <= scope.pairing.margin);
}

// Instantiates a separate loop for each kind of pairs.
template <typename Scope, typename... Arguments>
[[gnu::always_inline]] inline auto search_by_kind(const Scope& scope, Arguments&&... arguments) {
    const bool alike = scope.pairing.sigma > 0.0;
    if (alike && scope.pairing.several_images) return search<true, true>(scope, arguments...);
    if (alike) return search<false, true>(scope, arguments...);
    if (scope.pairing.several_images) return search<true, false>(scope, arguments...);
    return search<false, false>(scope, arguments...);
}

// A loop for each kind of pairs, but only one for all kinds of spheres that may fall: walls that
// act take more time than it saves, and each loop takes long to compile.
template <typename Scope, typename... Arguments>
[[gnu::always_inline]] inline auto search_in(const Scope& scope, Arguments&&... arguments) {
    if constexpr (Falls<typename Scope::Body> && Scope::axes == 3)
        return search<true, false>(scope, arguments...);
    else
        return search_by_kind(scope, arguments...);
}

// Bodies that fly straight, or that may fall, with or without gravity.
template <typename Body, typename... Arguments>
[[gnu::always_inline]] inline auto search_bodies(const LargeVector<Body>& bodies,
                                                 const BodyProperties& properties,
                                                 const PairingOf<Body>& pairing,
                                                 const std::int32_t* near, double now,
                                                 Arguments&&... arguments) {
    if constexpr (Falls<Body>) {
        bool falls = false;
        for (const double g : pairing.gravity) falls |= g != 0.0;
        if (falls)
            return search_in(Scope<Body, true>{bodies.data(), properties, pairing, near, now},
                             arguments...);
    }
    return search_in(Scope<Body, false>{bodies.data(), properties, pairing, near, now},
                     arguments...);
}

}  // namespace

template <int Dimension>
Pairing<Dimension> Pairing<Dimension>::nearest(const Box& box) {
    Pairing pairing;
    for (std::size_t a = 0; a < pairing.half.size(); ++a) {
        const bool periodic = box.is_periodic(a);
        const double size = box.length(a);
        pairing.half[a] = periodic ? 0.5 * size : never<double>;
        pairing.size[a] = periodic ? size : 0.0;
    }
    return pairing;
}

template <int Dimension>
Pairing<Dimension> Pairing<Dimension>::shifted(const Vector& shift) {
    Pairing pairing{.shift = shift, .several_images = false};
    pairing.half.fill(never<double>);
    return pairing;
}

template struct Pairing<2>;
template struct Pairing<3>;

template <typename Body>
CAROM_FOR_PROCESSORS_WITH_FMA bool search_contact(const LargeVector<Body>& bodies,
                                                  const BodyProperties& properties, std::int32_t i,
                                                  double now, const std::int32_t* near,
                                                  std::size_t count, const PairingOf<Body>& pairing,
                                                  FirstContact& first) {
    return search_bodies(bodies, properties, pairing, near, now, i, count, first);
}

template <typename Body>
CAROM_FOR_PROCESSORS_WITH_FMA bool search_two_contacts(
    const LargeVector<Body>& bodies, const BodyProperties& properties,
    std::array<std::int32_t, 2> both, double now, const std::int32_t* near, std::size_t split,
    std::size_t count, const PairingOf<Body>& pairing, std::array<FirstContact, 2>& firsts) {
    return search_bodies(bodies, properties, pairing, near, now, both, split, count, firsts);
}

// For both kinds of bodies of doubles.
#define CAROM_SEARCHES(...)                                                                   \
    template bool search_contact<__VA_ARGS__>(                                                \
        const LargeVector<__VA_ARGS__>&, const BodyProperties&, std::int32_t, double,         \
        const std::int32_t*, std::size_t, const PairingOf<__VA_ARGS__>&, FirstContact&);      \
    template bool search_two_contacts<__VA_ARGS__>(                                           \
        const LargeVector<__VA_ARGS__>&, const BodyProperties&, std::array<std::int32_t, 2>,  \
        double, const std::int32_t*, std::size_t, std::size_t, const PairingOf<__VA_ARGS__>&, \
        std::array<FirstContact, 2>&)

CAROM_SEARCHES(BodyState<2>);
CAROM_SEARCHES(BodyState<3>);
CAROM_SEARCHES(FallingBody<double, 2>);
CAROM_SEARCHES(FallingBody<double, 3>);

}  // namespace carom
