// The symbols of formulae: how TeX names each, the letter that stands for it, what it is in a
// formula, and how it is read aloud.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "util/language.h"

namespace carom::formula {

/// What a symbol or a part is for the space around it (TeXbook, chapter 17).
enum class Class { ordinary, operation, binary, relation, opening, closing, punctuation, inner };

struct Symbol {
    std::string tex;     ///< a character, or a command without its backslash
    std::string letter;  ///< in UTF-8
    Class kind = Class::ordinary;
    bool is_slanted = false;  ///< as Latin and small Greek letters are
    Phrase spoken = {};  ///< how it is read aloud; empty: as its letter, or nothing for a bracket
};

/// The symbol of a character (UTF-8), or null.
const Symbol* symbol_of_letter(std::string_view letter);

/// The symbol of a command, without its backslash, or null.
const Symbol* symbol_of_command(std::string_view name);

/// An accent over a part: bar, hat, vec, dot; null if it is none.
const Symbol* accent_of_command(std::string_view name);

/// What may stand after \left and \right, by the character or the command without its backslash,
/// or null.
const Symbol* bracket_of(std::string_view name);

/// What a function with a name of its own, such as ln, is called; empty if there is none.
Phrase spoken_function(std::string_view name);

/// All commands that a formula may have, for hints.
const std::vector<std::string>& commands();

}  // namespace carom::formula
