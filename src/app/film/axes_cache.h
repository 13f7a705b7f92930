// What the first pass over a run has fixed, kept in a folder from one command to the next: a still,
// or a part of a film, then needs the run only up to its last frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.h"
#include "util/archive.h"

namespace carom {

/// The bits of the numbers of a run, which take long to find where a scene names none.
struct RunBits {
    std::optional<int> own;
    std::optional<int> beside = {};  ///< of the run beside it, if there is one

    void archive(Archive& archive) { archive(own, beside); }
};

RunBits bits_of(const Scene& scene);
Scene with_bits(Scene scene, const RunBits& bits);

/// The axes and colour scales of a film, and what else is known only after its whole run.
struct SettledAxes {
    RunBits bits;
    std::string axes;  ///< as FilmPlan::axes

    void archive(Archive& archive) { archive(bits, axes); }
};

/// A file in a folder for each scene, named by a fingerprint of all that its axes depend on: the
/// files of the scene, what the command line has changed, and this build of carom with the
/// mathematical functions of the machine. Any number of processes may share the folder.
class AxesCache {
  public:
    /// Creates the folder where it is missing; an empty path: nothing is found or kept. Throws
    /// SystemError where it cannot be created.
    AxesCache(const std::filesystem::path& folder, const Scene& asked);

    /// What is kept of the scene. Nothing where there is none, or it is damaged.
    std::optional<SettledAxes> find() const;

    /// Replaces what is kept of the scene. Throws SystemError, Interrupted.
    void keep(SettledAxes settled) const;

  private:
    std::filesystem::path file_;  ///< empty: there is no cache
};

}  // namespace carom
