// A folder for what is not where it belongs yet; gone with the program, however that ends but by a
// kill.
#pragma once

#include <filesystem>

#include "util/interrupt.h"

namespace carom {

class ScratchFolder {
  public:
    /// In $TMPDIR or /tmp. Throws SystemError.
    ScratchFolder();
    /// Hidden in `folder`, which is made if it is missing; of one that a killed program has left
    /// the next one there gets rid. Throws SystemError.
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
