// The files that an output was made from, for make and ninja.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"
#include "app/output.h"
#include "scene/scene.h"

namespace carom {

/// `path` as a name in a makefile and in a depfile of ninja. Throws UsageError where neither can
/// hold it: one with a line break.
std::string depfile_name(std::string_view path);

/// The files that a scene was read from: its own (none of standard input), the template of its
/// film, and the scenes that it names.
std::vector<std::string> files_of(const Scene& scene);

/// A rule that says what the outputs are made from. A file that comes again is written once.
std::string depfile_rule(std::span<const std::string> outputs, std::span<const std::string> files);

/// The depfile of folders whose files are made anew only where they have changed. One file in a
/// folder stands for all that is in it.
class FolderRules {
  public:
    /// An empty path: no depfile, and nothing is done. Throws SystemError when it cannot be
    /// written.
    explicit FolderRules(const std::string& depfile);

    /// The file that stands for a folder, and what the folder was made from. A file that is gone
    /// later is no mistake for make. Throws UsageError as depfile_name().
    void add(const std::filesystem::path& output, const std::vector<std::string>& files);

    /// When all is made: the outputs are newer than the files, also where their bytes have not
    /// changed, and the depfile gets its name. Throws SystemError.
    void commit();

  private:
    std::optional<Output> depfile_;
    std::vector<std::filesystem::path> outputs_;
};

/// --depfile.
Option depfile_option(std::string& path);

}  // namespace carom
