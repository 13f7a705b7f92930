// Large blocks of memory that are reused instead of being returned to the system, which clears
// every page that it grants. For work that allocates blocks of the same sizes again and again.
#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// The large blocks kept for one thread. While a `Collection` is open, the program's malloc
/// (app/allocation.cpp) keeps blocks that the thread frees, and gives them to the same thread
/// again. Must be destroyed by the thread that constructed it. If the thread already has such an
/// object, a second one has no effect.
class KeptBlocks {
  public:
    static constexpr std::size_t least_bytes = std::size_t{1} << 20;  ///< of a large block

    /// While it exists, the KeptBlocks of its thread keep what is freed. The constructor first
    /// frees blocks kept earlier that have not been reused. Has no effect in a thread without
    /// KeptBlocks.
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

    /// Sets the function that frees kept blocks; the default is std::free. The program's malloc,
    /// whose own free() keeps blocks, sets another one. To be called before the first object is
    /// constructed.
    static void free_with(void (*free)(void*)) noexcept;

    /// Returns the KeptBlocks of this thread; null if there are none.
    static KeptBlocks* of_thread() noexcept;

    /// Keeps a block of `bytes` bytes that is about to be freed. Returns false if the caller must
    /// free it, which is always so while no collection is open.
    bool keep(void* block, std::size_t bytes) noexcept;

    /// Returns a kept block with the alignment (a power of two) and room for `bytes` bytes, but not
    /// much more; null if there is none. Its contents are undefined.
    void* take(std::size_t alignment, std::size_t bytes) noexcept;

    /// Frees all kept blocks; returns whether there were any.
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
