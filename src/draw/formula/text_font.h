// A typeface of texts as a font for formulae: the letters are those of the typeface; signs that
// it lacks, and brackets that must grow, are drawn with lines of the same thickness.
#pragma once

#include <span>
#include <vector>

#include "draw/fonts/font_families.h"
#include "draw/formula/layout.h"
#include "draw/geometry.h"

namespace carom::formula {

class TextFont : public Font {
  public:
    /// `fonts`: as in TextStyle.
    explicit TextFont(int weight, const FontFamilies* fonts = nullptr);

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

    /// The weight for letters drawn scale_of_large times as large, at which their strokes are as
    /// thick as those of the others.
    int weight_of_large() const;

  private:
    int weight_;
    const FontFamilies* fonts_;
    double x_height_ = 0.0, digit_height_ = 0.0, axis_ = 0.0, rule_ = 0.0;
};

/// The size of letters in an index, relative to those of the surrounding words.
double scale_of(Size size);

/// The magnification of a sum sign in a formula that stands alone.
constexpr double scale_of_large = 1.5;

std::string markup_of(const Letter& letter);

/// The distance, in its em, by which a letter is drawn lower than in the typeface: that of a prime,
/// which is set as an index here.
double lowering_of(const Letter& letter, const FontFamilies* fonts);

/// A sign, bracket, root or accent as polylines in a unit square (y down); empty if the typeface
/// has it.
std::vector<std::vector<Point>> lines_of(const Piece& piece);

}  // namespace carom::formula
