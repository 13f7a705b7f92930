#include "panels/collision/pair_collision.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "panels/chosen.h"
#include "panels/plot/layers.h"
#include "physics/gas.h"
#include "util/text.h"

namespace carom {
namespace {

double square_after(const Vec& apart, const Vec& moving, double time) {
    return square(apart + time * moving);
}

// The times at which an event of the run changes the velocity or the place of a particle.
std::vector<double> interruptions(const Run& run, Eigen::Index particle) {
    std::vector<double> times = velocity_changes(run);
    for (const RunEvent& event : run.events)
        if (const auto* nudge = perturbation_of(event);
            nudge != nullptr && nudge->particle == particle)
            times.push_back(event.at);
    return times;
}

}  // namespace

double PairCollision::square(double at) const {
    return at <= time ? free_square(at)
                      : square_after(place[1] - place[0], after[1] - after[0], at - time);
}

double PairCollision::free_square(double at) const {
    return square_after(place[1] - place[0], before[1] - before[0], at - time);
}

PairCollision::Parabola PairCollision::parabola() const {
    const Vec moving = before[1] - before[0];
    const Vec apart = place[1] - place[0] - (time - since) * moving;
    return {dot(apart, apart), dot(apart, moving), dot(moving, moving)};
}

double PairCollision::other_root() const {
    const Vec moving = before[1] - before[0];
    return time - 2.0 * dot(place[1] - place[0], moving) / dot(moving, moving);
}

PairCollisionWatch::PairCollisionWatch(const PanelContext& context, const PanelSpec& spec)
    : context_(context),
      spec_(spec),
      last_(static_cast<std::size_t>(context.particles.count()), 0.0) {}

bool PairCollisionWatch::is_wanted(const Collision& collision) const {
    if (collision.second.is_surface()) return false;
    if (spec_.of.empty()) return true;
    const std::int64_t a = spec_.of[0].particle.value(), b = spec_.of[1].particle.value();
    return (collision.first == a && collision.second == b) ||
           (collision.first == b && collision.second == a);
}

// Reversals, heating and perturbations end a free flight as collisions do.
double PairCollisionWatch::flying_since(Eigen::Index particle, double now) const {
    double since = last_[static_cast<std::size_t>(particle)];
    for (const double at : interruptions(context_.run(), particle))
        if (at < now) since = std::max(since, at);
    return since;
}

double PairCollisionWatch::flying_until(Eigen::Index particle, double now) const {
    double next = context_.run().until;
    for (const double at : interruptions(context_.run(), particle))
        if (at >= now) next = std::min(next, at);
    return next;
}

void PairCollisionWatch::meet(const Collision& collision) {
    const bool swapped = !spec_.of.empty() && spec_.of[0].particle.value() != collision.first;
    PairCollision met;
    met.time = collision.time;
    met.particle = {collision.first, collision.second.particle()};
    met.place = {collision.first_position, collision.second_position};
    met.before = {collision.first_before, collision.second_before};
    met.after = {collision.first_after, collision.second_after};
    met.since = std::max(flying_since(collision.first, met.time),
                         flying_since(collision.second.particle(), met.time));
    met.until = std::min(flying_until(collision.first, met.time),
                         flying_until(collision.second.particle(), met.time));
    if (swapped || (spec_.of.empty() && collision.second.particle() < collision.first)) {
        std::swap(met.particle[0], met.particle[1]);
        std::swap(met.place[0], met.place[1]);
        std::swap(met.before[0], met.before[1]);
        std::swap(met.after[0], met.after[1]);
    }
    found_ = met;
}

void PairCollisionWatch::survey(const FrameInput& input) {
    if (is_over_) return;
    for (const Collision& collision : input.advanced.collisions) {
        const auto is_one_of_them = [&](Eigen::Index i) {
            return i == collision.first || i == collision.second;
        };
        if (found_ &&
            (is_one_of_them(found_->particle[0]) || is_one_of_them(found_->particle[1]))) {
            found_->until = std::min(found_->until, collision.time);
            is_over_ = true;
            return;
        }
        if (found_) continue;
        if (is_wanted(collision)) meet(collision);
        last_[static_cast<std::size_t>(collision.first)] = collision.time;
        if (collision.second.is_particle())
            last_[static_cast<std::size_t>(collision.second.particle())] = collision.time;
    }
}

const PairCollision& PairCollisionWatch::collision() const {
    if (found_) return *found_;
    const std::string pair =
        spec_.of.empty() ? "no two particles"
                         : fmt::format("particles {} and {} do not", spec_.of[0].particle.value(),
                                       spec_.of[1].particle.value());
    refuse(
        spec_.place,
        fmt::format("{} collide from time 0 to {}, the end of the run", pair, context_.run().until),
        spec_.of.empty()
            ? "give a longer run, or let particles collide"
            : "give another pair in `of`, or none for the first that collides, or a longer "
              "run");
}

plot::Role role_of(const PanelContext& context, const PairCollision& pair, std::size_t k) {
    const auto species = [&](std::size_t one) {
        return static_cast<std::size_t>(context.particles.species[pair.particle[one]]);
    };
    if (species(0) != species(1)) return species_role(context, species(k));
    return choice_role(context, {}, k);
}

Color color_of(const PanelContext& context, const PairCollision& pair, std::size_t k,
               const Theme& theme) {
    return plot::color_of(role_of(context, pair, k), theme);
}

std::optional<std::array<std::string, 2>> own_names(const PanelContext& context,
                                                    const PairCollision& pair) {
    std::array<std::string, 2> names;
    for (std::size_t k = 0; k < 2; ++k) {
        const int species = context.particles.species[pair.particle.at(k)];
        if ((context.particles.species == species).count() > 1) return {};
        names.at(k) = context.species()[static_cast<std::size_t>(species)].name;
        if (names.at(k).empty()) return {};
    }
    return names;
}

plot::Text names_of(const PanelContext& context, const PairCollision& pair) {
    const auto own = own_names(context, pair);
    const auto name = [&](std::size_t k) {
        return plot::named(own ? own->at(k) : std::to_string(pair.particle[k]),
                           role_of(context, pair, k), plot::Swatch::disk);
    };
    return plot::text_of(context.language(),
                         own ? Phrase{"{} and {}"} : Phrase{"particles {} and {}"},
                         {name(0), name(1)});
}

std::string plain_names_of(const PanelContext& context, const PairCollision& pair) {
    const Language language = context.language();
    const auto own = own_names(context, pair);
    const auto name = [&](std::size_t k) {
        const std::string number = std::to_string(pair.particle.at(k));
        return own ? fmt::format("{} ({})", number, own->at(k)) : number;
    };
    return capitalised(say(language, "particles {} and {}", name(0), name(1)));
}

}  // namespace carom
