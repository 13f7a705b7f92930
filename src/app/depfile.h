// Depfiles: the files that an output was made from, as dependency rules for make and ninja.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"
#include "app/output.h"

namespace carom {

struct Scene;

/// `path`, escaped for makefiles and for the depfiles of ninja. Throws UsageError if it contains a
/// line break, which neither can express.
std::string depfile_name(std::string_view path);

/// The files that a scene was read from: its own file (none if it came from standard input), the
/// template of its film, and the scenes that it names.
std::vector<std::string> files_of(const Scene& scene);

/// A makefile rule by which `outputs` depend on `files`. Files that occur several times are listed
/// once.
std::string depfile_rule(std::span<const std::string> outputs, std::span<const std::string> files);

/// The depfile of output folders in which only files that have changed are rewritten. One file in
/// each folder represents the whole folder.
class FolderRules {
  public:
    /// With an empty path there is no depfile and all calls do nothing. Throws SystemError if the
    /// depfile cannot be written.
    explicit FolderRules(const std::string& depfile);

    /// Adds a rule: `output` is the file that represents a folder, `files` are what the folder was
    /// made from. Each of these also gets an empty rule, so that make does not fail if the file is
    /// removed later. Throws UsageError as depfile_name() does.
    void add(const std::filesystem::path& output, const std::vector<std::string>& files);

    /// To be called when all is made. Sets the modification time of the outputs to now, so that
    /// they are newer than the files although their bytes may not have changed, and gives the
    /// depfile its name. Throws SystemError.
    void commit();

  private:
    std::optional<Output> depfile_;
    std::vector<std::filesystem::path> outputs_;
};

/// --depfile.
Option depfile_option(std::string& path);

}  // namespace carom
