// slurm-array.sh where there is no Slurm.
#include <doctest/doctest.h>

#include <filesystem>

#include "cluster/recipes.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

TEST_CASE("without Slurm slurm-array.sh says so, and leaves nothing behind") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "");
    const fs::path programs = folder.path() / "bin";  // all that the script needs up to there
    fs::create_directory(programs);
    for (const char* name : {"bash", "basename", "cat"})
        fs::create_symlink(fs::path("/bin") / name, programs / name);
    const Outcome outcome =
        shell("PATH='" + programs.string() + "' CAROM='" + program + "' bash '" +
                  (recipes / "slurm-array.sh").string() + "' scene.yaml -o out/film.mp4",
              folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(
        outcome.err.find("sbatch is not found: this machine has no Slurm; without it carom plan") !=
        std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "out"));
}
