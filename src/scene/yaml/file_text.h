// Reading the text of a scene, a template or a figure set from a file.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "scene/yaml/node.h"

namespace carom {

/// A hint for those who have no scene yet.
inline constexpr const char* how_to_start = "`carom new NAME` writes a scene to start from";

/// Returns the text of a stream, up to one byte more than a file may have, so that the reader then
/// refuses it as too long. Reports an error and returns nothing if the stream cannot be read.
/// Throws Interrupted.
std::optional<std::string> text_of(std::FILE& file, const Source& name, Errors& errors);

/// Returns the text of the regular file at `path` in the same way; other files are refused. From
/// then on no output may replace that file: throws UsageError if an output to it has already been
/// opened (util/files/one_use_paths.h).
std::optional<std::string> file_text(const std::filesystem::path& path, const Source& name,
                                     Errors& errors);

/// Returns whether a text is a bare file name, without a folder, and not that of a hidden file.
bool is_plain_name(const std::string& name);

}  // namespace carom
