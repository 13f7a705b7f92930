#include "app/manual/candidates.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "app/figures/figure_pages.h"
#include "app/manual/scene_pages.h"
#include "panels/registry.h"
#include "runs/own_files.h"
#include "scene/reading/scene_reading.h"

namespace carom {
namespace {

struct KnownKey {
    std::string meaning;
    std::set<std::string> words;  // that its value may be
};

// By path, "film.theme"; items of lists have the number 0.
using KnownKeys = std::map<std::string, KnownKey>;

void add_words(const std::vector<Form>& forms, std::set<std::string>& words) {
    for (const Form& form : forms) {
        if (form.shape == Shape::word) words.insert(form.words.begin(), form.words.end());
        if (form.shape == Shape::flag) words.insert({"true", "false"});
    }
}

// Paths end where a section would contain itself.
void add_keys(const Section& section, const std::string& prefix, const std::set<std::string>& outer,
              KnownKeys& found) {
    if (outer.contains(section.name)) return;
    std::set<std::string> around = outer;
    around.insert(section.name);
    for (const Key& key : section.keys) {
        const std::string path = prefix + key.name;
        KnownKey& known = found[path];
        known.meaning = key.meaning;
        add_words(key.forms, known.words);
        for (const Form& form : key.forms) {
            if (form.shape == Shape::mapping) add_keys(*form.section, path + ".", around, found);
            if (form.shape != Shape::list) continue;
            for (const Form& item : form.items)
                if (item.shape == Shape::mapping)
                    add_keys(*item.section, path + ".0.", around, found);
        }
    }
}

KnownKeys keys_of_scenes() {
    KnownKeys found;
    for (const int dimension : {1, 2, 3})
        add_keys(scene_table(panel_kinds(), dimension).section(), "", {}, found);
    return found;
}

// "gas.0.count" as "gas.light.count" where "gas.light.c" is typed: items of lists by any number or
// name.
std::string with_typed_items(std::string path, const std::string& typed, const KnownKeys& keys) {
    for (std::size_t at = path.find(".0."); at != std::string::npos; at = path.find(".0.", at)) {
        const std::size_t item = ++at;
        const std::size_t end = typed.find_first_of(".=", item);
        if (end == std::string::npos || end == item || typed[end] == '=') break;
        if (typed.compare(0, item, path, 0, item) != 0) break;
        const std::string with_item = typed.substr(0, end + 1);
        const auto known = keys.lower_bound(with_item);
        if (known != keys.end() && known->first.starts_with(with_item)) break;
        path.replace(0, item + 2, with_item);
    }
    return path;
}

// "SCENE" of "SCENE...", "PAGE" of "PAGE,...", "COMMAND" of "[COMMAND]".
std::string name_of(const Option& option) {
    std::string name = word_of(option);
    if (const std::size_t dots = name.find("..."); dots != std::string::npos)
        name.erase(name[dots - 1] == ',' ? dots - 1 : dots);
    std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
    return name;
}

CompletedFiles files_called(const std::string& name) {
    if (name == "SCENE") return CompletedFiles::scenes;
    if (name == "PLAN" || name == "FOLDER" || name == "SITE") return CompletedFiles::folders;
    if (name == "FILM" || name == "PICTURE" || name == "FILE" || name == "PAGE")
        return CompletedFiles::any;
    return CompletedFiles::none;
}

template <class Words>
std::vector<Candidate> without_meaning(const Words& words) {
    std::vector<Candidate> candidates;
    for (const std::string& word : words) candidates.push_back({word});
    return candidates;
}

std::vector<Candidate> yaml_stems(const std::filesystem::path& folder) {
    std::set<std::string> stems;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".yaml") stems.insert(entry.path().stem());
    return without_meaning(stems);
}

std::vector<Candidate> names_of(const std::vector<Command>& commands) {
    std::vector<Candidate> names;
    for (const Command& command : commands) names.push_back({command.name, command.meaning});
    return names;
}

std::vector<Candidate> keys_behind(const std::string& typed, bool with_words) {
    const KnownKeys keys = keys_of_scenes();
    const std::size_t equals = typed.find('=');
    std::vector<Candidate> candidates;
    for (const auto& [known_path, key] : keys) {
        const std::string path = with_typed_items(known_path, typed, keys) + "=";
        if (equals == std::string::npos) {
            candidates.push_back({path, key.meaning});
        } else if (with_words && typed.compare(0, equals + 1, path) == 0) {
            for (const std::string& word : key.words) candidates.push_back({path + word});
        }
    }
    return candidates;
}

void add(std::vector<Candidate> more, Candidates& to) {
    std::ranges::move(more, std::back_inserter(to.words));
}

// The words that an option, or a positional word, takes by its name.
std::vector<Candidate> words_called(const std::string& name, const std::vector<Command>& commands) {
    if (name == "PAGE") return without_meaning(page_templates);
    if (name == "TEMPLATE") return yaml_stems(templates_folder() / "films");
    if (name == "STYLE") return yaml_stems(templates_folder() / "styles");
    if (name == "KIND") return without_meaning(keys_of_scenes().at("figures.0.kind").words);
    if (name == "COMMAND") {
        std::vector<Candidate> names = names_of(commands);
        names.push_back({"panel", "the panels of films and figures"});
        names.push_back({"scene", "the keys of a scene"});
        return names;
    }
    return {};
}

// What carom help shows beside commands.
std::vector<Candidate> topics_behind(const std::string& word) {
    std::vector<Candidate> topics;
    if (word == "panel")
        for (const PanelKind& kind : panel_kinds()) topics.push_back({kind.name, kind.shows});
    if (word == "scene")
        for (const SceneName& known : scene_names()) topics.push_back({known.name, known.meaning});
    return topics;
}

std::vector<Candidate> words_for(const Option& option, const Command& command,
                                 const std::vector<Command>& commands) {
    if (!option.choices.empty()) return without_meaning(option.choices);
    const std::string name = name_of(option);
    // A name of the library is as good as a file here.
    if (command.name == "new" && name == "SCENE") return yaml_stems(library_folder());
    std::vector<Candidate> words = words_called(name, commands);
    if (!words.empty() || option.key.empty()) return words;
    const KnownKeys keys = keys_of_scenes();
    const auto key = keys.find(option.key);
    return key == keys.end() ? words : without_meaning(key->second.words);
}

// Adds what may stand for the value of an option, or as a positional word, of which `typed` is
// there already.
void add_value(const Option& option, const Command& command, const std::vector<Command>& commands,
               std::string typed, Candidates& to) {
    const std::string name = name_of(option);
    to.files = files_called(name);
    if (name == "KEY.PATH=VALUE" || name == "KEY=VALUES") {
        add(keys_behind(typed, name == "KEY.PATH=VALUE"), to);
        to.is_open = typed.find('=') == std::string::npos;
    }
    std::vector<Candidate> words = words_for(option, command, commands);
    if (std::holds_alternative<CommaSeparated>(option.value)) {
        const std::string given = "," + typed.substr(0, typed.rfind(',') + 1);
        std::erase_if(words, [&](const Candidate& candidate) {
            return given.find("," + candidate.word + ",") != std::string::npos;
        });
        to.before += given.substr(1);
        to.is_open = true;
    }
    add(std::move(words), to);
}

std::vector<std::string> parted(const std::string& flags) {
    const std::size_t comma = flags.find(',');
    if (comma == std::string::npos) return {flags};
    return {flags.substr(0, comma), flags.substr(comma + 1)};
}

bool is_flag(const Option& option) { return option.name.starts_with('-'); }

// The option that takes a value behind this flag.
const Option* option_behind(const std::string& flag, const Command& command) {
    for (const Option& option : command.options)
        if (is_flag(option) && !std::holds_alternative<bool*>(option.value) &&
            std::ranges::count(parted(flags_of(option)), flag) > 0)
            return &option;
    return nullptr;
}

void add_flags(const Command& command, const std::vector<std::string>& words, Candidates& to) {
    const auto add_if_new = [&](const std::string& joined, const std::string& meaning) {
        const std::vector<std::string> flags = parted(joined);
        if (std::find_first_of(words.begin(), words.end() - 1, flags.begin(), flags.end()) ==
            words.end() - 1)
            for (const std::string& flag : flags) to.words.push_back({flag, meaning});
    };
    for (const Option& option : command.options) {
        const std::string flags = flags_of(option);
        if (std::holds_alternative<std::vector<std::string>*>(option.value) && is_flag(option)) {
            for (const std::string& flag : parted(flags))
                to.words.push_back({flag, option.meaning});
        } else if (is_flag(option)) {
            add_if_new(flags, option.meaning);
        }
    }
    add_if_new("-h,--help", "print the options and some examples");
}

// Whether the last word stands behind --set and changes: several may follow it.
bool is_behind_changes(const std::vector<std::string>& words) {
    std::size_t first = words.size() - 1;
    while (first > 1 && words[first - 1].find('=') != std::string::npos) --first;
    return first > 1 && first + 1 < words.size() && words[first - 1] == "--set";
}

}  // namespace

Candidates candidates_for(const std::vector<std::string>& words,
                          const std::vector<Command>& commands) {
    Candidates result;
    if (words.empty()) return result;
    const std::string& word = words.back();
    if (words.size() == 1 && word.starts_with('-')) {
        result.words = {{"-h", "print the commands"},
                        {"--help", "print the commands"},
                        {"--version", "print the version"}};
        return result;
    }
    if (words.size() == 1) {
        result.words = names_of(commands);
        return result;
    }
    const auto command = std::ranges::find(commands, words.front(), &Command::name);
    if (command == commands.end()) return result;
    const auto add_value_of = [&](const Option& option, const std::string& typed) {
        add_value(option, *command, commands, typed, result);
    };
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    if (const Option* option = option_behind(words[words.size() - 2], *command)) {
        add_value_of(*option, word);
    } else if (equals != std::string::npos) {
        if (const Option* of_word = option_behind(word.substr(0, equals), *command)) {
            result.before = word.substr(0, equals + 1);
            add_value_of(*of_word, word.substr(equals + 1));
        }
    } else if (word.starts_with('-')) {
        add_flags(*command, words, result);
    } else {
        if (const Option* set = option_behind("--set", *command);
            set != nullptr && is_behind_changes(words))
            add_value_of(*set, word);
        for (const Option& positional : command->options)
            if (name_of(positional) == "TOPIC")
                add(words.size() > 2 ? topics_behind(words[1]) : std::vector<Candidate>{}, result);
            else if (!is_flag(positional) && (command->name != "help" || words.size() == 2))
                add_value_of(positional, word);
    }
    return result;
}

}  // namespace carom
