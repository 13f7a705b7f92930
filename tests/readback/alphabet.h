// Reads the letters of an SVG by their outlines, which it knows from text of its own.
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

    /// What the letters say; `?` for one that is not known, as in formulae.
    std::string read(const Letters& letters) const;

  private:
    struct Known {
        std::string letter;
        Outline outline;
    };
    std::string read(const Outline& outline) const;
    std::multimap<std::string, Known> known_;  ///< by commands
};

/// A number as labels write it, with a true minus, thin spaces between thousands and powers of
/// ten; none where there are other words.
std::optional<double> number_in(const std::string& text);

/// Half a unit of the last digit that is written.
double rounding_of(const std::string& text);

}  // namespace carom::test
