// Pieces of work that do not depend on one another, on several threads; and whether the system
// grants threads and memory, asked before they are needed: libraries end the program where it does
// not.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace carom {

/// Calls `work` with 0 to count - 1, on `threads` threads at most, this one among them; begun in
/// this order. Where one throws, no more are begun, and the first of what was thrown, in this
/// order, is thrown: it is the same for any number of threads.
/// Throws SystemError when threads cannot be started.
void on_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// Starts so many threads at once, beside this one, each of which calls `work`; throws SystemError
/// when they cannot be started, or the first of what was thrown. For what must be known before an
/// output is begun.
void require_threads(int threads, const std::function<void()>& work);

/// Throws SystemError where the process may not take so many bytes more: of its address space
/// (`ulimit -v`), or of what the system grants. `what` needs them, as a message calls it; where
/// it works on several threads, the message advises fewer. They are not kept.
void require_memory(std::size_t bytes, const std::string& what, int threads = 1);

/// The error of a thread that could not be started, one of so many.
[[noreturn]] void throw_no_threads(int threads, const std::string& reason);

}  // namespace carom
