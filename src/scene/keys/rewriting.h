// Values that mean one of the allowed forms, but are written in another: "40 x 30" for [40, 30].
#pragma once

#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/yaml/node.h"

namespace carom {

/// Returns how a value that has none of the forms is probably meant to be written; empty if that is
/// not known.
std::string rewritten(const Node& node, const std::vector<Form>& forms);

}  // namespace carom
