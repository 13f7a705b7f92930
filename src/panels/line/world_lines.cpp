#include "panels/line/world_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "panels/chosen.h"
#include "physics/mechanics.h"
#include "stats/paths/paths.h"

namespace carom {
namespace {

constexpr std::size_t most_lines = 150;  // more cannot be distinguished on a screen
constexpr double finest = 1.0 / 2000.0;  // of the memory: bends closer in time are merged

}  // namespace

bool stands_out(const PanelContext& context, Eigen::Index i) {
    return asked_trail(context.scene, context.particles, i).value_or(0.0) > 0.0 ||
           is_single_among_many(context.scene, context.particles, i);
}

WorldLines::WorldLines(const PanelContext& context, const LineMap& map, const GasColors& colors,
                       double memory)
    : context_(context),
      map_(map),
      colors_(colors),
      memory_(memory),
      changes_(velocity_changes(context.run())) {
    choose(map);
}

// Chooses beads evenly along the line, and those that the film is about.
void WorldLines::choose(const LineMap& map) {
    const std::size_t beads = map.order().size();
    const std::size_t stride = (beads + most_lines - 1) / most_lines;
    line_of_.assign(beads, -1);
    for (std::size_t k = 0; k < beads; ++k) {
        const Eigen::Index i = map.order()[k];
        if (k % stride != stride / 2 && !stands_out(context_, i)) continue;
        line_of_[static_cast<std::size_t>(i)] = static_cast<std::ptrdiff_t>(particles_.size());
        particles_.push_back(i);
    }
    bends_.resize(particles_.size());
}

void WorldLines::bend(std::size_t line, double time, double place, const Present& now) {
    std::deque<Bend>& bends = bends_[line];
    if (!bends.empty() && time - bends.back().time < finest * memory_) return;
    const double velocity =
        bends.empty() ? 0.0 : (place - bends.back().place) / (time - bends.back().time);
    bends.push_back(
        {time, place,
         colors_.shade(particles_[line], {std::abs(velocity), {velocity, 0.0}, now.mean_speed},
                       now.membership)});
}

void WorldLines::see(const FrameInput& input, const Eigen::ArrayXd& places,
                     const Eigen::ArrayXd& last) {
    const double now = input.tick.time;
    const Present present{mean_of_speeds(context_.particles, input.speed),
                          input.sample.membership.get()};
    const auto bend_at = [&](std::int32_t particle, double time, double x) {
        const std::ptrdiff_t line = line_of_[static_cast<std::size_t>(particle)];
        if (line < 0) return;
        bend(static_cast<std::size_t>(line), time, map_.place(particle, x, last[particle]),
             present);
    };
    for (std::size_t line = 0; line < count(); ++line)
        if (bends_[line].empty()) bend(line, now, places[particles_[line]], present);
    for (const Collision& collision : input.advanced.collisions) {
        bend_at(collision.first, collision.time, collision.first_position[0]);
        if (collision.second.is_particle())
            bend_at(collision.second.particle(), collision.time, collision.second_position[0]);
    }
    const bool turned =
        input.tick.phase == Phase::reversing && (reversals_.empty() || reversals_.back() < now);
    if (turned) reversals_.push_back(now);
    // Heating or a reversal changes all velocities, possibly between frames. Under gravity a line
    // bends all the time.
    const auto change = std::ranges::upper_bound(changes_, now);
    const double changed = change == changes_.begin() ? 0.0 : *std::prev(change);
    const bool falls = context_.box().surfaces.gravity[0] != 0.0;
    for (std::size_t line = 0; line < count(); ++line) {
        const Eigen::Index i = particles_[line];
        if (bends_[line].back().time < changed && !falls)
            bend(line, changed, places[i] - (now - changed) * input.sample.velocity(i, 0), present);
        if (falls) bend(line, now, places[i], present);
        while (bends_[line].size() > 1 && bends_[line][1].time < now - memory_)
            bends_[line].pop_front();
    }
}

std::vector<WorldLines::Bend> WorldLines::line(std::size_t line, const Bend& present) const {
    std::vector<Bend> bends(bends_[line].begin(), bends_[line].end());
    bends.push_back(present);
    return bends;
}

std::vector<double> WorldLines::reversals(double now) const {
    std::vector<double> recent;
    std::copy_if(reversals_.begin(), reversals_.end(), std::back_inserter(recent),
                 [&](double time) { return time >= now - memory_; });
    return recent;
}

}  // namespace carom
