// The scene language as a JSON Schema, for editors and for programs that write scenes.
#pragma once

#include <string>

namespace carom {

/// The JSON Schema of scenes: UTF-8, indented, ends with a line break. It says what one value or
/// one mapping can say: forms, ranges, defaults, keys that are required or exclude one another.
/// What depends on several places (overlaps, packing, counts against lists) is checked only when a
/// scene is loaded.
std::string scene_schema_json();

/// The same of figure sets.
std::string set_schema_json();

}  // namespace carom
