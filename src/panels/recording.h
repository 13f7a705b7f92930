// The moments of the first pass over a run: the frames of a film, or the times that figures show,
// and the samples of the run, which belong to its statistics whatever is shown. And the run of a
// film, frame by frame: simulated once, and replayed any number of times. It is kept in memory, and
// what exceeds that in a temporary file; a run that is too large for both is replayed by simulating
// it again from its start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physics/run.h"
#include "physics/simulation.h"
#include "scene/time/timeline.h"
#include "util/files/scratch_file.h"

namespace carom {

class Archive;

/// A moment of the first pass.
struct SeenMoment {
    Tick tick;
    bool is_frame = true, is_sample = true;  ///< or both
};

/// The times at which statistics are taken, in order: the samples of the run, and its events.
std::vector<double> measured_times(const Run& run);

/// The frames, and the measured times of the run up to the last frame. A measured time that frames
/// show is the first of these frames that is no card.
std::vector<SeenMoment> moments_of(const std::vector<Tick>& ticks, const Run& run);

/// The frames alone, each of which also counts as a sample.
std::vector<SeenMoment> moments_of(const std::vector<Tick>& ticks);

/// Joins the collisions of several advances.
class JoinedCollisions {
  public:
    void add(std::span<const Collision> collisions) {
        before_.insert(before_.end(), collisions.begin(), collisions.end());
    }

    /// Gives all that were added, followed by `last`, and starts again; valid until the next call.
    std::span<const Collision> take(std::span<const Collision> last) {
        if (before_.empty()) return last;
        add(last);
        taken_.swap(before_);
        before_.clear();
        return taken_;
    }

  private:
    std::vector<Collision> before_, taken_;
};

/// The limits of what is kept of a run, in bytes: in memory, and of the rest in a temporary file.
struct RecordingRoom {
    static constexpr std::size_t most_memory = 128 << 20;
    std::size_t memory = most_memory;
    std::int64_t file = ScratchFile::most_bytes;
};

class Recording {
  public:
    /// Receives a frame: the state of the gas, and what happened since the frame before. The
    /// arguments are valid during the call only.
    using Viewer = std::function<void(const Tick&, const Sample&, const AdvanceResult&)>;

    /// Receives a moment of the first pass: the state of the gas, what happened since the moment
    /// before and, at a frame, the collisions since the frame before. Valid during the call only.
    using FirstViewer = std::function<void(const SeenMoment&, const Sample&, const AdvanceResult&,
                                           std::span<const Collision> since_frame)>;

    using Room = RecordingRoom;
    static constexpr std::size_t most_bytes = Room::most_memory;

    /// What is recorded besides the samples, and how much of the run.
    struct Wanted {
        bool collisions = false;
        bool first_collisions = false;           ///< in the first pass only
        std::vector<double> return_times = {};   ///< in the first pass only
        std::optional<std::size_t> frames = {};  ///< that are kept and replayed, the first ones;
                                                 ///< none: all
        bool later_positions = true;  ///< in samples of the first pass after these frames
        bool aside = false;  ///< frames of the first pass are seen on a separate thread, in
                             ///< parallel with the simulation
    };

    Recording() = default;

    /// A run that is simulated whenever it is played, without a first pass.
    Recording(Simulation start, std::vector<Tick> ticks, bool with_collisions)
        : ticks_(std::move(ticks)), with_collisions_(with_collisions), start_(std::move(start)) {}

    /// Simulates the run at the times of `ticks`, which must not decrease, from a simulation at
    /// time 0, and calls `see` for each frame. Throws Interrupted, and what `see` and the
    /// simulation throw.
    Recording(Simulation start, std::vector<Tick> ticks, const Wanted& wanted, const Viewer& see,
              const Room& room = {});

    /// The same for moments of which only the frames are kept and replayed; `see` is called for
    /// each moment.
    Recording(Simulation start, const std::vector<SeenMoment>& moments, const Wanted& wanted,
              const FirstViewer& see, const Room& room = {});

    /// Replays the frames in order, bit for bit the same. Holds a reference to the recording.
    /// Thread safety: any number of players may replay one recording at the same time, each on its
    /// own thread.
    class Player {
      public:
        explicit Player(const Recording& recording);
        Player(const Player&) = delete;
        Player& operator=(const Player&) = delete;

        /// Advances to the next frame; the first call, to the first frame. Throws Interrupted,
        /// SystemError if the temporary file cannot be read, and std::out_of_range after the last
        /// frame.
        void next();

        /// The present frame; valid until next().
        const Tick& tick() const { return recording_->ticks_[next_ - 1]; }
        const Sample& sample() const { return *sample_; }
        const AdvanceResult& advanced() const { return advanced_; }

        /// The number of frames shown so far, which is also the number of the next one.
        std::size_t shown() const { return next_; }

        /// The frames from the next one up to but excluding number `end`, as a separate recording,
        /// which replays them bit for bit as this one would. Throws std::out_of_range if `end` is
        /// beyond the last frame.
        Recording rest(std::size_t end) const;

      private:
        void show_sample(std::size_t number);

        const Recording* recording_;
        std::size_t next_ = 0;
        std::optional<Simulation> simulation_;  ///< used for a run that is not kept
        const Sample* sample_ = nullptr;
        AdvanceResult advanced_;
        std::optional<std::size_t> read_;  ///< number of the sample in `from_file_`
        Sample from_file_;
        std::vector<Collision> collisions_;  ///< of the present frame, if read from the file
    };

    /// The frames [first, end) alone, as Player::rest() gives them at `first`. A run that is not
    /// kept is simulated up to there, so take several parts of it from one Player.
    Recording part(std::size_t first, std::size_t end) const;

    /// Calls `see` for the frames before number `end`, counted from the first frame of this
    /// recording.
    void play(std::size_t end, const Viewer& see) const;

    /// The ticks of the frames of this recording, with their numbers in the whole film.
    const std::vector<Tick>& ticks() const { return ticks_; }

    /// Whether the run is kept in memory or in a file. If not, each play() simulates it.
    bool is_kept() const { return !start_.has_value(); }

    /// The number of collisions in the whole run, walls included, and whether they are kept.
    double collision_count() const { return collision_count_; }
    bool keeps_collisions() const { return with_collisions_; }

    /// Whether `frames` frames of this many particles could be kept, without their collisions and
    /// if nothing else fills the disk.
    static bool fits(std::size_t frames, std::int64_t particles, int dimension);

    /// Writes or reads the recording, which may be a part. Of a run that is not kept, the exact
    /// state before its first frame is written, which is the state of a simulation of this box and
    /// these particles in this run.
    void archive(Archive& archive, const Box& box, const Particles& particles, const Run& run);

  private:
    struct Frame {
        std::size_t sample = 0;  ///< index; frames of the same time share a sample
        AdvanceResult advanced;  ///< without collisions
        std::vector<Collision> collisions;
        std::int64_t place = 0;  ///< position of its collisions in the file
        std::size_t filed = 0;   ///< number of collisions in the file

        template <class Archive>
        void archive(Archive& archive) {
            auto index = static_cast<std::int64_t>(sample);
            archive(index, advanced, collisions);
            sample = static_cast<std::size_t>(index);
        }
    };
    struct FiledSample {
        double time = 0.0;
        std::int64_t place = 0;  ///< in the file
        std::shared_ptr<const Membership> membership = {};
    };
    bool fits(const Frame& frame, const Box& box, Eigen::Index particles) const;
    bool fits_together(const Box& box, Eigen::Index particles) const;
    bool keep(const Sample& sample, const AdvanceResult& advanced, const Room& room);
    bool keep_in_file(const Sample& sample, bool is_new, std::span<const Collision> collisions,
                      Frame& frame);
    std::size_t sample_count() const { return samples_.size() + filed_.size(); }
    double time_of_last_sample() const;
    void read_sample(std::size_t number, Sample& to) const;
    void forget();
    using Advances = std::function<void(const SeenMoment&, const Sample&, const AdvanceResult&)>;
    static void simulate(Simulation simulation, const std::vector<SeenMoment>& moments,
                         const Wanted& wanted, const Advances& see);
    static void see_aside(const std::function<void(const Advances&)>& simulate,
                          const Advances& see);
    void keep_part(const Recording& whole, std::size_t first, std::size_t end);
    Recording in_memory() const;

    std::vector<Tick> ticks_;
    bool with_collisions_ = false;
    double collision_count_ = 0.0;
    std::vector<Sample> samples_;     ///< the first samples, in memory
    std::vector<FiledSample> filed_;  ///< the samples after them, in the file
    std::vector<Frame> frames_;
    std::size_t bytes_ = 0;                  ///< used in memory
    std::shared_ptr<ScratchFile> file_;      ///< none: all is in memory
    Eigen::Index particles_ = 0, axes_ = 0;  ///< of a sample in the file
    std::optional<Simulation> start_;        ///< of a run that is not kept, before its first frame
};

/// What a frame shows of one run: its state, and what happened since the frame before.
struct RunFrame {
    const Sample& sample;
    const AdvanceResult& advanced;
};

/// Replays recordings with the same ticks, those of the runs that a film shows, in step. Holds
/// references to them; there must be at least one.
class RunsPlayer {
  public:
    explicit RunsPlayer(std::span<const Recording> runs) {
        for (const Recording& run : runs) players_.emplace_back(run);
    }

    /// Advances to the next frame; the first call, to the first frame. Throws as
    /// Recording::Player::next().
    void next() {
        for (Recording::Player& player : players_) player.next();
    }

    /// The present frame; valid until next().
    const Tick& tick() const { return players_.front().tick(); }
    std::vector<RunFrame> frames() const;

    /// As Recording::Player::shown(), and the rest of each recording as Recording::Player::rest().
    std::size_t shown() const { return players_.front().shown(); }
    std::vector<Recording> rest(std::size_t end) const;

  private:
    std::deque<Recording::Player> players_;
};

}  // namespace carom
