#include "app/resources.h"

#include "panels/registry.h"
#include "util/diagnostics.h"

namespace carom {

std::filesystem::path templates_folder() {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (fs::path folder = program.parent_path(); !error; folder = folder.parent_path()) {
        for (const char* place : {"share/carom/templates", "templates"})
            if (fs::is_directory(folder / place / "films")) return folder / place;
        if (folder == folder.root_path()) break;
    }
    throw SystemError("cannot find carom's templates folder near " + program.string());
}

SceneResources scene_resources() { return {templates_folder(), panel_kinds()}; }

Scene scene_from(const SceneSource& source, const Overrides& more) {
    SceneResources resources = scene_resources();
    resources.files = source.files;
    resources.is_classroom = source.is_held_to_classroom;
    Overrides overrides = source.overrides;
    overrides.insert(overrides.end(), more.begin(), more.end());
    return load_scene_text(source.text, source.path, resources, overrides);
}

std::filesystem::path library_folder() { return templates_folder().parent_path() / "scenes"; }

}  // namespace carom
