// The command line: parses the arguments and runs the command.
#pragma once

#include <string>
#include <vector>

namespace carom {

/// From this call on, if memory runs out and nothing catches the error, the program ends with a
/// message and exit code 1.
void say_when_memory_runs_out();

/// Parses the arguments, runs the command and reports errors. Returns the exit code: 0 done, 1 the
/// work failed, 2 wrong input, 75 failed but may succeed if tried again, 130 interrupted.
int run_command_line(int argc, const char* const* argv);

/// Parses the words after `carom` without running the command. Throws UsageError if they are wrong.
void check_command_line(const std::vector<std::string>& words);

}  // namespace carom
