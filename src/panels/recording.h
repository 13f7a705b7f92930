// The run of a film, frame by frame: simulated once, and shown again as often as it is wanted. From
// memory, and beyond that from a temporary file; or where it is too large for both by simulating it
// again from its start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "physics/simulation.h"
#include "scene/time/timeline.h"
#include "util/files/scratch_file.h"

namespace carom {

class Archive;

/// How many bytes of a run are kept: in memory, and of what is more in a temporary file.
struct RecordingRoom {
    static constexpr std::size_t most_memory = 128 << 20;
    std::size_t memory = most_memory;
    std::int64_t file = ScratchFile::most_bytes;
};

class Recording {
  public:
    /// Sees a frame: the state of the gas, and what happened since the frame before. All are valid
    /// during the call only.
    using Viewer = std::function<void(const Tick&, const Sample&, const AdvanceResult&)>;

    using Room = RecordingRoom;
    static constexpr std::size_t most_bytes = Room::most_memory;

    /// What is measured on the way, beyond the samples.
    struct Wanted {
        bool collisions = false;
        bool first_collisions = false;          ///< in the first pass only
        std::vector<double> return_times = {};  ///< in the first pass only
        bool aside = false;  ///< the first pass is seen on a thread of its own, as it is simulated
    };

    Recording() = default;

    /// Simulates the run at the times of `ticks`, which never fall, from a simulation at time 0;
    /// `see` sees each frame. Throws Interrupted, and what `see` and the simulation throw.
    Recording(Simulation start, std::vector<Tick> ticks, const Wanted& wanted, const Viewer& see,
              const Room& room = {});

    /// Shows the frames again, in order: the same, bit for bit. Refers to the recording, of which
    /// any number may be shown at once, on any threads.
    class Player {
      public:
        explicit Player(const Recording& recording);
        Player(const Player&) = delete;
        Player& operator=(const Player&) = delete;

        /// Goes on to the next frame, the first one at first. Throws Interrupted, SystemError where
        /// a temporary file cannot be read, and std::out_of_range after the last one.
        void next();

        /// The present frame; valid until next().
        const Tick& tick() const { return recording_->ticks_[next_ - 1]; }
        const Sample& sample() const { return *sample_; }
        const AdvanceResult& advanced() const { return advanced_; }

        /// How many frames it has shown; the next one has this number.
        std::size_t shown() const { return next_; }

        /// The frames from the next one on and before number `end`, as a recording of its own,
        /// which shows them as this one would, bit for bit. Throws std::out_of_range where that is
        /// beyond the last one.
        Recording rest(std::size_t end) const;

      private:
        void show_sample(std::size_t number);

        const Recording* recording_;
        std::size_t next_ = 0;
        std::optional<Simulation> simulation_;  ///< of a run that is not kept
        const Sample* sample_ = nullptr;
        AdvanceResult advanced_;
        std::optional<std::size_t> read_;  ///< the sample that `from_file_` is
        Sample from_file_;
        std::vector<Collision> collisions_;  ///< of the present frame, where they are in the file
    };

    /// The frames [first, end) alone: Player::rest() at the first. A run that is not kept is
    /// simulated up to there; several parts of it are had from one Player.
    Recording part(std::size_t first, std::size_t end) const;

    /// Shows the frames before number `end` to a viewer, counted from the first one that is here.
    void play(std::size_t end, const Viewer& see) const;

    /// Of the frames that are here, with their numbers in the whole film.
    const std::vector<Tick>& ticks() const { return ticks_; }

    /// Whether it is in memory or in a file. If not, each play() simulates.
    bool is_kept() const { return !start_.has_value(); }

    /// How many collisions the whole run has had, walls included, and whether it keeps them.
    double collision_count() const { return collision_count_; }
    bool keeps_collisions() const { return with_collisions_; }

    /// Whether `frames` of so many particles could be kept, but for their collisions, and as long
    /// as nothing else fills the disk.
    static bool fits(std::size_t frames, std::int64_t particles, int dimension);

    /// Writes or reads it, a part too; of what is not kept the exact state before its first frame,
    /// which is one of a simulation of this box and these particles in this run.
    void archive(Archive& archive, const Box& box, const Particles& particles, const Run& run);

  private:
    struct Frame {
        std::size_t sample = 0;  ///< frames that show one time share one
        AdvanceResult advanced;  ///< without collisions
        std::vector<Collision> collisions;
        std::int64_t place = 0;  ///< of its collisions in the file
        std::size_t filed = 0;   ///< how many there are

        template <class Archive>
        void archive(Archive& archive) {
            auto its = static_cast<std::int64_t>(sample);
            archive(its, advanced, collisions);
            sample = static_cast<std::size_t>(its);
        }
    };
    struct FiledSample {
        double time = 0.0;
        std::int64_t place = 0;  ///< in the file
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
    void simulate(Simulation simulation, bool with_collisions, const Viewer& see) const;
    void keep_part(const Recording& whole, std::size_t first, std::size_t end);
    Recording in_memory() const;

    std::vector<Tick> ticks_;
    bool with_collisions_ = false;
    double collision_count_ = 0.0;
    std::vector<Sample> samples_;     ///< the first ones
    std::vector<FiledSample> filed_;  ///< those after them
    std::vector<Frame> frames_;
    std::size_t bytes_ = 0;                  ///< of memory
    std::shared_ptr<ScratchFile> file_;      ///< none: all is in memory
    Eigen::Index particles_ = 0, axes_ = 0;  ///< of a sample in the file
    std::optional<Simulation> start_;        ///< of a run that is not kept, before its first frame
};

}  // namespace carom
