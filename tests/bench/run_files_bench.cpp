// The cost of the files of `carom run` relative to the bare run, as CPU time of the program: a
// trajectory (--xyz) with one sample per mean collision time of a particle, and a row for every
// collision (--events). Also the peak memory of the program, which must not grow in a run of four
// times the length.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "bench/process_cost.h"
#include "support/files.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

// The numbers are written with all their digits: 14 in a row of --events, 7 in a row of --xyz.
constexpr double most_xyz = 2.2, most_events = 6.0;
constexpr double most_growth = 1.02;  // pages of the heap come and go
constexpr double length = 100.0;

class RunFiles {
  public:
    // Packing fraction 0.3; about one collision a particle in each unit of time.
    RunFiles()
        : scene_(folder_.write("scene.yaml",
                               "title: A gas\nbox: {size: [84, 63]}\n"
                               "gas: [{count: 2000, radius: 0.5, temperature: 1}]\n"
                               "run: {until: 100, sample_every: 1}\n")) {}

    // `option`: the option that writes the file; empty: no file is written.
    test::Cost cost(const std::string& option, double until, int rounds) const {
        std::vector<std::string> command{test::carom_program(),
                                         "run",
                                         scene_.string(),
                                         "--quiet",
                                         "--set",
                                         fmt::format("run.until={}", until)};
        if (!option.empty()) command.insert(command.end(), {option, file().string()});
        test::Cost best;
        for (int k = 0; k < rounds; ++k) best.keep_better(test::cost_of_program(command));
        return best;
    }

    double megabytes() const { return 1e-6 * static_cast<double>(fs::file_size(file())); }

  private:
    fs::path file() const { return folder_.path() / "file"; }

    test::TemporaryFolder folder_;
    fs::path scene_;
};

bool is_cheap(const RunFiles& files, const std::string& option, double most, int rounds) {
    const test::Cost bare = files.cost("", length, rounds);
    const test::Cost its = files.cost(option, length, rounds);
    const double written = files.megabytes();
    const test::Cost longer = files.cost(option, 4.0 * length, 1);
    const double ratio = its.seconds / bare.seconds, growth = longer.bytes / its.bytes;
    fmt::print(
        "{:<9} {:6.2f} s for {:4.0f} MB, {:5.2f} times the bare run (at most {}); {:4.0f} MB of "
        "memory, {:.3f} times as much for four times the length (at most {})\n",
        option, its.seconds, written, ratio, most, 1e-6 * its.bytes, growth, most_growth);
    return ratio <= most && growth <= most_growth;
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 && std::string(argv[1]) == "--quick" ? 1 : 5;
    const RunFiles files;
    bool good = is_cheap(files, "--xyz", most_xyz, rounds);
    good = is_cheap(files, "--events", most_events, rounds) && good;
    return good ? 0 : 1;
}
