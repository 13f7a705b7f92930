// The extents of the letters of a line, and lines that are drawn in pieces: implemented in
// draw/text.cpp.
#pragma once

#include <string>

#include "draw/geometry.h"
#include "draw/text.h"

namespace carom {

struct Ink {
    double advance = 0;  ///< distance to the start of a following letter
    Rect rect;           ///< y down, from the baseline
};

/// The ink of one line of Pango markup.
Ink ink_of(const std::string& markup, const TextStyle& style);

/// Everything that this thread draws during the lifetime of the object counts as a single line in
/// its TextLog.
class LineInPieces {
  public:
    explicit LineInPieces(DrawnLine line);
    ~LineInPieces();
    LineInPieces(const LineInPieces&) = delete;
    LineInPieces& operator=(const LineInPieces&) = delete;

  private:
    TextLog* log_;
};

}  // namespace carom
