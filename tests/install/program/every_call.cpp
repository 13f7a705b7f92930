// A user's program that calls all that the installed headers offer, rightly and wrongly.
#include <carom/physics/gas.h>
#include <carom/physics/placement/placement.h>
#include <carom/physics/reversal/precision.h>
#include <carom/physics/simulation.h>
#include <carom/physics/theory/theory.h>
#include <carom/util/archive.h>
#include <carom/util/diagnostics.h>
#include <carom/util/interrupt.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace {

int failures = 0;

void check(bool condition, const char* what) {
    if (condition) return;
    std::printf("%s\n", what);
    ++failures;
}

template <typename Function>
void check_refused(Function&& f, const char* what) {
    try {
        f();
    } catch (const std::invalid_argument& error) {
        check(!std::string(error.what()).empty(), what);
        return;
    } catch (const std::exception& error) {
        std::printf("%s ended in another error: %s\n", what, error.what());
        ++failures;
        return;
    }
    check(false, what);
}

carom::Gas some_gas() {
    carom::Gas gas;
    gas.box.size = {12.0, 10.0};
    gas.species = {{.name = "disks", .count = 20, .velocity = carom::Temperature{1.0}}};
    return gas;
}

carom::Run reversed(std::optional<int> bits) {
    carom::Run run{.until = 4.0, .events = {}};
    run.events = {{2.0, carom::ReverseVelocities{}}};
    run.bits = bits;
    return run;
}

void advance_rightly() {
    carom::Simulation simulation(some_gas(), reversed(128));
    simulation.record_collisions(true);
    simulation.measure_return({4.0});
    const carom::ExactPositions start = simulation.exact_positions();
    carom::Simulation copy = simulation;
    copy.replace_events({{1.0, carom::Perturbation{3, {"1e-12", "0"}}}});
    int walls = 0;
    for (const carom::Collision& collision : simulation.advance_to(2.0).collisions) {
        const carom::Partner partner = collision.second;
        if (partner.is_surface() && partner.surface() < 4) ++walls;
        if (partner.is_particle()) check(partner.particle() != collision.first, "another partner");
    }
    check(walls > 0, "some collide with a side");
    const auto returned = simulation.advance_to(4.0).return_distance;
    check(returned && returned->largest < 1e-9, "the gas returns");
    check(return_distance(start, simulation.exact_positions()).largest == returned->largest,
          "the same distance");
    copy.advance_to(4.0);
    check(return_distance(start, copy.exact_positions()).largest > 1.0, "the copy does not");
}

void write_and_read() {
    carom::Simulation simulation(some_gas(), reversed(128));
    simulation.advance_to(1.0);
    carom::Archive archive;
    simulation.archive(archive);
    const std::string bytes = archive.finished();
    carom::Archive checkpoint(bytes, "checkpoint");
    carom::Simulation read(simulation.box(), simulation.particles(), reversed(128), checkpoint);
    const auto far = return_distance(simulation.exact_positions(), read.exact_positions());
    check(far.largest == 0.0, "a simulation is read back");
    try {
        carom::Archive half(bytes.substr(0, bytes.size() / 2), "checkpoint");
        check(false, "half a checkpoint");
    } catch (const carom::SystemError&) {
    }
}

void find_bits() {
    int calls = 0;
    const int bits =
        carom::bits_for_return(some_gas(), reversed(std::nullopt), [&](int, double) { ++calls; });
    check(bits >= carom::least_bits && calls > 0, "bits are found");
    check(carom::start_run(some_gas(), reversed(std::nullopt)).bits() == bits, "the same bits");
    check(carom::bits_for({0, {"1e-40", "0"}}, 10.0) > 128, "bits for a perturbation");
    check(carom::moved_by({{0, {"3", "4"}}}, 1).largest == 5.0, "a perturbation is measured");
    try {
        throw carom::Interrupted();
    } catch (const carom::Interrupted&) {
    }
}

void construct_wrongly() {
    const carom::Gas gas = some_gas();
    check_refused([&] { carom::Simulation(gas, reversed(std::nullopt)); }, "unset bits");
    check_refused([&] { carom::Simulation(gas, reversed(7)); }, "seven bits");
    carom::Gas flat = gas;
    flat.box.size[1] = 0.0;
    check_refused([&] { carom::Simulation(flat, {}); }, "a box without height");
    carom::Run run = reversed(53);
    run.events.push_back({1.0, carom::ReverseVelocities{}});
    check_refused([&] { carom::Simulation(gas, run); }, "events out of order");
    run.events = {{1.0, carom::Perturbation{20, {"0", "1"}}}};
    check_refused([&] { carom::Simulation(gas, run); }, "a perturbation of no particle");
    run.events = {{1.0, carom::Perturbation{0, {"a bit", "1"}}}};
    check_refused([&] { carom::Simulation(gas, run); }, "a perturbation by words");
    auto [particles, start] = carom::place(gas);
    start.position.row(1) = start.position.row(0);
    check_refused([&] { carom::Simulation(gas.box, particles, start, {}); }, "an overlap");
    start.position(1, 0) = std::nan("");
    check_refused([&] { carom::Simulation(gas.box, particles, start, {}); }, "no position");
    start.position.resize(20, 1);
    check_refused([&] { carom::Simulation(gas.box, particles, start, {}); }, "a wrong shape");
}

void advance_wrongly() {
    carom::Simulation simulation(some_gas(), reversed(53)), precise(some_gas(), reversed(64));
    simulation.advance_to(1.0);
    check_refused([&] { simulation.advance_to(0.5); }, "the past");
    check_refused([&] { simulation.advance_to(std::nan("")); }, "no time");
    check_refused([&] { simulation.advance_to(std::numeric_limits<double>::infinity()); }, "ever");
    check_refused(
        [&] {
            simulation.replace_events({{0.5, carom::ReverseVelocities{}}});
        },
        "an event in the past");
    check_refused([&] { return_distance(simulation.exact_positions(), precise.exact_positions()); },
                  "numbers of two kinds");
    check(simulation.advance_to(2.0).reversals == 1, "nothing was changed by wrong calls");
}

}  // namespace

int main() {
    advance_rightly();
    write_and_read();
    find_bits();
    construct_wrongly();
    advance_wrongly();
    return failures == 0 ? 0 : 1;
}
