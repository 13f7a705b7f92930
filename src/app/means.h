// Whether this machine grants what a piece of work needs: asked before an output is begun, since
// the libraries that set text end the program where it does not.
#pragma once

#include <cstddef>

namespace carom {

/// Throws SystemError where so many threads that draw text, or so many bytes beside what these need
/// themselves, cannot be had, or a font cannot be read.
void require_means(int threads, std::size_t bytes);

}  // namespace carom
