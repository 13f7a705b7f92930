// Validation of heat baths.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "support/space.h"
#include "validation/hard_fluids.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* baths_field = "Heat baths";

/// One disk or sphere carries heat from bath to bath, between sides that reflect: (d + 1) / 2 T
/// from each.
Study heat_flow(int dimension) {
    constexpr double length = 5.0, radius = 0.5, hot = 3.0, cold = 1.0, mass = 2.0;
    Study study;
    study.field = baths_field;
    study.runs = 40;
    const double hits =
        2.0 / ((length - 2.0 * radius) * (1.0 / std::sqrt(hot) + 1.0 / std::sqrt(cold)) *
               std::sqrt(2.0 * pi * mass));
    study.truths = {
        {"heat that one " + body_of(dimension) + " carries per time from a bath of 3 to one of 1",
         0.5 * (dimension + 1.0) * (hot - cold) * hits, 0.0, 0.0,
         std::string("exact: ") + (dimension == 2 ? "1.5" : "2") +
             "(*T*₁ − *T*₂)*G*, *G* = 2/((*L* − 2*r*)(*T*₁^−½ + *T*₂^−½)√(2π*m*))"},
        {"its hits of each bath per time, *G*", hits, 0.0, 0.0, "exact, the same"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::box_of(dimension, {length, 3.0, 3.0});
        gas.box.surfaces.sides[0] = Bath{hot};
        gas.box.surfaces.sides[1] = Bath{cold};
        gas.species = {{.name = "",
                        .count = 1,
                        .radius = radius,
                        .mass = ValueRule{mass},
                        .velocity = Temperature{2.0}}};
        Simulation simulation(gas, {});
        const double time = 200'000.0 * run.effort;
        simulation.advance_to(time);
        const auto surfaces = simulation.surfaces();
        return std::vector<double>{
            0.5 * (surfaces[0].heat - surfaces[1].heat) / time,
            0.5 * static_cast<double>(surfaces[0].hits + surfaces[1].hits) / time};
    };
    return study;
}

Study gas_beside_a_bath(int dimension) {
    constexpr int count = 20;
    constexpr double temperature = 1.5;
    Study study;
    study.field = baths_field;
    study.runs = 24;
    const double half = 0.5 * dimension;
    const std::string body = body_of(dimension);
    study.truths = {
        {"mean energy of a " + body + " beside a bath of 1.5, of 20", half * temperature, 0.0, 0.0,
         dimension == 2 ? "exact: canonical, *T*" : "exact: canonical, (3/2) *T*"},
        {"variance of the energy of all 20", half * count * temperature * temperature, 0.0, 0.0,
         dimension == 2 ? "exact: canonical, *NT*²" : "exact: canonical, (3/2) *NT*²"},
        {"mean energy of " + body + "s that leave the bath", (half + 0.5) * temperature, 0.0, 0.0,
         dimension == 2 ? "exact: 1.5 *T*" : "exact: 2 *T*"},
        {"mean of *mv*² along the normal as they leave", 2.0 * temperature, 0.0, 0.0,
         "exact: flux law, 2*T*"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box =
            test::box_of(dimension, {dimension == 2 ? 9.0 : 5.0, dimension == 2 ? 8.0 : 4.0, 4.0});
        gas.box.surfaces.sides[0] = Bath{temperature};
        gas.species = {
            {.name = "", .count = count, .radius = 0.3, .velocity = Temperature{temperature}}};
        Run how;
        how.equilibrate = 200.0;
        Simulation simulation(gas, how);
        simulation.record_collisions(true);
        const int samples = std::max(10, static_cast<int>(12'000 * run.effort));
        double mean = 0.0, variance = 0.0, carried = 0.0, normal = 0.0, leaving = 0.0;
        for (int k = 1; k <= samples; ++k) {
            for (const Collision& hit : simulation.advance_to(2.0 * k).collisions) {
                if (!hit.second.is_surface() || hit.second.surface() != 0) continue;
                carried += 0.5 * square(hit.first_after);
                normal += hit.first_after[0] * hit.first_after[0];
                leaving += 1.0;
            }
            const double energy =
                kinetic_energies(simulation.particles(), simulation.sample()).sum();
            mean += energy / count / samples;
            variance += std::pow(energy - half * count * temperature, 2) / samples;
        }
        return std::vector<double>{mean, variance, carried / leaving, normal / leaving};
    };
    return study;
}

Study effusion(int dimension) {
    constexpr double mass = 2.0, temperature = 1.0;
    constexpr int count = 40;
    const double size = dimension == 2 ? 10.0 : 5.0, other_width = dimension == 2 ? 1.0 : 1.5;
    const Gap gap{{4.0, 2.0}, {5.0, 2.0 + other_width}};
    const double density = count / content_of({size, size, size}, dimension);
    Study study;
    study.field = baths_field;
    study.runs = 24;
    if (dimension == 2)
        study.how =
            "Behind the gap of the effusion a bath sends back what comes through, as from the same "
            "gas, so that the density stays.";
    study.truths = {
        {std::string("points that effuse through a gap of 1 ") +
             (dimension == 2 ? "per time, of 40 in 10 × 10 with *m* = 2"
                             : "× 1.5 per time, of 40 in 5 × 5 × 5 with *m* = 2"),
         density * gap.extent(dimension) * std::sqrt(temperature / (2.0 * pi * mass)), 0.0, 0.0,
         dimension == 2 ? "exact: *na*√(*T*/2π*m*)" : "exact: *n*⟨*v*⟩*a*/4 = *na*√(*T*/2π*m*)"},
        {"their mean energy", 0.5 * (dimension + 1.0) * temperature, 0.0, 0.0,
         dimension == 2 ? "exact: 1.5 *T*" : "exact: 2 *T*"},
        {"mean sin² of their angles", (dimension - 1.0) / (dimension + 1.0), 0.0, 0.0,
         dimension == 2 ? "exact: angles ½ cos *θ*" : "exact: angles 2 sin *θ* cos *θ*"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::box_of(dimension, {size + 1.0, size, size});
        gas.box.surfaces.sides[0] = Bath{temperature};
        gas.box.surfaces.partitions = {
            {.name = "gap", .axis = 0, .at = size, .gaps = {gap}},
            {.name = "counter", .axis = 0, .at = size + 1e-6, .behaviour = Bath{temperature}}};
        gas.species = {{.name = "",
                        .count = count,
                        .radius = 0.0,
                        .mass = ValueRule{mass},
                        .velocity = Temperature{temperature},
                        .position = WithinRegion{{{}, {size, size, dimension == 2 ? 0.0 : size}}}}};
        Simulation simulation(gas, {});
        simulation.record_collisions(true);
        const double time = 20'000.0 * run.effort;
        double energy = 0.0, sines = 0.0, hits = 0.0;
        for (int part = 1; part <= 20; ++part)
            for (const Collision& hit : simulation.advance_to(time * part / 20.0).collisions) {
                if (hit.second.surface() != gas.box.surfaces.first_partition() + 1) continue;
                const Vec& v = hit.first_before;
                energy += 0.5 * mass * square(v);
                sines += 1.0 - v[0] * v[0] / square(v);
                hits += 1.0;
            }
        return std::vector<double>{hits / time, energy / hits, sines / hits};
    };
    return study;
}

}  // namespace

std::vector<Study> baths() {
    return {heat_flow(2), gas_beside_a_bath(2), effusion(2),
            heat_flow(3), gas_beside_a_bath(3), effusion(3)};
}

}  // namespace carom::validation
