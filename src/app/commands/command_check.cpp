// carom check: whether scenes and figure sets are valid, what they are, and what they will cost.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/command.h"
#include "app/figures/figure_pages.h"
#include "app/figures/set_loading.h"
#include "app/output.h"
#include "app/report/check_facts.h"
#include "app/report/scene_facts.h"
#include "app/resources.h"
#include "panels/words/text_panel.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

struct CheckArguments : SceneOptions {
    std::vector<std::string> scenes;
    bool json = false;
};

// A scene that says nothing of a film, and of which none can be made, is good for its physics.
std::pair<Scene, bool> loaded(const std::string& path, const Overrides& overrides) {
    const SceneResources resources = scene_resources();
    try {
        return {load_scene(path, resources, overrides, Wanted::film), true};
    } catch (const SceneError& error) {
        try {
            return {load_scene(path, resources, overrides, Wanted::physics), false};
        } catch (const SceneError&) {
            throw error;
        }
    }
}

// With all its scenes, figures and pages.
CheckedScene checked_set(const std::string& path, const CheckArguments& arguments) {
    CheckedScene found{
        .path = path, .scene = {}, .facts = {}, .errors = {}, .is_set = true, .set = {}};
    try {
        FigureSet set = set_of_file(path, overrides_of(arguments));
        for (const SetPart& part : set.parts) refuse_long_words(part.scene);
        for (const PageTemplate& page : set.pages) page_text(set, page, {}, {});
        refuse_same_names(set);
        found.set = std::move(set);
    } catch (const SceneError& error) {
        found.errors = error.diagnostics();
    } catch (const UsageError& error) {
        Diagnostic& told = found.errors.emplace_back();
        told.span.file = path;
        told.message = error.what();
    }
    return found;
}

CheckedScene checked(const std::string& path, const CheckArguments& arguments) {
    if (path != standard_input && is_figure_set(path)) return checked_set(path, arguments);
    CheckedScene found{
        .path = path == standard_input ? "<stdin>" : path, .scene = {}, .facts = {}, .errors = {}};
    try {
        auto [scene, has_film] = loaded(path, overrides_of(arguments));
        if (has_film) refuse_long_words(scene);
        found.facts = facts_of(scene, has_film, threads_of(arguments));
        found.scene = std::move(scene);
    } catch (const SceneError& error) {
        found.errors = error.diagnostics();
    }
    return found;
}

// The errors themselves go to standard error with the exit code; in JSON they stand in it.
void refuse_invalid(const std::vector<CheckedScene>& scenes, bool json) {
    std::vector<Diagnostic> errors;
    std::size_t invalid = 0;
    for (const CheckedScene& scene : scenes) {
        errors.insert(errors.end(), scene.errors.begin(), scene.errors.end());
        invalid += scene.is_valid() ? 0 : 1;
    }
    if (invalid == 0) return;
    if (!json) throw SceneError(std::move(errors));
    const bool any_set = std::ranges::any_of(scenes, &CheckedScene::is_set);
    throw UsageError(fmt::format("{} of {} {}{} not valid", invalid, scenes.size(),
                                 any_set ? "file" : "scene", scenes.size() == 1 ? " is" : "s are"));
}

void check_scenes(const CheckArguments& arguments) {
    refuse_second_standard_input(arguments.scenes);
    std::vector<CheckedScene> scenes;
    for (const std::string& path : arguments.scenes) scenes.push_back(checked(path, arguments));
    if (arguments.json)
        Output("-").write(check_json(scenes));
    else if (!arguments.quiet)
        Output("-").write(check_table(scenes));
    refuse_invalid(scenes, arguments.json);
}

}  // namespace

Command check_command() {
    const auto arguments = std::make_shared<CheckArguments>();
    CheckArguments& its = *arguments;
    return {
        "check", "whether scenes and sets are valid, and what they will cost",
        joined({{{"scenes", "files of scenes and of figure sets; - for a scene from standard input",
                  &its.scenes},
                 {"--json", "for programs: a list with an object per file", &its.json}},
                scene_options(its),
                picture_options(its)}),
        [arguments] { check_scenes(*arguments); }};
}

}  // namespace carom
