#include "util/memory/kept_blocks.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace carom {
namespace {

constinit thread_local KeptBlocks* current = nullptr;
using Free = void (*)(void*);
constinit Free free_block = std::free;

}  // namespace

KeptBlocks::KeptBlocks() noexcept {
    if (current == nullptr) current = this;
}

KeptBlocks::Collection::Collection() noexcept {
    if (current == nullptr) return;
    current->release();
    current->is_collecting_ = true;
}

KeptBlocks::Collection::~Collection() {
    if (current != nullptr) current->is_collecting_ = false;
}

KeptBlocks::~KeptBlocks() {
    release();
    if (current == this) current = nullptr;
}

void KeptBlocks::free_with(void (*free)(void*)) noexcept { free_block = free; }

KeptBlocks* KeptBlocks::of_thread() noexcept { return current; }

bool KeptBlocks::keep(void* block, std::size_t bytes) noexcept {
    if (!is_collecting_ || bytes < least_bytes || count_ == blocks_.size()) return false;
    blocks_[count_++] = {block, bytes};
    return true;
}

void* KeptBlocks::take(std::size_t alignment, std::size_t bytes) noexcept {
    if (bytes < least_bytes) return nullptr;
    constexpr std::size_t page = 4096;
    // For an aligned block, glibc allocates as much more as the alignment; the unused rest stays
    // behind the block.
    const std::size_t most = bytes + 2 * page + (alignment > page ? alignment : 0);
    Block* const end = blocks_.data() + count_;
    Block* const found = std::find_if(blocks_.data(), end, [&](const Block& block) {
        return block.bytes >= bytes && block.bytes <= most &&
               reinterpret_cast<std::uintptr_t>(block.begin) % alignment == 0;
    });
    if (found == end) return nullptr;
    void* const begin = found->begin;
    *found = blocks_[--count_];
    return begin;
}

bool KeptBlocks::release() noexcept {
    const bool are_any = count_ > 0;
    while (count_ > 0) free_block(blocks_[--count_].begin);
    return are_any;
}

}  // namespace carom
