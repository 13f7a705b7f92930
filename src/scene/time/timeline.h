// The simulated time that each frame of a film shows: holds at both ends, a pause at each reversal,
// and frame times that are symmetric about a reversal, so that the way back mirrors the way out
// picture by picture.
#pragma once

#include <vector>

#include "physics/run.h"
#include "scene/time/pace.h"

namespace carom {

struct Film;
struct Scene;

enum class Phase { title_card, opening, moving, reversing, pausing, closing, end_card };

/// One frame of a film.
struct Tick {
    int frame = 0;
    double time = 0.0;  ///< simulated
    Phase phase = Phase::moving;
    double progress =
        0.0;             ///< through the phase, from 0 to 1; of a pause the share that has passed
    Slowness slow = {};  ///< of the motion; its factor is 0 in a pause
    int reversals = 0;   ///< reversals up to this frame; one that is just announced counts from the
                         ///< middle of its pause
    double seconds = 0.0;  ///< of film, since the gas is first shown; 0 in a title card
};

/// Returns all frames of the film of `scene`: round(seconds * fps) frames, whose times never
/// decrease. The first is at time 0, the last at `until` (a single frame is at 0), and each
/// reversal's time has a frame. The opening hold takes 1.5 s, the closing hold 2 s and any frames
/// left over, and the pause at each reversal 1 s; together at most a quarter of the film without
/// cards and pauses (not counting frames left over), scaled down in short films. The scene's own
/// pauses last exactly as long as given, after the reversal if they are at the time of one. Slow
/// motion takes more of the remaining frames. Requires branch_count <= moving_steps, which holds
/// for every loaded scene.
std::vector<Tick> timeline(const Scene& scene);

/// Returns the position of `time` on an axis that turns back at every reversal: elapsed time up to
/// the first reversal, then running backwards.
double folded_time(const Run& run, double time);

/// Returns whether a frame shows a card with words instead of the gas.
constexpr bool is_card(Phase phase) {
    return phase == Phase::title_card || phase == Phase::end_card;
}

/// The numbers of frames of the cards before and after a film, together at most a third of it.
struct CardFrames {
    int title = 0, end = 0;
};
CardFrames card_frames(const Film& film);

/// Returns how far a card has appeared in a frame, from 0 to 1: fully in all of its own frames; an
/// end card appears over the gas in the half second before.
double card_cover(const Film& film, const Tick& tick);

/// Returns the seconds of both cards that a film asks for.
double card_seconds(const Film& film);

/// Returns the seconds of all pauses that the scene asks for, and the most that they may take: half
/// of the film without its cards. If they ask for more, all are shortened in the same proportion.
double pause_seconds(const Film& film);
double most_pause_seconds(const Film& film);

/// Returns the number of frames of each pause.
std::vector<int> pause_frames(const Film& film);

/// Returns the number of frames of a scene's film, including cards.
int frame_count(const Film& film);

/// Returns the number of parts into which reversals divide a run.
int branch_count(const Run& run);

/// Returns the number of steps from frame to frame in which the gas may move: the film without its
/// cards, pauses and holds. At least 3/4 of the frames that belong to no card and no pause of the
/// scene, minus one.
int moving_steps(const Film& film, const Run& run);

/// Returns the first frame of each segment of a film, and the number of frames as the last entry.
/// Depends on its arguments alone, not on the machine. Segments have at most 150 frames, or less
/// (at least 30) if many particles make a frame's data large. Their number is a multiple of four
/// (for as many cores) in films of at least 120 frames, and at least two in films of at least 40.
std::vector<int> segment_starts(int frames, std::int64_t particles);

}  // namespace carom
