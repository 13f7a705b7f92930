// The caption and the alternative text of a figure: those that the scene gives, or else generated
// from what the figure shows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "physics/units/number_text.h"
#include "util/language.h"

namespace carom {

class FigureRun;
struct Figure;
struct FigureSpec;
struct Gas;

/// The simulated times that a figure shows.
struct ShownTimes {
    std::vector<double> times;                       ///< several of a strip
    std::optional<std::array<double, 2>> over = {};  ///< of a mean: from and until
    bool are_of_collisions = false;                  ///< measured: three digits in words
};

struct FigureWords {
    std::string caption;  ///< with formulae between `$` signs; `\$` is a dollar sign
    std::string alt;      ///< plain text, for people who cannot see the picture
    std::string time;     ///< the times that it shows: 12, 6 to 12, "0, 1 and 4"
    ShownTimes shown;     ///< the same as numbers
};

/// The times that a figure shows by its spec. Some kinds show others, which are known only after
/// the run: the time of a collision, or of a mean over all of it.
ShownTimes times_of(const FigureSpec& spec);

/// These times in words.
std::string words_of(const Wording& language, const ShownTimes& shown);

/// The quantity that a key of a scene sets, in words: "temperature" for "gas.0.temperature.exact",
/// with the name of the species if there are several.
std::string words_of_key(Language language, const std::string& key, const Gas& gas);

/// The same with a value, written as in a scene: "radius 0.35".
std::string words_of_value(Language language, const std::string& key, const std::string& value,
                           const Gas& gas);

FigureWords words_of(const FigureRun& run, const Figure& figure);

}  // namespace carom
