#include "panels/recording.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "panels/archived.h"
#include "physics/reversal/mirrored_events.h"
#include "physics/sample_times.h"
#include "scene/limits.h"
#include "util/interrupt.h"
#include "util/threads/relay.h"

namespace carom {
namespace {

// The limit of memory for frames whose samples and collisions are in a file: enough for an hour of
// film.
constexpr std::size_t most_bytes_beside = 64 << 20;

std::size_t bytes_of_sample(std::int64_t particles, int dimension) {
    return static_cast<std::size_t>(particles * dimension) * 2 * sizeof(double);
}

template <class Value>
std::span<const std::byte> bytes_of(const Value* values, std::size_t count) {
    return std::as_bytes(std::span(values, count));
}

template <class Value>
std::span<std::byte> room_of(Value* values, std::size_t count) {
    return std::as_writable_bytes(std::span(values, count));
}

// A moment that is passed from the simulating thread to the observing thread.
struct SentMoment {
    SeenMoment moment;
    std::shared_ptr<const Sample> sample;
    AdvanceResult advanced;
    std::vector<Collision> collisions;
};

}  // namespace

std::vector<double> measured_times(const Run& run) {
    std::vector<double> times;
    for (std::int64_t k = 0; k < sample_count(run); ++k) times.push_back(sample_time(run, k));
    for (const RunEvent& event : run.events)
        if (event.at <= run.until) times.push_back(event.at);
    for (const MirroredEvent& mirrored : mirrored_events(run)) times.push_back(mirrored.at);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

std::vector<SeenMoment> moments_of(const std::vector<Tick>& ticks, const Run& run) {
    std::vector<SeenMoment> all;
    const std::vector<double> times = measured_times(run);
    auto next = times.begin();
    for (const Tick& tick : ticks) {
        for (; next != times.end() && *next < tick.time; ++next) {
            Tick between = all.empty() ? tick : all.back().tick;
            between.time = *next;
            between.phase = Phase::moving;
            all.push_back({between, false, true});
        }
        const bool is_measured = next != times.end() && *next == tick.time && !is_card(tick.phase);
        all.push_back({tick, true, is_measured});
        if (is_measured) ++next;
    }
    return all;
}

std::vector<SeenMoment> moments_of(const std::vector<Tick>& ticks) {
    std::vector<SeenMoment> all;
    for (const Tick& tick : ticks) all.push_back({tick});
    return all;
}

Recording::Recording(Simulation start, std::vector<Tick> ticks, const Wanted& wanted,
                     const Viewer& see, const Room& room)
    : Recording(
          std::move(start), moments_of(ticks), wanted,
          [&](const SeenMoment& moment, const Sample& sample, const AdvanceResult& advanced,
              std::span<const Collision>) { see(moment.tick, sample, advanced); },
          room) {}

Recording::Recording(Simulation start, const std::vector<SeenMoment>& moments, const Wanted& wanted,
                     const FirstViewer& see, const Room& room)
    : with_collisions_(wanted.collisions), start_(std::move(start)) {
    for (const SeenMoment& moment : moments)
        if (moment.is_frame && ticks_.size() < wanted.frames.value_or(moments.size()))
            ticks_.push_back(moment.tick);
    bool kept = true;
    std::size_t seen = 0;  // frames
    JoinedCollisions since_frame;
    const auto see_and_keep = [&](const SeenMoment& moment, const Sample& sample,
                                  const AdvanceResult& advanced) {
        if (!moment.is_frame) {
            since_frame.add(advanced.collisions);
            return see(moment, sample, advanced, {});
        }
        AdvanceResult whole = advanced;
        whole.collisions = since_frame.take(advanced.collisions);
        if (kept && seen++ < ticks_.size() && !keep(sample, whole, room)) {
            kept = false;
            forget();
        }
        collision_count_ = static_cast<double>(advanced.counts.particle + advanced.counts.wall);
        see(moment, sample, advanced, whole.collisions);
    };
    Simulation first = *start_;
    first.measure_return(wanted.return_times);
    if (wanted.aside)
        see_aside([&](const Advances& send) { simulate(std::move(first), moments, wanted, send); },
                  see_and_keep);
    else
        simulate(std::move(first), moments, wanted, see_and_keep);
    if (kept) start_.reset();
}

// Calls `see` on a separate thread for the moments that `simulate` produces meanwhile. An exception
// of `see` takes precedence over one of the simulation, as it belongs to an earlier moment.
void Recording::see_aside(const std::function<void(const Advances&)>& simulate,
                          const Advances& see) {
    Relay<SentMoment> relay([&](SentMoment sent) {
        sent.advanced.collisions = sent.collisions;
        see(sent.moment, *sent.sample, sent.advanced);
    });
    std::shared_ptr<const Sample> last;
    try {
        simulate([&](const SeenMoment& moment, const Sample& sample,
                     const AdvanceResult& advanced) {
            if (!last || last->time != sample.time) last = std::make_shared<const Sample>(sample);
            relay.send(
                {moment, last, advanced, {advanced.collisions.begin(), advanced.collisions.end()}});
        });
    } catch (...) {
        relay.finish();
        throw;
    }
    relay.finish();
}

void Recording::forget() {
    samples_ = {};
    filed_ = {};
    frames_ = {};
    file_.reset();
}

double Recording::time_of_last_sample() const {
    return filed_.empty() ? samples_.back().time : filed_.back().time;
}

// Keeps frames in memory up to its limit, from then on in the file.
bool Recording::keep(const Sample& sample, const AdvanceResult& advanced, const Room& room) {
    const bool is_new = sample_count() == 0 || time_of_last_sample() != sample.time;
    Frame frame{sample_count() - (is_new ? 0 : 1), advanced, {}};
    frame.advanced.collisions = {};
    const auto collisions = with_collisions_ ? advanced.collisions : std::span<const Collision>{};
    const std::size_t of_sample =
        is_new ? bytes_of_sample(sample.position.rows(), static_cast<int>(sample.position.cols()))
               : 0;
    const std::size_t of_collisions = collisions.size_bytes();
    bytes_ += sizeof(Frame) + advanced.surfaces.size() * sizeof(SurfaceState);
    if (!file_ && bytes_ + of_sample + of_collisions > room.memory && room.file > 0)
        file_ = std::make_shared<ScratchFile>(room.file);
    if (file_) {
        // All parts of frames except samples and collisions stay in memory.
        if (bytes_ > room.memory + most_bytes_beside ||
            !keep_in_file(sample, is_new, collisions, frame))
            return false;
    } else {
        if (is_new) samples_.push_back(sample);
        frame.collisions.assign(collisions.begin(), collisions.end());
        bytes_ += of_sample + of_collisions;
    }
    frames_.push_back(std::move(frame));
    return file_ || bytes_ <= room.memory;
}

bool Recording::keep_in_file(const Sample& sample, bool is_new,
                             std::span<const Collision> collisions, Frame& frame) {
    const auto add = [&](std::span<const std::byte> bytes, std::int64_t& place) {
        const std::optional<std::int64_t> begin = file_->append(bytes);
        place = begin.value_or(0);
        return begin.has_value();
    };
    if (is_new) {
        particles_ = sample.position.rows();
        axes_ = sample.position.cols();
        const auto count = static_cast<std::size_t>(sample.position.size());
        FiledSample& filed = filed_.emplace_back(FiledSample{sample.time, 0, sample.membership});
        std::int64_t behind = 0;
        if (!add(bytes_of(sample.position.data(), count), filed.place) ||
            !add(bytes_of(sample.velocity.data(), count), behind))
            return false;
    }
    frame.filed = collisions.size();
    return add(std::as_bytes(collisions), frame.place);
}

void Recording::read_sample(std::size_t number, Sample& to) const {
    const FiledSample& filed = filed_[number - samples_.size()];
    to.time = filed.time;
    to.membership = filed.membership;
    to.position.resize(particles_, axes_);
    to.velocity.resize(particles_, axes_);
    const auto count = static_cast<std::size_t>(to.position.size());
    const std::span<std::byte> position = room_of(to.position.data(), count);
    file_->read(filed.place, position);
    file_->read(filed.place + static_cast<std::int64_t>(position.size()),
                room_of(to.velocity.data(), count));
}

void Recording::simulate(Simulation simulation, const std::vector<SeenMoment>& moments,
                         const Wanted& wanted, const Advances& see) {
    simulation.record_collisions(wanted.collisions || wanted.first_collisions);
    VelocitySamples velocities;
    std::size_t left = wanted.later_positions ? moments.size() : wanted.frames.value_or(0);
    for (const SeenMoment& moment : moments) {
        throw_if_interrupted();
        const AdvanceResult advanced = simulation.advance_to(moment.tick.time);
        const bool is_whole = wanted.later_positions || (moment.is_frame && left > 0);
        if (is_whole)
            velocities.skip();
        else
            simulation.forget_sample();
        if (moment.is_frame && left > 0) --left;
        see(moment,
            is_whole ? simulation.sample()
                     : velocities.after(simulation, moment.tick.time, advanced),
            advanced);
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
        if (frame.filed > 0) {
            collisions_.resize(frame.filed);
            recording_->file_->read(frame.place, room_of(collisions_.data(), frame.filed));
            advanced_.collisions = collisions_;
        }
        show_sample(frame.sample);
    }
    ++next_;
}

void Recording::Player::show_sample(std::size_t number) {
    if (number < recording_->samples_.size()) {
        sample_ = &recording_->samples_[number];
        return;
    }
    if (read_ != number) recording_->read_sample(number, from_file_);
    read_ = number;
    sample_ = &from_file_;
}

std::vector<RunFrame> RunsPlayer::frames() const {
    std::vector<RunFrame> frames;
    for (const Recording::Player& player : players_)
        frames.push_back({player.sample(), player.advanced()});
    return frames;
}

std::vector<Recording> RunsPlayer::rest(std::size_t end) const {
    std::vector<Recording> all;
    for (const Recording::Player& player : players_) all.push_back(player.rest(end));
    return all;
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

// Frames that share a sample also share it in the part. The file is shared with the whole
// recording.
void Recording::keep_part(const Recording& whole, std::size_t first, std::size_t end) {
    file_ = whole.file_;
    particles_ = whole.particles_;
    axes_ = whole.axes_;
    for (std::size_t i = first; i < end; ++i) {
        const Frame& frame = whole.frames_[i];
        if (i == first || frame.sample != whole.frames_[i - 1].sample) {
            if (frame.sample < whole.samples_.size())
                samples_.push_back(whole.samples_[frame.sample]);
            else
                filed_.push_back(whole.filed_[frame.sample - whole.samples_.size()]);
        }
        frames_.push_back(frame);
        frames_.back().sample = sample_count() - 1;
    }
}

// A copy that does not need the file.
Recording Recording::in_memory() const {
    Recording all;
    all.ticks_ = ticks_;
    all.with_collisions_ = with_collisions_;
    Player player(*this);
    for (const Frame& frame : frames_) {
        player.next();
        if (all.frames_.empty() || all.frames_.back().sample != frame.sample)
            all.samples_.push_back(player.sample());
        const std::span<const Collision> collisions = player.advanced().collisions;
        all.frames_.push_back(
            {frame.sample, frame.advanced, {collisions.begin(), collisions.end()}});
    }
    return all;
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
    const auto bytes = static_cast<double>(bytes_of_sample(particles, dimension) + sizeof(Frame)) *
                       static_cast<double>(frames);
    return bytes <= static_cast<double>(most_bytes) ||
           bytes <= static_cast<double>(ScratchFile::room());
}

// Whether all samples, particles and surfaces to which a frame refers by number exist.
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

// Validates a recording that was read from an archive.
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
    if (!archive.is_reading() && file_) return in_memory().archive(archive, box, particles, run);
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
