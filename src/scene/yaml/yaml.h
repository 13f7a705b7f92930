// From YAML text to nodes, strictly: what YAML leaves open is refused here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "scene/yaml/node.h"

namespace carom {

/// Reads the text of `source` from byte `begin` as one document. Adds an error for everything that
/// is no plain, unambiguous YAML (bytes that are not UTF-8, control characters, duplicate keys,
/// tags, several documents, a limit exceeded). Nothing when that leaves no tree; a null node for
/// an empty document.
std::optional<Node> read_yaml(const Source& source, Errors& errors, std::size_t begin = 0);

/// The same of the file at `path`, which becomes the name and the text of `source`; nothing, with
/// an error, if it cannot be read.
std::optional<Node> read_yaml_file(const std::filesystem::path& path, Source& source,
                                   Errors& errors);

}  // namespace carom
