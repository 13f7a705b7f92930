// Outputs of one piece of work that appear together or not at all.
#pragma once

#include <string>
#include <vector>

namespace carom {

/// An output that is being written and does not have its final name yet.
class PendingOutput {
  public:
    PendingOutput() = default;
    virtual ~PendingOutput() = default;  ///< leaves nothing behind if not committed
    PendingOutput(const PendingOutput&) = delete;
    PendingOutput& operator=(const PendingOutput&) = delete;

    /// Does everything that can fail except the renaming: afterwards the output is complete and on
    /// the disk. Throws SystemError. Further calls have no effect.
    virtual void settle() = 0;

    /// Settles the output and gives it its name. After SystemError an earlier output of that name
    /// is unchanged.
    virtual void commit() = 0;

    /// Returns the final name, for messages.
    virtual std::string name() const = 0;
};

/// Settles all outputs, then commits them in order. Throws SystemError: either before any output
/// has its name, or with a message that lists those that have.
void commit_together(const std::vector<PendingOutput*>& outputs);

}  // namespace carom
