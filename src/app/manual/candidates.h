// What may stand where a command line of carom is being typed, as a value: from the table of
// commands and the keys of the scene language. shell_completions.h writes it for each shell.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace carom {

/// The kind of files that complete a word.
enum class CompletedFiles { none, any, scenes, folders };

struct Candidate {
    std::string word;
    std::string meaning = {};
};

/// The candidates for the last word of a command line.
struct Candidates {
    std::string before = {};  ///< what of the word stands before each of them: "--format=", "svg,"
    std::vector<Candidate> words = {};
    CompletedFiles files = CompletedFiles::none;  ///< which files are candidates as well
    bool is_open = false;  ///< a word is only the beginning of what is meant: "film.theme="
};

/// Gives the candidates for the last of `words`, which are those behind `carom`; where nothing is
/// known, none. Some may begin otherwise than what is typed: shells know several ways to match.
/// Templates and scenes are those that come with this program; throws SystemError when they cannot
/// be found.
Candidates candidates_for(const std::vector<std::string>& words,
                          const std::vector<Command>& commands);

}  // namespace carom
