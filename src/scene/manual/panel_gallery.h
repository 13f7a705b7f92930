// The gallery of panels in the reference page: each kind with a picture, the lines that produce it,
// and its keys.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/panel_kind.h"

namespace carom {

/// A scene that shows a panel of one kind, docs/panels/KIND.yaml, and the alternative text of its
/// picture, docs/panels/KIND.png, for readers who cannot see it.
struct PanelExample {
    std::string scene;
    std::string alt;
};

/// Returns the figure set docs/panels/panels.yaml: the scenes of all kinds, in their order.
std::string panel_set(PanelKinds kinds);

/// Keys that the gallery tells, each with the section that it belongs to: those that a single kind
/// takes, and those that several kinds share, of panels in films and of figures.
using KeysInGallery = std::vector<std::pair<const Section*, const Key*>>;
KeysInGallery keys_in_gallery(PanelKinds kinds);

/// Returns the section "Panels" of docs/scene-reference.md. `examples` must have an entry for each
/// kind.
std::string panel_gallery(PanelKinds kinds, const std::map<std::string, PanelExample>& examples);

}  // namespace carom
