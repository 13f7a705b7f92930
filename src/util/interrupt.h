// Ctrl-C: a flag that long work asks for, so that everything it holds is released and no
// half-written file is left; and work that is ended where it is.
#pragma once

#include <stdexcept>
#include <string>

namespace carom {

/// Thrown where work stops because the user asked for it (exit code 130). Says what is left of it.
class Interrupted : public std::runtime_error {
  public:
    Interrupted();  ///< whether any output has its name: nothing was written, or nothing more
    explicit Interrupted(const std::string& left) : std::runtime_error("interrupted; " + left) {}
};

/// To be called when an output has its name: what an interruption says from then on.
void note_output();

/// "nothing was written", or "nothing more was written" after note_output(). Allocates nothing;
/// safe in a signal handler.
const char* state_of_outputs() noexcept;

/// Sets the flag on SIGINT and SIGTERM, and on SIGHUP unless it is ignored; ignores SIGXFSZ and
/// SIGPIPE, so that a full disk or a closed pipe is an error and no death. No output has its name
/// yet.
void install_signal_handlers();

/// Throws Interrupted if the user has asked to stop, and std::bad_alloc if memory has run out
/// (memory/memory_reserve.h). Cheap: two relaxed atomic loads.
void throw_if_interrupted();

/// While one exists, on any thread, a signal ends the program at once, with exit code 130 and one
/// line on standard error: around work that asks for no flag. Throws Interrupted if the user has
/// asked to stop before. Without the handlers above it does nothing.
class EndsAtOnce {
  public:
    EndsAtOnce();
    ~EndsAtOnce();
    EndsAtOnce(const EndsAtOnce&) = delete;
    EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

/// While one exists, on any thread, a signal sets the flag only, also within EndsAtOnce: something
/// must be removed, or several steps belong together.
class MustCleanUp {
  public:
    MustCleanUp();
    ~MustCleanUp();
    MustCleanUp(const MustCleanUp&) = delete;
    MustCleanUp& operator=(const MustCleanUp&) = delete;
};

/// For tests: sets or clears the flag.
void set_interrupted(bool value);

}  // namespace carom
