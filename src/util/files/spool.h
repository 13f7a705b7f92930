// A store for pieces of bytes until they are needed: in memory while they are few, beyond that in a
// temporary file, so that the use of memory is bounded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "util/files/scratch_file.h"

namespace carom {

class Archive;

/// Not thread-safe; several threads may use it one after another.
class Spool {
  public:
    /// Keeps `most_in_memory` bytes in memory, and more only if there is no room for them in a
    /// temporary file (scratch_file.h).
    explicit Spool(std::size_t most_in_memory) : most_in_memory_(most_in_memory) {}

    void add(std::string piece);

    /// Returns the number of pieces.
    std::size_t size() const { return pieces_.size(); }

    /// Returns the k-th piece added, from 0. Throws SystemError if it cannot be read back.
    std::string piece(std::size_t k) const;

    /// Writes all pieces to an archive, or reads pieces from it and adds them.
    void archive(Archive& archive);

  private:
    struct Piece {
        std::string bytes;        ///< if it is in memory
        std::int64_t place = -1;  ///< otherwise its place in the file
        std::size_t length = 0;
    };

    std::size_t most_in_memory_, in_memory_ = 0;
    std::vector<Piece> pieces_;
    std::unique_ptr<ScratchFile> file_;  ///< none until it is needed
};

}  // namespace carom
