// The keys of `run`: its times, what happens to the gas, and what is said and marked in the film on
// the way.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

/// All that `run` says. Refers to the scene's nodes.
struct RunDraft : Run {
    std::vector<const Node*> event_nodes;   ///< of each of its events
    const Node* precision = nullptr;        ///< where it is given
    const Node* ceiling = nullptr;          ///< `most_collisions`, or the run where it is not given
    const Node* step = nullptr;             ///< where `time_step` is given
    std::vector<Mark> marks;                ///< in order of time; equal times in the order listed
    std::vector<Placed<Pause>> pauses;      ///< in order of time
    std::vector<Placed<Caption>> captions;  ///< in order of time; equal times in the order listed
};

/// The run of a box of one or two dimensions.
Notation<RunDraft> run_notation(int dimension);

/// Whether each of the captions stays long enough to be read, in a complete scene, of which `root`
/// is the mapping, with a film that is as long as its file says: one that the command line makes
/// shorter shows what it can.
void check_captions(const Scene& scene, const std::vector<Placed<Caption>>& drafts,
                    const Node& root, Errors& errors);

}  // namespace carom
