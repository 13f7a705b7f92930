// The symbols of formulae: the TeX name of each, its character, its class for spacing, and how it
// is read aloud.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "util/language.h"

namespace carom::formula {

/// The class of a symbol or a part, which determines the space around it (TeXbook, chapter 17).
enum class Class { ordinary, operation, binary, relation, opening, closing, punctuation, inner };

struct Symbol {
    std::string tex;     ///< a character, or a command without its backslash
    std::string letter;  ///< in UTF-8
    Class kind = Class::ordinary;
    bool is_slanted = false;  ///< as Latin and small Greek letters are
    Phrase spoken = {};  ///< how it is read aloud; empty: as its letter, or nothing for a bracket
};

/// Returns the symbol of a character (UTF-8), or null.
const Symbol* symbol_of_letter(std::string_view letter);

/// Returns the symbol of a command, given without its backslash, or null.
const Symbol* symbol_of_command(std::string_view name);

/// Returns an accent over a part: bar, hat, vec, dot; null for other commands.
const Symbol* accent_of_command(std::string_view name);

/// Returns a delimiter that may follow \left and \right, given as a character or a command without
/// its backslash; null for others.
const Symbol* bracket_of(std::string_view name);

/// Returns how a named function, such as ln, is read aloud; empty if there is no such function.
Phrase spoken_function(std::string_view name);

/// Returns all commands that a formula may contain, for hints.
const std::vector<std::string>& commands();

}  // namespace carom::formula
