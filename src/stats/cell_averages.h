// Averages over time of the particles in the cells of a box: their number, mean speed and velocity,
// and temperature. The times that particles spend in cells are exact, computed from the free
// flights between collisions, not from samples.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/simulation.h"
#include "stats/paths/paths.h"

namespace carom {

/// Equal cells that cover a box, in one, two or three dimensions: numbered along x first, then
/// along y, from the corner at the origin.
struct Cells {
    Eigen::Array3i count{1, 1, 1};
    Vec size{1.0, 1.0, 1.0};  ///< of one cell; 1 along an axis that the box does not have
    Vec box{1.0, 1.0, 1.0};   ///< of the whole grid

    Eigen::Index all() const { return Eigen::Index{count[0]} * count[1] * count[2]; }
    double content() const { return size[0] * size[1] * size[2]; }  ///< a length, area or volume
    Region region(Eigen::Index cell) const;
};

/// `along_longest` cells along the longest side of the box, and as many along each other one as
/// make them most nearly squares or cubes.
Cells square_cells(const Box& box, int along_longest);

/// `count` slabs side by side along an axis.
Cells slabs(const Box& box, int axis, int count);

/// Sums over the particles in each cell, integrated over time; for a single moment the plain sums.
struct CellSums {
    double time = 0.0;               ///< length of the integration; 1 for a single moment
    Eigen::ArrayXd particles;        ///< number of particles
    Eigen::ArrayXd speed;            ///< of |v|
    Eigen::ArrayXXd velocity;        ///< a column for each axis
    Eigen::ArrayXd thermal_energy;   ///< sum of m (v - u)^2, u being the velocity of the centre of
                                     ///< mass of the particles that are in the cell at that time
    Eigen::ArrayXd thermal_freedom;  ///< of n - 1, for n > 0 particles of finite mass in the cell

    /// The mean number of particles in each cell, and the means of the other quantities per
    /// particle. The temperature is the thermal energy divided by thermal freedom and dimension, an
    /// unbiased estimate for any number of particles in the cell and any time. NaN where the
    /// divisor is 0.
    Eigen::ArrayXd mean_particles() const { return particles / time; }
    Eigen::ArrayXd mean_speed() const { return speed / particles; }
    Eigen::ArrayXXd mean_velocity() const { return velocity.colwise() / particles; }
    Eigen::ArrayXd temperature() const;

    void add(const CellSums& more);

    void archive(auto& archive) {
        archive(time, particles, speed, velocity, thermal_energy, thermal_freedom);
    }
};

/// Accumulates the cell averages of a run.
class CellAverages {
  public:
    /// Which particles are averaged, over which time, and what is computed.
    struct Wanted {
        std::vector<bool> members = {};     ///< one flag for each particle; empty: all of them
        std::optional<double> window = {};  ///< length of time before the present; 0: the present
                                            ///< moment only; none: all since the start
        bool temperature = false;  ///< whether temperatures are computed; without them it is faster
    };

    CellAverages(const Box& box, const Particles& particles, const Cells& cells, Wanted wanted,
                 std::vector<double> velocity_changes);

    /// Changes `members` of Wanted for what is seen from now on. The present moment is that of the
    /// next call of see(), which may take the last sample again.
    void choose(std::vector<bool> members) { wanted_.members = std::move(members); }

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one. Throws CollisionError if a particle crosses more than a million cells
    /// between two collisions or samples, as it can in a periodic box.
    void see(const Sample& sample, std::span<const Collision> collisions);

    /// The sums over the window, whose start is resolved to 1/32 of its length, or over the whole
    /// time so far if that is shorter. Sums of the last sample alone where no time has passed or
    /// the window is 0. Requires a call of see().
    CellSums sums() const;

    /// The same in 16 pieces of nearly equal time, in order: the last one is a quarter shorter or
    /// longer at most. None without a window, and while the time so far is shorter than it.
    static constexpr int pieces_of_window = 16;
    std::vector<CellSums> pieces() const;

    /// Writes or reads the accumulated state; `wanted` is not part of it.
    void archive(auto& archive) { archive(paths_, slices_, moment_, is_first_, from_); }

  private:
    struct Point {
        double time = 0.0;
        Vec place = {}, velocity = {};
    };
    /// An interval of time that a particle spends in a cell.
    struct CellStay {
        Eigen::Index cell;
        double from, to;
        Vec velocity = {};      ///< extrapolated along this path to the time `from_`
        Vec acceleration = {};  ///< minus gravity
        double mass;
    };
    struct Slice {
        std::int64_t number = 0;
        CellSums sums;
        void archive(auto& archive) { archive(number, sums); }
    };
    Point at(const Sample& sample, Eigen::Index particle) const;
    bool is_member(Eigen::Index particle) const {
        return wanted_.members.empty() || wanted_.members[static_cast<std::size_t>(particle)];
    }
    CellSums no_sums() const;
    CellSums& slice_at(double time);
    std::int64_t slice_number(double time) const;
    Eigen::Index cell_at(const Vec& place) const;
    void fly(const PathPiece& piece);
    void add_crossings(const PathPiece& piece, double from, double to);
    void stay(const PathPiece& piece, double from, double to);
    void add_temperatures();
    void add_moment(const Sample& sample);

    Box box_;
    Particles particles_;
    Cells cells_;
    Wanted wanted_;
    Paths paths_;
    Vec gravity_ = {};
    std::deque<Slice> slices_;
    CellSums moment_;
    bool is_first_ = true;         ///< no sample has been seen
    double from_ = 0.0;            ///< time of the previous sample
    double start_ = 0.0;           ///< of the window
    std::vector<double> crossed_;  ///< scratch: times
    std::vector<CellStay> stays_;  ///< since the previous sample
};

}  // namespace carom
