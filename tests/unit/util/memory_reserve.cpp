#include "util/memory/memory_reserve.h"

#include <doctest/doctest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <new>

#include "support/files.h"
#include "util/files/atomic_file.h"
#include "util/interrupt.h"

// The address space of a sanitizer has no useful limit, and QEMU grants beyond it.
#if defined(__linux__) && !defined(CAROM_SANITIZERS) && !defined(CAROM_EMULATED)

using namespace carom;

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

bool is_granted(std::size_t bytes) {
    void* const memory =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return false;
    munmap(memory, bytes);
    return true;
}

std::size_t address_space() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// Of this process.
bool grows_no_more() {
    const std::size_t size = address_space();
    const rlimit limit{.rlim_cur = size, .rlim_max = size};
    return setrlimit(RLIMIT_AS, &limit) == 0;
}

// In a process of its own, with a reserve: the number of what is wrong there; 0: nothing.
template <class Work>
int first_wrong(const Work& work) {
    const pid_t child = fork();
    if (child == 0) {
        keep_memory_reserve();
        _exit(work());
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status);
}

template <class Work>
bool throws_bad_alloc(const Work& work) {
    try {
        work();
        return false;
    } catch (const std::bad_alloc&) {
        return true;
    }
}

}  // namespace

TEST_CASE("the reserve is there when nothing else is, once, and the work ends after it") {
    CHECK(first_wrong([] {
              if (!grows_no_more() || is_granted(4 * mebibyte)) return 1;
              if (throws_bad_alloc(throw_if_interrupted)) return 2;
              note_failed_allocation();
              if (!throws_bad_alloc(throw_if_memory_ran_out)) return 3;
              if (!throws_bad_alloc(throw_if_interrupted)) return 4;
              note_failed_allocation();  // nothing is left to give back
              return is_granted(4 * mebibyte) ? 0 : 5;
          }) == 0);
}

TEST_CASE("nothing gets its name after an allocation has failed") {
    const test::TemporaryFolder outputs;
    const auto file = outputs.path() / "file", folder = outputs.path() / "folder";
    CHECK(first_wrong([&] {
              AtomicFile begun(file);
              AtomicFolder frames(folder);
              note_failed_allocation();
              if (!throws_bad_alloc([&] { begun.commit(); })) return 1;
              if (!throws_bad_alloc([&] { frames.commit(); })) return 2;
              return 0;
          }) == 0);
    CHECK(!std::filesystem::exists(file));
    CHECK(!std::filesystem::exists(folder));
}
#endif
