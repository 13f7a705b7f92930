#include "app/manual/completion_table.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <variant>

#include "app/figures/figure_pages.h"
#include "app/own_files.h"
#include "panels/registry.h"
#include "scene/reading/scene_reading.h"

namespace carom {
namespace {

// Paths of keys, and the words that each takes.
using KeyWords = std::map<std::string, std::set<std::string>>;

void add_words(const std::vector<Form>& forms, std::set<std::string>& words) {
    for (const Form& form : forms) {
        if (form.shape == Shape::word) words.insert(form.words.begin(), form.words.end());
        if (form.shape == Shape::flag) words.insert({"true", "false"});
    }
}

// Paths end where a section would contain itself.
void add_keys(const Section& section, const std::string& prefix, const std::set<std::string>& outer,
              KeyWords& found) {
    if (outer.contains(section.name)) return;
    std::set<std::string> around = outer;
    around.insert(section.name);
    for (const Key& key : section.keys) {
        const std::string path = prefix + key.name;
        add_words(key.forms, found[path]);
        for (const Form& form : key.forms) {
            if (form.shape == Shape::mapping) add_keys(*form.section, path + ".", around, found);
            if (form.shape != Shape::list) continue;
            for (const Form& item : form.items)
                if (item.shape == Shape::mapping)
                    add_keys(*item.section, path + ".0.", around, found);
        }
    }
}

KeyWords keys_of_scenes() {
    KeyWords found;
    for (const int dimension : {1, 2})
        add_keys(scene_table(panel_kinds(), dimension).section(), "", {}, found);
    return found;
}

std::vector<std::string> yaml_stems(const std::filesystem::path& folder) {
    std::vector<std::string> stems;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".yaml") stems.push_back(entry.path().stem());
    std::ranges::sort(stems);
    return stems;
}

class Values {
  public:
    Values(const std::vector<Command>& commands, const KeyWords& keys)
        : commands_(commands), keys_(keys) {}

    CompletedValue of(const Option& option) const {
        CompletedValue value = by_name(name_of(option));
        value.with_commas = std::holds_alternative<CommaSeparated>(option.value);
        if (!option.choices.empty()) value.words = option.choices;
        if (const auto words = keys_.find(option.key); words != keys_.end() && value.words.empty())
            value.words.assign(words->second.begin(), words->second.end());
        return value;
    }

  private:
    // "SCENE" of "SCENE...", "PAGE" of "PAGE,...", "COMMAND" of "[COMMAND]".
    static std::string name_of(const Option& option) {
        std::string name = word_of(option);
        if (const std::size_t dots = name.find("..."); dots != std::string::npos)
            name.erase(name[dots - 1] == ',' ? dots - 1 : dots);
        std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
        return name;
    }

    CompletedValue by_name(const std::string& name) const {
        CompletedValue value{name};
        if (name == "SCENE") value.files = CompletedFiles::scenes;
        if (name == "PLAN" || name == "FOLDER" || name == "SITE")
            value.files = CompletedFiles::folders;
        if (name == "FILM" || name == "PICTURE" || name == "FILE" || name == "PAGE")
            value.files = CompletedFiles::any;
        if (name == "PAGE") value.words = page_templates;
        if (name == "TEMPLATE") value.words = yaml_stems(templates_folder() / "films");
        if (name == "KIND") add_all(keys_.at("figures.0.kind"), value.words);
        if (name == "COMMAND")
            for (const Command& command : commands_) value.words.push_back(command.name);
        value.key_values = name == "KEY.PATH=VALUE";
        value.keys = value.key_values || name == "KEY=VALUES";
        return value;
    }

    static void add_all(const std::set<std::string>& from, std::vector<std::string>& to) {
        to.insert(to.end(), from.begin(), from.end());
    }

    const std::vector<Command>& commands_;
    const KeyWords& keys_;
};

std::vector<std::string> parted(const std::string& flags) {
    const std::size_t comma = flags.find(',');
    if (comma == std::string::npos) return {flags};
    return {flags.substr(0, comma), flags.substr(comma + 1)};
}

CompletedCommand completed(const Command& command, const Values& values) {
    CompletedCommand result{command.name, command.meaning, {}};
    for (const Option& option : command.options) {
        CompletedValue value = values.of(option);
        // A name of the library is as good as a file here.
        if (command.name == "new" && value.name == "SCENE")
            value.words = yaml_stems(library_folder());
        if (!option.name.starts_with('-')) {
            result.words = std::move(value);
            continue;
        }
        const bool several = std::holds_alternative<std::vector<std::string>*>(option.value);
        result.options.push_back({parted(flags_of(option)), option.meaning,
                                  !std::holds_alternative<bool*>(option.value), several,
                                  std::move(value)});
    }
    result.options.push_back({{"-h", "--help"}, "print the options and some examples"});
    return result;
}

}  // namespace

CompletionTable completion_table(const std::vector<Command>& commands) {
    const KeyWords keys = keys_of_scenes();
    const Values values(commands, keys);
    CompletionTable table;
    for (const Command& command : commands) table.commands.push_back(completed(command, values));
    for (const auto& [path, words] : keys) {
        table.keys.push_back(path + "=");
        for (const std::string& word : words) table.key_values.push_back(path + "=" + word);
    }
    return table;
}

}  // namespace carom
