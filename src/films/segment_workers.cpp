#include "films/segment_workers.h"

#include <algorithm>
#include <system_error>

#include "util/interrupt.h"
#include "util/memory/kept_blocks.h"
#include "util/stopwatch.h"
#include "util/threads/on_threads.h"

namespace carom {
namespace {

constexpr std::size_t frame_overhead_bytes = 4096;  // of a FrameData without its arrays

std::size_t weight(const FrameData& data) { return data.bytes + frame_overhead_bytes; }

}  // namespace

SegmentWorkers::SegmentWorkers(const PanelSet& panels, std::vector<int> starts, int threads,
                               FilmWriter& writer, Progress& progress)
    : panels_(panels),
      writer_(writer),
      progress_(progress),
      starts_(std::move(starts)),
      next_frame_(starts_.front()) {
    for (std::size_t i = 0; i + 1 < starts_.size(); ++i)
        segments_.push_back({starts_[i + 1] - starts_[i], {}});
    most_ahead_ = 2 * std::min(static_cast<std::size_t>(threads), segments_.size());
    try {
        for (std::size_t i = 0; i < most_ahead_ / 2; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error& error) {
        stop();
        throw_no_threads(static_cast<int>(most_ahead_ / 2), error.what());
    } catch (...) {
        stop();
        throw;
    }
}

SegmentWorkers::~SegmentWorkers() { stop(); }

void SegmentWorkers::stop() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        if (thread.joinable()) thread.join();
}

void SegmentWorkers::frame(FrameData data) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || waiting_bytes_ < most_waiting_bytes; });
    rethrow_if_failed();
    std::size_t index = 0;
    while (starts_[index + 1] <= next_frame_) ++index;
    ++next_frame_;
    waiting_bytes_ += weight(data);
    segments_[index].waiting.push_back(std::move(data));
    changed_.notify_all();
}

WorkerSeconds SegmentWorkers::finish() {
    for (std::thread& thread : threads_) thread.join();
    rethrow_if_failed();
    return seconds_;
}

void SegmentWorkers::rethrow_if_failed() {
    if (error_) std::rethrow_exception(error_);
}

void SegmentWorkers::work() {
    try {
        const KeptBlocks kept;
        FramePainter painter(panels_);
        WorkerSeconds seconds;
        while (true) {
            std::size_t index = 0;
            {
                // Finished segments wait in memory to be joined. To bound it, no segment is begun
                // far ahead of the one to be joined next.
                std::unique_lock lock(mutex_);
                changed_.wait(
                    lock, [&] { return stop_ || next_segment_ < encoded_.next() + most_ahead_; });
                if (stop_ || next_segment_ == segments_.size()) break;
                index = next_segment_++;
            }
            draw_segment(index, painter, seconds);
        }
        const std::scoped_lock lock(mutex_);
        seconds_.draw += seconds.draw;
        seconds_.encode += seconds.encode;
    } catch (...) {
        fail(std::current_exception());
    }
}

void SegmentWorkers::draw_segment(std::size_t index, FramePainter& painter,
                                  WorkerSeconds& seconds) {
    std::unique_ptr<FilmSegment> segment = writer_.segment(starts_[index]);
    FrameData data;
    for (int i = 0; i < segments_[index].frames; ++i) {
        throw_if_interrupted();
        if (!take(index, data)) return;
        const Stopwatch drawing;
        const Canvas& canvas = painter.paint(data);
        seconds.draw += drawing.cpu();
        const Stopwatch encoding;
        segment->add(canvas);
        seconds.encode += encoding.cpu();
        progress_.advance();
    }
    const Stopwatch encoding;
    {
        const KeptBlocks::Collection for_the_next_encoder;
        segment->finish();
    }
    seconds.encode += encoding.cpu();
    join(index, std::move(segment));
}

bool SegmentWorkers::take(std::size_t index, FrameData& data) {
    std::unique_lock lock(mutex_);
    std::deque<FrameData>& waiting = segments_[index].waiting;
    changed_.wait(lock, [&] { return stop_ || !waiting.empty(); });
    if (stop_) return false;
    data = std::move(waiting.front());
    waiting.pop_front();
    waiting_bytes_ -= weight(data);
    changed_.notify_all();
    return true;
}

void SegmentWorkers::join(std::size_t index, std::unique_ptr<FilmSegment> segment) {
    const std::scoped_lock lock(mutex_);
    encoded_.add(index, std::move(segment), [](std::unique_ptr<FilmSegment> due) { due->join(); });
    changed_.notify_all();
}

void SegmentWorkers::fail(std::exception_ptr error) {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::move(error);
    stop_ = true;
    changed_.notify_all();
}

}  // namespace carom
