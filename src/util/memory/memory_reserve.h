// Memory that is kept for the moment when the system grants no more. Not all libraries of the
// system survive an allocation that fails: some end the program, some write something else without
// saying so. With the reserve they finish what they do, and the program then stops by itself.
#pragma once

namespace carom {

/// Keeps some megabytes of the address space, which take no memory until they are given back.
/// Without effect where the system does not grant them, and after the first call.
void keep_memory_reserve() noexcept;

/// To be called when an allocation has failed, which may then be tried once more: gives the reserve
/// back. From now on throw_if_memory_ran_out() throws. Allocates nothing; safe on any thread.
void note_failed_allocation() noexcept;

/// Throws std::bad_alloc if an allocation has failed in this process. Cheap: one relaxed atomic
/// load.
void throw_if_memory_ran_out();

}  // namespace carom
