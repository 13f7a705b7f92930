// Ctrl-C: a flag that long work polls, so that its resources are released and no half-written file
// is left; and work that a signal may end at once.
#pragma once

#include <stdexcept>
#include <string>

namespace carom {

/// Thrown where work stops because the user asked for it (exit code 130). The message says what of
/// the output exists.
class Interrupted : public std::runtime_error {
  public:
    Interrupted();  ///< the message says state_of_outputs()
    explicit Interrupted(const std::string& left) : std::runtime_error("interrupted; " + left) {}
};

/// To be called when an output has got its final name: changes what the message of an interruption
/// says from then on.
void note_output();

/// Returns "nothing was written", or "nothing more was written" after note_output(). Does not
/// allocate; safe in a signal handler.
const char* state_of_outputs() noexcept;

/// Installs handlers that set the flag on SIGINT and SIGTERM, and on SIGHUP unless it is ignored.
/// Ignores SIGXFSZ and SIGPIPE, so that a full disk or a closed pipe is reported as an error
/// instead of killing the program. Also marks that no output has its name yet.
void install_signal_handlers();

/// Throws Interrupted if the user has asked to stop, and std::bad_alloc if memory has run out
/// (memory/memory_reserve.h). Cheap: two relaxed atomic loads.
void throw_if_interrupted();

/// While an object of this class exists on any thread, a signal ends the program at once, with exit
/// code 130 and one line on standard error: for work that does not poll the flag. The constructor
/// throws Interrupted if the user has already asked to stop. Has no effect unless the handlers
/// above are installed.
class EndsAtOnce {
  public:
    EndsAtOnce();
    ~EndsAtOnce();
    EndsAtOnce(const EndsAtOnce&) = delete;
    EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

/// While an object of this class exists on any thread, a signal only sets the flag, even within
/// EndsAtOnce: for work that must remove something, or consists of steps that belong together.
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
