#include "app/manual/shell_completions.h"

#include <cstdio>
#include <vector>

#include "app/manual/candidates.h"

namespace carom {
namespace {

// Readline splits words at `=`, so that candidates lose what stands before it.
constexpr const char* bash_script =
    R"SH(# Completions of carom for bash, made by `carom completions bash`.
_carom() {
    local line=${COMP_LINE:0:COMP_POINT} program=${1:-carom} words word before= i
    COMPREPLY=()
    read -ra words <<<"$line"
    [[ $line == *[[:space:]] ]] && words+=("")
    word=${words[${#words[@]} - 1]}
    while IFS= read -r line; do
        case $line in
            :after\ *) before=${line#:after } ;;
            :open) compopt -o nospace 2>/dev/null ;;
            :files) _carom_files -f ;;
            :scenes) _carom_files -f -X '!*.yaml'; _carom_files -f -X '!*.yml'; _carom_files -d ;;
            :folders) _carom_files -d ;;
            *) COMPREPLY+=("$before$line") ;;
        esac
    done < <("${program/#~\//$HOME/}" __complete bash "${words[@]:1}" 2>/dev/null)
    [[ $word == *=* && $COMP_WORDBREAKS == *=* ]] || return 0
    for i in "${!COMPREPLY[@]}"; do COMPREPLY[i]=${COMPREPLY[i]#"${word%"${word##*=}"}"}; done
}
_carom_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen "$@" -- "${word#"$before"}")
}
complete -o default -F _carom carom
)SH";

constexpr const char* zsh_script = R"SH(#compdef carom
# Completions of carom for zsh, made by `carom completions zsh`.
_carom() {
    local line failed=1
    local -a candidates space files
    for line in ${(f)"$(${~words[1]} __complete zsh "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)"}; do
        case $line in
            ':after '*) compset -P "${(b)line#:after }" ;;
            :open) space=(-S '') ;;
            :files) files=(_files) ;;
            :scenes) files=(_files -g '*.(yaml|yml)(-.)') ;;
            :folders) files=(_files -/) ;;
            *) candidates+=("$line") ;;
        esac
    done
    (($#candidates)) && _describe -t words candidate candidates $space && failed=0
    (($#files)) && $files && failed=0
    return failed
}
_carom "$@"
)SH";

constexpr const char* fish_script =
    R"SH(# Completions of carom for fish, made by `carom completions fish`.
function __carom_complete
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l before ''
    set -l program (string replace -r '^~(?=/)' -- $HOME $words[1])
    for line in ($program __complete fish $words[2..] "$word" 2>/dev/null)
        set -l files '.*'
        switch $line
            case ':after *'
                set before (string replace ':after ' '' -- $line)
                continue
            case :open
                continue
            case :files
            case :scenes
                set files '.*(?:\.ya?ml|/)'
            case :folders
                set files '.*/'
            case '*'
                echo $before$line
                continue
        end
        complete -C "__carom_no_command "(string replace -- "$before" '' $word) |
            string match -r "^$files(?:\t.*)?\$" | string replace -r '^' -- $before
    end
end
complete -c carom -f -k -a '(__carom_complete)'
)SH";

// As _describe wants it.
std::string without_colons(const std::string& text) {
    std::string plain;
    for (const char letter : text) {
        if (letter == ':' || letter == '\\') plain += '\\';
        plain += letter;
    }
    return plain;
}

std::string line_of(const Candidate& candidate, const std::string& shell) {
    const auto& [word, meaning] = candidate;
    if (shell == "fish") return word + "\t" + meaning;
    if (shell == "bash") return word;
    return without_colons(word) + (meaning.empty() ? "" : ":" + without_colons(meaning));
}

std::string answer(const std::string& shell, const std::vector<std::string>& words) {
    const Candidates candidates = candidates_for(words, all_commands());
    // Of the three, bash alone does not match by itself.
    const std::string begun =
        shell == "bash" ? words.back().substr(candidates.before.size()) : std::string();
    std::string lines, marks;
    for (const Candidate& candidate : candidates.words)
        if (candidate.word.starts_with(begun)) lines += line_of(candidate, shell) + "\n";
    if (!candidates.before.empty()) marks += ":after " + candidates.before + "\n";
    if (candidates.is_open && !lines.empty()) marks += ":open\n";
    switch (candidates.files) {
        case CompletedFiles::none:
            break;
        case CompletedFiles::any:
            lines += ":files\n";
            break;
        case CompletedFiles::scenes:
            lines += ":scenes\n";
            break;
        case CompletedFiles::folders:
            lines += ":folders\n";
            break;
    }
    return marks + lines;
}

}  // namespace

std::string completion_script(const std::string& shell) {
    return shell == "bash" ? bash_script : shell == "zsh" ? zsh_script : fish_script;
}

void print_candidates(std::span<const char* const> shell_and_words) noexcept {
    try {
        if (shell_and_words.size() < 2) return;
        const std::string lines =
            answer(shell_and_words.front(), {shell_and_words.begin() + 1, shell_and_words.end()});
        std::fputs(lines.c_str(), stdout);
        std::fflush(stdout);
    } catch (...) {  // a shell that completes has no place for a message
    }
}

}  // namespace carom
