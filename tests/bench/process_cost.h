// The CPU time and the peak memory of some work, measured in a process of its own.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "bench/measured.h"

namespace carom::test {

struct Cost {
    double seconds = std::numeric_limits<double>::infinity();  ///< of CPU
    double bytes = 0.0;                                        ///< of memory

    /// Combines two measurements: the shorter time, which is less disturbed, and the larger memory.
    void keep_better(const Cost& other) {
        seconds = std::min(seconds, other.seconds);
        bytes = std::max(bytes, other.bytes);
    }
};

/// Runs `work` in a child process. It returns the CPU time at which the measurement begins, so that
/// preparation is not counted.
template <typename Work>
Cost cost_of(const Work& work) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) std::abort();
    const pid_t child = fork();
    if (child < 0) std::abort();
    if (child == 0) {
        const double begin = work();
        const double seconds = cpu_seconds() - begin;
        const bool is_written = write(ends[1], &seconds, sizeof seconds) == sizeof seconds;
        _exit(is_written ? 0 : 1);
    }
    Cost cost;
    int status = 0;
    rusage usage{};
    close(ends[1]);
    const bool is_read = read(ends[0], &cost.seconds, sizeof cost.seconds) == sizeof cost.seconds;
    close(ends[0]);
    if (wait4(child, &status, 0, &usage) != child || status != 0 || !is_read) std::abort();
    cost.bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
    return cost;
}

/// The path of carom, which is in the folder of the benchmarks.
inline std::string carom_program() {
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "carom").string();
}

/// The cost of a program with these arguments; it must succeed.
inline Cost cost_of_program(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (std::string& word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0) std::abort();
    if (child == 0) {
        execv(arguments.front(), arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child || status != 0) std::abort();
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
            1024.0 * static_cast<double>(usage.ru_maxrss)};
}

}  // namespace carom::test
