#include "app/depfile.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "runs/own_files.h"
#include "scene/scene.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

std::vector<std::string> each_once(std::span<const std::string> files) {
    std::vector<std::string> found;
    std::set<std::string_view> seen;
    for (const std::string& file : files)
        if (seen.insert(file).second) found.push_back(file);
    return found;
}

}  // namespace

std::string depfile_name(std::string_view path) {
    std::string name;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const char letter = path[i];
        if (letter == '\n' || letter == '\r')
            throw UsageError(
                fmt::format("--depfile: {} has a line break, and neither make nor ninja has a way "
                            "to write it; rename the file",
                            path));
        if (letter == ' ' || letter == '\t' || letter == '#') {
            // Backslashes before such a character would be read as escapes: double them.
            for (std::size_t k = i; k > 0 && path[k - 1] == '\\'; --k) name += '\\';
            name += '\\';
        }
        if (letter == ':') name += '\\';
        if (letter == '$') name += '$';
        name += letter;
    }
    return name;
}

std::vector<std::string> files_of(const Scene& scene) {
    std::vector<std::string> files;
    const SceneSource& source = scene.source;
    if (!source.path.empty() && source.path != "<stdin>") files.push_back(source.path);
    const bool is_own = std::ranges::any_of(
        source.files, [&](const auto& file) { return file.second == source.template_text; });
    if (!is_own && !source.template_text.empty())
        files.push_back(
            (templates_folder() / "films" / (scene.film.template_name + ".yaml")).string());
    for (const auto& [file, text] : source.files) files.push_back(file);
    return files;
}

std::string depfile_rule(std::span<const std::string> outputs, std::span<const std::string> files) {
    std::string rule;
    for (const std::string& output : outputs)
        rule += (rule.empty() ? "" : " ") + depfile_name(output);
    rule += ":";
    for (const std::string& file : each_once(files)) rule += " \\\n  " + depfile_name(file);
    rule += "\n";
    return rule;
}

FolderRules::FolderRules(const std::string& depfile) {
    if (!depfile.empty()) depfile_.emplace(depfile);
}

void FolderRules::add(const std::filesystem::path& output, const std::vector<std::string>& files) {
    if (!depfile_) return;
    std::string rules = depfile_rule(std::vector{output.string()}, files);
    for (const std::string& file : each_once(files)) rules += depfile_name(file) + ":\n";
    depfile_->write(rules);
    outputs_.push_back(output);
}

void FolderRules::commit() {
    if (!depfile_) return;
    for (const std::filesystem::path& output : outputs_) {
        std::error_code error;
        std::filesystem::last_write_time(output, std::filesystem::file_time_type::clock::now(),
                                         error);
        if (error)
            throw_system_error(
                fmt::format("cannot set the time of {}: {}", output.string(), error.message()),
                error.value());
    }
    depfile_->commit();
}

Option depfile_option(std::string& path) {
    return {"--depfile FILE",
            "also write the files that the output was made from, as make and ninja read them",
            &path};
}

}  // namespace carom
