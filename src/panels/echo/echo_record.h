// How far a reversed gas is from where it was: the return distances that the first pass measures,
// and how far it should be by the growth law. Draws nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "physics/exact_positions.h"

namespace carom {

/// The times at which a pass over a film measures return distances (Simulation::measure_return()):
/// those of as many frames as memory allows.
std::vector<double> return_times(const Scene& scene, Eigen::Index particles,
                                 const std::vector<Tick>& ticks);

class EchoRecord {
  public:
    /// One comparison; it holds until the next.
    struct Step {
        int frame;              ///< the first that shows it
        std::size_t reversal;   ///< which one it is measured from, counted from 0
        double since;           ///< simulated time since then
        double collisions;      ///< since then, of each particle with others, on average
        ReturnDistance apart;   ///< lengths
        bool is_known = false;  ///< false: the gas goes on to where it has never been
        double log10_law = std::numeric_limits<double>::quiet_NaN();  ///< of the largest distance,
                                                                      ///< where there is a law

        void archive(auto& archive) {
            archive(frame, reversal, since, collisions, apart, is_known, log10_law);
        }
    };

    explicit EchoRecord(const PanelContext& context);

    /// First pass, every frame in order; it measures at return_times().
    void survey(const FrameInput& input);

    /// Writes or reads the steps.
    void archive(auto& archive) { archive(steps_); }

    /// In order of time, from the first reversal on.
    const std::vector<Step>& steps() const { return steps_; }

    /// How many of the steps a frame shows: those up to it.
    std::size_t shown(int frame) const;

    /// The distance in a frame; none before a reversal, and where there is none.
    std::optional<ReturnDistance> at(int frame) const;

    /// Times of the reversals.
    const std::vector<double>& reversals() const { return reversals_; }

    /// By how many bits the law says that the distance grows with each collision of a particle;
    /// none where there is no law for this gas.
    const std::optional<double>& bits_per_collision() const { return bits_per_collision_; }

  private:
    double log10_law(const Step& step) const;

    PanelContext context_;
    std::vector<double> reversals_;
    std::vector<std::int64_t> collisions_until_;  ///< each reversal, of all particles with others
    std::optional<double> bits_per_collision_;
    int stride_ = 1;  ///< one of so many frames is kept
    std::vector<Step> steps_;
};

}  // namespace carom
