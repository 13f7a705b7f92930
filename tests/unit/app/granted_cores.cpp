// What schedulers and containers grant.
#include "app/granted_cores.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <thread>

#include "support/files.h"

using carom::granted_cores;
using carom::test::TemporaryFolder;

namespace {

struct GrantedByTask {
    explicit GrantedByTask(const char* cores) { setenv("SLURM_CPUS_PER_TASK", cores, 1); }
    ~GrantedByTask() { unsetenv("SLURM_CPUS_PER_TASK"); }
};

const int all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));

}  // namespace

TEST_CASE("without a limit all cores are granted that the process may run on") {
    const TemporaryFolder root;
    CHECK(granted_cores(root.path()) == all);
}

TEST_CASE("a task of Slurm has the cores that it was given, if they are there") {
    const TemporaryFolder root;
    {
        const GrantedByTask one("1");
        CHECK(granted_cores(root.path()) == 1);
    }
    for (const char* meaningless : {"1000000", "", "many", "0", "-1"}) {
        const GrantedByTask task(meaningless);
        CHECK(granted_cores(root.path()) == all);
    }
}

TEST_CASE("a control group has the cores of its quota, or of a group above it; 1 at least") {
    const TemporaryFolder root;
    root.write("proc/self/cgroup", "0::/jobs/carom\n");
    root.write("sys/fs/cgroup/jobs/carom/cpu.max", "max 100000\n");
    CHECK(granted_cores(root.path()) == all);
    root.write("sys/fs/cgroup/jobs/cpu.max", "150000 100000\n");
    CHECK(granted_cores(root.path()) == 1);
    root.write("sys/fs/cgroup/jobs/cpu.max", "20000 100000\n");
    CHECK(granted_cores(root.path()) == 1);
    root.write("sys/fs/cgroup/jobs/cpu.max", "100000000 100000\n");
    CHECK(granted_cores(root.path()) == all);
    root.write("sys/fs/cgroup/jobs/cpu.max", "nonsense");
    CHECK(granted_cores(root.path()) == all);
}

TEST_CASE("the same of control groups of version 1") {
    const TemporaryFolder root;
    root.write("proc/self/cgroup", "5:memory:/docker/a\n4:cpu,cpuacct:/docker/a\n");
    root.write("sys/fs/cgroup/cpu,cpuacct/docker/a/cpu.cfs_period_us", "100000\n");
    root.write("sys/fs/cgroup/cpu,cpuacct/docker/a/cpu.cfs_quota_us", "-1\n");
    CHECK(granted_cores(root.path()) == all);
    root.write("sys/fs/cgroup/cpu,cpuacct/docker/a/cpu.cfs_quota_us", "100000\n");
    CHECK(granted_cores(root.path()) == 1);
}
