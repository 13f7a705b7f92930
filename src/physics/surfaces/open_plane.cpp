#include "physics/surfaces/open_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "physics/collision/pair_collision.h"

namespace carom {
namespace {

using Vector = std::array<double, 2>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }

auto& at(auto& things, std::integral auto i) { return things[static_cast<std::size_t>(i)]; }

// More work than this, in units of the energy that a box has without it, only a driven wall does
// that crushes the gas: in a plane the volume falls as the energy rises. It would hit ever faster,
// without end.
constexpr double most_times_energy = 1e8;

// Where a disk is and how fast at a time, from a point.
BarrierMotion seen_from(const Vector& point, const FallingDisk& d, double now) {
    BarrierMotion m{.x = {}, .v = {}, .a = d.a, .radius = d.radius};
    for (std::size_t k = 0; k < 2; ++k) {
        m.x[k] = position_at(d, k, now) - point[k];
        m.v[k] = velocity_at(d, k, now);
    }
    return m;
}

}  // namespace

OpenPlane::OpenPlane(const Box& box, const Particles& particles, const Arithmetic&)
    : box_(box),
      grid_(box, particles.radius),
      largest_(particles.count() > 0 ? particles.radius.maxCoeff() : 0.0),
      least_radius_(1e-13 * box.size.maxCoeff()),
      behaviours_(behaviours_of(box)),
      barriers_(barriers_of(box, largest_ + std::max(grid_.cell_size()[0], grid_.cell_size()[1]))),
      movers_(movers_of(box)),
      totals_(behaviours_.size()) {
    list_barriers();
}

OpenPlane::Bodies OpenPlane::bodies_of(const Particles& particles) {
    Bodies bodies = PlainBodies<Body>::bodies_of(particles);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        bodies[i].species = particles.species[static_cast<Eigen::Index>(i)];
    return bodies;
}

void OpenPlane::begin(double time) {
    for (Mover& mover : movers_) mover.change_at -= time;
}

// ------------------------------------------------------------------------------------- surfaces

// How far a disk in a cell may reach beyond it along an axis.
double OpenPlane::reach_of(std::size_t axis) const {
    return (largest_ + grid_.overhang()[axis]) * (1.0 + 1e-9) + 1e-9 * box_.size.maxCoeff();
}

// Each cell's list of what a disk in it may touch, one after the other.
void OpenPlane::list_barriers() {
    const std::array cells{grid_.last_cell()[0] + 1, grid_.last_cell()[1] + 1};
    const Vector& size = grid_.cell_size();
    std::vector<std::vector<std::int32_t>> lists(static_cast<std::size_t>(cells[0] * cells[1]));
    for (std::size_t k = 0; k < barriers_.size(); ++k) {
        const Barrier& barrier = barriers_[k];
        if (barrier.mover >= 0) {
            moving_.push_back(static_cast<std::int32_t>(k));
            continue;
        }
        if (barrier.is_endless()) floors_.push_back(static_cast<std::int32_t>(k));
        std::array<int, 2> from{}, to{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double reach = reach_of(axis);
            const auto cell = [&](double x) {
                return static_cast<int>(
                    std::clamp(std::floor(x / size[axis]), 0.0, cells[axis] - 1.0));
            };
            from[axis] = cell(barrier.low(axis) - reach);
            to[axis] = cell(barrier.high(axis) + reach);
        }
        for (int row = from[1]; row <= to[1]; ++row)
            for (int column = from[0]; column <= to[0]; ++column)
                at(lists, row * cells[0] + column).push_back(static_cast<std::int32_t>(k));
    }
    first_listed_.assign(1, 0);
    for (const auto& list : lists) {
        listed_.insert(listed_.end(), list.begin(), list.end());
        first_listed_.push_back(static_cast<std::int32_t>(listed_.size()));
    }
}

// --------------------------------------------------------------------------------------- bodies

void OpenPlane::enter(Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        Body& body = bodies[k];
        body.cell = grid_.cell_at(body.x[0], body.x[1]);
        body.passing = -1;
        settle_at_rest(body);
        grid_.add(static_cast<std::int32_t>(k), body.radius, body.cell);
    }
    for (Mover& mover : movers_) register_mover(mover);
    most_work_ = most_times_energy * energy_of(bodies);
}

// All that the gas could have without driven walls and baths, but for them: kinetic energies, those
// of disks as fast as the fastest mover, and what a fall through the box gives.
double OpenPlane::energy_of(const Bodies& bodies) const {
    const Eigen::Array2d fall = box_.surfaces.gravity.abs() * box_.size;
    double energy = 0.0, fastest = 0.0;
    for (const Mover& mover : movers_) {
        fastest = std::max(fastest, std::abs(mover.velocity));
        if (!(mover.inverse_mass > 0.0)) continue;
        const double size = box_.length(mover.axis);
        energy += (0.5 * mover.velocity * mover.velocity + std::abs(mover.acceleration) * size) /
                  mover.inverse_mass;
    }
    for (const Body& body : bodies)
        if (body.inverse_mass > 0.0)
            energy += (dot(body.v, body.v) + fastest * fastest + fall.sum()) / body.inverse_mass;
    return energy;
}

// A disk that lies on a wall and does not leave it does not fall: the wall carries it.
void OpenPlane::settle_at_rest(Body& body) const {
    body.a = {box_.surfaces.gravity[0], box_.surfaces.gravity[1]};
    if (body.a[0] == 0.0 && body.a[1] == 0.0) return;
    const double slack = 1e-12 * box_.size.maxCoeff();
    for (const std::int32_t k : floors_) {
        const Barrier& wall = at(barriers_, k);
        if (dot(wall.normal, body.v) != 0.0) continue;
        const Vector from{body.x[0] - wall.place[0], body.x[1] - wall.place[1]};
        const double distance = dot(wall.normal, from), pull = dot(wall.normal, body.a);
        if (std::abs(distance) > body.radius + slack || !(distance * pull < 0.0)) continue;
        for (std::size_t a = 0; a < 2; ++a) body.a[a] -= pull * wall.normal[a];
    }
}

double OpenPlane::pair_time(const Body& a, const Body& b, const Vector& shift, double now) const {
    const Vector origin{0.0, 0.0};
    const BarrierMotion first = seen_from(origin, a, now), second = seen_from(origin, b, now);
    const RelativeMotion<double> m{second.x[0] + shift[0] - first.x[0],
                                   second.x[1] + shift[1] - first.x[1], second.v[0] - first.v[0],
                                   second.v[1] - first.v[1]};
    const double sigma = a.radius + b.radius;
    if (a.inverse_mass + b.inverse_mass == 0.0 || sigma == 0.0) return never<double>;
    const double round_off =
        approach_round_off(m, first.v[0], first.v[1], second.v[0], second.v[1]);
    if (a.a == b.a) return contact_time(m, sigma, round_off);
    return accelerated_contact_time<double>(
        {m.x, m.y, m.vx, m.vy, b.a[0] - a.a[0], b.a[1] - a.a[1]}, sigma, round_off);
}

Vector OpenPlane::place_of(const Barrier& barrier, double now) const {
    Vector place = barrier.place;
    if (barrier.mover >= 0) {
        const Mover& mover = at(movers_, barrier.mover);
        place[mover.axis] = mover.place_at(now);
    }
    return place;
}

Vector OpenPlane::velocity_of(const Barrier& barrier, double now) const {
    Vector velocity{0.0, 0.0};
    if (barrier.mover >= 0) {
        const Mover& mover = at(movers_, barrier.mover);
        velocity[mover.axis] = mover.velocity_at(now);
    }
    return velocity;
}

std::uint32_t OpenPlane::changes_of(const Barrier& barrier) const {
    return barrier.mover >= 0 ? at(movers_, barrier.mover).changes & most_collisions : 0;
}

// As the barrier sees it.
BarrierMotion OpenPlane::motion_of(const Body& body, const Barrier& barrier, double now) const {
    BarrierMotion m = seen_from(place_of(barrier, now), body, now);
    m.radius = std::max(m.radius, least_radius_);
    if (barrier.mover >= 0) {
        const Mover& mover = at(movers_, barrier.mover);
        m.v[mover.axis] -= mover.velocity_at(now);
        m.a[mover.axis] -= mover.acceleration;
    }
    return m;
}

double OpenPlane::barrier_time(const Body& body, std::int32_t k, double now) const {
    const Barrier& barrier = at(barriers_, k);
    const BarrierMotion m = motion_of(body, barrier, now);
    if (barrier.kind == Barrier::Kind::circle) return circle_time(barrier, m);
    return line_time(barrier, m, body.passing == k);
}

Vector OpenPlane::contact_point(const Body& body, const Barrier& barrier, double now) const {
    const BarrierMotion m = motion_of(body, barrier, now);
    const bool is_line = barrier.kind == Barrier::Kind::line;
    const double share =
        is_line ? dot(barrier.normal, m.x) : 1.0 - barrier.radius / std::hypot(m.x[0], m.x[1]);
    Vector point = body.x;
    for (std::size_t k = 0; k < 2; ++k) point[k] -= share * (is_line ? barrier.normal : m.x)[k];
    return point;
}

void OpenPlane::look_at_barriers(const Body& body, double now, Candidate& first) const {
    const auto look = [&](std::int32_t k) {
        const Barrier& barrier = at(barriers_, k);
        if (const auto* membrane = std::get_if<Membrane>(&at(behaviours_, barrier.surface)))
            if (std::ranges::find(membrane->species, body.species) != membrane->species.end())
                return;
        const double time = now + barrier_time(body, k, now);
        if (!(time < first.time)) return;
        first = {time, -1 - k, changes_of(barrier)};
    };
    const int cell = body.cell[1] * (grid_.last_cell()[0] + 1) + body.cell[0];
    for (std::int32_t k = at(first_listed_, cell); k < at(first_listed_, cell + 1); ++k)
        look(at(listed_, k));
    for (const std::int32_t k : moving_) look(k);
}

// When a body leaves its cell, and by which side. A cell beside a wall has no border there.
double OpenPlane::border_time(const Body& body, double now, std::uint32_t& side) const {
    const BarrierMotion m = seen_from({0.0, 0.0}, body, now);
    const std::array<int, 2>& last = grid_.last_cell();
    const Vector& size = grid_.cell_size();
    double first = never<double>;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const bool periodic = box_.is_periodic(axis);
        const double hang = grid_.overhang()[axis];
        for (const unsigned up : {0U, 1U}) {
            if (!periodic && body.cell[axis] == (up == 1 ? last[axis] : 0)) continue;
            const double border = size[axis] * (body.cell[axis] + up);
            const double t = up == 1 ? fall_time(border + hang - m.x[axis], -m.v[axis], -m.a[axis])
                                     : fall_time(m.x[axis] - border + hang, m.v[axis], m.a[axis]);
            if (!(t < first)) continue;
            first = t;
            side = first_cell_side + 2 * static_cast<unsigned>(axis) + up;
        }
    }
    return now + first;
}

double OpenPlane::predict(Bodies& bodies, std::int32_t i, double now) {
    Body& body = at(bodies, i);
    Candidate first;
    grid_.for_each_near(
        body.radius, body.cell, [&](const CellGrid::Slots& slots, double shift_x, double shift_y) {
            std::size_t count = 0;
            grid_.append(slots, near_, count);
            for (std::size_t k = 0; k < count; ++k) {
                const std::int32_t j = near_[k];
                if (j == i) continue;
                const double time = now + pair_time(body, at(bodies, j), {shift_x, shift_y}, now);
                if (time < first.time || (time == first.time && j < first.partner))
                    first = {time, j, at(bodies, j).collisions & most_collisions};
            }
        });
    look_at_barriers(body, now, first);
    std::uint32_t side = 0;
    const double border = border_time(body, now, side);
    body.prediction = {.contact_time = first.time,
                       .partner = first.partner,
                       .partner_collisions = first.partner_collisions & most_collisions,
                       .border = side & 7U};
    return std::min(first.time, border);
}

void OpenPlane::cross(Bodies& bodies, std::int32_t i, int side, double now) {
    Body& body = at(bodies, i);
    const Cell from = body.cell;
    body.cell = grid_.next_cell(from, side);
    if (grid_.is_last(from, side)) {  // leaves a periodic box, and enters at the other side
        const auto axis = static_cast<std::size_t>(side / 2);
        advance_body(body, now);
        body.x[axis] += side % 2 == 1 ? -box_.length(axis) : box_.length(axis);
    }
    grid_.move(i, body.radius, from, body.cell);
}

bool OpenPlane::collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const {
    Body &a = at(bodies, i), &b = at(bodies, j);
    const double sigma = a.radius + b.radius;
    // Of the images of b the one in contact with a that it approaches.
    RelativeMotion<double> m{0.0, 0.0, b.v[0] - a.v[0], b.v[1] - a.v[1]};
    double best = never<double>;
    for (int turns_x = -1; turns_x <= 1; ++turns_x) {
        if (turns_x != 0 && !box_.is_periodic(0)) continue;
        for (int turns_y = -1; turns_y <= 1; ++turns_y) {
            if (turns_y != 0 && !box_.is_periodic(1)) continue;
            const double x = b.x[0] - a.x[0] + turns_x * box_.size[0];
            const double y = b.x[1] - a.x[1] + turns_y * box_.size[1];
            const double misfit = std::abs(x * x + y * y - sigma * sigma);
            if (!(misfit < best) || !(x * m.vx + y * m.vy < 0.0)) continue;
            best = misfit, m.x = x, m.y = y;
        }
    }
    if (best == never<double>) return false;
    const double factor = impulse_factor(m, a.inverse_mass, b.inverse_mass);
    const Vector r{m.x, m.y};
    for (std::size_t k = 0; k < 2; ++k) {
        a.v[k] += a.inverse_mass * factor * r[k];
        b.v[k] -= b.inverse_mass * factor * r[k];
    }
    for (Body* body : {&a, &b}) {
        body->passing = -1;
        settle_at_rest(*body);
    }
    const double square = dot(r, r);
    contact = {r, -factor * square, 0.5 * (1.0 - square / (sigma * sigma))};
    return true;
}

// ----------------------------------------------------------------------------- what surfaces do

bool OpenPlane::goes_through(const Body& body, const Barrier& barrier,
                             const Membrane& membrane) const {
    const auto axis = static_cast<std::size_t>(barrier.normal[0] == 0.0 ? 1 : 0);
    const Membrane::Speeds& speeds = body.v[axis] > 0.0 ? membrane.upward : membrane.downward;
    return speeds.admits(std::hypot(body.v[0], body.v[1]));
}

// The velocity of the flux along the normal, away from the wall, and a normal one along the wall.
void OpenPlane::leave_bath(Body& body, const Barrier& barrier, double temperature,
                           std::int64_t hit) {
    Random random(box_.surfaces.seed, fmt::format("hit {} of surface {}", hit, barrier.surface));
    const double thermal = std::sqrt(temperature * body.inverse_mass);
    const double away = thermal * std::sqrt(-2.0 * std::log1p(-random.uniform()));
    const double across = thermal * random.normal();
    const Vector from{body.x[0] - barrier.place[0], body.x[1] - barrier.place[1]};
    const double side = dot(barrier.normal, from) < 0.0 ? -1.0 : 1.0;
    body.v = {side * away * barrier.normal[0] + across * barrier.normal[1],
              side * away * barrier.normal[1] - across * barrier.normal[0]};
}

void OpenPlane::reflect(Body& body, const Barrier& barrier, double now) {
    const BarrierMotion m = motion_of(body, barrier, now);
    const Vector& normal = barrier.kind == Barrier::Kind::line ? barrier.normal : m.x;
    Mover* mover = barrier.mover >= 0 ? &at(movers_, barrier.mover) : nullptr;
    const double other = mover != nullptr ? mover->inverse_mass : 0.0;
    const double factor = -2.0 * dot(m.v, normal) / dot(normal, normal);
    const double sum = body.inverse_mass + other;
    const double share = other > 0.0 ? body.inverse_mass / sum : 1.0;
    for (std::size_t k = 0; k < 2; ++k) body.v[k] += share * factor * normal[k];
    if (!(other > 0.0)) return;
    mover->advance(now);
    mover->velocity -= other / sum * factor * normal[mover->axis];
    ++mover->changes;
}

bool OpenPlane::hit(Body& body, std::int32_t k, double now) {
    const Barrier& barrier = at(barriers_, k);
    const Behaviour& behaviour = at(behaviours_, barrier.surface);
    const BarrierMotion m = motion_of(body, barrier, now);
    const double approach = barrier.kind == Barrier::Kind::line
                                ? dot(barrier.normal, m.x) * dot(barrier.normal, m.v)
                                : dot(m.x, m.v);
    if (!(approach < 0.0)) return false;
    if (const auto* membrane = std::get_if<Membrane>(&behaviour)) {
        if (goes_through(body, barrier, *membrane)) {
            body.passing = k;
            return false;
        }
    }
    SurfaceTotals& totals = at(totals_, barrier.surface);
    ++totals.hits;
    const Vector before = body.v;
    const auto* bath = std::get_if<Bath>(&behaviour);
    if (bath != nullptr && body.inverse_mass > 0.0)
        leave_bath(body, barrier, bath->temperature, totals.hits);
    else
        reflect(body, barrier, now);
    body.passing = -1;
    settle_at_rest(body);
    if (body.inverse_mass == 0.0) return true;
    const double mass = 1.0 / body.inverse_mass;
    for (std::size_t a = 0; a < 2; ++a)
        totals.impulse[static_cast<Eigen::Index>(a)] += mass * (before[a] - body.v[a]);
    const double gain = 0.5 * mass * (dot(body.v, body.v) - dot(before, before));
    if (bath != nullptr) {
        totals.heat += gain;
        most_work_ += most_times_energy * std::abs(gain);
    } else if (barrier.mover >= 0) {
        totals.work += gain;
    }
    if (totals.work > most_work_)
        throw std::runtime_error(
            "a driven wall has given the disks 10^8 times their energy: it leaves them no room");
    return true;
}

// --------------------------------------------------------------------------------------- movers

void OpenPlane::register_mover(Mover& mover) const {
    const double width = grid_.cell_size()[mover.axis];
    mover.low = mover.place - width;
    mover.high = mover.place + width;
}

// When a mover reaches a barrier at rest, -1 - its number, or another mover.
double OpenPlane::next_obstacle(const Mover& mover, std::int32_t& other) const {
    double first = never<double>;
    const auto consider = [&](double apart, double v, double a, std::int32_t which) {
        const double side = apart < 0.0 || (apart == 0.0 && v < 0.0) ? -1.0 : 1.0;
        const double t = mover.time + fall_time(side * apart, side * v, side * a);
        if (t < first) first = t, other = which;
    };
    for (std::size_t k = 0; k < barriers_.size(); ++k) {
        const Barrier& barrier = barriers_[k];
        if (barrier.mover >= 0 || barrier.kind != Barrier::Kind::line ||
            barrier.normal[1 - mover.axis] != 0.0)
            continue;
        consider(mover.place - barrier.place[mover.axis], mover.velocity, mover.acceleration,
                 -1 - static_cast<std::int32_t>(k));
    }
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        const Mover& one = movers_[k];
        if (&one == &mover || one.axis != mover.axis) continue;
        consider(mover.place - one.place_at(mover.time),
                 mover.velocity - one.velocity_at(mover.time),
                 mover.acceleration - one.acceleration, static_cast<std::int32_t>(k));
    }
    return first;
}

double OpenPlane::mover_event(std::size_t k) const {
    const Mover& mover = movers_[k];
    std::int32_t other = 0;
    return std::min({mover.change_at, mover.registered_until(), next_obstacle(mover, other)});
}

std::optional<std::size_t> OpenPlane::process_mover(std::size_t k, double now) {
    std::optional<std::size_t> changed;
    Mover& mover = movers_[k];
    std::int32_t other = 0;
    const double reaches = next_obstacle(mover, other);
    const bool changes = mover.change_at <= now;
    mover.advance(now);
    if (reaches <= now) {
        if (mover.inverse_mass == 0.0 && (other < 0 || at(movers_, other).inverse_mass == 0.0))
            throw std::runtime_error("a driven wall reaches another");
        if (other < 0) {
            mover.velocity = -mover.velocity;
            mover.place = at(barriers_, -1 - other).place[mover.axis];
        } else {
            Mover& partner = at(movers_, other);
            partner.advance(now);
            mover.place = partner.place;
            const double impulse = 2.0 * (partner.velocity - mover.velocity) /
                                   (mover.inverse_mass + partner.inverse_mass);
            mover.velocity += impulse * mover.inverse_mass;
            partner.velocity -= impulse * partner.inverse_mass;
            ++partner.changes;
            changed = static_cast<std::size_t>(other);
        }
        ++mover.changes;
    }
    if (changes) mover.change();
    register_mover(mover);
    return changed;
}

void OpenPlane::look_for_hits(Bodies& bodies, std::size_t k, double now,
                              const std::function<double(std::int32_t)>& time_of,
                              const std::function<void(std::int32_t, double)>& earlier) {
    const Mover& mover = movers_[k];
    const double reach = reach_of(mover.axis);
    grid_.for_each_in_band(
        mover.axis, mover.low - reach, mover.high + reach, [&](const CellGrid::Slots& slots) {
            std::size_t count = 0;
            grid_.append(slots, near_, count);
            for (std::size_t n = 0; n < count; ++n) {
                const std::int32_t i = near_[n];
                Body& body = at(bodies, i);
                for (const std::int32_t barrier : moving_) {
                    if (at(barriers_, barrier).mover != static_cast<std::int32_t>(k)) continue;
                    const double time = now + barrier_time(body, barrier, now);
                    if (!(time < time_of(i))) continue;
                    body.prediction.contact_time = time;
                    body.prediction.partner = -1 - barrier;
                    body.prediction.partner_collisions = mover.changes & most_collisions;
                    earlier(i, time);
                }
            }
        });
}

void OpenPlane::shift_epoch(double shift) {
    for (Mover& mover : movers_) mover.move_epoch(shift);
}

void OpenPlane::move_epoch_to(double now) {
    for (Mover& mover : movers_) mover.advance(now);
    shift_epoch(now);
}

void OpenPlane::reverse() {
    for (Mover& mover : movers_) mover.reverse();
}

std::vector<SurfaceState> OpenPlane::states(double now) const {
    std::vector<SurfaceState> states;
    for (std::size_t k = 0; k < totals_.size(); ++k) states.push_back({totals_[k], behaviours_[k]});
    for (std::size_t k = 0; k < box_.surfaces.partitions.size(); ++k)
        states[4 + k].is_open = box_.surfaces.partitions[k].is_open;
    for (const Mover& mover : movers_)
        at(states, mover.surface).motion =
            SurfaceState::Motion{mover.place_at(now), mover.velocity_at(now)};
    return states;
}

std::optional<std::int32_t> OpenPlane::overlapped(const Body& body, double now) const {
    std::vector<Barrier> barriers = barriers_;
    for (Barrier& barrier : barriers) barrier.place = place_of(barrier, now);
    return surface_in_the_way(box_, barriers, {body.x[0], body.x[1]}, body.radius);
}

}  // namespace carom
