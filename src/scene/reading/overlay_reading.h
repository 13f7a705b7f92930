// The keys of what a film shows for a while or lays over the gas: when panels are there,
// spotlights, callouts, the camera, a field; and the run that it shows beside its own.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// When a panel is there.
Notation<TimeSpan> show_notation();

/// A part of the box, as the value of a key: [x0, y0, x1, y1], on a wire [x0, x1]. `instead`: what
/// the key may have otherwise, for messages.
Notation<Region> region_notation(const std::string& key, const std::string& instead = "");

/// What is seen of the box: all of it or a part.
Notation<View> view_notation();

/// A callout as it is written; the panel that it points to is found later.
struct CalloutDraft : Callout {
    const Node* panel = nullptr;  ///< the name of a panel
    const Node* on_node = nullptr;
};

/// What a field or a profile shows; a profile knows no shares of species.
Notation<FieldOf> quantity_notation(bool with_shares);

/// The key of a film's field.
Binding<Film> field_key();

/// The keys of a film that lay something over the gas, but for callouts.
std::vector<Binding<Film>> overlay_keys();
Notation<std::vector<CalloutDraft>> callouts_notation();

/// The run that a film shows beside its own. Its scene is loaded later.
Binding<Film> beside_key();

/// Reports panels that cannot show two runs.
void check_beside(const Film& film, const Node& node, PanelKinds kinds, Errors& errors);

/// The callouts of a film whose panels are known; reports those that point to no plot.
std::vector<Callout> resolve_callouts(const std::vector<CalloutDraft>& drafts,
                                      const std::vector<PanelSpec>& panels, PanelKinds kinds,
                                      Errors& errors);

}  // namespace carom
