#include "util/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "util/diagnostics.h"
#include "util/memory/memory_reserve.h"

namespace carom {
namespace {

std::atomic<bool> interrupted{false}, has_output{false};
std::atomic<int> ending_at_once{0}, to_clean_up{0};
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<int>::is_always_lock_free);  // hence safe in a signal handler

void on_signal(int) {
    interrupted.store(true);
    if (ending_at_once.load() == 0 || to_clean_up.load() > 0) return;
    const char* const on_terminal = "\r\033[K";  // in place of a line of progress
    write_to_standard_error({isatty(STDERR_FILENO) != 0 ? on_terminal : "", "carom: interrupted; ",
                             state_of_outputs(), "\n"});
    constexpr int code = 130;
    _exit(code);
}

// SIGHUP means that the terminal has closed. It is left ignored if it was ignored before: nohup
// does that to let the program continue.
void stop_at_hangup(const struct sigaction& action) {
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

}  // namespace

Interrupted::Interrupted() : Interrupted(state_of_outputs()) {}

void note_output() { has_output.store(true); }

const char* state_of_outputs() noexcept {
    return has_output.load() ? "nothing more was written" : "nothing was written";
}

void install_signal_handlers() {
    has_output.store(false);
    struct sigaction action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    stop_at_hangup(action);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void throw_if_interrupted() {
    if (interrupted.load(std::memory_order_relaxed)) throw Interrupted();
    throw_if_memory_ran_out();
}

// A signal before the increment is detected through the flag, one after it through the handler.
EndsAtOnce::EndsAtOnce() {
    ++ending_at_once;
    if (!interrupted.load()) return;
    --ending_at_once;
    throw Interrupted();
}

EndsAtOnce::~EndsAtOnce() { --ending_at_once; }

MustCleanUp::MustCleanUp() { ++to_clean_up; }

MustCleanUp::~MustCleanUp() { --to_clean_up; }

void set_interrupted(bool value) { interrupted.store(value, std::memory_order_relaxed); }

}  // namespace carom
