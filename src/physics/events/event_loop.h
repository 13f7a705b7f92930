// The event loop of hard particles, spheres in space, disks in the plane or beads on a line:
// advances them from one event to the next. Each particle has its own local time, up to which it
// has been moved; an event touches only the particles that collide. The same source serves doubles
// and multiprecision (multiprecision.h). The loop does not know about runs, reversals at given
// times or placement (simulation.h), nor about neighbour search (plain_space.h, mp_space.h,
// line.h).
//
// A particle's next event is the earliest of its contact with another particle, its contact with a
// wall, and its crossing of a cell border. It may predict a contact with a particle whose own next
// event comes earlier. If that event changes the path of the other particle, which its collision
// count shows, the prediction is stale and the particle predicts again.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/cells/plain_space.h"
#include "physics/collision/velocity_changes.h"
#include "physics/events/contact_rounds.h"
#include "physics/events/event_queue.h"
#include "physics/events/fetch_ahead.h"
#include "physics/events/local_clock.h"
#include "physics/line/line.h"
#include "physics/multiprecision/mp_event_queue.h"
#include "physics/multiprecision/mp_space.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "physics/surfaces/change_history.h"
#include "physics/surfaces/open_line.h"
#include "physics/surfaces/open_space.h"
#include "physics/surfaces/surface_error.h"
#include "physics/surfaces/surface_events.h"

namespace carom {

/// `has_surfaces`: the box has surfaces other than reflecting walls, or gravity, or events change
/// surfaces or velocities.
template <int Dimension, typename Scalar = double, bool has_surfaces = false>
class EventLoop {
  public:
    /// Creates particles without a state, which start() sets. advance() throws after `most`
    /// collisions, those of moving surfaces included.
    EventLoop(const Box& box, const Particles& particles, const Arithmetic& arithmetic = {},
              std::int64_t most = std::numeric_limits<std::int64_t>::max());

    /// Sets the positions, velocities and time from `state`, and predicts all events.
    void start(Sample state);

    /// Processes all events with time <= `time`. Appends each collision to `record` and notes each
    /// changed velocity in `velocities`, unless these are null. Calls `on_progress` now and then
    /// with the time of the latest event. Throws Interrupted; SurfaceError (without the time, see
    /// at_present()); CollisionError if particles collide without end at one instant, if there are
    /// too many collisions in total, or if two beads of infinite mass meet.
    void advance(double time, std::vector<Collision>* record, const TimeCallback& on_progress = {},
                 VelocityLog* velocities = nullptr);

    /// Completes an error thrown by advance() with the name of the surface, the time and its
    /// position.
    SurfaceError at_present(const SurfaceError& error) const;

    /// Advances to the next collision at a time <= `time`; returns false if there is none.
    bool advance_one(double time, Collision& collision);

    /// Reverses all velocities at `time`, which must not lie before the last event processed nor
    /// after the next one, and predicts all events again. Changes made by change() and heat() at a
    /// time t will be undone at 2 `time` - t.
    void reverse(double time);

    /// Applies an event to a surface at `time`, which is restricted as for reverse(), and predicts
    /// all events again. Unless `is_mirrored`, the change is not undone after a reversal. If a
    /// partition would close on a particle, nothing is changed and that particle is returned.
    std::optional<std::int32_t> change(const SurfaceAction& action, bool is_mirrored,
                                       double time) requires has_surfaces;

    /// The same for heating, which scales velocities. Returns false and changes nothing if the
    /// particles do not have enough energy.
    bool heat(const Heat& heat, bool is_mirrored, double time) requires has_surfaces;

    /// Displaces a particle at `time`, which is restricted as for reverse(), by lengths given in
    /// decimal, and predicts all events again. Returns the particle or wall that it would overlap,
    /// if any.
    std::optional<Partner> displace(std::int64_t particle, const Displacement& by, double time);

    /// Writes the state at `time`, which must not lie before the last event processed nor after the
    /// next one, to `state`. Periodic coordinates lie in [0, size). Does not change the particles.
    void sample(double time, Sample& state) const;

    /// The same without velocities, or without positions.
    Sample sample_of_positions(double time) const;
    Sample sample_of_velocities(double time) const;

    /// Positions at `time` in full precision; periodic coordinates are not wrapped into the box.
    /// The coordinates of each particle follow each other, in the order in which the user lists the
    /// particles.
    std::vector<Scalar> positions(double time) const;

    /// Collision counts and transferred momentum since construction or the last call of forget().
    const CollisionCounts& counts() const { return counts_; }
    const ImpulseTotals& impulses() const { return impulses_; }
    void forget();

    /// The totals of each surface since then, and its position at `time`, which is restricted as
    /// for sample(); empty if there are only walls.
    std::vector<SurfaceState> surfaces(double time) const {
        if constexpr (has_surfaces)
            return geometry_.surfaces().states(clock_.local(time));
        else
            return {};
    }

    /// The work done by driven surfaces and by events since then, and the heat added by events.
    double driven_work() const {
        if constexpr (has_surfaces)
            return geometry_.surfaces().driven_work();
        else
            return 0.0;
    }
    double heat_of_events() const { return heat_of_events_; }

    /// The time of the first instant since start() whose contacts would not lead back if all
    /// velocities were reversed: for instance where two particles that touched at rest were pushed
    /// apart.
    std::optional<double> one_way() const { return one_way_; }

    /// Writes or reads all that changes in the course of a run.
    template <class Archive>
    void archive(Archive& archive) {
        const std::size_t count = bodies_.size();
        archive(bodies_, number_, geometry_, queue_, clock_, now_, changes_, heat_of_events_,
                cycles_since_sorted_, counts_, impulses_, collisions_, at_one_instant_, touching_,
                last_tie_, one_way_, at_once_);
        if (bodies_.size() != count || number_.size() != count)
            archive.refuse("it holds another number of particles");
        fetch_ahead_ = {};
    }

  private:
    static constexpr bool of_doubles = std::is_same_v<Scalar, double>;
    /// Components of vectors: a line uses the first of two.
    static constexpr std::size_t axes = Dimension == 3 ? 3 : 2;
    static constexpr int cells_dimension = static_cast<int>(axes);
    using Vector = std::array<Scalar, axes>;
    using Shift = std::array<double, axes>;
    using Space =
        std::conditional_t<of_doubles, PlainSpace<cells_dimension>, MpSpace<cells_dimension>>;
    using PlainGeometry = std::conditional_t<Dimension == 1, Line<Scalar>, Space>;
    using OpenGeometry =
        std::conditional_t<Dimension == 1, OpenLine<Scalar>, OpenSpace<Scalar, cells_dimension>>;
    using Geometry = std::conditional_t<has_surfaces, OpenGeometry, PlainGeometry>;
    using Queue = std::conditional_t<of_doubles, EventQueue, MpEventQueue>;
    using Clock = std::conditional_t<of_doubles, LocalClock, MpClock>;
    using Body = typename Geometry::Body;
    /// In boxes of doubles there can be so many bodies that memory access is slow.
    static constexpr bool is_large = of_doubles && Dimension >= 2;

    Body& body(std::int32_t i) { return bodies_[static_cast<std::size_t>(i)]; }
    std::int32_t number_of(std::int32_t i) const { return number_[static_cast<std::size_t>(i)]; }

    /// A vector of zeros in the precision of the loop.
    Vector no_vector() const {
        Vector vector;
        vector.fill(with_bits(0.0));
        return vector;
    }

    /// Converts a double to the scalar type and precision of the loop.
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
    [[gnu::noinline]] bool begin_cycle();
    bool process(std::int32_t i, Collision* collision);
    bool collide(std::int32_t first, std::int32_t second, Collision* collision);
    void bounce(std::int32_t i, int side, Collision* collision);
    bool hit(std::int32_t i, const Prediction& event, Collision* collision);
    void note_velocity(std::int32_t i, const Vec& before);
    void process_surface_event(std::size_t k);
    void look_for_hits(std::size_t k);
    std::int32_t events_of_surfaces() const;
    Scalar surface_event(std::size_t k) const;
    void carry_out(const Change<Scalar, axes>& change);
    void scale(const Scaling<Scalar, axes>& scaling);
    std::optional<std::int32_t> first_in(std::int32_t surface) const;
    bool counts_for(const Body& body, const std::optional<std::int32_t>& species) const;
    void stop_later(std::int32_t surface);
    void move_on_to(const Scalar& time, std::optional<std::int32_t> i);
    void refuse_to_stall(std::optional<std::int32_t> i);
    void refuse_more_collisions();
    [[noreturn]] void refuse_endless(std::optional<std::int32_t> i);

    static constexpr std::int32_t a_surface = -1;  ///< in `touching_`, instead of a particle
    /// Two bodies, or a body and a side or barrier, that touch at the present.
    struct ClosedContact {
        std::int32_t first, second;
        bool is_pair;
        Vector normal;    ///< of length 1, from the first to the second
        double distance;  ///< of the centres, or of the centre from the wall
        double sigma;     ///< what that should be
    };
    /// Body b relative to body a, and the largest coordinate, whose rounding error matters.
    struct Between {
        Vector r, v;
        double furthest;
    };
    using AllContacts = ContactRounds<Scalar, axes>;
    using Participant = typename AllContacts::Participant;
    /// Contacts with their participants, and the place of each body and surface among these.
    struct Rounds {
        AllContacts rounds;
        std::vector<std::pair<std::int32_t, std::size_t>> bodies, surfaces;
    };
    // event_loop_contacts.h
    double margin_of_instants() const;
    bool is_closed(const Scalar& gap, const Scalar& speed, double length) const;
    bool is_beyond_contact(double square, double sigma) const;
    bool may_touch(std::int32_t i, std::int32_t k);
    Between between(std::int32_t i, std::int32_t j, const Shift& shift);
    std::optional<ClosedContact> closed_pair(std::int32_t i, std::int32_t j, const Shift& shift,
                                             int side);
    std::optional<ClosedContact> closed_side(std::int32_t i, std::size_t axis, bool up);
    std::optional<ClosedContact> closed_barrier(std::int32_t i, std::int32_t k);
    std::vector<ClosedContact> closed_contacts_of(std::int32_t i);
    void append_closed_walls(std::int32_t i, std::vector<ClosedContact>& all);
    std::vector<ClosedContact> closed_contacts_around(std::int32_t i, std::int32_t j);
    void put_in_users_order(std::vector<ClosedContact>& contacts) const;
    std::int32_t surface_touched(const ClosedContact& contact) const;
    bool pushes_piston(const ClosedContact& contact) const;
    std::vector<std::int32_t> bodies_at_surface(std::int32_t surface);
    void find_touching();
    void add_touching(const ClosedContact& contact);
    bool touches_another(std::int32_t i) const;
    // event_loop_instants.h
    bool expects_another(std::int32_t j, std::int32_t i, double until);
    bool may_coincide(std::int32_t i, std::int32_t j, double time);
    [[gnu::noinline, gnu::cold]] bool may_coincide_until(double until, std::int32_t i,
                                                         std::int32_t j, double time);
    Participant participant_of(std::int32_t i);
    Participant surface_participant(const ClosedContact& contact);
    Rounds rounds_of(const std::vector<ClosedContact>& contacts);
    bool is_tie(const AllContacts& rounds, bool is_random) const;
    bool settle_instant(std::int32_t i, std::int32_t j, bool is_random, Collision* collision);
    void count_tie(std::size_t contacts);
    void set_velocity(std::int32_t i, const Vector& before, const Vector& after);
    void carry_out(const ClosedContact& contact, const typename AllContacts::Hit& hit);
    void count_pair(const ClosedContact& contact, double impulse);
    void count_hit(const ClosedContact& contact, const typename AllContacts::Hit& hit);
    void note_touching(const std::vector<ClosedContact>& contacts, const Rounds& found);
    void forget_touching(std::int32_t i);
    void follow_up(const std::array<std::int32_t, 2>& of_event, const Rounds& found,
                   const std::vector<Participant>& start);
    void push_surface(std::size_t k, const Vector& v);

    Box box_;
    typename Geometry::Bodies bodies_;
    std::vector<std::int32_t> number_;  ///< number of each body in the user's order
    Geometry geometry_;
    Queue queue_;
    Clock clock_;
    Scalar now_ = 0.0;  ///< local
    int bits_;
    ChangeHistory<Scalar, axes> changes_;
    double heat_of_events_ = 0.0;
    int cycles_since_sorted_ = 0;
    FetchAhead<Geometry> fetch_ahead_;   ///< used only if `is_large`
    VelocityLog* velocities_ = nullptr;  ///< set within advance() if changes are recorded
    CollisionCounts counts_;
    ImpulseTotals impulses_;
    std::int64_t collisions_ = 0;  ///< since start()
    std::int64_t most_;
    std::int64_t at_one_instant_ = 0;  ///< number of consecutive events at the same time
    /// Pairs of particles that touch without approaching, in both orders, and particles that touch
    /// surfaces so.
    std::set<std::pair<std::int32_t, std::int32_t>> touching_;
    double last_tie_ = -never<double>;  ///< time of the last instant with several contacts
    std::optional<double> one_way_;
    std::vector<Collision> at_once_;  ///< carried out, but not yet reported
};

extern template class EventLoop<1>;
extern template class EventLoop<2>;
extern template class EventLoop<3>;
extern template class EventLoop<1, Real>;
extern template class EventLoop<2, Real>;
extern template class EventLoop<3, Real>;
extern template class EventLoop<3, double, true>;
extern template class EventLoop<3, Real, true>;
extern template class EventLoop<1, double, true>;
extern template class EventLoop<2, double, true>;
extern template class EventLoop<1, Real, true>;
extern template class EventLoop<2, Real, true>;

}  // namespace carom
