// A collision of hard spheres beside one in the programs Single and Cell of F. Smallenburg, Eur.
// Phys. J. E 45, 22 (2022), as they are published. The environment variable CAROM_EDMD names the
// folder of a clone of github.com/FSmallenburg/EDMD; without it nothing is measured. All start from
// the same face-centred cubic crystal at temperature 1, melt for the same time and are measured in
// turn, on one core. Fails if carom makes fewer than 1.5 times as many collisions in a second as
// the faster of the two, at 864 to 1,000,188 spheres and packing fractions 0.2 and 0.49.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "bench/measured.h"
#include "support/equal_disks.h"
#include "support/files.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

constexpr double least_ratio = 1.5;

// The rest of a program whose first part is that of Smallenburg, without its thermostat and its
// reports: the CPU time per collision, in nanoseconds.
constexpr std::string_view own_main = R"(
#undef main
#include <time.h>
int main(int count, char** values) {
    (void)count;
    initialconfig = 1;
    N = atoi(values[1]);
    packfrac = atof(values[2]);
    thermostatinterval = writeinterval = 1e9;
    const double melt = atof(values[3]), until = melt + atof(values[4]);
    init();
    while (simtime <= melt) step();
    const unsigned int before = colcounter;
    const clock_t begin = clock();
    while (simtime <= until) step();
    const double seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    fprintf(stderr, "%.6f\n", 1e9 * seconds / (colcounter - before));
    return 0;
}
)";

// Compiled as its makefile does; nothing if that fails.
std::optional<fs::path> compiled(const fs::path& clone, const std::string& name,
                                 const fs::path& folder) {
    const fs::path source = clone / name / ("md" + name + ".c"), own = folder / (name + ".c");
    std::ofstream(own) << "#define main main_of_" << name << "\n#include \"" << source.string()
                       << "\"\n"
                       << own_main;
    const fs::path program = folder / name;
    const std::string command =
        fmt::format("cc -w -Ofast -funroll-loops -march=native -I '{}' '{}' -o '{}' -lm",
                    source.parent_path().string(), own.string(), program.string());
    if (std::system(command.c_str()) != 0) return std::nullopt;
    return program;
}

// Nanoseconds per collision; infinite if the program fails.
double run_of(const fs::path& program, std::int64_t count, double packing, double melting,
              double time) {
    const std::string command =
        fmt::format("cd '{}' && '{}' {} {} {} {} 2>&1 >/dev/null", program.parent_path().string(),
                    program.string(), count, packing, melting, time);
    double nanoseconds = std::numeric_limits<double>::infinity();
    FILE* output = popen(command.c_str(), "r");
    if (output == nullptr) return nanoseconds;
    if (std::fscanf(output, "%lf", &nanoseconds) != 1)
        nanoseconds = std::numeric_limits<double>::infinity();
    return pclose(output) == 0 ? nanoseconds : std::numeric_limits<double>::infinity();
}

bool is_faster(const fs::path& single, const fs::path& cell, std::int64_t count, double packing) {
    const int rounds = count > 100'000 ? 2 : 5;
    // A collision each takes a time of 0.25 at the lower packing and 0.03 at the higher.
    const double melting = count > 100'000 ? 0.5 : 2.0, time = 2e5 / static_cast<double>(count);
    test::Measured own(test::equal_spheres(packing, count), melting);
    double by_single = std::numeric_limits<double>::infinity(), by_cell = by_single;
    for (int k = 0; k < rounds; ++k) {
        own.measure();
        by_single = std::min(by_single, run_of(single, count, packing, melting, time));
        by_cell = std::min(by_cell, run_of(cell, count, packing, melting, time));
    }
    const double ratio = std::min(by_single, by_cell) / own.nanoseconds();
    fmt::print("{:>9} {:7.2f} {:10.0f} {:10.0f} {:10.0f} {:8.2f} (at least {})\n", count, packing,
               own.nanoseconds(), by_single, by_cell, ratio, least_ratio);
    std::fflush(stdout);
    return ratio >= least_ratio && ratio < std::numeric_limits<double>::infinity();
}

}  // namespace

int main() {
    const char* const clone = std::getenv("CAROM_EDMD");
    if (clone == nullptr) {
        fmt::print(
            "not compared with F. Smallenburg's programs: git clone "
            "https://github.com/FSmallenburg/EDMD, and set CAROM_EDMD to its folder\n");
        return 0;
    }
    const test::TemporaryFolder folder;
    const auto single = compiled(fs::absolute(clone), "Single", folder.path()),
               cell = compiled(fs::absolute(clone), "Cell", folder.path());
    if (!single || !cell) {
        fmt::print(stderr, "the programs in {} cannot be compiled\n", clone);
        return 1;
    }
    fmt::print(
        "nanoseconds of CPU time per collision\n  spheres packing      carom     Single       "
        "Cell    ratio\n");
    bool good = true;
    for (const std::int64_t count : {864, 10'976, 97'556, 1'000'188})
        for (const double packing : {0.2, 0.49})
            good = is_faster(*single, *cell, count, packing) && good;
    return good ? 0 : 1;
}
