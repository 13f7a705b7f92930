#include "films/cost/trial_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "panels/panel_set.h"
#include "panels/precision.h"
#include "panels/registry.h"
#include "physics/collision_error.h"
#include "physics/placement/draws.h"
#include "physics/theory/law.h"
#include "scene/panel_kind.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

constexpr std::int64_t most_particles_tried = 20'000;

// Arithmetic with more bits than a double is some hundred times slower.
std::int64_t collisions_tried(const Run& run, double share) {
    constexpr double least = 500.0;
    const double most = run.bits == bits_of_double ? 300e3 : 5e3;
    return static_cast<std::int64_t>(std::max(least, share * most));
}

// Thrown to end a trial without collisions, in which particles only fly from cell to cell.
struct TooManyFlights {};

// What a trial has counted, up to a simulated time.
struct Counted {
    double collisions = 0.0, looks = 0.0;
    double time = 0.0;
    std::optional<Ties> ties = {};
    std::vector<MeanSpeeds> speeds = {};
};

MeanSpeeds mean_speeds(const Particles& particles, const Sample& sample, std::size_t species) {
    MeanSpeeds mean{sample.time, std::vector<double>(species)};
    std::vector<double> count(species);
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const auto its = static_cast<std::size_t>(particles.species[i]);
        mean.of_species[its] += sample.velocity.row(i).matrix().norm();
        ++count[its];
    }
    for (std::size_t k = 0; k < species; ++k) mean.of_species[k] /= std::max(1.0, count[k]);
    return mean;
}

// Advances in steps, so that the collisions of a long run do not accumulate in memory, and stops
// at the times that panels show.
std::vector<double> times_of(const Run& run, const std::vector<PanelSpec>& panels) {
    constexpr int steps = 64;
    std::set<double> times;
    for (int k = 0; k <= steps; ++k) times.insert(run.until * k / steps);
    for (const PanelSpec& panel : panels)
        if (panel.at) times.insert(*panel.at);
    return {times.begin(), times.end()};
}

// The number of bits of a trial that ended before they were found.
int expected_bits(const Scene& scene, double collisions) {
    const auto [particles, sample] = draw_gas(scene.gas);
    const double each =
        2.0 * collisions / static_cast<double>(std::max<Eigen::Index>(1, particles.count()));
    const Law growth =
        law(BoxedGas(scene.gas.box, scene.run.events, particles, sample), LawOf::error_growth);
    const double rate = growth ? growth.value : 1.0;
    const std::vector<double> turns = reversal_times(scene.run);
    const double share = turns.empty() ? 1.0 : std::min(1.0, turns.front() / scene.run.until);
    const double lost = each * share * rate;
    return static_cast<int>(
        std::clamp(64.0 + lost + 2.0 * std::sqrt(lost), double(least_bits), double(most_bits)));
}

// Runs the beginning of `tried`, whose collisions are limited.
class Trial {
  public:
    Trial(const Scene& scene, std::span<const PanelSpec> panels, bool is_cut, double share)
        : scene_(scene),
          panels_(panels.begin(), panels.end()),
          is_cut_(is_cut),
          most_looks_(std::max(20.0, 10e3 * share)) {}

    RunCounts counts() {
        try {
            run();
        } catch (const TooManyCollisions& error) {
            if (!is_cut_) throw;
            const CollisionsSeen& seen = error.seen();
            const double tried = seen.begin + scene_.run.equilibrate;
            if (seen.begin > 0.0) counted_.ties = seen.ties;
            return extrapolated(static_cast<double>(seen.most), tried);
        } catch (const TooManyFlights&) {
            RunCounts counts = extrapolated(counted_.collisions, counted_.time);
            counts.collisions.reset();
            return counts;
        }
        return {counted_.collisions, events(), bits_, counted_.ties, false, counted_.speeds};
    }

  private:
    double events() const {
        constexpr double events_between_looks = 4096.0;  // EventLoop::advance()
        return std::max(counted_.collisions, events_between_looks * counted_.looks);
    }

    // At the rates of a trial with so many collisions that ended after `tried` units of time.
    RunCounts extrapolated(double collisions, double tried) const {
        const double longer = scene_.run.until / std::max(tried, 1e-9 * scene_.run.until);
        RunCounts counts{collisions * longer,
                         std::max(collisions, events()) * longer,
                         bits_,
                         counted_.ties,
                         true,
                         counted_.speeds};
        if (!scene_.run.bits && bits_ == bits_of_double && !reversal_times(scene_.run).empty())
            counts.bits = expected_bits(scene_, *counts.collisions);
        return counts;
    }

    void run() {
        Simulation simulation = start_run(scene_.gas, scene_.run);
        bits_ = simulation.bits();
        simulation.record_collisions(!panels_.empty());
        const Particles particles = simulation.particles();
        PanelSet panels(scene_, particles, simulation.sample(), 1, panels_);
        survey(panels, simulation);
        fix_axes(panels);
    }

    // Bars of a mean over several seeds hold more particles than those of this run.
    void fix_axes(PanelSet& panels) {
        std::vector<Panel*> shown;
        for (std::size_t k = 0; k < panels_.size(); ++k)
            if (panels_[k].seeds == 1) shown.push_back(panels.panels()[k].panel.get());
        all_made(shown, [](Panel* panel) {
            panel->fix_axes();
            return true;
        });
    }

    void survey(PanelSet& panels, Simulation& simulation) {
        const auto look = [&](double now) {
            counted_.time = std::max(counted_.time, now);
            if (++counted_.looks > most_looks_) throw TooManyFlights{};
        };
        int frame = 0;
        for (const double time : times_of(scene_.run, panels_)) {
            const AdvanceResult advanced = simulation.advance_to(time, look);
            panels.survey({.frame = frame++, .time = time}, simulation.sample(), advanced);
            counted_.collisions =
                static_cast<double>(advanced.counts.particle + advanced.counts.wall);
            counted_.time = time;
            counted_.ties = advanced.counts.ties;
            counted_.speeds.push_back(mean_speeds(simulation.particles(), simulation.sample(),
                                                  scene_.gas.species.size()));
        }
    }

    const Scene& scene_;
    std::vector<PanelSpec> panels_;
    bool is_cut_;
    double most_looks_;  // one for each some thousand events: seconds in all
    Counted counted_;
    int bits_ = bits_of_double;
};

bool is_to_try(const PanelSpec& spec) { return spec.test || kind_of(spec).can(Ability::pair); }

}  // namespace

std::optional<RunCounts> try_run(const Scene& scene, std::span<const PanelSpec> panels,
                                 double share) {
    const std::int64_t particles = total_count(scene.gas);
    if (particles > most_particles_tried || scene.run.time_step) return std::nullopt;
    Scene tried = scene;
    const std::int64_t ceiling = collision_ceiling(scene.run, particles);
    tried.run.most_collisions = std::min(ceiling, collisions_tried(scene.run, share));
    std::optional<RunCounts> counts;
    with_places_of_errors(scene, [&] {
        counts = Trial(tried, panels, *tried.run.most_collisions < ceiling, share).counts();
    });
    return counts;
}

RunCounts counts_of(const Scene& scene, std::span<const PanelSpec> panels, double share) {
    if (const std::optional<RunCounts> counts = try_run(scene, panels, share)) return *counts;
    RunCounts counts{.bits = scene.run.bits.value_or(bits_of_double)};
    const auto [particles, sample] = draw_gas(scene.gas);
    counts.speeds = {mean_speeds(particles, sample, scene.gas.species.size())};
    const BoxedGas gas(scene.gas.box, scene.run.events, particles, sample);
    if (const Law rate = law(gas, LawOf::collision_rate))
        counts.collisions =
            0.5 * static_cast<double>(particles.count()) * rate.value * scene.run.until;
    const double steps = scene.run.time_step ? scene.run.until / *scene.run.time_step : 0.0;
    counts.events =
        std::max(counts.collisions.value_or(0.0), steps * static_cast<double>(particles.count()));
    return counts;
}

std::vector<PanelSpec> panels_to_try(const std::vector<PanelSpec>& film) {
    std::vector<PanelSpec> specs;
    std::ranges::copy_if(film, std::back_inserter(specs), is_to_try);
    return specs;
}

std::vector<PanelSpec> panels_to_try(const std::vector<FigureSpec>& figures) {
    std::vector<PanelSpec> specs;
    for (const FigureSpec& figure : figures)
        if (figure.compare.empty() && is_to_try(figure.panel)) specs.push_back(figure.panel);
    return specs;
}

}  // namespace carom
