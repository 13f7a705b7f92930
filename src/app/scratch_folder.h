// A folder for files that are not at their final place yet. It is removed when the program ends in
// any way but by a kill signal.
#pragma once

#include <filesystem>

#include "util/interrupt.h"

namespace carom {

class ScratchFolder {
  public:
    /// In $TMPDIR or /tmp. Throws SystemError.
    ScratchFolder();
    /// A hidden folder in `folder`, which is created if it is missing. One that a killed program
    /// left behind is removed when the next one is created there. Throws SystemError.
    explicit ScratchFolder(const std::filesystem::path& folder);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    MustCleanUp exists_;
    std::filesystem::path path_;
    int lock_ = -1;
};

}  // namespace carom
