// Formulae in a small subset of TeX as values: parts of a text between `$` signs, read into a tree
// that knows what each part is and nothing of how large it is drawn.
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
        group,     ///< `body`, as one
        fraction,  ///< `body` over `below`
        root,      ///< of `body`
        accent,    ///< `symbol` over `body`
        fenced,    ///< `body` between brackets that grow, `left` and `right`
        upright,   ///< `words` in upright letters: the name of a function, or plain words
        space      ///< `width`
    };
    Of of = Of::symbol;
    Class kind = Class::ordinary;
    const Symbol* symbol = nullptr;
    const Symbol* left = nullptr;  ///< null: none is drawn
    const Symbol* right = nullptr;
    Parts body = {}, below = {};
    Parts above_index = {}, below_index = {};  ///< raised, and lowered
    std::string words = {};
    double width = 0.0;  ///< eighteenths of an em

    bool has_indices() const { return !above_index.empty() || !below_index.empty(); }
};

/// What is wrong with a formula, and where.
class Error : public std::runtime_error {
  public:
    Error(std::size_t place, const std::string& message, std::string advice = {})
        : std::runtime_error(message), at(place), hint(std::move(advice)) {}
    std::size_t at;  ///< byte of what was read
    std::string hint;
};

/// Throws Error for what is not in the subset, with its place in `tex`.
Parts parsed(std::string_view tex);

/// A part of a text: plain words, or the TeX of a formula.
struct Span {
    bool is_formula = false;
    std::string text = {};
    std::size_t at = 0;  ///< byte where it begins in the whole text
};

/// A text in parts. `\$` is a dollar sign in plain words. Throws Error where a formula is not
/// closed or is empty; does not look into formulae.
std::vector<Span> spans_of(std::string_view text);

/// Plain words as a text in which they stay what they are.
std::string without_formulas(std::string_view words);

/// Whether there is a formula in a text that spans_of() takes.
bool has_formula(std::string_view text);

/// Throws the first Error of a text and its formulae, its place counted from the text's begin.
void check(std::string_view text);

/// A formula as it is read aloud in a language: "k times T over m".
std::string spoken(Language language, const Parts& formula);

/// A text with its formulae as they are read aloud.
std::string spoken_text(Language language, std::string_view text);

/// A formula in MathML, `<math>...</math>`.
std::string mathml(const Parts& formula);

}  // namespace carom::formula
