#include "physics/reversal/echo.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/error_growth.h"
#include "util/interrupt.h"

namespace carom {
namespace {

constexpr int exact_bits = 256;  // no sum of times needs more
constexpr int whole_words = 64;  // bits that cost no more than one of them

int up_to_whole_words(double bits) {
    const double words = std::ceil(std::max(bits, double{least_bits}) / whole_words);
    return static_cast<int>(std::min(words, 1e6) * whole_words);
}

/// A stretch of the run between two reversals. Where the gas is on its way is told by the path: the
/// time on the way out, which falls while the gas goes back, and below 0 once it has passed home.
struct Leg {
    double begin, end;  ///< simulated times
    double path;        ///< at its begin, and
    Real exact_path;    ///< the same without rounding
    int direction;      ///< 1 or -1
    double at(double time) const { return path + direction * (time - begin); }
};

/// Two times at which the gas should be at the same places.
struct Meeting {
    double first, again;
    double path;
    double off;  ///< by how much they miss each other, where a time between has no double
};

class Itinerary {
  public:
    explicit Itinerary(const Run& run) {
        Leg next{0.0, 0.0, 0.0, Real(0.0, exact_bits), 1};
        const auto leg_until = [&](double end) {
            next.end = end;
            if (end > next.begin) add(next);
            next.exact_path = exact_path(next, end);
            next.path = static_cast<double>(next.exact_path);
            next.begin = end;
        };
        for (const double time : reversal_times(run)) {
            if (time >= run.until) break;
            leg_until(time);
            next.direction = -next.direction;
        }
        leg_until(run.until);
    }

    const std::vector<Leg>& legs() const { return legs_; }
    const std::vector<Meeting>& meetings() const { return meetings_; }  ///< by the second time

  private:
    // The path at a time, without rounding.
    static Real exact_path(const Leg& leg, double time) {
        const Real since = Real(time, exact_bits) - leg.begin;
        return leg.direction > 0 ? leg.exact_path + since : leg.exact_path - since;
    }

    // When the gas was first where it is at a time of a later leg.
    Meeting meeting_at(const Leg& later, double path) const {
        const double again = std::min(later.begin + std::abs(path - later.path), later.end);
        for (const Leg& leg : legs_) {
            const double end = leg.at(leg.end);
            if (path < std::min(leg.path, end) || path > std::max(leg.path, end)) continue;
            const double first = std::min(leg.begin + std::abs(path - leg.path), leg.end);
            const Real off = exact_path(later, again) - exact_path(leg, first);
            return {first, again, path, std::abs(static_cast<double>(off))};
        }
        return {0.0, again, path, 0.0};
    }

    void add(const Leg& leg) {
        legs_.push_back(leg);
        const double end = leg.at(leg.end);
        if (legs_.size() > 1) {
            std::vector<double> paths{std::clamp(end, low_, high_)};
            if (low_ < 0.0 && (leg.path > 0.0) != (end > 0.0)) paths.push_back(0.0);
            std::ranges::sort(paths, {}, [&](double path) { return std::abs(path - leg.path); });
            for (const double path : paths)
                if (path != leg.path) meetings_.push_back(meeting_at(leg, path));
        }
        low_ = std::min(low_, end);
        high_ = std::max(high_, end);
    }

    std::vector<Leg> legs_;
    std::vector<Meeting> meetings_;
    double low_ = 0.0, high_ = 0.0;  ///< where the gas has been
};

Run without_nudges(Run run) {
    std::erase_if(run.events, [](const RunEvent& event) {
        return std::holds_alternative<Perturbation>(event.action);
    });
    return run;
}

/// Whom each particle has met along the path. On known ground it must meet the same again.
class Diary {
  public:
    Diary(Eigen::Index particles, double slack)
        : pages_(static_cast<std::size_t>(particles)), slack_(slack) {}

    /// False if it contradicts what has been.
    bool write(const Leg& leg, const Collision& collision) {
        const double path = leg.at(collision.time);
        const bool one = write(leg.direction, path, collision.first, collision.second);
        return one && (collision.second < 0 ||
                       write(leg.direction, path, collision.second, collision.first));
    }

    /// How far each has read, to be compared at a second visit.
    std::vector<std::ptrdiff_t> bookmarks() const {
        std::vector<std::ptrdiff_t> marks;
        for (const Page& page : pages_) marks.push_back(page.place - page.before_start);
        return marks;
    }

    /// Whether they are where they were, up to what happens at this very moment.
    bool is_at(const std::vector<std::ptrdiff_t>& marks, double path) const {
        for (std::size_t i = 0; i < pages_.size(); ++i) {
            const Page& page = pages_[i];
            const auto [from, to] = std::minmax({page.place, marks[i] + page.before_start});
            for (std::ptrdiff_t k = from; k < to; ++k)
                if (std::abs(page.entries[static_cast<std::size_t>(k)].path - path) > slack_)
                    return false;
        }
        return true;
    }

    /// The stretch of the path that has been seen, by an observer who goes along.
    void reach(double path) {
        low_ = std::min(low_, path);
        high_ = std::max(high_, path);
    }

  private:
    struct Entry {
        std::int32_t whom;
        double path;
    };
    struct Page {
        std::deque<Entry> entries;
        std::ptrdiff_t place = 0;         ///< the next on the way out
        std::ptrdiff_t before_start = 0;  ///< entries from before the start
    };

    bool write(int direction, double path, std::int32_t who, std::int32_t whom) {
        Page& page = pages_[static_cast<std::size_t>(who)];
        const bool out = direction > 0;
        const std::ptrdiff_t next = out ? page.place : page.place - 1;
        const bool is_new = next < 0 || next == static_cast<std::ptrdiff_t>(page.entries.size());
        if (is_new) {
            if (path > low_ + slack_ && path < high_ - slack_) return false;
            if (out)
                page.entries.push_back({whom, path});
            else
                page.entries.push_front({whom, path});
            if (out)
                ++page.place;
            else
                ++page.before_start;  // and the place stays 0
            return true;
        }
        page.place += direction;
        return page.entries[static_cast<std::size_t>(next)].whom == whom;
    }

    std::vector<Page> pages_;
    double slack_;
    double low_ = 0.0, high_ = 0.0;
};

TimeCallback times_of(const TrialCallback& on_progress, int bits) {
    if (!on_progress) return {};
    return [&on_progress, bits](double time) { on_progress(bits, time); };
}

/// How a run in so many bits came home.
struct Echo {
    bool meets_the_same = true;
    double log2_excess = -1e9;  ///< of the largest distance over the tolerance
};

// Goes the whole way with so many bits, leg by leg.
template <int Dimension>
class EchoRun {
  public:
    EchoRun(const Gas& gas, const Particles& particles, Sample start, const Run& run, int bits,
            const TrialCallback& on_progress)
        : box_(gas.box),
          loop_(gas.box, particles, {.bits = bits}),
          bits_(bits),
          on_progress_(on_progress) {
        start.time = -run.equilibrate;
        loop_.start(start);
        loop_.advance(0.0, nullptr, times_of(on_progress, bits));
    }

    Echo go(const Itinerary& way, Diary& diary, double tolerance, double fastest) {
        Echo echo;
        std::vector<Visit> visits = visits_of(way.meetings());
        auto next = visits.begin();
        int direction = 1;
        for (const Leg& leg : way.legs()) {
            if (leg.direction != direction) loop_.reverse(leg.begin);
            direction = leg.direction;
            for (; next != visits.end() && next->time <= leg.end; ++next) {
                const Meeting& meeting = way.meetings()[next->meeting];
                if (!advance(leg, next->time, diary)) return {.meets_the_same = false};
                const ExactPositions here(box_, loop_.places(next->time));
                Seen& before = seen_[next->meeting];
                if (!next->again) {
                    before = {here, diary.bookmarks()};
                    continue;
                }
                const double far = return_distance(*before.where, here).log10_largest;
                const double allowed = tolerance + 10.0 * fastest * meeting.off;
                echo.log2_excess =
                    std::max(echo.log2_excess, (far - std::log10(allowed)) / std::log10(2.0));
                if (!diary.is_at(before.marks, meeting.path)) echo.meets_the_same = false;
            }
            if (next == visits.end()) break;
            if (!advance(leg, leg.end, diary)) return {.meets_the_same = false};
        }
        return echo;
    }

  private:
    struct Visit {
        double time;
        std::size_t meeting;
        bool again;
    };
    struct Seen {
        std::optional<ExactPositions> where;
        std::vector<std::ptrdiff_t> marks;
    };

    std::vector<Visit> visits_of(const std::vector<Meeting>& meetings) {
        std::vector<Visit> visits;
        for (std::size_t k = 0; k < meetings.size(); ++k) {
            visits.push_back({meetings[k].first, k, false});
            visits.push_back({meetings[k].again, k, true});
        }
        std::ranges::stable_sort(visits, {}, &Visit::time);
        seen_.resize(meetings.size());
        return visits;
    }

    // False if the gas does not meet again whom it has met. In stretches, so that what is recorded
    // of a long run is soon forgotten.
    bool advance(const Leg& leg, double time, Diary& diary) {
        constexpr int stretches = 64;
        const double begin = now_;
        for (int k = 1; k <= stretches; ++k) {
            now_ = k == stretches ? time : begin + (time - begin) * k / stretches;
            collisions_.clear();
            loop_.advance(now_, &collisions_);
            for (const Collision& collision : collisions_)
                if (!diary.write(leg, collision)) return false;
            throw_if_interrupted();
            if (on_progress_ && now_ > 0.0) on_progress_(bits_, now_);
        }
        diary.reach(leg.at(now_));
        return true;
    }

    Box box_;
    EventLoop<Dimension, Real> loop_;
    std::vector<Seen> seen_;
    std::vector<Collision> collisions_;
    double now_ = 0.0;
    int bits_;
    const TrialCallback& on_progress_;
};

/// A gas in search of its bits.
class Search {
  public:
    Search(const Gas& gas, const Run& run, const Itinerary& way, const TrialCallback& on_progress)
        : gas_(gas),
          run_(run),
          way_(way),
          on_progress_(on_progress),
          placed_(place(gas)),
          tolerance_(tolerance_length()) {}

    int bits() {
        count_collisions();
        const double guess = first_guess();
        if (guess > most_bits) refuse_so_many(guess);
        int bits = up_to_whole_words(guess);
        while (true) {
            const Echo echo = try_out(bits);
            if (echo.meets_the_same && echo.log2_excess < 0.0) return bits;
            if (bits == most_bits) refuse_at_ceiling();
            if (bits > 8.0 * guess + 1024.0) refuse_for_no_reason_known(bits);
            const double more = echo.meets_the_same ? bits + echo.log2_excess + 32.0 : 1.5 * bits;
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

    // Of each particle with others on the longest leg, in doubles: only the number counts.
    void count_collisions() {
        Run run = without_nudges(run_);
        run.bits = bits_of_double;
        Simulation simulation(gas_, run, times_of(on_progress_, bits_of_double));
        std::int64_t before = 0;
        for (const Leg& leg : way_.legs()) {
            const std::int64_t now = simulation.advance_to(leg.end).counts.particle;
            const double each = 2.0 * static_cast<double>(now - before) /
                                static_cast<double>(placed_.first.count());
            if (each >= of_each_) longest_ = leg.end - leg.begin;
            of_each_ = std::max(of_each_, each);
            before = now;
            if (on_progress_) on_progress_(bits_of_double, leg.end);
        }
    }

    // The law is for equal disks; of others it is a guess. On a wire errors grow more slowly, by
    // how much is found out.
    double first_guess() const {
        if (gas_.box.dimension == 1) return least_bits;
        const double lost =
            of_each_ * bits_lost_per_collision(packing_fraction(gas_.box, placed_.first));
        return std::log2(gas_.box.size.maxCoeff() / tolerance_) + 12.0 + lost +
               2.0 * std::sqrt(lost);
    }

    Echo try_out(int bits) const {
        return gas_.box.dimension == 1 ? try_out<1>(bits) : try_out<2>(bits);
    }
    template <int Dimension>
    Echo try_out(int bits) const {
        const auto& [particles, start] = placed_;
        const double fastest = particles.count() > 0 ? speeds(start).maxCoeff() : 0.0;
        // The times of collisions come as doubles.
        const double round_off = 16.0 * std::numeric_limits<double>::epsilon() * run_.until;
        Diary diary(particles.count(), (fastest > 0.0 ? tolerance_ / fastest : 0.0) + round_off);
        return EchoRun<Dimension>(gas_, particles, start, run_, bits, on_progress_)
            .go(way_, diary, tolerance_, fastest);
    }

    std::string after_how_many() const {
        return fmt::format("after {:.4g} collisions of each particle", of_each_);
    }
    [[noreturn]] void refuse_so_many(double bits) const {
        throw PrecisionError(
            fmt::format("to bring the gas home {} takes some {:.0f} bits; the ceiling is {}",
                        after_how_many(), bits, most_bits),
            fmt::format(
                "a reversal {:.3g} time units after the one before, or after the start, needs "
                "fewer; so do disks that fill more of the box",
                longest_ * most_bits / bits));
    }
    [[noreturn]] void refuse_at_ceiling() const {
        throw PrecisionError(
            fmt::format("even {} bits, the ceiling, do not bring the gas home {}", most_bits,
                        after_how_many()),
            fmt::format("a reversal less than {:.3g} time units after the one before, or after the "
                        "start, needs fewer",
                        longest_));
    }
    [[noreturn]] void refuse_for_no_reason_known(int bits) const {
        throw PrecisionError(
            fmt::format("even {} bits do not bring the gas home {}, where far fewer should", bits,
                        after_how_many()),
            "three particles that meet at one instant, as in symmetric starts, have no way back "
            "that is the only one; another `seed`, or places a little off, avoid that");
    }

    const Gas& gas_;
    const Run& run_;
    const Itinerary& way_;
    const TrialCallback& on_progress_;
    std::pair<Particles, Sample> placed_;
    double tolerance_;      ///< length
    double of_each_ = 0.0;  ///< collisions with others, on the leg with most
    double longest_ = 0.0;  ///< time of that leg
};

}  // namespace

int bits_for(const Perturbation& perturbation, double size) {
    const ReturnDistance moved = moved_by({perturbation}, 1);
    if (!std::isfinite(moved.log10_largest)) return least_bits;
    return up_to_whole_words((std::log10(size) - moved.log10_largest) / std::log10(2.0) + 64.0);
}

ReturnDistance moved_by(const std::vector<Perturbation>& perturbations, Eigen::Index particles) {
    std::map<std::int64_t, std::array<Real, 2>> displaced;
    for (const Perturbation& perturbation : perturbations) {
        std::array<Real, 2>& by = displaced[perturbation.particle];
        for (std::size_t axis = 0; axis < by.size(); ++axis)
            by[axis] += Real::from_text(perturbation.by[axis], least_bits);
    }
    Real largest = 0.0, sum = 0.0;
    for (const auto& [particle, by] : displaced) {
        const Real square = by[0] * by[0] + by[1] * by[1];
        largest = std::max(largest, square);
        sum += square;
    }
    const auto distance = [](const Real& square) {
        const Real root = sqrt(square);
        constexpr double none = -std::numeric_limits<double>::infinity();
        return std::pair{static_cast<double>(root), root.is_zero() ? none : log10(root)};
    };
    const auto [most, log10_most] = distance(largest);
    const auto [mean, log10_mean] = distance(sum / static_cast<double>(particles));
    return {most, mean, log10_most, log10_mean};
}

int bits_for_return(const Gas& gas, const Run& run, const TrialCallback& on_progress) {
    const Itinerary way(run);
    int bits = bits_of_double;
    if (!way.meetings().empty()) bits = std::max(bits, Search(gas, run, way, on_progress).bits());
    for (const RunEvent& event : run.events)
        if (const auto* perturbation = std::get_if<Perturbation>(&event.action))
            bits = std::max(bits, bits_for(*perturbation, gas.box.size.maxCoeff()));
    return bits;
}

}  // namespace carom
