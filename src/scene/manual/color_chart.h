// The colours that scenes can name, as a part of the reference page and as its picture.
#pragma once

#include <string>

namespace carom {

/// The section "Colours" of docs/scene-reference.md: a picture, docs/colors.svg, and all names.
std::string color_section();

/// docs/colors.svg, whole: every colour with its names beside it.
std::string color_chart();

}  // namespace carom
