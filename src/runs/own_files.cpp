#include "runs/own_files.h"

#ifdef __linux__
#include <sys/auxv.h>
#endif

#include <system_error>

#include "draw/text.h"
#include "panels/registry.h"
#include "panels/theme/style_faults.h"
#include "scene/scene.h"
#include "util/diagnostics.h"

namespace carom {

namespace {

namespace fs = std::filesystem;

// The file that the program was started from; empty if the system does not tell.
fs::path program_file() {
    std::error_code error;
    fs::path program = fs::read_symlink("/proc/self/exe", error);
#ifdef __linux__
    if (error) {  // there is no /proc
        const auto* const started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
        if (started != nullptr) program = fs::canonical(started, error);
    }
#endif
    return error ? fs::path() : program;
}

}  // namespace

// The folder of the program cannot change while it runs, but a relative path to it can.
std::filesystem::path templates_folder() {
    static const fs::path program = program_file();
    if (program.empty())
        throw SystemError(
            "cannot find the program's own file, and with it carom's templates folder: /proc is "
            "not mounted");
    std::error_code error;
    for (fs::path folder = program.parent_path();; folder = folder.parent_path()) {
        for (const char* place : {"share/carom/templates", "templates"})
            if (fs::is_directory(folder / place / "films", error)) return folder / place;
        if (folder == folder.root_path()) break;
    }
    throw SystemError("cannot find carom's templates folder near " + program.string());
}

SceneResources scene_resources() {
    return {.templates = templates_folder(),
            .panels = panel_kinds(),
            .styles = {.families = installed_families, .faults = faults_of}};
}

Scene scene_from(const SceneSource& source, const Overrides& more) {
    SceneResources resources = scene_resources();
    resources.files = source.files;
    resources.is_classroom = source.is_held_to_classroom;
    Overrides overrides = source.overrides;
    overrides.insert(overrides.end(), more.begin(), more.end());
    return load_scene_text(source.text, source.path, resources, overrides);
}

std::filesystem::path library_folder() { return templates_folder().parent_path() / "scenes"; }

std::filesystem::path manual_folder() {
    const fs::path data = templates_folder().parent_path();
    return data.filename() == "carom" && data.parent_path().filename() == "share"
               ? data.parent_path() / "doc/carom"
               : data;
}

}  // namespace carom
