// The contents of a report as a list of facts: each has a name and a value with all its digits for
// programs, a label and words for people. The table and the JSON report are written from the same
// list.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/advance_result.h"
#include "runs/json.h"

namespace carom {

struct Fact {
    std::string name;  ///< for programs; empty: for people only
    Json value = nullptr;
    std::string label = {};  ///< for people, with `words`; both empty: for programs only
    std::string words = {};  ///< without a label: complete lines, written as they are
};
using Facts = std::vector<Fact>;

/// "two dimensions", and "disks": for people, in English.
const char* words_of_dimension(int dimension);
const char* word_for_bodies(int dimension);

/// A row for people only.
Fact for_people(const char* label, const std::string& words);

/// An item of a list, for people and for programs.
struct ListItem {
    std::string words;
    Json value;
};

/// A list: a row for each item, the first of them with the label; none if the list is empty.
Facts rows_of(const char* name, const char* label, std::vector<ListItem> items);

/// The same, of words for both.
Facts rows_of(const char* name, const char* label, const std::vector<std::string>& lines);

/// What contacts coincided in a run; none: not known. `is_cut`: in its beginning only.
Fact ties_fact(const std::optional<Ties>& ties, bool is_cut = false);

/// The facts for people, one per row, with labels padded to `label_width`; each line ends with a
/// line break.
std::string text_table(const Facts& facts, int label_width);

/// The facts for programs, as a JSON object.
Json json_of(const Facts& facts);

}  // namespace carom
