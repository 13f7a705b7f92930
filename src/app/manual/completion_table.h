// What a shell can complete in a command line of carom, as a value: made from the table of commands
// and from the keys of the scene language. shell_completions.h writes the scripts for each shell.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace carom {

/// The kind of files that complete a word.
enum class CompletedFiles { none, any, scenes, folders };

/// The candidates for the value of an option, or for a positional word.
struct CompletedValue {
    std::string name;  ///< as the help calls it
    CompletedFiles files = CompletedFiles::none;
    std::vector<std::string> words = {};
    bool with_commas = false;  ///< several of the words, separated by commas
    bool keys = false;         ///< a key of the scene and `=`
    bool key_values = false;   ///< and, after the `=`, the words that the key takes
};

struct CompletedOption {
    std::vector<std::string> flags;  ///< "-o", "--output"
    std::string meaning;
    bool takes_value = false, repeated = false;
    CompletedValue value = {};
};

struct CompletedCommand {
    std::string name, meaning;
    std::vector<CompletedOption> options;
    CompletedValue words = {};  ///< candidates for its positional words
};

struct CompletionTable {
    std::vector<CompletedCommand> commands;
    std::vector<std::string> keys;        ///< "film.theme="; items of lists have the number 0
    std::vector<std::string> key_values;  ///< "film.theme=dark", of keys that take words
};

/// Templates and scenes are those that come with this program. Throws SystemError when they cannot
/// be found.
CompletionTable completion_table(const std::vector<Command>& commands);

}  // namespace carom
