// Words as patterns of dots: letters on a grid of cells, five across and seven up, as on a dot
// matrix. Knows no species and no YAML.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "physics/gas.h"

namespace carom {

/// The cells of a word that are filled.
struct WordShape {
    int columns = 0, rows = 0;
    std::vector<Eigen::Array2i> cells;  ///< column from the left, row from the bottom

    /// The largest side of a cell with which the word fits into a region.
    double cell_in(const Region& region) const;
};

/// The shape of a word, small letters as capitals. Letters that have none are left out.
WordShape word_shape(const std::string& words);

/// Those letters, each once, in UTF-8.
std::vector<std::string> letters_without_shape(const std::string& words);

/// What has a shape, in words.
extern const char* const letters_with_shape;

/// `count` places in the middle of a region: each cell holds `across` by `across` dots, evenly
/// spaced over the whole word, from the top left; where that is more than `count`, every so many is
/// left out. There are as many dots as `count` at least.
std::vector<Eigen::Array2d> places_of(const WordShape& shape, const Region& region, int across,
                                      std::int64_t count);

}  // namespace carom
