// A reserve of memory for the moment when the system grants no more. Not all system libraries
// survive a failed allocation: some end the program, some write something else without reporting
// it. With the reserve they finish what they are doing, and the program then stops by itself.
#pragma once

namespace carom {

/// Reserves some megabytes of the address space, which occupy no memory as long as they are unused.
/// Has no effect if the system does not grant them, or after the first call.
void keep_memory_reserve() noexcept;

/// To be called when an allocation has failed; returns the reserve to the system, so that the
/// allocation may be tried once more. From then on throw_if_memory_ran_out() throws. Does not
/// allocate; thread-safe.
void note_failed_allocation() noexcept;

/// Throws std::bad_alloc if an allocation has failed in this process. Cheap: one relaxed atomic
/// load.
void throw_if_memory_ran_out();

}  // namespace carom
