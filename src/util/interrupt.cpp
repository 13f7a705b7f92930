#include "util/interrupt.h"

#include <atomic>
#include <csignal>

namespace carom {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // hence safe in a signal handler

void on_signal(int) { interrupted.store(true, std::memory_order_relaxed); }

// A terminal that closes; nohup has asked to outlive it.
void stop_at_hangup(const struct sigaction& action) {
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
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
}

void set_interrupted(bool value) { interrupted.store(value, std::memory_order_relaxed); }

}  // namespace carom
