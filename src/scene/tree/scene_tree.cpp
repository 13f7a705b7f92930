#include "scene/tree/scene_tree.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "scene/film.h"
#include "scene/keys/check.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/template.h"
#include "scene/style/style_reading.h"
#include "scene/yaml/yaml.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// A film of disks that shows a single panel has it over the gas.
std::string usual_template(const SceneTree& tree) {
    const Node* panels = given(tree.film, "panels");
    const bool has_one = panels != nullptr && panels->is_list() && panels->items.size() == 1;
    const bool is_beside = find(tree.film, "beside") != nullptr;
    return has_one && !is_beside && tree.dimension > 1 ? "hero" : Film{}.template_name;
}

// Returns the node with the name of the film's template; a node in the scene with the default name
// if none is given; nothing if the name contains a mistake.
std::optional<Node> template_asked(const SceneTree& tree) {
    if (const Node* asked = given(tree.film, "template")) return *asked;
    if (find(tree.film, "template") != nullptr) return std::nullopt;
    Node usual = default_node(usual_template(tree));
    usual.source = tree.root.source;
    return usual;
}

// Files whose texts are in `resources.files` take precedence, wherever the scene is now.
std::optional<TemplateFile> named_file(const Node& asked, const fs::path& scene,
                                       const SceneResources& resources, Errors& errors,
                                       const NamedFiles& kind) {
    for (const fs::path& path : named_paths(asked, scene, kind))
        if (resources.files.contains(path.string()))
            return TemplateFile{path.stem().string(), path};
    return find_template(asked, scene, resources.templates, errors, kind);
}

std::optional<Node> read_file(const fs::path& path, const SceneResources& resources, Source& source,
                              Errors& errors) {
    const auto found = resources.files.find(path.string());
    if (found == resources.files.end()) return read_yaml_file(path, source, errors);
    source.name = path.string();
    source.text = found->second;
    return read_yaml(source, errors);
}

void read_template(SceneTree& tree, const fs::path& scene, const SceneResources& resources,
                   Sources& sources, Errors& errors) {
    const auto asked = template_asked(tree);
    if (!asked) return;
    const auto file = named_file(*asked, scene, resources, errors, film_templates);
    if (!file) return;
    Source& source = sources.emplace_back(Source{.origin = Origin::template_file});
    auto root = read_file(file->path, resources, source, errors);
    if (!root) return;
    tree.template_file = std::move(*root);
    tree.template_name = file->name;
    if (!tree.template_file.is_mapping()) {
        errors.add(
            tree.template_file,
            "expected a template (a mapping with `layout`), found " + described(tree.template_file),
            "a template begins with `layout:`, see templates/films/ of carom");
        return;
    }
    const FixedTable<FilmDraft>& table = template_table(resources.panels);
    check_mapping(tree.template_file, table.section(), errors);
    tree.film = lay_over(tree.film, tree.template_file, table.section().choices);
}

// Reads the style that a scene names.
void load_style(SceneTree& tree, const fs::path& scene, const SceneResources& resources,
                Wanted wanted, Sources& sources, Errors& errors) {
    const Node* asked = given(tree.root, "style");
    const bool is_of_set = find(tree.root, "style") == nullptr && resources.set != nullptr &&
                           resources.set->style.has_value();
    if (is_of_set) asked = &*resources.set->style;
    if (asked == nullptr) return;
    const auto file = named_file(*asked, is_of_set ? fs::path(resources.set->source.name) : scene,
                                 resources, errors, style_files);
    if (!file) return;
    Source& source = sources.emplace_back(Source{.origin = Origin::template_file});
    auto root = read_file(file->path, resources, source, errors);
    if (!root) return;
    tree.style_file = std::move(*root);
    tree.style = read_style(
        tree.style_file, source.name,
        wanted == Wanted::physics ? StyleCheck{}.families : resources.styles.families, errors);
}

// Whether a value of the box is a list of three, whatever its key is called: only a size and a
// shape are lists.
bool has_three_lengths(const Node& box) {
    return box.is_mapping() && std::ranges::any_of(box.items, [](const Node& value) {
               return value.is_list() && value.items.size() == 3;
           });
}

}  // namespace

int dimension_of(const Node& root) {
    const Node* box = find(root, "box");
    if (box == nullptr) return 2;
    const Node* length = find(*box, "length");
    const Node* size = find(*box, find(*box, "shape") != nullptr ? "shape" : "size");
    const int by_size = has_three_lengths(*box) ? 3 : 2;
    if (length != nullptr)
        return size == nullptr || length->source->origin > size->source->origin ? 1 : by_size;
    const std::vector<std::string> names{"size", "length", "walls"};
    const bool is_misspelt = std::ranges::any_of(
        box->keys, [&](const Node& key) { return nearest_spelling(key.text, names) == names[1]; });
    return is_misspelt ? 1 : by_size;
}

void read_named_files(SceneTree& tree, const fs::path& scene, const SceneResources& resources,
                      Wanted wanted, Sources& sources, Errors& errors) {
    const Node* film = find(tree.root, "film");
    tree.film = film != nullptr && film->is_mapping()
                    ? *film
                    : Node{.kind = Node::Kind::mapping, .source = tree.root.source};
    load_style(tree, scene, resources, wanted, sources, errors);
    read_template(tree, scene, resources, sources, errors);
}

}  // namespace carom
