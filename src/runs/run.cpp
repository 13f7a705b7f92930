#include "runs/run.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "panels/precision.h"
#include "panels/surfaces/surface_words.h"
#include "physics/reversal/mirrored_events.h"
#include "physics/sample_times.h"
#include "physics/ways_back.h"
#include "runs/run_meters.h"
#include "stats/paths/time_averages.h"
#include "util/fingerprint.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"
#include "util/threads/relay.h"

namespace carom {
namespace {

// Counts the events up to each reversal and up to the return, and records the return distance.
class ReversalWatch {
  public:
    ReversalWatch(const Run& run, Simulation& simulation) {
        std::vector<double> returns;
        for (const WayBack& way : ways_back(run.events)) {
            const double home = std::min(2.0 * way.begin, way.end);
            times_.push_back({way.begin, reports_.size(), false});
            if (home <= run.until) times_.push_back({home, reports_.size(), true});
            reports_.push_back({.at = way.begin, .home = home});
            returns.push_back(home);
        }
        std::ranges::stable_sort(times_, {}, &WatchedTime::time);
        simulation.measure_return(returns, true);
    }

    /// The next time at which look() must be called; infinite after the last one.
    double next_time() const {
        return next_ < times_.size() ? times_[next_].time : std::numeric_limits<double>::infinity();
    }

    /// To be called at next_time().
    void look(const AdvanceResult& advanced) {
        for (const double now = next_time(); next_time() == now; ++next_) {
            const WatchedTime& watched = times_[next_];
            ReversalReport& report = reports_[watched.reversal];
            if (!watched.is_return) {
                report.events_out = events_of(advanced.counts);
                continue;
            }
            report.events_back = events_of(advanced.counts) - report.events_out;
            if (alone_before(watched.time)) report.distance = advanced.return_distance;
        }
    }

    const std::vector<ReversalReport>& reports() const { return reports_; }

  private:
    struct WatchedTime {
        double time;
        std::size_t reversal;
        bool is_return;
    };

    bool alone_before(double time) const {
        return std::ranges::count_if(
                   reports_, [=](const ReversalReport& other) { return other.at < time; }) == 1;
    }

    std::vector<WatchedTime> times_;
    std::vector<ReversalReport> reports_;
    std::size_t next_ = 0;
};

// Mean, spread and last value of the positions of movable surfaces, over the samples.
class SurfaceWatch {
  public:
    explicit SurfaceWatch(const Box& box) : box_(box), names_(box.surfaces.names()) {}

    void see(const std::vector<SurfaceState>& states) {
        const auto count = static_cast<std::size_t>(box_.surfaces.first_obstacle());
        if (states.empty()) return;
        sums_.resize(count);
        ++seen_;
        for (std::size_t k = 0; k < count; ++k) {
            Sums& sums = sums_[k];
            sums.last = place_of_surface(box_, states, k);
            const double off = sums.last - sums.mean;
            sums.mean += off / static_cast<double>(seen_);
            sums.squares += off * (sums.last - sums.mean);
        }
    }

    std::vector<SurfaceReport> reports(const std::vector<SurfaceState>& states) const {
        std::vector<SurfaceReport> reports;
        for (std::size_t k = 0; k < states.size(); ++k) {
            if (!box_.has_surface(k)) continue;
            SurfaceReport& report = reports.emplace_back(SurfaceReport{names_[k], states[k]});
            if (states[k].motion)
                report.position = {
                    sums_[k].mean,
                    std::sqrt(std::max(0.0, sums_[k].squares / static_cast<double>(seen_))),
                    states[k].motion->place};
        }
        return reports;
    }

  private:
    struct Sums {
        double mean = 0.0, squares = 0.0, last = 0.0;
    };
    Box box_;
    std::vector<std::string> names_;
    std::vector<Sums> sums_;
    std::int64_t seen_ = 0;
};

// The fingerprint of the bytes of all positions and velocities. These are little-endian on all
// machines that carom supports.
std::string fingerprint_of(const Simulation& simulation) {
    static_assert(std::endian::native == std::endian::little);
    GrowingFingerprint all;
    const auto add = [&](const Eigen::ArrayXXd& numbers) {
        all.add({reinterpret_cast<const char*>(numbers.data()),
                 static_cast<std::size_t>(numbers.size()) * sizeof(double)});
    };
    add(simulation.sample_of_positions().position);
    add(simulation.sample_of_velocities().velocity);
    return all.digits();
}

bool can_be_followed(const Simulation& simulation, const RunTakers& take, bool measures) {
    constexpr Eigen::Index least = 1'000;  // below, looking at all particles takes no time
    return !take.sample && !take.collisions && !measures && simulation.particles().count() >= least;
}

// Chooses how far a run advances in one step, so that only a few of its collisions are in memory at
// a time.
class StepLength {
  public:
    /// The end of the next step on the way to `time`.
    double next(double now, double time) const {
        if (span_ <= 0.0) return time;
        return std::min(time, std::max(now + span_, std::nextafter(now, time)));
    }

    /// Adapts the step to the rate in the last step, of `length` with so many collisions. Growth is
    /// limited, because a gas at rest may begin to move.
    void see(double length, std::size_t collisions) {
        constexpr double aim = 4096.0, most_growth = 2.0;
        const double per_time = static_cast<double>(collisions) / length;
        const double wanted = per_time > 0.0 ? aim / per_time : most_growth * length;
        span_ = std::min(wanted, most_growth * length);
    }

    void begin(double length) { span_ = length; }

  private:
    double span_ = 0.0;  ///< 0: no limit
};

class PhysicsRun {
  public:
    PhysicsRun(StartedScene& started, const Stopwatch& watch, const RunTakers& take,
               const RunCallbacks& on_progress)
        : units_(started.scene.units),
          run_(started.scene.run),
          simulation_(std::move(started.simulation)),
          statistics_(simulation_.box(), simulation_.particles(),
                      static_cast<int>(started.scene.gas.species.size()), sample_count(run_)),
          averages_(simulation_.box(), simulation_.particles(),
                    static_cast<int>(started.scene.gas.species.size()), velocity_changes(run_)),
          reversals_(run_, simulation_),
          surfaces_(simulation_.box()),
          take_(take),
          following_(can_be_followed(simulation_, take, !started.scene.measure.empty())),
          on_progress_(on_progress),
          watch_(watch) {
        constexpr Eigen::Index enough = 1'000;  // with fewer a thread does not pay
        if (take_.aside && simulation_.particles().count() >= enough)
            aside_.emplace([](const Work& work) { work(); });
        advanced_.surfaces = simulation_.surfaces();
        for (const RunEvent& event : run_.events) events_.push_back(event.at);
        for (const MirroredEvent& mirrored : mirrored_events(run_)) events_.push_back(mirrored.at);
        std::ranges::sort(events_);
        while (!events_.empty() && events_.front() <= 0.0) events_.pop_front();
        events_.erase(std::unique(events_.begin(), events_.end()), events_.end());
        averages_.see(simulation_.sample(), {});
        membership_ = simulation_.membership();
        if (!started.scene.measure.empty())
            meters_.emplace(started.scene, simulation_.particles(), simulation_.sample());
        if (!sees_samples()) simulation_.forget_sample();
        simulation_.record_collisions(true);
        step_.begin(first_step * run_.until);
        seconds_.prepare = watch.wall();
        if (on_progress_.started) on_progress_.started();
    }

    RunReport run() {
        const std::int64_t samples = sample_count(run_);
        for (std::int64_t index = 0; index < samples; ++index) {
            go_on_to(sample_time(run_, index));
            see_sample();
        }
        if (aside_) aside_->finish();
        seconds_.samples += taking_seconds_;
        seconds_.total = watch_.wall();
        RunReport report{simulation_.particles().count(),
                         simulation_.bits(),
                         samples,
                         summary(),
                         advanced_.counts,
                         reversals_.reports(),
                         seconds_,
                         surfaces_.reports(simulation_.surfaces())};
        const bool is_heated = std::ranges::any_of(run_.events, heats);
        if (!report.surfaces.empty() || is_heated) {
            report.account = simulation_.energy_account();
            report.summary.largest_energy_error = std::nullopt;
        }
        if (meters_) report.readings = meters_->readings();
        report.state = fingerprint_of(simulation_);
        report.units = units_;
        return report;
    }

  private:
    using Work = std::function<void()>;

    // Averages over time, which are exact, take the place of those over samples.
    RunSummary summary() const {
        RunSummary summary = statistics_.summary(advanced_);
        const TimeAverages::Values averages = averages_.averages();
        for (std::size_t k = 0; k < summary.species.size(); ++k) {
            SpeciesMeans& species = summary.species[k];
            if (species.energy) species.energy = averages.energy[k];
            if (species.speed) species.speed = averages.speed[k];
        }
        if (summary.temperature) summary.temperature = averages.temperature;
        return summary;
    }

    static constexpr double first_step = 1e-6;  // fraction of the run, while the rate is unknown

    // Does work here or on the other thread, after all work that was given before.
    void give(Work work) {
        Work timed = [this, work = std::move(work)] {
            const Stopwatch watch;
            work();
            taking_seconds_ += watch.wall();
        };
        if (aside_)
            aside_->send(std::move(timed));
        else
            timed();
    }

    // The result of the last advance without references to data that the next advance invalidates,
    // for work that may run later.
    AdvanceResult lasting() const {
        AdvanceResult advanced = advanced_;
        advanced.collisions = {};
        advanced.velocities.reset();
        return advanced;
    }

    // Whether whole samples are needed.
    bool sees_samples() const { return take_.sample || meters_; }

    void see_sample() {
        if (sees_samples())
            take_sample();
        else
            see_parts();
        surfaces_.see(advanced_.surfaces);
    }

    void take_sample() {
        const auto take = [this](const Sample& sample, const AdvanceResult& advanced) {
            statistics_.see(sample, advanced);
            if (meters_) meters_->see(sample, advanced);
            if (take_.sample) take_.sample(simulation_.particles(), sample, advanced.surfaces);
        };
        if (!aside_) return give([&] { take(simulation_.sample(), advanced_); });
        give([take, sample = simulation_.sample(), advanced = lasting()] {
            take(sample, advanced);
        });
    }

    // Waits until all work that was given is done.
    void settle() {
        if (aside_) aside_->settle();
    }

    // Takes the positions and the velocities of a sample one after the other, so that only one of
    // the two is in memory. Whether positions are wanted depends on the samples before.
    void see_parts() {
        settle();
        if (statistics_.wants_positions(advanced_)) {
            give([this, sample = simulation_.sample_of_positions(), advanced = lasting()] {
                statistics_.see_positions(sample, advanced);
            });
            settle();
        }
        const bool are_known = advances_ == 1 && advanced_.velocities;
        if (are_known && see_changes()) return;
        following_.see(advances_ == 0 || advanced_.velocities.has_value());
        simulation_.follow_velocities(following_.is_on());
        give([this, sample = simulation_.sample_of_velocities(), advanced = lasting(),
              is_followed = following_.is_on()] {
            statistics_.see_velocities(sample, advanced, is_followed);
        });
    }

    bool see_changes() {
        const Stopwatch watch;
        const bool are_seen =
            statistics_.see_changes({.time = now_, .membership = simulation_.membership()},
                                    *advanced_.velocities, advanced_);
        seconds_.samples += watch.wall();
        return are_seen;
    }

    void reach(double now) const {
        if (on_progress_.reached) on_progress_.reached(now);
    }

    // Advances to `time`, stopping at reversals and returns on the way.
    void go_on_to(double time) {
        for (advances_ = 0; now_ < time; ++advances_) {
            throw_if_interrupted();
            const Stopwatch watch;
            const double before = now_;
            now_ = step_.next(before, std::min({time, reversals_.next_time(), next_event()}));
            advanced_ = simulation_.advance_to(now_, [this](double now) { reach(now); });
            seconds_.simulate += watch.wall();
            reach(now_);
            hand_on(now_ - before);
            if (now_ == reversals_.next_time()) reversals_.look(advanced_);
            if (now_ == next_event()) see_event(now_ == time);
        }
    }

    double next_event() const {
        return events_.empty() ? std::numeric_limits<double>::infinity() : events_.front();
    }

    // The gas may have a single pressure from an event on. Instruments are read there, too, as in
    // films and figures.
    void see_event(bool is_sample) {
        events_.pop_front();
        give([this, now = now_, advanced = lasting()] { statistics_.see_event(now, advanced); });
        if (meters_ && !is_sample)
            give([this, sample = simulation_.sample(), advanced = lasting()] {
                meters_->see(sample, advanced);
            });
    }

    // Passes on the collisions of a step of this length.
    void hand_on(double length) {
        const std::span<const Collision> collisions = advanced_.collisions;
        step_.see(length, collisions.size());
        const auto take = [this](const Sample& sample, std::span<const Collision> its) {
            averages_.see(sample, its);
            if (meters_) meters_->take(its);
            if (take_.collisions && !its.empty()) take_.collisions(simulation_.particles(), its);
        };
        Sample sample{.time = now_, .membership = simulation_.membership()};
        const bool is_changed = std::exchange(membership_, sample.membership) != sample.membership;
        if (averages_.needs_samples() || is_changed) sample = simulation_.sample();
        if (!aside_) return give([&] { take(sample, collisions); });
        give([take, sample = std::move(sample),
              all = std::vector(collisions.begin(), collisions.end())] { take(sample, all); });
    }

    RunSeconds seconds_;
    UnitSystem units_;
    Run run_;
    Simulation simulation_;
    RunStatistics statistics_;
    TimeAverages averages_;
    std::shared_ptr<const Membership> membership_;  ///< in the last sample of the averages
    ReversalWatch reversals_;
    SurfaceWatch surfaces_;
    StepLength step_;
    std::deque<double> events_;  ///< times still to come
    const RunTakers& take_;
    VelocityFollowing following_;
    std::optional<RunMeters> meters_;  ///< if the scene has instruments
    const RunCallbacks& on_progress_;
    const Stopwatch& watch_;
    AdvanceResult advanced_;
    int advances_ = 0;  ///< since the last sample
    double now_ = 0.0;
    double taking_seconds_ = 0.0;       ///< of given work; changed only by the thread that does it
    std::optional<Relay<Work>> aside_;  ///< last member, destroyed first: its work uses all others
};

}  // namespace

std::int64_t events_of(const CollisionCounts& counts) { return counts.particle + counts.wall; }

RunReport run_physics(const Scene& scene, const RunTakers& take, const RunCallbacks& on_progress) {
    const Stopwatch watch;
    StartedScene started = start_scene(scene, on_progress.start);
    RunReport report;
    with_places_of_errors(started.scene,
                          [&] { report = PhysicsRun(started, watch, take, on_progress).run(); });
    return report;
}

}  // namespace carom
