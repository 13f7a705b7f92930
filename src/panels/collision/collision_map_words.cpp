// The words and numbers of a collision map: its names and key, its table, and its account.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "panels/collision/collision_map.h"
#include "panels/gas/bead_words.h"
#include "panels/plot/layers.h"
#include "util/text.h"

namespace carom {
namespace {

using Vector = Eigen::Array2d;
using Cause = WalkStep::Cause;

// Three digits, without zeros at the end.
std::string few_digits(double value) {
    return plain_number(std::stod(fmt::format("{:.3g}", off_the_tie(value))));
}

// Two momenta that cancel but for round-off are none.
std::string momentum_words(const PairMotion& motion) {
    const double least = 1e-12 * (motion.before / motion.inverse_mass).abs().maxCoeff();
    return few_digits(std::abs(motion.momentum()) < least ? 0.0 : motion.momentum());
}

// The numbers of a vector; those that are 0 but for round-off are 0.
std::array<std::string, 2> numbers(const Vector& velocity) {
    const double least = 1e-9 * velocity.abs().maxCoeff();
    const auto words = [&](double v) { return few_digits(std::abs(v) < least ? 0.0 : v); };
    return {words(velocity[0]), words(velocity[1])};
}

std::string in_brackets(const Vector& velocity) {
    const auto [first, second] = numbers(velocity);
    return "(" + first + ", " + second + ")";
}

std::string with_and(const Vector& velocity) {
    const auto [first, second] = numbers(velocity);
    return first + " and " + second;
}

}  // namespace

struct CollisionMapPanel::Counts {
    std::int64_t pair = 0, wall = 0;
};

CollisionMapPanel::Counts CollisionMapPanel::counts_of(std::size_t steps) const {
    Counts counts;
    for (std::size_t i = 0; i < steps; ++i) {
        if (walk_[i].cause == Cause::pair) ++counts.pair;
        if (walk_[i].cause == Cause::wall) ++counts.wall;
    }
    return counts;
}

std::string CollisionMapPanel::subscripted(const char* letter, std::size_t k) const {
    constexpr std::array lowered{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string words = letter;
    for (const char digit : std::to_string(number_[k]))
        words += lowered[static_cast<std::size_t>(digit - '0')];
    return words;
}

std::string CollisionMapPanel::velocity_name(std::size_t k) const {
    return (is_scaled() ? "√" + subscripted("m", k) + "\u2009" : "") + subscripted("v", k);
}

std::string CollisionMapPanel::pair_title(const Theme& theme) const {
    if (met_) return plot::markup_of(names_of(context_, *met_), theme);
    return fmt::format("masses {} and {}", mass_text(motion_.inverse_mass[0]),
                       mass_text(motion_.inverse_mass[1]));
}

std::vector<std::string> CollisionMapPanel::titles(const Theme& theme) const {
    const std::string of = pair_title(theme);
    if (is_walk())
        return {"Velocities of " + of + ", collision by collision",
                "Velocities, collision by collision", "Velocities"};
    return {"Velocities of " + of + " in their collision", "Velocities of " + of,
            "Velocities in a collision"};
}

std::vector<MapKeyEntry> CollisionMapPanel::key(std::size_t steps) const {
    const std::string v0 = subscripted("v", 0), v1 = subscripted("v", 1);
    if (is_walk()) {
        const Counts counts = counts_of(steps);
        return {{MapMark::before, "start"},
                {MapMark::after, spec_.at ? "at time " + plain_number(*spec_.at) : "present"},
                {MapMark::energy, "energy " + few_digits(motion_.energy())},
                {MapMark::steps, "with each other: " + grouped(counts.pair)},
                {MapMark::walls, "with a wall: " + grouped(counts.wall)},
                {MapMark::equal, v0 + " = " + v1}};
    }
    std::vector<MapKeyEntry> entries{{MapMark::before, "before " + in_brackets(motion_.before)},
                                     {MapMark::after, "after " + in_brackets(motion_.after)}};
    if (motion_.has_infinite_mass()) {
        const std::size_t wall = motion_.inverse_mass[0] > 0.0 ? 1 : 0;
        const double velocity = motion_.before[static_cast<Eigen::Index>(wall)];
        entries.push_back({MapMark::energy, "no ellipse: |" + v0 + " − " + v1 +
                                                "| = " + few_digits(motion_.speed_apart())});
        entries.push_back(
            {MapMark::momentum, (wall == 0 ? v0 : v1) + " = " + few_digits(velocity) + ", mass ∞"});
    } else {
        entries.push_back({MapMark::energy, "energy " + few_digits(motion_.energy())});
        entries.push_back({MapMark::momentum, "momentum " + momentum_words(motion_)});
    }
    const Vector stays = factor_ / factor_[0];
    Vector turns = factor_ * motion_.turning();
    turns /= turns[0] != 0.0 ? turns[0] : turns[1];
    entries.push_back({MapMark::center, in_brackets(stays) + " stays"});
    entries.push_back({MapMark::turning, in_brackets(turns) + " turns round"});
    return entries;
}

Table CollisionMapPanel::table(const PanelState& state, const Theme&) const {
    const auto column = [&](std::size_t k) {
        const auto number = number_[k];
        return is_scaled()
                   ? column_name(fmt::format("sqrt(m{0}) v{0}", number), "mass^0.5 length/time")
                   : column_name(fmt::format("v{}", number), reduced::speed);
    };
    Table table{
        {"part", "of", "step (number)", column_name("time", reduced::time), column(0), column(1)}};
    const auto add = [&](const char* part, const char* of, Cell step, double time,
                         const Vector& v) {
        const Vector at = factor_ * v;
        table.rows.push_back({part, of, std::move(step), time, at[0], at[1]});
    };
    const double none = std::nan("");
    if (!motion_.has_infinite_mass())
        for (const Vector& point : ellipse()) add("curve", "energy", {}, none, point);
    if (is_walk()) {
        constexpr std::array causes{"start", "collision of the two", "wall", "reversal"};
        for (std::size_t i = 0; i < steps_of(state); ++i)
            add("point", causes.at(static_cast<std::size_t>(walk_[i].cause)), std::int64_t(i),
                walk_[i].time, walk_[i].velocity);
        return table;
    }
    const double time = met_ ? met_->time : none;
    add("point", "before", {}, time, motion_.before);
    add("point", "after", {}, time, motion_.after);
    add("point", "centre of mass", {}, none, Vector::Constant(motion_.mass_center_velocity()));
    add("eigenvector", "1", {}, none, Vector::Ones());
    add("eigenvector", "-1", {}, none, motion_.turning());
    return table;
}

std::string CollisionMapPanel::account(const PanelState& state) const {
    const auto mass = [&](Eigen::Index k) {
        return motion_.inverse_mass[k] > 0.0 ? "mass " + mass_text(motion_.inverse_mass[k])
                                             : std::string("infinite mass");
    };
    const std::string pair = fmt::format("Beads of {} and {}", mass(0), mass(1));
    if (is_walk()) {
        const std::size_t steps = steps_of(state);
        const Counts counts = counts_of(steps);
        return fmt::format(
            "{} at energy {}: {} collisions with one another and {} with a wall, from velocities "
            "{} to {}.",
            pair, few_digits(motion_.energy()), grouped(counts.pair), grouped(counts.wall),
            with_and(walk_.front().velocity), with_and(walk_[steps - 1].velocity));
    }
    const std::string kept =
        motion_.has_infinite_mass()
            ? fmt::format("the infinite mass goes on as before, and their relative speed stays {}",
                          few_digits(motion_.speed_apart()))
            : fmt::format("energy {} and momentum {} stay", few_digits(motion_.energy()),
                          momentum_words(motion_));
    return fmt::format("{} with velocities {} before their collision and {} after it: {}.", pair,
                       with_and(motion_.before), with_and(motion_.after), kept);
}

}  // namespace carom
