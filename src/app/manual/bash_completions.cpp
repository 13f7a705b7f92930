#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/shell_completions.h"

namespace carom {
namespace {

// Readline splits words at `=`, so that candidates lose what stands before it.
constexpr const char* bash_functions = R"SH(
# Candidates from a list of words.
_carom_words() { mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$value"); }

# Keys, or behind `=` the words that they take; items of lists by any number or name.
_carom_keys() {
    local list=$1 name
    [[ $value == *=* ]] && list=$2
    for name in '[a-z_]+' '[a-z_]+\.[a-z_]+'; do
        if [[ $value =~ ^($name)\.[^.=]+\. && " $list" != *" ${BASH_REMATCH[0]}"* ]]; then
            list=${list//"${BASH_REMATCH[1]}.0."/"${BASH_REMATCH[0]}"}
        fi
    done
    _carom_words "$list"
    [[ $value == *=* ]] || compopt -o nospace 2>/dev/null
}

# The last of several words between commas.
_carom_comma_words() {
    local before=
    [[ $value == *,* ]] && before=${value%,*},
    _carom_words "${1//@/$before}"
    compopt -o nospace 2>/dev/null
}

_carom_scenes() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X '!*.@(yaml|yml)' -- "$value"; compgen -d -- "$value")
}
_carom_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$value")
}
_carom_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$value")
}

_carom() {
    local line=${COMP_LINE:0:COMP_POINT} words flag= value i extended
    COMPREPLY=()
    read -ra words <<<"$line"
    [[ $line == *[[:space:]] ]] && words+=("")
    local last=$((${#words[@]} - 1))
    value=${words[last]}
    extended=$(shopt -p extglob)
    shopt -s extglob
    if ((last > 1)); then
        flag=${words[last - 1]}
        # Several values may follow one --set.
        for ((i = last - 1; i > 1; --i)); do
            [[ ${words[i]} == --set ]] && flag=--set
            [[ ${words[i]} == *=* ]] || break
        done
        if [[ $value == --*=* ]]; then
            flag=${value%%=*}
            value=${value#*=}
        fi
    fi
    _carom_candidates "$last" "${words[1]}" "$flag"
    if [[ ${words[last]} == *=* && $COMP_WORDBREAKS == *=* ]]; then
        COMPREPLY=("${COMPREPLY[@]#"${value%"${value##*=}"}"}")
    fi
    eval "$extended"
}
complete -o default -F _carom carom
)SH";

std::string words_in(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

std::string candidates_of(const CompletedValue& value) {
    std::string calls;
    if (value.files == CompletedFiles::scenes) calls += " _carom_scenes;";
    if (value.files == CompletedFiles::folders) calls += " _carom_folders;";
    if (value.files == CompletedFiles::any) calls += " _carom_files;";
    if (value.keys)
        calls += fmt::format(" _carom_keys \"$keys\" {};",
                             value.key_values ? "\"$key_values\"" : "\"\"");
    if (value.words.empty()) return calls.empty() ? " :;" : calls;
    if (!value.with_commas)
        return calls + fmt::format(" _carom_words '{}';", words_in(value.words));
    return calls + fmt::format(" _carom_comma_words '@{}';", fmt::join(value.words, " @"));
}

std::string case_of(const CompletedCommand& command) {
    std::string text = fmt::format("        {})\n            case $3 in\n", command.name), flags;
    for (const CompletedOption& option : command.options) {
        flags += (flags.empty() ? "" : " ") + words_in(option.flags);
        if (!option.takes_value) continue;
        text += fmt::format("                {}){} return ;;\n", fmt::join(option.flags, " | "),
                            candidates_of(option.value));
    }
    return text + fmt::format(
                      "            esac\n            if [[ $value == -* ]]; then\n"
                      "                _carom_words '{}'\n            else\n"
                      "               {}\n            fi ;;\n",
                      flags, candidates_of(command.words));
}

}  // namespace

std::string bash_completions(const CompletionTable& table) {
    std::string names, cases;
    for (const CompletedCommand& command : table.commands) {
        names += (names.empty() ? "" : " ") + command.name;
        cases += case_of(command);
    }
    return fmt::format(
        "# Completions of carom for bash, made by `carom completions bash`.\n{}\n"
        "# _carom_candidates PLACE COMMAND FLAG: of $value\n_carom_candidates() {{\n"
        "    local keys='{}'\n    local key_values='{}'\n"
        "    if (($1 < 2)); then\n        _carom_words '{} --help --version'\n        return\n"
        "    fi\n    case $2 in\n{}    esac\n}}\n",
        bash_functions, words_in(table.keys), words_in(table.key_values), names, cases);
}

}  // namespace carom
