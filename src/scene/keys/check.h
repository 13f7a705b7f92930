// Whether values have the forms that their keys allow. What they mean is for those who read them
// (reading/).
#pragma once

#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/yaml/node.h"

namespace carom {

/// Checks a mapping against its section, marks what is wrong in it as invalid and reports all of
/// it.
void check_mapping(Node& node, const Section& section, Errors& errors);

/// Reports at `place` that keys exclude each other.
void refuse_together(Errors& errors, const Node& place, const std::vector<std::string>& keys);

}  // namespace carom
