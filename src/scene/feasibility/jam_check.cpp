// Whether particles fill a line of their box and move along it: what can be said before anything is
// placed.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "physics/placement/jam.h"
#include "physics/placement/lattice.h"
#include "scene/reading/gas_reading.h"

namespace carom {
namespace {

// Touching is no gap; positions are decimal numbers, rounded to doubles.
constexpr double rounding = 1e-12;

// A velocity that is drawn: like no other.
constexpr double drawn = std::numeric_limits<double>::quiet_NaN();

bool is_zero(const Quantity& quantity, std::size_t i) {
    if (std::holds_alternative<UniformLaw>(quantity) || std::holds_alternative<NormalLaw>(quantity))
        return false;
    return number_of(quantity, i) == 0.0;
}

Eigen::Array2d velocity_of(const VelocityRule& rule, std::size_t i) {
    if (const auto* velocity = std::get_if<Velocity>(&rule))
        return velocity->values.size() == 1 ? velocity->values.front() : velocity->values.at(i);
    const auto* speed = std::get_if<Speed>(&rule);
    const auto* temperature = std::get_if<Temperature>(&rule);
    const bool rests = std::holds_alternative<AtRest>(rule) ||
                       (speed && is_zero(speed->value, i)) ||
                       (temperature && temperature->value == 0.0);
    return rests ? Eigen::Array2d{0.0, 0.0} : Eigen::Array2d{drawn, drawn};
}

/// A particle whose place is known.
struct Known {
    Eigen::Array2d place;
    const SpeciesDraft* draft;
    std::size_t index;     ///< in its species
    std::size_t particle;  ///< counted over all species
    const Node* node;
};

double radius_of(const Known& one) { return number_of(one.draft->species.radius, one.index); }

template <typename Function>
void for_each_particle(const std::vector<SpeciesDraft>& drafts, Function&& f) {
    std::size_t first = 0;
    for (const SpeciesDraft& draft : drafts) {
        const auto count = static_cast<std::size_t>(draft.species.count);
        for (std::size_t i = 0; i < count; ++i)
            f(Known{{0.0, 0.0}, &draft, i, first + i, &at_key(draft, "radius")});
        first += count;
    }
}

std::vector<Known> listed(const std::vector<SpeciesDraft>& drafts) {
    std::vector<Known> all;
    for_each_particle(drafts, [&](Known one) {
        const auto* places = std::get_if<Places>(&one.draft->species.position);
        if (places == nullptr) return;
        one.place = places->values.at(one.index);
        const Node& position = at_key(*one.draft, "position");
        one.node = &position;
        if (position.is_list() && (places->values.size() > 1 || position.items.front().is_list()))
            one.node = &position.items.at(one.index);
        all.push_back(one);
    });
    return all;
}

// All beads of a wire that they fill, in some order: none of them has room.
std::vector<Known> filling(const Box& box, const std::vector<SpeciesDraft>& drafts) {
    std::vector<Known> all;
    double end = 0.0;
    for_each_particle(drafts, [&](Known one) {
        one.place[0] = end + radius_of(one);
        end += 2.0 * radius_of(one);
        all.push_back(one);
    });
    if (end < box.size[0] * (1.0 - rounding)) all.clear();
    return all;
}

// Disks that reach from wall to wall, wherever they are placed.
std::vector<Known> as_wide_as(const Box& box, const std::vector<SpeciesDraft>& drafts) {
    std::vector<Known> all;
    for_each_particle(drafts, [&](Known one) {
        one.place = 0.5 * box.size;
        if (2.0 * radius_of(one) >= box.size.minCoeff() * (1.0 - rounding)) all.push_back(one);
    });
    return all;
}

// Disks of one species on a lattice where disks touch along a side of the box, if nothing but they
// takes its sites.
std::vector<Known> on_lattice(const Box& box, const std::vector<SpeciesDraft>& drafts) {
    std::vector<Known> all;
    double radius = 0.0;
    for_each_particle(drafts, [&](Known one) {
        if (!std::holds_alternative<LatticePlaces>(one.draft->species.position)) return;
        radius = std::max(radius, radius_of(one));
        all.push_back(one);
    });
    const auto is_apart = [](const SpeciesDraft& draft) {
        return std::holds_alternative<RandomPlaces>(draft.species.position) ||
               std::holds_alternative<WithinRegion>(draft.species.position);
    };
    const auto others = std::ranges::count_if(drafts, std::not_fn(is_apart));
    if (all.empty() || others > 1 ||
        4.0 * radius * radius * static_cast<double>(all.size()) < 0.3 * box.size.prod())
        return {};
    const auto lattices = fitting_lattices(box, static_cast<int>(all.size()), radius);
    const double touching = 2.0 * radius * (1.0 + rounding);
    if (lattices.empty()) return {};
    const Eigen::Array2d& spacing = lattices.front().spacing;  // of rows, every other one shifted
    if (std::min(spacing[0], 2.0 * spacing[1]) > touching) return {};
    const std::vector<Eigen::Array2d> sites = lattice_sites(box, lattices.front(), radius);
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k].place = sites[k * sites.size() / all.size()];
    return all;
}

bool report_jam(const Box& box, const std::vector<Known>& known, Errors& errors) {
    const auto count = static_cast<Eigen::Index>(known.size());
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, box.dimension), Eigen::ArrayXXd(count, box.dimension)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Known& one = known[static_cast<std::size_t>(i)];
        const Species& species = one.draft->species;
        particles.radius[i] = radius_of(one);
        particles.inverse_mass[i] = std::holds_alternative<Infinite>(species.mass) ? 0.0 : 1.0;
        const Eigen::Array2d velocity = velocity_of(species.velocity, one.index);
        for (int axis = 0; axis < box.dimension; ++axis) {
            start.position(i, axis) = one.place[axis];
            start.velocity(i, axis) = velocity[axis];
        }
    }
    const auto jam = first_jam(box, particles, start);
    if (!jam) return false;
    const Known& one = known[static_cast<std::size_t>(jam->particle)];
    errors.add(*one.node, to_text(*jam, called(*one.draft, one.particle), box.dimension),
               way_out_of_jam(box.dimension));
    return true;
}

}  // namespace

void check_jam(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    if (report_jam(box, listed(drafts), errors)) return;
    if (box.dimension == 1) {
        report_jam(box, filling(box, drafts), errors);
        return;
    }
    for (const Known& one : as_wide_as(box, drafts))
        if (report_jam(box, {one}, errors)) return;
    report_jam(box, on_lattice(box, drafts), errors);
}

}  // namespace carom
