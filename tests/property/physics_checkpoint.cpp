// A simulation that was written and read back goes on as the original does, bit for bit, whatever
// its gas and its run are and whenever it is written; what is damaged or foreign is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "physics/multiprecision/multiprecision.h"
#include "physics/simulation.h"
#include "support/equal_disks.h"
#include "support/small_scenes.h"
#include "support/surface_scenes.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/fingerprint.h"
#include "util/random.h"

using namespace carom;

namespace {

struct Case {
    Gas gas;
    Run run;
    std::vector<double> returns = {};  ///< for measure_return()
};

std::string written(Simulation& simulation) {
    Archive archive;
    simulation.archive(archive);
    return archive.finished();
}

Simulation restored(const Simulation& of, const Run& run, const std::string& bytes) {
    Archive archive(bytes, "checkpoint");
    Simulation simulation(of.box(), of.particles(), run, archive);
    archive.expect_end();
    return simulation;
}

// All that a simulation reports as it goes on, as bits.
class Trace {
  public:
    void go_on(Simulation& simulation, const std::vector<double>& stops) {
        try {
            for (const double time : stops) {
                add(simulation.advance_to(time));
                add(simulation.sample());
                const EnergyAccount energy = simulation.energy_account();
                numbers({energy.kinetic, energy.potential, energy.pistons, energy.work, energy.heat,
                         energy.relative_error});
            }
        } catch (const std::exception& error) {
            thrown = error.what();
        }
    }

    std::vector<std::uint64_t> bits;
    std::size_t collisions = 0, returns = 0;
    std::string thrown;

  private:
    void numbers(std::initializer_list<double> all) {
        for (const double number : all) bits.push_back(std::bit_cast<std::uint64_t>(number));
    }
    void add(const Eigen::ArrayXXd& array) {
        for (Eigen::Index k = 0; k < array.size(); ++k) numbers({array.data()[k]});
    }
    void count(std::int64_t number) { bits.push_back(static_cast<std::uint64_t>(number)); }

    void add(const Sample& sample) {
        numbers({sample.time});
        add(sample.position);
        add(sample.velocity);
    }
    void add(const Collision& its) {
        count(its.first);
        count(its.second.is_particle() ? its.second.particle() : -1 - its.second.surface());
        numbers({its.time});
        for (const Eigen::Array2d& vector :
             {its.first_position, its.second_position, its.first_before, its.second_before,
              its.first_after, its.second_after})
            numbers({vector[0], vector[1]});
    }
    void add(const AdvanceResult& its) {
        for (const Collision& collision : its.collisions) add(collision);
        collisions += its.collisions.size();
        for (const std::int64_t number :
             {its.counts.particle, its.counts.wall, its.counts.ties, std::int64_t{its.reversals}})
            count(number);
        numbers({its.impulses.virial, its.impulses.largest_overlap});
        for (const double wall : its.impulses.wall) numbers({wall});
        if (its.return_distance) {
            ++returns;
            numbers({its.return_distance->log10_largest, its.return_distance->root_mean_square});
        }
        for (const SurfaceState& surface : its.surfaces) {
            for (const std::int64_t number :
                 {surface.hits, std::int64_t{surface.is_open}, std::int64_t{surface.is_held},
                  static_cast<std::int64_t>(surface.behaviour.index())})
                count(number);
            numbers({surface.impulse[0], surface.impulse[1], surface.work, surface.heat});
            if (surface.motion) numbers({surface.motion->place, surface.motion->velocity});
        }
    }
};

// Among the events of a run, in order.
void insert(std::vector<RunEvent>& events, RunEvent event) {
    const auto later = [&](const RunEvent& one) { return one.at > event.at; };
    events.insert(std::ranges::find_if(events, later), std::move(event));
}

Case any_case(std::uint64_t seed) {
    Random random(seed, "checkpoint");
    Case its;
    const auto with_surfaces = [&](test::SurfaceScene scene) {
        its.gas = std::move(scene.gas);
        its.run.events = std::move(scene.events);
    };
    bool has_steps = false;
    switch (seed % 7) {
        case 0:
            its.gas = test::small_scene(seed);
            break;
        case 1:
            its.gas = test::small_line(seed);
            break;
        case 2:
            with_surfaces(test::small_wire(seed));
            break;
        case 3:
            its.gas = test::equal_disks(random.uniform(0.1, 0.7), 256);
            break;
        case 4:
            its.gas = test::small_scene(seed);
            has_steps = true;
            break;
        default:
            with_surfaces(test::small_box(seed));
            break;
    }
    its.run.equilibrate = random.uniform() < 0.3 ? 0.5 : 0.0;
    const int any_bits[] = {53, 53, 64, 256};
    its.run.bits = its.gas.species[0].count > 100 ? 53 : any_bits[random.below(4)];
    if (has_steps) {
        its.run.time_step = 0.01;
        its.run.bits = 53;
    }
    for (std::uint64_t k = random.below(3); k > 0; --k) {
        const double at = random.uniform(0.5, 4.0);
        insert(its.run.events, {at, ReverseVelocities{}});
        for (const double after : {0.2, 0.5, 0.5, 1.0}) its.returns.push_back(at + after);
        its.returns.push_back(at);
    }
    if (random.uniform() < 0.3)
        insert(its.run.events, {random.uniform(0.0, 4.0), Perturbation{0, {"1e-9", "0"}}});
    return its;
}

Simulation start_of(const Case& its) {
    Simulation simulation(its.gas, its.run);
    simulation.record_collisions(true);
    if (!its.returns.empty()) simulation.measure_return(its.returns);
    return simulation;
}

// Anywhere, at an event of the run, at a collision, or at the very start.
double checkpoint_time(const Case& its, const Simulation& start, Random& random) {
    const double any = random.uniform(0.0, 4.0);
    if (random.uniform() < 0.3 && !its.run.events.empty())
        return its.run.events[random.below(its.run.events.size())].at;
    if (random.uniform() < 0.1) return 0.0;
    if (random.uniform() < 0.5) return any;
    Simulation probe = start;
    const auto collisions = probe.advance_to(any).collisions;
    return collisions.empty() ? any : collisions.back().time;
}

// Times up to the end, those among them at which returns are measured.
std::vector<double> stops_after(const Case& its, double time) {
    std::vector<double> stops{5.0, 6.0};
    for (const double at : its.returns)
        if (at > time) stops.push_back(at);
    stops.push_back(time + 0.1);
    std::ranges::sort(stops);
    return stops;
}

void require_same(const Trace& one, const Trace& other) {
    REQUIRE(one.thrown == other.thrown);
    REQUIRE(one.collisions == other.collisions);
    REQUIRE(one.bits == other.bits);
}

struct Found {
    std::size_t collisions = 0, returns = 0, thrown = 0;
};

Found require_exact_checkpoint(const Case& its, Simulation original, double time) {
    const Simulation start = original;
    Trace before;
    before.go_on(original, {time});
    const std::string bytes = written(original);
    Simulation copy = restored(original, its.run, bytes);
    REQUIRE(written(copy) == bytes);

    Trace trace, of_copy, of_other;
    const std::vector<double> stops = stops_after(its, time);
    if (before.thrown.empty()) {
        trace.go_on(original, stops);
        of_copy.go_on(copy, stops);
        require_same(trace, of_copy);
        REQUIRE(written(copy) == written(original));
    }

    // Over a simulation that was elsewhere, which is then as the copy was.
    Simulation other = start;
    Archive archive(bytes, "checkpoint");
    other.archive(archive);
    REQUIRE(written(other) == bytes);
    if (before.thrown.empty()) {
        of_other.go_on(other, stops);
        require_same(trace, of_other);
    }
    return {trace.collisions, trace.returns, trace.thrown.empty() ? 0U : 1U};
}

std::optional<std::string> refusal_of(const Case& its, const Simulation& simulation,
                                      const std::string& bytes) {
    try {
        restored(simulation, its.run, bytes);
    } catch (const SystemError& error) {
        return error.what();
    }
    return std::nullopt;
}

// An archive whole in itself, with other content.
std::string sealed_again(const std::string& bytes, const std::string& content) {
    std::string length;
    for (std::size_t k = 0; k < 8; ++k)
        length += static_cast<char>(content.size() >> (8 * k) & 0xff);
    return bytes.substr(0, 12) + length + fingerprint(content) + content;
}

constexpr std::size_t header_size = 8 + 4 + 8 + 32;

Case a_gas(std::int64_t count, int bits = 53) {
    Case its;
    its.gas.box.size = {8.0, 6.0};
    its.gas.species = {
        {.name = "one", .count = count, .radius = 0.2, .velocity = Temperature{1.0}}};
    its.run.bits = bits;
    return its;
}

}  // namespace

TEST_CASE("a simulation that is read back goes on as the original, bit for bit") {
    Found all;
    int runs = 0;
    for (std::uint64_t seed = 1; seed <= 700; ++seed) {
        CAPTURE(seed);
        const Case its = any_case(seed);
        CAPTURE(*its.run.bits);
        std::optional<Simulation> start;
        try {
            start = start_of(its);
        } catch (const std::exception&) {
            continue;  // no room for the disks, or what no run can be
        }
        Random random(seed, "time of the checkpoint");
        double time = 0.0;
        try {
            time = checkpoint_time(its, *start, random);
        } catch (const std::exception&) {
            time = 0.0;  // the run ends before
        }
        CAPTURE(time);
        const Found found = require_exact_checkpoint(its, *start, time);
        all.collisions += found.collisions;
        all.returns += found.returns;
        all.thrown += found.thrown;
        ++runs;
    }
    CHECK(runs > 500);
    CHECK(all.collisions > 50'000);
    CHECK(all.returns > 200);
    CHECK(all.thrown < 150);
}

TEST_CASE("a checkpoint in the middle of a crowd of events is exact") {
    for (const bool at_once : {false, true}) {
        Case its{test::equal_disks(0.5, 2500), {}};
        if (at_once)  // all collide with their neighbours at few times
            its.gas.species[0].velocity = Velocity{{{1.0, 0.0}}};
        its.gas.box.walls = {Wall::solid, Wall::solid};
        its.gas.species[0].position = LatticePlaces{};
        Simulation start = start_of(its);
        Simulation probe = start;
        const auto collisions = probe.advance_to(1.0).collisions;
        REQUIRE(collisions.size() > 100);
        for (const double share : {0.01, 0.5, 0.9}) {
            CAPTURE(share);
            const auto k = static_cast<std::size_t>(share * static_cast<double>(collisions.size()));
            require_exact_checkpoint(its, start, collisions[k].time);
        }
    }
}

TEST_CASE("a checkpoint of so many disks that memory is slow is exact") {
    Case its{test::equal_disks(0.4, 36'100), {}};
    Simulation start(its.gas, its.run);
    start.record_collisions(true);
    Simulation probe = start;
    const auto times = {0.7, 3.1};  // the second after the disks were put into another order
    for (const double time : times) {
        probe.advance_to(time);
        const std::string bytes = written(probe);
        Simulation copy = restored(probe, its.run, bytes);
        REQUIRE(written(copy) == bytes);
        Trace one, other;
        Simulation original = probe;
        one.go_on(original, {time + 0.5, time + 0.6});
        other.go_on(copy, {time + 0.5, time + 0.6});
        require_same(one, other);
        CHECK(one.collisions > 20'000);
    }
}

TEST_CASE("disks are put into another order when the original does it") {
    const Case its{test::equal_disks(0.4, 4'900), {}};
    Simulation original(its.gas, its.run);
    for (double time = 1.0; time < 8.0; time += 1.0) {
        CAPTURE(time);
        original.advance_to(time);
        Simulation copy = restored(original, its.run, written(original)), other = original;
        copy.advance_to(time + 4.0);
        other.advance_to(time + 4.0);
        REQUIRE(written(copy) == written(other));
    }
}

TEST_CASE("disks that lie on a floor are in a checkpoint") {
    Case its;
    its.gas.box.size = {10.0, 10.0};
    its.gas.box.surfaces.gravity = {0.0, -1.0};
    its.gas.species = {
        {.name = "lying", .count = 2, .radius = 0.5, .position = Places{{{2.0, 0.5}, {6.0, 0.5}}}},
        {.name = "falling",
         .count = 1,
         .radius = 0.5,
         .velocity = Velocity{{{0.1, 0.0}}},
         .position = Places{{{1.8, 5.0}}}}};
    for (const double time : {0.0, 1.0, 3.5, 5.0}) {
        CAPTURE(time);
        require_exact_checkpoint(its, start_of(its), time);
    }
}

TEST_CASE("disks that a demon lets through are in a checkpoint") {
    Case its = a_gas(70);  // so dense that disks collide while they are in the line
    its.gas.species[0].radius = 0.28;
    its.gas.box.surfaces.partitions = {
        {.name = "demon",
         .at = 4.0,
         .behaviour = Membrane{.upward = {.faster_than = 0.7}, .downward = {.faster_than = 1.2}}}};
    for (double time = 0.05; time < 4.0; time += 0.05) {
        CAPTURE(time);
        require_exact_checkpoint(its, start_of(its), time);
    }
}

TEST_CASE("a wall crushes the gas of a checkpoint when it crushes that of the original") {
    Case its = a_gas(3);
    its.gas.box.dimension = 1;
    its.gas.box.surfaces.sides[0] = Driven{1.45};
    const Found found = require_exact_checkpoint(its, start_of(its), 1.0);
    CHECK(found.thrown == 1);
}

TEST_CASE("the events of a run that were replaced are in its checkpoint") {
    Case its = a_gas(20);
    Simulation original = start_of(its);
    original.advance_to(1.0);
    original.replace_events({{2.0, ReverseVelocities{}}, {2.5, Perturbation{3, {"1e-6", "0"}}}});
    Simulation copy = restored(original, its.run, written(original));
    CHECK(copy.advance_to(3.0).reversals == 1);
    Trace one, other;
    original.advance_to(3.0);
    one.go_on(original, {4.0});
    other.go_on(copy, {4.0});
    require_same(one, other);
}

TEST_CASE("a checkpoint that is cut short or changed is refused") {
    const Case its = a_gas(12);
    Simulation simulation = start_of(its);
    simulation.advance_to(2.0);
    const std::string bytes = written(simulation);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) {
        CAPTURE(size);
        REQUIRE(refusal_of(its, simulation, bytes.substr(0, size)));
    }
    for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 64) {
        CAPTURE(at);
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 0x40);
        REQUIRE(refusal_of(its, simulation, changed));
    }
}

TEST_CASE(
    "a checkpoint whose content is wrong in a whole archive neither crashes nor takes memory") {
    for (const int bits : {53, 128}) {
        CAPTURE(bits);
        const Case its = a_gas(6, bits);
        Simulation simulation = start_of(its);
        simulation.advance_to(2.0);
        const std::string bytes = written(simulation), content = bytes.substr(header_size);
        REQUIRE_FALSE(refusal_of(its, simulation, sealed_again(bytes, content)));
        for (std::size_t size = 0; size < content.size(); size += 1 + size / 200) {
            CAPTURE(size);
            REQUIRE(refusal_of(its, simulation, sealed_again(bytes, content.substr(0, size))));
        }
        for (std::size_t at = 0; at < content.size(); at += 1 + at / 500) {
            CAPTURE(at);
            std::string changed = content;
            changed[at] = static_cast<char>(changed[at] ^ 0x55);
            CHECK_NOTHROW(refusal_of(its, simulation, sealed_again(bytes, changed)));
        }
    }
}

TEST_CASE("a checkpoint of another gas or another kind of run is refused") {
    const Case its = a_gas(12);
    Simulation simulation = start_of(its);
    simulation.advance_to(1.0);
    const std::string bytes = written(simulation);
    const auto refused = [&](const Case& other) {
        const Simulation another = start_of(other);
        const auto cause = refusal_of(other, another, bytes);
        return cause && cause->find("another kind") != std::string::npos;
    };
    CHECK_FALSE(refused(its));
    CHECK(refused(a_gas(13)));
    CHECK(refused(a_gas(12, 64)));
    Case other = its;
    other.gas.species[0].radius = 0.21;
    CHECK(refused(other));
    other = its;
    other.gas.box.size[0] = 8.5;
    CHECK(refused(other));
    other = its;
    other.gas.box.walls[0] = Wall::periodic;
    CHECK(refused(other));
    other = its;
    other.gas.box.surfaces.sides[1] = Bath{1.0};
    CHECK(refused(other));
    other = its;
    other.run.time_step = 0.1;
    CHECK(refused(other));
    other = its;
    other.run.events = {{1.0, Heat{{}, 1.0}}};
    CHECK(refused(other));
}

TEST_CASE("a simulation that refuses a checkpoint stays as it was") {
    const Case its = a_gas(12), other = a_gas(13);
    Simulation simulation = start_of(its), another = start_of(other);
    simulation.advance_to(1.0);
    another.advance_to(0.5);
    const std::string before = written(another);
    Archive archive(written(simulation), "checkpoint");
    CHECK_THROWS_AS(another.archive(archive), SystemError);
    CHECK(written(another) == before);
}

TEST_CASE("numbers of many bits are read back with every bit") {
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<Real> numbers{Real(0.0),           Real(-0.0, 64), Real(infinity, 300),
                              Real(-infinity),     Real(5e-324),   sqrt(Real(2.0, 16'384)),
                              -sqrt(Real(3.0, 65))};
    for (int bits = 53; bits < 140; ++bits) numbers.push_back(Real(1.0, bits) / 3.0);
    Archive archive;
    archive(numbers);
    Archive again(archive.finished(), "numbers");
    std::vector<Real> read;
    again(read);
    REQUIRE(read.size() == numbers.size());
    for (std::size_t k = 0; k < read.size(); ++k) {
        CAPTURE(k);
        CHECK(read[k].bits() == numbers[k].bits());
        CHECK(read[k] == numbers[k]);
        const auto one = static_cast<double>(read[k]), other = static_cast<double>(numbers[k]);
        CHECK(std::signbit(one) == std::signbit(other));
    }
    Archive of_none;
    std::vector<Real> none{Real(std::numeric_limits<double>::quiet_NaN(), 80)};
    of_none(none);
    Archive none_again(of_none.finished(), "numbers");
    none_again(read);
    CHECK(read.at(0).bits() == 80);
    CHECK(std::isnan(static_cast<double>(read[0])));
}
