// Validation of beads on a wire.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/csv.h"
#include "support/test_root.h"
#include "util/random.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

constexpr const char* wires_field = "Beads on a wire";

Study places() {
    Study study;
    study.field = wires_field;
    study.runs = 20;
    const char* source =
        "exact: *x*₁/*L* ~ Beta(1, 4), the order of uniform numbers; "
        "`tests/reference/beads_1d_positions.csv`";
    for (const auto& row : test::reference_rows("beads_1d_positions.csv"))
        if (row[0] == "4" && row[1] == "1")
            study.truths = {{"mean place of the first of 4 point beads of masses 1, 2, 3.3, 5.7",
                             test::fraction(row[2]), 0.0, 0.0, source},
                            {"variance of its place", test::fraction(row[3]), 0.0, 0.0, source}};
    study.measure = [=](const RunOf& run) {
        Random random(run.seed, "beads of validation");
        Simulation wire = test::along_a_line(1, 1.0, 0.0,
                                             {{0.2, random.normal(), 1.0},
                                              {0.4, random.normal(), 1.0 / 2.0},
                                              {0.6, random.normal(), 1.0 / 3.3},
                                              {0.8, random.normal(), 1.0 / 5.7}});
        const int samples = std::max(10, static_cast<int>(100'000 * run.effort));
        // The time in which a bead crosses the wire a few times.
        const double energy = kinetic_energies(wire.particles(), wire.sample()).sum();
        const double step = 1.37 / std::sqrt(energy);
        double sum = 0.0, squares = 0.0;
        for (int k = 1; k <= samples; ++k) {
            wire.advance_to(step * k);
            const double x = wire.sample().position(0, 0);
            sum += x / samples;
            squares += (x - 0.2) * (x - 0.2) / samples;
        }
        return std::vector<double>{sum, squares};
    };
    return study;
}

Study force() {
    Study study;
    study.field = wires_field;
    study.runs = 20;
    study.truths = {
        {"force on an end of a wire of length 20 with 16 rods of length 0.6, in units "
         "of 2*E*/(*L* − *Na*)",
         1.0, 0.0, 0.0, "exact: L. Tonks, Phys. Rev. 50, 955 (1936)"}};
    study.measure = [=](const RunOf& run) {
        Random random(run.seed, "rods of validation");
        std::vector<test::Bead> beads;
        for (int i = 0; i < 16; ++i)
            beads.push_back({(i + 0.5) * 1.25, random.normal(), 1.0 / random.uniform(1.0, 7.0)});
        Simulation wire = test::along_a_line(1, 20.0, 0.3, beads);
        const double energy = kinetic_energies(wire.particles(), wire.sample()).sum();
        const double time = 100'000.0 * run.effort;
        const double measured = wire.advance_to(time).impulses.wall[0] / time;
        return std::vector<double>{measured * (20.0 - 16.0 * 0.6) / (2.0 * energy)};
    };
    return study;
}

Study galperin(int n) {
    Study study;
    study.field = wires_field;
    for (const auto& row : test::reference_rows("galperin.csv"))
        if (std::stoi(row[0]) == n)
            study.truths = {
                {"collisions of a bead between a wall and one of 100^" + row[0] + " times its mass",
                 std::stod(row[1]), 0.0, 1e-12,
                 "G. Galperin, Regul. Chaotic Dyn. 8, 375 (2003): ⌈π/arctan 10⁻ⁿ⌉ − 1"}};
    study.measure = [n](const RunOf&) {
        Simulation wire =
            test::along_a_line(1, 1e5, 0.5, {{2.0, 0.0}, {4.0, -1.0, std::pow(100.0, -n)}});
        const CollisionCounts counts = wire.advance_to(5e4).counts;
        return std::vector<double>{static_cast<double>(counts.particle + counts.wall)};
    };
    return study;
}

double entry(const nlohmann::json& value) {
    return value.is_string() ? test::fraction(value.get<std::string>()) : value.get<double>();
}

/// Whether the beads have the known final velocities after the known number of collisions.
bool is_right(const nlohmann::json& cradle) {
    std::vector<test::Bead> beads;
    double x = 500.0;
    for (std::size_t k = 0; k < cradle.at("v_in").size(); ++k) {
        const double mass = cradle.contains("masses") ? entry(cradle["masses"][k]) : 1.0;
        beads.push_back({x, entry(cradle["v_in"][k]), 1.0 / mass});
        x += 1.01 + 0.003 * static_cast<double>(k);
    }
    Simulation wire = test::along_a_line(1, 1000.0, 0.5, beads);
    const CollisionCounts counts = wire.advance_to(100.0).counts;
    if (counts.particle + counts.wall != cradle.at("collisions").get<std::int64_t>()) return false;
    for (std::size_t k = 0; k < beads.size(); ++k)
        if (std::abs(wire.sample().velocity(static_cast<Eigen::Index>(k), 0) -
                     entry(cradle["v_out"][k])) > 2e-15)
            return false;
    return true;
}

Study pairs() {
    Study study;
    study.field = wires_field;
    const auto rows = test::reference_rows("pair_collision_1d.csv");
    study.truths = {
        {"of " + std::to_string(rows.size()) +
             " collisions of two beads, those with the exact velocities, to 4 roundings",
         static_cast<double>(rows.size()), 0.0, 1e-12,
         "exact: `tests/reference/pair_collision_1d.csv`"}};
    study.measure = [=](const RunOf&) {
        double right = 0.0;
        for (const auto& row : rows) {
            const double u1 = test::fraction(row[0]), u2 = test::fraction(row[1]);
            const bool in_order = u1 > u2;
            const test::Bead first{100.0, u1, test::fraction(row[2])};
            const test::Bead second{in_order ? 101.5 : 98.5, u2, test::fraction(row[3])};
            Simulation wire = test::along_a_line(
                1, 200.0, 0.5, in_order ? std::vector{first, second} : std::vector{second, first});
            wire.advance_to(0.6 / std::abs(u1 - u2));
            const double rounding = 9e-16 * (std::abs(u1) + std::abs(u2));
            const Eigen::ArrayXXd& v = wire.sample().velocity;
            const bool is_exact =
                std::abs(v(in_order ? 0 : 1, 0) - std::stod(row[6])) <= rounding &&
                std::abs(v(in_order ? 1 : 0, 0) - std::stod(row[7])) <= rounding;
            right += is_exact ? 1.0 : 0.0;
        }
        return std::vector<double>{right};
    };
    return study;
}

Study cradles() {
    Study study;
    study.field = wires_field;
    study.truths = {{"of 7 cradles, those with the exact velocities and collisions", 7.0, 0.0,
                     1e-12, "exact: `tests/reference/newton_cradle.json`"}};
    study.measure = [=](const RunOf&) {
        std::ifstream file(test::checkout().string() + "/tests/reference/newton_cradle.json");
        const auto all = nlohmann::json::parse(file);
        double right = 0.0;
        for (const auto& cradle : all.at("cases")) right += is_right(cradle) ? 1.0 : 0.0;
        return std::vector<double>{right};
    };
    return study;
}

}  // namespace

std::vector<Study> wires() {
    return {places(), force(), galperin(3), galperin(6), cradles(), pairs()};
}

}  // namespace carom::validation
