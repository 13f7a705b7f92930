// The reference page of the scene language, made from the key table.
#pragma once

#include <string>

namespace carom {

/// docs/scene-reference.md, whole: Markdown, UTF-8.
std::string scene_reference();

/// The scene that the page shows.
std::string reference_example();

}  // namespace carom
