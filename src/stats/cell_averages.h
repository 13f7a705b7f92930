// What particles do in the cells of a box, averaged over a while: how many are there, how fast, and
// how hot. Times of residence are exact, by free flights between collisions; nothing is sampled.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/simulation.h"
#include "stats/paths/paths.h"

namespace carom {

/// Equal cells that cover a box, or a line: numbered along x first, from the lower left.
struct Cells {
    Eigen::Array2i count{1, 1};
    Eigen::Array2d size{1.0, 1.0};  ///< of one; along y of a line 1
    Eigen::Array2d box{1.0, 1.0};   ///< of all

    Eigen::Index all() const { return Eigen::Index{count[0]} * count[1]; }
    double area() const { return size.prod(); }  ///< of a line a length
    Region region(Eigen::Index cell) const;
};

/// So many along the longer side of a box, as square as that allows.
Cells square_cells(const Box& box, int along_longer);

/// So many side by side along an axis.
Cells slabs(const Box& box, int axis, int count);

/// Sums over the particles in each cell, integrated over time; of a moment, sums.
struct CellSums {
    double time = 0.0;               ///< that was integrated over; of a moment 1
    Eigen::ArrayXd particles;        ///< their number
    Eigen::ArrayXd speed;            ///< of |v|
    Eigen::ArrayXXd velocity;        ///< a column for each axis
    Eigen::ArrayXd thermal_energy;   ///< of m (v - u)^2, u the velocity of the centre of mass of
                                     ///< those that are in the cell at that moment
    Eigen::ArrayXd thermal_freedom;  ///< of n - 1, where there are n > 0 of finite mass

    /// Each cell's mean number, and the mean of the others over its particles. The temperature is
    /// thermal energy over freedom and dimension: without bias for any number in the cell and
    /// any time. NaN where there is nothing to divide by.
    Eigen::ArrayXd mean_particles() const { return particles / time; }
    Eigen::ArrayXd mean_speed() const { return speed / particles; }
    Eigen::ArrayXXd mean_velocity() const { return velocity.colwise() / particles; }
    Eigen::ArrayXd temperature() const;

    void archive(auto& archive) {
        archive(time, particles, speed, velocity, thermal_energy, thermal_freedom);
    }
};

/// Follows a run.
class CellAverages {
  public:
    /// Which particles, and over what.
    struct Wanted {
        std::vector<bool> members = {};     ///< of all particles; empty: all of them
        std::optional<double> window = {};  ///< time before the present, 0: the present alone;
                                            ///< none: since the start
        bool temperature = false;           ///< otherwise it is left out, which is faster
    };

    CellAverages(const Box& box, const Particles& particles, const Cells& cells, Wanted wanted,
                 std::vector<double> velocity_changes);

    /// Samples in order of time, with all collisions on the way from the one before. Throws
    /// CollisionError for a particle that goes through a million cells between two of them, as it
    /// can in a periodic box.
    void see(const Sample& sample, std::span<const Collision> collisions);

    /// Over the window, to a thirty-second of it; over what has passed where that is less. Of the
    /// moment where no time has passed. After the first see().
    CellSums sums() const;

    /// Writes or reads all that was seen; what is wanted is not part of it.
    void archive(auto& archive) { archive(paths_, slices_, moment_, is_first_, from_); }

  private:
    struct Point {
        double time = 0.0;
        Eigen::Array2d place{0.0, 0.0}, velocity{0.0, 0.0};
    };
    /// A stay of a particle in a cell.
    struct Stay {
        Eigen::Index cell;
        double from, to;
        Eigen::Array2d velocity;      ///< at `from_`, had it been on this path then
        Eigen::Array2d acceleration;  ///< less gravity
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
    Eigen::Index cell_at(const Eigen::Array2d& place) const;
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
    Eigen::Array2d gravity_{0.0, 0.0};
    std::deque<Slice> slices_;
    CellSums moment_;
    bool is_first_ = true;         ///< nothing has been seen
    double from_ = 0.0;            ///< the time of the sample before
    double start_ = 0.0;           ///< of the window
    std::vector<double> crossed_;  ///< scratch: times
    std::vector<Stay> stays_;      ///< since the sample before
};

}  // namespace carom
