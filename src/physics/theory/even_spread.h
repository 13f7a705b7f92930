// The entropy of positions of a gas that is spread evenly over its box, from counts in cells.
#pragma once

namespace carom {

/// The mean of -sum p ln p over equal cells, where p is the share of `count` points that are in a
/// cell, if each point is in any cell with the same probability, independently of the others: below
/// ln(cells), as it is of a finite number. Exact, as a sum over the binomial distribution.
double entropy_of_even_spread(double count, double cells);

}  // namespace carom
