#include "scene/reading/set_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/keys/check.h"
#include "scene/keys/fields.h"
#include "scene/reading/figure_reading.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/yaml.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::array page_names{"markdown", "html", "latex"};

std::optional<Node> tree_of(const fs::path& path, Source& source, Errors& errors) {
    source.name = path.string();
    auto text = file_text(path, source, errors);
    if (!text) return std::nullopt;
    source.text = std::move(*text);
    return read_yaml(source, errors);
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool is_inside(const fs::path& file, const fs::path& folder) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end == folder.end() && rest != file.end();
}

// Of a scene that is not there: the one beside its place that is meant.
std::string hint_of_missing(const fs::path& path) {
    std::vector<std::string> names;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder_of(path), failed))
        names.push_back(entry.path().filename().string());
    const auto meant = nearest_spelling(path.filename().string(), names);
    return meant ? fmt::format("did you mean `{}`?", *meant) : "paths are relative to the set";
}

void check_is_there(const Node& written, const fs::path& path, Errors& errors) {
    std::error_code failed;
    const bool is_there = fs::exists(path, failed);
    if (is_there && !fs::is_directory(path, failed)) return;
    errors.add(written,
               fmt::format("the scene {} {}", in_quotes(written.text),
                           is_there ? "is a folder" : "is not there"),
               is_there ? "" : hint_of_missing(path));
}

// A set and its scenes may be moved together, and lead nowhere else.
fs::path scene_path(const Node& written, const fs::path& set, Errors& errors) {
    const fs::path path = folder_of(set) / written.text;
    std::error_code failed;
    const fs::path above = fs::weakly_canonical(folder_of(set) / "..", failed);
    if (fs::path(written.text).is_absolute() ||
        !is_inside(fs::weakly_canonical(path, failed), above) || failed)
        errors.add(written,
                   fmt::format("the scene {} is neither in the set's folder nor in the one above",
                               in_quotes(written.text)),
                   "give its path from the set: ../one-hot-particle.yaml");
    else if (written.valid && !written.text.empty())
        check_is_there(written, path, errors);
    return path.lexically_normal();
}

SetScene read_scene(const Node& item, const fs::path& set, Errors& errors) {
    SetScene scene;
    scene.place = place_of(item);
    if (item.is_scalar()) {
        scene.path = scene_path(item, set, errors);
        return scene;
    }
    const Section& section = section_of(set_section(), "scenes");
    const Fields fields{item, section};
    if (const Node* path = fields.given("scene")) {
        scene.path = scene_path(*path, set, errors);
        scene.place = place_of(*path);
    }
    scene.title = fields.text("title");
    scene.description = fields.text("description");
    if (const Node* figures = fields.given("figures"))
        for (const Node& name : figures->items)
            scene.figures.emplace_back(name.text, place_of(name));
    return scene;
}

SetRun read_run(const Node& item, const Section& section, const fs::path& set, Errors& errors) {
    if (item.is_scalar()) return {scene_path(item, set, errors), place_of(item), {}, {}};
    const Fields fields{item, section};
    SetRun run{{}, place_of(item), fields.text("label"), read_changes(fields, errors)};
    if (const Node* path = fields.given("scene")) run.path = scene_path(*path, set, errors);
    return run;
}

std::vector<SetComparison> read_comparisons(const Fields& set, const fs::path& path,
                                            const std::shared_ptr<const Source>& source,
                                            Errors& errors) {
    std::vector<SetComparison> comparisons;
    const Node* list = set.given("comparisons");
    if (list == nullptr) return comparisons;
    const Section& section = section_of(set_section(), "comparisons");
    for (const Node& item : list->items) {
        if (!item.valid || !item.is_mapping()) continue;
        SetComparison comparison{source, item, {}};
        if (const Node* scenes = Fields{item, section}.given("scenes"))
            for (const Node& one : scenes->items)
                if (one.valid)
                    comparison.runs.push_back(
                        read_run(one, section_of(section, "scenes"), path, errors));
        comparisons.push_back(std::move(comparison));
    }
    return comparisons;
}

std::string template_of(const Node& written, const fs::path& set, Errors& errors) {
    const std::string& name = written.text;
    if (std::ranges::find(page_names, name) != page_names.end()) return name;
    const std::string ending = fs::path(name).extension().string();
    const bool page = ending == ".md" || ending == ".html" || ending == ".tex";
    if (name.find_first_of("/\\") != std::string::npos || name.starts_with('.') || !page)
        errors.add(written, fmt::format("expected a template of pages, found {}", in_quotes(name)),
                   "`markdown`, `html`, `latex`, or a file beside the set that ends in .md, .html "
                   "or .tex");
    return (folder_of(set) / name).lexically_normal().string();
}

}  // namespace

bool is_figure_set(const fs::path& path) {
    Errors errors;
    Source source;
    const auto root = tree_of(path, source, errors);
    return root && root->is_mapping() && find(*root, "scenes") != nullptr &&
           find(*root, "box") == nullptr;
}

FigureSpec figure_of(const SetComparison& comparison, const Scene& scene) {
    Errors errors;
    FigureSpec figure = read_comparison(comparison.node, {scene.gas, scene.run}, errors);
    errors.throw_if_any();
    return figure;
}

SetFile load_figure_set(const fs::path& path) {
    Errors errors;
    const auto kept = std::make_shared<Source>();
    Source& source = *kept;
    auto root = tree_of(path, source, errors);
    if (root && !root->is_mapping())
        errors.add(source, root->kind == Node::Kind::null ? "the set is empty"
                                                          : "expected a set (a mapping with "
                                                            "`title` and `scenes`)");
    errors.throw_if_any();
    check_mapping(root.value(), set_section(), errors);
    const Fields fields{*root, set_section()};
    SetFile set;
    set.title = fields.text("title").value_or("");
    set.description = fields.text("description").value_or("");
    set.text = source.text;
    set.comparisons = read_comparisons(fields, path, kept, errors);
    if (const Node* scenes = fields.given("scenes"))
        for (const Node& item : scenes->items)
            if (item.valid) set.scenes.push_back(read_scene(item, path, errors));
    if (const Node* asked = fields.value("template")) {
        if (asked->is_scalar()) set.templates.push_back(template_of(*asked, path, errors));
        for (const Node& one : asked->items)
            set.templates.push_back(template_of(one, path, errors));
    }
    if (const Node* formats = fields.given("formats"))
        for (const Node& one : formats->items) set.formats.push_back(one.text);
    errors.throw_if_any();
    return set;
}

}  // namespace carom
