// From the checked `run` of a scene to values: its times, what happens to the gas, and what is said
// and marked in the film on the way.
#pragma once

#include <vector>

#include "scene/keys/fields.h"
#include "scene/scene.h"

namespace carom {

/// A caption and where it is written.
struct CaptionDraft {
    Caption caption;
    const Node* node;
};

/// All that `run` says. Refers to the scene's nodes.
struct RunDraft {
    Run run;
    std::vector<const Node*> event_nodes;  ///< of each of run.events
    const Node* precision = nullptr;       ///< where it is given
    std::vector<Mark> marks;               ///< in order of time; equal times in the order listed
    std::vector<CaptionDraft> captions;    ///< in order of time; equal times in the order listed
};

RunDraft read_run(const Fields& scene, Errors& errors);

/// Whether nudges have their particles, and numbers of so few bits room for them.
void check_nudges(const RunDraft& draft, const Gas& gas, Errors& errors);

/// Whether each of the captions stays long enough to be read, in a complete scene with a film that
/// is as long as its file says: one that the command line makes shorter shows what it can.
void check_captions(const Scene& scene, const std::vector<CaptionDraft>& drafts,
                    const Fields& fields, Errors& errors);

}  // namespace carom
