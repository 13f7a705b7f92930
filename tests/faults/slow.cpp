// Faults at every call.
#include <doctest/doctest.h>

#include <algorithm>
#include <cerrno>

#include "faults/faults.h"

#if defined(__linux__) && defined(__GLIBC__) && !defined(CAROM_SANITIZERS)

using namespace carom::test;

namespace {

void check(const Trial& trial, const std::vector<Run>& runs) {
    for (const std::string& wrong : wrong_in(runs)) FAIL_CHECK(wrong);
    MESSAGE(trial.name() << ": " << runs.size() << " runs");
}

}  // namespace

TEST_CASE("every call of the system that fails costs the whole output or nothing") {
    for (const Work& work : all_work()) {
        const Trial trial(work);
        std::vector<Run> runs;
        for (const Fault& fault : all_faults())
            for (long n = 1; n <= trial.calls(fault.call); ++n) runs.push_back({&trial, fault, n});
        check(trial, runs);
    }
}

TEST_CASE("memory that is not there costs the whole output or nothing") {
    for (const Work& work : all_work()) {
        const Trial trial(work);
        std::vector<Run> runs;
        constexpr long every = 3000, samples = 2000;  // each of `every`, then `samples` more
        const long calls = trial.calls("memory");
        const long step = std::max(1L, (calls - every) / samples);
        for (long n = 1; n <= calls; n += n < every ? 1 : step)
            runs.push_back({&trial, {"memory", ENOMEM}, n});
        check(trial, runs);
    }
}

TEST_CASE("a run that is killed leaves no half file, and the next one cleans up") {
    const std::vector<Trial> trials(all_work().begin(), all_work().end());
    for (const std::string& wrong : wrong_in_killed(trials, 1000)) FAIL_CHECK(wrong);
}
#endif
