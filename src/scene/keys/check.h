// Checks that values have the forms that their keys allow. Their meaning is checked by the
// functions that read them (reading/).
#pragma once

#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/yaml/node.h"

namespace carom {

/// Checks a mapping against its section, reports all errors in it and marks the values concerned as
/// invalid.
void check_mapping(Node& node, const Section& section, Errors& errors);

/// Reports at `place` that these keys cannot be combined.
void refuse_together(Errors& errors, const Node& place, const std::vector<std::string>& keys);

}  // namespace carom
