// Runs independent pieces of work on several threads; and checks that the system grants threads and
// memory before they are needed, because libraries end the program when it does not.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace carom {

/// Calls work(0) to work(count - 1) on at most `threads` threads, including the calling one; the
/// calls start in this order. After an exception no further calls start, and of the exceptions
/// thrown that with the smallest argument is rethrown, so that it is the same for any number of
/// threads.
/// Throws SystemError if threads cannot be started.
void on_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// Starts `threads` threads at once, in addition to the calling one, each of which calls `work`,
/// and waits for them. Throws SystemError if they cannot be started, or rethrows the first
/// exception of `work`. For checks that must precede the beginning of an output.
void require_threads(int threads, const std::function<void()>& work);

/// Throws SystemError if the process may not allocate `bytes` more, because of the limit on its
/// address space (`ulimit -v`) or because the system refuses. The message names `what` needs them;
/// if it works on several threads, the message advises fewer. The memory is released again at once.
void require_memory(std::size_t bytes, const std::string& what, int threads = 1);

/// Throws the error that a thread, one of `threads`, could not be started.
[[noreturn]] void throw_no_threads(int threads, const std::string& reason);

}  // namespace carom
