// What the program was compiled from. The value is made by the build
// (cmake/source_fingerprint.cmake).
#pragma once

namespace carom {

/// A fingerprint of all files in src/.
extern const char* const source_fingerprint;

}  // namespace carom
