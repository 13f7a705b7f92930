// What to write instead of words of the command line that a command does not take.
#pragma once

#include <string>
#include <vector>

namespace carom {

/// What to write instead of a flag that the command, which has other `flags`, does not have; empty
/// if that is not known.
std::string instead_of_flag(const std::string& command, const std::string& flag,
                            const std::vector<std::string>& flags);

/// The option, with its value, that a word which is no option belongs to: "-o FILM.mp4" or "--csv
/// X.csv" for the name of a file to write, "--fps 30" for fps=30; empty if the command has none.
std::string option_of_word(const std::string& word, const std::vector<std::string>& flags);

}  // namespace carom
