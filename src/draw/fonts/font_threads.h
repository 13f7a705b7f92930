// The threads that finding fonts takes.
#pragma once

namespace carom {

/// Threads that Pango starts at the same time to find the fonts of one drawing thread.
inline constexpr int threads_of_pango = 2;

}  // namespace carom
