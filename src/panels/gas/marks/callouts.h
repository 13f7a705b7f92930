// Callouts to particles: which are shown at a moment, and the path of each particle while its
// callout is shown. From these paths each callout gets a place that does not move.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "panels/callouts/callout.h"
#include "panels/panel.h"
#include "scene/time/showing.h"

namespace carom {

class Callouts {
  public:
    explicit Callouts(const PanelContext& context);
    bool any() const { return !callouts_.empty(); }

    /// First pass, every frame in order; `places` are the positions as drawn.
    void survey(const FrameInput& input, const Eigen::ArrayXXd& places);
    void archive(auto& archive) { archive(ways_); }

    /// The position of a particle in a frame; frames are counted from 0, the first one surveyed.
    struct Step {
        std::int64_t frame = 0;
        Vec at;
        void archive(auto& archive) { archive(frame, at); }
    };

    /// A callout that is shown at a moment.
    struct Present {
        std::size_t index = 0;
        Eigen::Index particle = 0;
        double share = 0.0;  ///< opacity, from 0 to 1
    };
    std::vector<Present> at(const Tick& tick, bool is_still) const;

    /// The places of the plates of the callouts in `present`; each place is the same in all frames
    /// that show the callout. `place_of(way, particle, plate, others)` finds a place for one plate,
    /// given the places of others.
    using PlaceOf = std::function<Rect(const std::vector<Step>& way, Eigen::Index particle,
                                       const CalloutPlate& plate, std::span<const Rect> others)>;
    struct Standing {
        Present callout;
        CalloutPlate plate;
        Rect place;
    };
    std::vector<Standing> standing(const std::vector<Present>& present, const DrawContext& dc,
                                   double most_width, const PlaceOf& place_of) const;

  private:
    PanelContext context_;
    struct Timed {
        Eigen::Index particle;
        const Callout* callout;
    };
    std::vector<Timed> callouts_;
    std::vector<Showing> times_;           ///< of each
    std::vector<std::vector<Step>> ways_;  ///< of each
    std::int64_t surveyed_ = 0;
};

}  // namespace carom
