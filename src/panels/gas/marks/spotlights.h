// Spotlights: particles that stand out for a while, as all others are dimmed. Knows no places.
#pragma once

#include <vector>

#include "panels/panel.h"
#include "scene/time/showing.h"

namespace carom {

class Spotlights {
  public:
    explicit Spotlights(const PanelContext& context);

    /// How much of its colour each particle keeps, from 0.35 to 1; empty where all keep theirs.
    std::vector<float> light(const Tick& tick, bool is_still = false) const;

    /// Single particles that a spotlight is on, and how much of it: rings tell them from a crowd.
    struct Ring {
        Eigen::Index particle;
        double share;
    };
    std::vector<Ring> rings(const Tick& tick, bool is_still = false) const;

  private:
    struct Light {
        Showing time;
        std::vector<Eigen::Index> on;      ///< all that it is on
        std::vector<Eigen::Index> single;  ///< those of them that are named one by one
    };
    double share(const Light& light, const Tick& tick, bool is_still) const;

    PanelContext context_;
    std::vector<Light> lights_;
};

/// How much is seen of something that is shown for a while: in films it comes and goes, stills and
/// figures show it or not.
double share_of(const PanelContext& context, const Showing& time, const Tick& tick, bool is_still);

/// How long it takes to come and to go.
constexpr double overlay_fade_seconds = 0.4;

}  // namespace carom
