// Several outputs of one piece of work, which appear together or not at all.
#pragma once

#include <string>
#include <vector>

namespace carom {

/// What is being written and has not got its name yet.
class PendingOutput {
  public:
    PendingOutput() = default;
    virtual ~PendingOutput() = default;  ///< uncommitted: leaves nothing
    PendingOutput(const PendingOutput&) = delete;
    PendingOutput& operator=(const PendingOutput&) = delete;

    /// All that can fail, but for the name: what is written is whole and on the disk. Throws
    /// SystemError. More than once does no more than once.
    virtual void settle() = 0;

    /// Settles it, and gives it its name. SystemError leaves an earlier one as it was.
    virtual void commit() = 0;

    /// The name that it gets, for messages.
    virtual std::string name() const = 0;
};

/// Settles all, then commits all in order. Throws SystemError: before the first has its name, or
/// saying which have theirs.
void commit_together(const std::vector<PendingOutput*>& outputs);

}  // namespace carom
