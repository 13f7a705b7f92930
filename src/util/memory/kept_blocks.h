// Large blocks of memory that are used once more instead of going back to the system, which clears
// every page that it grants. For work that asks for the same blocks again and again.
#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// The large blocks of one thread. The program's malloc (app/allocation.cpp) keeps what the thread
/// frees while a `Collection` is open, and gives it to the same thread again. Must be destroyed by
/// the thread that made it. Where a thread has one already, a second does nothing.
class KeptBlocks {
  public:
    static constexpr std::size_t least_bytes = std::size_t{1} << 20;  ///< of a large block

    /// While it lives, those of its thread keep what is freed; what they kept before and nobody has
    /// asked for is freed first. Does nothing in a thread that has none.
    class Collection {
      public:
        Collection() noexcept;
        Collection(const Collection&) = delete;
        Collection& operator=(const Collection&) = delete;
        ~Collection();
    };

    KeptBlocks() noexcept;
    KeptBlocks(const KeptBlocks&) = delete;
    KeptBlocks& operator=(const KeptBlocks&) = delete;
    ~KeptBlocks();  ///< frees what is kept

    /// The function by which kept blocks are freed: std::free, unless told otherwise, which the
    /// program's malloc does, whose own free keeps blocks. To be called before the first is made.
    static void free_with(void (*free)(void*)) noexcept;

    /// Those of this thread, if any.
    static KeptBlocks* of_thread() noexcept;

    /// Keeps a block of so many bytes that is to be freed; false if it must be freed, as always
    /// while no collection is open.
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
    bool is_collecting_ = false;
};

}  // namespace carom
