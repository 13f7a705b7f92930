// Keys as tables of the reference page, in Markdown.
#pragma once

#include <string>

#include "scene/keys/keys.h"

namespace carom {

/// Returns the row of a key: name, meaning, values and default. Of a key that a few kinds of panel
/// share, it names these.
std::string key_row(const Section& section, const Key& key);

/// Returns whether the rows of both keys are the same, whichever kinds of panel take them.
bool are_told_alike(const Section& section, const Key& key, const Section& other,
                    const Key& its_key);

/// Returns a table of such rows, followed by an empty line.
std::string key_table(const std::string& rows);

}  // namespace carom
