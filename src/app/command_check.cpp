// carom check: whether scenes are valid, what they are, and what they will cost.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/check_json.h"
#include "app/check_table.h"
#include "app/command.h"
#include "app/output.h"
#include "app/resources.h"
#include "app/scene_facts.h"
#include "panels/text_panel.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

struct CheckArguments : SceneOptions {
    std::vector<std::string> scenes;
    bool json = false;
};

// A scene that says nothing of a film, and of which none can be made, is good for its physics.
std::pair<Scene, bool> loaded(const std::string& path, const Overrides& overrides) {
    const std::filesystem::path templates = templates_folder();
    try {
        return {load_scene(path, templates, overrides, Wanted::film), true};
    } catch (const SceneError& error) {
        try {
            return {load_scene(path, templates, overrides, Wanted::physics), false};
        } catch (const SceneError&) {
            throw error;
        }
    }
}

CheckedScene checked(const std::string& path, const CheckArguments& arguments) {
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
        invalid += scene.scene ? 0 : 1;
    }
    if (invalid == 0) return;
    if (!json) throw SceneError(std::move(errors));
    throw UsageError(fmt::format("{} of {} {} not valid", invalid, scenes.size(),
                                 scenes.size() == 1 ? "scene is" : "scenes are"));
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

void add_check(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("check", "whether scenes are valid, and what they will cost");
    const auto arguments = std::make_shared<CheckArguments>();
    command.add_option("scenes", arguments->scenes, "scene files; - for standard input")
        ->required();
    command.add_flag("--json", arguments->json, "for programs: a list with an object per scene");
    add_scene_options(command, *arguments);
    add_picture_options(command, *arguments);
    command.callback([arguments] { check_scenes(*arguments); });
}

}  // namespace carom
