// Whether this machine has the letters that a scene's words are written in.
#pragma once

#include <string>

#include "scene/scene.h"
#include "util/diagnostics.h"

namespace carom {

/// A scene has words in letters that no font of this machine has.
class MissingLetters : public SystemError {
  public:
    MissingLetters(const std::string& scene, const std::string& letters);

    static constexpr const char* hint =
        "install one (fonts-noto-cjk has the letters of Chinese, Japanese and Korean, "
        "fonts-noto-core those of most other scripts)";
    std::string path;             ///< of the scene
    std::string what_is_missing;  ///< without the path and the hint
};

/// Throws MissingLetters where a picture of the scene, its film or its figures would show empty
/// boxes instead of letters; SystemError where there is no font at all.
void require_letters(const Scene& scene);

/// The same of words that are drawn beside those of scenes; `path` is the file that has them.
void require_letters(const std::string& words, const std::string& path);

}  // namespace carom
