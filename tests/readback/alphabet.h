// Reads the letters of an SVG by comparing their outlines with those of known text that it draws
// itself.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/svg_picture.h"

namespace carom::test {

class Alphabet {
  public:
    /// Draws each letter alone, in the weights of panels.
    Alphabet();

    /// The text of the letters; `?` for a letter that is not known, as in formulae.
    std::string read(const Letters& letters) const;

  private:
    struct Known {
        std::string letter;
        Outline outline;
    };
    std::string read(const Outline& outline) const;
    std::multimap<std::string, Known> known_;  ///< by commands
};

/// The number in a label, with a true minus sign, thin spaces between thousands and powers of ten;
/// none if there are other words.
std::optional<double> number_in(const std::string& text);

/// The rounding error of a number as written: half a unit of its last digit.
double rounding_of(const std::string& text);

}  // namespace carom::test
