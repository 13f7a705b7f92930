// The law of Galton's board (Natural Inheritance, 1889): each of n rows of pegs sends a ball
// half a distance of pegs to the left or to the right, independently of the rows before, so that
// the place under them is binomial: k steps of n to the right with the probability C(n, k) / 2^n.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "physics/theory/laws/laws.h"

namespace carom::laws {
namespace {

struct PegRow {
    double height = 0.0;          // against gravity
    std::vector<double> at = {};  // in rising order
};

// Disks, and the upper ends of upright segments, in rows from the highest to the lowest. Empty if
// other things stand in the way.
std::vector<PegRow> rows_of_pegs(const BoxedGas& gas, int along, double near) {
    const int down = 1 - along;
    const double up = gas.box.surfaces.gravity[down] < 0.0 ? 1.0 : -1.0;
    std::vector<PegRow> rows;
    for (const Obstacle& obstacle : gas.box.surfaces.obstacles) {
        Vec top;
        if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape)) {
            top = disk->center;
        } else {
            const auto& corners = std::get<Obstacle::Lines>(obstacle.shape).corners;
            if (corners.size() != 2 || std::abs(corners[0][along] - corners[1][along]) > near)
                return {};
            top = up * corners[0][down] > up * corners[1][down] ? corners[0] : corners[1];
        }
        const auto row = std::ranges::find_if(
            rows, [&](const PegRow& one) { return std::abs(one.height - up * top[down]) < near; });
        if (row == rows.end())
            rows.push_back({up * top[down], {top[along]}});
        else
            row->at.push_back(top[along]);
    }
    std::ranges::sort(rows, std::ranges::greater{}, &PegRow::height);
    for (PegRow& row : rows) std::ranges::sort(row.at);
    return rows;
}

// The distance of pegs, if it is the same in all rows and each stands over the gaps of the next.
std::optional<double> distance_of_pegs(const std::vector<PegRow>& rows, double near) {
    if (rows.size() < 2 || rows.front().at.size() < 2) return std::nullopt;
    const double distance = rows.front().at[1] - rows.front().at[0];
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::vector<double>& at = rows[r].at;
        if (at.size() < 2) return std::nullopt;
        for (std::size_t k = 1; k < at.size(); ++k)
            if (std::abs(at[k] - at[k - 1] - distance) > near) return std::nullopt;
        if (r == 0) continue;
        const double shift = (at[0] - rows[r - 1].at[0]) / distance - 0.5;
        if (std::abs(shift - std::round(shift)) * distance > near) return std::nullopt;
    }
    return distance;
}

}  // namespace

// The balls begin at one place, the nearest to their mean that is over a peg or a gap; a ball over
// a gap passes the first row.
Law binomial(const BoxedGas& gas, const Asked& asked) {
    const int along = asked.axis;
    if (gas.box.dimension != 2) return none(Why::plane_only);
    if (const auto reason = first_of(gas, {Why::no_finite_mass})) return none(*reason);
    if (gas.box.surfaces.gravity[1 - along] == 0.0 || gas.box.surfaces.gravity[along] != 0.0)
        return none(Why::no_board);
    const double near = 1e-9 * gas.box.longest_side();
    const std::vector<PegRow> rows = rows_of_pegs(gas, along, near);
    const std::optional<double> distance = distance_of_pegs(rows, near);
    if (!distance || !gas.is_placed) return none(Why::no_board);
    const double first = rows.front().at.front(), step = 0.5 * *distance;
    const double steps = std::round((gas.mean_place[along] - first) / step);
    const bool is_over_gap = std::fmod(std::abs(steps), 2.0) == 1.0;
    const auto choices = static_cast<int>(rows.size()) - (is_over_gap ? 1 : 0);
    Law law;
    double share = std::pow(0.5, choices);
    for (int k = 0; k <= choices; ++k) {
        law.places.push_back(first + (steps + 2.0 * k - choices) * step);
        law.curve.push_back(share);
        share *= double(choices - k) / (k + 1);
    }
    return law;
}

}  // namespace carom::laws
