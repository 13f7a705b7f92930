#include "physics/reversal/precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>

#include "physics/gas.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/placement/placement.h"
#include "physics/reversal/collision_history.h"
#include "physics/reversal/reversal_schedule.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/error_growth.h"
#include "util/interrupt.h"

namespace carom {
namespace {

constexpr int bits_of_word = 64;  // a number takes whole words

int up_to_whole_words(double bits) {
    const double words = std::ceil(std::max(bits, double{least_bits}) / bits_of_word);
    return static_cast<int>(std::min(words, 1e6) * bits_of_word);
}

Run in_bits(Run run, int bits) {
    run.bits = bits;
    return run;
}

bool is_perturbation(const RunEvent& event) { return perturbation_of(event) != nullptr; }

bool closes(const RunEvent& event) {
    const auto* set = opening_of(event);
    return set != nullptr && !set->is_open;
}

/// The events of a run that a trial includes, and their indices in the run.
class TrialEvents {
  public:
    TrialEvents(const Run& run, const auto& is_left_out) {
        for (std::size_t k = 0; k < run.events.size(); ++k) {
            if (is_left_out(run.events[k])) continue;
            events_.push_back(run.events[k]);
            numbers_.push_back(k);
        }
    }

    std::vector<RunEvent>& all() { return events_; }

    /// Calls a function whose errors refer to events by their index counted from `first`, and
    /// rethrows these errors with the index in the run.
    void run_from(std::size_t first, const auto& function) const {
        try {
            function();
        } catch (const RunEventError& error) {
            throw RunEventError(numbers_[first + error.event()], error.what(), error.hint());
        }
    }

  private:
    std::vector<RunEvent> events_;
    std::vector<std::size_t> numbers_;
};

TimeCallback in_trial(const TrialCallback& on_progress, int bits) {
    if (!on_progress) return {};
    return [&on_progress, bits](double time) { on_progress(bits, time); };
}

/// Result of a trial run with a given number of bits.
struct TrialResult {
    bool same_partners = true;  ///< in reverse order
    double log2_excess = -1e9;  ///< base-2 logarithm of the largest return distance divided by the
                                ///< tolerance
    bool succeeded() const { return same_partners && log2_excess < 0.0; }
};

/// Runs through all branches of a run, starting from a simulation at time 0 and with its number of
/// bits.
class ReturnTrial {
  public:
    ReturnTrial(const Simulation& start, const Run& run, const ReversalSchedule& schedule,
                const TrialCallback& on_progress)
        : simulation_(start),
          events_(run, is_perturbation),
          schedule_(schedule),
          on_progress_(on_progress) {
        simulation_.replace_events(events_of_next_branch());
        simulation_.record_collisions(true);
        const std::vector<MirrorTimes>& mirrors = schedule.mirror_times();
        for (std::size_t k = 0; k < mirrors.size(); ++k) {
            visits_.push_back({mirrors[k].first, k, false});
            visits_.push_back({mirrors[k].again, k, true});
        }
        std::ranges::stable_sort(visits_, {}, &Visit::time);
        states_.resize(mirrors.size());
    }

    TrialResult run(CollisionHistory& history, double tolerance, double fastest) {
        TrialResult result;
        auto next = visits_.begin();
        int direction = 1;
        for (const Branch& branch : schedule_.branches()) {
            if (branch.direction != direction) simulation_.replace_events(events_of_next_branch());
            direction = branch.direction;
            if (branch.leaves_way_back) history.forget_ahead(branch);
            for (; next != visits_.end() && next->time <= branch.end; ++next) {
                if (!advance(branch, next->time, history)) return {.same_partners = false};
                if (next->again)
                    compare(next->mirror, history, tolerance, fastest, result);
                else
                    states_[next->mirror] = {simulation_.exact_positions(), history.checkpoint()};
            }
            if (next == visits_.end()) break;
            if (!advance(branch, branch.end, history)) return {.same_partners = false};
        }
        return result;
    }

  private:
    struct Visit {
        double time;
        std::size_t mirror;
        bool again;
    };
    struct State {
        std::optional<ExactPositions> positions;
        std::vector<std::ptrdiff_t> checkpoint;
    };

    // The events from one reversal until just before the next: positions at the time of a reversal
    // are compared before it happens.
    std::vector<RunEvent> events_of_next_branch() {
        const std::vector<RunEvent>& all = events_.all();
        first_event_ = next_event_;
        const auto from = all.begin() + static_cast<std::ptrdiff_t>(first_event_);
        const auto begin = has_begun_ && from != all.end() ? from + 1 : from;
        const auto end = std::find_if(begin, all.end(), reverses);
        next_event_ = static_cast<std::size_t>(end - all.begin());
        has_begun_ = true;
        return {from, end};
    }

    void compare(std::size_t mirror, const CollisionHistory& history, double tolerance,
                 double fastest, TrialResult& result) const {
        const MirrorTimes& times = schedule_.mirror_times()[mirror];
        const State& before = states_[mirror];
        const double far =
            return_distance(*before.positions, simulation_.exact_positions()).log10_largest;
        const double allowed = tolerance + 10.0 * fastest * times.off;
        result.log2_excess =
            std::max(result.log2_excess, (far - std::log10(allowed)) / std::log10(2.0));
        if (!history.is_at(before.checkpoint, times.path)) result.same_partners = false;
    }

    // Advances and records collisions; returns false if a particle collides with another partner
    // than before. Works in steps, so that the recorded collisions of a long run do not accumulate
    // in memory.
    bool advance(const Branch& branch, double time, CollisionHistory& history) {
        constexpr int steps = 64;
        const double begin = now_;
        for (int k = 1; k <= steps; ++k) {
            now_ = k == steps ? time : begin + (time - begin) * k / steps;
            AdvanceResult advanced;
            events_.run_from(first_event_, [&] { advanced = simulation_.advance_to(now_); });
            for (const Collision& collision : advanced.collisions)
                if (!history.record(branch, collision)) return false;
            throw_if_interrupted();
            if (on_progress_ && now_ > 0.0) on_progress_(simulation_.bits(), now_);
        }
        history.extend_to(branch.path_at(now_));
        return true;
    }

    Simulation simulation_;
    TrialEvents events_;
    std::size_t first_event_ = 0, next_event_ = 0;  ///< first event of this branch and of the next
    bool has_begun_ = false;
    const ReversalSchedule& schedule_;
    const TrialCallback& on_progress_;
    std::vector<Visit> visits_;
    std::vector<State> states_;  ///< states at the first of each pair of mirror times
    double now_ = 0.0;
};

/// Finds the bits of a run by trials.
class PrecisionSearch {
  public:
    PrecisionSearch(const Gas& gas, const Run& run, const ReversalSchedule& schedule,
                    const TrialCallback& on_progress)
        : gas_(gas),
          run_(run),
          schedule_(schedule),
          on_progress_(on_progress),
          placed_(place(gas)),
          tolerance_(tolerance_length()) {}

    /// The simulation at time 0, with a number of bits for which a trial has succeeded.
    Simulation start() {
        count_collisions();
        const double guess = first_guess();
        if (guess > most_bits) refuse_so_many(guess);
        int bits = up_to_whole_words(guess);
        while (true) {
            Simulation start(gas_, in_bits(run_, bits), in_trial(on_progress_, bits));
            const TrialResult result = try_out(start);
            if (result.succeeded()) return start;
            if (bits == most_bits) refuse_at_limit();
            if (bits > 8.0 * guess + 1024.0) refuse_for_no_reason_known(bits);
            const double more =
                result.same_partners ? bits + result.log2_excess + 32.0 : 1.5 * bits;
            bits = std::min(most_bits, up_to_whole_words(more));
        }
    }

  private:
    double tolerance_length() const {
        const Particles& particles = placed_.first;
        const double smallest = particles.count() > 0 ? particles.radius.minCoeff() : 0.0;
        const double spacing = gas_.box.size[0] / static_cast<double>(particles.count());
        return run_.tolerance * (smallest > 0.0 ? smallest : spacing);
    }

    // Counts the collisions per particle on the branch with most of them, in doubles. Only their
    // number matters, so partitions are not closed: a particle of a gas that does not return might
    // be in their way.
    void count_collisions() {
        Simulation simulation(gas_, in_bits(run_, bits_of_double),
                              in_trial(on_progress_, bits_of_double));
        TrialEvents events(
            run_, [](const RunEvent& event) { return is_perturbation(event) || closes(event); });
        for (RunEvent& event : events.all()) event.is_mirrored = false;
        simulation.replace_events(events.all());
        std::int64_t before = 0;
        for (const Branch& branch : schedule_.branches()) {
            std::int64_t now = 0;
            events.run_from(0, [&] { now = simulation.advance_to(branch.end).counts.particle; });
            const double each = 2.0 * static_cast<double>(now - before) /
                                static_cast<double>(placed_.first.count());
            if (each >= of_each_) longest_ = branch.end - branch.begin;
            of_each_ = std::max(of_each_, each);
            before = now;
            if (on_progress_) on_progress_(bits_of_double, branch.end);
        }
    }

    // The growth law holds for equal disks or spheres; for others this is only a guess. On a line
    // errors grow more slowly, at a rate that the trials find out.
    double first_guess() const {
        if (gas_.box.dimension == 1) return least_bits;
        const double lost =
            of_each_ *
            bits_lost_per_collision(gas_.box.dimension, packing_fraction(gas_.box, placed_.first));
        return std::log2(gas_.box.longest_side() / tolerance_) + 12.0 + lost +
               2.0 * std::sqrt(lost);
    }

    TrialResult try_out(const Simulation& start) const {
        const auto& [particles, placed] = placed_;
        const double fastest = particles.count() > 0 ? speeds(placed).maxCoeff() : 0.0;
        // The times of collisions are reported as doubles.
        const double round_off = 16.0 * std::numeric_limits<double>::epsilon() * run_.until;
        CollisionHistory history(particles.count(),
                                 (fastest > 0.0 ? tolerance_ / fastest : 0.0) + round_off);
        return ReturnTrial(start, run_, schedule_, on_progress_).run(history, tolerance_, fastest);
    }

    std::string after_how_many() const {
        return fmt::format("after {:.4g} collisions of each particle", of_each_);
    }
    [[noreturn]] void refuse_so_many(double bits) const {
        throw PrecisionError(
            fmt::format("a return {} takes some {:.0f} bits; the limit is {}", after_how_many(),
                        bits, most_bits),
            fmt::format("reverse {:.3g} time units or less after the previous reversal or the "
                        "start, or let the particles fill more of the box",
                        longest_ * most_bits / bits));
    }
    [[noreturn]] void refuse_at_limit() const {
        throw PrecisionError(
            fmt::format("even {} bits, the limit, do not return the gas to its start {}", most_bits,
                        after_how_many()),
            fmt::format(
                "reverse less than {:.3g} time units after the previous reversal or the start",
                longest_));
    }
    [[noreturn]] void refuse_for_no_reason_known(int bits) const {
        throw PrecisionError(
            fmt::format(
                "even {} bits do not return the gas to its start {}, although far fewer should",
                bits, after_how_many()),
            "when three particles collide at one instant, as in symmetric starts, the way back is "
            "not unique; use another `seed`, or move particles a little");
    }

    const Gas& gas_;
    const Run& run_;
    const ReversalSchedule& schedule_;
    const TrialCallback& on_progress_;
    std::pair<Particles, Sample> placed_;
    double tolerance_;      ///< length
    double of_each_ = 0.0;  ///< collisions per particle with others, on the branch with most
    double longest_ = 0.0;  ///< duration of that branch
};

}  // namespace

int bits_for(const Perturbation& perturbation, double size) {
    const ReturnDistance moved = moved_by({perturbation}, 1);
    if (!std::isfinite(moved.log10_largest)) return least_bits;
    return up_to_whole_words((std::log10(size) - moved.log10_largest) / std::log10(2.0) + 64.0);
}

ReturnDistance moved_by(const std::vector<Perturbation>& perturbations, Eigen::Index particles) {
    std::map<std::int64_t, std::array<Real, 3>> displaced;
    for (const Perturbation& perturbation : perturbations) {
        std::array<Real, 3>& by = displaced[perturbation.particle];
        for (std::size_t axis = 0; axis < by.size(); ++axis)
            by[axis] += Real::from_text(perturbation.by[axis], least_bits);
    }
    Real largest = 0.0, sum = 0.0;
    for (const auto& [particle, by] : displaced) {
        const Real square = by[0] * by[0] + by[1] * by[1] + by[2] * by[2];
        largest = std::max(largest, square);
        sum += square;
    }
    largest = sqrt(largest);
    const Real mean = sqrt(sum / static_cast<double>(particles));
    return {static_cast<double>(largest), static_cast<double>(mean), log10(largest), log10(mean)};
}

Simulation start_run(const Gas& gas, const Run& run, const TrialCallback& on_progress) {
    int bits = run.bits.value_or(bits_of_double);
    if (!run.bits) {
        for (const RunEvent& event : run.events)
            if (const auto* perturbation = perturbation_of(event))
                bits = std::max(bits, bits_for(*perturbation, gas.box.longest_side()));
        const ReversalSchedule schedule(run);
        if (!schedule.mirror_times().empty()) {
            Simulation start = PrecisionSearch(gas, run, schedule, on_progress).start();
            if (start.bits() >= bits) return start;
        }
    }
    return {gas, in_bits(run, bits), in_trial(on_progress, bits)};
}

int bits_for_return(const Gas& gas, const Run& run, const TrialCallback& on_progress) {
    return start_run(gas, run, on_progress).bits();
}

}  // namespace carom
