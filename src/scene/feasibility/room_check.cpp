// Whether a gas can fit into its box: what can be said before anything is placed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "physics/placement/lattice.h"
#include "scene/reading/gas_reading.h"

namespace carom {
namespace {

// Hexagonal packing, the densest of equal disks in the plane (Fejes Toth 1940). Mixtures can be
// denser by the small ones in the gaps, but not when they are placed at random.
const double densest_packing = std::numbers::pi / std::sqrt(12.0);

// Touching is no overlap; positions are decimal numbers, rounded to doubles.
constexpr double rounding = 1e-12;

struct RadiusMoments {
    double largest_sure;  ///< of a particle that is there for certain
    double mean_square;
};

RadiusMoments moments(const Quantity& radius) {
    if (const auto* one = std::get_if<double>(&radius)) return {*one, *one * *one};
    if (const auto* uniform = std::get_if<UniformLaw>(&radius)) {
        const auto [a, b] = *uniform;
        return {a, (a * a + a * b + b * b) / 3.0};
    }
    if (const auto* normal = std::get_if<NormalLaw>(&radius))
        return {normal->mean, normal->mean * normal->mean + normal->deviation * normal->deviation};
    const auto& list = std::get<std::vector<double>>(radius);
    const double sum = std::inner_product(list.begin(), list.end(), list.begin(), 0.0);
    return {*std::max_element(list.begin(), list.end()), sum / static_cast<double>(list.size())};
}

double area_of_disks(const SpeciesDraft& draft) {
    return std::numbers::pi * moments(draft.species.radius).mean_square *
           static_cast<double>(draft.species.count);
}

bool fits(const Box& box, const SpeciesDraft& draft, Errors& errors) {
    const double radius = moments(draft.species.radius).largest_sure;
    if (2.0 * radius <= box.size.minCoeff()) return true;
    errors.add(at_key(draft, "radius"),
               fmt::format("a disk of radius {} does not fit into a box of {} by {}", radius,
                           box.size[0], box.size[1]));
    return false;
}

bool check_packing(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    double covered = 0.0;
    const SpeciesDraft* largest = &drafts.front();
    for (const SpeciesDraft& draft : drafts) {
        covered += area_of_disks(draft);
        if (area_of_disks(draft) > area_of_disks(*largest)) largest = &draft;
    }
    const double fraction = covered / box.size.prod();
    if (fraction <= densest_packing) return true;
    const double scale = std::sqrt(fraction / 0.5);
    errors.add(at_key(*largest, "count"),
               fmt::format("the disks cover {:.4g} of the box's area {:.6g} (packing fraction "
                           "{:.4g}), more than the {:.4f} of the densest packing",
                           covered, box.size.prod(), fraction, densest_packing),
               fmt::format("fewer or smaller disks, or a box of about {:.3g} by {:.3g}",
                           box.size[0] * scale, box.size[1] * scale));
    return false;
}

// The most disks of this radius that a lattice holds; fewer than `too_many`.
int most_on_lattice(const Box& box, int too_many, double radius) {
    int most = 0;
    while (too_many - most > 1) {
        const int middle = most + (too_many - most) / 2;
        (fitting_lattices(box, middle, radius).empty() ? too_many : most) = middle;
    }
    return most;
}

// As the placement does it, before any place is taken: all of them share one lattice, on which each
// has as much room as the largest.
void check_lattice(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    constexpr double roomy = 0.3;  // packing fraction
    const Node* node = nullptr;
    int count = 0;
    double radius = 0.0;
    bool equal = true;
    for (const SpeciesDraft& draft : drafts) {
        if (!std::holds_alternative<LatticePlaces>(draft.species.position)) continue;
        if (node == nullptr) node = &at_key(draft, "position");
        const double* one = std::get_if<double>(&draft.species.radius);
        equal = equal && one != nullptr && (count == 0 || *one == radius);
        count += static_cast<int>(draft.species.count);
        radius = std::max(radius, moments(draft.species.radius).largest_sure);
    }
    if (count * std::numbers::pi * radius * radius < roomy * box.size.prod()) return;
    if (count == 0 || !fitting_lattices(box, count, radius).empty()) return;
    errors.add(
        *node,
        fmt::format("no hexagonal lattice holds {} disks of radius {}{} in a box of {} by {}",
                    count, equal ? "" : "up to ", radius, box.size[0], box.size[1]),
        fmt::format("{} of them would fit; or smaller disks, or a larger box",
                    most_on_lattice(box, count, radius)));
}

void check_region(const Box& box, const SpeciesDraft& draft, Errors& errors) {
    const auto* within = std::get_if<WithinRegion>(&draft.species.position);
    if (within == nullptr) return;
    const Node& node = at_key(draft, "position");
    const auto [low, high] = within->region;
    if ((low < 0.0).any() || (high > box.size).any())
        return errors.add(node, fmt::format("`within` reaches outside the box of {} by {}",
                                            box.size[0], box.size[1]));
    if (!draft.radius_known) return;
    const Eigen::Array2d size = high - low;
    const double radius = moments(draft.species.radius).largest_sure;
    if (2.0 * radius > size.minCoeff() * (1.0 + rounding))
        return errors.add(
            node, fmt::format("a disk of radius {} does not fit into `within`, {} by {}", radius,
                              size[0], size[1]));
    const double fraction = area_of_disks(draft) / size.prod();
    if (fraction > densest_packing)
        errors.add(node, fmt::format("{} disks cover `within` {:.4g} times (packing fraction), "
                                     "more than the {:.4f} of the densest packing",
                                     draft.species.count, fraction, densest_packing));
}

struct Disk {
    Eigen::Array2d center;
    double radius;
    std::size_t particle;  ///< counted over all species
    const Node* node;
    const SpeciesDraft* draft;
};

std::vector<Disk> listed_disks(const std::vector<SpeciesDraft>& drafts) {
    std::vector<Disk> disks;
    std::size_t first = 0;
    for (const SpeciesDraft& draft : drafts) {
        const auto* places = std::get_if<Places>(&draft.species.position);
        if (places != nullptr && draft.position_known) {
            const Node& list = at_key(draft, "position");
            const bool each = list.is_list() && list.items.front().is_list();  // no point, no text
            for (std::size_t i = 0; i < places->values.size(); ++i)
                disks.push_back({places->values[i],
                                 draft.radius_known ? number_of(draft.species.radius, i) : 0.0,
                                 first + i, each ? &list.items[i] : &list, &draft});
        }
        first += static_cast<std::size_t>(draft.species.count);
    }
    return disks;
}

std::string called(const Disk& disk) { return called(*disk.draft, disk.particle); }

std::string room_for_center(const Box& box, double radius) {
    Eigen::Array2d low{0.0, 0.0}, high = box.size;
    for (int axis = 0; axis < 2; ++axis)
        if (box.walls[static_cast<std::size_t>(axis)] == Wall::solid) {
            low[axis] += radius;
            high[axis] -= radius;
        }
    return fmt::format("its centre has room from {} to {} across and from {} to {} up", low[0],
                       high[0], low[1], high[1]);
}

void check_inside(const Box& box, const std::vector<Disk>& disks, Errors& errors) {
    for (const Disk& disk : disks) {
        bool inside = true;
        for (int axis = 0; axis < 2; ++axis) {
            const bool solid = box.walls[static_cast<std::size_t>(axis)] == Wall::solid;
            const double margin = solid ? disk.radius - rounding * box.size[axis] : 0.0;
            inside = inside && disk.center[axis] >= margin &&
                     disk.center[axis] <= box.size[axis] - margin;
        }
        if (!inside)
            errors.add(*disk.node,
                       fmt::format("{} of radius {} is not inside the box of {} by {}",
                                   called(disk), disk.radius, box.size[0], box.size[1]),
                       room_for_center(box, disk.radius));
    }
}

double distance(const Box& box, const Disk& a, const Disk& b) {
    Eigen::Array2d apart = (a.center - b.center).abs();
    for (int axis = 0; axis < 2; ++axis)
        if (box.walls[static_cast<std::size_t>(axis)] == Wall::periodic)
            apart[axis] = std::min(apart[axis], std::abs(box.size[axis] - apart[axis]));
    return apart.matrix().norm();
}

// Whether the pair overlaps, which is reported; of a word only once, since it is moved as a whole.
bool overlap(const Box& box, const Disk& a, const Disk& b, std::set<const Node*>& words,
             Errors& errors) {
    const double needed = a.radius + b.radius;
    const double apart = distance(box, a, b);
    if (apart >= needed * (1.0 - rounding) && apart > 0.0) return false;
    const Disk& first = a.particle < b.particle ? a : b;
    const Disk& second = a.particle < b.particle ? b : a;
    const bool of_word = second.node->is_mapping();
    if (of_word && !words.insert(second.node).second) return false;
    errors.add(
        *second.node,
        fmt::format("{} overlaps {}: {:.6g} apart, at least {:.6g} needed", called(second),
                    called(first), apart, needed),
        of_word ? "another `within` moves the word" : "move one of them, or make them smaller");
    return true;
}

// Sorted by x, only neighbours within two radii are compared; what lies beyond the ceiling is left
// to the placement, which looks at everything.
void check_overlaps(const Box& box, std::vector<Disk> disks, Errors& errors) {
    std::sort(disks.begin(), disks.end(), [](const Disk& a, const Disk& b) {
        return std::pair{a.center[0], a.particle} < std::pair{b.center[0], b.particle};
    });
    double reach = 0.0;
    for (const Disk& disk : disks) reach = std::max(reach, 2.0 * disk.radius);
    const bool around = box.walls[0] == Wall::periodic;
    std::size_t compared = 0;
    std::size_t overlaps = 0;
    std::set<const Node*> words;
    for (std::size_t i = 0; i < disks.size(); ++i)
        for (std::size_t step = 1; step < disks.size(); ++step) {
            const std::size_t j = (i + step) % disks.size();
            if (j < i && !around) break;
            const double turn = j < i ? box.size[0] : 0.0;
            if (disks[j].center[0] + turn - disks[i].center[0] > reach) break;
            if (++compared > most_pairs_compared.count()) return;
            if (overlap(box, disks[i], disks[j], words, errors) &&
                ++overlaps == most_errors_shown.count())
                return;
        }
}

}  // namespace

void check_room(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    if (drafts.empty()) return;
    bool known = true;
    bool all_fit = true;
    for (const SpeciesDraft& draft : drafts) {
        known = known && draft.radius_known && draft.species.count > 0;
        if (draft.radius_known) all_fit = fits(box, draft, errors) && all_fit;
        if (draft.position_known) check_region(box, draft, errors);
    }
    if (known && all_fit && check_packing(box, drafts, errors)) check_lattice(box, drafts, errors);
    const std::vector<Disk> disks = listed_disks(drafts);
    check_inside(box, disks, errors);
    check_overlaps(box, disks, errors);
}

}  // namespace carom
