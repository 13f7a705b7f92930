// How many cores this process may use: what a scheduler, a container or the system grants, which
// may be fewer than the machine has.
#pragma once

#include <filesystem>

namespace carom {

/// The minimum of: the number of cores that the process may run on (sched_getaffinity),
/// SLURM_CPUS_PER_TASK, and the CPU quota of its control group and all parent groups (cpu.max in
/// version 2, cpu.cfs_quota_us in version 1); at least 1. `root` replaces the root of the file
/// system, for tests.
int granted_cores(const std::filesystem::path& root = "/");

}  // namespace carom
