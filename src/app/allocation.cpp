// The program's malloc, which libraries call too. If the system grants no memory, it releases the
// reserve that the program keeps for this case (util/memory/memory_reserve.h) and tries once more.
// Large blocks that are freed go back to the system or, in threads that encode films, are kept for
// the next encoder (util/memory/kept_blocks.h). This is part of the program, not of the library:
// other programs keep their own malloc. Only with glibc, whose functions may be replaced in this
// way (glibc manual, "Replacing malloc"), and without sanitizers, which replace malloc themselves.
#include <cstdlib>

#if defined(__GLIBC__)

#include <dlfcn.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>

#include "util/memory/kept_blocks.h"
#include "util/memory/memory_reserve.h"

extern "C" {
void* __libc_malloc(std::size_t);  // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

// The next definition of a function in the search order (RTLD_NEXT): that of glibc, or of a library
// that was loaded before it.
template <class Function>
class Next {
  public:
    constexpr Next(const char* name, Function* of_glibc) : name_(name), of_glibc_(of_glibc) {}

    Function* get() noexcept {
        Function* found = found_.load(std::memory_order_acquire);
        if (found != nullptr) return found;
        static thread_local bool is_looking = false;
        if (is_looking) return of_glibc_;  // dlsym itself allocates
        is_looking = true;
        found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
        is_looking = false;
        if (found == nullptr) found = of_glibc_;
        found_.store(found, std::memory_order_release);
        return found;
    }

  private:
    const char* name_;
    Function* of_glibc_;
    std::atomic<Function*> found_{nullptr};
};

constinit Next<void*(std::size_t)> next_malloc("malloc", __libc_malloc);
constinit Next<void*(std::size_t, std::size_t)> next_calloc("calloc", __libc_calloc);
constinit Next<void*(void*, std::size_t)> next_realloc("realloc", __libc_realloc);
constinit Next<void*(std::size_t, std::size_t)> next_memalign("memalign", __libc_memalign);
constinit Next<void(void*)> next_free("free", __libc_free);

// Calls `allocate`. If it fails, tries again after freeing the thread's kept blocks, and finally
// after releasing the reserve.
template <class Allocate>
void* with_reserve(const Allocate& allocate) noexcept {
    if (void* const made = allocate()) return made;
    if (auto* const kept = carom::KeptBlocks::of_thread(); kept != nullptr && kept->release())
        if (void* const made = allocate()) return made;
    carom::note_failed_allocation();
    return allocate();
}

void* kept_block(std::size_t alignment, std::size_t size) noexcept {
    auto* const kept = carom::KeptBlocks::of_thread();
    return kept != nullptr ? kept->take(std::max<std::size_t>(alignment, 1), size) : nullptr;
}

// By default, once a block of up to 32 MB has been freed, glibc keeps blocks of that size for later
// use, fragmented so that later requests do not fit. The encoder of each segment of a film
// allocates about 70 MB in blocks of a few megabytes: with the default, a film of many segments
// took 90 MB more.
[[gnu::constructor(101)]] void give_back_large_blocks() {
    constexpr auto large = static_cast<int>(carom::KeptBlocks::least_bytes);
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, 4 * large);
    carom::KeptBlocks::free_with([](void* block) { next_free.get()(block); });
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
    if (void* const kept = kept_block(alignof(std::max_align_t), size)) return kept;
    return with_reserve([=] { return next_malloc.get()(size); });
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return with_reserve([=] { return next_calloc.get()(count, size); });
}

void* realloc(void* old, std::size_t size) noexcept {
    if (old != nullptr && size == 0) return next_realloc.get()(old, size);  // frees: null is right
    return with_reserve([=] { return next_realloc.get()(old, size); });
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    if (void* const kept = kept_block(alignment, size)) return kept;
    return with_reserve([=] { return next_memalign.get()(alignment, size); });
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return memalign(alignment, size);
}

int posix_memalign(void** made, std::size_t alignment, std::size_t size) noexcept {
    const bool is_power = alignment != 0 && (alignment & (alignment - 1)) == 0;
    if (!is_power || alignment % sizeof(void*) != 0) return EINVAL;
    void* const found = memalign(alignment, size);
    if (found == nullptr) return ENOMEM;
    *made = found;
    return 0;
}

void free(void* block) noexcept {
    auto* const kept = block != nullptr ? carom::KeptBlocks::of_thread() : nullptr;
    if (kept != nullptr && kept->keep(block, malloc_usable_size(block))) return;
    next_free.get()(block);
}
}
#endif
