#include "app/command_line.h"
#include "util/interrupt.h"

int main(int argc, char** argv) {
    carom::install_signal_handlers();
    return carom::run_command_line(argc, argv);
}
