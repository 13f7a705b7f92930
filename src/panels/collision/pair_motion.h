// Two beads on a wire in the plane of their two velocities: their collision as a linear map, what
// it conserves, and all their collisions as a walk in that plane. Draws nothing.
#pragma once

#include <optional>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// A collision of two beads. Its linear map has two eigenvectors: (1, 1), the motion of the centre
/// of mass, with eigenvalue 1; and (w1, -w2) with the inverse masses w, the relative motion, with
/// eigenvalue -1.
struct PairMotion {
    Eigen::Array2d inverse_mass{1.0, 1.0};  ///< 0: infinite mass; at most one is
    Eigen::Array2d before{0.0, 0.0}, after{0.0, 0.0};

    bool has_infinite_mass() const { return !(inverse_mass[0] > 0.0 && inverse_mass[1] > 0.0); }
    double mass_center_velocity() const;
    Eigen::Array2d turning() const { return {inverse_mass[0], -inverse_mass[1]}; }
    double energy() const;    ///< of finite masses
    double momentum() const;  ///< of finite masses
    double speed_apart() const { return std::abs(before[0] - before[1]); }
    void archive(auto& archive) { archive(inverse_mass, before, after); }
};

/// The matrix that maps the velocities before a collision to those after it.
Eigen::Matrix2d collision_matrix(const Eigen::Array2d& inverse_mass);

/// One step of the walk: what changed the two velocities, and their values after it.
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
    /// `spec.of` names the pair; if empty, the first pair that collides is taken.
    WalkWatch(const PanelContext& context, const PanelSpec& spec);

    /// First pass: called for every frame in order, with the collisions since the frame before.
    void survey(const FrameInput& input);

    /// All steps of the run; valid after the first pass. Throws SceneError, with the panel's place
    /// in the scene file, if something else changes the energy of the pair, if a third bead strikes
    /// one of the two, or if there are more than `most_steps` steps.
    std::vector<WalkStep> steps() const;

    static constexpr std::size_t most_steps = 2000;

  private:
    void see(const Collision& collision);

    PanelContext context_;
    PanelSpec spec_;
    std::optional<std::array<Eigen::Index, 2>> pair_;
    Eigen::ArrayXd start_;
    std::vector<Collision> early_;  ///< wall collisions before the pair is known
    std::vector<WalkStep> met_;     ///< without reversals
    std::optional<Collision> foreign_;
    std::size_t count_ = 0;
};

}  // namespace carom
