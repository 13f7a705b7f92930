#include "panels/gas/marks/spotlights.h"

#include <algorithm>

#include "scene/film.h"

namespace carom {
namespace {

constexpr double dimmed = 0.35;  // what is left of a colour

}  // namespace

double share_of(const PanelContext& context, const Showing& time, const Tick& tick, bool is_still) {
    if (!context.in_film) return time.holds(tick.time) ? 1.0 : 0.0;
    const double share = opacity(time, context.film(), tick.frame, overlay_fade_seconds);
    return is_still && share > 0.0 ? 1.0 : share;
}

Spotlights::Spotlights(const PanelContext& context) : context_(context) {
    const Film& film = context.film();
    if (film.spotlights.empty()) return;
    const std::vector<Tick> ticks = timeline(context.scene);
    for (const Spotlight& spotlight : film.spotlights)
        lights_.push_back({showing(ticks, film, spotlight.time), Members(context, spotlight.on)});
}

void Spotlights::see(const Sample& sample) {
    for (Light& light : lights_) light.on.see(sample);
}

double Spotlights::share(const Light& light, const Tick& tick, bool is_still) const {
    return share_of(context_, light.time, tick, is_still);
}

// Where one spotlight follows another, particles that both are on stay as they are.
std::vector<float> Spotlights::light(const Tick& tick, bool is_still) const {
    double most = 0.0;
    for (const Light& light : lights_) most = std::max(most, share(light, tick, is_still));
    if (most <= 0.0) return {};
    std::vector<double> on(static_cast<std::size_t>(context_.particles.count()), 0.0);
    for (const Light& light : lights_) {
        const double its = share(light, tick, is_still);
        for (const std::vector<Eigen::Index>& list : light.on.lists())
            for (const Eigen::Index i : list) {
                double& own = on[static_cast<std::size_t>(i)];
                own = std::max(own, its);
            }
    }
    std::vector<float> kept;
    kept.reserve(on.size());
    for (const double own : on)
        kept.push_back(static_cast<float>(1.0 - (1.0 - dimmed) * (most - own)));
    return kept;
}

std::vector<Spotlights::Ring> Spotlights::rings(const Tick& tick, bool is_still) const {
    std::vector<Ring> rings;
    for (const Light& light : lights_) {
        const double its = share(light, tick, is_still);
        if (its <= 0.0) continue;
        for (const std::vector<Eigen::Index>& list : light.on.lists())
            if (list.size() == 1) rings.push_back({list.front(), its});
    }
    return rings;
}

}  // namespace carom
