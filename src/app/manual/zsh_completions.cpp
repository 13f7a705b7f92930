#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/shell_completions.h"

namespace carom {
namespace {

constexpr const char* zsh_functions = R"SH(
# Keys, or behind `=` the words that they take; items of lists by any number or name.
_carom_keys() {
    local -a list match
    local word=$PREFIX name MATCH
    list=($carom_keys)
    [[ $1 == values && $word == *=* ]] && list=($carom_key_values)
    for name in '[a-z_]+' '[a-z_]+\.[a-z_]+'; do
        if [[ $word =~ "^($name)\\.[^.=]+\\." && -z ${(M)list:#$MATCH*} ]]; then
            list=(${list/#$match[1].0./$MATCH})
        fi
    done
    if [[ $word == *=* ]]; then compadd -- $list; else compadd -S '' -- $list; fi
}

# Of words behind several values of --set: changes or files.
_carom_behind_set() {
    local i
    for ((i = CURRENT - 1; i > 1; --i)); do
        [[ $words[i] == --set ]] && { _carom_keys values; return }
        [[ $words[i] == *=* ]] || return 1
    done
    return 1
}
_carom_scenes() { _carom_behind_set; _files -g '*.(yaml|yml)(-.)' }
)SH";

std::string quoted_for_zsh(const std::string& text) {
    std::string quoted = "'";
    for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
    return quoted + "'";
}

// As _arguments and _describe want it.
std::string without_syntax(const std::string& text) {
    std::string plain;
    for (const char letter : text) {
        if (letter == ':' || letter == '[' || letter == ']' || letter == '\\') plain += '\\';
        plain += letter;
    }
    return plain;
}

// ":FILM:_files".
std::string zsh_action(const CompletedValue& value) {
    std::string action;
    const auto add = [&](const std::string& one) { action += (action.empty() ? "" : "; ") + one; };
    if (value.files == CompletedFiles::scenes) add("_carom_scenes");
    if (value.files == CompletedFiles::folders) add("_files -/");
    if (value.files == CompletedFiles::any) add("_files");
    if (value.keys) add(value.key_values ? "_carom_keys values" : "_carom_keys");
    if (!value.words.empty())
        add(fmt::format("{} {}", value.with_commas ? "_values -s , word" : "compadd --",
                        fmt::join(value.words, " ")));
    return fmt::format(":{}:{{{}}}", without_syntax(value.name), action.empty() ? ":" : action);
}

std::string zsh_option(const CompletedOption& option) {
    std::string text;
    const std::string rest = "[" + without_syntax(option.meaning) + "]" +
                             (option.takes_value ? zsh_action(option.value) : "");
    const std::string others = fmt::format("{}", fmt::join(option.flags, " "));
    for (const std::string& flag : option.flags) {
        const bool takes_equals = option.takes_value && flag.starts_with("--");
        text += " \\\n            " + quoted_for_zsh((option.repeated ? "*" : "(" + others + ")") +
                                                     flag + (takes_equals ? "=" : "") + rest);
    }
    return text;
}

std::string zsh_case(const CompletedCommand& command) {
    std::string text = fmt::format("        {}) _arguments", command.name);
    for (const CompletedOption& option : command.options) text += zsh_option(option);
    return text + " \\\n            " + quoted_for_zsh("*" + zsh_action(command.words)) + " ;;\n";
}

}  // namespace

std::string zsh_completions(const CompletionTable& table) {
    std::string names, cases;
    for (const CompletedCommand& command : table.commands) {
        names += "        " + quoted_for_zsh(command.name + ":" + without_syntax(command.meaning)) +
                 "\n";
        cases += zsh_case(command);
    }
    return fmt::format(
        "#compdef carom\n# Completions of carom for zsh, made by `carom completions zsh`.\n"
        "typeset -ga carom_keys carom_key_values\ncarom_keys=({})\ncarom_key_values=({})\n{}\n"
        "_carom() {{\n    local curcontext=$curcontext state line\n    local -a commands\n"
        "    typeset -A opt_args\n    commands=(\n{}    )\n"
        "    _arguments -C '(- *)'{{-h,--help}}'[print the commands]' "
        "'(- *)--version[print the version]' '1:command:->command' '*::words:->words'\n"
        "    case $state in\n"
        "        command) _describe -t commands command commands; return ;;\n"
        "        words) ;;\n        *) return ;;\n    esac\n"
        "    case $words[1] in\n{}    esac\n}}\n_carom \"$@\"\n",
        fmt::join(table.keys, " "), fmt::join(table.key_values, " "), zsh_functions, names, cases);
}

}  // namespace carom
