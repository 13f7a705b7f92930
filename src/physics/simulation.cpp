#include "physics/simulation.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/hard_disks.h"
#include "physics/placed_disks.h"
#include "physics/placement.h"

namespace carom {
namespace {

[[maybe_unused]] bool nothing_overlaps(const Box& box, const Particles& particles,
                                       const Sample& state) {
    if (particles.count() == 0) return true;
    PlacedDisks placed(box, particles.count(), 0.5 * particles.radius.mean());
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const Eigen::Array2d centre = state.position.row(i).transpose();
        if (!placed.is_free(centre, particles.radius[i])) return false;
        placed.add(static_cast<std::int32_t>(i), centre, particles.radius[i]);
    }
    return true;
}

}  // namespace

struct Simulation::Implementation {
    Implementation(const Box& its_box, Particles its_particles, const Sample& start, const Run& run)
        : box(its_box),
          particles(std::move(its_particles)),
          events(run.events),
          disks(its_box, particles),
          present(start) {
        assert(box.dimension == 2);
        assert(nothing_overlaps(box, particles, start));
        present.time = -run.equilibrate;
        disks.start(present);
        if (run.equilibrate > 0.0) {
            disks.advance(0.0, nullptr);
            disks.sample(0.0, present);
            disks.start(present);
            disks.forget();
        }
    }

    void advance(double time) {
        disks.advance(time, recording ? &collisions : nullptr);
        present.time = time;
        sampled = false;
    }

    // Rule for a faithful way back: exactly at its time, with all predictions made anew.
    void reverse() {
        disks.sample(present.time, present);
        present.velocity = -present.velocity;
        disks.start(present);
        ++reversals;
    }

    Box box;
    Particles particles;
    std::vector<RunEvent> events;
    std::size_t next_event = 0;
    HardDisks disks;
    Sample present;  ///< its time is the present; positions and velocities only when `sampled`
    bool sampled = true;
    bool recording = false;
    std::vector<Collision> collisions;
    int reversals = 0;
};

Simulation::Simulation(const Gas& gas, const Run& run) {
    auto [particles, start] = place(gas);
    implementation_ = std::make_unique<Implementation>(gas.box, std::move(particles), start, run);
}

Simulation::Simulation(const Box& box, Particles particles, const Sample& start, const Run& run)
    : implementation_(std::make_unique<Implementation>(box, std::move(particles), start, run)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Passage Simulation::advance_to(double time) {
    Implementation& its = *implementation_;
    assert(time >= its.present.time);
    its.collisions.clear();
    while (its.next_event < its.events.size() && its.events[its.next_event].at <= time) {
        its.advance(its.events[its.next_event].at);
        its.reverse();
        ++its.next_event;
    }
    its.advance(time);
    return {its.disks.counts(), its.disks.transfers(), its.reversals, its.collisions};
}

const Sample& Simulation::sample() {
    Implementation& its = *implementation_;
    if (!its.sampled) its.disks.sample(its.present.time, its.present);
    its.sampled = true;
    return its.present;
}

void Simulation::record_collisions(bool on) { implementation_->recording = on; }

const Box& Simulation::box() const { return implementation_->box; }

const Particles& Simulation::particles() const { return implementation_->particles; }

}  // namespace carom
