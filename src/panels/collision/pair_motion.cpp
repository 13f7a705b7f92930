#include "panels/collision/pair_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "scene/scene.h"

namespace carom {
namespace {

constexpr const char* hint_for_walks =
    "`walk` is for two beads that collide only with each other and with walls at rest; without it "
    "the panel shows their first collision";

// Whether nothing acts on the particles but collisions, walls at rest and reversals.
bool keeps_energy(const Scene& scene) {
    const Surfaces& surfaces = scene.gas.box.surfaces;
    return surfaces.sides_reflect() &&
           std::ranges::all_of(surfaces.partitions, only_reflects, &Partition::behaviour) &&
           !surfaces.has_gravity() && !act_on_box(scene.run.events);
}

}  // namespace

double PairMotion::mass_center_velocity() const {
    return (inverse_mass[1] * before[0] + inverse_mass[0] * before[1]) / inverse_mass.sum();
}

double PairMotion::energy() const { return 0.5 * (before.square() / inverse_mass).sum(); }

double PairMotion::momentum() const { return (before / inverse_mass).sum(); }

Eigen::Matrix2d collision_matrix(const Eigen::Array2d& w) {
    Eigen::Matrix2d map;
    map << w[1] - w[0], 2.0 * w[0], 2.0 * w[1], w[0] - w[1];
    return map / w.sum();
}

WalkWatch::WalkWatch(const PanelContext& context, const PanelSpec& spec)
    : context_(context), spec_(spec) {
    if (!spec.of.empty())
        pair_ = std::array<Eigen::Index, 2>{*spec.of[0].particle, *spec.of[1].particle};
}

void WalkWatch::survey(const FrameInput& input) {
    if (start_.size() == 0) start_ = input.sample.velocity.col(0);
    for (const Collision& collision : input.advanced.collisions) {
        if (!pair_ && collision.second.is_surface()) {
            early_.push_back(collision);
            continue;
        }
        if (!pair_) {
            pair_ =
                std::array<Eigen::Index, 2>{std::min(collision.first, collision.second.particle()),
                                            std::max(collision.first, collision.second.particle())};
            for (const Collision& early : early_) see(early);
        }
        see(collision);
    }
}

void WalkWatch::see(const Collision& collision) {
    const auto& pair = *pair_;
    const auto place = [&](Eigen::Index i) { return std::ranges::find(pair, i) - pair.begin(); };
    const auto first = place(collision.first);
    const auto second = collision.second.is_surface() ? 2 : place(collision.second.particle());
    if (first == 2 && second == 2) return;
    const bool of_the_two = first < 2 && second < 2;
    if (!of_the_two && collision.second.is_particle()) {
        if (!foreign_) foreign_ = collision;
        return;
    }
    if (++count_ > most_steps) return;
    WalkStep step{.time = collision.time,
                  .cause = of_the_two ? WalkStep::Cause::pair : WalkStep::Cause::wall,
                  .velocity = {NAN, NAN}};  // NaN: of the bead that does not hit the wall
    step.velocity[first] = collision.first_after[0];
    if (of_the_two) step.velocity[second] = collision.second_after[0];
    met_.push_back(step);
}

std::vector<WalkStep> WalkWatch::steps() const {
    std::vector<WalkStep> steps;
    if (!pair_) return steps;
    const auto& pair = *pair_;
    if (!keeps_energy(context_.scene))
        refuse(
            spec_.place,
            fmt::format("walls, gravity or events change the energy of particles {} and {}: they "
                        "do not walk on one ellipse",
                        pair[0], pair[1]),
            hint_for_walks);
    if (foreign_) {
        const bool first_is_own = std::ranges::find(pair, foreign_->first) != pair.end();
        refuse(spec_.place,
               fmt::format("particle {} strikes particle {} at {:.6g}: particles {} and {} do not "
                           "walk on one ellipse",
                           first_is_own ? foreign_->second.particle() : foreign_->first,
                           first_is_own ? foreign_->first : foreign_->second.particle(),
                           foreign_->time, pair[0], pair[1]),
               hint_for_walks);
    }
    if (count_ > most_steps)
        refuse(
            spec_.place,
            fmt::format("particles {} and {} collide with each other and with walls {} times, but "
                        "`walk` shows "
                        "at most {}",
                        pair[0], pair[1], count_, most_steps),
            "give a shorter run, or more similar masses");
    steps.push_back({.velocity = {start_[pair[0]], start_[pair[1]]}});
    std::size_t next = 0;
    const auto go_on_until = [&](double time) {
        for (; next < met_.size() && met_[next].time <= time; ++next) {
            WalkStep step = met_[next];
            for (Eigen::Index k = 0; k < 2; ++k)
                if (std::isnan(step.velocity[k])) step.velocity[k] = steps.back().velocity[k];
            steps.push_back(step);
        }
    };
    for (const double time : reversal_times(context_.run())) {
        go_on_until(time);
        steps.push_back(
            {.time = time, .cause = WalkStep::Cause::reversal, .velocity = -steps.back().velocity});
    }
    go_on_until(std::numeric_limits<double>::infinity());
    return steps;
}

}  // namespace carom
