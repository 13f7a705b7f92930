#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/shell_completions.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr const char* fish_functions = R"SH(
# Is this the command that stands behind carom?
function __carom_is
    set -l words (commandline -opc)
    test (count $words) -gt 1; and test "$words[2]" = "$argv[1]"
end
function __carom_no_command
    test (count (commandline -opc)) -eq 1
end

function __carom_scenes
    string match -q '*=*' -- (commandline -ct); and return
    __fish_complete_suffix .yaml | string match -r '^[^\t]*(?:\.ya?ml|/)(?:\t.*)?$'
end

# Several words between commas.
function __carom_comma_words
    set -l before (commandline -ct | string replace -r '[^,]*$' '')
    printf '%s\n' "$before"$argv
end

# Keys, or behind `=` the words that they take; items of lists by any number or name.
function __carom_keys
    set -l word (commandline -ct | string replace -r '^--[a-z]+=' '')
    set -l list $__carom_keys
    string match -q '*=*' -- $word; and test "$argv[1]" = values; and set list $__carom_key_values
    for list_name in '[a-z_]+' '[a-z_]+\.[a-z_]+'
        set -l item (string match -r "^($list_name)\\.[^.=]+\\." -- $word)
        if test (count $item) -eq 2; and not string match -q -- "$item[1]*" $list
            set list (string replace -- "$item[2].0." $item[1] $list)
        end
    end
    printf '%s\n' $list
end

# After --set several values may follow.
function __carom_in_changes
    set -l words (commandline -opc)
    while test (count $words) -gt 2; and string match -q '*=*' -- $words[-1]
        set -e words[-1]
        test "$words[-1]" = --set; and return 0
    end
    return 1
end
)SH";

std::string quoted_for_fish(const std::string& text) {
    std::string quoted = "'";
    for (const char letter : text) {
        if (letter == '\'' || letter == '\\') quoted += '\\';
        quoted += letter;
    }
    return quoted + "'";
}

// The options of `complete` that give the candidates.
std::string fish_candidates(const CompletedValue& value) {
    std::vector<std::string> lists;
    if (value.files == CompletedFiles::scenes) lists.push_back("(__carom_scenes)");
    if (value.files == CompletedFiles::folders) lists.push_back("(__fish_complete_directories)");
    if (value.keys) lists.push_back(value.key_values ? "(__carom_keys values)" : "(__carom_keys)");
    if (!value.words.empty() && value.with_commas)
        lists.push_back(fmt::format("(__carom_comma_words {})", fmt::join(value.words, " ")));
    else
        lists.insert(lists.end(), value.words.begin(), value.words.end());
    const std::string files = value.files == CompletedFiles::any ? " -F" : "";
    return lists.empty() ? files : fmt::format("{} -ka '{}'", files, fmt::join(lists, " "));
}

std::string option_line(const std::string& command, const CompletedOption& option) {
    std::string line = fmt::format("complete -c carom -n '__carom_is {}'", command);
    for (const std::string& flag : option.flags)
        line += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
    const bool has_files = option.value.files == CompletedFiles::any;
    if (option.takes_value) line += fish_candidates(option.value) + (has_files ? " -r" : " -x");
    return line + " -d " + quoted_for_fish(option.meaning) + "\n";
}

std::string command_lines(const CompletedCommand& command) {
    std::string lines = fmt::format("\ncomplete -c carom -n __carom_no_command -a {} -d {}\n",
                                    command.name, quoted_for_fish(command.meaning));
    if (const std::string candidates = fish_candidates(command.words); !candidates.empty())
        lines += fmt::format("complete -c carom -n '__carom_is {}'{}\n", command.name, candidates);
    for (const CompletedOption& option : command.options) {
        lines += option_line(command.name, option);
        if (option.value.key_values)
            lines += fmt::format(
                "complete -c carom -n '__carom_is {}; and __carom_in_changes' -a '(__carom_keys "
                "values)'\n",
                command.name);
    }
    return lines;
}

}  // namespace

std::string fish_completions(const CompletionTable& table) {
    std::string text = fmt::format(
        "# Completions of carom for fish, made by `carom completions fish`.\n{}\n"
        "set -g __carom_keys {}\nset -g __carom_key_values {}\n\n"
        "complete -c carom -f\n"
        "complete -c carom -n __carom_no_command -s h -l help -d 'print the commands'\n"
        "complete -c carom -n __carom_no_command -l version -d 'print the version'\n",
        fish_functions, fmt::join(table.keys, " "), fmt::join(table.key_values, " "));
    for (const CompletedCommand& command : table.commands) text += command_lines(command);
    return text;
}

}  // namespace carom
