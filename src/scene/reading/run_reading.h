// The keys of `run`: its times, the events that act on the gas, and the captions, marks and pauses
// that the film shows during the run.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

/// Everything that `run` gives. Holds pointers to nodes of the scene, which must outlive it.
struct RunDraft : Run {
    std::vector<const Node*> event_nodes;  ///< one for each of its events
    const Node* precision = nullptr;       ///< the value of `precision`; null: not given
    const Node* ceiling = nullptr;  ///< the value of `most_collisions`, or `run` if it is not given
    const Node* step = nullptr;     ///< the value of `time_step`; null: not given
    std::vector<Mark> marks;        ///< in order of time; equal times in the order listed
    std::vector<Placed<Pause>> pauses;      ///< in order of time
    std::vector<Placed<Caption>> captions;  ///< in order of time; equal times in the order listed
};

/// The notation of the run of a gas in a box of one, two or three dimensions.
Notation<RunDraft> run_notation(int dimension);

/// Reports each caption that is not on the screen long enough to be read. The scene is complete;
/// `root` is its mapping. Checks nothing if the command line sets the length of the film or of the
/// run: a film shortened that way shows the captions as well as it can.
void check_captions(const Scene& scene, const std::vector<Placed<Caption>>& drafts,
                    const Node& root, Errors& errors);

}  // namespace carom
