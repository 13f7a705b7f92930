#include "util/memory/kept_blocks.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <thread>
#include <vector>

using namespace carom;

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

void* block_of(std::size_t bytes, std::size_t alignment = 64) {
    void* block = nullptr;
    REQUIRE(posix_memalign(&block, alignment, bytes) == 0);
    return block;
}

}  // namespace

TEST_CASE("a kept block is given to a request of its size once") {
    KeptBlocks kept;
    const KeptBlocks::Collection collection;
    void* const block = block_of(4 * mebibyte);
    CHECK(kept.take(16, 4 * mebibyte) == nullptr);
    REQUIRE(kept.keep(block, 4 * mebibyte));
    CHECK(kept.take(16, 4 * mebibyte + 1) == nullptr);  // it is too small
    CHECK(kept.take(16, 3 * mebibyte) == nullptr);      // too much would be unused
    CHECK(kept.take(16, 4 * mebibyte - 100) == block);
    CHECK(kept.take(16, 4 * mebibyte - 100) == nullptr);
    std::free(block);
}

TEST_CASE("a kept block is given where its address has the alignment that is asked for") {
    KeptBlocks kept;
    const KeptBlocks::Collection collection;
    constexpr std::size_t alignment = 2 * mebibyte;
    auto* const whole = static_cast<std::uint8_t*>(block_of(8 * mebibyte, alignment));
    REQUIRE(kept.keep(whole + 64, 4 * mebibyte));
    CHECK(kept.take(alignment, 4 * mebibyte) == nullptr);
    REQUIRE(kept.take(64, 4 * mebibyte) == whole + 64);
    REQUIRE(kept.keep(whole, 5 * mebibyte));
    CHECK(kept.take(64, 4 * mebibyte) == nullptr);
    REQUIRE(kept.take(alignment, 4 * mebibyte) == whole);  // what lies behind was for its alignment
    std::free(whole);
}

TEST_CASE("small blocks and more than its room are not kept") {
    KeptBlocks kept;
    const KeptBlocks::Collection collection;
    std::uint8_t small = 0;
    CHECK_FALSE(kept.keep(&small, mebibyte - 1));
    CHECK_FALSE(kept.release());
    std::vector<void*> blocks;
    while (true) {
        blocks.push_back(block_of(mebibyte));
        if (!kept.keep(blocks.back(), mebibyte)) break;
        REQUIRE(blocks.size() < 1000);
    }
    std::free(blocks.back());
    CHECK(kept.release());
    CHECK_FALSE(kept.release());
}

TEST_CASE("each thread has its own kept blocks, and the first of them counts") {
    CHECK(KeptBlocks::of_thread() == nullptr);
    {
        KeptBlocks first;
        CHECK(KeptBlocks::of_thread() == &first);
        {
            const KeptBlocks second;
            CHECK(KeptBlocks::of_thread() == &first);
        }
        CHECK(KeptBlocks::of_thread() == &first);
        std::thread([] { CHECK(KeptBlocks::of_thread() == nullptr); }).join();
        first.release();
        CHECK(KeptBlocks::of_thread() == &first);
    }
    CHECK(KeptBlocks::of_thread() == nullptr);
}

TEST_CASE("blocks are kept while they are collected, until the next collection") {
    KeptBlocks kept;
    void* const block = block_of(2 * mebibyte);
    CHECK_FALSE(kept.keep(block, 2 * mebibyte));
    {
        const KeptBlocks::Collection collection;
        REQUIRE(kept.keep(block, 2 * mebibyte));
    }
    void* const again = kept.take(64, 2 * mebibyte);
    REQUIRE(again == block);
    CHECK_FALSE(kept.keep(again, 2 * mebibyte));
    {
        const KeptBlocks::Collection collection;
        REQUIRE(kept.keep(again, 2 * mebibyte));
    }
    {
        const KeptBlocks::Collection collection;
        CHECK(kept.take(64, 2 * mebibyte) == nullptr);
    }
    CHECK_FALSE(kept.release());
}
