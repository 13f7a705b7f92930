#include "scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "scene/feasibility/feasibility.h"
#include "scene/keys/check.h"
#include "scene/overrides.h"
#include "scene/reading/figure_reading.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/reading/template.h"
#include "scene/time/captions.h"
#include "scene/time/timeline.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/scalar.h"
#include "scene/yaml/yaml.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// A scene of a newer format may hold anything: nothing else in it is looked at.
void refuse_newer_format(const Node& root) {
    const Node* version = find(root, "carom");
    if (version == nullptr) return;
    const auto number = number_in(*version);
    if (!number || *number <= scene_format) return;
    Errors errors;
    errors.add(*version,
               fmt::format("the scene is written for format {}, this carom reads format {}",
                           version->text, scene_format),
               "a newer carom reads it");
    errors.throw_if_any();
}

void refuse_figure_set(const Node& root) {
    const auto scenes = std::ranges::find(root.keys, "scenes", &Node::text);
    if (scenes == root.keys.end() || find(root, "box") != nullptr) return;
    Errors errors;
    errors.add(*scenes, "this is a figure set, and a scene is wanted",
               "`carom figures` makes the figures of a set, `carom check` checks it");
    errors.throw_if_any();
}

// Of the box that a scene asks for, before it is checked: keys and forms depend on it.
int dimension_of(const Node& root) {
    const Node* box = find(root, "box");
    if (box == nullptr || !box->is_mapping()) return 2;
    const Node* length = find(*box, "length");
    const Node* size = find(*box, "size");
    if (length != nullptr)
        return size == nullptr || length->source->origin > size->source->origin ? 1 : 2;
    const std::vector<std::string> names{"size", "length", "walls"};
    return std::any_of(
               box->keys.begin(), box->keys.end(),
               [&](const Node& key) { return nearest_spelling(key.text, names) == names[1]; })
               ? 1
               : 2;
}

Node empty_mapping(const Source& source) {
    Node node;
    node.kind = Node::Kind::mapping;
    node.source = &source;
    return node;
}

/// What a scene and its template say, and where: checked for form.
struct Tree {
    Node root;
    int dimension = 2;  ///< of the box
    Node film;          ///< the scene's, laid over the template's
    Node template_file;
    std::string template_name;
};

// Where the name of the film's template is written; the scene, if it is the usual one; nothing if
// there is a mistake in it.
std::optional<Node> template_asked(const Tree& tree) {
    if (const Node* asked = given(tree.film, "template")) return *asked;
    if (find(tree.film, "template") != nullptr) return std::nullopt;
    Node usual = default_node(Film{}.template_name);
    usual.source = tree.root.source;
    return usual;
}

void read_template(Tree& tree, const fs::path& scene, const SceneResources& resources,
                   Sources& sources, Errors& errors) {
    const auto asked = template_asked(tree);
    if (!asked) return;
    const auto file = find_template(*asked, scene, resources.templates, errors);
    if (!file) return;
    Source& source = sources.emplace_back();
    source = {file->path.string(), {}, Origin::template_file};
    auto text = file_text(file->path, source, errors);
    if (!text) return;
    source.text = std::move(*text);
    auto root = read_yaml(source, errors);
    if (!root) return;
    tree.template_file = std::move(*root);
    tree.template_name = file->name;
    if (!tree.template_file.is_mapping()) {
        errors.add(tree.template_file, "expected a template (a mapping with `layout`), found " +
                                           described(tree.template_file));
        return;
    }
    const KeyTable<FilmDraft> table = template_table(resources.panels);
    check_mapping(tree.template_file, table.section(), errors);
    tree.film = lay_over(tree.film, tree.template_file, table.choices);
}

double usual_sample_every(const Scene& scene, bool has_film) {
    constexpr int samples_without_film = 1000;
    const int steps = has_film ? frame_count(scene.film) - 1 : samples_without_film;
    return scene.run.until / steps;
}

// The gas and the run from the drafts of the scene, which they are checked with.
void complete_physics(SceneDraft& draft, const Node& root, Errors& errors) {
    Scene& scene = draft.scene;
    scene.gas.seed = scene.seed;
    scene.run = draft.run.run;
    scene.marks = draft.run.marks;
    for (const auto& [caption, node] : draft.run.captions) scene.captions.push_back(caption);
    const Node* precision = draft.run.precision;
    scene.precision_place = place_of(precision != nullptr ? *precision : root);
    for (const Node* node : draft.run.event_nodes) scene.event_places.push_back(place_of(*node));
    for (const SpeciesDraft& species : draft.species) {
        scene.gas.species.push_back(species.species);
        scene.looks.push_back(species.look);
        scene.species_spans.push_back(place_of(*species.node));
    }
    if (!draft.box) return;
    scene.gas.box = *draft.box;
    check_feasibility(*draft.box, draft.species, scene.seed, scene.run, errors);
    check_nudges(draft.run, scene.gas, errors);
}

void complete_film(SceneDraft& draft, const Tree& tree, const SceneResources& resources,
                   Reading& reading) {
    const auto layout = read_layout(tree.template_file, reading);
    FilmDraft film;
    film_table(resources.panels).read(tree.film, film, reading);
    const auto others = [&](std::size_t panels) {
        return templates_with_places(resources.templates, panels);
    };
    Scene& scene = draft.scene;
    film.template_name = tree.template_name;
    scene.film = complete_film(film, tree.film, tree.root, layout, others, reading);
    if (reading.errors.empty())
        check_captions(scene, draft.run.captions, tree.root, reading.errors);
    if (!scene.captions.empty()) scene.film.layout = with_caption_line(scene.film.layout);
}

Scene read_scene(const Tree& tree, const SceneResources& resources, Wanted wanted, Errors& errors) {
    SceneDraft draft;
    Scene& scene = draft.scene;
    Reading reading{errors, scene.gas, scene.run};
    scene_table(resources.panels, tree.dimension).read(tree.root, draft, reading);
    complete_physics(draft, tree.root, errors);
    const bool has_film = find(tree.root, "film") != nullptr;
    if (tree.template_file.is_mapping() && (has_film || wanted == Wanted::film))
        complete_film(draft, tree, resources, reading);
    if (draft.figures != nullptr)
        scene.figures = figures_notation(resources.panels).read(*draft.figures, reading).value();
    errors.throw_if_any();
    if (scene.run.sample_every == 0.0) scene.run.sample_every = usual_sample_every(scene, has_film);
    scene.description = draft.description.value_or(describe(scene));
    return scene;
}

// The scene of a compared run, as `reload` makes it of overrides, with that figure alone.
template <typename Reload>
Scene compared_scene(const FigureSpec& figure, const ComparedRun& run, Overrides overrides,
                     const Reload& reload) {
    for (const std::string& value : run.values) overrides.values.push_back(parted_change(value));
    Diagnostic error = run.place;
    try {
        Scene scene = reload(figure.name, overrides);
        for (FigureSpec& one : scene.figures) one.compare.clear();
        if (!scene.figures.empty() && scene.figures.front().panel.kind == figure.panel.kind)
            return scene;
        error.message = fmt::format("with this the scene has no figure `{}` of kind `{}`",
                                    figure.name, figure.panel.kind);
    } catch (const SceneError& refused) {
        error.message =
            "with this the scene is not valid: " + refused.diagnostics().front().message;
        error.hint = refused.diagnostics().front().hint;
    }
    throw SceneError({std::move(error)});
}

// Of all figures; their mistakes are reported together.
template <typename Reload>
void load_compared(Scene& scene, const Overrides& overrides, const Reload& reload) {
    std::vector<Diagnostic> errors;
    for (FigureSpec& figure : scene.figures)
        for (ComparedRun& run : figure.compare) try {
                run.scene = std::make_shared<Scene>(compared_scene(figure, run, overrides, reload));
            } catch (const SceneError& error) {
                errors.insert(errors.end(), error.diagnostics().begin(), error.diagnostics().end());
            }
    if (!errors.empty()) throw SceneError(std::move(errors));
}

// Of the figures only the one of this name: what is asked of the others is not of this run.
void keep_figure(Node& root, const std::string& name) {
    Node* list = find(root, "figures");
    if (list == nullptr || !list->is_list()) return;
    std::erase_if(list->items, [&](const Node& figure) {
        const Node* its = figure.is_mapping() ? find(figure, "name") : nullptr;
        return its == nullptr || its->text != name;
    });
}

// With `figure`, as a run that this figure compares: the only one that is looked at, if it is here.
Scene load(Sources& sources, const fs::path& path, const SceneResources& resources,
           const Overrides& overrides, Wanted wanted,
           const std::optional<std::string>& figure = {}) {
    const Source& source = sources.front();
    Errors errors;
    Tree tree;
    auto root = read_yaml(source, errors);
    if (root && root->kind == Node::Kind::null) errors.add(source, "the scene is empty");
    if (!root || root->kind == Node::Kind::null) errors.throw_if_any();
    tree.root = std::move(root.value());
    if (tree.root.is_mapping()) apply_overrides(overrides, tree.root, sources, errors);
    if (!tree.root.is_mapping()) {
        errors.add(tree.root,
                   "expected a scene (a mapping with `title`, `box`, `gas` and `run`), "
                   "found " +
                       described(tree.root));
        errors.throw_if_any();
    }
    if (figure) keep_figure(tree.root, *figure);
    refuse_newer_format(tree.root);
    refuse_figure_set(tree.root);
    tree.dimension = dimension_of(tree.root);
    check_mapping(tree.root, scene_table(resources.panels, tree.dimension).section(), errors);
    const Node* film = find(tree.root, "film");
    tree.film = film != nullptr && film->is_mapping() ? *film : empty_mapping(source);
    read_template(tree, path, resources, sources, errors);
    Scene scene = read_scene(tree, resources, wanted, errors);
    const Source* used = tree.template_file.source;
    scene.source = {source.name, source.text, used != nullptr ? used->text : "", {}};
    for (const auto& [key, value] : overrides.values)
        scene.source.overrides.push_back(key + "=" + value);
    if (!figure)
        load_compared(scene, overrides, [&](const std::string& name, const Overrides& others) {
            Sources again(1);
            again.front() = {source.name, source.text, Origin::scene};
            return load(again, path, resources, others, wanted, name);
        });
    return scene;
}

Scene load_file(const fs::path& path, const SceneResources& resources, const Overrides& overrides,
                Wanted wanted, const std::optional<std::string>& figure) {
    const bool streamed = path == standard_input;
    const fs::path name = streamed ? "<stdin>" : path;
    Sources sources(1);
    sources.front().name = name.string();
    Errors errors;
    if (name.empty()) sources.front().name = "\"\"";
    auto text = streamed ? text_of(*stdin, sources.front(), errors)
                         : file_text(path, sources.front(), errors);
    errors.throw_if_any();
    sources.front().text = std::move(text.value());
    return load(sources, name, resources, overrides, wanted, figure);
}

}  // namespace

Scene load_run(const fs::path& path, const SceneResources& resources, const Overrides& overrides) {
    return load_file(path, resources, overrides, Wanted::film, "");
}

Scene load_scene(const fs::path& path, const SceneResources& resources, const Overrides& overrides,
                 Wanted wanted) {
    return load_file(path, resources, overrides, wanted, {});
}

Scene load_scene_text(const std::string& text, const std::string& name,
                      const SceneResources& resources, const Overrides& overrides, Wanted wanted) {
    Sources sources(1);
    sources.front() = {name, text, Origin::scene};
    return load(sources, name, resources, overrides, wanted);
}

}  // namespace carom
