#include "panels/collision/pair_event.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/palette.h"

namespace carom {
namespace {

double dot(const Eigen::Array2d& a, const Eigen::Array2d& b) { return (a * b).sum(); }

double square_after(const Eigen::Array2d& apart, const Eigen::Array2d& moving, double time) {
    return (apart + time * moving).square().sum();
}

}  // namespace

double Meeting::square(double at) const {
    return at <= time ? free_square(at)
                      : square_after(place[1] - place[0], after[1] - after[0], at - time);
}

double Meeting::free_square(double at) const {
    return square_after(place[1] - place[0], before[1] - before[0], at - time);
}

double Meeting::other_root() const {
    const Eigen::Array2d moving = before[1] - before[0];
    return time - 2.0 * dot(place[1] - place[0], moving) / dot(moving, moving);
}

MeetingWatch::MeetingWatch(const PanelContext& context, const PanelSpec& spec)
    : context_(context),
      spec_(spec),
      last_(static_cast<std::size_t>(context.particles.count()), 0.0) {}

bool MeetingWatch::is_wanted(const Collision& collision) const {
    if (collision.second.is_side()) return false;
    if (spec_.of.empty()) return true;
    const std::int64_t a = spec_.of[0].particle.value(), b = spec_.of[1].particle.value();
    return (collision.first == a && collision.second == b) ||
           (collision.first == b && collision.second == a);
}

// Reversals part two flights as collisions do.
double MeetingWatch::flying_since(Eigen::Index particle, double now) const {
    double since = last_[static_cast<std::size_t>(particle)];
    for (const double at : reversal_times(context_.scene.run))
        if (at < now) since = std::max(since, at);
    return since;
}

double MeetingWatch::flying_until(double now, double next) const {
    for (const double at : reversal_times(context_.scene.run))
        if (at >= now) next = std::min(next, at);
    return next;
}

void MeetingWatch::meet(const Collision& collision) {
    const bool swapped = !spec_.of.empty() && spec_.of[0].particle.value() != collision.first;
    Meeting met;
    met.time = collision.time;
    met.particle = {collision.first, collision.second.particle()};
    met.place = {collision.first_position, collision.second_position};
    met.before = {collision.first_before, collision.second_before};
    met.after = {collision.first_after, collision.second_after};
    met.since = std::max(flying_since(collision.first, met.time),
                         flying_since(collision.second.particle(), met.time));
    met.until = flying_until(met.time, context_.scene.run.until);
    if (swapped || (spec_.of.empty() && collision.second.particle() < collision.first)) {
        std::swap(met.particle[0], met.particle[1]);
        std::swap(met.place[0], met.place[1]);
        std::swap(met.before[0], met.before[1]);
        std::swap(met.after[0], met.after[1]);
    }
    meeting_ = met;
}

void MeetingWatch::survey(const FrameInput& input) {
    if (is_over_) return;
    for (const Collision& collision : input.advanced.collisions) {
        const auto is_one_of_them = [&](Eigen::Index i) {
            return i == collision.first || i == collision.second;
        };
        if (meeting_ &&
            (is_one_of_them(meeting_->particle[0]) || is_one_of_them(meeting_->particle[1]))) {
            meeting_->until = std::min(meeting_->until, collision.time);
            is_over_ = true;
            return;
        }
        if (meeting_) continue;
        if (is_wanted(collision)) meet(collision);
        last_[static_cast<std::size_t>(collision.first)] = collision.time;
        if (collision.second.is_particle())
            last_[static_cast<std::size_t>(collision.second.particle())] = collision.time;
    }
}

const Meeting& MeetingWatch::meeting() const {
    if (meeting_) return *meeting_;
    Diagnostic error = spec_.place;
    const std::string pair =
        spec_.of.empty() ? "no two particles"
                         : fmt::format("particles {} and {} do not", spec_.of[0].particle.value(),
                                       spec_.of[1].particle.value());
    error.message = fmt::format("{} collide from time 0 to {}, the end of the run", pair,
                                context_.scene.run.until);
    error.hint =
        spec_.of.empty()
            ? "give a longer run, or let particles meet"
            : "give another pair in `of`, or none for the first that collides, or a longer "
              "run";
    throw SceneError({error});
}

Color color_of(const PanelContext& context, const Meeting& meeting, std::size_t k,
               const Theme& theme) {
    const auto species = [&](std::size_t one) {
        return static_cast<std::size_t>(context.particles.species[meeting.particle[one]]);
    };
    if (species(0) != species(1)) return species_color(context, species(k), theme);
    return kind_color(context.scene.gas.species.size() + k, theme);
}

std::string names_of(const PanelContext& context, const Meeting& meeting, const Theme& theme) {
    const auto name = [&](std::size_t k) {
        const Color color = color_of(context, meeting, k, theme);
        return disk_sample(color, theme) +
               colored(std::to_string(meeting.particle[k]), color, theme);
    };
    return "particles " + name(0) + " and " + name(1);
}

}  // namespace carom
