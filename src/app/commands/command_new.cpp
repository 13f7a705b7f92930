// carom new: a scene to start from, commented or made from another.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <optional>
#include <system_error>

#include "app/command.h"
#include "app/report/schema_json.h"
#include "panels/registry.h"
#include "runs/own_files.h"
#include "scene/manual/starter.h"
#include "scene/scene.h"
#include "scene/sets/set_reading.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/links.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct NewArguments {
    std::string name;
    std::string from;
    bool quiet = false;
};

fs::path named(const std::string& name) {
    const fs::path path = name;
    if (path.filename().empty() || path.filename() == "." || path.filename() == "..")
        throw UsageError(fmt::format("new {}: expected the name of a file", name));
    if (path.extension() == ".yaml" || path.extension() == ".yml") return path;
    return name + ".yaml";
}

constexpr const char* schema_name = "scene.schema.json";

// The relative path by which a scene file refers to the schema, so that it stays valid when its
// folder is moved or given to others: in the library the schema of the library, elsewhere the one
// next to the file.
std::string schema_reference(const fs::path& file) {
    std::error_code error;
    const fs::path way = fs::relative(library_folder(), fs::absolute(file).parent_path(), error);
    const bool is_in_library = !error && std::ranges::all_of(way, [](const fs::path& step) {
        return step == ".." || step == ".";
    });
    return is_in_library ? (way / schema_name).lexically_normal().string() : schema_name;
}

// The scenes in all folders of the library, by name, without figure sets.
std::map<std::string, fs::path> library() {
    std::map<std::string, fs::path> scenes;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(library_folder(), error))
        if (entry.path().extension() == ".yaml" && !is_figure_set(entry.path()))
            scenes.emplace(entry.path().stem().string(), entry.path());
    return scenes;
}

// A file, or a scene of the library by its name.
fs::path source(const std::string& from) {
    std::error_code error;
    if (from == standard_input || fs::exists(from, error)) return from;
    const std::map<std::string, fs::path> all = library();
    if (const auto found = all.find(from); found != all.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, path] : all) names.push_back(name);
    const std::string scenes = fmt::format("its scenes are {}", fmt::join(names, ", "));
    throw UsageError(
        fmt::format("--from {}: there is no such file, and no such scene in the library; {}", from,
                    spelling_hint(from, names, scenes)));
}

std::string text_for(const NewArguments& arguments, const fs::path& file) {
    const std::string schema = schema_reference(file);
    if (arguments.from.empty())
        return starter_scene(panel_kinds(), schema, file.filename().string());
    // Mistakes in that scene are reported at their place in its file.
    const Scene scene = load_scene(source(arguments.from), scene_resources());
    return starter_from(scene.source.text, schema);
}

// Neither file replaces another, not even one that a process creates at this moment. The schema is
// removed again if the scene cannot get its name.
void write_both(const fs::path& file, const std::string& text) {
    AtomicFile scene(file, Earlier::kept);
    scene.write(text);
    const fs::path beside = file.parent_path() / schema_reference(file);
    std::optional<AtomicFile> schema;  // an existing one is left as it is
    if (!is_taken(beside)) schema.emplace(beside, Earlier::kept).write(scene_schema_json());
    scene.settle();
    const MustCleanUp together;
    if (schema) schema->commit();
    try {
        scene.commit();
    } catch (...) {
        std::error_code error;
        if (schema) fs::remove(schema->path(), error);
        throw;
    }
}

void make_scene(const NewArguments& arguments) {
    const fs::path file = named(arguments.name);
    if (is_taken(file)) refuse_existing(file);
    const std::string text = text_for(arguments, file);
    load_scene_text(text, file.string(), scene_resources());  // a template beside the other one
    write_both(file, text);
    if (!arguments.quiet)
        fmt::print("{0}: a scene; `carom render {0}` makes its film\n", printable(file.string()));
}

CommandText new_text() {
    return {{"carom new NAME [--from SCENE]"},
            "Writes NAME.yaml, a scene that renders as it is, with a comment on every key, and "
            "beside it scene.schema.json, with which editors complete keys and underline mistakes. "
            "An existing file is never replaced.",
            {{"carom new mine", "writes mine.yaml"},
             {"carom new echo --from time-reversal", "starts from a scene that comes with carom"},
             {"carom new other --from scenes/mixed-masses.yaml", "starts from a file"}}};
}

}  // namespace

Command new_command() {
    const auto arguments = std::make_shared<NewArguments>();
    return {"new",
            "write a commented scene to start from",
            {{"name", "the file to write: NAME.yaml", &arguments->name},
             {"--from SCENE",
              "start from another scene: a file, - for standard input, or the name of one that "
              "comes with carom",
              &arguments->from},
             {"--quiet", "print no report", &arguments->quiet}},
            [arguments] { make_scene(*arguments); },
            new_text()};
}

}  // namespace carom
