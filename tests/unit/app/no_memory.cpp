#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>

#include "app/command.h"
#include "app/commands/command_line.h"
#include "panels/registry.h"
#include "scene/scene.h"
#include "support/files.h"
#include "util/interrupt.h"

namespace {

// How many more allocations this thread is granted; below 0: any number.
thread_local long granted = -1;
thread_local long made = 0;

void* allocated(std::size_t bytes) {
    if (granted == 0) throw std::bad_alloc();
    if (granted > 0) --granted;
    ++made;
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) { return allocated(bytes); }
// The library's calls the one above, but that of a sanitizer does not.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    try {
        return allocated(bytes);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using namespace carom;

TEST_CASE("whenever memory runs out, carom says so and ends with exit code 1") {
    const test::TemporaryFolder folder;
    const std::string scene = (folder.path() / "missing.yaml").string();
    const std::array<const char*, 3> words{"carom", "check", scene.c_str()};
    const std::string message =
        "carom: not enough memory; nothing was written; a smaller picture or fewer particles need "
        "less\n";
    const std::filesystem::path errors = folder.path() / "errors";
    const auto with_memory_for = [&](long allocations) {
        const pid_t child = fork();
        if (child == 0) {  // which may end in the midst of a library
            dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600),
                 STDERR_FILENO);
            dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDOUT_FILENO);
            install_signal_handlers();  // no output has its name yet
            granted = allocations;
            _exit(run_command_line(3, words.data()));
        }
        int status = 0;
        REQUIRE(waitpid(child, &status, 0) == child);
        REQUIRE(WIFEXITED(status));
        return WEXITSTATUS(status);
    };
    REQUIRE(with_memory_for(-1) == 2);
    CHECK(with_memory_for(0) == 1);
    CHECK(test::contents(errors) == message);
    // Where a table of options, or of keys of panels, is half made, what GCC 12 does of it is
    // undefined: it destroys some of them twice.
    panel_kinds();  // once for all
    made = 0;
    all_commands();
    long allocations = made;
    const long first = allocations;
    while (true) {
        const int code = with_memory_for(allocations);
        if (code == 2) break;  // all the memory that it needs
        CAPTURE(allocations);
        REQUIRE(code == 1);
        REQUIRE(test::contents(errors) == message);
        allocations += 1 + (allocations - first) / 50;
    }
    CHECK(allocations > first + 100);
}
