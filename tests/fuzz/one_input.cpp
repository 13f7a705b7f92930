// The function that libFuzzer and replay_main.cpp call for each input: it runs the target and waits
// for its threads to end. Pango looks for fonts on threads that it does not join. If libFuzzer
// checks for leaks while such a thread ends, memory that the thread is about to free counts as
// leaked.
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <thread>

#include "fuzz/fuzz.h"

namespace {

namespace fs = std::filesystem;

// The number of threads of this process; 0 if the system does not tell. A thread may end while they
// are counted.
std::ptrdiff_t count_threads() {
    std::error_code none;
    std::ptrdiff_t count = 0;
    for (fs::directory_iterator task("/proc/self/task", none), end; !none && task != end;
         task.increment(none))
        ++count;
    return count;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace std::chrono_literals;
    const std::ptrdiff_t before = count_threads();
    carom::test::fuzz(data, size);
    // The wait is limited because newer versions of Pango keep one thread from their first use on.
    const auto end = std::chrono::steady_clock::now() + 2s;
    while (count_threads() > before && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(100us);
    return 0;
}
