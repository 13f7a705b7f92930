#include "scene/yaml/file_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "scene/limits.h"
#include "util/files/input_file.h"
#include "util/files/one_use_paths.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {

namespace fs = std::filesystem;

namespace {

// Returns the names of the YAML files in a folder, in alphabetical order.
std::vector<std::string> yaml_files_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, failed), end;
         !failed && entry != end; entry.increment(failed))
        if (const fs::path& file = entry->path();
            file.extension() == ".yaml" || file.extension() == ".yml")
            names.push_back(file.filename().string());
    std::ranges::sort(names);
    return names;
}

std::string instance_in(const fs::path& folder) {
    const std::vector<std::string> names = yaml_files_in(folder);
    return names.empty() ? "" : fmt::format(", for instance {}", (folder / names[0]).string());
}

// Returns a hint that names an existing file whose name is like that of one that does not exist.
std::string similar_file(const fs::path& path) {
    const fs::path folder = path.parent_path();
    const std::string wanted = path.filename().string();
    const std::vector<std::string> names = yaml_files_in(folder);
    for (const std::string& name : names)
        if (fs::path(name).stem() == path.stem() || fs::path(name).stem() == wanted)
            return fmt::format("did you mean {}?", (folder / name).string());
    const auto near = nearest_spelling(wanted, names);
    if (near) return fmt::format("did you mean {}?", (folder / *near).string());
    const std::string ending = path.extension().string();
    if (path.empty()) return "give the name of a file";
    if (!ending.empty() && ending != ".yaml" && ending != ".yml") return "";  // no scene
    return names.empty() ? how_to_start : "name a scene" + instance_in(folder);
}

}  // namespace

// Reads up to one byte over the limit, so that the reader then refuses the text.
std::optional<std::string> text_of(std::FILE& file, const Source& name, Errors& errors) {
    constexpr std::size_t block = 65'536;
    const std::size_t most = most_file_bytes.count() + 1;
    std::string text;
    while (text.size() < most) {
        const std::size_t size = text.size(), wanted = std::min(block, most - size);
        text.resize(size + wanted);
        const std::size_t got = std::fread(text.data() + size, 1, wanted, &file);
        text.resize(size + got);
        if (got == wanted) continue;
        if (std::ferror(&file) == 0 || errno != EINTR) break;
        throw_if_interrupted();  // a terminal or pipe that sends nothing must not hold Ctrl-C
        std::clearerr(&file);
    }
    if (std::ferror(&file) == 0) return text;
    errors.add(name, "cannot be read: " + std::generic_category().message(errno), "");
    return std::nullopt;
}

// A failure that may pass is no mistake of the user.
std::optional<std::string> file_text(const fs::path& path, const Source& name, Errors& errors) {
    InputFile file(path);
    if (file.is_open()) {
        keep_source(path);
        return file.rest(static_cast<std::int64_t>(most_file_bytes.count()));
    }
    if (file.may_pass()) file.require_open();
    std::string hint;
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (fs::is_directory(status))
        hint = "name a file in it" + instance_in(path);
    else if (status.type() == fs::file_type::not_found)
        hint = similar_file(path);
    errors.add(name, "cannot be read: " + file.problem(), hint);
    return std::nullopt;
}

bool is_plain_name(const std::string& name) {
    return name.find_first_of("/\\") == std::string::npos && !name.starts_with('.');
}

}  // namespace carom
