#include "scene/reading/template.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/yaml/file_text.h"
#include "scene/yaml/yaml.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

bool is_plain_name(const std::string& name) {
    return name.find_first_of("/\\") == std::string::npos && !name.starts_with('.');
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (fs::directory_iterator entry{folder, ignored}, end; !ignored && entry != end;
         entry.increment(ignored))
        if (entry->path().extension() == ".yaml") names.push_back(entry->path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored) && !ignored;
}

// A link in the scene's folder may lead anywhere; what it leads to must lie in that folder.
bool stays_inside(const fs::path& file, const fs::path& folder) {
    std::error_code failed;
    const fs::path inside = fs::weakly_canonical(folder, failed);
    const fs::path target = fs::weakly_canonical(file, failed);
    return !failed && target.parent_path() == inside;
}

fs::path folder_of(const fs::path& scene) {
    return scene.parent_path().empty() ? fs::path{"."} : scene.parent_path();
}

void report_unknown(const Node& asked, const fs::path& films, Errors& errors) {
    const std::vector<std::string> names = names_in(films);
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    std::string hint = names.empty() ? "no templates in " + films.string() : "templates: " + list;
    if (const auto near = nearest_spelling(asked.text, names))
        hint = fmt::format("did you mean `{}`?", *near);
    errors.add(asked, fmt::format("there is no template {}", in_quotes(asked.text)), hint);
}

// None where it cannot be read: it is not the template that was asked for.
std::size_t panel_places(const fs::path& file) {
    Source source{file.string(), {}, Origin::template_file};
    Errors errors;
    auto text = file_text(file, source, errors);
    if (!text) return 0;
    source.text = std::move(*text);
    const auto root = read_yaml(source, errors);
    const Node* layout = root && root->is_mapping() ? find(*root, "layout") : nullptr;
    const Node* panels = layout && layout->is_mapping() ? find(*layout, "panels") : nullptr;
    return panels && panels->is_list() ? panels->items.size() : 0;
}

bool is_excluded(const std::string& key, const Node& film, const std::vector<Choice>& choices) {
    const auto is_given = [&](const std::string& name) { return find(film, name) != nullptr; };
    return std::ranges::any_of(choices, [&](const Choice& choice) {
        return std::ranges::find(choice.names, key) != choice.names.end() &&
               std::ranges::any_of(choice.names, is_given);
    });
}

}  // namespace

std::optional<TemplateFile> find_template(const Node& asked, const fs::path& scene,
                                          const fs::path& templates, Errors& errors) {
    const std::string& name = asked.text;
    const bool typed = asked.source->origin == Origin::command_line;
    if (typed && (name.find('/') != std::string::npos || name.ends_with(".yaml")))
        return TemplateFile{fs::path{name}.stem().string(), name};
    if (!is_plain_name(name)) {
        errors.add(asked, fmt::format("expected the name of a template, found {}", in_quotes(name)),
                   "a template is a file in the scene's folder or in templates/films, without "
                   "folder and extension");
        return std::nullopt;
    }
    const fs::path beside = folder_of(scene) / (name + ".yaml");
    if (is_there(beside) && !same_file(beside, scene)) {
        if (stays_inside(beside, folder_of(scene)))
            return TemplateFile{name, scene.parent_path() / (name + ".yaml")};
        errors.add(asked,
                   fmt::format("the template {} is a link that leads out of the scene's folder",
                               in_quotes(name)),
                   "copy the file into the folder");
        return std::nullopt;
    }
    const fs::path own = templates / "films" / (name + ".yaml");
    if (is_there(own)) return TemplateFile{name, own};
    report_unknown(asked, templates / "films", errors);
    return std::nullopt;
}

std::vector<std::string> templates_with_places(const fs::path& templates, std::size_t panels) {
    std::vector<std::pair<std::size_t, std::string>> found;
    for (const std::string& name : names_in(templates / "films"))
        if (const std::size_t places = panel_places(templates / "films" / (name + ".yaml"));
            places >= panels)
            found.emplace_back(places, name);
    std::ranges::sort(found);
    std::vector<std::string> names;
    for (const auto& [places, name] : found) names.push_back(name);
    return names;
}

Node lay_over(const Node& film, const Node& template_file, const std::vector<Choice>& choices) {
    Node merged = film;
    for (std::size_t i = 0; i < template_file.keys.size(); ++i) {
        const std::string& key = template_file.keys[i].text;
        if (key == "layout" || find(film, key) != nullptr || is_excluded(key, film, choices))
            continue;
        merged.keys.push_back(template_file.keys[i]);
        merged.items.push_back(template_file.items[i]);
    }
    return merged;
}

}  // namespace carom
