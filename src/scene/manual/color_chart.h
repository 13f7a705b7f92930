// The colours that scenes can name, as a section of the reference page and as a chart.
#pragma once

#include <string>

namespace carom {

/// Returns the section "Colours" of docs/scene-reference.md: the picture docs/colors.svg and all
/// names.
std::string color_section();

/// Returns the content of docs/colors.svg: every colour with all its names.
std::string color_chart();

}  // namespace carom
