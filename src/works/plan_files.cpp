#include "works/plan_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "util/diagnostics.h"
#include "util/files/input_file.h"
#include "works/plan_folder.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr const char* format_of_summaries = "carom-sweep-summary";

// True also for other plans that are being written.
bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

// Whether a path has the name of a file or folder of a plan; nothing else is ever removed.
bool is_of_plan(const fs::path& path) {
    std::error_code error;
    const std::string name = path.filename().string();
    const bool is_folder = fs::is_directory(path, error);
    if (is_hidden(path)) return true;
    if (is_folder || name == "starts" || name == "chunks")
        return is_folder && (name == "starts" || name == "chunks");
    if (std::ranges::find(names_in_plan, name) != names_in_plan.end()) return true;
    const std::string folder = path.parent_path().filename().string();
    const std::string ending = path.extension().string();
    const bool is_numbered =
        path.stem().string().find_first_not_of("0123456789") == std::string::npos;
    return is_numbered &&
           ((folder == "starts" && ending == ".start") ||
            (folder == "chunks" && (ending == ".chunk" || ending == ".runs" || ending == ".json")));
}

}  // namespace

bool is_from_carom(const Json& contents, const std::string& name) {
    if (!contents.is_object()) return false;
    const Json format = contents.value("format", Json());
    if (name == "plan.json") return format == format_of_plans;
    if (name == "summary.json") return format == format_of_summaries;
    return contents.contains("plan") && contents.contains("chunk");
}

// If the folder holds a plan of carom, names tell which files belong to it. If plan.json is
// missing, for example because a scheduler has removed it, the contents of the JSON files are
// checked.
void refuse_other_files(const fs::path& folder) {
    const auto refuse = [](const fs::path& path) {
        throw UsageError(fmt::format(
            "{} is not a file of a plan; choose another folder, or move it away", path.string()));
    };
    std::error_code error;
    std::vector<fs::path> lists;
    fs::recursive_directory_iterator entry(folder, error), end;
    for (; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (!is_of_plan(path)) refuse(path);
        if (is_hidden(path))
            entry.disable_recursion_pending();
        else if (path.extension() == ".json")
            lists.push_back(path);
    }
    std::error_code unknown;
    if (error && fs::exists(folder, unknown))
        throw UsageError(fmt::format("{}: {}", folder.string(), error.message()));
    if (is_plan(folder)) lists = {folder / "plan.json"};
    for (const fs::path& path : lists)
        if (!is_from_carom(json_in(read_file(StoredFile{folder, path.lexically_relative(folder)},
                                             most_json_bytes)),
                           path.filename().string()))
            refuse(path);
}

void refuse_scenes_in(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& path = entry->path();
        if (is_hidden(path) || (path.extension() != ".yaml" && path.extension() != ".yml"))
            continue;
        throw UsageError(
            fmt::format("{} is not read: the plan in this folder was made from another file; plan "
                        "again from this scene, or move it away",
                        path.string()));
    }
}

}  // namespace carom
