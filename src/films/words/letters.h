// Checks that the fonts of this machine have all letters that occur in a scene's words.
#pragma once

#include <string>

#include "util/diagnostics.h"

namespace carom {

struct Scene;

/// Thrown if a scene's words contain letters that no font of this machine has.
class MissingLetters : public SystemError {
  public:
    MissingLetters(const std::string& scene, const std::string& letters);

    static constexpr const char* hint =
        "install one (fonts-noto-cjk has the letters of Chinese, Japanese and Korean, "
        "fonts-noto-core those of most other scripts)";
    std::string path;             ///< of the scene
    std::string what_is_missing;  ///< without the path and the hint
};

/// Throws MissingLetters if a picture of the scene, its film or its figures would show empty boxes
/// instead of letters; SystemError if there is no font at all.
void require_letters(const Scene& scene);

/// The same for words that are drawn in addition to those of scenes; `path` is the file that
/// contains them.
void require_letters(const std::string& words, const std::string& path);

}  // namespace carom
