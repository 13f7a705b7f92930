#include "physics/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "physics/archived.h"
#include "physics/events/echo_measurement.h"
#include "physics/events/energy_account.h"
#include "physics/events/event_loop.h"
#include "physics/events/fixed_step_loop.h"
#include "physics/gas.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/placement/feasibility.h"
#include "physics/placement/placement.h"
#include "physics/simulation_checks.h"
#include "physics/surfaces/surface_events.h"
#include "physics/ways_back.h"
#include "util/fingerprint.h"
#include "util/overloaded.h"

namespace carom {
namespace {

using Loop =
    std::variant<EventLoop<1>, EventLoop<2>, EventLoop<1, Real>, EventLoop<2, Real>,
                 EventLoop<1, double, true>, EventLoop<2, double, true>, EventLoop<1, Real, true>,
                 EventLoop<2, Real, true>, FixedStepLoop, EventLoop<3>, EventLoop<3, Real>,
                 EventLoop<3, double, true>, EventLoop<3, Real, true>>;

// With fewer particles per change than this, looking at all particles takes less time.
constexpr std::size_t particles_a_change = 2;

}  // namespace

struct Simulation::Implementation {
    template <typename Function>
    auto with_loop(Function&& f) {
        return std::visit(std::forward<Function>(f), chosen_loop);
    }

    Implementation(const Box& its_box, Particles its_particles, Sample start, const Run& run,
                   const TimeCallback& on_progress)
        : box(its_box),
          particles(std::move(its_particles)),
          events(run.events),
          bits(
              (check_surfaces(box, particles, start, run), check_run(run, particles.count(), box))),
          chosen_loop(loop_for(its_box, particles, run, bits)),
          membership(membership_at_start(particles)),
          present(std::move(start)) {
        present.time = -run.equilibrate;
        with_loop([&](auto& loop) {
            loop.start(std::exchange(present, {}));
            if (run.equilibrate > 0.0) advance_loop(loop, 0.0, nullptr, on_progress);
            loop.forget();
        });
        present.time = 0.0;
        const bool falls = box.surfaces.has_gravity();
        if (falls) with_loop([&](const auto& loop) { loop.sample(0.0, present); });
        sampled = falls;
        at_start = energies(box, particles, falls ? present : with_loop([&](const auto& loop) {
                                return loop.sample_of_velocities(0.0);
                            }),
                            surfaces());
    }

    // Creates an implementation whose state will be read from an archive.
    Implementation(const Box& its_box, Particles its_particles, const Run& run)
        : box(its_box),
          particles(std::move(its_particles)),
          bits((check_surfaces(box, run), check_run(run, particles.count(), box))),
          chosen_loop(loop_for(box, particles, run, bits)),
          membership(membership_at_start(particles)) {}

    template <typename Scalar, bool has_surfaces>
    static Loop loop_in(const Box& box, const Particles& particles, int bits, std::int64_t most) {
        const Arithmetic arithmetic{.bits = bits};
        if (box.dimension == 1)
            return Loop(std::in_place_type<EventLoop<1, Scalar, has_surfaces>>, box, particles,
                        arithmetic, most);
        if (box.dimension == 3)
            return Loop(std::in_place_type<EventLoop<3, Scalar, has_surfaces>>, box, particles,
                        arithmetic, most);
        return Loop(std::in_place_type<EventLoop<2, Scalar, has_surfaces>>, box, particles,
                    arithmetic, most);
    }

    static Loop loop_for(const Box& box, const Particles& particles, const Run& run, int bits) {
        const std::int64_t most = collision_ceiling(run, particles.count());
        if (run.time_step)
            return Loop(std::in_place_type<FixedStepLoop>, box, particles, *run.time_step, most);
        const bool is_plain = box.surfaces.are_plain() && !act_on_box(run.events);
        if (bits > bits_of_double)
            return is_plain ? loop_in<Real, false>(box, particles, bits, most)
                            : loop_in<Real, true>(box, particles, bits, most);
        return is_plain ? loop_in<double, false>(box, particles, bits, most)
                        : loop_in<double, true>(box, particles, bits, most);
    }

    // Identifies simulations whose states can be read into each other.
    std::string kind() {
        Archive parts;
        auto which = static_cast<std::int64_t>(chosen_loop.index());
        parts(box, particles, bits, which);
        return fingerprint(parts.finished());
    }

    void archive(Archive& archive) {
        std::string its_kind = kind();
        const std::string expected = its_kind;
        archive(its_kind);
        if (its_kind != expected)
            archive.refuse("it holds a simulation of other particles, or of a run of another kind");
        with_loop([&](auto& loop) { archive(loop); });
        if (!sampled) {
            present.position.resize(0, 0);
            present.velocity.resize(0, 0);
        }
        Membership now = *membership;
        archive(events, next_event, happened, now, present, sampled, recording, echo, at_start);
        if (archive.is_reading()) membership = std::make_shared<const Membership>(std::move(now));
    }

    static void advance_loop(auto& loop, double time, std::vector<Collision>* record,
                             const TimeCallback& on_progress, VelocityLog* velocities = nullptr) {
        try {
            loop.advance(time, record, on_progress, velocities);
        } catch (const SurfaceError& error) {
            throw loop.at_present(error);
        }
    }

    void advance(double time, const TimeCallback& on_progress) {
        with_loop([&](auto& loop) {
            advance_loop(loop, time, recording ? &collisions : nullptr, on_progress,
                         velocities.is_open() ? &velocities : nullptr);
        });
        present.time = time;
        sampled = false;
    }

    // Advances to a time; carries out the events of the run on the way and stores positions at the
    // mirror times of measure_return().
    void advance_with_events(double time, const TimeCallback& on_progress) {
        for (; next_event < events.size() && events[next_event].at <= time; ++next_event) {
            const double at = events[next_event].at;
            while (echo.next_time() < at) keep_mirror_positions(on_progress);
            advance(at, on_progress);
            apply(next_event);
            happened.push_back(events[next_event]);
        }
        while (echo.next_time() <= time) keep_mirror_positions(on_progress);
        advance(time, on_progress);
    }

    void keep_mirror_positions(const TimeCallback& on_progress) {
        advance(echo.next_time(), on_progress);
        echo.keep([this] { return exact_positions(); });
    }

    ExactPositions exact_positions() const {
        if (bits > bits_of_double)
            return std::visit(
                [&](const auto& loop) {
                    const auto all = loop.positions(present.time);
                    return ExactPositions(box, std::vector<Real>(all.begin(), all.end()));
                },
                chosen_loop);
        Sample now;
        std::visit([&](const auto& loop) { loop.sample(present.time, now); }, chosen_loop);
        return {box, std::move(now.position)};
    }

    // For an accurate return the reversal takes place exactly at its time, and all predictions are
    // made again.
    void reverse(std::size_t event) {
        velocities.give_up();
        const auto one_way = with_loop([](const auto& loop) -> std::optional<double> {
            if constexpr (requires { loop.one_way(); })
                return loop.one_way();
            else
                return std::nullopt;
        });
        if (one_way)
            throw RunEventError(
                event,
                fmt::format("the gas cannot go back from time {:g}: at time {:.10g} several "
                            "contacts coincided and pushed particles apart that touched at rest; "
                            "reversed, all of them would meet at once",
                            present.time, *one_way),
                "let the particles not touch at the start, or leave out the reversal");
        echo.keep_at_reversal(present.time, [this] { return exact_positions(); });
        with_loop([&](auto& loop) { loop.reverse(present.time); });
        sampled = false;
    }

    void perturb(std::size_t event, const Perturbation& perturbation) {
        const auto obstacle = with_loop([&](auto& loop) {
            return loop.displace(perturbation.particle, perturbation.by, present.time);
        });
        sampled = false;
        if (!obstacle) return;
        throw RunEventError(
            event,
            fmt::format("the nudge at time {:g} would push particle {} into {}", present.time,
                        perturbation.particle,
                        obstacle->is_surface() ? "a wall"
                                               : fmt::format("particle {}", obstacle->particle())),
            "a smaller one may have room");
    }

    void apply(std::size_t event) {
        std::visit(
            Overloaded{[&](const ReverseVelocities&) { reverse(event); },
                       [&](const Perturbation& perturbation) { perturb(event, perturbation); },
                       [&](const SetOpen& action) { change(event, action); },
                       [&](const MoveSurface& action) { change(event, action); },
                       [&](const HoldPiston& action) { change(event, action); },
                       [&](const ReleasePiston& action) { change(event, action); },
                       [&](const ChangeSurface& action) { change(event, action); },
                       [&](const Heat& action) { heat(event, action); }},
            events[event].action);
    }

    void change(std::size_t event, const SurfaceAction& action) {
        velocities.give_up();
        std::optional<std::int32_t> in_the_way;
        with_loop([&](auto& loop) {
            if constexpr (requires { loop.change(action, true, 0.0); })
                in_the_way = loop.change(action, events[event].is_mirrored, present.time);
        });
        sampled = false;
        if (in_the_way)
            throw RunEventError(
                event,
                fmt::format("the partition cannot close at time {:g}: particle {} is in its "
                            "way",
                            present.time, *in_the_way),
                "close it a little earlier or later");
    }

    void heat(std::size_t event, const Heat& heat) {
        velocities.give_up();
        bool is_done = true;
        with_loop([&](auto& loop) {
            if constexpr (requires { loop.heat(heat, true, 0.0); })
                is_done = loop.heat(heat, events[event].is_mirrored, present.time);
        });
        sampled = false;
        if (!is_done)
            throw RunEventError(
                event,
                fmt::format("`heat` fails at time {:g}: the particles stand still, or have less "
                            "than it takes",
                            present.time),
                "take less, or heat particles that move");
    }

    std::vector<SurfaceState> surfaces() const {
        return std::visit([&](const auto& loop) { return loop.surfaces(present.time); },
                          chosen_loop);
    }

    // The energies at present, without the work, the heat of events and the numerical error.
    EnergyAccount energies_now() const {
        Sample now;
        std::visit([&](const auto& loop) { loop.sample(present.time, now); }, chosen_loop);
        return energies(box, particles, now, surfaces());
    }

    EnergyAccount energy_account() const {
        EnergyAccount account = energies_now();
        std::visit(
            [&](const auto& loop) {
                account.work = loop.driven_work();
                account.heat += loop.heat_of_events();
            },
            chosen_loop);
        if (!at_start.relative_error || !account.relative_error) {
            account.relative_error.reset();
            return account;
        }
        const double most = std::max({account.kinetic, std::abs(account.potential), account.pistons,
                                      std::abs(account.work), std::abs(account.heat)});
        const double error = account.in_all() - at_start.in_all() - account.work - account.heat;
        account.relative_error = most > 0.0 ? std::abs(error) / most : 0.0;
        return account;
    }

    Box box;
    Particles particles;
    std::vector<RunEvent> events;
    std::size_t next_event = 0;
    int bits;
    Loop chosen_loop;
    std::shared_ptr<const Membership> membership;  ///< at present
    Sample present;  ///< its time is always the present time; positions and velocities are valid
                     ///< only if `sampled`
    bool sampled = false;
    bool recording = false;
    bool is_following = false;
    VelocityLog velocities;
    std::vector<Collision> collisions;
    std::vector<RunEvent> happened;
    EchoMeasurement echo;
    EnergyAccount at_start;
};

Simulation::Simulation(const Gas& gas, const Run& run, const TimeCallback& on_progress) {
    check_box(gas.box);
    auto [particles, start] = place(gas);
    if (const auto problem = motion_problem(gas.box, particles, start, run))
        throw PlacementError(*problem, gas);
    Box box = gas.box;
    box.surfaces.seed = gas.seed;
    implementation_ = std::make_unique<Implementation>(box, std::move(particles), std::move(start),
                                                       run, on_progress);
}

Simulation::Simulation(const Box& box, Particles particles, const Sample& start, const Run& run) {
    check_start(box, particles, start);
    implementation_ =
        std::make_unique<Implementation>(box, std::move(particles), start, run, TimeCallback{});
}

Simulation::Simulation(const Box& box, Particles particles, const Run& run, Archive& state) {
    check_box(box);
    check_particles(box, particles);
    implementation_ = std::make_unique<Implementation>(box, std::move(particles), run);
    implementation_->archive(state);
}

Simulation::Simulation(const Simulation& other)
    : implementation_(std::make_unique<Implementation>(*other.implementation_)) {}

Simulation& Simulation::operator=(const Simulation& other) { return *this = Simulation(other); }

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::archive(Archive& archive) {
    if (!archive.is_reading()) {
        implementation_->archive(archive);
        return;
    }
    Simulation read = *this;  // so that this one remains unchanged if the archive is refused
    read.implementation_->archive(archive);
    *this = std::move(read);
}

AdvanceResult Simulation::advance_to(double time, const TimeCallback& on_progress) {
    Implementation& state = *implementation_;
    if (!(time >= state.present.time) || std::isinf(time))
        throw std::invalid_argument(
            fmt::format("cannot advance to {:g}: the present is {:g}", time, state.present.time));
    state.collisions.clear();
    if (state.is_following)
        state.velocities.open(static_cast<std::size_t>(state.particles.count()) /
                              particles_a_change);
    state.advance_with_events(time, on_progress);
    auto distance = state.echo.compare(time, [&] { return state.exact_positions(); });
    const auto reversals = static_cast<int>(std::ranges::count_if(state.happened, reverses));
    return state.with_loop([&](const auto& loop) {
        return AdvanceResult{loop.counts(),
                             loop.impulses(),
                             reversals,
                             state.collisions,
                             std::move(distance),
                             state.surfaces(),
                             state.velocities.changes()};
    });
}

void Simulation::measure_return(std::vector<double> times, bool ends_branch) {
    Implementation& state = *implementation_;
    std::vector<RunEvent> all = state.happened;
    all.insert(all.end(), state.events.begin() + static_cast<std::ptrdiff_t>(state.next_event),
               state.events.end());
    state.echo = EchoMeasurement(ways_back(all), std::move(times), state.present.time, ends_branch);
}

void Simulation::replace_events(std::vector<RunEvent> events) {
    Implementation& state = *implementation_;
    check_events(events, state.present.time, state.particles.count(), state.box);
    state.events = std::move(events);
    state.next_event = 0;
}

const Sample& Simulation::sample() {
    Implementation& state = *implementation_;
    if (!state.sampled)
        state.with_loop([&](const auto& loop) { loop.sample(state.present.time, state.present); });
    state.sampled = true;
    state.present.membership = state.membership;
    return state.present;
}

const std::shared_ptr<const Membership>& Simulation::membership() const {
    return implementation_->membership;
}

Sample Simulation::sample_of_positions() const {
    const Implementation& state = *implementation_;
    Sample sample =
        std::visit([&](const auto& loop) { return loop.sample_of_positions(state.present.time); },
                   state.chosen_loop);
    sample.membership = state.membership;
    return sample;
}

Sample Simulation::sample_of_velocities() const {
    const Implementation& state = *implementation_;
    Sample sample =
        std::visit([&](const auto& loop) { return loop.sample_of_velocities(state.present.time); },
                   state.chosen_loop);
    sample.membership = state.membership;
    return sample;
}

ExactPositions Simulation::exact_positions() const { return implementation_->exact_positions(); }

int Simulation::bits() const { return implementation_->bits; }

void Simulation::record_collisions(bool on) { implementation_->recording = on; }

void Simulation::follow_velocities(bool on) {
    implementation_->is_following = on;
    implementation_->velocities = {};
}

void Simulation::forget_sample() {
    Implementation& state = *implementation_;
    state.sampled = false;
    state.present.position.resize(0, 0);
    state.present.velocity.resize(0, 0);
}

const Box& Simulation::box() const { return implementation_->box; }

const Particles& Simulation::particles() const { return implementation_->particles; }

std::vector<SurfaceState> Simulation::surfaces() const { return implementation_->surfaces(); }

EnergyAccount Simulation::energy_account() const { return implementation_->energy_account(); }

}  // namespace carom
