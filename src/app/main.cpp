#include <fcntl.h>
#include <unistd.h>

#include "app/command_line.h"
#include "util/interrupt.h"

namespace {

// A standard stream that the caller has closed must not become the number of a film's file.
void open_closed_streams() {
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDWR) != descriptor) _exit(1);
}

}  // namespace

int main(int argc, char** argv) {
    open_closed_streams();
    carom::install_signal_handlers();
    return carom::run_command_line(argc, argv);
}
