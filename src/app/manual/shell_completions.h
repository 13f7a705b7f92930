// Completions for bash, zsh and fish: for each a script of a few lines, which asks the program what
// may stand where the user types, `carom __complete SHELL WORD...`, and the answer.
#pragma once

#include <span>
#include <string>

namespace carom {

/// The word that the scripts give instead of a command.
constexpr const char* completing = "__complete";

/// The script for a shell: bash, zsh or fish.
std::string completion_script(const std::string& shell);

/// Prints the candidates for the last of the words SHELL WORD... as the script of that shell reads
/// them: a line for each, with its meaning where the shell shows one. Lines that begin with a colon
/// are for the script: `:after TEXT`, the candidates follow this part of the word; `:open`, more is
/// to be typed behind them; `:files`, `:scenes` or `:folders`, such files are candidates too.
/// Prints nothing, and throws nothing, where there is none or something fails.
void print_candidates(std::span<const char* const> shell_and_words) noexcept;

}  // namespace carom
