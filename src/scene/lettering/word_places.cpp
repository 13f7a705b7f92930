#include "scene/lettering/word_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/gas.h"
#include "scene/keys/notation.h"
#include "scene/lettering/word_pattern.h"
#include "scene/limits.h"
#include "util/text.h"

namespace carom {
namespace {

// Returns nothing for a normal distribution, which has no largest value.
std::optional<double> largest_of(const ValueRule& rule) {
    if (const auto* number = std::get_if<double>(&rule)) return *number;
    if (const auto* uniform = std::get_if<UniformDistribution>(&rule)) return uniform->high;
    const auto* list = std::get_if<std::vector<double>>(&rule);
    return list != nullptr ? std::optional(std::ranges::max(*list)) : std::nullopt;
}

// Returns the largest number of disks that fit side by side across a cell of a word.
int most_across(double cell, double radius) {
    const double most = cell / (2.0 * radius) * (1.0 + 1e-12);
    return static_cast<int>(std::min(most, std::sqrt(most_particles.value)));
}

bool check_word(const Node& word, const WordShape& shape, Errors& errors) {
    const std::vector<std::string> without = letters_without_shape(word.text);
    if (!without.empty())
        errors.add(word, fmt::format("no pattern for {}", listed(without, "and", "`")),
                   fmt::format("there is one for {}", letters_with_shape));
    else if (shape.cells.empty())
        errors.add(word, "expected at least one letter for `text`", "for instance `text: CAROM`");
    return without.empty() && !shape.cells.empty();
}

// Reports that the letters are too narrow: their strokes are as wide as `cell`, and have room for
// `room` particles in all.
void report_narrow(const Node& word, const char* particles, double count, double radius,
                   double cell, double room, Errors& errors) {
    if (room == 0.0)
        errors.add(word,
                   fmt::format("{} of radius {} are wider than the strokes of the letters, "
                               "which are {:.4g} wide",
                               particles, radius, cell),
                   fmt::format("smaller {} or a larger `within` make room", particles));
    else
        errors.add(word,
                   fmt::format("{} {} of radius {} do not fit into the letters, which have "
                               "room for {:.0f}",
                               count, particles, radius, room),
                   fmt::format("fewer or smaller {} or a larger `within` make room", particles));
}

}  // namespace

std::optional<Places> places_of_word(const Node& word, const Region& region, int dimension,
                                     const ValueRule& radius, std::int64_t count, Errors& errors) {
    const char* particles = particles_of(dimension);
    const WordShape shape = word_shape(word.text);
    const auto largest = largest_of(radius);
    if (!check_word(word, shape, errors)) return std::nullopt;
    if (!largest) {
        errors.add(word, "a `text` needs radii with an upper bound, not a normal distribution",
                   "for instance `radius: 0.3`");
        return std::nullopt;
    }
    const double depth = region.high[2] - region.low[2];
    if (dimension == 3 && 2.0 * *largest > depth) {
        errors.add(
            word,
            fmt::format("spheres of radius {} do not fit into `within`, which is {:.4g} deep",
                        *largest, depth),
            "smaller spheres or a deeper `within` make room");
        return std::nullopt;
    }
    const double cell = shape.cell_in(region);
    const auto cells = static_cast<double>(shape.cells.size());
    const int most = most_across(cell, *largest);
    const int across =
        count > 0 ? static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count) / cells)))
                  : std::clamp(most_across(cell, 1.25 * *largest), 1,
                               static_cast<int>(std::sqrt(most_particles.value / cells)));
    if (across > most) {
        report_narrow(word, particles, static_cast<double>(count), *largest, cell,
                      cells * most * most, errors);
        return std::nullopt;
    }
    const std::int64_t all = static_cast<std::int64_t>(cells) * across * across;
    return Places{places_of(shape, region, across, count > 0 ? count : all)};
}

}  // namespace carom
