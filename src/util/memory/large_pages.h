// An allocator that asks the system to place large arrays in large memory pages. Otherwise, where
// millions of small records are visited in random order, most of the time goes into translating
// addresses (TLB misses). It is only a request: everything also works without large pages, but more
// slowly.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace carom {

template <typename T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <typename U>
    LargePages(const LargePages<U>&) {}

    /// Throws std::bad_alloc.
    T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T) - page) throw std::bad_alloc();
        const std::size_t bytes = count * sizeof(T);
        if (bytes < page / 2)
            return static_cast<T*>(::operator new(bytes, std::align_val_t(alignment)));
        void* memory = ::operator new(bytes, std::align_val_t(page));
#ifdef MADV_HUGEPAGE
        madvise(memory, bytes / page * page, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) {
        const bool large = count * sizeof(T) >= page / 2;
        ::operator delete(memory, std::align_val_t(large ? page : alignment));
    }

    template <typename U>
    bool operator==(const LargePages<U>&) const {
        return true;
    }

  private:
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::size_t alignment = alignof(T) > 16 ? alignof(T) : 16;
};

/// A std::vector whose memory, when large, is in large pages.
template <typename T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace carom
