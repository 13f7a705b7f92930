#include "app/report/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>

#include "app/simulate.h"
#include "panels/precision.h"
#include "util/interrupt.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// Adds the time of its life to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum) {}
    ~Stopwatch() { sum_ += seconds_since(begun_); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& sum_;
    Clock::time_point begun_ = Clock::now();
};

std::int64_t events(const CollisionCounts& counts) { return counts.particle + counts.wall; }

// Counts events up to each reversal and the return, and takes the return distance.
class ReversalWatch {
  public:
    ReversalWatch(const Run& run, Simulation& simulation) {
        std::vector<double> returns;
        for (const double time : reversal_times(run)) {
            add(time, run.until);
            returns.push_back(2.0 * time);
        }
        std::stable_sort(marks_.begin(), marks_.end(),
                         [](const Mark& a, const Mark& b) { return a.time < b.time; });
        simulation.measure_return(returns, true);
    }

    /// When to look next; infinite after the last time.
    double next_time() const {
        return next_ < marks_.size() ? marks_[next_].time : std::numeric_limits<double>::infinity();
    }

    /// To be called at next_time().
    void look(const AdvanceResult& advanced) {
        for (const double now = next_time(); next_time() == now; ++next_) {
            const Mark& mark = marks_[next_];
            ReversalReport& report = reports_[mark.reversal];
            if (!mark.is_return) {
                report.events_out = events(advanced.counts);
                continue;
            }
            report.events_back = events(advanced.counts) - report.events_out;
            if (alone_before(mark.time)) report.distance = advanced.return_distance;
        }
    }

    const std::vector<ReversalReport>& reports() const { return reports_; }

  private:
    struct Mark {
        double time;
        std::size_t reversal;
        bool is_return;
    };

    void add(double at, double until) {
        marks_.push_back({at, reports_.size(), false});
        if (2.0 * at <= until) marks_.push_back({2.0 * at, reports_.size(), true});
        reports_.push_back({});
        reports_.back().at = at;
    }

    bool alone_before(double time) const {
        return std::count_if(reports_.begin(), reports_.end(),
                             [=](const ReversalReport& other) { return other.at < time; }) == 1;
    }

    std::vector<Mark> marks_;
    std::vector<ReversalReport> reports_;
    std::size_t next_ = 0;
};

// Between two looks at how far the run has come: some hundredths of a second.
constexpr std::int64_t events_in_a_stretch = 20'000;

class Course {
  public:
    Course(const StartedScene& started, double prepare_seconds, Progress& progress)
        : run_(started.scene.run),
          simulation_(started.simulation),
          statistics_(simulation_.box(), simulation_.particles(),
                      static_cast<int>(started.scene.gas.species.size()), sample_count(run_)),
          reversals_(run_, simulation_),
          progress_(progress),
          stretch_(1e-6 * run_.until) {
        seconds_.prepare = prepare_seconds;
        progress_.begin("simulating", run_.until, "time units");
    }

    RunReport run(const SampleTaker& take) {
        const std::int64_t samples = sample_count(run_);
        for (std::int64_t index = 0; index < samples; ++index) {
            go_on_to(sample_time(run_, index));
            see_sample(take);
        }
        progress_.finish();
        seconds_.total = seconds_.prepare + seconds_since(begun_);
        return {simulation_.particles().count(),
                simulation_.bits(),
                samples,
                statistics_.summary(advanced_),
                advanced_.counts,
                reversals_.reports(),
                seconds_};
    }

  private:
    void see_sample(const SampleTaker& take) {
        const Stopwatch watch(seconds_.samples);
        const Sample& sample = simulation_.sample();
        statistics_.see(sample);
        if (take) take(simulation_.particles(), sample);
    }

    // Stops on the way change nothing in the course of the events.
    void go_on_to(double time) {
        while (now_ < time) {
            advance_to(std::min({time, reversals_.next_time(), now_ + stretch_}));
            if (now_ == reversals_.next_time()) reversals_.look(advanced_);
        }
    }

    void advance_to(double time) {
        throw_if_interrupted();
        const Stopwatch watch(seconds_.simulate);
        const std::int64_t before = events(advanced_.counts);
        advanced_ = simulation_.advance_to(time);
        adapt_stretch(events(advanced_.counts) - before, time - now_);
        now_ = time;
        progress_.reach(now_);
    }

    // By counts of events, not by the clock: a run makes the same stops wherever it runs.
    void adapt_stretch(std::int64_t happened, double went) {
        const double least = 1e-12 * run_.until;  // time must go on
        if (happened > events_in_a_stretch) stretch_ = std::max(0.5 * went, least);
        const bool was_whole = went > 0.99 * stretch_;  // not cut off by a sample or a reversal
        if (4 * happened < events_in_a_stretch && was_whole) stretch_ = 2.0 * went;
    }

    Clock::time_point begun_ = Clock::now();
    RunSeconds seconds_;
    Run run_;
    Simulation simulation_;
    RunStatistics statistics_;
    ReversalWatch reversals_;
    Progress& progress_;
    AdvanceResult advanced_;
    double now_ = 0.0;
    double stretch_;  ///< simulated time of at most some events_in_a_stretch
};

}  // namespace

std::int64_t sample_count(const Run& run) {
    constexpr double rounding = 1e-9;  // an end at exactly k steps must not get a sliver after it
    return 1 + static_cast<std::int64_t>(
                   std::max(1.0, std::ceil(run.until / run.sample_every - rounding)));
}

double sample_time(const Run& run, std::int64_t index) {
    if (index + 1 >= sample_count(run)) return run.until;
    return static_cast<double>(index) * run.sample_every;
}

RunReport run_physics(const Scene& scene, const SampleTaker& take, Progress& progress) {
    const Clock::time_point begun = Clock::now();
    const StartedScene started = start_scene(scene, progress);
    const double prepare_seconds = seconds_since(begun);
    RunReport report;
    with_places_of_errors(started.scene,
                          [&] { report = Course(started, prepare_seconds, progress).run(take); });
    return report;
}

}  // namespace carom
