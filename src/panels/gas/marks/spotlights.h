// Spotlights: particles that stand out for a while because all others are dimmed. Independent of
// positions.
#pragma once

#include <vector>

#include "panels/chosen.h"
#include "panels/panel.h"
#include "scene/time/showing.h"

namespace carom {

class Spotlights {
  public:
    explicit Spotlights(const PanelContext& context);

    /// Takes the next sample, in order of time: who is in the light from now on.
    void see(const Sample& sample);

    /// The share of its colour that each particle keeps, from 0.35 to 1; empty if none is dimmed.
    std::vector<float> light(const Tick& tick, bool is_still = false) const;

    /// Single particles under a spotlight, and the strength of the light: they are marked by rings,
    /// so that they are found in a crowd.
    struct Ring {
        Eigen::Index particle;
        double share;
    };
    std::vector<Ring> rings(const Tick& tick, bool is_still = false) const;

  private:
    struct Light {
        Showing time;
        Members on;  ///< the particles in the light; the only one of a choice has a ring
    };
    double share(const Light& light, const Tick& tick, bool is_still) const;

    PanelContext context_;
    std::vector<Light> lights_;
};

/// The opacity, from 0 to 1, of something that is shown for a while: films fade it in and out,
/// stills and figures show it or not.
double share_of(const PanelContext& context, const Showing& time, const Tick& tick, bool is_still);

/// The duration of fading in, and of fading out.
constexpr double overlay_fade_seconds = 0.4;

}  // namespace carom
