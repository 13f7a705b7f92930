// The paths of disks during the last moment of a film, as a shutter would record them. Independent
// of the canvas.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "panels/panel.h"
#include "stats/paths/paths.h"

namespace carom {

/// The paths of all disks that end in one frame.
struct StreakState {
    struct Corner {
        float x, y;   ///< from where the disk is now, length; not wrapped into a periodic box
        float light;  ///< from 0, where the streak ends, to 1, where the disk is
    };
    std::vector<std::uint32_t> ends;  ///< of each particle, of its corners
    std::vector<Corner> corners;      ///< of each particle, from the disk backwards

    /// The corners of a path behind its disk; none if the disk has not moved.
    std::span<const Corner> of(std::size_t particle) const {
        const std::uint32_t first = particle > 0 ? ends[particle - 1] : 0;
        return std::span(corners).subspan(first, ends[particle] - first);
    }
    std::size_t bytes() const {
        return ends.size() * sizeof ends.front() + corners.size() * sizeof(Corner);
    }
};

class Streaks {
  public:
    static constexpr double seconds = 1.0 / 60.0;  ///< of film, that a streak lasts

    explicit Streaks(const PanelContext& context);

    bool shown() const { return shown_; }

    /// Called for every frame in order, with the collisions since the frame before. The paths of
    /// the last `seconds` of film, with a corner at each collision and curved by gravity; null if
    /// streaks are not shown or nothing has moved.
    std::shared_ptr<const StreakState> see(const FrameInput& input);

    void archive_progress(Archive& archive);

  private:
    struct Step {  // of the film in which the gas has moved, from one frame to the next
        int frame = 0;
        double from = 0.0, to = 0.0;  // simulated
        std::vector<PathPiece> pieces;
        void archive(auto& archive) { archive(frame, from, to, pieces); }
    };
    struct Part {  // of a path
        const Step* step;
        const PathPiece* piece;
    };
    double frames_left(const Step& step, int frame) const;
    double begin_of(const Step& step, int frame) const;
    double light_at(const Step& step, double time, int frame) const;
    void move(const FrameInput& input);
    void add_path(StreakState& state, std::span<const Part> parts, int frame) const;

    bool shown_;
    double fps_;
    double tolerance_;  // length, of curves drawn as lines
    Eigen::Index count_;
    Paths paths_;
    std::deque<Step> steps_;  // those of the last `seconds`
    double last_time_ = 0.0;
};

}  // namespace carom
