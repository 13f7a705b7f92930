// How far a reversed gas is from where it was on the way out: the distance between its state and
// the mirror state, which is as long before the last reversal as the present is after it; and how
// far it should be by the growth law. Owns the comparison; draws nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "physics/exact_positions.h"

namespace carom {

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
    };

    explicit EchoRecord(const PanelContext& context);

    /// First pass, every frame in order: keeps where the particles are after a reversal, of as many
    /// frames as memory allows.
    void survey(const FrameInput& input);

    /// Runs the gas once more, to see the way out at the very times that mirror those kept; a gas
    /// of many bits on both ways, to compare them in full.
    void settle();

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
    void compare();
    void compare_in_full();
    void begin_at_perturbations();
    void apply_law();
    std::vector<Perturbation> perturbations_at(double time) const;

    PanelContext context_;
    bool in_full_ = false;  ///< numbers have more bits than samples
    std::vector<double> reversals_;
    std::vector<std::int64_t> collisions_until_;  ///< each reversal, of all particles with others
    std::optional<double> bits_per_collision_;
    int stride_ = 1;  ///< one of so many frames is kept
    std::vector<Step> steps_;
    std::vector<Sample> kept_;  ///< one for each step, its time the mirror's; no velocities
};

}  // namespace carom
