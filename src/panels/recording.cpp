#include "panels/recording.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "panels/archived.h"
#include "scene/limits.h"
#include "util/interrupt.h"

namespace carom {
namespace {

std::size_t bytes_of_sample(std::int64_t particles, int dimension) {
    return static_cast<std::size_t>(particles * dimension) * 2 * sizeof(double);
}

}  // namespace

Recording::Recording(Simulation start, std::vector<Tick> ticks, const Wanted& wanted,
                     const Viewer& see, std::size_t most)
    : ticks_(std::move(ticks)), with_collisions_(wanted.collisions), start_(std::move(start)) {
    bool kept = true;
    Simulation first = *start_;
    first.measure_return(wanted.return_times);
    simulate(std::move(first),
             [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                 kept = kept && keep(sample, advanced, most);
                 see(tick, sample, advanced);
             });
    if (kept) {
        start_.reset();
    } else {
        samples_ = {};
        frames_ = {};
    }
}

bool Recording::keep(const Sample& sample, const AdvanceResult& advanced, std::size_t most) {
    if (samples_.empty() || samples_.back().time != sample.time) {
        samples_.push_back(sample);
        bytes_ += bytes_of_sample(sample.position.rows(), static_cast<int>(sample.position.cols()));
    }
    frames_.push_back(
        {samples_.size() - 1, advanced, {advanced.collisions.begin(), advanced.collisions.end()}});
    frames_.back().advanced.collisions = {};
    bytes_ += sizeof(Frame) + advanced.collisions.size() * sizeof(Collision) +
              advanced.surfaces.size() * sizeof(SurfaceState);
    return bytes_ <= most;
}

void Recording::simulate(Simulation simulation, const Viewer& see) const {
    simulation.record_collisions(with_collisions_);
    for (const Tick& tick : ticks_) {
        throw_if_interrupted();
        const AdvanceResult advanced = simulation.advance_to(tick.time);
        see(tick, simulation.sample(), advanced);
    }
}

Recording::Player::Player(const Recording& recording)
    : recording_(&recording), simulation_(recording.start_) {
    if (simulation_) simulation_->record_collisions(recording.with_collisions_);
}

void Recording::Player::next() {
    throw_if_interrupted();
    const double time = recording_->ticks_.at(next_).time;
    if (simulation_) {
        advanced_ = simulation_->advance_to(time);
        sample_ = &simulation_->sample();
    } else {
        const Frame& frame = recording_->frames_[next_];
        advanced_ = frame.advanced;
        advanced_.collisions = frame.collisions;
        sample_ = &recording_->samples_[frame.sample];
    }
    ++next_;
}

Recording Recording::Player::rest(std::size_t end) const {
    const std::vector<Tick>& ticks = recording_->ticks_;
    if (end < next_ || end > ticks.size())
        throw std::out_of_range("a part of a recording beyond its frames");
    Recording rest;
    rest.ticks_.assign(ticks.begin() + std::ptrdiff_t(next_), ticks.begin() + std::ptrdiff_t(end));
    rest.with_collisions_ = recording_->with_collisions_;
    rest.start_ = simulation_;
    if (!simulation_) rest.keep_part(*recording_, next_, end);
    return rest;
}

// Frames that share a sample share it in the part too.
void Recording::keep_part(const Recording& whole, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        const Frame& frame = whole.frames_[i];
        if (i == first || frame.sample != whole.frames_[i - 1].sample)
            samples_.push_back(whole.samples_[frame.sample]);
        frames_.push_back(frame);
        frames_.back().sample = samples_.size() - 1;
    }
}

Recording Recording::part(std::size_t first, std::size_t end) const {
    Player player(*this);
    while (player.shown() < first) player.next();
    return player.rest(end);
}

void Recording::play(std::size_t end, const Viewer& see) const {
    Player player(*this);
    for (std::size_t i = 0; i < end; ++i) {
        player.next();
        see(player.tick(), player.sample(), player.advanced());
    }
}

bool Recording::fits(std::size_t frames, std::int64_t particles, int dimension) {
    return frames * (bytes_of_sample(particles, dimension) + sizeof(Frame)) <= most_bytes;
}

// What panels look up by the numbers of samples, particles and surfaces is there.
bool Recording::fits(const Frame& frame, const Box& box, Eigen::Index particles) const {
    const auto is_there = [&](const Collision& its) {
        const bool is_pair = its.second.is_particle();
        return its.first >= 0 && its.first < particles &&
               (is_pair ? its.second.particle() < particles
                        : its.second.surface() < box.surfaces.count());
    };
    const std::size_t surfaces = frame.advanced.surfaces.size();
    return frame.sample < samples_.size() && std::ranges::all_of(frame.collisions, is_there) &&
           (std::cmp_equal(surfaces, box.surfaces.count()) ||
            (surfaces == 0 && box.surfaces.are_plain()));
}

// Of a recording that was read.
bool Recording::fits_together(const Box& box, Eigen::Index particles) const {
    const auto is_next = [](const Tick& before, const Tick& tick) {
        return tick.frame - 1 == before.frame && tick.time >= before.time;
    };
    const auto is_tick = [](const Tick& tick) {
        return tick.frame >= 0 && tick.frame < static_cast<int>(most_frames.value) &&
               std::isfinite(tick.time) && tick.phase >= Phase::title_card &&
               tick.phase <= Phase::end_card;
    };
    if (ticks_.empty() || !std::ranges::all_of(ticks_, is_tick) ||
        !std::equal(ticks_.begin(), ticks_.end() - 1, ticks_.begin() + 1, is_next))
        return false;
    if (!is_kept()) return true;
    return frames_.size() == ticks_.size() &&
           std::ranges::all_of(samples_,
                               [&](const Sample& its) { return is_of(its, box, particles); }) &&
           std::ranges::all_of(frames_,
                               [&](const Frame& its) { return fits(its, box, particles); });
}

void Recording::archive(Archive& archive, const Box& box, const Particles& particles,
                        const Run& run) {
    bool kept = is_kept();
    archive(kept, with_collisions_, ticks_, samples_, frames_);
    if (archive.is_reading()) {
        start_.reset();
        if (!kept) start_.emplace(box, particles, run, archive);
        if (!fits_together(box, particles.count()))
            archive.refuse("its frames do not fit together");
    } else if (!kept) {
        start_->archive(archive);
    }
}

}  // namespace carom
