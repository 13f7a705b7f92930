// What a report says, each thing once: for programs a name and a value with all its digits, for
// people a label and words. A table and JSON are two ways to write one list of facts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runs/json.h"

namespace carom {

struct Fact {
    std::string name;  ///< for programs; empty: for people only
    Json value = nullptr;
    std::string label = {};  ///< for people, with `words`; both empty: for programs only
    std::string words = {};  ///< without a label whole lines, which are written as they are
};
using Facts = std::vector<Fact>;

/// A number; null where there is none, or an infinite one.
Json number_or_null(std::optional<double> value);

/// Those for people, a row each, with labels of a width; lines end with a line break.
std::string table_of(const Facts& facts, int label_width);

/// Those for programs, as an object.
Json json_of(const Facts& facts);

}  // namespace carom
