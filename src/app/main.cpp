#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "app/commands/command_line.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/memory/memory_reserve.h"

namespace {

// If the caller has closed a standard stream, its descriptor must not be reused for the file of a
// film. /dev/null takes its place, opened so that standard input still cannot be read, and the
// output streams cannot be written.
void hold_closed_streams() {
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
        const int mode = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", mode) != descriptor) _exit(1);
    }
}

// Where the stack ends, the system ends the program with a signal. Small commands need 64 kB;
// deeply nested scenes, and the threads, whose stacks are as large, more.
void require_stack() {
    constexpr rlim_t least = 256 << 10;
    rlimit stack = {};
    if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= least) return;
    carom::write_to_standard_error(
        {"carom: the stack is limited to less than 256 kB; a higher limit (ulimit -s 8192) is "
         "needed\n"});
    _exit(1);
}

// Runs before the constructors of the program's global lists, which allocate memory.
[[gnu::constructor(101)]] void begin() {
    require_stack();
    carom::keep_memory_reserve();
    carom::say_when_memory_runs_out();
}

}  // namespace

int main(int argc, char** argv) {
    hold_closed_streams();
    carom::install_signal_handlers();
    return carom::run_command_line(argc, argv);
}
