// The cost of exact reversal in a film: the wall time of the scene time-reversal as it is,
// including the search for the number of bits, against the same scene in doubles. Films of both
// kinds take turns, and the fastest of each counts, since other work on the machine can only slow
// it down. Fails if the ratio is above 1.3.
// --quick: two rounds instead of five.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string>

#include "films/render.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "scene/scene.h"

using namespace carom;

namespace {

constexpr double most_ratio = 1.3;

struct Cost {
    double wall = std::numeric_limits<double>::infinity();
    double simulate = std::numeric_limits<double>::infinity();  ///< CPU seconds
};

void render_once(const std::string& precision, const std::filesystem::path& output, Cost& best) {
    const Scene scene = load_scene(library_folder() / "time-reversal.yaml", scene_resources(),
                                   {"run.precision=" + precision});
    Progress silent(Progress::Form::silent, "");
    const RenderReport report = render(scene, {.output = output, .threads = 2}, silent);
    best.wall = std::min(best.wall, report.wall_seconds);
    best.simulate = std::min(best.simulate, report.simulate_seconds);
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const auto folder = std::filesystem::temp_directory_path() / "carom-reversal-bench";
    Cost home, astray;
    for (int round = 0; round < (quick ? 2 : 5); ++round) {
        render_once("double", folder / "film.mp4", astray);
        render_once("auto", folder / "film.mp4", home);
    }
    std::filesystem::remove_all(folder);
    const double ratio = home.wall / astray.wall;
    fmt::print("A film of 30 s that comes home, 1080p30, two cores, the best of each\n");
    fmt::print("{:>12} {:>14} {:>22}\n", "precision", "wall seconds", "simulation, CPU s");
    fmt::print("{:>12} {:>14.2f} {:>22.2f}\n", "double", astray.wall, astray.simulate);
    fmt::print("{:>12} {:>14.2f} {:>22.2f}\n", "auto", home.wall, home.simulate);
    const bool good = ratio <= most_ratio;
    fmt::print("it takes {:.2f} times as long, allowed are {}: {}\n", ratio, most_ratio,
               good ? "good" : "TOO MUCH");
    return good ? 0 : 1;
}
