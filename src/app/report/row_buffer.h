// Text on its way to an output, of which little is kept in memory.
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

    /// Where rows are written to.
    auto end() { return std::back_inserter(text_); }

    /// After a row; hands many of them on at once. Throws SystemError.
    void end_row() {
        constexpr std::size_t most = 1 << 20;
        if (text_.size() >= most) finish();
    }

    /// Hands on what is left.
    void finish() {
        output_.write({text_.data(), text_.size()});
        text_.clear();
    }

  private:
    Output& output_;
    fmt::memory_buffer text_;
};

}  // namespace carom
