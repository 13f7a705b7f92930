// Whether beads can be on their wire: what can be said before anything is placed.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "physics/placement/line_squeeze.h"
#include "scene/reading/gas_reading.h"

namespace carom {
namespace {

// Touching is no overlap; positions are decimal numbers, rounded to doubles.
constexpr double rounding = 1e-12;

struct RadiusMoments {
    double largest_sure;  ///< of a bead that is there for certain
    double mean;
};

RadiusMoments moments(const Quantity& radius) {
    if (const auto* one = std::get_if<double>(&radius)) return {*one, *one};
    if (const auto* uniform = std::get_if<UniformLaw>(&radius))
        return {uniform->low, 0.5 * (uniform->low + uniform->high)};
    if (const auto* normal = std::get_if<NormalLaw>(&radius)) return {normal->mean, normal->mean};
    const auto& list = std::get<std::vector<double>>(radius);
    return {*std::max_element(list.begin(), list.end()),
            std::accumulate(list.begin(), list.end(), 0.0) / static_cast<double>(list.size())};
}

double length_of_beads(const SpeciesDraft& draft) {
    return 2.0 * moments(draft.species.radius).mean * static_cast<double>(draft.species.count);
}

bool fits(const Box& box, const SpeciesDraft& draft, Errors& errors) {
    const double radius = moments(draft.species.radius).largest_sure;
    if (2.0 * radius <= box.size[0] * (1.0 + rounding)) return true;
    errors.add(at_key(draft, "radius"),
               fmt::format("a bead of radius {} does not fit on a wire of length {}", radius,
                           box.size[0]));
    return false;
}

void check_filling(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    double length = 0.0;
    const SpeciesDraft* largest = &drafts.front();
    for (const SpeciesDraft& draft : drafts) {
        length += length_of_beads(draft);
        if (length_of_beads(draft) > length_of_beads(*largest)) largest = &draft;
    }
    if (length <= box.size[0] * (1.0 + rounding)) return;
    errors.add(at_key(*largest, "count"),
               fmt::format("the beads are {:.6g} long together, longer than the wire of {:.6g}",
                           length, box.size[0]),
               fmt::format("fewer or shorter beads, or a wire of about {:.3g}", 2.0 * length));
}

void check_part(const Box& box, const SpeciesDraft& draft, Errors& errors) {
    const auto* within = std::get_if<WithinRegion>(&draft.species.position);
    if (within == nullptr) return;
    const Node& node = at_key(draft, "position");
    const double low = within->region.low[0], high = within->region.high[0];
    if (low < 0.0 || high > box.size[0])
        return errors.add(
            node, fmt::format("`within` reaches outside the wire from 0 to {}", box.size[0]));
    if (!draft.radius_known) return;
    const double length = length_of_beads(draft);
    if (length > (high - low) * (1.0 + rounding))
        errors.add(node, fmt::format("{} beads, {:.6g} long together, do not fit into `within`, "
                                     "{:.6g} long",
                                     draft.species.count, length, high - low));
}

void check_density(const SpeciesDraft& draft, Errors& errors) {
    if (!std::holds_alternative<Density>(draft.species.mass) || !draft.radius_known) return;
    const Quantity& radius = draft.species.radius;
    const auto* one = std::get_if<double>(&radius);
    const auto* list = std::get_if<std::vector<double>>(&radius);
    const bool points = (one != nullptr && *one == 0.0) ||
                        (list != nullptr && std::count(list->begin(), list->end(), 0.0) > 0);
    if (points)
        errors.add(at_key(draft, "density"), "a point, of radius 0, has no mass from a density",
                   "give a `radius`, or a `mass` instead");
}

struct Bead {
    double x, radius, velocity;
    bool is_fixed;          ///< of infinite mass
    Eigen::Index particle;  ///< counted over all species
    const Node* node;
    const SpeciesDraft* draft;
};

double velocity_of(const VelocityRule& rule, std::size_t i) {
    const auto* velocity = std::get_if<Velocity>(&rule);
    if (velocity == nullptr) return 0.0;
    const std::size_t index = velocity->values.size() == 1 ? 0 : i;
    return index < velocity->values.size() ? velocity->values[index][0] : 0.0;
}

void list_beads(const SpeciesDraft& draft, Eigen::Index first, std::vector<Bead>& beads) {
    const auto* places = std::get_if<Places>(&draft.species.position);
    if (places == nullptr || !draft.position_known) return;
    const Node& node = at_key(draft, "position");
    for (std::size_t i = 0; i < places->values.size(); ++i)
        beads.push_back({.x = places->values[i][0],
                         .radius = draft.radius_known ? number_of(draft.species.radius, i) : 0.0,
                         .velocity = velocity_of(draft.species.velocity, i),
                         .is_fixed = std::holds_alternative<Infinite>(draft.species.mass),
                         .particle = first + static_cast<Eigen::Index>(i),
                         .node = node.is_list() ? &node.items[i] : &node,
                         .draft = &draft});
}

std::string called(const Bead& bead) {
    return called(*bead.draft, static_cast<std::size_t>(bead.particle));
}

bool is_inside(const Box& box, const Bead& bead, Errors& errors) {
    const bool solid = box.walls[0] == Wall::solid;
    const double margin = solid ? bead.radius - rounding * box.size[0] : 0.0;
    if (bead.x >= margin && bead.x <= box.size[0] - margin) return true;
    errors.add(*bead.node,
               fmt::format("{}{} is not inside the wire from 0 to {}", called(bead),
                           bead.radius > 0.0 ? fmt::format(" of radius {}", bead.radius) : "",
                           box.size[0]),
               fmt::format("its middle has room from {} to {}", solid ? bead.radius : 0.0,
                           box.size[0] - (solid ? bead.radius : 0.0)));
    return false;
}

// Whether two neighbours overlap, which is reported.
bool overlap(const Box& box, const Bead& left, const Bead& right, double turn, Errors& errors) {
    const double needed = left.radius + right.radius;
    const double apart = right.x + turn - left.x;
    if (apart > 0.0 && apart >= needed - rounding * box.size[0]) return false;
    const Bead& first = left.particle < right.particle ? left : right;
    const Bead& second = left.particle < right.particle ? right : left;
    if (apart == 0.0 && needed == 0.0)
        errors.add(*second.node,
                   fmt::format("{} is at the place of {}", called(second), called(first)),
                   "beads have an order on the wire: move one of them");
    else
        errors.add(*second.node,
                   fmt::format("{} overlaps {}: {:.6g} apart, at least {:.6g} needed",
                               called(second), called(first), apart, needed),
                   "move one of them, or make them shorter");
    return true;
}

bool overlaps(const Box& box, const std::vector<Bead>& beads, Errors& errors) {
    std::size_t found = 0;
    for (std::size_t k = 0; k + 1 < beads.size() && found < most_errors_shown.count(); ++k)
        found += overlap(box, beads[k], beads[k + 1], 0.0, errors);
    if (box.walls[0] == Wall::periodic && beads.size() > 1)
        found += overlap(box, beads.back(), beads.front(), box.size[0], errors);
    return found > 0;
}

// Beads that are placed later can only take more room: what is found among those listed holds. It
// needs all of infinite mass, for those not listed might stand between.
void check_squeeze(const Box& box, const std::vector<SpeciesDraft>& drafts,
                   const std::vector<Bead>& beads, const Run& run, Errors& errors) {
    for (const SpeciesDraft& draft : drafts)
        if (std::holds_alternative<Infinite>(draft.species.mass) &&
            !(std::holds_alternative<Places>(draft.species.position) && draft.position_known))
            return;
    const auto count = static_cast<Eigen::Index>(beads.size());
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, 1), Eigen::ArrayXXd(count, 1)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Bead& bead = beads[static_cast<std::size_t>(i)];
        particles.radius[i] = bead.radius;
        particles.inverse_mass[i] = bead.is_fixed ? 0.0 : 1.0;
        start.position(i, 0) = bead.x;
        start.velocity(i, 0) = bead.velocity;
    }
    auto squeeze = first_squeeze(box, particles, start, run);
    if (!squeeze) return;
    const Bead* last = nullptr;
    for (Eigen::Index* boundary : {&squeeze->left, &squeeze->right}) {
        if (*boundary < 0) continue;
        const Bead& bead = beads[static_cast<std::size_t>(*boundary)];
        *boundary = bead.particle;
        if (last == nullptr || bead.particle > last->particle) last = &bead;
    }
    errors.add(*last->node, to_text(*squeeze),
               "on a wire nothing can pass or yield: give a finite mass, another velocity, or an "
               "earlier end of the run");
}

}  // namespace

void check_wire(const Box& box, const std::vector<SpeciesDraft>& drafts, const Run& run,
                Errors& errors) {
    if (drafts.empty()) return;
    bool known = true;
    bool all_fit = true;
    std::vector<Bead> beads;
    Eigen::Index first = 0;
    for (const SpeciesDraft& draft : drafts) {
        known = known && draft.radius_known && draft.species.count > 0;
        check_density(draft, errors);
        if (draft.radius_known) all_fit = fits(box, draft, errors) && all_fit;
        if (draft.position_known) check_part(box, draft, errors);
        list_beads(draft, first, beads);
        first += static_cast<Eigen::Index>(draft.species.count);
    }
    if (known && all_fit) check_filling(box, drafts, errors);
    std::stable_sort(beads.begin(), beads.end(),
                     [](const Bead& a, const Bead& b) { return a.x < b.x; });
    const auto outside =
        std::erase_if(beads, [&](const Bead& bead) { return !is_inside(box, bead, errors); });
    const bool good = !overlaps(box, beads, errors) && outside == 0;
    if (good && known) check_squeeze(box, drafts, beads, run, errors);
}

}  // namespace carom
