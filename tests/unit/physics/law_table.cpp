// Each law under each condition: its value, from elsewhere, or the reason why there is none. A cell
// that is missing fails.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "physics/placement/placement.h"
#include "physics/theory/law.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

using std::numbers::pi;

struct GasState {
    Gas gas;
    std::vector<RunEvent> events = {};
    Particles particles = {};
    Sample start = {};
    Asked asked = {};

    BoxedGas boxed() const { return {gas.box, events, particles, start}; }
};

Species disks(std::int64_t count, double mass = 1.0) {
    return {.name = "disks",
            .count = count,
            .radius = 0.3,
            .mass = Quantity{mass},
            .velocity = Temperature{1.0}};
}

struct Condition {
    std::string name;
    std::function<void(GasState&)> change;
    bool is_line = false;
};

void make_periodic(GasState& s) { s.gas.box.walls = {Wall::periodic, Wall::periodic}; }

Condition on_side(const std::string& name, const Behaviour& behaviour, std::size_t side = 3) {
    return {name, [=](GasState& s) {
                s.gas.box.surfaces.sides.at(side) = behaviour;
                s.asked.surface = static_cast<std::int32_t>(side);
            }};
}

Condition with_partition(const std::string& name, const Partition& partition) {
    return {name, [=](GasState& s) {
                s.gas.box.surfaces.partitions = {partition};
                s.asked.surface = Surfaces::first_partition;
            }};
}

Condition of_disks(const std::string& name, std::int64_t count, bool is_periodic) {
    return {name, [=](GasState& s) {
                s.gas.species = {disks(count)};
                if (is_periodic) make_periodic(s);
            }};
}

Condition on_line(const std::string& name, Wall ends, const std::vector<double>& masses) {
    return {name,
            [=](GasState& s) {
                s.gas.box = {1, {20.0, 0.0}, {ends, Wall::solid}};
                Species beads = disks(static_cast<std::int64_t>(masses.size()));
                beads.mass = Quantity{masses};
                s.gas.species = {beads};
            },
            true};
}

std::vector<Condition> conditions() {
    const Partition middle{.name = "wall", .axis = 0, .at = 10.0};
    Partition gap = middle, selects = middle;
    gap.gaps = {{5.0, 8.0}};
    selects.behaviour = Membrane{.species = {0}};
    std::vector<Condition> all{
        {"closed", [](GasState&) {}},
        {"periodic", make_periodic},
        {"half", [](GasState& s) { s.gas.box.walls[0] = Wall::periodic; }},
        {"mixture",
         [](GasState& s) {
             make_periodic(s);
             s.gas.species = {disks(10), disks(1, 20.0)};
             s.gas.species[1].velocity = AtRest{};  // no momentum
         }},
        {"gravity",
         [](GasState& s) {
             s.gas.box.surfaces.gravity = {0.0, -0.2};
         }},
        {"fixed",
         [](GasState& s) {
             s.gas.species.push_back(
                 {.name = "post", .count = 1, .radius = 1.0, .mass = Infinite{}});
         }},
        {"moved",
         [](GasState& s) {
             s.gas.species.push_back({.name = "post",
                                      .count = 1,
                                      .radius = 1.0,
                                      .mass = Infinite{},
                                      .velocity = Velocity{{{1.0, 0.0}}}});
         }},
        on_side("bath", Bath{2.0}),
        {"baths",
         [](GasState& s) {
             s.gas.box.surfaces.sides[2] = Bath{1.0};
             s.gas.box.surfaces.sides[3] = Bath{2.0};
         }},
        on_side("driven", Driven{0.1}),
        on_side("piston", Piston{.mass = 50.0, .force = -2.0}),
        with_partition("membrane", selects),
        with_partition("divided", middle),
        with_partition("gap", gap),
        {"obstacle",
         [](GasState& s) {
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Disk{{10.0, 7.0}, 1.5}}};
         }},
        {"heated",
         [](GasState& s) {
             s.events = {{1.0, Heat{{}, 5.0}}};
         }},
        {"opened",
         [middle](GasState& s) {
             s.gas.box.surfaces.partitions = {middle};
             s.asked.surface = Surfaces::first_partition;
             s.events = {{1.0, SetOpen{Surfaces::first_partition, true}}};
         }},
        {"shut",
         [middle](GasState& s) {
             s.gas.box.surfaces.partitions = {middle};
             s.asked.surface = Surfaces::first_partition;
             s.events = {{1.0, SetOpen{Surfaces::first_partition, false}}};
         }},
        {"reversed",
         [](GasState& s) {
             s.events = {{1.0, ReverseVelocities{}}};
         }},
        of_disks("one", 1, false),
        of_disks("one-free", 1, true),
        {"billiard",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Disk{{10.0, 7.0}, 1.5}}};
         }},
        {"billiard-falling",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Disk{{10.0, 7.0}, 1.5}}};
             s.gas.box.surfaces.gravity = {0.0, -0.2};
         }},
        {"billiard-on",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Disk{{10.0, 7.0}, 1.5}}};
             s.asked.ends_at_walls = false;
         }},
        of_disks("two", 2, false),
        of_disks("two-free", 2, true),
        of_disks("empty", 0, false),
        {"at-rest", [](GasState& s) { s.gas.species[0].velocity = AtRest{}; }},
        {"drifts",
         [](GasState& s) {
             make_periodic(s);
             s.gas.species.push_back(disks(1));
             s.gas.species.back().velocity = Velocity{{{3.0, 0.0}}};
         }},
        {"points", [](GasState& s) { s.gas.species[0].radius = 0.0; }},
        {"points-falling",
         [](GasState& s) {
             s.gas.species[0].radius = 0.0;
             s.gas.box.surfaces.gravity = {0.0, -0.2};
         }},
        on_line("line", Wall::solid, {1.0, 2.0, 3.0, 1.0, 2.5}),
        on_line("ring", Wall::periodic, {1.0, 2.0, 3.0, 1.0, 2.5}),
        on_line("equals", Wall::solid, {1.0, 1.0, 1.0, 1.0, 1.0}),
        {"not-yet", make_periodic},
        {"hardly", make_periodic}};
    return all;
}

GasState state_of(const Condition& condition) {
    GasState s;
    s.gas.box.size = {20.0, 15.0};
    s.gas.species = {disks(20)};
    s.gas.seed = 3;
    s.asked = {.axis = 1, .cells = 4, .cells_up = 3, .at = 7.0, .ends_at_walls = true};
    condition.change(s);
    if (condition.is_line) s.asked.axis = 0;
    if (condition.name == "not-yet") s.asked.collisions = 0.0;
    if (condition.name == "hardly") s.asked.collisions = 2.0;
    std::tie(s.particles, s.start) = place(s.gas);
    return s;
}

// In the order of NoLaw::Why.
constexpr std::array<const char*, reasons_count> words_of_reasons{"unknown_gas",
                                                                  "bath",
                                                                  "baths_differ",
                                                                  "driven",
                                                                  "piston",
                                                                  "membrane",
                                                                  "partitions",
                                                                  "obstacles",
                                                                  "gravity",
                                                                  "event",
                                                                  "reversal",
                                                                  "moving_infinite_mass",
                                                                  "fixed_particles",
                                                                  "no_finite_mass",
                                                                  "alone",
                                                                  "keeps_axes",
                                                                  "unhindered",
                                                                  "pair",
                                                                  "pair_only",
                                                                  "few",
                                                                  "many",
                                                                  "at_rest",
                                                                  "no_freedom",
                                                                  "drifts",
                                                                  "points",
                                                                  "line",
                                                                  "equal_masses",
                                                                  "few_between_ends",
                                                                  "few_on_ring",
                                                                  "parted",
                                                                  "keeps_order",
                                                                  "rods",
                                                                  "no_room",
                                                                  "one_axis",
                                                                  "bounded",
                                                                  "bounded_once",
                                                                  "unequal_masses",
                                                                  "unequal_radii",
                                                                  "dense",
                                                                  "freezes",
                                                                  "off_center",
                                                                  "regions",
                                                                  "part_of_line",
                                                                  "near_wall",
                                                                  "no_walls",
                                                                  "no_gap",
                                                                  "wide_gap",
                                                                  "no_bath",
                                                                  "no_piston",
                                                                  "pistons",
                                                                  "no_force",
                                                                  "no_gravity",
                                                                  "no_floor",
                                                                  "many_kinds",
                                                                  "flies_on",
                                                                  "shapes",
                                                                  "no_collisions",
                                                                  "few_collisions"};

std::string cell_of(const Law& law) {
    return law ? "yes" : words_of_reasons.at(static_cast<std::size_t>(law.none->why));
}

// A word for each condition, in their order: "yes" or the reason.
const std::map<LawOf, std::string>& table() {
    static const std::map<LawOf, std::string> rows{
        {LawOf::mean_energy,
         "yes yes yes yes gravity yes moving_infinite_mass yes baths_differ driven "
         "piston membrane partitions partitions obstacles event event yes yes yes "
         "obstacles yes yes no_finite_mass at_rest yes points yes yes equal_masses yes "
         "yes"},
        {LawOf::mean_speed,
         "yes yes yes yes gravity yes moving_infinite_mass yes baths_differ driven "
         "piston membrane partitions partitions obstacles event event yes alone alone "
         "obstacles yes pair no_finite_mass at_rest drifts points yes yes equal_masses "
         "yes yes"},
        {LawOf::bath,
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath yes baths_differ "
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath "
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath "
         "no_bath no_bath no_bath no_bath no_bath"},
        {LawOf::temperature,
         "yes yes yes yes gravity yes moving_infinite_mass yes baths_differ driven "
         "piston membrane partitions partitions obstacles event event yes yes "
         "no_freedom obstacles yes yes no_finite_mass at_rest yes yes yes yes yes yes "
         "yes"},
        {LawOf::distribution,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event yes alone alone "
         "obstacles yes pair no_finite_mass at_rest drifts points yes yes equal_masses "
         "yes yes"},
        {LawOf::goodness_of_fit,
         "yes yes one_axis unequal_masses gravity fixed_particles moving_infinite_mass "
         "bath baths_differ driven piston membrane partitions partitions obstacles "
         "event event yes alone alone obstacles yes pair no_finite_mass at_rest drifts "
         "points unequal_masses unequal_masses equal_masses yes yes"},
        {LawOf::velocity_entropy,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event yes alone alone "
         "obstacles yes pair no_finite_mass at_rest drifts points yes yes equal_masses "
         "yes yes"},
        {LawOf::position_entropy,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass yes baths_differ "
         "driven piston membrane partitions yes obstacles yes yes yes yes yes obstacles "
         "yes yes no_finite_mass at_rest yes yes yes yes yes yes yes"},
        {LawOf::collision_rate,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event yes yes yes "
         "obstacles yes yes yes yes yes yes yes yes yes yes yes"},
        {LawOf::mean_free_path,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event yes alone alone obstacles yes pair no_finite_mass at_rest drifts points "
         "yes yes equal_masses yes yes"},
        {LawOf::ideal_pressure,
         "yes yes one_axis yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event yes keeps_axes no_freedom obstacles yes yes no_finite_mass at_rest yes "
         "yes yes yes yes yes yes"},
        {LawOf::pressure,
         "yes yes one_axis yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event yes keeps_axes no_freedom obstacles few yes no_finite_mass at_rest yes "
         "yes yes yes yes yes yes"},
        {LawOf::contact,
         "yes yes yes unequal_masses gravity fixed_particles moving_infinite_mass yes "
         "baths_differ driven piston membrane partitions partitions obstacles yes event "
         "yes unhindered unhindered obstacles yes yes no_finite_mass at_rest yes points "
         "line line line yes yes"},
        {LawOf::displacement,
         "bounded yes bounded_once yes bounded bounded moving_infinite_mass bounded "
         "bounded bounded bounded bounded bounded bounded bounded bounded bounded "
         "bounded bounded unhindered bounded bounded pair no_finite_mass at_rest drifts "
         "bounded keeps_order keeps_order keeps_order no_collisions few_collisions"},
        {LawOf::autocorrelation,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event reversal alone "
         "alone obstacles yes pair no_finite_mass at_rest drifts points yes yes "
         "equal_masses no_collisions few_collisions"},
        {LawOf::free_flight,
         "many many many many many many many many many many many many many many many "
         "many many many unhindered unhindered yes many many many many many many line "
         "line line many many"},
        {LawOf::memoryless,
         "yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes "
         "unhindered unhindered yes pair_only pair_only no_finite_mass at_rest yes points "
         "yes yes yes no_collisions yes"},
        {LawOf::flux,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event yes alone alone obstacles yes pair no_finite_mass at_rest drifts points "
         "rods yes equal_masses yes yes"},
        {LawOf::gap_flux,
         "partitions no_walls no_walls no_walls gravity fixed_particles fixed_particles "
         "bath bath driven piston membrane no_gap yes obstacles partitions no_gap "
         "partitions partitions no_walls obstacles partitions no_walls no_finite_mass "
         "partitions no_walls partitions line line line no_walls no_walls"},
        {LawOf::side_count,
         "regions regions regions regions gravity fixed_particles moving_infinite_mass "
         "bath bath driven piston membrane partitions yes obstacles event event regions "
         "regions regions obstacles regions regions no_finite_mass regions regions "
         "regions regions regions regions regions regions"},
        {LawOf::side_energy,
         "regions regions regions regions gravity fixed_particles moving_infinite_mass "
         "bath bath driven piston membrane partitions yes obstacles event event regions "
         "regions regions obstacles regions regions no_finite_mass regions regions "
         "regions regions regions regions regions regions"},
        {LawOf::side_temperature,
         "regions regions regions regions gravity fixed_particles moving_infinite_mass "
         "bath bath driven piston membrane partitions yes obstacles event event regions "
         "regions regions obstacles regions regions no_finite_mass regions regions "
         "regions regions regions regions regions regions"},
        {LawOf::piston,
         "no_piston no_piston no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston yes partitions partitions partitions no_piston "
         "no_piston partitions no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston"},
        {LawOf::isotherm,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass yes yes yes yes "
         "partitions partitions partitions obstacles yes partitions yes keeps_axes "
         "no_freedom obstacles yes yes no_finite_mass at_rest yes points yes yes yes "
         "yes yes"},
        {LawOf::heights,
         "no_gravity no_gravity no_gravity no_gravity yes no_gravity "
         "moving_infinite_mass bath bath driven piston membrane partitions partitions "
         "obstacles event event no_gravity no_gravity no_gravity obstacles no_gravity "
         "no_gravity no_gravity no_gravity no_gravity no_gravity line line line "
         "no_gravity no_gravity"},
        {LawOf::error_growth,
         "yes yes yes unequal_masses gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event yes few few obstacles few few no_finite_mass at_rest yes points line "
         "line line yes yes"}};
    return rows;
}

std::vector<std::string> words_in(const std::string& row) {
    std::istringstream stream(row);
    return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

TEST_CASE("PRINT") {
    const std::vector<Condition> all = conditions();
    for (std::size_t k = 0; k < laws_count; ++k) {
        std::printf("ROW %zu", k);
        for (const Condition& c : all) {
            const GasState s = state_of(c);
            std::printf(" %s", cell_of(law(s.boxed(), LawOf(k), s.asked)).c_str());
        }
        std::printf("\n");
    }
    std::printf("NAMES");
    for (const Condition& c : all) std::printf(" %s", c.name.c_str());
    std::printf("\n");
}

TEST_CASE("each law holds, or gives its reason, under each condition") {
    const std::vector<Condition> all = conditions();
    for (std::size_t k = 0; k < laws_count; ++k) {
        CAPTURE(k);
        REQUIRE(table().contains(LawOf(k)));
        const std::vector<std::string> row = words_in(table().at(LawOf(k)));
        REQUIRE(row.size() == all.size());
        for (std::size_t c = 0; c < all.size(); ++c) {
            CAPTURE(all[c].name);
            const GasState s = state_of(all[c]);
            CHECK(cell_of(law(s.boxed(), LawOf(k), s.asked)) == row[c]);
        }
    }
}

TEST_CASE("a picture without a gas has no law") {
    for (std::size_t k = 0; k < laws_count; ++k)
        CHECK(law({}, LawOf(k)).none->why == NoLaw::Why::unknown_gas);
}

TEST_CASE("every reason has words, in every language") {
    for (std::size_t k = 0; k < reasons_count; ++k)
        for (const Language language :
             {Language::english, Language::german, Language::french, Language::spanish}) {
            const NoLaw reason{static_cast<NoLaw::Why>(k)};
            CHECK(to_text(language, reason, {}).size() > 5);
            CHECK(to_text(language, reason, {disks(1)}).find("{}") == std::string::npos);
        }
}

namespace {

GasState state_named(const std::string& name) {
    for (const Condition& one : conditions())
        if (one.name == name) return state_of(one);
    FAIL("there is no condition ", name);
    return {};
}

double value_of(const GasState& s, LawOf quantity) {
    return law(s.boxed(), quantity, s.asked).value;
}

// Velocities with the energy and the momenta of a state, uniformly distributed: independent normal
// momenta, without their sum along conserved axes, at the same energy. The slow, obvious way.
class Shuffled {
  public:
    explicit Shuffled(const GasState& s)
        : masses_((s.particles.inverse_mass > 0.0).select(s.particles.inverse_mass.inverse(), 0.0)),
          start_(s.start.velocity),
          random_(17, "shuffled velocities") {
        const bool are_finite = (masses_ > 0.0).all();
        for (int axis = 0; axis < s.gas.box.dimension; ++axis)
            conserves_.push_back(are_finite && s.gas.box.is_periodic(axis));
        for (Eigen::Index axis = 0; axis < start_.cols(); ++axis)
            drift_.push_back(conserves_[std::size_t(axis)] ? mean(start_.col(axis)) : 0.0);
    }

    Eigen::ArrayXXd next() {
        Eigen::ArrayXXd v(start_.rows(), start_.cols());
        double wanted = 0.0, found = 0.0;
        for (Eigen::Index axis = 0; axis < v.cols(); ++axis) {
            for (Eigen::Index i = 0; i < v.rows(); ++i)
                v(i, axis) = masses_[i] > 0.0 ? random_.normal() / std::sqrt(masses_[i]) : 0.0;
            if (conserves_[std::size_t(axis)]) v.col(axis) -= mean(v.col(axis));
            wanted += (masses_ * (start_.col(axis) - drift_[std::size_t(axis)]).square()).sum();
            found += (masses_ * v.col(axis).square()).sum();
        }
        v *= std::sqrt(wanted / found);
        for (Eigen::Index axis = 0; axis < v.cols(); ++axis)
            for (Eigen::Index i = 0; i < v.rows(); ++i)
                if (masses_[i] > 0.0) v(i, axis) += drift_[std::size_t(axis)];
        return v;
    }

  private:
    double mean(const Eigen::ArrayXd& v) const { return (masses_ * v).sum() / masses_.sum(); }

    Eigen::ArrayXd masses_;
    Eigen::ArrayXXd start_;
    std::vector<bool> conserves_;
    std::vector<double> drift_;
    Random random_;
};

// A mean over samples that agrees with a value within four standard errors.
struct Sampled {
    double count = 0.0, sum = 0.0, squares = 0.0;
    void add(double x) {
        count += 1.0;
        sum += x;
        squares += x * x;
    }
    double mean() const { return sum / count; }
    double error() const {
        return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / count);
    }
    void check(double value) const {
        CHECK(std::abs(mean() - value) <= 4.0 * error() + 1e-9 * std::abs(value));
    }
};

}  // namespace

TEST_CASE("mean energies and speeds are those of uniform points on the sphere of the energy") {
    for (const std::string name : {"closed", "periodic", "half", "mixture", "fixed", "reversed",
                                   "two", "two-free", "drifts", "line", "ring", "not-yet", "one"}) {
        CAPTURE(name);
        GasState s = state_named(name);
        const std::vector<Eigen::Index> first{0}, last{s.particles.count() - 1};
        for (const std::vector<Eigen::Index>& list : {first, last}) {
            if (s.particles.inverse_mass[list[0]] == 0.0) continue;
            s.asked.of = list;
            const double mass = 1.0 / s.particles.inverse_mass[list[0]];
            Shuffled shuffled(s);
            Sampled energy, speed;
            for (int k = 0; k < 20'000; ++k) {
                const double square = shuffled.next().row(list[0]).square().sum();
                energy.add(0.5 * mass * square);
                speed.add(std::sqrt(square));
            }
            energy.check(value_of(s, LawOf::mean_energy));
            if (law(s.boxed(), LawOf::mean_speed, s.asked))
                speed.check(value_of(s, LawOf::mean_speed));
        }
    }
}

TEST_CASE("of ten light disks and a heavy one in a periodic box, the heavy one has less energy") {
    GasState s = state_named("mixture");
    const double temperature = kinetic_energies(s.particles, s.start).sum() / 10.0;  // E / (N - 1)
    CHECK(value_of(s, LawOf::temperature) == relative(temperature, 1e-12));
    s.asked.of = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
    CHECK(value_of(s, LawOf::mean_energy) == relative(temperature * (1.0 - 1.0 / 30.0), 1e-12));
    s.asked.of = {{10}};
    CHECK(value_of(s, LawOf::mean_energy) == relative(temperature * (1.0 - 20.0 / 30.0), 1e-12));
}

TEST_CASE("densities of a box that is periodic along one axis are those of the sphere") {
    for (const int count : {3, 20}) {
        CAPTURE(count);
        GasState s = state_named("half");
        s.gas.species = {disks(count)};
        std::tie(s.particles, s.start) = place(s.gas);
        const EquilibriumGas gas = *law(s.boxed(), LawOf::distribution).equilibrium;
        Shuffled shuffled(s);
        std::array<Sampled, 5> below;  // of energy, speed, component along x, along y, either
        const double e = 0.6 * gas.energy / count, v = std::sqrt(2.0 * e);
        for (int k = 0; k < 40'000; ++k) {
            const Eigen::ArrayXd u = shuffled.next().row(0);
            below[0].add(0.5 * u.square().sum() < e);
            below[1].add(std::sqrt(u.square().sum()) < v);
            below[2].add(std::abs(u[0]) < v);
            below[3].add(std::abs(u[1]) < v);
            below[4].add(0.5 * ((std::abs(u[0]) < v) + (std::abs(u[1]) < v)));
        }
        const auto integral = [](double end, const std::function<double(double)>& f) {
            constexpr int steps = 2000;
            double sum = 0.0;
            for (int k = 0; k < steps; ++k) sum += f(end * (k + 0.5) / steps) * end / steps;
            return sum;
        };
        below[0].check(integral(e, [&](double x) { return energy_density(gas, x); }));
        below[0].check(energy_probability(gas, 0.0, e));
        below[1].check(integral(v, [&](double x) { return speed_density(gas, x); }));
        below[2].check(2.0 * integral(v, [&](double x) { return velocity_density(gas, x, 0); }));
        below[3].check(2.0 * integral(v, [&](double x) { return velocity_density(gas, x, 1); }));
        below[4].check(2.0 * integral(v, [&](double x) { return velocity_density(gas, x); }));
    }
}

TEST_CASE("the temperature is twice the energy per degree of freedom") {
    const std::map<std::string, double> freedoms{
        {"closed", 40},   {"periodic", 38}, {"half", 39}, {"mixture", 20}, {"fixed", 40},
        {"reversed", 40}, {"one", 2},       {"two", 4},   {"two-free", 2}, {"points", 40},
        {"line", 5},      {"ring", 4},      {"equals", 5}};
    for (const auto& [name, count] : freedoms) {
        CAPTURE(name);
        const GasState s = state_named(name);
        const BoxedGas gas = s.boxed();
        double energy = kinetic_energies(s.particles, s.start).sum();
        energy -= 0.5 * gas.mass * gas.drift.square().sum();
        CHECK(value_of(s, LawOf::temperature) == relative(2.0 * energy / count, 1e-12));
    }
    const GasState bath = state_named("bath");
    CHECK(value_of(bath, LawOf::temperature) == 2.0);
    CHECK(value_of(bath, LawOf::bath) == 2.0);
    CHECK(value_of(bath, LawOf::mean_energy) == 2.0);  // 2 d / 2
    CHECK(value_of(bath, LawOf::mean_speed) == relative(std::sqrt(pi), 1e-14));
}

TEST_CASE("few particles collide as often as their exact relative speed says") {
    // Two disks whose momentum is conserved are one point among disks: 2 s v / (A - pi s^2).
    const GasState s = state_named("two-free");
    const Eigen::ArrayXd apart = s.start.velocity.row(0) - s.start.velocity.row(1);
    const double v = std::sqrt(apart.square().sum()), contact = 0.6;
    CHECK(value_of(s, LawOf::collision_rate) ==
          relative(2.0 * contact * v / (300.0 - pi * contact * contact), 0.005));
    CHECK(mean_speed_factor(2.0) == relative(std::sqrt(4.0 / pi), 1e-14));
    CHECK(mean_speed_factor(1e6) == relative(1.0, 1e-6));
}

TEST_CASE("pressures and the contact value are the closed forms") {
    for (const std::string name : {"closed", "periodic", "points"}) {
        const GasState s = state_named(name);
        const double energy = s.boxed().thermal.energy;
        CHECK(value_of(s, LawOf::ideal_pressure) == relative(energy / 300.0, 1e-13));
    }
    const GasState rods = state_named("line");
    const double twice = 2.0 * kinetic_energies(rods.particles, rods.start).sum();
    CHECK(value_of(rods, LawOf::ideal_pressure) == relative(twice / 20.0, 1e-13));
    CHECK(value_of(rods, LawOf::pressure) == relative(twice / (20.0 - 5 * 0.6), 1e-13));
    const double eta = 20 * pi * 0.09 / 300.0;
    CHECK(value_of(state_named("closed"), LawOf::contact) ==
          relative((1.0 - 7.0 / 16.0 * eta) / ((1.0 - eta) * (1.0 - eta)), 1e-12));
}

TEST_CASE("where walls bound displacements, these level off at twice the variance of a place") {
    CHECK(value_of(state_named("closed"), LawOf::displacement) ==
          relative((19.4 * 19.4 + 14.4 * 14.4) / 6.0, 1e-13));
    CHECK(value_of(state_named("half"), LawOf::displacement) == relative(14.4 * 14.4 / 6.0, 1e-13));
    CHECK(std::isnan(value_of(state_named("gravity"), LawOf::displacement)));
    CHECK(std::isnan(value_of(state_named("obstacle"), LawOf::displacement)));
    // Beads keep their order: places in rising order, drawn twice.
    Random random(5, "places in order");
    Sampled squares;
    for (int k = 0; k < 20'000; ++k) {
        std::array<std::vector<double>, 2> places;
        for (std::vector<double>& each : places) {
            for (int i = 0; i < 5; ++i) each.push_back(random.uniform(0.0, 20.0 - 5 * 0.6));
            std::ranges::sort(each);
        }
        double sum = 0.0;
        for (std::size_t i = 0; i < 5; ++i) sum += std::pow(places[1][i] - places[0][i], 2);
        squares.add(sum / 5.0);
    }
    squares.check(value_of(state_named("line"), LawOf::displacement));
}

TEST_CASE("the slope of the autocorrelation has the factor of finite numbers") {
    for (const std::string name : {"two", "mixture", "half", "line", "ring"}) {
        CAPTURE(name);
        GasState s = state_named(name);
        const Eigen::Index i = 0, j = s.particles.count() - 1;
        s.asked.of = {{i}};
        const double m = 1.0 / s.particles.inverse_mass[i],
                     other = 1.0 / s.particles.inverse_mass[j];
        const double mu = m * other / (m + other), d = s.gas.box.dimension;
        // At collisions with normals of any direction, weighted with the speed of approach g.
        Shuffled shuffled(s);
        Random random(3, "normals");
        Sampled lost, speed, square;
        for (int k = 0; k < 60'000; ++k) {
            const Eigen::ArrayXXd v = shuffled.next();
            const double angle = random.uniform(0.0, 2.0 * pi);
            Eigen::RowVectorXd normal(v.cols());
            if (v.cols() == 1)
                normal << 1.0;
            else
                normal << std::cos(angle), std::sin(angle);
            const double own = normal.dot(v.row(i).matrix());
            const double g = own - normal.dot(v.row(j).matrix());
            lost.add(std::abs(g) * 2.0 * mu / m * g * own);
            speed.add(std::abs(g));
            square.add(v.row(i).square().sum());
        }
        const double found = lost.mean() / speed.mean() / square.mean();
        // Three means, each within four standard errors at most.
        const double error = 4.0 * (lost.error() / lost.mean() + speed.error() / speed.mean() +
                                    square.error() / square.mean());
        CHECK(found ==
              relative(value_of(s, LawOf::autocorrelation) * 4.0 / d * other / (m + other), error));
    }
}

TEST_CASE("laws of lines, halves, heights and billiards") {
    const GasState s = state_named("half");
    Shuffled shuffled(s);
    Sampled rate, energy;
    for (int k = 0; k < 20'000; ++k) {
        const Eigen::ArrayXXd v = shuffled.next();
        const Eigen::ArrayXd crossing = 0.5 * v.col(1).abs() / 14.4;
        rate.add(crossing.sum());
        energy.add((crossing * 0.5 * v.square().rowwise().sum()).sum());
    }
    const Law flux = law(s.boxed(), LawOf::flux, s.asked);
    rate.check(flux.value);
    energy.check(flux.energy);

    const GasState gap = state_named("gap");
    CHECK(value_of(gap, LawOf::side_count) == 10.0);
    CHECK(value_of(gap, LawOf::side_energy) ==
          relative(kinetic_energies(gap.particles, gap.start).mean(), 1e-13));
    CHECK(value_of(gap, LawOf::side_temperature) == value_of(gap, LawOf::side_energy));

    const GasState falling = state_named("gravity");
    double all = 0.0;
    for (const double density : law(falling.boxed(), LawOf::heights, falling.asked).curve)
        all += density * 300.0 / 4.0;
    CHECK(all == relative(20.0, 1e-9));

    // Pi times the area that its centre can reach, over the perimeter of that.
    const double area = 19.4 * 14.4 - pi * 1.8 * 1.8;
    const double perimeter = 2.0 * (19.4 + 14.4) + 2.0 * pi * 1.8;
    CHECK(value_of(state_named("billiard"), LawOf::free_flight) ==
          relative(pi * area / perimeter, 1e-13));
}

TEST_CASE("the entropy of velocities in equilibrium is that of an independent count") {
    for (const std::string name : {"closed", "periodic", "half"}) {
        CAPTURE(name);
        const GasState s = state_named(name);
        const Law found = law(s.boxed(), LawOf::velocity_entropy);
        CHECK(found.error > 0.0);
        CHECK(found.error < 5e-4);
        Shuffled shuffled(s);
        const double thermal = std::sqrt(s.boxed().thermal.temperature());
        Sampled entropy;
        for (int k = 0; k < 20'000; ++k) {
            const Eigen::ArrayXXd v = shuffled.next() / thermal;
            std::map<std::pair<int, int>, double> cells;  // six along each axis, from -4 to 4
            const auto cell = [](double u) { return std::clamp(int(std::floor(0.75 * u)), -3, 2); };
            for (Eigen::Index i = 0; i < v.rows(); ++i)
                cells[{cell(v(i, 0)), cell(v(i, 1))}] += 1.0;
            double sum = 0.0;
            for (const auto& [place, n] : cells) sum -= n / 20.0 * std::log(n / 20.0);
            entropy.add(sum);
        }
        CHECK(std::abs(entropy.mean() - found.value) <
              4.0 * std::hypot(entropy.error(), found.error));
    }
}
