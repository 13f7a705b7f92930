#include "physics/plane/contact_search.h"

#include <bit>
#include <cmath>
#include <limits>

#include "physics/collision/loop_types.h"
#include "physics/collision/pair_collision.h"
#include "util/threads/processors.h"

namespace carom {
namespace {

// The searching disk at the present, and the time up to which contacts matter.
struct Viewer {
    double x, y, vx, vy;
    Properties properties;
    double latest;
};

// The input of a search: all disks, the numbers of those to test, and the images of them.
template <typename BodyType, bool may_fall>
struct Scope {
    using Body = BodyType;
    static constexpr bool falls = may_fall;
    const Body* disks;
    const DiskProperties& properties;
    const Pairing& pairing;
    const std::int32_t* near;
    double now;
    /// Earlier than now by more than the rounding error of a contact time.
    double just_before = now - 8 * std::numeric_limits<double>::epsilon() * std::abs(now);

    [[gnu::always_inline]] const Body& disk(std::size_t k) const { return disks[near[k]]; }
    [[gnu::always_inline]] const Properties& properties_of(std::size_t k) const {
        return properties[near[k]];
    }

    [[gnu::always_inline]] Viewer viewer(std::int32_t i, const FirstContact& first) const {
        const Body& d = disks[i];
        const double age = now - d.time;
        Viewer viewer{d.x[0], d.x[1], d.v[0], d.v[1], properties[i], first.time};
        move(viewer.x, viewer.vx, age, 0);
        move(viewer.y, viewer.vy, age, 1);
        viewer.x -= pairing.shift[0];
        viewer.y -= pairing.shift[1];
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

[[gnu::always_inline]] inline FourLanes nearest(const FourLanes& x, const Pairing& pairing,
                                                std::size_t axis) {
    const FourLanes size = FourLanes{} + pairing.size[axis];
    const FourLanes lower = select(x > pairing.half[axis], size, FourLanes{});
    const FourLanes higher = select(x < -pairing.half[axis], size, FourLanes{});
    return (x - lower) + higher;
}

// Relative motion of the pairs at the present.
struct Pairs {
    template <typename T>
    using Each = std::array<T, most_searched>;
    alignas(sizeof(FourLanes)) Each<double> x, y, vx, vy, sigma;
};

// Which of four other disks might be touched: a mask, one lane for each.
template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline FourMasks might_touch(const Scope& scope, const Viewer& a,
                                                    std::size_t k, Pairs& pairs) {
    using Body = typename Scope::Body;
    const Body &b0 = scope.disk(k), &b1 = scope.disk(k + 1), &b2 = scope.disk(k + 2),
               &b3 = scope.disk(k + 3);
    // For each disk x and y are adjacent in memory, and so are vx and vy: they are transposed, two
    // pairs at a time.
    const FourLanes x02 = load_two_and_two(b0.x.data(), b2.x.data());
    const FourLanes x13 = load_two_and_two(b1.x.data(), b3.x.data());
    const FourLanes v02 = load_two_and_two(b0.v.data(), b2.v.data());
    const FourLanes v13 = load_two_and_two(b1.v.data(), b3.v.data());
    FourLanes others_vx = __builtin_shufflevector(v02, v13, 0, 4, 2, 6);
    FourLanes others_vy = __builtin_shufflevector(v02, v13, 1, 5, 3, 7);
    const FourLanes age = scope.now - FourLanes{b0.time, b1.time, b2.time, b3.time};
    FourLanes x = __builtin_shufflevector(x02, x13, 0, 4, 2, 6);
    FourLanes y = __builtin_shufflevector(x02, x13, 1, 5, 3, 7);
    scope.move(x, others_vx, age, 0);
    scope.move(y, others_vy, age, 1);
    x -= a.x;
    y -= a.y;
    if (several_images) {
        x = nearest(x, scope.pairing, 0);
        y = nearest(y, scope.pairing, 1);
    }
    const FourLanes vx = others_vx - a.vx, vy = others_vy - a.vy;
    FourLanes sigma = FourLanes{} + scope.pairing.sigma;
    if (!alike) {
        sigma = FourLanes{scope.properties_of(k).radius, scope.properties_of(k + 1).radius,
                          scope.properties_of(k + 2).radius, scope.properties_of(k + 3).radius} +
                a.properties.radius;
        store_lanes(sigma, &pairs.sigma[k]);
    }
    store_lanes(x, &pairs.x[k]);
    store_lanes(y, &pairs.y[k]);
    store_lanes(vx, &pairs.vx[k]);
    store_lanes(vy, &pairs.vy[k]);
    const RelativeMotion<FourLanes> motion{x, y, vx, vy};
    const auto look = quick_look(motion, sigma);
    const FourLanes others_latest{b0.prediction.contact_time, b1.prediction.contact_time,
                                  b2.prediction.contact_time, b3.prediction.contact_time};
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

// The exact times of two contacts: of a with the disk at position k in `near`, and of b with that
// at l.
template <bool alike, typename Scope>
[[gnu::always_inline]] inline void solve(const Scope& scope, const Viewer& a, const Viewer& b,
                                         const Pairs& p, const Two& two, FirstContact& first_of_a,
                                         FirstContact& first_of_b, double& second_of_a,
                                         double& second_of_b) {
    const auto [k, l, same] = two;
    const auto &c = scope.disk(k), &d = scope.disk(l);
    RelativeMotion<TwoLanes> motion{
        {p.x[k], p.x[l]}, {p.y[k], p.y[l]}, {p.vx[k], p.vx[l]}, {p.vy[k], p.vy[l]}};
    TwoLanes sigma = both(scope.pairing.sigma);
    if (!alike) sigma = TwoLanes{p.sigma[k], p.sigma[l]};
    for (TwoLanes* pair : {&motion.x, &motion.y, &motion.vx, &motion.vy, &sigma})
        keep_together(*pair);
    const TwoLanes vx{a.vx, b.vx}, vy{a.vy, b.vy};
    TwoLanes others_vx{c.v[0], d.v[0]}, others_vy{c.v[1], d.v[1]};
    if constexpr (Scope::falls) others_vx = motion.vx + vx, others_vy = motion.vy + vy;
    const TwoLanes round_off = approach_round_off(motion, vx, vy, others_vx, others_vy);
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
[[gnu::always_inline]] inline FourMasks all_that_might_touch(const Scope& scope, const Viewer& a,
                                                             std::size_t begin, std::size_t end,
                                                             Pairs& pairs) {
    FourMasks found{};
    FourMasks bits = FourMasks{1, 2, 4, 8} << static_cast<std::int64_t>(begin);
    for (std::size_t k = begin; k < end; k += lanes) {
        found |= might_touch<several_images, alike>(scope, a, k, pairs) & bits;
        bits <<= lanes;
    }
    return found;
}

// Search for one disk.
template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline bool search(const Scope& scope, std::int32_t i, std::size_t count,
                                          FirstContact& first) {
    const Viewer a = scope.viewer(i, first);
    Pairs pairs;
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

// Search for two disks.
template <bool several_images, bool alike, typename Scope>
[[gnu::always_inline]] inline bool search(const Scope& scope,
                                          const std::array<std::int32_t, 2>& both,
                                          std::size_t split, std::size_t count,
                                          std::array<FirstContact, 2>& firsts) {
    const std::array viewers{scope.viewer(both[0], firsts[0]), scope.viewer(both[1], firsts[1])};
    Pairs pairs;
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

// Disks that may fall, with or without gravity.
template <typename... Arguments>
[[gnu::always_inline]] inline auto search_falling(const FallingDisks& disks,
                                                  const DiskProperties& properties,
                                                  const Pairing& pairing, const std::int32_t* near,
                                                  double now, Arguments&&... arguments) {
    using Body = FallingDisk<double>;
    if ((pairing.gravity[0] == 0.0) & (pairing.gravity[1] == 0.0))
        return search_by_kind(Scope<Body, false>{disks.data(), properties, pairing, near, now},
                              arguments...);
    return search_by_kind(Scope<Body, true>{disks.data(), properties, pairing, near, now},
                          arguments...);
}

}  // namespace

Pairing Pairing::nearest(const Box& box) {
    Pairing pairing;
    for (std::size_t a = 0; a < 2; ++a) {
        const bool periodic = box.is_periodic(a);
        const double size = box.length(a);
        pairing.half[a] = periodic ? 0.5 * size : never<double>;
        pairing.size[a] = periodic ? size : 0.0;
    }
    return pairing;
}

Pairing Pairing::shifted(double x, double y) {
    return {.shift = {x, y},
            .half = {never<double>, never<double>},
            .size = {0.0, 0.0},
            .several_images = false};
}

CAROM_FOR_PROCESSORS_WITH_FMA
bool search_contact(const DiskStates& disks, const DiskProperties& properties, std::int32_t i,
                    double now, const std::int32_t* near, std::size_t count, const Pairing& pairing,
                    FirstContact& first) {
    return search_by_kind(Scope<DiskState, false>{disks.data(), properties, pairing, near, now}, i,
                          count, first);
}

CAROM_FOR_PROCESSORS_WITH_FMA
bool search_contact(const FallingDisks& disks, const DiskProperties& properties, std::int32_t i,
                    double now, const std::int32_t* near, std::size_t count, const Pairing& pairing,
                    FirstContact& first) {
    return search_falling(disks, properties, pairing, near, now, i, count, first);
}

CAROM_FOR_PROCESSORS_WITH_FMA
bool search_two_contacts(const DiskStates& disks, const DiskProperties& properties,
                         std::array<std::int32_t, 2> both, double now, const std::int32_t* near,
                         std::size_t split, std::size_t count, const Pairing& pairing,
                         std::array<FirstContact, 2>& firsts) {
    return search_by_kind(Scope<DiskState, false>{disks.data(), properties, pairing, near, now},
                          both, split, count, firsts);
}

CAROM_FOR_PROCESSORS_WITH_FMA
bool search_two_contacts(const FallingDisks& disks, const DiskProperties& properties,
                         std::array<std::int32_t, 2> both, double now, const std::int32_t* near,
                         std::size_t split, std::size_t count, const Pairing& pairing,
                         std::array<FirstContact, 2>& firsts) {
    return search_falling(disks, properties, pairing, near, now, both, split, count, firsts);
}

}  // namespace carom
