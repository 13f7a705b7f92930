// Keys in words: what values a key takes, and an example. For pages and files made from the
// bindings.
#pragma once

#include <string>

#include "scene/keys/keys.h"

namespace carom {

/// All forms of a key: "a positive number; or a list of numbers".
std::string forms_text(const Key& key);

/// A value as it could be written: the default where it is fixed, else a short one that fits the
/// first form.
std::string example_text(const Key& key);

}  // namespace carom
