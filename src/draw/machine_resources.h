// Checks whether this machine grants the threads, memory and fonts that a piece of work needs.
// Called before an output is begun, because the libraries that set text terminate the program if
// one of these is missing.
#pragma once

#include <cstddef>

namespace carom {

/// Throws SystemError if the system does not grant `threads` threads that draw text, or `bytes` of
/// memory in addition to what these threads need themselves, or if a font cannot be read.
void require_machine_resources(int threads, std::size_t bytes);

}  // namespace carom
