// The start-up time of the program: the CPU time of short commands, compared with that of a shell
// that does nothing, and of the launcher compared with the program itself.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include "bench/process_cost.h"

namespace fs = std::filesystem;
using namespace carom;

namespace {

double seconds_of_children() {
    rusage usage = {};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// CPU milliseconds of a command: the minimum of several runs.
double milliseconds(const std::string& command) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 15; ++i) {
        const double begin = seconds_of_children();
        if (std::system((command + " >/dev/null").c_str()) != 0)
            throw std::runtime_error("failed: " + command);
        lowest = std::min(lowest, 1e3 * (seconds_of_children() - begin));
    }
    return lowest;
}

bool is_good(const std::string& what, double its, const std::string& of, double other,
             double most) {
    fmt::print("{:<28} {:6.1f} ms, {:5.1f} times {} (at most {})\n", what, its, its / other, of,
               most);
    return its <= most * other;
}

}  // namespace

int main() {
    const std::string program = test::carom_program();
    const fs::path checkout =
        fs::path(program).parent_path().parent_path().parent_path().parent_path();
    const std::string scene = (checkout / "scenes/one-hot-particle.yaml").string();
    const double shell = milliseconds("bash -c :");
    const double version = milliseconds(program + " --version");
    fmt::print("{:<28} {:6.1f} ms\n", "a shell that does nothing", shell);
    bool good = is_good("carom --version", version, "that", shell, 7.0);
    good &= is_good("carom check SCENE", milliseconds(program + " check " + scene), "that", shell,
                    14.0);
    const std::string launcher = (checkout / "carom").string();
    if (fs::exists(checkout / "build/release/.current"))
        good &= is_good("./carom --version", milliseconds(launcher + " --version") - shell,
                        "--version beyond the shell", version, 2.0);
    return good ? 0 : 1;
}
