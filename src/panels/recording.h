// The run of a film, frame by frame: simulated once, and shown again as often as it is wanted. From
// memory, or where it is too large for that by simulating it again from its start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "physics/simulation.h"
#include "scene/time/timeline.h"

namespace carom {

class Archive;

class Recording {
  public:
    /// Sees a frame: the state of the gas, and what happened since the frame before. All are valid
    /// during the call only.
    using Viewer = std::function<void(const Tick&, const Sample&, const AdvanceResult&)>;

    /// Bytes of memory up to which a run is kept.
    static constexpr std::size_t most_bytes = 128 << 20;

    /// What is measured on the way, beyond the samples.
    struct Wanted {
        bool collisions = false;
        std::vector<double> return_times = {};  ///< in the first pass only
    };

    Recording() = default;

    /// Simulates the run at the times of `ticks`, which never fall, from a simulation at time 0;
    /// `see` sees each frame. Throws Interrupted, and what `see` and the simulation throw.
    Recording(Simulation start, std::vector<Tick> ticks, const Wanted& wanted, const Viewer& see,
              std::size_t most = most_bytes);

    /// Shows the frames again, in order: the same, bit for bit. Refers to the recording, of which
    /// any number may be shown at once, on any threads.
    class Player {
      public:
        explicit Player(const Recording& recording);

        /// Goes on to the next frame, the first one at first. Throws Interrupted, and
        /// std::out_of_range after the last one.
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
        const Recording* recording_;
        std::size_t next_ = 0;
        std::optional<Simulation> simulation_;  ///< of a run that is not kept
        const Sample* sample_ = nullptr;
        AdvanceResult advanced_;
    };

    /// The frames [first, end) alone: Player::rest() at the first. A run that is not kept is
    /// simulated up to there; several parts of it are had from one Player.
    Recording part(std::size_t first, std::size_t end) const;

    /// Shows the frames before number `end` to a viewer, counted from the first one that is here.
    void play(std::size_t end, const Viewer& see) const;

    /// Of the frames that are here, with their numbers in the whole film.
    const std::vector<Tick>& ticks() const { return ticks_; }

    /// Whether it is in memory. If not, each play() simulates.
    bool is_kept() const { return !start_.has_value(); }

    /// Whether `frames` of so many particles could be kept, but for their collisions.
    static bool fits(std::size_t frames, std::int64_t particles, int dimension);

    /// Writes or reads it, a part too; of what is not kept the exact state before its first frame,
    /// which is one of a simulation of this box and these particles in this run.
    void archive(Archive& archive, const Box& box, const Particles& particles, const Run& run);

  private:
    struct Frame {
        std::size_t sample = 0;  ///< frames that show one time share one
        AdvanceResult advanced;  ///< without collisions
        std::vector<Collision> collisions;

        template <class Archive>
        void archive(Archive& archive) {
            auto its = static_cast<std::int64_t>(sample);
            archive(its, advanced, collisions);
            sample = static_cast<std::size_t>(its);
        }
    };
    bool fits(const Frame& frame, const Box& box, Eigen::Index particles) const;
    bool fits_together(const Box& box, Eigen::Index particles) const;
    bool keep(const Sample& sample, const AdvanceResult& advanced, std::size_t most);
    void simulate(Simulation simulation, const Viewer& see) const;
    void keep_part(const Recording& whole, std::size_t first, std::size_t end);

    std::vector<Tick> ticks_;
    bool with_collisions_ = false;
    std::vector<Sample> samples_;
    std::vector<Frame> frames_;
    std::size_t bytes_ = 0;
    std::optional<Simulation> start_;  ///< of a run that is not kept, before its first frame
};

}  // namespace carom
