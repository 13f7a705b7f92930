// Validation of the pressure of hard disks and spheres, measured from the momentum that they
// exchange, and of crystals of spheres.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "stats/pairs/bond_order.h"
#include "support/bodies.h"
#include "support/equal_disks.h"
#include "validation/hard_fluids.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
std::string pressures_field(int dimension) {
    return "Pressure of hard " + body_of(dimension) + "s";
}

/// Disks on a triangular lattice of 29 by 30, in a periodic box of 29 : 30 sqrt(3) / 2.
Gas gas_of_li(double packing, std::uint64_t seed) {
    const double spacing = std::sqrt(pi / (2.0 * std::sqrt(3.0) * packing));
    Gas gas;
    gas.seed = seed;
    gas.box.size = {29.0 * spacing, 15.0 * std::sqrt(3.0) * spacing};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    Places places;
    for (int row = 0; row < 30; ++row)
        for (int k = 0; k < 29; ++k)
            places.values.push_back({(k + 0.25 + 0.5 * (row % 2)) * spacing,
                                     (row + 0.5) * 0.5 * std::sqrt(3.0) * spacing});
    gas.species = {
        {.name = "", .count = 870, .velocity = Temperature{1.0, true}, .position = places}};
    return gas;
}

/// P V / (N T) of a run whose centre of mass is at rest: there are d (N - 1) degrees of freedom.
double compressibility(Simulation& simulation, double duration) {
    const double count = static_cast<double>(simulation.particles().count());
    const double twice_energy =
        2.0 * kinetic_energies(simulation.particles(), simulation.sample()).sum();
    const double virial = simulation.advance_to(duration).impulses.virial;
    return 1.0 + virial * (count - 1.0) / (count * twice_energy * duration);
}

Study li(double packing, double value, double error, int runs, double duration) {
    Study study;
    study.field = pressures_field(2);
    study.runs = runs;
    study.truths = {{"*P*(2*R*)²/*T* of 870 disks at packing " +
                         std::string(packing == 0.7 ? "0.700" : "0.670") + ", box 29 : 30√3/2",
                     value, error, 0.0,
                     "B. Li et al., J. Chem. Phys. 157, 234111 (2022), data at "
                     "github.com/jellyfysh/HistoricDisks"}};
    study.measure = [=](const RunOf& run) {
        Run how;
        how.equilibrate = 0.1 * duration * run.effort;
        Simulation simulation(gas_of_li(packing, run.seed), how);
        return std::vector<double>{4.0 * packing / pi *
                                   compressibility(simulation, duration * run.effort)};
    };
    return study;
}

Study equation(int dimension, double packing, double value, double error, const char* source,
               double duration) {
    const int count = dimension == 2 ? 900 : 512;
    Study study;
    study.field = pressures_field(dimension);
    study.runs = 20;
    study.truths = {
        {fmt::format("*Z* = *P{}*/*NT* at packing {:.2f}", dimension == 2 ? "A" : "V", packing),
         value + finite_number(dimension, packing, count), error, 0.0, source}};
    study.measure = [=](const RunOf& run) {
        Run how;  // spheres collide more often
        how.equilibrate = (20.0 + 4.0 / packing) / (dimension == 2 ? 1.0 : 2.0);
        Simulation simulation(test::equal_particles(dimension, packing, count, run.seed), how);
        return std::vector<double>{compressibility(simulation, duration * run.effort)};
    };
    return study;
}

constexpr const char* of_kolafa =
    "J. Kolafa, M. Rottner, Mol. Phys. 104, 3435 (2006), equation (7), and 1/*N*";
constexpr const char* of_henderson =
    "D. Henderson, Mol. Phys. 30, 971 (1975), and 1/*N*; its error: how far it is from Kolafa and "
    "Rottner’s";

constexpr const char* of_series =
    "virial coefficients to *B*₁₀: N. Clisby, B. M. McCoy, J. Stat. Phys. 122, 15 (2006), and "
    "1/*N*";
constexpr const char* of_malijevsky =
    "J. Kolafa, S. Labík, A. Malijevský, Phys. Chem. Chem. Phys. 6, 2335 (2004), the fit to their "
    "molecular dynamics, and 1/*N*";

Study by_henderson(double packing, double duration) {
    const double value = henderson(packing);
    return equation(2, packing, value, std::abs(value - compressibility_of(2, packing)),
                    of_henderson, duration);
}

Study by_series(int dimension, double packing, double duration) {
    return equation(dimension, packing, virial_series(dimension, packing), 0.0, of_series,
                    duration);
}

Study by_kolafa(double packing, double duration) {
    return equation(2, packing, compressibility_of(2, packing), 0.0, of_kolafa, duration);
}

/// Their runs have a standard error of 0.00002 of Z.
Study by_malijevsky(double packing, double duration) {
    const double value = compressibility_of(3, packing);
    return equation(3, packing, value, 2e-5 * value, of_malijevsky, duration);
}

/// Two particles between walls: the configuration integral Q (the content of the allowed pairs of
/// places) is known, and thus also the force on a wall, E/d d ln Q / da.
Study two_particles(int dimension) {
    constexpr Vec sides{2.0, 1.5, 1.2};
    Study study;
    study.field = pressures_field(dimension);
    study.runs = 20;
    const auto logarithm = [=](double a) {
        const Vec changed{a, sides[1], sides[2]};
        return 2.0 * std::log(content_of(changed, dimension)) +
               std::log1p(-excluded_share(dimension, changed, 1.0));
    };
    study.truths = {
        {"force of two " + body_of(dimension) +
             "s of diameter 1 and energy 2 on a side of a box of 3 × 2.5" +
             (dimension == 2 ? "" : " × 2.2"),
         2.0 / dimension * derivative(logarithm, sides[0]), 0.0, 0.0,
         dimension == 2
             ? "exact: (*E*/2) d ln *Q*/d*a* with *Q* = *a*²*b*² − π*ab* + (4/3)(*a* + *b*) "
               "− ½, *a* = 2, *b* = 1.5"
             : "exact: (*E*/3) d ln *Q*/d*a* with *Q* = *a*²*b*²*c*² − (4/3)π*abc* + (π/2)(*ab* + "
               "*bc* + *ca*) − (8/15)(*a* + *b* + *c*) + ⅙, *a* = 2, *b* = 1.5, *c* = 1.2"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::box_of(dimension, {sides[0] + 1.0, sides[1] + 1.0, sides[2] + 1.0});
        gas.species = {{.name = "", .count = 2, .velocity = Speed{std::numbers::sqrt2}}};
        Simulation simulation(gas, {});
        const double time = 100'000.0 * run.effort;
        return std::vector<double>{simulation.advance_to(time).impulses.wall[1] / time};
    };
    return study;
}

/// Z of two sizes of spheres, one half as large as the other, in equal numbers.
double mixture_of_halves(double packing) {
    // Moments of the diameters 1 and 1/2, in units of the third.
    const double third = 1.125, m0 = 2.0 / third, m1 = 1.5 / third, m2 = 1.25 / third;
    const double free = 1.0 - packing;
    return 1.0 / free + 3.0 * m1 * m2 / m0 * packing / (free * free) +
           std::pow(m2, 3) / m0 * packing * packing * (3.0 - packing) / std::pow(free, 3);
}

/// Carnahan and Starling's Z of equal spheres.
double carnahan_starling(double packing) {
    return (1.0 + packing * (1.0 + packing * (1.0 - packing))) / std::pow(1.0 - packing, 3);
}

Study mixture() {
    constexpr double packing = 0.25;
    constexpr int each = 500;
    Study study;
    study.field = pressures_field(3);
    study.runs = 20;
    study.truths = {
        {"*Z* of a mixture of two sizes, 1 : 2, 500 of each, at packing 0.25",
         mixture_of_halves(packing) + finite_number(mixture_of_halves, packing, 2.0 * each),
         std::abs(carnahan_starling(packing) - compressibility_of(3, packing)), 0.0,
         "T. Boublík, J. Chem. Phys. 53, 471 (1970); G. A. Mansoori et al., J. Chem. "
         "Phys. 54, 1523 (1971), and 1/*N*; its error: how far it is from Kolafa’s for "
         "equal spheres"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::cube_of(std::cbrt(each * pi / 6.0 * 1.125 / packing), Wall::periodic);
        for (const double diameter : {1.0, 0.5})
            gas.species.push_back({.name = diameter == 1.0 ? "large" : "small",
                                   .count = each,
                                   .radius = 0.5 * diameter,
                                   .mass = ValueRule{std::pow(diameter, 3)},
                                   .velocity = Temperature{1.0}});
        Run how;
        how.equilibrate = 10.0;
        Simulation simulation(gas, how);
        return std::vector<double>{compressibility(simulation, 80.0 * run.effort)};
    };
    return study;
}

constexpr const char* crystals_field = "Crystals of spheres";

/// Z of a crystal, as Speedy fitted it to molecular dynamics.
struct CrystalFit {
    double factor, shift, pole;
    double operator()(double packing) const {
        const double z = packing * 3.0 * std::numbers::sqrt2 / pi;  // over that of close packing
        return 3.0 / (1.0 - z) - factor * (z - shift) / (z - pole);
    }
};

/// All vibrations but those of the resting centre of mass take part: (Z - 1) / N less.
Study crystal() {
    constexpr double packing = 0.6;
    constexpr int count = 2048;
    constexpr CrystalFit speedy{0.5921, 0.7072, 0.601}, later{0.620735, 0.708194, 0.591663};
    Study study;
    study.field = crystals_field;
    study.runs = 10;
    const double value = speedy(packing);
    study.truths = {{"*Z* of a face-centred cubic crystal at packing 0.60",
                     value - (value - 1.0) / count, std::abs(value - later(packing)), 0.0,
                     "R. J. Speedy, J. Phys. Condens. Matter 10, 4387 (1998), and 1/*N*; its "
                     "error: how far a later fit of the same form is from it (SklogWiki, Equations "
                     "of state for crystals of hard spheres)"}};
    study.measure = [=](const RunOf& run) {
        Run how;
        how.equilibrate = 3.0;
        Gas gas = test::equal_spheres(packing, count);
        gas.seed = run.seed;
        Simulation simulation(gas, how);
        return std::vector<double>{compressibility(simulation, 20.0 * run.effort)};
    };
    return study;
}

Study order_of_crystals() {
    Study study;
    study.field = crystals_field;
    study.truths = {{"*q*₆ of a sphere among its twelve neighbours in a face-centred cubic crystal",
                     13.0 / (16.0 * std::numbers::sqrt2), 0.0, 1e-12,
                     "exact: *q*₆² is the mean of *P*₆(cos *θ*) over all pairs of the twelve "
                     "directions, 169/512; P. J. Steinhardt et al., Phys. Rev. B 28, 784 (1983)"}};
    study.measure = [=](const RunOf&) {
        const Gas gas = test::equal_spheres(0.7, 108);
        const auto [particles, sample] = place(gas);
        return std::vector<double>{local_order(bond_order(gas.box, particles, sample.position))};
    };
    return study;
}

}  // namespace

std::vector<Study> pressures() {
    std::vector<Study> all{li(0.70, 9.12956, 0.00017, 20, 3000.0),
                           li(0.67, 7.986735, 0.000026, 20, 2000.0)};
    // The number of disks is fixed: the correction of about 0.1 % exceeds the errors.
    all.push_back(by_series(2, 0.1, 3000.0));
    all.push_back(by_henderson(0.05, 4000.0));
    all.push_back(by_henderson(0.3, 600.0));
    all.push_back(by_kolafa(0.2, 1200.0));
    all.push_back(by_kolafa(0.4, 500.0));
    all.push_back(by_kolafa(0.5, 400.0));
    all.push_back(by_kolafa(0.6, 400.0));
    all[0].how =
        "Li et al. have the pressure by event-chain Monte Carlo of the same 870 disks in the same "
        "periodic box, at 0.700 where fluid and solid take turns. No correction is needed: the "
        "virial of collisions has the mean of Monte Carlo if *T* = *E*/(*N* − 1), the centre of "
        "mass at rest. Each run begins as a lattice and melts for a tenth of its time; runs of "
        "3,000 and 2,000 units of time (a diameter times √(*m*/*T*)), 20 seeds.";
    all[2].how =
        "Kolafa and Rottner’s, Henderson’s and the virial series are of infinitely many disks. 900 "
        "disks in a periodic box press differently by *ρ*/2*N* · d ln *χ*/d*ρ*, *χ* = "
        "d*ρ*/d(*P*/*T*) (J. L. Lebowitz, J. K. Percus, Phys. Rev. 122, 1675, 1961), which is "
        "included. Henderson’s equation is an approximation; how far it is from Kolafa and "
        "Rottner’s stands as its error.";
    all.push_back(two_particles(2));
    const std::size_t spheres = all.size();
    all.push_back(by_series(3, 0.01, 4000.0));
    all.push_back(by_series(3, 0.05, 1500.0));
    all.push_back(by_series(3, 0.1, 800.0));
    all.push_back(by_malijevsky(0.2, 200.0));
    all.push_back(by_malijevsky(0.3, 100.0));
    all.push_back(by_malijevsky(0.4, 60.0));
    all.push_back(by_malijevsky(0.49, 40.0));
    all[spheres].how =
        "512 spheres begin on a simple cubic lattice in a periodic cube and melt; the correction "
        "for their "
        "number is that of disks. The runs to which Kolafa, Labík and Malijevský fitted have a "
        "standard error of 0.00002 *Z*.";
    all.push_back(two_particles(3));
    all.push_back(mixture());
    all.push_back(crystal());
    all.back().how =
        "2048 spheres. Along with their centre of mass, which rests, one of *N* vibrations is "
        "missing: (*Z* − 1)/*N*, which is included.";
    all.push_back(order_of_crystals());
    return all;
}

}  // namespace carom::validation
