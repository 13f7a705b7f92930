// Pieces of bytes that wait for their turn: in memory as long as they are few, in a temporary file
// beyond that, so that what waits takes a bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "util/files/scratch_file.h"

namespace carom {

class Archive;

/// Not for sharing between threads; one after the other may use it.
class Spool {
  public:
    /// Keeps `most_in_memory` bytes in memory, and more only where no temporary file has room for
    /// them (scratch_file.h).
    explicit Spool(std::size_t most_in_memory) : most_in_memory_(most_in_memory) {}

    void add(std::string piece);

    /// The number of pieces.
    std::size_t size() const { return pieces_.size(); }

    /// The piece that was added k-th. Throws SystemError where it cannot be read back.
    std::string piece(std::size_t k) const;

    /// Writes all pieces, or adds those that were written.
    void archive(Archive& archive);

  private:
    struct Piece {
        std::string bytes;        ///< if they are in memory
        std::int64_t place = -1;  ///< else in the file, from here on
        std::size_t length = 0;
    };

    std::size_t most_in_memory_, in_memory_ = 0;
    std::vector<Piece> pieces_;
    std::unique_ptr<ScratchFile> file_;  ///< none until it is needed
};

}  // namespace carom
