#include "panels/gas/marks/streaks.h"

#include <algorithm>
#include <cmath>

#include "panels/archived.h"
#include "scene/film.h"

namespace carom {

Streaks::Streaks(const PanelContext& context)
    : shown_(context.film().streaks && context.in_film),
      fps_(context.film().fps),
      tolerance_(1e-4 * context.box().shortest_side()),
      count_(context.particles.count()),
      paths_(context.box(), velocity_changes(context.run())) {}

// How many frames before the end of a step a streak begins, at a later frame.
double Streaks::frames_left(const Step& step, int frame) const {
    return seconds * fps_ - (frame - step.frame);
}

// The simulated time in a step at which a streak begins.
double Streaks::begin_of(const Step& step, int frame) const {
    return std::max(step.from, step.to - frames_left(step, frame) * (step.to - step.from));
}

double Streaks::light_at(const Step& step, double time, int frame) const {
    const double age = (frame - step.frame) + (step.to - time) / (step.to - step.from);  // frames
    return std::clamp(1.0 - age / (seconds * fps_), 0.0, 1.0);
}

void Streaks::move(const FrameInput& input) {
    const int frame = input.tick.frame;
    while (!steps_.empty() && frames_left(steps_.front(), frame) <= 0.0) steps_.pop_front();
    const auto& collisions = input.advanced.collisions;
    if (input.sample.time <= last_time_)  // also the first frame
        return paths_(input.sample, collisions, [](const PathPiece&) {});
    Step step{.frame = frame, .from = last_time_, .to = input.sample.time, .pieces = {}};
    const double begin = begin_of(step, frame);
    paths_(input.sample, collisions, [&](const PathPiece& piece) {
        if (piece.to > begin) step.pieces.push_back(piece);
    });
    last_time_ = input.sample.time;
    steps_.push_back(std::move(step));
}

// Adds the corners of a path, the latest first.
void Streaks::add_path(StreakState& state, std::span<const Part> parts, int frame) const {
    Vec offset;
    double last = 1.0;
    const auto add = [&](const Step& step, double time) {
        last = light_at(step, time, frame);
        state.corners.push_back({static_cast<float>(offset[0]), static_cast<float>(offset[1]),
                                 static_cast<float>(last)});
    };
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        const auto& [step, piece] = *part;
        const double begin = std::max(piece->from, begin_of(*step, frame));
        const double span = piece->to - begin;
        if (!(span > 0.0)) continue;
        // The gas may have stood still since.
        if (light_at(*step, piece->to, frame) < last) add(*step, piece->to);
        constexpr double most_lines = 32.0;
        const double bend = length(piece->acceleration) * span * span / 8.0;
        const double lines = std::clamp(std::ceil(std::sqrt(bend / tolerance_)), 1.0, most_lines);
        Vec at = piece->place_after(piece->to - piece->from);
        for (double line = lines - 1.0; line >= 0.0; --line) {
            const double time = begin + span * line / lines;
            const Vec before = piece->place_after(time - piece->from);
            offset += before - at;
            at = before;
            add(*step, time);
        }
    }
}

std::shared_ptr<const StreakState> Streaks::see(const FrameInput& input) {
    if (!shown_) return nullptr;
    move(input);
    if (steps_.empty()) return nullptr;
    // The parts of all paths, those of one particle together and in order of time.
    std::vector<std::uint32_t> end(static_cast<std::size_t>(count_) + 1);
    const auto for_each = [&](const auto& see) {
        for (const Step& step : steps_)
            for (const PathPiece& piece : step.pieces)
                see(step, piece, static_cast<std::size_t>(piece.particle));
    };
    for_each([&](const Step&, const PathPiece&, std::size_t i) { ++end[i + 1]; });
    for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
    std::vector<Part> parts(end.back());
    std::vector<std::uint32_t> next = end;
    for_each([&](const Step& step, const PathPiece& piece, std::size_t i) {
        parts[next[i]++] = {&step, &piece};
    });
    auto state = std::make_shared<StreakState>();
    state->ends.reserve(static_cast<std::size_t>(count_));
    for (std::size_t i = 0; i + 1 < end.size(); ++i) {
        add_path(*state, std::span(parts).subspan(end[i], end[i + 1] - end[i]), input.tick.frame);
        state->ends.push_back(static_cast<std::uint32_t>(state->corners.size()));
    }
    return state;
}

void Streaks::archive_progress(Archive& archive) {
    if (shown_) archive(paths_, steps_, last_time_);
}

}  // namespace carom
