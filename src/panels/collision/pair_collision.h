// One collision of two particles, taken from the simulation: their positions at contact, their
// velocities before and after it, and the duration of the free flights on both sides. Draws
// nothing.
#pragma once

#include <array>
#include <optional>
#include <string>
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
    std::array<Vec, 2> place;          ///< at contact: the images that touch; y is 0 in 1-D
    std::array<Vec, 2> before, after;  ///< velocities

    /// The squared distance of the particles at a time, on the free flights before and after the
    /// contact.
    double square(double at) const;

    /// The squared distance if they passed through each other: the parabola of the flight before.
    double free_square(double at) const;

    /// The coefficients of free_square() as a polynomial of the time after `since`, from the
    /// position r and the velocity v of the second particle relative to the first:
    /// r.r + 2 r.v t + v.v t^2.
    struct Parabola {
        double rr, rv, vv;
    };
    Parabola parabola() const;

    /// The second root of the contact condition: the other time at which free_square() has the
    /// value that it has at contact.
    double other_root() const;

    void archive(auto& archive) { archive(time, since, until, particle, place, before, after); }
};

/// The change of one velocity in the collision, all of which is along the line of centres.
inline Vec change(const PairCollision& pair, std::size_t k) {
    return pair.after[k] - pair.before[k];
}

/// Waits for the first collision of a pair, or of any pair.
class PairCollisionWatch {
  public:
    /// `spec.of` names the pair; if empty, the first pair that collides is taken.
    PairCollisionWatch(const PanelContext& context, const PanelSpec& spec);

    /// First pass: called for every frame in order, with the collisions since the frame before.
    void survey(const FrameInput& input);

    /// The collision; valid after the first pass. Throws SceneError, with the panel's place in the
    /// scene file, if the pair never collides.
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
    bool is_over_ = false;  ///< whether the flight after the collision has ended
};

/// The names of the two particles: their numbers, in their colours.
plot::Text names_of(const PanelContext& context, const PairCollision& pair);

/// The names of their species, where each of the two is the only particle of one.
std::optional<std::array<std::string, 2>> own_names(const PanelContext& context,
                                                    const PairCollision& pair);

/// The same at the beginning of a sentence, without colours.
std::string plain_names_of(const PanelContext& context, const PairCollision& pair);

/// The colour of particle k of the pair: that of its species, or a colour of its own if both are of
/// the same species.
plot::Role role_of(const PanelContext& context, const PairCollision& pair, std::size_t k);
Color color_of(const PanelContext& context, const PairCollision& pair, std::size_t k,
               const Theme& theme);

}  // namespace carom
