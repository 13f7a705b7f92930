// The event loop of hard particles, disks in the plane or beads on a line: advances them from one
// event to the next and nothing else. Each particle has its own time, up to which it has been
// moved; only those that collide are touched. One source for doubles and for numbers of many bits
// (multiprecision.h). Does not know runs, reversals at given times or placement (simulation.h), nor
// which particles are near each other (plane.h, mp_plane.h, line.h).
//
// A particle's next event is the first of: its contact with another, with a wall, or its leaving a
// cell. It predicts a contact with a particle whose own next event comes earlier; if that changes
// the other's path (its collision count shows this), the event is stale and the particle looks
// again.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "physics/advance_result.h"
#include "physics/collision/velocity_changes.h"
#include "physics/events/event_queue.h"
#include "physics/events/fetch_ahead.h"
#include "physics/events/local_clock.h"
#include "physics/gas.h"
#include "physics/line/line.h"
#include "physics/multiprecision/mp_event_queue.h"
#include "physics/multiprecision/mp_plane.h"
#include "physics/particles.h"
#include "physics/plane/plane.h"
#include "physics/run.h"
#include "physics/surfaces/change_history.h"
#include "physics/surfaces/open_line.h"
#include "physics/surfaces/open_plane.h"
#include "physics/surfaces/surface_error.h"
#include "physics/surfaces/surface_events.h"

namespace carom {

/// `has_surfaces`: the box has surfaces that act, obstacles or gravity, or events change surfaces
/// or velocities.
template <int Dimension, typename Scalar = double, bool has_surfaces = false>
class EventLoop {
  public:
    /// Particles without state: start() gives it. After `most` collisions of particles and of
    /// moving surfaces advance() throws.
    EventLoop(const Box& box, const Particles& particles, const Arithmetic& arithmetic = {},
              std::int64_t most = std::numeric_limits<std::int64_t>::max());

    /// Puts all particles where `state` says, at its time, and predicts all events anew.
    void start(Sample state);

    /// Processes all events with time <= `time`; adds each collision to `record` unless it is null,
    /// and notes in `velocities` which have changed. `on_progress` is called now and then with the
    /// time of the latest event. Throws Interrupted, SurfaceError (without its time), and
    /// CollisionError when particles collide without end at one instant, too often in all, or two
    /// of infinite mass meet on a line.
    void advance(double time, std::vector<Collision>* record, const TimeCallback& on_progress = {},
                 VelocityLog* velocities = nullptr);

    /// What advance() has thrown, with the name of the surface, the time and where it is.
    SurfaceError at_present(const SurfaceError& error) const;

    /// Goes on to the next collision at a time <= `time`, false if there is none.
    bool advance_one(double time, Collision& collision);

    /// Turns all velocities round at `time`, which is not before the last event processed nor after
    /// the next, and predicts all events anew. What change() and heat() changed at t is changed
    /// back at 2 `time` - t.
    void reverse(double time);

    /// Carries out what an event does to a surface, at `time` as for reverse(), and predicts all
    /// events anew. Unless `is_mirrored` it is not changed back after a reversal. Returns the
    /// particle that is in the way of a partition that would close, if any: then nothing is done.
    std::optional<std::int32_t> change(const SurfaceAction& action, bool is_mirrored,
                                       double time) requires has_surfaces;

    /// The same for velocities, which are scaled. Returns false, and does nothing, if there is not
    /// so much energy.
    bool heat(const Heat& heat, bool is_mirrored, double time) requires has_surfaces;

    /// Moves a particle at `time`, which is as for reverse(), by lengths in decimal, and predicts
    /// all events anew. Returns what it would overlap then, if anything: a particle or a
    /// wall.
    std::optional<Partner> displace(std::int64_t particle, const std::array<std::string, 2>& by,
                                    double time);

    /// The state at `time`, which is not before the last event processed nor after the next;
    /// periodic coordinates lie in [0, size). Changes nothing in the particles.
    void sample(double time, Sample& state) const;

    /// The same without velocities, or without positions.
    Sample sample_of_positions(double time) const;
    Sample sample_of_velocities(double time) const;

    /// Positions at `time`, as sample() has them but in full, and periodic ones not brought into
    /// the box: those of each particle one after the other, in the order listed by the user.
    std::vector<Scalar> positions(double time) const;

    /// Collisions, and what they transferred, since the construction or the last call of forget().
    const CollisionCounts& counts() const { return counts_; }
    const ImpulseTotals& impulses() const { return impulses_; }
    void forget();

    /// What each surface has done since then, and where it is at `time`, which is as for sample();
    /// none where there are only walls.
    std::vector<SurfaceState> surfaces(double time) const {
        if constexpr (has_surfaces)
            return geometry_.surfaces().states(clock_.local(time));
        else
            return {};
    }

    /// The work of driven surfaces and events since then, and the heat by events.
    double driven_work() const {
        if constexpr (has_surfaces)
            return geometry_.surfaces().driven_work();
        else
            return 0.0;
    }
    double heat_of_events() const { return heat_of_events_; }

    /// Writes or reads all that changes in the course of a run.
    template <class Archive>
    void archive(Archive& archive) {
        const std::size_t count = bodies_.size();
        archive(bodies_, number_, geometry_, queue_, clock_, now_, changes_, heat_of_events_,
                cycles_since_sorted_, counts_, impulses_, collisions_, last_collision_,
                at_one_instant_, last_pair_[0], last_pair_[1]);
        if (bodies_.size() != count || number_.size() != count)
            archive.refuse("it holds another number of particles");
        fetch_ahead_ = {};
    }

  private:
    static constexpr bool of_doubles = std::is_same_v<Scalar, double>;
    using Disks = std::conditional_t<of_doubles, Plane, MpPlane>;
    using PlainGeometry = std::conditional_t<Dimension == 1, Line<Scalar>, Disks>;
    using OpenGeometry = std::conditional_t<Dimension == 1, OpenLine<Scalar>, OpenPlane<Scalar>>;
    using Geometry = std::conditional_t<has_surfaces, OpenGeometry, PlainGeometry>;
    using Queue = std::conditional_t<of_doubles, EventQueue, MpEventQueue>;
    using Clock = std::conditional_t<of_doubles, LocalClock, MpClock>;
    using Body = typename Geometry::Body;
    /// Planes of doubles search so many disks that memory is slow.
    static constexpr bool is_large = of_doubles && Dimension == 2;

    Body& body(std::int32_t i) { return bodies_[static_cast<std::size_t>(i)]; }
    std::int32_t number_of(std::int32_t i) const { return number_[static_cast<std::size_t>(i)]; }

    /// A double in the numbers of the loop.
    Scalar with_bits(double value) const {
        if constexpr (of_doubles)
            return value;
        else
            return Scalar(value, bits_);
    }

    template <typename See>
    void for_each_body(const See& see) const;
    std::optional<Partner> overlapped(std::size_t moved) const;
    void predict_next(std::int32_t i) { queue_.schedule(i, geometry_.predict(bodies_, i, now_)); }
    std::vector<std::int32_t> put_in_order();
    void resort();
    void predict_all();
    void move_epoch_to(const Scalar& local_time);
    std::int32_t next_particle();
    bool process(std::int32_t i, Collision* collision);
    bool collide(std::int32_t first, std::int32_t second, Collision* collision);
    void bounce(std::int32_t i, int side, Collision* collision);
    bool hit(std::int32_t i, const Prediction& event, Collision* collision);
    void note_velocity(std::int32_t i, const std::array<double, 2>& before);
    void process_surface_event(std::size_t k);
    void look_for_hits(std::size_t k);
    std::int32_t events_of_surfaces() const;
    Scalar surface_event(std::size_t k) const;
    void carry_out(const Change<Scalar>& change);
    void scale(const Scaling<Scalar>& scaling);
    std::optional<std::int32_t> first_in(std::int32_t surface) const;
    bool counts_for(const Body& body, const std::optional<std::int32_t>& species) const;
    void stop_later(std::int32_t surface);
    void move_on_to(const Scalar& time, std::optional<std::int32_t> i);
    void refuse_to_stall(std::optional<std::int32_t> i);
    void refuse_more_collisions();
    void count_tie(std::int32_t first, std::int32_t second);

    Box box_;
    typename Geometry::Bodies bodies_;
    std::vector<std::int32_t> number_;  ///< of each body as listed by the user
    Geometry geometry_;
    Queue queue_;
    Clock clock_;
    Scalar now_ = 0.0;  ///< local
    int bits_;
    ChangeHistory<Scalar> changes_;
    double heat_of_events_ = 0.0;
    int cycles_since_sorted_ = 0;
    FetchAhead<Geometry> fetch_ahead_;   ///< used where memory is slow
    VelocityLog* velocities_ = nullptr;  ///< within advance(), where it is wanted
    CollisionCounts counts_;
    ImpulseTotals impulses_;
    std::int64_t collisions_ = 0;  ///< since start()
    std::int64_t most_;
    Scalar last_collision_ = -1.0;
    std::int64_t at_one_instant_ = 0;  ///< events in a row without a step of time
    std::int32_t last_pair_[2] = {-1, -1};
};

extern template class EventLoop<1>;
extern template class EventLoop<2>;
extern template class EventLoop<1, Real>;
extern template class EventLoop<2, Real>;
extern template class EventLoop<1, double, true>;
extern template class EventLoop<2, double, true>;
extern template class EventLoop<1, Real, true>;
extern template class EventLoop<2, Real, true>;

}  // namespace carom
