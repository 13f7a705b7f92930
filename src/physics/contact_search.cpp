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

[[gnu::always_inline]] inline Viewer viewer(const FlyingDisk& d, double now, const Images& images) {
    const double age = now - d.time;
    return {(d.x[0] + d.v[0] * age) - images.shift[0],
            (d.x[1] + d.v[1] * age) - images.shift[1],
            d.v[0],
            d.v[1],
            d.radius,
            d.inverse_mass,
            now};
}

[[gnu::always_inline]] inline FourLanes nearest(const FourLanes& x, const Images& images,
                                                std::size_t axis) {
    const FourLanes size = FourLanes{} + images.size[axis];
    const FourLanes lower = select(x > images.half[axis], size, FourLanes{});
    const FourLanes higher = select(x < -images.half[axis], size, FourLanes{});
    return (x - lower) + higher;
}

// Four pairs as they are now.
struct FourPairs {
    FourLanes x, y, vx, vy, sigma;
};

// Which of four others might be touched: bits 0 to 3 of the lanes together.
[[gnu::always_inline]] inline FourMasks might_touch(const Viewer& a, const FlyingDisk* disks,
                                                    const std::int32_t* near, const Images& images,
                                                    FourPairs& pairs) {
    const FlyingDisk &b0 = disks[near[0]], &b1 = disks[near[1]], &b2 = disks[near[2]],
                     &b3 = disks[near[3]];
    // Each disk's x, y, vx, vy lie side by side: four by four, turned over.
    const FourLanes row0 = load_lanes(b0.x.data()), row1 = load_lanes(b1.x.data()),
                    row2 = load_lanes(b2.x.data()), row3 = load_lanes(b3.x.data());
    const FourLanes x01 = __builtin_shufflevector(row0, row1, 0, 4, 2, 6);
    const FourLanes y01 = __builtin_shufflevector(row0, row1, 1, 5, 3, 7);
    const FourLanes x23 = __builtin_shufflevector(row2, row3, 0, 4, 2, 6);
    const FourLanes y23 = __builtin_shufflevector(row2, row3, 1, 5, 3, 7);
    const FourLanes vx = __builtin_shufflevector(x01, x23, 2, 3, 6, 7);
    const FourLanes vy = __builtin_shufflevector(y01, y23, 2, 3, 6, 7);
    const FourLanes age = a.now - FourLanes{b0.time, b1.time, b2.time, b3.time};
    const FourLanes x = __builtin_shufflevector(x01, x23, 0, 1, 4, 5) + vx * age;
    const FourLanes y = __builtin_shufflevector(y01, y23, 0, 1, 4, 5) + vy * age;
    pairs = {nearest(x - a.x, images, 0), nearest(y - a.y, images, 1), vx - a.vx, vy - a.vy,
             FourLanes{b0.radius, b1.radius, b2.radius, b3.radius} + a.radius};
    const auto look =
        quick_look(RelativeMotion<FourLanes>{pairs.x, pairs.y, pairs.vx, pairs.vy}, pairs.sigma);
    return (look.approach > 0.0) & (look.slack >= 0.0);
}

[[gnu::always_inline]] inline std::uint64_t bits_of(FourMasks mask) {
    mask |= __builtin_shufflevector(mask, mask, 2, 3, 0, 1);
    return static_cast<std::uint64_t>(mask[0] | mask[1]);
}

// What is known of the first contact: its time, whose bits are kept, and the partner, in the lower
// half, with its collision count. So all is replaced by two masks.
struct First {
    std::uint64_t time;
    std::uint64_t who;
};

// Takes a contact at `time` if it is the one to wait for. Without branches, which the processor
// could not foretell.
[[gnu::always_inline]] inline void consider(double time, std::int32_t other, double sigma,
                                            const Viewer& a, const FlyingDisk* disks,
                                            const EventQueue& queue, First& first) {
    const FlyingDisk& b = disks[other];
    const double known = std::bit_cast<double>(first.time);
    const bool lower = other < static_cast<std::int32_t>(first.who);
    const bool take = ((time < known) | ((time <= known) & lower)) &
                      (time <= queue.event(other).contact_time) &
                      (a.inverse_mass + b.inverse_mass > 0.0) & (sigma > 0.0);
    const std::uint64_t mask = -static_cast<std::uint64_t>(take);
    const auto who =
        static_cast<std::uint64_t>(b.collisions) << 32 | static_cast<std::uint32_t>(other);
    first.time ^= (first.time ^ std::bit_cast<std::uint64_t>(time)) & mask;
    first.who ^= (first.who ^ who) & mask;
}

// The exact times of two contacts, of a with the disk numbered k in `near` and of b with l; the
// same twice does no harm.
[[gnu::always_inline]] inline void solve(const Viewer& a, const Viewer& b, const FlyingDisk* disks,
                                         const std::int32_t* near, const FourPairs* pairs,
                                         std::size_t k, std::size_t l, const EventQueue& queue,
                                         First& first_of_a, First& first_of_b) {
    const FourPairs &p = pairs[k / lanes], &q = pairs[l / lanes];
    const std::size_t m = k % lanes, n = l % lanes;
    const FlyingDisk &c = disks[near[k]], &d = disks[near[l]];
    RelativeMotion<TwoLanes> motion{
        {p.x[m], q.x[n]}, {p.y[m], q.y[n]}, {p.vx[m], q.vx[n]}, {p.vy[m], q.vy[n]}};
    TwoLanes sigma{p.sigma[m], q.sigma[n]};
    for (TwoLanes* both : {&motion.x, &motion.y, &motion.vx, &motion.vy, &sigma})
        keep_together(*both);
    const TwoLanes round_off =
        approach_round_off(motion, TwoLanes{a.vx, b.vx}, TwoLanes{a.vy, b.vy},
                           TwoLanes{c.v[0], d.v[0]}, TwoLanes{c.v[1], d.v[1]});
    const TwoLanes time = a.now + contact_times(motion, sigma, round_off);
    consider(time[0], near[k], sigma[0], a, disks, queue, first_of_a);
    consider(time[1], near[l], sigma[1], b, disks, queue, first_of_b);
}

[[gnu::always_inline]] inline FourMasks all_that_might_touch(
    const Viewer& a, const FlyingDisk* disks, const std::int32_t* near, std::size_t begin,
    std::size_t end, const Images& images, FourPairs* pairs) {
    FourMasks found{};
    for (std::size_t k = begin; k < end; k += lanes)
        found |= might_touch(a, disks, near + k, images, pairs[k / lanes]) &
                 (FourMasks{1, 2, 4, 8} << static_cast<std::int64_t>(k));
    return found;
}

// Takes the lowest bit away, and tells which it was.
[[gnu::always_inline]] inline std::size_t next_of(std::uint64_t& bits) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bits));
    bits &= bits - 1;
    return k;
}

[[gnu::always_inline]] inline First known(const Event& event) {
    return {
        std::bit_cast<std::uint64_t>(event.contact_time),
        std::uint64_t{event.partner_collisions} << 32 | static_cast<std::uint32_t>(event.partner)};
}

[[gnu::always_inline]] inline void tell(const First& first, Event& event) {
    event.contact_time = std::bit_cast<double>(first.time);
    event.partner = static_cast<std::int32_t>(first.who);
    event.partner_collisions = (first.who >> 32) & most_collisions;
}

}  // namespace

Images Images::nearest(const Box& box) {
    Images images;
    for (std::size_t a = 0; a < 2; ++a) {
        const bool periodic = box.walls[a] == Wall::periodic;
        const double size = box.size[static_cast<Eigen::Index>(a)];
        images.half[a] = periodic ? 0.5 * size : Event::never;
        images.size[a] = periodic ? size : 0.0;
    }
    return images;
}

Images Images::shifted(double x, double y) {
    return {.shift = {x, y}, .half = {Event::never, Event::never}, .size = {0.0, 0.0}};
}

CAROM_FOR_EACH_PROCESSOR
void search_contact(const FlyingDisks& all, std::int32_t i, double now, const std::int32_t* near,
                    std::size_t count, const Images& images, const EventQueue& queue,
                    Event& first) {
    const FlyingDisk* const disks = all.data();
    const Viewer a = viewer(disks[i], now, images);
    FourPairs pairs[most_searched / lanes];
    std::uint64_t bits = bits_of(all_that_might_touch(a, disks, near, 0, count, images, pairs));
    if (bits == 0) return;
    First best = known(first);
    do {
        const std::size_t k = next_of(bits);
        const std::size_t l = bits != 0 ? next_of(bits) : k;
        solve(a, a, disks, near, pairs, k, l, queue, best, best);
    } while (bits != 0);
    tell(best, first);
}

CAROM_FOR_EACH_PROCESSOR
void search_two_contacts(const FlyingDisks& all, std::array<std::int32_t, 2> both, double now,
                         const std::int32_t* near, std::size_t split, std::size_t count,
                         const Images& images, const EventQueue& queue,
                         std::array<Event, 2>& firsts) {
    const FlyingDisk* const disks = all.data();
    const std::array viewers{viewer(disks[both[0]], now, images),
                             viewer(disks[both[1]], now, images)};
    FourPairs pairs[most_searched / lanes];
    std::uint64_t bits =
        bits_of(all_that_might_touch(viewers[0], disks, near, 0, split, images, pairs) |
                all_that_might_touch(viewers[1], disks, near, split, count, images, pairs));
    std::array best{known(firsts[0]), known(firsts[1])};
    while (bits != 0) {
        const std::size_t k = next_of(bits);
        const std::size_t l = bits != 0 ? next_of(bits) : k;
        const std::size_t whose_k = k >= split ? 1 : 0, whose_l = l >= split ? 1 : 0;
        solve(viewers[whose_k], viewers[whose_l], disks, near, pairs, k, l, queue, best[whose_k],
              best[whose_l]);
    }
    for (std::size_t k = 0; k < 2; ++k) tell(best[k], firsts[k]);
}

}  // namespace carom
