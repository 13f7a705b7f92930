#include <algorithm>
#include <cmath>
#include <vector>

#include "films/cost/film_cost.h"
#include "films/first_pass.h"
#include "films/render.h"
#include "util/archive.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"

namespace carom {
namespace {

// The number of places, and the successive frames encoded at each, like the beginning of a segment:
// one key frame, then two complete groups of B frames, each with the P frame that follows it
// (media/codecs.cpp).
constexpr int places = 10, in_a_row = 9;

double bytes_of(FilmSegment& segment) {
    Archive archive;
    segment.archive(archive);
    return static_cast<double>(archive.finished().size());
}

// Draws and encodes the frames at these places of a plan.
class FrameSampler {
  public:
    FrameSampler(const FilmPlan& plan, FilmWriter& writer, Progress& progress)
        : plan_(plan), writer_(writer), progress_(progress), frames_(plan) {
        const int frames = plan.frames();
        row_ = std::min(in_a_row, frames);
        const int rows = std::clamp(frames / row_, 1, places);
        for (int k = 0; k < rows; ++k)
            firsts_.push_back(plan.span.first + k * frames / rows + (frames / rows - row_) / 2);
    }

    // The cost of the whole film, in which each segment begins with a key frame.
    FilmCost measure() {
        const auto end =
            static_cast<std::size_t>(firsts_.back() + row_ - plan_.ticks().front().frame);
        FramePainter painter(frames_.panels());
        progress_.begin("measuring", static_cast<double>(end));
        const Stopwatch watch;
        frames_.go_to(end, [&](const FrameData& frame, const AdvanceResult&) {
            encode(frame, painter);
            progress_.advance();
        });
        progress_.finish();
        const auto rows = static_cast<double>(firsts_.size());
        const double segments = static_cast<double>(plan_.segments.size()) - 1.0;
        const double change = row_ > 1 ? (all_ - whole_) / (rows * (row_ - 1)) : 0.0;
        FilmCost cost;
        cost.bytes = segments * whole_ / rows + (plan_.frames() - segments) * change;
        cost.seconds = plan_.frames() * encoding_seconds_ / (rows * (row_ + 1));
        played_seconds_ = watch.cpu() - encoding_seconds_;
        return cost;
    }

    double played_seconds() const { return played_seconds_; }

  private:
    void encode(const FrameData& frame, FramePainter& painter) {
        const int number = frame.tick.frame;
        const auto next = std::ranges::upper_bound(firsts_, number);
        if (next == firsts_.begin() || number >= *std::prev(next) + row_) return;
        throw_if_interrupted();
        const Stopwatch watch;
        const Canvas& canvas = painter.paint(frame);
        const int first = *std::prev(next), in_film = number - plan_.span.first;
        if (number == first) {
            const std::unique_ptr<FilmSegment> one = writer_.segment(in_film);
            one->add(canvas);
            one->finish();
            whole_ += bytes_of(*one);
            row_segment_ = writer_.segment(in_film);
        }
        row_segment_->add(canvas);
        if (number == first + row_ - 1) {
            row_segment_->finish();
            all_ += bytes_of(*row_segment_);
        }
        encoding_seconds_ += watch.cpu();
    }

    const FilmPlan& plan_;
    FilmWriter& writer_;
    Progress& progress_;
    FilmFrames frames_;
    int row_ = 1;
    std::vector<int> firsts_;
    std::unique_ptr<FilmSegment> row_segment_;
    double whole_ = 0.0, all_ = 0.0;  // bytes
    double encoding_seconds_ = 0.0, played_seconds_ = 0.0;
};

}  // namespace

FilmCost measured_cost(const Scene& scene, const FilmOptions& options, Progress& progress) {
    const Stopwatch watch;
    FilmOptions its = options;
    its.take = [](const FilmWriter&) {};
    const OutputFormat& format = format_of_film(options.output);
    const FilmPlan plan = prepare(scene, its, progress);
    const std::unique_ptr<FilmWriter> writer = film_writer(plan, its);
    if (!plan.colors.empty()) writer->use_colors(plan.colors);
    const double prepared_seconds = watch.cpu();
    FrameSampler sampler(plan, *writer, progress);
    FilmCost cost = sampler.measure();
    cost.format = format.name;
    cost.bytes += bytes_of_sound(scene, format, plan.frames());
    cost.seconds = prepared_seconds + sampler.played_seconds() + cost.seconds / options.threads;
    FilmCollisions collisions{.kept = plan.runs.front().keeps_collisions()};
    for (const Recording& run : plan.runs) collisions.count += run.collision_count();
    cost.memory = static_cast<double>(
        memory_of_film(scene, format, plan.particles().count(), collisions, options.threads));
    return cost;
}

}  // namespace carom
