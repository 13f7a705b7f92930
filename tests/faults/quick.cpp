// A part of the faults at every call: a few of each kind, and all that concern outputs.
#include <doctest/doctest.h>

#include <algorithm>
#include <cerrno>

#include "faults/faults.h"

#if defined(__linux__) && defined(__GLIBC__) && !defined(CAROM_SANITIZERS)

using namespace carom::test;

TEST_CASE("a call that fails costs the whole output or nothing, with one message") {
    const std::vector<Trial> trials(all_work().begin(), all_work().end());
    std::vector<Run> runs;
    for (const Trial& trial : trials) {
        constexpr long most = 2;  // of each kind, the last one among them
        for (const Fault& fault : all_faults())
            for (long calls = trial.calls(fault.call), n = calls; n > 0;
                 n -= std::max(1L, calls / most))
                runs.push_back({&trial, fault, n});
        // For memory allocation, also some of the last calls, when fonts are read and films are
        // joined.
        const long allocations = trial.calls("memory");
        for (long n = allocations; n > 0; n -= allocations / most)
            runs.push_back({&trial, {"memory", ENOMEM}, n});
        for (long n = allocations; n > std::max(0L, allocations - 1600); n -= 160)
            runs.push_back({&trial, {"memory", ENOMEM}, n});
    }
    CHECK(runs.size() > 200);
    for (const std::string& wrong : wrong_in(runs)) FAIL_CHECK(wrong);
    for (const std::string& wrong : wrong_in_killed(trials, 12)) FAIL_CHECK(wrong);
}
#endif
