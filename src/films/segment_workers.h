// Draws and encodes (or stores) the segments of a film, each segment on one core, and joins them in
// order. The resulting file depends only on the frames, not on the number of workers. Memory is
// bounded.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "films/in_order.h"
#include "media/film_writer.h"
#include "panels/frame.h"
#include "util/progress.h"

namespace carom {

/// Upper limit for the bytes of frames that wait to be drawn.
inline constexpr std::size_t most_waiting_bytes = 64 << 20;

/// CPU seconds, summed over all workers.
struct WorkerSeconds {
    double draw = 0.0;
    double encode = 0.0;  ///< including conversion of the pictures
};

class SegmentWorkers {
  public:
    /// `panels`, `writer` and `progress` must outlive the workers. `starts` as from
    /// segment_starts(). Throws SystemError if threads cannot be started.
    SegmentWorkers(const PanelSet& panels, std::vector<int> starts, int threads, FilmWriter& writer,
                   Progress& progress);
    ~SegmentWorkers();  ///< stops the workers at once, without finishing

    /// Adds the next frame, in order. Blocks while most_waiting_bytes or more wait to be drawn;
    /// rethrows an error of a worker.
    void frame(FrameData data);

    /// Waits until all frames are drawn and joined; rethrows an error of a worker.
    WorkerSeconds finish();

  private:
    struct Segment {
        int frames = 0;  ///< when complete
        std::deque<FrameData> waiting;
    };

    void stop();
    void work();
    void draw_segment(std::size_t index, FramePainter& painter, WorkerSeconds& seconds);
    bool take(std::size_t index, FrameData& data);
    void join(std::size_t index, std::unique_ptr<FilmSegment> segment);
    void fail(std::exception_ptr error);
    void rethrow_if_failed();

    const PanelSet& panels_;
    FilmWriter& writer_;
    Progress& progress_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<int> starts_;
    std::vector<Segment> segments_;
    std::size_t most_ahead_ = 0;    ///< segments that may be begun before the next is joined
    std::size_t next_segment_ = 0;  ///< the next to be taken by a worker
    InOrder<std::unique_ptr<FilmSegment>> encoded_;  ///< joined to the film one after the other
    int next_frame_;  ///< index of the next frame, counted like the starts
    std::size_t waiting_bytes_ = 0;
    bool stop_ = false;
    std::exception_ptr error_;
    WorkerSeconds seconds_;
    std::vector<std::thread> threads_;
};

}  // namespace carom
