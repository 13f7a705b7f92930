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
        const auto add = [&](const Fault& fault) {
            for (long part = 1; part <= most; ++part)
                if (const long n = trial.calls(fault.call) * part / most; n > 0)
                    runs.push_back({&trial, fault, n});
        };
        for (const Fault& fault : all_faults()) add(fault);
        // For memory allocation, also some of the last calls, when fonts are read and films are
        // joined.
        add({"memory", ENOMEM});
        const long allocations = trial.calls("memory");
        for (long n = allocations - 320; n > std::max(0L, allocations - 1600); n -= 320)
            runs.push_back({&trial, {"memory", ENOMEM}, n});
    }
    CHECK(runs.size() > 200);
    for (const std::string& wrong : wrong_in(runs)) FAIL_CHECK(wrong);
    for (const std::string& wrong : wrong_in_killed(trials, 12)) FAIL_CHECK(wrong);
}
#endif
