// The text of a scene, a template or a set, as it lies in a file.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "scene/yaml/node.h"

namespace carom {

/// All of a stream up to one byte over the limit of a file, which the reader then refuses;
/// nothing, with an error, if it cannot be read. Throws Interrupted.
std::optional<std::string> text_of(std::FILE& file, const Source& name, Errors& errors);

/// The same of the file at `path`, if it is an ordinary one. No output takes its place from then
/// on: throws UsageError where one is about to (util/files/one_use_paths.h).
std::optional<std::string> file_text(const std::filesystem::path& path, const Source& name,
                                     Errors& errors);

/// Whether a name is that of a file in some folder, and no path; not of a hidden file.
bool is_plain_name(const std::string& name);

}  // namespace carom
