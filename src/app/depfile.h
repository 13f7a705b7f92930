// The files that an output was made from, for make and ninja.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"
#include "scene/scene.h"

namespace carom {

/// `path` as a name in a makefile and in a depfile of ninja. Throws UsageError where neither can
/// hold it: one with a line break.
std::string depfile_name(std::string_view path);

/// The files that a scene was read from: its own (none of standard input), the template of its
/// film, and the scenes that it names.
std::vector<std::string> files_of(const Scene& scene);

/// A rule that says what the outputs are made from.
std::string depfile_rule(std::span<const std::string> outputs, std::span<const std::string> files);

/// --depfile.
Option depfile_option(std::string& path);

}  // namespace carom
