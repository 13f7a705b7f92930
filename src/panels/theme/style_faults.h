// What viewers may fail to see or to tell apart in the colours of a style.
#pragma once

#include <vector>

#include "util/diagnostics.h"

namespace carom {

struct Style;

/// The colours of a style that have too little contrast with its page or ground (WCAG 2.2: 4.5 for
/// words, 3 for other marks), and those of its series and of its scale that some viewers confuse,
/// each with the place of the key at fault and a hint.
std::vector<Diagnostic> faults_of(const Style& style);

}  // namespace carom
