// The command line: what it means (parse) and doing it (run).
#pragma once

#include <string>
#include <vector>

namespace carom {

/// From here on the program ends with a message, and exit code 1, where there is no memory and
/// nothing that catches it.
void say_when_memory_runs_out();

/// Parses the arguments, does the work, reports; returns the exit code: 0 done, 1 the work failed,
/// 2 wrong input, 130 interrupted.
int run_command_line(int argc, const char* const* argv);

/// Parses the words behind `carom` and does nothing. Throws UsageError where they are wrong.
void check_command_line(const std::vector<std::string>& words);

}  // namespace carom
