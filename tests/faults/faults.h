// Small commands of carom, each of whose calls of the system is made to fail, and what must hold
// however they end.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace carom::test {

/// The files of a folder and of those in it, by their paths from there.
using Files = std::map<std::string, std::string>;

/// A command line that is run in a folder with a scene, where `before` has run.
struct Work {
    std::string name;
    std::string before;  ///< of the shell, with $carom
    std::string arguments;
};

/// What a call does instead of its work: FAULT_CALL and FAULT_ERROR of failing_calls.cpp.
struct Fault {
    std::string call;
    int error = 0;  ///< errno; 0: half of the bytes are written
};

/// All commands, and all faults but those of memory.
const std::vector<Work>& all_work();
const std::vector<Fault>& all_faults();

/// A command, the files that it begins with, and those that it leaves when nothing fails.
class Trial {
  public:
    explicit Trial(const Work& work);

    /// The number of its calls of a class.
    long calls(const std::string& of) const { return calls_.at(of); }

    /// What is wrong with a run whose call of this number fails; empty: nothing.
    std::string with_fault(const Fault& fault, long number) const;

    /// What is wrong with a run that is killed after these seconds, or with the next one.
    std::string killed_after(double seconds) const;

    double seconds() const { return seconds_; }  ///< that an undisturbed run takes
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

/// What is wrong with these runs, a text for each; on all cores.
std::vector<std::string> wrong_in(const std::vector<Run>& runs);

/// What is wrong with runs that are killed at random times, `count` of them.
std::vector<std::string> wrong_in_killed(const std::vector<Trial>& trials, int count);

}  // namespace carom::test
