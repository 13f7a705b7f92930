#include "app/granted_cores.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>

namespace carom {
namespace {

namespace fs = std::filesystem;

// A whole number greater than 0, else nothing: "max" and -1 mean that there is no limit.
std::optional<double> positive_number(std::string_view text) {
    long long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || value <= 0) return std::nullopt;
    return static_cast<double>(value);
}

std::string first_line(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

// The number of cores that a quota of CPU time in each period corresponds to.
std::optional<double> cores_of(const std::string& quota, const std::string& period) {
    const auto time = positive_number(quota), whole = positive_number(period);
    if (!time || !whole) return std::nullopt;
    return *time / *whole;
}

std::optional<double> quota_in(const fs::path& folder) {
    std::istringstream words(first_line(folder / "cpu.max"));
    std::string quota, period;
    if (words >> quota >> period) return cores_of(quota, period);
    return cores_of(first_line(folder / "cpu.cfs_quota_us"),
                    first_line(folder / "cpu.cfs_period_us"));
}

// The smallest quota of this process's control group and its parents. The group is in a line of
// /proc/self/cgroup: "0::/group" in version 2, "4:cpu,cpuacct:/group" in version 1.
double least_quota(const fs::path& root) {
    double least = std::numeric_limits<double>::infinity();
    std::ifstream lines(root / "proc/self/cgroup");
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string kinds = line.substr(first + 1, second - first - 1);
        const bool is_second_version = kinds.empty();
        if (!is_second_version && ("," + kinds + ",").find(",cpu,") == std::string::npos) continue;
        const fs::path top = root / "sys/fs/cgroup" / (is_second_version ? "" : kinds);
        fs::path group = fs::path(line.substr(second + 1)).relative_path();
        while (true) {
            least = std::min(least, quota_in(top / group).value_or(least));
            if (group.empty()) break;
            group = group.parent_path();
        }
    }
    return least;
}

}  // namespace

int granted_cores(const fs::path& root) {
    double cores = std::max(1U, std::thread::hardware_concurrency());  // respects the affinity mask
    if (const char* task = std::getenv("SLURM_CPUS_PER_TASK"))
        cores = std::min(cores, positive_number(task).value_or(cores));
    return static_cast<int>(std::max(1.0, std::floor(std::min(cores, least_quota(root)))));
}

}  // namespace carom
