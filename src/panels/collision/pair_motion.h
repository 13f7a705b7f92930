// Two beads on a wire in the plane of their velocities: their collision as a linear map, what it
// keeps, and all their collisions as a walk. Draws nothing.
#pragma once

#include <optional>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// A collision of two beads. Its map has the eigenvectors (1, 1), which stays: the motion of the
/// centre of mass, and (w1, -w2) with the inverse masses w, which turns round: relative motion.
struct PairMotion {
    Eigen::Array2d inverse_mass{1.0, 1.0};  ///< 0: infinite, one at most
    Eigen::Array2d before{0.0, 0.0}, after{0.0, 0.0};

    bool has_infinite_mass() const { return !(inverse_mass[0] > 0.0 && inverse_mass[1] > 0.0); }
    double mass_center_velocity() const;
    Eigen::Array2d turning() const { return {inverse_mass[0], -inverse_mass[1]}; }
    double energy() const;    ///< of finite masses
    double momentum() const;  ///< of finite masses
    double speed_apart() const { return std::abs(before[0] - before[1]); }
    void archive(auto& archive) { archive(inverse_mass, before, after); }
};

/// Velocities after a collision from those before it.
Eigen::Matrix2d collision_matrix(const Eigen::Array2d& inverse_mass);

/// What changed the two velocities, and what they were after it.
struct WalkStep {
    enum class Cause { start, pair, wall, reversal };
    double time = 0.0;
    Cause cause = Cause::start;
    Eigen::Array2d velocity{0.0, 0.0};
    void archive(auto& archive) { archive(time, cause, velocity); }
};

/// Follows the velocities of a pair through the run.
class WalkWatch {
  public:
    /// `spec.of` names the pair, or nothing: the first that collides.
    WalkWatch(const PanelContext& context, const PanelSpec& spec);

    /// First pass, every frame in order, with the collisions on the way.
    void survey(const FrameInput& input);

    /// All steps of the run, after the first pass. Throws SceneError, with the panel's place, where
    /// a third bead strikes one of the two, or where there are more than `most_steps`.
    std::vector<WalkStep> steps() const;

    static constexpr std::size_t most_steps = 2000;

  private:
    void see(const Collision& collision);

    PanelContext context_;
    PanelSpec spec_;
    std::optional<std::array<Eigen::Index, 2>> pair_;
    Eigen::ArrayXd start_;
    std::vector<Collision> early_;  ///< with walls, before the pair is known
    std::vector<WalkStep> met_;     ///< without reversals
    std::optional<Collision> foreign_;
    std::size_t count_ = 0;
};

}  // namespace carom
