#include "films/cost/panel_seconds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/chosen.h"
#include "panels/correlations/lag_meter.h"
#include "panels/registry.h"
#include "physics/placement/draws.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {
namespace {

// CPU seconds, measured as those in work.cpp.
constexpr double of_particle = 0.01e-6;    // of a frame that any panel sees
constexpr double of_open_lag = 0.04e-6;    // of a flight that goes on in a picture of a film
constexpr double of_pair = 0.14e-6;        // of near particles, for each flight of either
constexpr double of_neighbours = 0.25e-6;  // of a particle whose neighbours are found

double largest_distance(const Scene& scene, const PanelWork& work, const Particles& gas) {
    constexpr double usual_diameters = 5.0;
    const double most = 0.5 * scene.gas.box.longest_side();
    const double diameter = gas.count() > 0 ? 2.0 * gas.radius.maxCoeff() : 0.0;
    return work.reach.value_or(diameter > 0.0 ? std::min(most, usual_diameters * diameter) : most);
}

// The pairs near enough that their flights are followed, for each particle.
double pairs_near(const Box& box, double particles, double distance) {
    constexpr double margin = 1.35;  // for the way that both fly meanwhile
    const double reach = margin * distance;
    const double share = content_of_ball(reach, box.dimension) / box.content();
    return particles * std::min(1.0, share);
}

// Of a pair correlation, whose flights are cut whenever fast particles have flown half of the
// largest distance (stats/paths/pair_correlation.cpp), at frames of a window, and where it is read.
double pair_seconds(const Scene& scene, const PanelSpec& panel, const PanelWork& work,
                    double frames, double pictures, double flights) {
    constexpr double fast = 4.0, way = 0.5;
    const auto [gas, sample] = draw_gas(scene.gas);
    const auto particles = static_cast<double>(gas.count());
    const double to = largest_distance(scene, work, gas);
    const double speed = std::sqrt(sample.velocity.square().rowwise().sum().mean());
    const bool is_window = panel.over && panel.over->since == Over::Since::window;
    const double cuts = is_window ? frames : scene.run.until * fast * speed / (way * to) + pictures;
    return (flights + cuts * particles) * pairs_near(scene.gas.box, particles, to) * of_pair;
}

// The collisions of the particles that a panel chooses, as a share of those of all: in kinetic
// theory they meet others in proportion to the distance of contact and the relative speed.
double share_of(const PanelSpec& panel, const Particles& gas) {
    const Eigen::ArrayXd inverse_mass = gas.inverse_mass;
    Eigen::ArrayXd meets = (inverse_mass + inverse_mass.mean()).sqrt();
    if (gas.radius.maxCoeff() > 0.0) meets *= gas.radius + gas.radius.mean();
    const auto is_chosen = [&](const Chosen& chosen, Eigen::Index i) {
        if (chosen.particle) return *chosen.particle == i;
        return !chosen.species || gas.species[i] == static_cast<int>(*chosen.species);
    };
    double sum = 0.0;
    for (const Chosen& chosen : choices(panel))
        for (Eigen::Index i = 0; i < gas.count(); ++i)
            if (is_chosen(chosen, i)) sum += meets[i];
    return sum / std::max(meets.sum(), std::numeric_limits<double>::min());
}

// A flight for each lag, from 0.6 to 18 megabytes of flights within the longest lag, which are read
// at as many places as there are lags.
double seconds_of_lag(double bytes) { return 0.06e-6 + 0.115e-6 * std::log1p(1e-6 * bytes); }

// Of a panel that averages over lags. Where it is read, the flights that go on are added.
double lag_seconds(const Scene& scene, const PanelSpec& panel, const PanelWork& work,
                   double pictures, double flights) {
    constexpr double of_piece = 72.0;  // bytes
    const auto [gas, sample] = draw_gas(scene.gas);
    const double share = share_of(panel, gas);
    const double kept = flights * work.longest_lag / scene.run.until * of_piece;
    return share * lag_count *
           (flights * seconds_of_lag(share * kept) +
            pictures * static_cast<double>(gas.count()) * of_open_lag);
}

double seconds_of_flight(PanelWork::Flights flights) {
    using enum PanelWork::Flights;
    if (flights == followed) return 0.28e-6;
    if (flights == displaced) return 0.2e-6;
    return flights == recorded ? 0.1e-6 : 0.0;
}

}  // namespace

double panel_seconds(const Scene& scene, const PanelSpec& panel, double frames, double pictures,
                     const RunCounts& counts) {
    const auto particles = static_cast<double>(total_count(scene.gas));
    const double seen = frames * particles;
    const double flights = 2.0 * counts.collisions.value_or(counts.events) + particles;
    const PanelWork work = work_of(panel, scene.run);
    const double choices = std::max<double>(
        1.0, static_cast<double>(panel.of.size() + places_of(panel).regions.size()));
    const double seconds = seen * of_particle * choices;
    if (work.flights == PanelWork::Flights::lags)
        return seconds + lag_seconds(scene, panel, work, pictures, flights);
    if (work.flights == PanelWork::Flights::pairs)
        return seconds + pair_seconds(scene, panel, work, frames, pictures, flights);
    if (work.finds_neighbours) return seconds + seen * of_neighbours;
    return seconds + flights * seconds_of_flight(work.flights);
}

std::string reduces_panel(const PanelSpec& panel, const Run& run) {
    const PanelWork work = work_of(panel, run);
    if (work.flights == PanelWork::Flights::lags)
        return "`lags`, `run.until` or the particles, or choose some of them in `of`";
    if (work.flights == PanelWork::Flights::pairs)
        return "`to` of the panel, `run.until` or the particles";
    return "`run.until` or the particles";
}

}  // namespace carom
