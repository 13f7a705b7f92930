// The scene language as a JSON Schema, for editors and for programs that write scenes.
#pragma once

#include <string>

namespace carom {

/// The JSON Schema of scenes: UTF-8, indented, ending with a line break. It covers rules about a
/// single value or mapping: forms, ranges, defaults, keys that are required or exclude each other.
/// Rules that involve several places (overlaps, packing, counts that must match lists) are checked
/// only when a scene is loaded.
std::string scene_schema_json();

/// The same for figure sets, and for styles.
std::string set_schema_json();
std::string style_schema_json();

}  // namespace carom
