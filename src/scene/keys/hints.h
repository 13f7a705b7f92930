// Hints on what to write instead of a value or a key that the check refuses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/yaml/node.h"

namespace carom {

/// Returns the first form of this shape; null if there is none.
const Form* form_of(const std::vector<Form>& forms, Shape shape);

std::vector<std::string> key_names(const Section& section);

/// Returns the key of a section that was probably meant by a name that it does not have: one that
/// users try for it, or one of similar spelling.
std::optional<std::string> meant_key(const std::string& name, const Section& section);

/// Returns a hint for a value that has none of the forms: what is wrong with its spelling if that
/// is known, otherwise an example of a right value: the default `usual` of its key, if there is
/// one.
std::string hint_for(const Node& node, const std::vector<Form>& forms, const std::string& usual);

/// Returns a hint for a text that has a control character.
std::string control_hint(const Node& node);

/// Returns a hint for a text of several lines where one is allowed.
std::string lines_hint(const Node& node);

/// Returns a hint for a key that a section does not have; `whole` is the section of the whole file.
std::string hint_for_unknown(const Node& key, const Section& section, const Section& whole);

}  // namespace carom
