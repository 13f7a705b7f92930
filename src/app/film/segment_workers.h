// Draws and encodes (or stores) the segments of a film, one segment on one core, and joins them in
// order. The file depends on the frames alone, not on the number of workers; the memory is bounded.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "app/film/in_order.h"
#include "app/progress.h"
#include "media/film_writer.h"
#include "panels/frame.h"

namespace carom {

/// Bytes of frames that wait to be drawn, at most.
inline constexpr std::size_t most_waiting_bytes = 64 << 20;

/// CPU seconds spent by all workers together.
struct WorkerSeconds {
    double draw = 0.0;
    double encode = 0.0;  ///< conversion included
};

class SegmentWorkers {
  public:
    /// `writer` and the others must outlive the workers. `starts` as from segment_starts(). Throws
    /// SystemError when threads cannot be started.
    SegmentWorkers(const PanelSet& panels, std::vector<int> starts, int threads, FilmWriter& writer,
                   Progress& progress);
    ~SegmentWorkers();  ///< stops at once

    /// The next frame in order. Waits while too much waits to be drawn; rethrows a worker's error.
    void frame(FrameData data);

    /// Waits until all is drawn and joined; rethrows a worker's error.
    WorkerSeconds finish();

  private:
    struct Segment {
        int frames = 0;  ///< that it will have
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
    std::size_t most_ahead_ = 0;    ///< segments taken before the one to be joined next is done
    std::size_t next_segment_ = 0;  ///< to be taken by a worker
    InOrder<std::unique_ptr<FilmSegment>> encoded_;  ///< joined to the film one after the other
    int next_frame_;                                 ///< counted as the starts are
    std::size_t waiting_bytes_ = 0;
    bool stop_ = false;
    std::exception_ptr error_;
    WorkerSeconds seconds_;
    std::vector<std::thread> threads_;
};

}  // namespace carom
