// Buffers rows of text for an output, at most about 1 MiB at a time.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

#include "app/output.h"

namespace carom {

class RowBuffer {
  public:
    /// `output` must outlive it.
    explicit RowBuffer(Output& output) : output_(output) {}

    /// An output iterator to which rows are written.
    auto end() { return std::back_inserter(text_); }

    /// To be called after each row. Passes the buffer to the output when it is large. Throws
    /// SystemError.
    void end_row() {
        constexpr std::size_t most = 1 << 20;
        if (text_.size() >= most) finish();
    }

    /// Passes the rest to the output.
    void finish() {
        output_.write({text_.data(), text_.size()});
        text_.clear();
    }

  private:
    Output& output_;
    fmt::memory_buffer text_;
};

}  // namespace carom
