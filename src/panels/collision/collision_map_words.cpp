// The words of the collisions of two beads: axes, titles, keys and an account.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "panels/collision/collision_map.h"
#include "panels/gas/bead_words.h"
#include "util/text.h"

namespace carom::collision_map {
namespace {

constexpr double air_around = 1.08;  // over the largest velocities, at the ends of the axes

// Three digits, without zeros at the end.
std::string few_digits(Language language, double value) {
    return plain_number(language, std::stod(fmt::format("{:.3g}", off_the_tie(value))));
}

// The total momentum as text; 0 if the two momenta cancel up to round-off.
std::string momentum_words(Language language, const PairMotion& motion) {
    const double least = 1e-12 * (motion.before / motion.inverse_mass).abs().maxCoeff();
    return few_digits(language, std::abs(motion.momentum()) < least ? 0.0 : motion.momentum());
}

// The components of a vector as text; those that are 0 up to round-off are written as 0.
std::vector<std::string> numbers(Language language, const Vector& velocity) {
    const double least = 1e-9 * velocity.abs().maxCoeff();
    const auto words = [&](double v) {
        return few_digits(language, std::abs(v) < least ? 0.0 : v);
    };
    return {words(velocity[0]), words(velocity[1])};
}

std::string in_brackets(Language language, const Vector& velocity) {
    return fmt::format("({})", fmt::join(numbers(language, velocity), between_numbers(language)));
}

}  // namespace

Stroke of_momentum() {
    Stroke stroke = of_steps;
    stroke.print_dashes = dashes_in_print(1, 2);
    return stroke;
}

Counts CollisionMapPanel::counts_of(std::size_t steps) const {
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

std::string CollisionMapPanel::name_of(std::size_t k) const {
    return is_scaled() ? fmt::format("sqrt(m{0}) v{0}", number_[k])
                       : fmt::format("v{}", number_[k]);
}

Heading CollisionMapPanel::column_of(std::size_t k) const {
    return {name_of(k),
            is_scaled() ? quantities::mass.root() * quantities::velocity : quantities::velocity};
}

Axis CollisionMapPanel::axis(std::size_t k) const {
    // In this order the root needs no bar over the mass.
    const auto own = walking_names();
    const std::string quantity =
        own ? (is_scaled() ? "v\u2009√m" : "v")
            : subscripted("v", k) + (is_scaled() ? "\u2009√" + subscripted("m", k) : "");
    const double end = air_around * reach_[static_cast<Eigen::Index>(k)];
    const auto in_its_color = [&](const std::string& words) {
        return met_ ? named(words, role_of(context_, *met_, k)) : Text(words);
    };
    return {.title = in_its_color(own ? own->at(k) + ": " + quantity : quantity),
            .short_title = in_its_color(quantity),
            .low = -end,
            .high = end,
            .quantity = column_of(k).quantity};
}

std::string CollisionMapPanel::energy_words() const {
    const Language language = context_.language();
    return say(language, "energy {}", few_digits(language, motion_.energy()));
}

std::vector<Text> CollisionMapPanel::titles() const {
    if (spec_.title) return {escape_markup(*spec_.title)};
    const Language language = context_.language();
    const Text of =
        met_ ? names_of(context_, *met_)
             : Text(say(language, "masses {} and {}", mass_text(language, motion_.inverse_mass[0]),
                        mass_text(language, motion_.inverse_mass[1])));
    const Text words = text_of(language, Phrase{"Velocities of {}"}, {of});
    if (is_walk())
        return {text_of(language, Phrase{"{}, collision by collision"}, {words}),
                say(language, "Velocities, collision by collision"), say(language, "Velocities")};
    return {text_of(language, Phrase{"{} in their collision"}, {words}), words,
            say(language, "Velocities in a collision")};
}

Note CollisionMapPanel::key_of_walk(std::size_t steps) const {
    const Counts counts = counts_of(steps), all = counts_of(walk_.size());
    const Language language = context_.language();
    const auto with_each_other = [&](const Counts& of) {
        return say(language, "with each other: {}", grouped(of.pair));
    };
    const auto with_a_wall = [&](const Counts& of) {
        return say(language, "with a wall: {}", grouped(of.wall));
    };
    return {
        .entries =
            {{.words = {say(language, "start")}, .dot = hollow},
             {.words = {spec_.at ? say(language, "at time {}", plain_number(language, *spec_.at))
                                 : say(language, "now")},
              .dot = full},
             {.swatch = of_energy, .words = {energy_words()}},
             {.swatch = of_steps,
              .words = {with_each_other(counts)},
              .reserved = {{with_each_other(all)}}},
             {.swatch = of_walls, .words = {with_a_wall(counts)}, .reserved = {{with_a_wall(all)}}},
             {.swatch = of_equal,
              .words = {walking_names() ? say(language, "equal velocities")
                                        : subscripted("v", 0) + " = " + subscripted("v", 1)}}},
        .changes = true};
}

Note CollisionMapPanel::key_of_collision() const {
    const std::array v{subscripted("v", 0), subscripted("v", 1)};
    const Language language = context_.language();
    std::string energy = energy_words();
    std::string momentum = say(language, "momentum {}", momentum_words(language, motion_));
    if (motion_.has_infinite_mass()) {
        const std::size_t wall = motion_.inverse_mass[0] > 0.0 ? 1 : 0;
        const double velocity = motion_.before[static_cast<Eigen::Index>(wall)];
        energy = say(language, "no ellipse: |{} − {}| = {}", v[0], v[1],
                     few_digits(language, motion_.speed_apart()));
        momentum = say(language, "{} = {}, mass ∞", v[wall], few_digits(language, velocity));
    }
    const Vector stays = factor_ / factor_[0];
    Vector turns = factor_ * motion_.turning();
    turns /= turns[0] != 0.0 ? turns[0] : turns[1];
    const auto swatch = [](double from, double to, const Role& role, const Role& edge) {
        return Arrow{{}, {from, 0.0}, {to, 0.0}, role, edge};
    };
    return {
        .entries = {{.words = {say(language, "before {}", in_brackets(language, motion_.before))},
                     .dot = hollow},
                    {.words = {say(language, "after {}", in_brackets(language, motion_.after))},
                     .dot = full},
                    {.swatch = of_energy, .words = {energy}},
                    {.swatch = of_momentum(), .words = {momentum}},
                    {.swatch = of_equal,
                     .words = {say(language, "{} is conserved", in_brackets(language, stays))},
                     .arrows = {swatch(0.0, 0.6, muted, page)}},
                    {.words = {say(language, "{} is reversed", in_brackets(language, turns))},
                     .arrows = {swatch(0.5, 0.0, page, ink), swatch(0.5, 1.0, ink, page)}}}};
}

Note CollisionMapPanel::key(std::size_t steps) const {
    Note note = is_walk() ? key_of_walk(steps) : key_of_collision();
    note.wraps = note.may_be_beside = true;
    note.swatch_width = 2.0;
    return note;
}

std::string CollisionMapPanel::account_of(std::size_t steps) const {
    const Language language = context_.language();
    const auto mass = [&](Eigen::Index k) {
        return motion_.inverse_mass[k] > 0.0
                   ? say(language, "mass {}", mass_text(language, motion_.inverse_mass[k]))
                   : say(language, "infinite mass");
    };
    const auto both = [&](const Vector& velocity) {
        return listed(language, numbers(language, velocity));
    };
    const std::string pair = say(language, "Beads of {} and {}", mass(0), mass(1));
    if (is_walk()) {
        const Counts counts = counts_of(steps);
        return say(language, "{} at energy {}: {} and {}, from velocities {} to {}.", pair,
                   few_digits(language, motion_.energy()),
                   carom::counted(language, counts.pair, Phrase{"{} collision with one another"},
                                  Phrase{"{} collisions with one another"}),
                   carom::counted(language, counts.wall, Phrase{"{} with a wall"},
                                  Phrase{"{} with a wall"}),
                   both(walk_.front().velocity), both(walk_[steps - 1].velocity));
    }
    const std::string kept =
        motion_.has_infinite_mass()
            ? say(language,
                  "the infinite mass keeps its velocity, and the relative speed {} is conserved",
                  few_digits(language, motion_.speed_apart()))
            : say(language, "energy {} and momentum {} are conserved",
                  few_digits(language, motion_.energy()), momentum_words(language, motion_));
    return say(language, "{}, with velocities {} before their collision and {} after it: {}.", pair,
               both(motion_.before), both(motion_.after), kept);
}

}  // namespace carom::collision_map
