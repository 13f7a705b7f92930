// Large blocks of memory that are used once more instead of going back to the system, which clears
// every page that it grants. For work that asks for the same blocks again and again.
#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// While one lives, the program's malloc (app/allocation.cpp) gives large blocks that its thread
/// has freed to the same thread again. Of one thread: it must be destroyed by the thread that made
/// it. Where one lives already, a second does nothing.
class KeptBlocks {
  public:
    static constexpr std::size_t least_bytes = std::size_t{1} << 20;  ///< of a large block

    KeptBlocks() noexcept;
    KeptBlocks(const KeptBlocks&) = delete;
    KeptBlocks& operator=(const KeptBlocks&) = delete;
    ~KeptBlocks();  ///< frees what is kept

    /// With what all of them free, std::free unless the program's own free keeps blocks here. To be
    /// called before the first is made.
    static void free_with(void (*free)(void*)) noexcept;

    /// Those of this thread, if any.
    static KeptBlocks* of_thread() noexcept;

    /// Keeps a block of so many bytes that is to be freed; false if it must be freed.
    bool keep(void* block, std::size_t bytes) noexcept;

    /// A kept block with room for so many bytes, not much more, and this alignment, a power of two;
    /// none: null. Its contents are undefined.
    void* take(std::size_t alignment, std::size_t bytes) noexcept;

    /// Frees what is kept; whether that was anything.
    bool release() noexcept;

  private:
    struct Block {
        void* begin;
        std::size_t bytes;
    };
    std::array<Block, 64> blocks_;  ///< the first count_ of them
    std::size_t count_ = 0;
};

}  // namespace carom
