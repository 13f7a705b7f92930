// Formulae in a small subset of TeX: the parts of a text between `$` signs, parsed into a tree that
// records what each part is, but not its size in a drawing.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "util/formula/symbols.h"

namespace carom::formula {

struct Part;
using Parts = std::vector<Part>;

/// A part of a formula with its indices.
struct Part {
    enum class Of {
        symbol,    ///< one letter or sign
        group,     ///< `body`, as one part
        fraction,  ///< `body` over `below`
        root,      ///< of `body`
        accent,    ///< `symbol` over `body`
        fenced,    ///< `body` between delimiters of its height, `left` and `right`
        upright,   ///< `words` in upright letters: the name of a function, or plain words
        space      ///< blank space of `width`
    };
    Of of = Of::symbol;
    Class kind = Class::ordinary;
    const Symbol* symbol = nullptr;
    const Symbol* left = nullptr;  ///< delimiter; null: none is drawn
    const Symbol* right = nullptr;
    Parts body = {}, below = {};
    Parts above_index = {}, below_index = {};  ///< superscript and subscript
    std::string words = {};
    double width = 0.0;  ///< eighteenths of an em

    bool has_indices() const { return !above_index.empty() || !below_index.empty(); }
};

/// An error in a formula, and its place.
class Error : public std::runtime_error {
  public:
    Error(std::size_t place, const std::string& message, std::string advice = {})
        : std::runtime_error(message), at(place), hint(std::move(advice)) {}
    std::size_t at;  ///< byte offset in the text that was parsed
    std::string hint;
};

/// Parses a formula. Throws Error, with the place in `tex`, for anything outside the subset.
Parts parsed(std::string_view tex);

/// A part of a text: plain words, or the TeX of a formula.
struct Span {
    bool is_formula = false;
    std::string text = {};
    std::size_t at = 0;  ///< byte offset of its beginning in the whole text
};

/// Splits a text into plain words and formulae. `\$` is a dollar sign in plain words. Throws Error
/// if a formula is not closed or is empty; does not parse the formulae.
std::vector<Span> spans_of(std::string_view text);

/// Returns plain words escaped so that spans_of() does not read formulae into them.
std::string without_formulas(std::string_view words);

/// Returns whether a text contains a formula. The text must be valid for spans_of().
bool has_formula(std::string_view text);

/// Throws the first Error in a text and its formulae, with the place counted from the beginning of
/// the text.
void check(std::string_view text);

/// Returns how a formula is read aloud in a language: "k times T over m".
std::string spoken(Language language, const Parts& formula);

/// Returns a text with its formulae replaced by how they are read aloud.
std::string spoken_text(Language language, std::string_view text);

/// Returns a formula in MathML, `<math>...</math>`.
std::string mathml(const Parts& formula);

}  // namespace carom::formula
