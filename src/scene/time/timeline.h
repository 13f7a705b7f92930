// Which simulated time each frame of a film shows: the holds at both ends, the pause at a reversal,
// and frame times that are symmetric about a reversal, so that the way back mirrors the way out
// picture by picture.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "scene/time/pace.h"

namespace carom {

enum class Phase { title_card, opening, moving, reversing, pausing, closing, end_card };

/// One frame of a film.
struct Tick {
    int frame = 0;
    double time = 0.0;  ///< simulated
    Phase phase = Phase::moving;
    double progress =
        0.0;             ///< through the phase, from 0 to 1; of a pause the share that has passed
    Slowness slow = {};  ///< of the motion; in a pause of factor 0
    int reversals = 0;   ///< reversals up to this frame; one that is just announced counts from the
                         ///< middle of its pause
    double seconds = 0.0;  ///< of film, since the gas is shown; 0 in a title card
};

/// All frames of the film of `scene`, round(seconds * fps) of them, times never falling; the first
/// is at 0, the last at `until` (a single frame is at 0), and every reversal's time has one.
/// Opening 1.5 s, closing 2 s, 1 s for each reversal; together at most a quarter of the film,
/// scaled down in short ones. The scene's own pauses show exactly their time, after a reversal at
/// it. Slow motion takes more frames of the rest. Needs branch_count <= moving_steps, as every
/// loaded scene has it.
std::vector<Tick> timeline(const Scene& scene);

/// Where `time` lies on an axis that turns back at every reversal: elapsed time until the first
/// reversal, then running back.
double folded_time(const Run& run, double time);

/// Whether a frame shows words instead of the gas.
constexpr bool is_card(Phase phase) {
    return phase == Phase::title_card || phase == Phase::end_card;
}

/// Frames of the cards before and after a film, at most a third of it together.
struct CardFrames {
    int title = 0, end = 0;
};
CardFrames card_frames(const Film& film);

/// How much of the picture a card covers in a frame, from 0 to 1: all of its own frames, and less
/// and less of the gas in half a second after a title card, more and more before an end card.
double card_cover(const Film& film, const Tick& tick);

/// Seconds of both cards that a film asks for.
double card_seconds(const Film& film);

/// Seconds of all pauses that the scene asks for, and the most that they take of the film: half of
/// it without its cards. Where they are more, all are shorter in the same proportion.
double pause_seconds(const Film& film);
double most_pause_seconds(const Film& film);

/// The frames of each of its pauses.
std::vector<int> pause_frames(const Film& film);

/// The number of frames of a scene's film, cards included.
int frame_count(const Film& film);

/// The stretches of a run between its start, its reversals and its end.
int branch_count(const Run& run);

/// The steps from frame to frame in which the gas may move: the film without its cards and pauses.
/// At least 3/4 of the frames that are no cards and no pauses of the scene, less one.
int moving_steps(const Film& film, const Run& run);

/// First frames of the film's segments, and the number of frames as the last entry. A function of
/// the scene alone: a multiple of four (of cores) segments of at most 150 frames, two of them from
/// 40 frames on and one in shorter films, shorter where
/// many particles make a frame's data large.
std::vector<int> segment_starts(int frames, std::int64_t particles);

}  // namespace carom
