// The distance of a reversed gas from the states that it came from: the return distances measured
// in the first pass, and the distances that the growth law predicts. Draws nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "physics/exact_positions.h"

namespace carom {

/// The times at which the pass over a film measures return distances
/// (Simulation::measure_return()): those of every frame, or of every n-th frame if memory does not
/// allow more, and always the reversals and the end.
std::vector<double> return_times(const Scene& scene, Eigen::Index particles,
                                 const std::vector<Tick>& ticks);

class EchoRecord {
  public:
    /// One measured distance; shown until the next one.
    struct Step {
        int frame;              ///< first frame that shows it
        std::size_t reversal;   ///< reversal from which it is measured, counted from 0
        double since;           ///< simulated time since then
        double collisions;      ///< since then: mean number per particle, walls not counted
        ReturnDistance apart;   ///< lengths
        bool is_known = false;  ///< false: the gas is past its initial state, with no earlier state
                                ///< to compare with
        double log10_law = std::numeric_limits<double>::quiet_NaN();  ///< of the largest distance,
                                                                      ///< where there is a law

        void archive(auto& archive) {
            archive(frame, reversal, since, collisions, apart, is_known, log10_law);
        }
    };

    explicit EchoRecord(const PanelContext& context);

    /// First pass: called for every frame in order; takes the distances that were measured at
    /// return_times().
    void survey(const FrameInput& input);

    /// Writes or reads the steps.
    void archive(auto& archive) { archive(steps_); }

    /// The measured steps in order of time, from the first reversal on.
    const std::vector<Step>& steps() const { return steps_; }

    /// The number of steps up to a frame, which it shows.
    std::size_t shown(int frame) const;

    /// The distance that a frame shows; none before the first reversal and while none is known.
    std::optional<ReturnDistance> at(int frame) const;

    /// Times of the reversals.
    const std::vector<double>& reversals() const { return reversals_; }

    /// The growth of the distance by the law, in bits per collision of a particle; none if no law
    /// is known for this gas.
    const std::optional<double>& bits_per_collision() const { return bits_per_collision_; }

  private:
    double log10_law(const Step& step) const;

    PanelContext context_;
    std::vector<double> reversals_;
    std::vector<std::int64_t> collisions_until_;  ///< each reversal, between all particles
    std::optional<double> bits_per_collision_;
    int stride_ = 1;  ///< one in `stride_` frames is kept
    std::vector<Step> steps_;
};

}  // namespace carom
