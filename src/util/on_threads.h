// Pieces of work that do not depend on one another, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace carom {

/// Calls `work` with 0 to count - 1, on `threads` threads at most, this one among them; begun in
/// this order. Where one throws, no more are begun, and the first of what was thrown, in this
/// order, is thrown: it is the same for any number of threads.
void on_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace carom
