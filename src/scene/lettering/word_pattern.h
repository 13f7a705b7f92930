// Words as patterns of dots: most letters fill a grid of cells five wide and seven high, as on a
// dot-matrix display. Independent of species and YAML.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "physics/box.h"

namespace carom {

/// The cells of a word that are filled.
struct WordShape {
    int columns = 0, rows = 0;
    std::vector<Eigen::Array2i> cells;  ///< column from the left, row from the bottom

    /// Returns the largest side of a cell for which the word fits into a region.
    double cell_in(const Region& region) const;
};

/// Returns the shape of a word; small letters are drawn as capitals. Characters without a pattern
/// are left out.
WordShape word_shape(const std::string& words);

/// Returns the characters without a pattern, each once, in UTF-8.
std::vector<std::string> letters_without_shape(const std::string& words);

/// The characters that have a pattern, in words.
extern const char* const letters_with_shape;

/// Returns `count` places for a word centred in a region. Each filled cell holds `across` by
/// `across` dots. If that gives more than `count` dots, dots are left out at regular intervals over
/// the whole word, counted row by row from the top left. There must be at least `count` dots.
std::vector<Vec> places_of(const WordShape& shape, const Region& region, int across,
                           std::int64_t count);

}  // namespace carom
