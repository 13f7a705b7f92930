// What the letters of a line touch, and lines that are drawn in pieces: implemented in
// draw/text.cpp.
#pragma once

#include <string>

#include "draw/geometry.h"
#include "draw/text.h"

namespace carom {

struct Ink {
    double advance = 0;  ///< to where the next letter would begin
    Rect rect;           ///< y down, from the baseline
};

/// Of one line of Pango markup.
Ink ink_of(const std::string& markup, const TextStyle& style);

/// What this thread draws while it lives is one line in its TextLog.
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
