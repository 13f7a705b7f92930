#include "physics/contact_search.h"

#include <bit>

#include "physics/arena.h"
#include "physics/pair_collision.h"

// Only GCC takes the attribute at the definition; its resolver would run before the address
// sanitizer is ready.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CAROM_FOR_EACH_PROCESSOR __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define CAROM_FOR_EACH_PROCESSOR
#endif

namespace carom {
namespace {

// A disk as it is now.
struct Viewer {
    double x, y, vx, vy, radius, inverse_mass, now;
};

[[gnu::always_inline]] inline Viewer viewer(const FlyingDisk& d, double now,
                                            const Pairing& pairing) {
    const double age = now - d.time;
    return {(d.x[0] + d.v[0] * age) - pairing.shift[0],
            (d.x[1] + d.v[1] * age) - pairing.shift[1],
            d.v[0],
            d.v[1],
            d.radius,
            d.inverse_mass,
            now};
}

[[gnu::always_inline]] inline FourLanes nearest(const FourLanes& x, const Pairing& pairing,
                                                std::size_t axis) {
    const FourLanes size = FourLanes{} + pairing.size[axis];
    const FourLanes lower = select(x > pairing.half[axis], size, FourLanes{});
    const FourLanes higher = select(x < -pairing.half[axis], size, FourLanes{});
    return (x - lower) + higher;
}

// Pairs as they are now.
struct Pairs {
    template <typename T>
    using Each = std::array<T, most_searched>;
    alignas(sizeof(FourLanes)) Each<double> x, y, vx, vy, sigma;
};

// Which of four others might be touched: bits 0 to 3 of the lanes together.
template <bool several_images, bool same_sigma>
[[gnu::always_inline]] inline FourMasks might_touch(const Viewer& a, const FlyingDisk* disks,
                                                    const std::int32_t* near, std::size_t k,
                                                    const Pairing& pairing, Pairs& pairs) {
    const FlyingDisk &b0 = disks[near[k]], &b1 = disks[near[k + 1]], &b2 = disks[near[k + 2]],
                     &b3 = disks[near[k + 3]];
    // Each disk's x and y lie side by side, and vx and vy: turned over, two pairs at a time.
    const FourLanes x02 = load_two_and_two(b0.x.data(), b2.x.data());
    const FourLanes x13 = load_two_and_two(b1.x.data(), b3.x.data());
    const FourLanes v02 = load_two_and_two(b0.v.data(), b2.v.data());
    const FourLanes v13 = load_two_and_two(b1.v.data(), b3.v.data());
    const FourLanes others_vx = __builtin_shufflevector(v02, v13, 0, 4, 2, 6);
    const FourLanes others_vy = __builtin_shufflevector(v02, v13, 1, 5, 3, 7);
    const FourLanes age = a.now - FourLanes{b0.time, b1.time, b2.time, b3.time};
    FourLanes x = (__builtin_shufflevector(x02, x13, 0, 4, 2, 6) + others_vx * age) - a.x;
    FourLanes y = (__builtin_shufflevector(x02, x13, 1, 5, 3, 7) + others_vy * age) - a.y;
    if (several_images) {
        x = nearest(x, pairing, 0);
        y = nearest(y, pairing, 1);
    }
    const FourLanes vx = others_vx - a.vx, vy = others_vy - a.vy;
    FourLanes sigma = FourLanes{} + pairing.sigma;
    if (!same_sigma) {
        sigma = FourLanes{b0.radius, b1.radius, b2.radius, b3.radius} + a.radius;
        store_lanes(sigma, &pairs.sigma[k]);
    }
    store_lanes(x, &pairs.x[k]);
    store_lanes(y, &pairs.y[k]);
    store_lanes(vx, &pairs.vx[k]);
    store_lanes(vy, &pairs.vy[k]);
    const auto look = quick_look(RelativeMotion<FourLanes>{x, y, vx, vy}, sigma);
    return (look.approach > 0.0) & (look.slack >= 0.0);
}

[[gnu::always_inline]] inline std::uint64_t bits_of(FourMasks mask) {
    mask |= __builtin_shufflevector(mask, mask, 2, 3, 0, 1);
    return static_cast<std::uint64_t>(mask[0] | mask[1]);
}

// Takes a contact at `time`, or never, if it comes first. Without branches, which the processor
// could not foretell.
[[gnu::always_inline]] inline void consider(double time, std::int32_t other,
                                            std::uint32_t collisions, FirstContact& first) {
    const bool lower = other < first.partner();
    const bool take = (time < first.time) | ((time <= first.time) & lower);
    const std::uint64_t mask = -static_cast<std::uint64_t>(take);
    const auto bits = std::bit_cast<std::uint64_t>(first.time);
    first.time = std::bit_cast<double>(bits ^ ((bits ^ std::bit_cast<std::uint64_t>(time)) & mask));
    first.who ^= (first.who ^ FirstContact(time, other, collisions).who) & mask;
}

// The exact times of two contacts, of a with the disk numbered k in `near` and of b with l; the
// same twice does no harm.
template <bool same_sigma>
[[gnu::always_inline]] inline void solve(const Viewer& a, const Viewer& b, const FlyingDisk* disks,
                                         const std::int32_t* near, const Pairs& p, std::size_t k,
                                         std::size_t l, const Pairing& pairing,
                                         const EventQueue& queue, FirstContact& first_of_a,
                                         FirstContact& first_of_b) {
    const FlyingDisk &c = disks[near[k]], &d = disks[near[l]];
    RelativeMotion<TwoLanes> motion{
        {p.x[k], p.x[l]}, {p.y[k], p.y[l]}, {p.vx[k], p.vx[l]}, {p.vy[k], p.vy[l]}};
    TwoLanes sigma = both(pairing.sigma);
    if (!same_sigma) sigma = TwoLanes{p.sigma[k], p.sigma[l]};
    for (TwoLanes* pair : {&motion.x, &motion.y, &motion.vx, &motion.vy, &sigma})
        keep_together(*pair);
    const TwoLanes round_off =
        approach_round_off(motion, TwoLanes{a.vx, b.vx}, TwoLanes{a.vy, b.vy},
                           TwoLanes{c.v[0], d.v[0]}, TwoLanes{c.v[1], d.v[1]});
    const TwoLanes met = a.now + contact_times(motion, sigma, round_off);
    const TwoLanes weight =
        TwoLanes{a.inverse_mass, b.inverse_mass} + TwoLanes{c.inverse_mass, d.inverse_mass};
    const TwoLanes contact_before{queue.event(near[k]).contact_time,
                                  queue.event(near[l]).contact_time};
    const auto possible = (met <= contact_before) & (weight > 0.0) & (sigma > 0.0);
    const TwoLanes time = select(possible, met, both(never<double>));
    consider(time[0], near[k], c.collisions, first_of_a);
    consider(time[1], near[l], d.collisions, first_of_b);
}

// Takes the lowest bit away, and tells which it was.
[[gnu::always_inline]] inline std::size_t next_of(std::uint64_t& bits) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bits));
    bits &= bits - 1;
    return k;
}

// The same, or `other` where there is none.
[[gnu::always_inline]] inline std::size_t next_of_or(std::size_t other, std::uint64_t& bits) {
    const std::size_t none = bits == 0 ? ~std::size_t{0} : 0;
    const std::size_t k = next_of(bits);
    return (k & ~none) | (other & none);
}

template <bool several_images, bool same_sigma>
[[gnu::always_inline]] inline FourMasks all_that_might_touch(const Viewer& a,
                                                             const FlyingDisk* disks,
                                                             const std::int32_t* near,
                                                             std::size_t begin, std::size_t end,
                                                             const Pairing& pairing, Pairs& pairs) {
    FourMasks found{};
    FourMasks bits = FourMasks{1, 2, 4, 8} << static_cast<std::int64_t>(begin);
    for (std::size_t k = begin; k < end; k += lanes) {
        found |= might_touch<several_images, same_sigma>(a, disks, near, k, pairing, pairs) & bits;
        bits <<= lanes;
    }
    return found;
}

// Of one viewer.
template <bool several_images, bool same_sigma>
[[gnu::always_inline]] inline void search(const Viewer& a, const FlyingDisk* disks,
                                          const std::int32_t* near, std::size_t count,
                                          const Pairing& pairing, const EventQueue& queue,
                                          FirstContact& first) {
    Pairs pairs;
    std::uint64_t bits = bits_of(
        all_that_might_touch<several_images, same_sigma>(a, disks, near, 0, count, pairing, pairs));
    if (bits == 0) return;
    FirstContact best = first;
    do {
        const std::size_t k = next_of(bits), l = next_of_or(k, bits);
        solve<same_sigma>(a, a, disks, near, pairs, k, l, pairing, queue, best, best);
    } while (bits != 0);
    first = best;
}

// Of two.
template <bool several_images, bool same_sigma>
[[gnu::always_inline]] inline void search(const std::array<Viewer, 2>& viewers,
                                          const FlyingDisk* disks, const std::int32_t* near,
                                          std::size_t split, std::size_t count,
                                          const Pairing& pairing, const EventQueue& queue,
                                          std::array<FirstContact, 2>& firsts) {
    Pairs pairs;
    std::uint64_t bits = bits_of(all_that_might_touch<several_images, same_sigma>(
                                     viewers[0], disks, near, 0, split, pairing, pairs) |
                                 all_that_might_touch<several_images, same_sigma>(
                                     viewers[1], disks, near, split, count, pairing, pairs));
    while (bits != 0) {
        const std::size_t k = next_of(bits), l = next_of_or(k, bits);
        const std::size_t whose_k = k >= split ? 1 : 0, whose_l = l >= split ? 1 : 0;
        solve<same_sigma>(viewers[whose_k], viewers[whose_l], disks, near, pairs, k, l, pairing,
                          queue, firsts[whose_k], firsts[whose_l]);
    }
}

// A loop of its own for each kind of pairs.
template <typename... Arguments>
[[gnu::always_inline]] inline void search_by_kind(const Pairing& pairing,
                                                  Arguments&&... arguments) {
    if (pairing.sigma > 0.0 && pairing.several_images)
        search<true, true>(arguments...);
    else if (pairing.sigma > 0.0)
        search<false, true>(arguments...);
    else if (pairing.several_images)
        search<true, false>(arguments...);
    else
        search<false, false>(arguments...);
}

}  // namespace

Pairing Pairing::nearest(const Box& box) {
    Pairing pairing;
    for (std::size_t a = 0; a < 2; ++a) {
        const bool periodic = box.walls[a] == Wall::periodic;
        const double size = box.size[static_cast<Eigen::Index>(a)];
        pairing.half[a] = periodic ? 0.5 * size : Event::never;
        pairing.size[a] = periodic ? size : 0.0;
    }
    return pairing;
}

Pairing Pairing::shifted(double x, double y) {
    return {.shift = {x, y},
            .half = {Event::never, Event::never},
            .size = {0.0, 0.0},
            .several_images = false};
}

CAROM_FOR_EACH_PROCESSOR
void search_contact(const FlyingDisks& disks, std::int32_t i, double now, const std::int32_t* near,
                    std::size_t count, const Pairing& pairing, const EventQueue& queue,
                    FirstContact& first) {
    search_by_kind(pairing, viewer(disks[static_cast<std::size_t>(i)], now, pairing), disks.data(),
                   near, count, pairing, queue, first);
}

CAROM_FOR_EACH_PROCESSOR
void search_two_contacts(const FlyingDisks& disks, std::array<std::int32_t, 2> both, double now,
                         const std::int32_t* near, std::size_t split, std::size_t count,
                         const Pairing& pairing, const EventQueue& queue,
                         std::array<FirstContact, 2>& firsts) {
    const std::array viewers{viewer(disks[static_cast<std::size_t>(both[0])], now, pairing),
                             viewer(disks[static_cast<std::size_t>(both[1])], now, pairing)};
    search_by_kind(pairing, viewers, disks.data(), near, split, count, pairing, queue, firsts);
}

}  // namespace carom
