// A folder for what is on its way to a stream; gone with the program, however that ends but by a
// kill.
#pragma once

#include <filesystem>

namespace carom {

class ScratchFolder {
  public:
    /// In $TMPDIR or /tmp. Throws SystemError.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace carom
