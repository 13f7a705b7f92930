// Formulae as boxes, by the rules of TeX (The TeXbook, appendix G): where each letter, rule and
// bracket stands. Sizes of letters come from a font, so that the rules can be tested with those of
// Computer Modern. Lengths are in the em of the words around; y is down, from the baseline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/geometry.h"
#include "util/formula/formula.h"

namespace carom::formula {

/// The sizes that a part of a formula may have: that of the words around, of an index, of an index
/// to an index.
enum class Size { text, script, second_script };

/// A letter or sign as it is set.
struct Letter {
    std::string text;  ///< UTF-8
    bool is_slanted = false;
    auto operator<=>(const Letter&) const = default;
};

struct Metrics {
    double width = 0.0, height = 0.0, depth = 0.0;  ///< depth below the baseline, positive
    double italic = 0.0;                            ///< by how much it leans out of its width
    double skew = 0.0;     ///< by how much an accent over it stands right of its middle
    bool is_text = false;  ///< of a font for words: no italic correction between its letters
};

/// Lengths that go with a size of letters: \fontdimen 5, 6 and 8 to 22 of TeX's symbols.
struct Lengths {
    double x_height = 0.0, quad = 0.0;
    double num1 = 0.0, num2 = 0.0, denom1 = 0.0, denom2 = 0.0;
    double sup1 = 0.0, sup2 = 0.0, sup3 = 0.0, sub1 = 0.0, sub2 = 0.0;
    double sup_drop = 0.0, sub_drop = 0.0, axis = 0.0;
};

/// Lengths that do not: \fontdimen 8 to 13 of TeX's large symbols, and its settings.
struct CommonLengths {
    double rule = 0.04;        ///< thickness of rules
    double gap = 0.04;         ///< between a rule and what is near it; in TeX as thick as a rule
    double limit_gap[5] = {};  // NOLINT(modernize-avoid-c-arrays): numbered by TeX
    double script_space = 0.05;
    double no_bracket = 0.12;
    double bracket_share = 0.901, bracket_shortfall = 0.5;
};

class Font {
  public:
    virtual ~Font() = default;
    virtual Lengths lengths(Size size) const = 0;
    virtual CommonLengths common() const = 0;
    virtual Metrics letter(const Letter& letter, Size size) const = 0;

    /// Between two letters of one font; none if they are not.
    virtual std::optional<double> kern(const Letter& first, const Letter& second,
                                       Size size) const = 0;

    /// A sum or an integral in a formula that stands alone.
    virtual Metrics large(const Letter& operation) const = 0;

    /// The smallest form of a bracket, or of a root's sign, of at least this height and depth
    /// together, or else the largest.
    virtual Metrics bracket(const Letter& bracket, double least, Size size) const = 0;
    virtual Metrics root(double least, Size size) const = 0;

    /// An accent, named as TeX names it, and the height of the letters that it is made for.
    virtual Metrics accent(const std::string& name, Size size) const = 0;
    virtual double accent_base(const std::string& name, Size size) const = 0;
};

/// A letter, rule, bracket, root's sign or accent at its place.
struct Piece {
    enum class Of { letter, large, bracket, root, accent, rule };
    Of of = Of::letter;
    Letter letter = {};
    Size size = Size::text;
    Point at = {};  ///< the begin of its baseline
    double width = 0.0, height = 0.0, depth = 0.0;
};

struct Box {
    double width = 0.0, height = 0.0, depth = 0.0;
    std::vector<Piece> pieces = {};
};

/// A formula as part of a line of words, or alone, where sums and fractions are larger.
enum class Standing { in_line, alone };

Box box_of(const Parts& formula, const Font& font, Standing standing);

}  // namespace carom::formula
