#include "scene/time/timeline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "scene/scene.h"

namespace carom {
namespace {

struct Holds {
    int opening, reversal, closing;
};

std::vector<double> reversals_on_the_way(const Run& run) {
    std::vector<double> times = reversal_times(run);
    std::erase_if(times, [&](double time) { return time >= run.until; });
    return times;
}

Holds holds(int frames, int fps, int reversals) {
    const double wanted = (1.5 + 2.0 + reversals) * fps;
    const double scale = std::min(1.0, frames / 4.0 / wanted);
    const auto count = [&](double seconds) { return static_cast<int>(seconds * fps * scale); };
    return {count(1.5), count(1.0), count(2.0)};
}

int frames_without_cards(const Film& film) {
    const CardFrames cards = card_frames(film);
    return frame_count(film) - cards.title - cards.end;
}

// Returns the number of frames without cards and without the scene's own pauses.
int gas_frames(const Film& film) {
    const std::vector<int> pauses = pause_frames(film);
    return frames_without_cards(film) - std::accumulate(pauses.begin(), pauses.end(), 0);
}

// Returns the number of frame steps in a leg, the part of a run between two reversals. Steps are
// equal and at most `step` long, and the leg's end is always a frame. The result is a whole number,
// but may exceed any integer type: a step of 1e-12 may be tried for a leg of 1e12.
double steps_of_leg(double length, double step) {
    constexpr double rounding =
        1e-9;  // a leg of exactly k steps must not get a sliver as step k + 1
    return std::max(1.0, std::ceil(length / step - rounding));
}

double steps_of_all(const std::vector<double>& ends, double step) {
    double steps = 0.0;
    double start = 0.0;
    for (double end : ends) {
        steps += steps_of_leg(end - start, step);
        start = end;
    }
    return steps;
}

// Returns the smallest step that divides the first leg evenly and takes at most `most` steps in
// all, if there is one; otherwise the length of the first leg.
double step_of_first_leg(const std::vector<double>& ends, int most) {
    int first = std::max(1, static_cast<int>(most * (ends.front() / ends.back())));
    while (first > 1 && steps_of_all(ends, ends.front() / first) > most) --first;
    return ends.front() / first;
}

// Returns the smallest step that divides the whole run evenly and takes at most `most` steps in
// all. Rounding up adds less than one step to each leg, so that the search ends at most - legs + 1
// at the latest.
double step_of_run(const std::vector<double>& ends, int most) {
    int whole = most;
    while (whole > 1 && steps_of_all(ends, ends.back() / whole) > most) --whole;
    return ends.back() / whole;
}

// Returns one step for all legs. Dividing the first leg evenly gives the smoothest motion, but if
// that leg is short, no such step fits, or only a coarse one.
double common_step(const std::vector<double>& ends, int most) {
    constexpr double well_used = 0.8;
    const double step = step_of_first_leg(ends, most);
    const double steps = steps_of_all(ends, step);
    return steps <= most && steps >= well_used * most ? step : step_of_run(ends, most);
}

class Reel {
  public:
    Reel(const Pace& pace, int fps) : pace_(pace), fps_(fps) {}
    void add(double time, Phase phase, double progress, int reversals) {
        if (phase != Phase::title_card) ++shown_;
        ticks_.push_back({static_cast<int>(ticks_.size()), time, phase, progress,
                          pace_.slowness(time), reversals,
                          static_cast<double>(std::max(0, shown_ - 1)) / fps_});
    }
    void hold(int frames, double time, Phase phase, int reversals) {
        for (int i = 0; i < frames; ++i) add(time, phase, (i + 1.0) / frames, reversals);
    }
    void pause(int frames, double time, int reversals) {
        for (int i = 0; i < frames; ++i) {
            add(time, Phase::pausing, (i + 1.0) / frames, reversals);
            ticks_.back().slow = {0.0, 1.0};
        }
    }
    void pause_at_reversal(int frames, double time, int before) {
        for (int i = 0; i < frames; ++i)
            add(time, Phase::reversing, (i + 1.0) / frames, 2 * i < frames ? before : before + 1);
    }
    int size() const { return static_cast<int>(ticks_.size()); }
    std::vector<Tick> take() { return std::move(ticks_); }

  private:
    const Pace& pace_;
    int fps_;
    int shown_ = 0;
    std::vector<Tick> ticks_;
};

// Inserts the pauses of a scene while its film is assembled.
class Pauses {
  public:
    explicit Pauses(const Film& film) : pauses_(film.pauses), frames_(pause_frames(film)) {}

    /// Adds the remaining pauses before `time`.
    void add_before(double time, int reversals, Reel& reel) {
        for (; next_ < pauses_.size() && pauses_[next_].at < time; ++next_)
            reel.pause(frames_[next_], pauses_[next_].at, reversals);
    }

  private:
    const std::vector<Pause>& pauses_;
    std::vector<int> frames_;
    std::size_t next_ = 0;
};

}  // namespace

double pause_seconds(const Film& film) {
    double seconds = 0.0;
    for (const Pause& pause : film.pauses) seconds += pause.seconds;
    return seconds;
}

std::vector<int> pause_frames(const Film& film) {
    const double wanted = pause_seconds(film), most = most_pause_seconds(film);
    const double scale = wanted > most ? most / wanted : 1.0;
    std::vector<int> frames;
    for (const Pause& pause : film.pauses)
        frames.push_back(static_cast<int>(scale < 1.0 ? pause.seconds * film.fps * scale
                                                      : std::round(pause.seconds * film.fps)));
    return frames;
}

double most_pause_seconds(const Film& film) { return 0.5 * frames_without_cards(film) / film.fps; }

int frame_count(const Film& film) {
    return std::max(1, static_cast<int>(std::lround(film.seconds * film.fps)));
}

double card_seconds(const Film& film) {
    constexpr double end_card_seconds = 4.0;
    return film.title_card + (film.end_card.empty() ? 0.0 : end_card_seconds);
}

CardFrames card_frames(const Film& film) {
    const double wanted = card_seconds(film);
    if (wanted == 0.0) return {};
    const double third = frame_count(film) / 3.0;
    const double scale = std::min(1.0, third / (wanted * film.fps));
    const auto count = [&](double seconds) { return static_cast<int>(seconds * film.fps * scale); };
    return {count(film.title_card), count(wanted - film.title_card)};
}

double card_cover(const Film& film, const Tick& tick) {
    if (is_card(tick.phase)) return 1.0;
    constexpr double fade_seconds = 0.5;
    const CardFrames cards = card_frames(film);
    const int before = frame_count(film) - cards.end - tick.frame;
    const auto left = [&](int frames) { return 1.0 - frames / (fade_seconds * film.fps); };
    return cards.end > 0 ? std::max(0.0, left(before)) : 0.0;
}

int branch_count(const Run& run) { return static_cast<int>(reversals_on_the_way(run).size()) + 1; }

int moving_steps(const Film& film, const Run& run) {
    const int frames = gas_frames(film);
    const int reversals = branch_count(run) - 1;
    const Holds hold = holds(frames, film.fps, reversals);
    return frames - 1 - hold.opening - hold.closing - hold.reversal * reversals;
}

std::vector<Tick> timeline(const Scene& scene) {
    const int frames = frame_count(scene.film);
    if (frames == 1) return {Tick{}};
    const CardFrames cards = card_frames(scene.film);
    std::vector<double> ends = reversals_on_the_way(scene.run);
    const Holds hold = holds(gas_frames(scene.film), scene.film.fps, branch_count(scene.run) - 1);
    ends.push_back(scene.run.until);
    const int most = moving_steps(scene.film, scene.run);
    assert(static_cast<int>(ends.size()) <= most);
    // Equal steps of the film are equal steps of stretched time.
    const Pace pace(scene.film.slow, scene.run.until, static_cast<double>(most) / scene.film.fps);
    std::vector<double> stretched_ends;
    for (const double end : ends) stretched_ends.push_back(pace.stretched(end));
    const double step = common_step(stretched_ends, most);

    Pauses pauses(scene.film);
    Reel reel(pace, scene.film.fps);
    reel.hold(cards.title, 0.0, Phase::title_card, 0);
    reel.hold(hold.opening, 0.0, Phase::opening, 0);
    reel.add(0.0, Phase::moving, 0.0, 0);
    double start = 0.0;
    for (std::size_t leg = 0; leg < ends.size(); ++leg) {
        const double length = stretched_ends[leg] - start;
        const int steps = static_cast<int>(steps_of_leg(length, step));
        const int reversals = static_cast<int>(leg);
        for (int i = 1; i <= steps; ++i) {
            const double time = i < steps ? pace.time(start + i * (length / steps)) : ends[leg];
            pauses.add_before(time, reversals, reel);
            reel.add(time, Phase::moving, 0.0, reversals);
        }
        if (leg + 1 < ends.size()) reel.pause_at_reversal(hold.reversal, ends[leg], reversals);
        start = stretched_ends[leg];
    }
    assert(reel.size() <= frames - cards.end);
    const int reversals = static_cast<int>(ends.size()) - 1;
    reel.hold(frames - cards.end - reel.size(), scene.run.until, Phase::closing, reversals);
    reel.hold(cards.end, scene.run.until, Phase::end_card, reversals);
    return reel.take();
}

double folded_time(const Run& run, double time) {
    double folded = 0.0;
    double start = 0.0;
    double direction = 1.0;
    for (double reversal : reversals_on_the_way(run)) {
        if (time <= reversal) break;
        folded += direction * (reversal - start);
        direction = -direction;
        start = reversal;
    }
    return folded + direction * (time - start);
}

std::vector<int> segment_starts(int frames, std::int64_t particles) {
    constexpr std::int64_t frame_data_bytes =
        24 << 20;  // of one segment, at about 12 bytes a particle
    const auto by_memory = frame_data_bytes / (12 * std::max<std::int64_t>(particles, 1));
    const int longest = static_cast<int>(std::clamp<std::int64_t>(by_memory, 30, 150));
    int segments = (frames + longest - 1) / longest;
    // A segment begins with a picture that does not refer to others, which takes as many bytes as
    // ten others. In films too short for that, some cores stay idle.
    if (frames >= 120)
        segments = (segments + 3) / 4 * 4;
    else if (frames >= 40)
        segments = std::max(segments, 2);

    std::vector<int> starts;
    for (int i = 0; i <= segments; ++i)
        starts.push_back(static_cast<int>(static_cast<std::int64_t>(frames) * i / segments));
    return starts;
}

}  // namespace carom
