// What a figure set gives to its scenes.
#pragma once

#include <optional>

#include "scene/yaml/node.h"

namespace carom {

/// What a figure set gives to those of its scenes that do not give it themselves. Mappings have
/// been checked.
struct SetDefaults {
    Source source;                     ///< the text that nodes point into
    std::optional<Node> style = {};    ///< the name of a style
    std::optional<Node> figures = {};  ///< `figure_defaults`
};

}  // namespace carom
