// Disks or spheres in a box, as in plain_space.h, in multiprecision: which pairs may touch, and
// when. A multiprecision contact time costs as much as a hundred in doubles. Doubles therefore give
// a time before which a contact or a wall is certainly not reached, with rigorous error bounds, and
// only candidates for the first event are solved in multiprecision. The sequence of events is the
// same, bit for bit, as if all were solved in multiprecision. Crossings of cell borders have no
// physical meaning: they happen at times calculated in doubles, which is accurate enough because a
// cell is slightly wider than necessary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/cells/cell_grid.h"
#include "physics/collision/coincidences.h"
#include "physics/collision/loop_types.h"
#include "physics/multiprecision/mp_body.h"

namespace carom {

template <int Dimension>
class MpSpace : public PlainBodies<MpBody<Dimension>> {
    static constexpr std::size_t axes = static_cast<std::size_t>(Dimension);
    using Point = std::array<double, axes>;

  public:
    using Body = MpBody<Dimension>;
    using Bodies = LargeVector<Body>;

    MpSpace(const Box& box, const Particles& particles, const Arithmetic& arithmetic);

    // As those of PlainSpace.
    void enter(Bodies& bodies);
    Real predict(Bodies& bodies, std::int32_t i, const Real& now);
    Real predict_after_crossing(Bodies& bodies, std::int32_t i, int, const Real& now) {
        return predict(bodies, i, now);
    }
    void cross(Bodies& bodies, std::int32_t i, int side, const Real& now);
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<Dimension>& contact);

    // As those of PairSearch.
    Coincidences& coincidences() { return coincidences_; }
    void set_margin(double margin) { coincidences_.reset(margin); }
    template <typename See>
    void for_each_neighbour(const Bodies& bodies, std::int32_t i, const See& see) {
        const Body& body = bodies[static_cast<std::size_t>(i)];
        grid_.for_each_neighbour(i, body.radius, body.cell, near_, see);
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(grid_, coincidences_);
    }

  private:
    /// The body whose next event is sought, in doubles, advanced to the present.
    struct Viewer {
        const Body& body;
        Point x;
        double distance;  ///< |x| + |y| + ... plus the distance flown: scale of its error
        double now;
    };
    /// Another body that it might touch, and a time before which it certainly does not.
    struct Candidate {
        double soonest;
        std::int32_t other;
        Point shift;
    };
    /// The first event found so far.
    struct First : Event<Real> {
        double late = never<double>;  ///< upper bound of its time, a double
    };
    /// The next border along an axis.
    struct Border {
        double place;
        unsigned kind;
        double soonest;  ///< time from now before which it is surely not reached
    };

    Viewer viewer(const Body& body, const Real& now);
    double soonest_contact(const Viewer& a, const Body& other, const Point& shift) const;
    void consider(const Bodies& bodies, const Body& a, const Candidate& candidate, const Real& now,
                  First& first);
    bool solve_contact(const Body& a, const Body& b, const Point& shift, const Real& now);
    const Real& squared(double sigma);
    void place_viewer(const Body& a, const Real& now);
    bool approaches(const Body& a, const Body& b);
    Border border_ahead(const Viewer& a, std::size_t axis) const;
    void predict_border(const Viewer& a, const Real& now, First& first);
    void solve_wall(const Body& a, std::size_t axis, double place, const Real& now);
    bool find_image(const Body& a, const Body& b);
    static void set_square(Real& square, const std::array<Real, axes>& vector, Real& part);
    void set_approach();
    void subtract_miss_square();
    void separate(const Body& a, const Body& b, const Point& shift);

    Box box_;
    CellGrid<Dimension> grid_;
    Coincidences coincidences_;
    bool screened_;
    int bits_;
    std::vector<std::int32_t> near_ = std::vector<std::int32_t>(2 * CellGrid<Dimension>::spare);
    std::vector<Candidate> candidates_;

    // Scratch numbers, so that none have to be created during a calculation.
    bool placed_ = false;           ///< whether here_ holds the position of the viewer
    std::array<Real, axes> here_;   ///< position of the viewer at the present
    std::array<Real, axes> r_, v_;  ///< separation and relative velocity (second minus first)
    Real approach_;                 ///< r . v
    Real time_;                     ///< the result
    Real a_, b_, c_;
    double sigma_ = 0.0;  ///< contact distance whose square is in sigma_square_
    Real sigma_square_;
};

extern template class MpSpace<2>;
extern template class MpSpace<3>;

}  // namespace carom
