// Descriptions of keys: the values that a key takes, and an example. For pages and files generated
// from the bindings.
#pragma once

#include <string>

#include "scene/keys/keys.h"

namespace carom {

/// Returns all forms of a key in words: "a positive number; or a list of numbers".
std::string forms_text(const Key& key);

/// Returns an example value as it could be written: the default if it is a fixed value, otherwise a
/// short one of the first form.
std::string example_text(const Key& key);

/// Returns a short example of a value of this form.
std::string example_text(const Form& form);

}  // namespace carom
