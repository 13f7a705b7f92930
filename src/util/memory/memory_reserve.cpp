#include "util/memory/memory_reserve.h"

#include <sys/mman.h>

#include <atomic>
#include <cstddef>
#include <new>

namespace carom {
namespace {

// Libraries allocate far less than this between two of carom's checks: a line of text, a packet.
constexpr std::size_t reserve_bytes = std::size_t{8} << 20;

constinit std::atomic<void*> reserve{nullptr};
constinit std::atomic<bool> ran_out{false};

}  // namespace

void keep_memory_reserve() noexcept {
    if (reserve.load() != nullptr || ran_out.load()) return;
    void* const kept =
        mmap(nullptr, reserve_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (kept != MAP_FAILED) reserve.store(kept);
}

void note_failed_allocation() noexcept {
    ran_out.store(true, std::memory_order_relaxed);
    if (void* const kept = reserve.exchange(nullptr)) munmap(kept, reserve_bytes);
}

void throw_if_memory_ran_out() {
    if (ran_out.load(std::memory_order_relaxed)) throw std::bad_alloc();
}

}  // namespace carom
