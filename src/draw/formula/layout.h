// The layout of formulae as boxes, by the rules of TeX (The TeXbook, appendix G): the position of
// each letter, rule and bracket. The metrics of letters come from a Font, so that the rules can be
// tested with those of Computer Modern. Lengths are in units of the em of the surrounding words; y
// is down, from the baseline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/geometry.h"
#include "util/formula/formula.h"

namespace carom::formula {

/// The sizes that a part of a formula may have: that of the surrounding words, of an index, or of
/// an index to an index.
enum class Size { text, script, second_script };

/// A letter or sign, as it is typeset.
struct Letter {
    std::string text;  ///< UTF-8
    bool is_slanted = false;
    auto operator<=>(const Letter&) const = default;
};

struct Metrics {
    double width = 0.0, height = 0.0, depth = 0.0;  ///< depth below the baseline, positive
    double italic = 0.0;   ///< italic correction: by how much a letter leans beyond its width
    double skew = 0.0;     ///< distance of an accent over the letter to the right of its middle
    bool is_text = false;  ///< from a font for words: no italic correction between its letters
};

/// Lengths that depend on the size of letters: \fontdimen 5, 6 and 8 to 22 of TeX's symbol fonts.
struct Lengths {
    double x_height = 0.0, quad = 0.0;
    double num1 = 0.0, num2 = 0.0, denom1 = 0.0, denom2 = 0.0;
    double sup1 = 0.0, sup2 = 0.0, sup3 = 0.0, sub1 = 0.0, sub2 = 0.0;
    double sup_drop = 0.0, sub_drop = 0.0, axis = 0.0;
};

/// Lengths that do not depend on the size: \fontdimen 8 to 13 of TeX's font of large symbols, and
/// settings of TeX.
struct CommonLengths {
    double rule = 0.04;        ///< thickness of rules
    double gap = 0.04;         ///< between a rule and its neighbours; in TeX as thick as a rule
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

    /// The kerning between two letters; none if they are not from the same font.
    virtual std::optional<double> kern(const Letter& first, const Letter& second,
                                       Size size) const = 0;

    /// A sum or an integral in a formula that stands alone.
    virtual Metrics large(const Letter& operation) const = 0;

    /// The smallest form of a bracket, or of a radical sign, whose height plus depth is at least
    /// `least`; or the largest form if none is.
    virtual Metrics bracket(const Letter& bracket, double least, Size size) const = 0;
    virtual Metrics root(double least, Size size) const = 0;

    /// An accent by its TeX name, and the height of the letters that it is made for.
    virtual Metrics accent(const std::string& name, Size size) const = 0;
    virtual double accent_base(const std::string& name, Size size) const = 0;
};

/// A letter, rule, bracket, radical sign or accent at its position.
struct Piece {
    enum class Of { letter, large, bracket, root, accent, rule };
    Of of = Of::letter;
    Letter letter = {};
    Size size = Size::text;
    Point at = {};  ///< start of its baseline
    double width = 0.0, height = 0.0, depth = 0.0;
};

struct Box {
    double width = 0.0, height = 0.0, depth = 0.0;
    std::vector<Piece> pieces = {};
};

/// Whether a formula is part of a line of words or stands alone; alone, sums and fractions are
/// larger.
enum class Standing { in_line, alone };

Box box_of(const Parts& formula, const Font& font, Standing standing);

}  // namespace carom::formula
