// The typeface of films as a font for formulae: its letters, and signs and brackets drawn with
// lines of the same thickness where it has none or they must grow.
#pragma once

#include <span>
#include <vector>

#include "draw/formula/layout.h"
#include "draw/geometry.h"

namespace carom::formula {

class InterFont : public Font {
  public:
    explicit InterFont(int weight);

    Lengths lengths(Size size) const override;
    CommonLengths common() const override;
    Metrics letter(const Letter& letter, Size size) const override;
    std::optional<double> kern(const Letter& first, const Letter& second, Size size) const override;
    Metrics large(const Letter& operation) const override;
    Metrics bracket(const Letter& bracket, double least, Size size) const override;
    Metrics root(double least, Size size) const override;
    Metrics accent(const std::string& name, Size size) const override;
    double accent_base(const std::string& name, Size size) const override;

    int weight() const { return weight_; }

    /// The weight of letters drawn so many times as large, so that their strokes are as thick.
    int weight_of_large() const;

  private:
    int weight_;
    double x_height_ = 0.0, digit_height_ = 0.0, axis_ = 0.0, rule_ = 0.0;
};

/// Of letters in an index to those of the words around.
double scale_of(Size size);

/// How many times as large a sum is in a formula that stands alone.
constexpr double scale_of_large = 1.5;

std::string markup_of(const Letter& letter);

/// By how much a letter is drawn lower than the typeface has it, in its em: a prime, which is an
/// index here.
double lowering_of(const Letter& letter);

/// A sign, bracket, root or accent as lines between the points of each, in a unit square (y down);
/// none if the typeface has it.
std::vector<std::vector<Point>> lines_of(const Piece& piece);

}  // namespace carom::formula
