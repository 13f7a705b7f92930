// How many cores this process may use: what a scheduler, a container or the system grants, which
// may be fewer than the machine has.
#pragma once

#include <filesystem>

namespace carom {

/// The least of: the cores that the process may run on (sched_getaffinity), SLURM_CPUS_PER_TASK,
/// and the quota of its control groups (cpu.max of version 2, cpu.cfs_quota_us of version 1, here
/// and in all groups above); at least 1. `root` stands in for the root of the file system.
int granted_cores(const std::filesystem::path& root = "/");

}  // namespace carom
