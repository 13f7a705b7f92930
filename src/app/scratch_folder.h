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
    /// At `path`, in place of what an earlier one left there; to be made by what writes into it.
    explicit ScratchFolder(std::filesystem::path path);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    void clear() const;

    MustCleanUp exists_;
    std::filesystem::path path_;
};

}  // namespace carom
