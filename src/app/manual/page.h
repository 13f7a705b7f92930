// The manual as values: a page for each command and one for the program, made from the table of
// commands. text_of (page_text.h) and roff_of (roff.h) convert them to text and to roff.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace carom {

/// A term and what it means.
struct Definition {
    std::string term, meaning;
};

/// A heading and its contents: command lines, then paragraphs, then definitions.
struct ManualSection {
    std::string title;
    std::vector<std::string> calls = {}, paragraphs = {};
    std::vector<Definition> definitions = {};
    bool long_terms = false;  ///< each term is on a line of its own
};

struct ManualPage {
    std::string name;     ///< "carom", "carom-render"
    std::string summary;  ///< a few words
    std::vector<ManualSection> sections;
};

/// The page of a command.
ManualPage page_of(const Command& command);

/// The page of the program.
ManualPage page_of(const std::vector<Command>& commands);

/// What --help shows of a command: calls, options and examples.
ManualPage help_of(const Command& command);

/// What --help shows of the program: its commands.
ManualPage help_of(const std::vector<Command>& commands);

}  // namespace carom
