// What to write instead of words of the command line that a command does not take.
#pragma once

#include <string>
#include <vector>

namespace carom {

/// What to write instead of a flag that the command, which has other `flags`, does not have; empty
/// if that is not known.
std::string instead_of_flag(const std::string& command, const std::string& flag,
                            const std::vector<std::string>& flags);

/// The option, with its value, that writes a file of this name: "-o FILM.mp4", "--csv X.csv"; empty
/// if the command has none.
std::string option_of_file(const std::string& word, const std::vector<std::string>& flags);

}  // namespace carom
