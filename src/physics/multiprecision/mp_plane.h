// The plane of plane.h for multiprecision disks: which pairs may touch and when. A multiprecision
// time costs as much as a hundred in doubles, so doubles give a time before which a contact or a
// wall is certainly not reached (the bounds on their errors are rigorous), and only what might come
// first is solved in multiprecision. Which events happen, and every bit of them, is the same as if
// all were. Borders of cells are no events of physics: they are crossed at times that doubles give,
// which is near enough, as a cell is a little wider than it must be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/collision/loop_types.h"
#include "physics/multiprecision/mp_disk.h"
#include "physics/plane/cell_grid.h"

namespace carom {

class MpPlane : public PlainBodies<MpDisk> {
  public:
    MpPlane(const Box& box, const Particles& particles, const Arithmetic& arithmetic);

    // As those of Plane.
    void enter(Bodies& bodies);
    Real predict(Bodies& bodies, std::int32_t i, const Real& now);
    Real predict_after_crossing(Bodies& bodies, std::int32_t i, int, const Real& now) {
        return predict(bodies, i, now);
    }
    void cross(Bodies& bodies, std::int32_t i, int side, const Real& now);
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact);

    template <class Archive>
    void archive(Archive& archive) {
        archive(grid_);
    }

  private:
    /// The disk whose next event is searched, in doubles, at the present.
    struct Viewer {
        const MpDisk& disk;
        std::array<double, 2> x;
        double distance;  ///< |x| + |y| and what it flew: a scale of its error
        double now;
    };
    /// Another that it might touch, and a time before which it surely does not.
    struct Candidate {
        double soonest;
        std::int32_t other;
        std::array<double, 2> shift;
    };
    /// The first event found so far.
    struct First : Event<Real> {
        double late = never<double>;  ///< a double not before its time
    };
    /// A border ahead along an axis.
    struct Border {
        double place;
        unsigned kind;
        double soonest;  ///< time from now before which it is surely not reached
    };

    Viewer viewer(const MpDisk& disk, const Real& now);
    double soonest_contact(const Viewer& a, const MpDisk& other,
                           const std::array<double, 2>& shift) const;
    void consider(const Bodies& bodies, const MpDisk& a, const Candidate& candidate,
                  const Real& now, First& first);
    bool solve_contact(const MpDisk& a, const MpDisk& b, const std::array<double, 2>& shift,
                       const Real& now);
    const Real& squared(double sigma);
    void place_viewer(const MpDisk& a, const Real& now);
    bool approaches(const MpDisk& a, const MpDisk& b);
    Border border_ahead(const Viewer& a, std::size_t axis) const;
    void predict_border(const Viewer& a, const Real& now, First& first);
    void solve_wall(const MpDisk& a, std::size_t axis, double place, const Real& now);
    bool find_image(const MpDisk& a, const MpDisk& b);
    void separate(const MpDisk& a, const MpDisk& b, double shift_x, double shift_y);

    Box box_;
    CellGrid grid_;
    bool screened_;
    int bits_;
    std::vector<std::int32_t> near_ = std::vector<std::int32_t>(2 * CellGrid::spare);
    std::vector<Candidate> candidates_;

    // Numbers to calculate with, so that none need be made on the way.
    bool placed_ = false;        ///< whether here_ holds the place of the disk that looks
    std::array<Real, 2> here_;   ///< its place at the present
    std::array<Real, 2> r_, v_;  ///< of the second disk as seen from the first
    Real approach_;              ///< r . v
    Real time_;                  ///< the result
    Real a_, b_, c_;
    double sigma_ = 0.0;  ///< whose square is
    Real sigma_square_;
};

}  // namespace carom
