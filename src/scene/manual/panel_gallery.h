// Every kind of panel with a picture and the lines that make it, as a part of the reference page.
#pragma once

#include <map>
#include <string>

#include "scene/panel_kind.h"

namespace carom {

/// A scene that shows a panel of one kind, docs/panels/KIND.yaml, and what carom says of its
/// picture, docs/panels/KIND.png, to those who cannot see it.
struct PanelExample {
    std::string scene;
    std::string alt;
};

/// The figure set docs/panels/panels.yaml: the scenes of all kinds, in their order.
std::string panel_set(PanelKinds kinds);

/// The section "Panels" of docs/scene-reference.md. Each kind has an example.
std::string panel_gallery(PanelKinds kinds, const std::map<std::string, PanelExample>& examples);

}  // namespace carom
