// Parses YAML text into nodes, strictly: where YAML is ambiguous, the text is refused.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "scene/yaml/node.h"

namespace carom {

/// Parses the text of `source` from byte `begin` as one document. Adds an error for everything that
/// is not plain, unambiguous YAML (bytes that are not UTF-8, control characters, duplicate keys,
/// tags, several documents, a limit exceeded). Returns nothing if the errors leave no tree, and a
/// null node for an empty document.
std::optional<Node> read_yaml(const Source& source, Errors& errors, std::size_t begin = 0);

/// Parses the file at `path` in the same way, and stores the path and the text in `source`. Adds an
/// error and returns nothing if the file cannot be read.
std::optional<Node> read_yaml_file(const std::filesystem::path& path, Source& source,
                                   Errors& errors);

}  // namespace carom
