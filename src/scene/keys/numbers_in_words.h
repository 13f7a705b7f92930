// Numbers in the words of a scene: `{temperature}` stands for what the run gives. When a scene is
// loaded, each is replaced by a mark; when its run is known, the marks are filled in. A mark stands
// between control characters, which no text of a scene contains.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/panel_spec.h"
#include "util/diagnostics.h"

namespace carom {

class Errors;
struct Node;

/// What reads a number (scene/numbers/known_numbers.h).
struct NumberReader {
    PanelSpec instrument;
    bool is_result = false;  ///< of the instrument; otherwise its reading
    std::string line = {};   ///< column of its line; empty: the first
};

/// A number for which words of a scene ask.
struct NumberInWords {
    std::string name;               ///< "light.mean_energy"
    std::optional<double> at = {};  ///< simulated time; none: the time at which the words appear
    int digits = 3;
    bool are_decimals = false;  ///< the digits are those after the point; otherwise all
    Diagnostic place = {};      ///< of the words, with an empty message, for errors found later
    std::optional<NumberReader> reader = {};  ///< none: a number of the figure whose words ask
};

/// Returns the words with a mark for each number, which is added to `numbers`, and with `{{` and
/// `}}` as single braces; formulae stay as they are. Reports an error at the node, and leaves the
/// words as they are, if braces do not hold a number.
std::string with_marks(const std::string& words, const Node& node,
                       std::vector<NumberInWords>& numbers, Errors& errors);

/// Returns marked words with what `words_for` gives for each number, by its index.
std::string filled(std::string_view marked,
                   const std::function<std::string(std::size_t)>& words_for);

/// Returns the indices of the numbers in marked words, in order.
std::vector<std::size_t> numbers_in(std::string_view marked);

/// Returns marked words as they look with numbers of usual length.
std::string with_usual_numbers(std::string_view marked);

/// Returns how many characters words have with numbers of usual length, before they are marked.
int letters_with_usual_numbers(const std::string& words);

}  // namespace carom
