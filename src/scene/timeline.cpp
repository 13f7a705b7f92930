#include "scene/timeline.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

struct Pauses {
    int opening, reversal, closing;
};

std::vector<double> reversal_times(const Run& run) {
    std::vector<double> times;
    for (const RunEvent& event : run.events)
        if (std::holds_alternative<ReverseVelocities>(event.action) && event.at < run.until)
            times.push_back(event.at);
    return times;
}

Pauses pauses(int frames, int fps, std::size_t reversals) {
    const double wanted = (1.5 + 2.0 + static_cast<double>(reversals)) * fps;
    const double scale = std::min(1.0, frames / 4.0 / wanted);
    const auto count = [&](double seconds) { return static_cast<int>(seconds * fps * scale); };
    return {count(1.5), count(1.0), count(2.0)};
}

// The film between two reversals: equal steps from its start; its end is always a frame.
int steps_of_leg(double length, double step) {
    constexpr double rounding =
        1e-9;  // a leg of exactly k steps must not get a sliver as step k + 1
    return std::max(1, static_cast<int>(std::ceil(length / step - rounding)));
}

int steps_of_all(const std::vector<double>& ends, double step) {
    int steps = 0;
    double start = 0.0;
    for (double end : ends) {
        steps += steps_of_leg(end - start, step);
        start = end;
    }
    return steps;
}

// The smallest step that divides the first leg evenly and spends at most `most` steps in all.
double common_step(const std::vector<double>& ends, int most) {
    int first = std::max(1, static_cast<int>(most * (ends.front() / ends.back())));
    while (first > 1 && steps_of_all(ends, ends.front() / first) > most) --first;
    return ends.front() / first;
}

class Reel {
  public:
    void add(double time, Phase phase, double progress, int reversals) {
        ticks_.push_back({static_cast<int>(ticks_.size()), time, phase, progress, reversals});
    }
    void hold(int frames, double time, Phase phase, int reversals) {
        for (int i = 0; i < frames; ++i) add(time, phase, (i + 1.0) / frames, reversals);
    }
    void pause_at_reversal(int frames, double time, int before) {
        for (int i = 0; i < frames; ++i)
            add(time, Phase::reversing, (i + 1.0) / frames, 2 * i < frames ? before : before + 1);
    }
    int size() const { return static_cast<int>(ticks_.size()); }
    std::vector<Tick> take() { return std::move(ticks_); }

  private:
    std::vector<Tick> ticks_;
};

}  // namespace

int frame_count(const Film& film) {
    return std::max(1, static_cast<int>(std::lround(film.seconds * film.fps)));
}

std::vector<Tick> timeline(const Scene& scene) {
    const int frames = frame_count(scene.film);
    std::vector<double> ends = reversal_times(scene.run);
    const Pauses pause = pauses(frames, scene.film.fps, ends.size());
    const int held = pause.opening + pause.closing + pause.reversal * static_cast<int>(ends.size());
    ends.push_back(scene.run.until);
    const double step = common_step(ends, std::max(1, frames - held - 1));

    Reel reel;
    reel.hold(pause.opening, 0.0, Phase::opening, 0);
    reel.add(0.0, Phase::moving, 0.0, 0);
    double start = 0.0;
    for (std::size_t leg = 0; leg < ends.size(); ++leg) {
        const int steps = steps_of_leg(ends[leg] - start, step);
        const int reversals = static_cast<int>(leg);
        for (int i = 1; i < steps; ++i)
            reel.add(start + i * ((ends[leg] - start) / steps), Phase::moving, 0.0, reversals);
        reel.add(ends[leg], Phase::moving, 0.0, reversals);
        if (leg + 1 < ends.size()) reel.pause_at_reversal(pause.reversal, ends[leg], reversals);
        start = ends[leg];
    }
    reel.hold(frames - reel.size(), scene.run.until, Phase::closing,
              static_cast<int>(ends.size()) - 1);
    std::vector<Tick> ticks = reel.take();
    ticks.resize(static_cast<std::size_t>(frames), ticks.back());
    return ticks;
}

double folded_time(const Run& run, double time) {
    double folded = 0.0;
    double start = 0.0;
    double direction = 1.0;
    for (double reversal : reversal_times(run)) {
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
    if (frames >= 240) segments = (segments + 3) / 4 * 4;

    std::vector<int> starts;
    for (int i = 0; i <= segments; ++i)
        starts.push_back(static_cast<int>(static_cast<std::int64_t>(frames) * i / segments));
    return starts;
}

}  // namespace carom
