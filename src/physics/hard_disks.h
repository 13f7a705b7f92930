// The event loop of hard disks in a box: flies them from one event to the next and nothing else.
// Each disk has its own time, up to which it has been moved; only disks that collide are touched.
// Does not know runs, reversals at given times or placement (simulation.h).
//
// A disk's next event is the first of: its contact with another, with a wall, or its leaving a
// cell. It foresees a contact with a disk whose own next event comes earlier; if that changes the
// other's path (its collision count tells), the event is stale and the disk looks again.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/cell_grid.h"
#include "physics/event_queue.h"
#include "physics/gas.h"
#include "physics/local_clock.h"
#include "physics/pair_collision.h"
#include "physics/particles.h"
#include "physics/simulation.h"

namespace carom {

class HardDisks {
  public:
    /// Disks without state: start() gives it.
    HardDisks(const Box& box, const Particles& particles);

    /// Puts all disks where `state` says, at its time, and foresees all events anew.
    void start(const Sample& state);

    /// Processes all events with time <= `time`; adds each collision to `record` unless it is null.
    /// Throws std::runtime_error when disks collide without end at one instant.
    void advance(double time, std::vector<Collision>* record);

    /// Goes on to the next collision at a time <= `time`, false if there is none.
    bool advance_one(double time, Collision& collision);

    /// The state at `time`, which is not before the last event processed nor after the next;
    /// periodic coordinates lie in [0, size). Changes nothing in the disks.
    void sample(double time, Sample& state) const;

    /// Collisions, and what they transferred, since the construction or the last call of forget().
    const CollisionCounts& counts() const { return counts_; }
    const Transfers& transfers() const { return transfers_; }
    void forget();

  private:
    /// All that a pair needs to be tested and to collide: one cache line.
    struct alignas(64) Disk {
        double x, y;  ///< at the disk's own time; in a periodic box not wrapped until it crosses
        double vx, vy;
        double time;  ///< local
        double radius;
        double inverse_mass;
        std::uint32_t collisions;
        Cell cell;
    };
    static_assert(sizeof(Disk) == 64);

    struct Near {
        std::int32_t other;
        double shift_x, shift_y;
    };
    /// A disk that may be touched.
    struct Suitor {
        RelativeMotion<double> motion;
        double sigma;
        std::int32_t other;
    };

    Disk& disk(std::int32_t i) { return disks_[static_cast<std::size_t>(i)]; }
    const Disk& disk(std::int32_t i) const { return disks_[static_cast<std::size_t>(i)]; }

    std::int32_t number_of(std::int32_t i) const { return number_[static_cast<std::size_t>(i)]; }

    void sort_along_curve();
    void sort_again();
    void foresee_all();
    std::int32_t next_particle();
    bool process(std::int32_t particle, Collision* collision);
    bool collide(std::int32_t first, std::int32_t second, Collision* collision);
    void bounce(std::int32_t particle, std::int32_t side, Collision* collision);
    void cross(std::int32_t particle, std::int32_t side);
    void fly_to_now(Disk& d) const;
    Event foresee(std::int32_t particle);
    Event foresee_after_crossing(std::int32_t particle, int side, const Event& before);
    void note_near(std::int32_t particle, std::int32_t other, double shift_x, double shift_y);
    Event first_event(const Disk& a, Event first);
    void consider(const Disk& a, const Suitor& s, Event& first) const;
    void foresee_border(const Disk& d, double x, double y, Event& first) const;
    bool separation_at_contact(const Disk& a, const Disk& b, double& x, double& y) const;
    void refuse_to_stall();
    void count_tie(std::int32_t first, std::int32_t second);

    Box box_;
    std::vector<Disk> disks_;
    std::vector<std::int32_t> number_;  ///< of each disk as listed by the user
    std::vector<Near> near_;            ///< scratch: the disks to be looked at
    std::vector<Suitor> suitors_;       ///< scratch, as many as near_
    CellGrid grid_;
    EventQueue queue_;
    LocalClock clock_;
    double now_ = 0.0;  ///< local
    int laps_since_sorted_ = 0;
    bool narrow_[2] = {false, false};  ///< periodic and so narrow that two images may touch
    CollisionCounts counts_;
    Transfers transfers_;
    double last_collision_ = -1.0;
    std::int64_t at_one_instant_ = 0;  ///< events in a row without a step of time
    std::int32_t last_pair_[2] = {-1, -1};
};

}  // namespace carom
