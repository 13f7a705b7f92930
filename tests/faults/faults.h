// Runs small commands of carom while one of their system calls fails, or while they are killed, and
// checks what must hold however they end.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace carom::test {

/// The contents of all files below a folder, by their path relative to it.
using Files = std::map<std::string, std::string>;

/// A command line, run in a folder with a scene after the commands of `before`.
struct Work {
    std::string name;
    std::string before;  ///< shell commands, with $carom for the program
    std::string arguments;
};

/// The failure of a call: the values of FAULT_CALL and FAULT_ERROR of failing_calls.cpp.
struct Fault {
    std::string call;
    int error = 0;  ///< errno; 0: only half of the bytes are written
};

/// All commands, and all faults except those of memory allocation.
const std::vector<Work>& all_work();
const std::vector<Fault>& all_faults();

/// A command, the files with which it starts, and the files that it leaves if nothing fails.
class Trial {
  public:
    explicit Trial(const Work& work);

    /// The number of calls of a class that the command makes.
    long calls(const std::string& of) const { return calls_.at(of); }

    /// Describes what is wrong with a run whose call `number` fails; empty: nothing.
    std::string with_fault(const Fault& fault, long number) const;

    /// Describes what is wrong with a run that is killed after `seconds`, or with the run after it;
    /// empty: nothing.
    std::string killed_after(double seconds) const;

    double seconds() const { return seconds_; }  ///< duration of an undisturbed run
    const std::string& name() const { return work_.name; }

  private:
    Work work_;
    Files before_, after_;
    std::map<std::string, long> calls_;
    double seconds_ = 0.0;
};

/// One run of a trial.
struct Run {
    const Trial* trial;
    Fault fault;
    long number;
};

/// Carries out the runs on all cores, and describes what is wrong, one text for each problem.
std::vector<std::string> wrong_in(const std::vector<Run>& runs);

/// Kills `count` runs at random times, and describes what is wrong.
std::vector<std::string> wrong_in_killed(const std::vector<Trial>& trials, int count);

}  // namespace carom::test
