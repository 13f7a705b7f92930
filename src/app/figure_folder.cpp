#include "app/figure_folder.h"

#include <fmt/format.h>

#include <utility>

#include "app/figures_json.h"
#include "app/fingerprint.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_manifest_bytes = 16 << 20;

bool is_there(const fs::path& path) {
    std::error_code error;
    return fs::exists(fs::symlink_status(path, error));
}

std::string_view text_of(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

FigureFolder::FigureFolder(fs::path path, std::string of) : path_(std::move(path)) {
    manifest_.of = of;
    const fs::path file = path_ / manifest_name;
    if (!is_there(file)) return;
    saved_ = read_file(file, most_manifest_bytes);
    auto known = read_manifest(saved_);
    if (!known)
        throw UsageError(
            fmt::format("{}: this is not the list that carom keeps of a folder's figures; choose "
                        "another folder, or move it away",
                        file.string()));
    if (known->of != of)
        throw UsageError(
            fmt::format("{}: this folder holds the figures of {}; choose another one "
                        "for those of {}",
                        path_.string(), known->of, of));
    manifest_ = std::move(*known);
}

bool FigureFolder::is_current(const std::string& file, const std::string& inputs) const {
    const auto known = manifest_.files.find(file);
    return known != manifest_.files.end() && known->second.inputs == inputs &&
           fingerprint_of_file(path_ / file) == known->second.content;
}

std::vector<std::string> FigureFolder::foreign(std::span<const std::string> files) const {
    std::vector<std::string> found;
    for (const std::string& file : files) {
        if (!is_there(path_ / file)) continue;
        const auto known = manifest_.files.find(file);
        if (known == manifest_.files.end() ||
            fingerprint_of_file(path_ / file) != known->second.content)
            found.push_back(file);
    }
    return found;
}

void FigureFolder::write(const std::string& file, std::span<const std::uint8_t> bytes,
                         const std::string& figure, const std::string& inputs) {
    const std::string content = fingerprint(text_of(bytes));
    if (fingerprint_of_file(path_ / file) != content) {
        AtomicFile output(path_ / file);
        output.write(bytes);
        output.commit();
    }
    manifest_.files[file] = {figure, inputs, content};
}

void FigureFolder::write(const std::string& file, std::string_view text, const std::string& figure,
                         const std::string& inputs) {
    write(file, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), figure,
          inputs);
}

void FigureFolder::note(const std::string& file, const std::string& figure,
                        const std::string& inputs) {
    manifest_.files[file] = {figure, inputs, fingerprint_of_file(path_ / file).value_or("")};
}

void FigureFolder::remember(const std::string& figure, WrittenWords words) {
    manifest_.figures[figure] = std::move(words);
}

void FigureFolder::save() {
    std::string text = manifest_json(manifest_);
    if (text == saved_) return;
    AtomicFile file(path_ / manifest_name);
    file.write(text);
    file.commit();
    saved_ = std::move(text);
}

}  // namespace carom
