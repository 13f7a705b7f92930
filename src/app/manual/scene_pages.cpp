#include "app/manual/scene_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>

#include "media/formats.h"
#include "panels/registry.h"
#include "runs/own_files.h"
#include "scene/keys/key_text.h"
#include "scene/manual/sections.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/sets/set_reading.h"
#include "scene/yaml/file_text.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

/// All sections: of scenes, of film templates and of figure sets.
struct SceneLanguage {
    SectionsOfBoxes scene = sections_of_scenes(panel_kinds());
    Section film_template = template_table(panel_kinds()).section();
    Section set = set_table(panel_kinds(), figure_formats()).section();
    std::vector<SectionsOfBoxes> sections = {};

    SceneLanguage() {
        std::set<std::string> names;
        for (const SectionsOfBoxes& file :
             {scene, in_any_box(section_of(film_template, "layout")), in_any_box(set)})
            for (const SectionsOfBoxes& section : sections_within(file))
                if (names.insert(section.plane->name).second) sections.push_back(section);
    }
    SceneLanguage(const SceneLanguage&) = delete;
    SceneLanguage& operator=(const SceneLanguage&) = delete;
    SceneLanguage(SceneLanguage&&) = delete;
    SceneLanguage& operator=(SceneLanguage&&) = delete;
    ~SceneLanguage() = default;
};

// The name by which a section is asked for: the key between backticks in "an item of `gas`", or
// "wall-that-acts" of "a wall that acts".
std::string short_name(const Section& section) {
    const std::string& name = section.name;
    if (const std::size_t begin = name.find('`'); begin != std::string::npos)
        return name.substr(begin + 1, name.find('`', begin + 1) - begin - 1);
    std::string words = name;
    for (const std::string_view article : {"a ", "an ", "the "})
        if (words.starts_with(article)) {
            words.erase(0, article.size());
            break;
        }
    std::ranges::replace(words, ' ', '-');
    return words;
}

Definition definition_of(const Section& section, const Key& key) {
    std::string meaning = fmt::format("{} Values: {}.", key.meaning, forms_text(key));
    const std::string usual = default_of(section, key);
    meaning += usual == "required" ? " Required." : fmt::format(" Default: {}.", usual);
    return {key.name, std::move(meaning)};
}

std::vector<Definition> definitions_of(const Section& section,
                                       const std::vector<const Key*>& keys) {
    std::vector<Definition> definitions;
    for (const Key* key : keys) definitions.push_back(definition_of(section, *key));
    return definitions;
}

std::vector<const Key*> all_keys(const Section& section) {
    std::vector<const Key*> keys;
    for (const Key& key : section.keys) keys.push_back(&key);
    return keys;
}

void add_section(const SectionsOfBoxes& section, std::vector<ManualSection>& page) {
    const Section& plane = *section.plane;
    page.push_back({.title = capitalised(plane.name),
                    .paragraphs = choices_in_words(plane),
                    .definitions = definitions_of(plane, all_keys(plane))});
    for (const auto& [other, where] :
         {std::pair{section.wire, " on a wire"}, {section.space, " in space"}}) {
        const Otherwise found = otherwise(plane, *other);
        if (!found.any()) continue;
        ManualSection elsewhere{.title = capitalised(plane.name) + where,
                                .definitions = definitions_of(*other, found.keys)};
        if (!found.missing.empty())
            elsewhere.paragraphs = {
                fmt::format("Not there: {}.", listed(found.missing, "and", "`"))};
        page.push_back(std::move(elsewhere));
    }
}

// A key that several sections say alike, as those of panels in films and figures, stands once.
void add_key(const std::string& name, const SceneLanguage& language,
             std::vector<ManualSection>& page) {
    std::vector<std::pair<Definition, std::vector<std::string>>> found;
    for (const auto& [plane, wire, space] : language.sections)
        for (const auto& [section, where] :
             {std::pair{plane, ""}, {wire, " on a wire"}, {space, " in space"}}) {
            if (section == plane && *where != '\0') continue;
            const std::size_t index = section->index(name);
            if (index == section->keys.size()) continue;
            const Definition said = definition_of(*section, section->keys[index]);
            const auto same = std::ranges::find_if(
                found, [&](const auto& one) { return one.first.meaning == said.meaning; });
            const std::string place = section->name + where;
            if (same == found.end())
                found.push_back({said, {place}});
            else if (section == plane)
                same->second.push_back(place);
        }
    for (auto& [said, places] : found)
        page.push_back({.title = fmt::format("{}, of {}", name, listed(places)),
                        .paragraphs = {std::move(said.meaning)}});
}

// Follows a path, "film.slow.factor" or "gas.0.count"; false where it leads nowhere.
bool add_path(const std::string& path, const SceneLanguage& language,
              std::vector<ManualSection>& page) {
    const auto is_number = [](const std::string& word) {
        return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    };
    const auto& [plane, wire, space] = language.scene;
    std::vector<const Section*> inside{plane, wire, space};
    std::istringstream words(path);
    Definition last;
    for (std::string word; std::getline(words, word, '.');) {
        if (is_number(word)) continue;
        std::vector<const Section*> deeper;
        last = {};
        for (const Section* section : inside) {
            const std::size_t index = section->index(word);
            if (index == section->keys.size()) continue;
            const Key& key = section->keys[index];
            if (last.term.empty()) last = definition_of(*section, key);
            std::ranges::copy(sections_in(key.forms), std::back_inserter(deeper));
        }
        if (last.term.empty()) return false;
        inside = std::move(deeper);
    }
    if (last.term.empty()) return false;
    page.push_back({.title = path, .paragraphs = {last.meaning}});
    std::set<std::string> shown;
    for (const SectionsOfBoxes& section : language.sections)
        for (const Section* one : inside)
            if (section.plane->name == one->name && shown.insert(one->name).second)
                add_section(section, page);
    return true;
}

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (const PanelKind& kind : panel_kinds()) names.push_back(kind.name);
    return names;
}

std::vector<std::string> section_names(const SceneLanguage& language) {
    std::vector<std::string> names;
    for (const SectionsOfBoxes& section : language.sections)
        if (const std::string name = short_name(*section.plane);
            std::ranges::find(names, name) == names.end())
            names.push_back(name);
    return names;
}

// The lines of a file of the manual; none where it is not installed.
std::vector<std::string> lines_of_manual(const std::string& file) {
    const Source source{.name = file};
    Errors unread;
    std::istringstream text(file_text(manual_folder() / file, source, unread).value_or(""));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

// "Figures (figures.md)" instead of "[Figures](figures.md#sweeps)".
std::string without_links(std::string text) {
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](")) {
        const std::size_t end = text.find(')', at), address = at + 2;
        const std::string page = text.substr(address, text.find_first_of("#)", at) - address);
        text.replace(at, end + 1 - at, " (" + page + ")");
        text.erase(text.rfind('[', at), 1);
    }
    return text;
}

// The keys of a figure of a kind that a panel of this kind in a film has not, or has otherwise.
std::vector<const Key*> further_keys(const Section& figure, const Section& panel,
                                     const std::string& kind) {
    std::vector<const Key*> further;
    for (const Key& key : figure.keys) {
        const bool takes = std::ranges::find(key.kinds, kind) != key.kinds.end();
        const std::size_t index = panel.index(key.name);
        const bool is_same = index < panel.keys.size() && panel.keys[index].meaning == key.meaning;
        if (takes && !is_same) further.push_back(&key);
    }
    return further;
}

}  // namespace

ManualPage page_of_panels() {
    ManualSection kinds{.title = "Kinds", .long_terms = true};
    for (const PanelKind& kind : panel_kinds())
        kinds.definitions.push_back({kind.name, without_links(kind.shows)});
    return {"carom panels",
            "what films show beside the gas, and figures show",
            {std::move(kinds), {.title = "More", .calls = {"carom help panel KIND"}}}};
}

ManualPage page_of_panel(const std::string& name) {
    const PanelKind* kind = kind_of(panel_kinds(), name);
    if (kind == nullptr)
        throw UsageError(
            fmt::format("there is no panel `{}`; {}", name,
                        spelling_hint(name, kind_names(), "carom help panel lists them")));
    const Section &panel = panel_section(panel_kinds()), &figure = figure_section(panel_kinds());
    const bool in_films = kind->in_films_instead.empty();
    ManualPage page{"carom panel " + name,
                    in_films ? "a panel of films and figures" : "a kind of figure",
                    {{.title = "Description", .paragraphs = {without_links(kind->shows)}}}};
    if (const std::vector<std::string> scene = lines_of_manual("docs/panels/" + name + ".yaml");
        !scene.empty())
        page.sections.push_back({.title = "Example", .calls = scene});
    const KeysOfKind keys = keys_of_kind(panel, name);
    std::vector<const Key*> all = keys.own;
    all.insert(all.end(), keys.shared.begin(), keys.shared.end());
    if (in_films && !all.empty())
        page.sections.push_back(
            {.title = "Keys in films and figures", .definitions = definitions_of(panel, all)});
    std::vector<const Key*> of_figures;
    for (const Key& key : figure.keys)
        if (std::ranges::find(key.kinds, name) != key.kinds.end()) of_figures.push_back(&key);
    if (in_films) of_figures = further_keys(figure, panel, name);
    if (!of_figures.empty())
        page.sections.push_back(
            {.title = "Keys in figures", .definitions = definitions_of(figure, of_figures)});
    page.sections.push_back({.title = "More",
                             .calls = {"carom help scene panel    keys of all panels in films",
                                       "carom help scene figure   keys of all figures"}});
    return page;
}

ManualPage page_of_scene() {
    const SceneLanguage language;
    ManualPage page{"carom scene", "what a scene file says", {}};
    add_section(language.scene, page.sections);
    page.sections.push_back(
        {.title = "Sections", .paragraphs = {listed(section_names(language)) + "."}});
    page.sections.push_back(
        {.title = "More",
         .calls = {"carom help scene SECTION   the keys of a section",
                   "carom help scene KEY       a key, wherever it stands, or its path: run.until",
                   "carom help panel KIND      a panel with its keys"}});
    return page;
}

ManualPage page_of_scene(const std::string& name) {
    const SceneLanguage language;
    ManualPage page{"carom scene " + name, "what it means in a scene", {}};
    const bool is_path = name.find('.') != std::string::npos;
    if (is_path && add_path(name, language, page.sections)) return page;
    add_key(name, language, page.sections);
    for (const SectionsOfBoxes& section : language.sections)
        if (short_name(*section.plane) == name) add_section(section, page.sections);
    if (!page.sections.empty()) return page;
    std::vector<std::string> names;
    for (const SceneName& known : scene_names()) names.push_back(known.name);
    const std::string kinds = kind_of(panel_kinds(), name) != nullptr
                                  ? fmt::format("write carom help panel {}", name)
                                  : spelling_hint(name, names, "carom help scene lists them");
    throw UsageError(fmt::format("scenes have no section and no key `{}`; {}", name, kinds));
}

std::vector<SceneName> scene_names() {
    const SceneLanguage language;
    std::vector<SceneName> names;
    std::set<std::string> seen;
    const auto add = [&](const std::string& name, const std::string& meaning) {
        if (seen.insert(name).second) names.push_back({name, meaning});
    };
    for (const SectionsOfBoxes& one : language.sections)
        add(short_name(*one.plane), one.plane->name);
    for (const auto& [plane, wire, space] : language.sections)
        for (const Section* section : {plane, wire, space})
            for (const Key& key : section->keys) add(key.name, key.meaning);
    return names;
}

}  // namespace carom
