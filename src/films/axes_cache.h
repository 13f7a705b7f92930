// Keeps what the first pass over a run has fixed in a folder, from one command to the next: a still
// or a part of a film then needs the run only up to its last frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "util/archive.h"
#include "util/files/stored_file.h"

namespace carom {

struct Scene;

/// The precision in bits of each run that a film shows, which takes long to find if the scene does
/// not give it.
using RunBits = std::vector<std::optional<int>>;

RunBits bits_of(const Scene& scene);
Scene with_bits(Scene scene, const RunBits& bits);

/// The axes and colour scales of a film, and everything else that is known only after its whole
/// run.
struct SettledAxes {
    RunBits bits;
    std::string axes;                            ///< as FilmPlan::axes
    std::vector<std::string> number_texts = {};  ///< as WordNumbers::texts()

    void archive(Archive& archive) { archive(bits, axes, number_texts); }
};

/// One file in the folder for each scene, named by a fingerprint of all that the axes depend on:
/// the files of the scene, the changes made on the command line, and this build of carom with the
/// mathematical functions of the machine. Any number of processes may share the folder.
class AxesCache {
  public:
    /// With an empty path nothing is found or kept. Throws SystemError if something else than a
    /// folder has the path, or stands on the way there.
    AxesCache(const std::filesystem::path& folder, const Scene& asked);

    /// What is kept for the scene; nothing if there is no file, or it is damaged or cannot be read.
    std::optional<SettledAxes> find() const;

    /// Replaces what is kept for the scene, and creates the folder if it is missing. If that fails,
    /// warns: the cache only saves time. Throws Interrupted.
    void keep(SettledAxes settled) const;

  private:
    StoredFile file_;  ///< with an empty name: there is no cache
};

}  // namespace carom
