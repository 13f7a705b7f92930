// One collision of two particles, as the simulation met it: where they are at the touch, how they
// move before and after it, and how long they fly undisturbed. Draws nothing.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "stats/paths/paths.h"

namespace carom {

struct PairCollision {
    double time = 0.0;   ///< of the contact
    double since = 0.0;  ///< when the free flight before it begins
    double until = 0.0;  ///< when the one after it ends
    std::array<Eigen::Index, 2> particle{};
    std::array<Eigen::Array2d, 2> place;          ///< at contact, images that touch; y is 0 in 1-D
    std::array<Eigen::Array2d, 2> before, after;  ///< velocities

    /// The square of the distance at a time of the flights before and after.
    double square(double at) const;

    /// The same as if they passed through each other: the parabola of the flight before.
    double free_square(double at) const;

    /// When that is the same as at the contact once more.
    double other_root() const;

    void archive(auto& archive) { archive(time, since, until, particle, place, before, after); }
};

/// The part of the change of one velocity that is along the line of centres, all of it.
inline Eigen::Array2d change(const PairCollision& pair, std::size_t k) {
    return pair.after[k] - pair.before[k];
}

/// Waits for the first collision of a pair, or of any pair.
class PairCollisionWatch {
  public:
    /// `spec.of` names the pair, or nothing.
    PairCollisionWatch(const PanelContext& context, const PanelSpec& spec);

    /// First pass, every frame in order, with the collisions on the way.
    void survey(const FrameInput& input);

    /// After the first pass. Throws SceneError, with the panel's place, where the pair never
    /// collides.
    const PairCollision& collision() const;

  private:
    bool is_wanted(const Collision& collision) const;
    void meet(const Collision& collision);
    double flying_since(Eigen::Index particle, double now) const;
    double flying_until(Eigen::Index particle, double now) const;

    PanelContext context_;
    PanelSpec spec_;
    std::vector<double> last_;  ///< for each particle: its last collision
    std::optional<PairCollision> found_;
    bool is_over_ = false;  ///< the flight after it
};

/// How the two are called: by their colours and numbers.
plot::Text names_of(const PanelContext& context, const PairCollision& pair);

/// The colour of one of them: its species', or where these are alike its own.
plot::Role role_of(const PanelContext& context, const PairCollision& pair, std::size_t k);
Color color_of(const PanelContext& context, const PairCollision& pair, std::size_t k,
               const Theme& theme);

}  // namespace carom
