#include "physics/simulation_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <variant>

#include "physics/events/time_step.h"
#include "physics/placement/feasibility.h"
#include "physics/placement/members.h"
#include "physics/placement/overlap.h"
#include "physics/placement/placed_particles.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/surface_problem.h"

namespace carom {
namespace {

bool beads_are_apart(const Box& box, const Particles& particles, const Sample& state) {
    const double tolerance = touching_tolerance * box.size[0];
    bool are_apart = true;
    for_each_two_neighbours(
        box, beads_along(state, 0), [&](Eigen::Index left, Eigen::Index right, double apart) {
            const double contact = particles.radius[left] + particles.radius[right];
            are_apart = are_apart && apart >= contact - tolerance;
        });
    return are_apart;
}

bool nothing_overlaps(const Box& box, const Particles& particles, const Sample& state) {
    if (box.dimension == 1) return beads_are_apart(box, particles, state);
    return largest_relative_overlap(box, particles, state) <= touching_tolerance;
}

void require(bool condition, const char* otherwise) {
    if (!condition) throw std::invalid_argument(otherwise);
}

bool is_number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && std::isfinite(value);
}

bool is_clear_of_surfaces(const Box& box, const Particles& particles, const Sample& start) {
    const InitialBarriers barriers(box);
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const Vec center = vec_in(start.position, i);
        if (barriers.surface_in_the_way(box, center, particles.radius[i])) return false;
    }
    return true;
}

}  // namespace

void check_box(const Box& box) {
    require(box.dimension >= 1 && box.dimension <= 3, "the dimension of a box is 1, 2 or 3");
    require(box.surfaces.side_count == (box.dimension == 3 ? 6 : 4),
            "the sides that have numbers are 6 in space and 4 otherwise");
    for (Eigen::Index axis = 0; axis < box.dimension; ++axis)
        require(box.size[axis] > 0.0 && std::isfinite(box.size[axis]),
                "the size of a box is positive and finite");
}

void check_events(const std::vector<RunEvent>& events, double present, Eigen::Index particles,
                  const Box& box) {
    double before = present;
    for (const RunEvent& event : events) {
        require(event.at >= before && std::isfinite(event.at),
                "events lie ahead, in order of their times");
        before = event.at;
        if (const auto surface = surface_of(event))
            require(*surface >= 0 && *surface < box.surfaces.first_obstacle(),
                    "an event changes a side or a partition of the box");
        const auto* perturbation = perturbation_of(event);
        if (perturbation == nullptr) continue;
        require(perturbation->particle >= 0 && perturbation->particle < particles,
                "a perturbation is of a particle of the gas");
        require(std::ranges::all_of(
                    perturbation->by,
                    [](const std::string& text) { return text.empty() || is_number(text); }),
                "a perturbation is by decimal numbers");
    }
}

void check_surfaces(const Box& box, const Run& run) {
    const std::vector<SurfaceProblem> problems = surface_problems(box, run);
    if (!problems.empty()) throw std::invalid_argument(to_text(problems[0], box).message);
}

void check_surfaces(const Box& box, const Particles& particles, const Sample& start,
                    const Run& run) {
    check_surfaces(box, run);
    require(box.surfaces.are_plain() || is_clear_of_surfaces(box, particles, start),
            "particles lie clear of all surfaces");
}

int check_run(const Run& run, Eigen::Index particles, const Box& box) {
    require(run.bits.has_value(),
            "the bits of the run are unset: start_run() and bits_for_return() find them");
    require(*run.bits == bits_of_double || (*run.bits >= least_bits && *run.bits <= most_bits),
            "the bits of a run are 53, those of a double, or from 64 to 16384");
    require(run.equilibrate >= 0.0 && std::isfinite(run.equilibrate),
            "the time to equilibrate is finite and not negative");
    require(run.most_collisions.value_or(1) > 0, "a run may have at least one collision");
    check_events(run.events, 0.0, particles, box);
    if (const auto problem = time_step_problem(box, run))
        throw std::invalid_argument(problem->message);
    return *run.bits;
}

void check_particles(const Box& box, const Particles& particles) {
    check_box(box);
    const Eigen::Index count = particles.count();
    require(particles.inverse_mass.size() == count && particles.species.size() == count,
            "radii, inverse masses and species are of as many particles");
    require((particles.radius >= 0.0).all() && particles.radius.isFinite().all() &&
                (particles.inverse_mass >= 0.0).all() && particles.inverse_mass.isFinite().all(),
            "radii and inverse masses are finite and not negative");
}

void check_start(const Box& box, const Particles& particles, const Sample& start) {
    check_particles(box, particles);
    const Eigen::Index count = particles.count();
    require(start.position.rows() == count && start.velocity.rows() == count &&
                start.position.cols() == box.dimension && start.velocity.cols() == box.dimension,
            "positions and velocities are N x dimension");
    require(start.position.isFinite().all() && start.velocity.isFinite().all(),
            "positions and velocities are finite");
    require(nothing_overlaps(box, particles, start), "particles overlap");
}

}  // namespace carom
