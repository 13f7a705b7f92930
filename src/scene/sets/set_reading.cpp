#include "scene/sets/set_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/keys/check.h"
#include "scene/keys/made_once.h"
#include "scene/reading/figure_reading.h"
#include "scene/scene.h"
#include "scene/style/style_reading.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/yaml.h"
#include "util/files/atomic_file.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::array page_names{"markdown", "html", "latex"};

bool is_inside(const fs::path& file, const fs::path& folder) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end == folder.end() && rest != file.end();
}

// Returns a hint for a scene that does not exist: the file in the same folder that is probably
// meant.
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

// Scenes must be in the set's folder or in the one above it, so that a set and its scenes can be
// moved together and refer to nothing else.
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

// The path of a scene, from the working folder.
Notation<fs::path> path_notation(const fs::path& set) {
    return parsed(text(1, most_title_letters),
                  [set](const std::string&, const Node& node, Reading& reading) {
                      return std::optional(scene_path(node, set, reading.errors));
                  });
}

// The path of a scene alone, or a mapping of `table` with the path among its keys.
template <typename Item>
Notation<Item> item_notation(const fs::path& set, KeyTable<Item> table) {
    const Notation<fs::path> file = path_notation(set);
    const auto alone = [](fs::path path, const Node& node, Reading&) {
        Item item;
        item.path = std::move(path);
        item.place = place_of(node);
        return std::optional(std::move(item));
    };
    table.keys.insert(table.keys.begin(),
                      bind_key("scene", &Item::path, file,
                               "The scene's file, relative to the set; it may lie in the folder "
                               "above the set's.")
                          .required());
    return either(parsed(file.called("the path of a scene"), alone), mapping(std::move(table)));
}

Notation<SetScene> scene_notation(const fs::path& set) {
    const auto name = parsed(text(1, most_name_letters),
                             [](const std::string& figure, const Node& node, Reading&) {
                                 return std::optional(std::pair(figure, place_of(node)));
                             });
    return item_notation<SetScene>(
        set, {.name = "an item of `scenes`",
              .keys = {bind_key("title", &SetScene::title, text(1, most_title_letters),
                                "Its title in the set.")
                           .default_text("the scene's"),
                       bind_key("description", &SetScene::description, lines(1, most_letters),
                                "The words under the title.")
                           .default_text("the scene's"),
                       bind_key("figures", &SetScene::figures,
                                list_of(name, 1, most_figures, "a list of names"),
                                "The names of the figures to show, in this order.")
                           .default_text("all figures of the scene")},
              .rule = [](SetScene& scene, const Node& node, Reading&) {
                  const Node* path = given(node, "scene");
                  scene.place = place_of(path != nullptr ? *path : node);
              }});
}

// The scenes of a comparison.
Notation<std::vector<SetRun>> runs_notation(const fs::path& set) {
    const auto run = item_notation<SetRun>(
        set,
        {.name = "an item of a comparison's `scenes`",
         .keys = {label_key().default_text("the scene's title"), changes_key(), run_color_key()},
         .rule = place_run});
    return list_of(run, 2, most_compared, "a list of scenes");
}

// The notation of a comparison as a figure; the node of `scenes` is kept unread.
const Notation<FigureSpec>& figure_notation(PanelKinds kinds) {
    static MadeOnce<Notation<FigureSpec>> notations;
    return notations.of(kinds, [&] { return comparison_notation(kinds, kept(runs_notation({}))); });
}

// Reads only the scenes; the other keys are read later as those of a figure of each scene.
Notation<SetComparison> set_comparison_notation(PanelKinds kinds, const fs::path& set) {
    const auto runs = runs_notation(set);
    return parsed(kept(figure_notation(kinds)),
                  [runs](const Node* node, const Node&, Reading& reading) {
                      SetComparison comparison{.source = {}, .node = *node, .runs = {}};
                      if (const Node* scenes = given(*node, "scenes"))
                          comparison.runs = runs.read(*scenes, reading).value_or(comparison.runs);
                      return std::optional(std::move(comparison));
                  });
}

std::string template_of(const std::string& name, const Node& written, const fs::path& set,
                        Errors& errors) {
    if (std::ranges::find(page_names, name) != page_names.end()) return name;
    const std::string ending = fs::path(name).extension().string();
    const bool page = ending == ".md" || ending == ".html" || ending == ".tex";
    if (!is_plain_name(name) || !page)
        errors.add(written, fmt::format("expected a template of pages, found {}", in_quotes(name)),
                   "`markdown`, `html`, `latex`, or a file beside the set that ends in .md, .html "
                   "or .tex");
    return (folder_of(set) / name).lexically_normal().string();
}

// What a set says is of several scenes.
void refuse(const std::vector<NumberInWords>& numbers) {
    if (numbers.empty()) return;
    Diagnostic error = numbers.front().place;
    error.message = fmt::format(
        "`{{{}}}`: the words of a set are of several runs, each of which "
        "has numbers of its own",
        numbers.front().name);
    error.hint = "put it into the words of a figure of a scene; a brace is written twice: `{{`";
    throw SceneError({std::move(error)});
}

}  // namespace

FixedTable<SetReading> set_table(PanelKinds kinds, const std::vector<std::string>& formats,
                                 const fs::path& path) {
    const auto page =
        parsed(text(1, most_title_letters),
               [path](const std::string& name, const Node& node, Reading& reading) {
                   return std::optional(template_of(name, node, path, reading.errors));
               });
    const auto pages = one_or_list(page, {page_names.size()}, "a list of templates");
    return KeyTable<SetReading>{
        .name = "a figure set",
        .keys = {
            bind_key("title", &SetFile::title, text(1, most_title_letters),
                     "The title of its pages.")
                .required(),
            bind_key("description", &SetFile::description, lines(1, most_letters),
                     "What the set shows, in words.")
                .default_text("none"),
            bind_key("scenes", &SetFile::scenes,
                     list_of(scene_notation(path), 1, most_set_scenes, "a list of scenes"),
                     "The scenes that it contains, in the order of the pages' sections.")
                .required(),
            bind_key("comparisons", &SetFile::comparisons,
                     list_of(set_comparison_notation(kinds, path), 1, most_figures,
                             "a list of comparisons"),
                     "Figures that show several scenes in one panel. They form the last section of "
                     "the pages.")
                .default_text("none"),
            bind_key("template", &SetFile::templates, pages,
                     "The kind of pages: `markdown`, `html`, `latex`, or a template in the set's "
                     "folder, a file that ends in .md, .html or .tex; or a list of these.")
                .default_value("html"),
            bind_key("formats", &SetFile::formats,
                     list_of(word(formats), 1, {double(formats.size())}, "a list of formats"),
                     "The file formats of its figures.")
                .default_text("those of its `figure_defaults`, or all"),
            bind_key(
                "figure_defaults", &SetReading::figures, kept(mapping(figure_defaults_table())),
                "What the figures of its scenes and its comparisons have that neither they nor "
                "their scenes' `figure_defaults` give.")
                .default_text("none"),
            bind_key("style", &SetReading::style, kept(text(1, most_title_letters)),
                     "The style of the scenes that name none: a file in the set's folder, or in "
                     "templates/styles, by name.")
                .default_text("none")}};
}

const Node* key_of_set(const Node& root) {
    const auto key = std::ranges::find(root.keys, "scenes", &Node::text);
    return key != root.keys.end() && find(root, "box") == nullptr ? &*key : nullptr;
}

bool is_figure_set(const fs::path& path) {
    Errors errors;
    Source source{.name = path.string()};
    const auto text = file_text(path, source, errors);
    // Searching for the key is much faster than parsing the file as YAML. Only an escape in double
    // quotes could hide the key.
    const auto holds = [&](std::string_view what) { return text->find(what) != text->npos; };
    if (!text || !(holds("scenes") || holds("\\"))) return false;
    source.text = *text;
    const auto root = read_yaml(source, errors);
    return root && key_of_set(*root) != nullptr;
}

namespace {

// With a source of their own, into which the nodes point.
std::shared_ptr<const SetDefaults> defaults_of(const SetReading& set, const fs::path& path) {
    const auto defaults = std::make_shared<SetDefaults>(
        SetDefaults{.source = {.name = path.string(), .text = set.text}});
    const auto owned = [&](const Node* node) {
        if (node == nullptr) return std::optional<Node>{};
        Node own = *node;
        point_to(own, defaults->source);
        return std::optional(std::move(own));
    };
    defaults->style = owned(set.style);
    defaults->figures = owned(set.figures);
    return defaults;
}

}  // namespace

FigureSpec figure_of(const SetComparison& comparison, const Scene& scene, PanelKinds kinds) {
    Errors errors;
    std::vector<NumberInWords> numbers;
    Reading reading{errors, scene.gas, scene.run, numbers, scene.units};
    auto figure = figure_notation(kinds).read(comparison.node, reading);
    refuse(numbers);
    errors.throw_if_any();
    take_style(*figure, comparison.node, scene.film.style);
    return std::move(*figure);
}

SetFile load_figure_set(const fs::path& path, PanelKinds kinds,
                        const std::vector<std::string>& formats) {
    Errors errors;
    const auto source = std::make_shared<Source>();
    auto root = read_yaml_file(path, *source, errors);
    if (root && !root->is_mapping())
        errors.add(*source,
                   root->kind == Node::Kind::null ? "the set is empty"
                                                  : "expected a set (a mapping with "
                                                    "`title` and `scenes`)",
                   "list its scenes: `scenes: [first.yaml, second.yaml]`");
    errors.throw_if_any();
    const FixedTable<SetReading> table = set_table(kinds, formats, path);
    check_mapping(root.value(), table.section(), errors);
    SetReading set;
    const Gas no_gas;
    const Run no_run;
    std::vector<NumberInWords> numbers;
    Reading reading{errors, no_gas, no_run, numbers};
    table.read(*root, set, reading);
    refuse(numbers);
    errors.throw_if_any();
    set.text = source->text;
    if (set.formats.empty() && set.figures != nullptr) {
        FigureDefaults defaults;
        figure_defaults_table().read(*set.figures, defaults, reading);
        set.formats = defaults.formats;
    }
    for (SetComparison& comparison : set.comparisons) {
        comparison.source = source;
        if (set.figures != nullptr) add_defaults(comparison.node, *set.figures);
    }
    if (set.style != nullptr || set.figures != nullptr) set.defaults = defaults_of(set, path);
    return set;
}

}  // namespace carom
