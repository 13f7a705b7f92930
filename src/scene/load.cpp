#include "scene/load.h"

#include <fmt/format.h>

#include <cstdio>

#include "physics/events/time_step.h"
#include "physics/sample_times.h"
#include "physics/units/gas_table.h"
#include "scene/describe.h"
#include "scene/feasibility/box_size.h"
#include "scene/feasibility/classroom.h"
#include "scene/feasibility/feasibility.h"
#include "scene/keys/check.h"
#include "scene/keys/gas_values.h"
#include "scene/keys/unit_conversion.h"
#include "scene/left_out.h"
#include "scene/numbers/known_numbers.h"
#include "scene/other_runs.h"
#include "scene/overrides.h"
#include "scene/reading/event_reading.h"
#include "scene/reading/figure_reading.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/panel_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/reading/template.h"
#include "scene/sets/set_reading.h"
#include "scene/style/style_reading.h"
#include "scene/sweep_figures.h"
#include "scene/time/captions.h"
#include "scene/time/timeline.h"
#include "scene/tree/scene_tree.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/run_fingerprint.h"
#include "scene/yaml/scalar.h"
#include "scene/yaml/yaml.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// A scene of a newer format may contain anything, so that nothing else in it is checked.
void refuse_newer_format(const Node& root) {
    const Node* version = find(root, "carom");
    if (version == nullptr) return;
    const auto number = number_in(*version);
    if (!number || *number <= scene_format) return;
    Errors errors;
    errors.add(*version,
               fmt::format("the scene is written for format {}, this carom reads format {}",
                           version->text, scene_format),
               "install a newer carom");
    errors.throw_if_any();
}

void refuse_figure_set(const Node& root) {
    const Node* scenes = key_of_set(root);
    if (scenes == nullptr) return;
    Errors errors;
    errors.add(*scenes, "expected a scene, found a figure set",
               "`carom figures` makes the figures of a set, `carom check` checks it");
    errors.throw_if_any();
}

// Figures take what they do not give from `figure_defaults` of the scene, then of its set, and then
// from the style.
void read_figures(SceneDraft& draft, const SceneTree& tree, const SceneResources& resources,
                  Reading& reading) {
    if (draft.defaults_node != nullptr) {
        FigureDefaults defaults;
        figure_defaults_table().read(*draft.defaults_node, defaults, reading);
        draft.figure_formats = defaults.formats;
    }
    if (tree.style && draft.figure_formats.empty())
        draft.figure_formats = tree.style->figure_formats;
    if (draft.figures_node == nullptr) return;
    Node figures = *draft.figures_node;
    if (draft.defaults_node != nullptr) add_defaults_to_all(figures, *draft.defaults_node);
    if (resources.set && resources.set->figures)
        add_defaults_to_all(figures, *resources.set->figures);
    draft.figures = figures_notation(resources.panels).read(figures, reading).value();
    if (!reading.errors.empty()) return;
    for (std::size_t k = 0; k < draft.figures.size(); ++k)
        take_style(draft.figures[k], figures.items[k], tree.style);
}

// Returns the node of the first surface that does more than reflect; if there is none, that of
// gravity or of the box.
const Node& first_acting(const SceneDraft& draft, const PlacedSurfaces& placed) {
    for (std::size_t k = 0; k < placed.nodes.size(); ++k)
        if (placed.nodes[k] != nullptr &&
            (!placed.surfaces.is_side(k) || !only_reflects(placed.surfaces.sides[k])))
            return *placed.nodes[k];
    return draft.gravity.node != nullptr ? *draft.gravity.node : *draft.box->node;
}

// Sets the surfaces of the box from the draft, and their numbers in events that name them.
void place_surfaces(SceneDraft& draft, Errors& errors) {
    const BoxDraft box = draft.box.value_or(BoxDraft{});
    std::vector<std::string> species;
    for (const SpeciesDraft& one : draft.species) species.push_back(one.name);
    const int dimension = draft.gas.box.dimension;
    const PlacedSurfaces placed = surfaces_of(dimension, box.sides, draft, species, errors);
    resolve_names(draft.written_run, placed, species, dimension, errors);
    if (!draft.box) return;
    draft.box->surfaces = placed.surfaces;
    draft.asked_pressure = draft.box->pressure;
    if (!size_by_pressure(*draft.box, draft.species, errors)) return draft.box.reset();
    draft.gas.box = *draft.box;
    place_beside_partitions(draft.species, draft.gas.box, placed.others, errors);
    draft.surface_nodes = placed.nodes;
    for (const Node* node : placed.nodes)
        draft.surface_places.push_back(place_of(node != nullptr ? *node : *box.node));
    draft.surfaces_place = place_of(first_acting(draft, placed));
}

// Completes the gas and the run from the draft of the scene, and checks them.
void complete_physics(SceneDraft& draft, const Node& root, Errors& errors) {
    draft.gas.seed = draft.seed;
    draft.marks = draft.written_run.marks;
    draft.captions = values_of(draft.written_run.captions);
    const Node* precision = draft.written_run.precision;
    draft.precision_place = place_of(precision != nullptr ? *precision : root);
    const Node* ceiling = draft.written_run.ceiling;
    draft.ceiling_place = place_of(ceiling != nullptr ? *ceiling : root);
    place_surfaces(draft, errors);
    for (const SpeciesDraft& species : draft.species) {
        draft.gas.species.push_back(species);
        draft.looks.push_back(species);
        draft.looks.back().scale = draft.scale;
        draft.named_gases.push_back(species.named);
        draft.species_spans.push_back(place_of(*species.node));
    }
    draft.run = draft.written_run;
    for (const Node* node : draft.written_run.event_nodes)
        draft.event_places.push_back(place_of(*node));
    if (!draft.box) return;
    check_feasibility(*draft.box, draft.species, draft.seed, draft.run, errors);
    check_surfaces(draft.gas, {draft.run, draft.surface_nodes, draft.written_run.event_nodes},
                   errors);
    check_nudges(draft.written_run, draft.gas, errors);
    if (const auto problem = time_step_problem(*draft.box, draft.run))
        errors.add(*draft.written_run.step, problem->message, problem->hint);
}

// Returns whether the scene itself says how long its film is.
bool gives_length(const Node& root) {
    const Node* film = find(root, "film");
    return film != nullptr && film->is_mapping() &&
           (find(*film, "seconds") != nullptr || find(*film, "pace") != nullptr);
}

// With `has_length`, the film is as long as it says, and is checked for it.
void complete_film(SceneDraft& draft, const SceneTree& tree, bool has_length,
                   const SceneResources& resources, Reading& reading) {
    draft.film =
        read_film({tree.film, tree.template_file, tree.root, has_length}, tree.template_name,
                  resources.panels, resources.templates, draft.written_run.pauses, reading);
    if (has_length && reading.errors.empty())
        check_captions(draft, draft.written_run.captions, tree.root, reading.errors);
    const bool has_subtitle_there = draft.film.layout.caption && !draft.subtitle.empty();
    if (!draft.captions.empty() || has_subtitle_there)
        draft.film.layout = with_caption_line(draft.film.layout);
}

// A gas that a scene names is called by its name in the language of its pictures.
void localize_names(SceneDraft& draft) {
    for (std::size_t k = 0; k < draft.species.size(); ++k)
        if (draft.named_gases[k] != nullptr && is_filled_in(*draft.species[k].node, "name"))
            draft.gas.species[k].name = say(draft.film.language, draft.named_gases[k]->name);
}

Scene read_scene(const SceneTree& tree, const SceneResources& resources, Wanted wanted,
                 Errors& errors) {
    SceneDraft draft;
    draft.gas.box.dimension = tree.dimension;  // known even where the box has mistakes
    Reading reading{errors, draft.gas, draft.run, draft.numbers, units_of(tree.root)};
    scene_table(resources.panels, tree.dimension).read(tree.root, draft, reading);
    complete_physics(draft, tree.root, errors);
    const bool has_film = find(tree.root, "film") != nullptr;
    const bool has_length = wanted == Wanted::film || gives_length(tree.root);
    const bool wants_pictures = wanted == Wanted::film || wanted == Wanted::figures;
    if (tree.template_file.is_mapping() && (has_film || wants_pictures))
        complete_film(draft, tree, has_length, resources, reading);
    if (tree.style) {
        draft.film.style = tree.style;
        const Node* film = find(tree.root, "film");
        if (film == nullptr || find(*film, "theme") == nullptr) draft.film.theme = tree.style->base;
    }
    read_figures(draft, tree, resources, reading);
    if (draft.measure_node != nullptr)
        draft.measure =
            measure_notation(resources.panels).read(*draft.measure_node, reading).value();
    if (wanted == Wanted::film && reading.units == UnitSystem::real && errors.empty())
        errors.add(*find(tree.root, "units"),
                   "films do not show the units of a scene with `units: real`",
                   "figures do: `carom figures`; `carom run` gives all numbers");
    errors.throw_if_any();
    if (auto wrong = find_instruments(draft, resources.panels); !wrong.empty())
        throw SceneError(std::move(wrong));
    if (draft.run.sample_every == 0.0) draft.run.sample_every = usual_sample_every(draft.run);
    if (resources.is_classroom) {
        hold_to_classroom(draft, tree.root, has_length, errors);
        errors.throw_if_any();
    }
    localize_names(draft);
    if (draft.description.empty()) draft.description = describe(draft);
    draft.notes = errors.notes();
    if (tree.style && wanted != Wanted::physics && resources.styles.faults)
        for (Diagnostic& fault : resources.styles.faults(*tree.style))
            draft.notes.push_back(std::move(fault));
    return draft;
}

// Throws the notes on a scene as errors, if there are any.
void refuse_notes(std::vector<Diagnostic> notes) {
    if (notes.empty()) return;
    for (Diagnostic& note : notes) note.hint = "without --strict this is a note: " + note.hint;
    throw SceneError(std::move(notes));
}

// Refuses a file outside the scene's folder, to which a symbolic link may lead.
void require_in_folder(const fs::path& file, const Node& asked) {
    const fs::path folder = file.parent_path();
    std::error_code error;
    Errors errors;
    if (!fs::exists(file, error))
        errors.add(asked,
                   fmt::format("there is no scene {} in the scene's folder", in_quotes(asked.text)),
                   "give the name of a file beside this one");
    else if (!stays_inside(file, folder.empty() ? "." : folder))
        errors.add(asked, fmt::format("{} leads out of the scene's folder", in_quotes(asked.text)),
                   "copy the scene into this folder");
    errors.throw_if_any();
}

// Returns everything that a scene was made from, except files that are part of carom.
SceneSource source_of(const SceneTree& tree, const Source& source, const SceneResources& resources,
                      const Overrides& overrides) {
    SceneSource all{source.name, source.text, "", overrides, run_fingerprint(tree.root)};
    all.is_held_to_classroom = resources.is_classroom;
    const auto add_look = [&](const Source& look) {
        all.files[look.name] = look.text;
        all.look_text += look.text;
    };
    if (const Source* style = tree.style_file.source) add_look(*style);
    if (resources.set) add_look(resources.set->source);
    const Source* used = tree.template_file.source;
    if (used == nullptr) return all;
    all.template_text = used->text;
    if (fs::path(used->name).parent_path() != resources.templates / "films")
        all.files[used->name] = used->text;
    return all;
}

/// What is loaded: a scene with overrides, or a part of it, without some items of its lists.
struct LoadRequest {
    fs::path path;
    const SceneResources& resources;
    Overrides overrides;
    Wanted wanted;
    ScenePart part = {};
    ListItems left_out = {};
};

Source source_at(const fs::path& path, const SceneResources& resources);

Scene load_once(Source file, const LoadRequest& request) {
    const EndsAtOnce whole;
    const auto& [path, resources, overrides, wanted, part, left_out] = request;
    Sources sources{std::move(file)};
    const Source& source = sources.front();
    Errors errors;
    SceneTree tree;
    auto root = read_yaml(source, errors);
    if (root && root->kind == Node::Kind::null)
        errors.add(source, std::size_t{0}, "the scene is empty", how_to_start);
    if (!root || root->kind == Node::Kind::null) errors.throw_if_any();
    tree.root = std::move(root.value());
    if (tree.root.is_mapping()) apply_overrides(overrides, tree.root, sources, errors);
    if (!tree.root.is_mapping()) {
        errors.add(tree.root,
                   "expected a scene (a mapping with `title`, `box`, `gas` and `run`), "
                   "found " +
                       described(tree.root),
                   how_to_start);
        errors.throw_if_any();
    }
    tree.dimension = dimension_of(tree.root);
    if (units_of(tree.root) == UnitSystem::real) {
        convert_units(tree.root, scene_table(resources.panels, tree.dimension).section(), errors);
        fill_in_gases(tree.root);
    }
    if (wanted == Wanted::run) keep_run(tree.root);
    const Removed removed = remove_items(tree.root, left_out);
    keep_part(tree.root, part);
    leave_out_later(tree.root, removed, wanted == Wanted::run ? nullptr : &errors);
    refuse_newer_format(tree.root);
    refuse_figure_set(tree.root);
    check_mapping(tree.root, scene_table(resources.panels, tree.dimension).section(), errors);
    read_named_files(tree, path, resources, wanted, sources, errors);
    Scene scene = read_scene(tree, resources, wanted, errors);
    scene.source = source_of(tree, source, resources, overrides);
    if (!part.is_whole()) return scene;
    if (resources.is_strict) refuse_notes(scene.notes);
    refuse_many_scenes(scene);
    const Wanted compared = wanted == Wanted::physics ? wanted : Wanted::figures;
    load_compared(scene, resources.panels, overrides,
                  [&](const std::string& name, const Overrides& others) {
                      return load_once(
                          source, {path, resources, others, compared, {.figure = name}, left_out});
                  });
    load_sweep_figures(scene, resources);
    load_beside(
        scene, tree.root, overrides,
        [&](const std::string& name, const ScenePart& other, const Overrides& changes) {
            if (name.empty())
                return load_once(source, {path, resources, changes, wanted, other, left_out});
            const fs::path there = path.parent_path() / name;
            if (!resources.files.contains(there.string()))
                require_in_folder(there, *find(*find(tree.film, "beside"), "scene"));
            return load_once(source_at(there, resources),
                             {there, resources, changes, wanted, other});
        });
    return scene;
}

// Whether errors only arise because the command line ends the run earlier than the scene does: then
// adds the items of lists with the errors to what is left out.
bool leave_out(const SceneError& error, const Source& file, LoadRequest& request) {
    LoadRequest whole = request;
    std::erase_if(whole.overrides,
                  [](const std::string& set) { return set.starts_with("run.until="); });
    if (whole.overrides.size() == request.overrides.size()) return false;
    Errors errors;
    Sources sources{file};
    auto root = read_yaml(sources.front(), errors);
    if (!root || !root->is_mapping()) return false;
    apply_overrides(request.overrides, *root, sources, errors);
    const Node* end = end_set_by_command_line(*root);
    const auto until = end != nullptr ? number_in(*end) : std::nullopt;
    if (!until || !add_items_with(error.diagnostics(), *root, request.left_out)) return false;
    whole.left_out.clear();
    try {
        return load_once(file, whole).run.until > *until;
    } catch (const SceneError&) {
        return false;
    }
}

Scene load(const Source& file, LoadRequest request) {
    while (true) try {
            return load_once(file, request);
        } catch (const SceneError& error) {
            if (!leave_out(error, file, request)) throw;
        }
}

// The path of a scene as messages name it.
fs::path name_of(const fs::path& path) { return path == standard_input ? "<stdin>" : path; }

// The text of a scene's file, or of standard input, which can be read only once.
Source source_at(const fs::path& path, const SceneResources& resources) {
    if (const auto found = resources.files.find(path.string()); found != resources.files.end())
        return {path.string(), found->second};
    const fs::path name = name_of(path);
    Source source{.name = name.empty() ? "\"\"" : name.string()};
    Errors errors;
    auto text =
        path == standard_input ? text_of(*stdin, source, errors) : file_text(path, source, errors);
    errors.throw_if_any();
    source.text = std::move(text.value());
    return source;
}

Scene load_file(const fs::path& path, const SceneResources& resources, const Overrides& overrides,
                Wanted wanted, const ScenePart& part) {
    return load(source_at(path, resources), {name_of(path), resources, overrides, wanted, part});
}

}  // namespace

Scene load_run(const fs::path& path, const SceneResources& resources, const Overrides& overrides) {
    return load_file(path, resources, overrides, Wanted::figures, {.figure = ""});
}

Scene load_scene(const fs::path& path, const SceneResources& resources, const Overrides& overrides,
                 Wanted wanted) {
    return load_file(path, resources, overrides, wanted, {});
}

LoadedScene load_for_all(const fs::path& path, const SceneResources& resources,
                         const Overrides& overrides) {
    const Source source = source_at(path, resources);
    const auto loaded = [&](Wanted wanted) {
        return load(source, {name_of(path), resources, overrides, wanted});
    };
    try {
        return {loaded(Wanted::film)};
    } catch (const SceneError& error) {
        try {
            return {loaded(Wanted::figures), error.diagnostics()};
        } catch (const SceneError&) {
            throw error;
        }
    }
}

Scene load_run_text(const std::string& text, const std::string& name,
                    const SceneResources& resources, const Overrides& overrides) {
    return load({name, text}, {name, resources, overrides, Wanted::physics, {.figure = ""}});
}

Scene load_scene_text(const std::string& text, const std::string& name,
                      const SceneResources& resources, const Overrides& overrides, Wanted wanted) {
    return load({name, text}, {name, resources, overrides, wanted});
}

}  // namespace carom
