// Callouts to particles: which there are at a moment, and the way of each particle meanwhile, by
// which the words find a place of their own that does not move.
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

    /// First pass, every frame in order; `places` as they are drawn.
    void survey(const FrameInput& input, const Eigen::ArrayXXd& places);
    void archive(auto& archive) { archive(ways_); }

    /// Where a particle is in a frame, which is counted from 0 for the first one surveyed.
    struct Step {
        std::int64_t frame = 0;
        double x = 0.0, y = 0.0;
        void archive(auto& archive) { archive(frame, x, y); }
    };

    /// One that is seen at a moment.
    struct Present {
        std::size_t index = 0;
        Eigen::Index particle = 0;
        double share = 0.0;  ///< how much of it is seen
    };
    std::vector<Present> at(const Tick& tick, bool is_still) const;

    /// Where the words of each of those stand, in all frames in which it is seen. `place_of(way,
    /// particle, plate, others)` finds a place for one beside others.
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
