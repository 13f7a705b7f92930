// The keys of what a film shows for a while or draws over the gas: panels that appear and
// disappear, spotlights, callouts, camera moves, a field; and of the second run that it shows side
// by side with its own.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/film.h"
#include "scene/keys/binding.h"
#include "scene/panel_kind.h"

namespace carom {

/// The span of time in which a panel is shown.
Notation<TimeSpan> show_notation();

/// A callout as read from the file. The panel that it points to is resolved later, by
/// resolve_callouts().
struct CalloutDraft : Callout {
    const Node* panel = nullptr;  ///< the node with the name of a panel
    const Node* on_node = nullptr;
};

/// The quantity of a field or a profile. The share of a species (a concentration) is available only
/// if `with_shares`, for fields.
Notation<FieldOf> quantity_notation(bool with_shares);

/// The key of a film's field.
Binding<Film> field_key();

/// The keys of a film that draw something over the gas, except callouts, whose notation follows.
std::vector<Binding<Film>> overlay_keys();
Notation<std::vector<CalloutDraft>> callouts_notation();

/// The key `beside`: the run that a film shows side by side with its own. The scene of that run is
/// loaded later.
Binding<Film> beside_key();

/// Reports panels that cannot show two runs.
void check_beside(const Film& film, const Node& node, PanelKinds kinds, Errors& errors);

/// Returns the callouts of a film, given its panels. Reports and omits those that do not point to a
/// plot.
std::vector<Callout> resolve_callouts(const std::vector<CalloutDraft>& drafts,
                                      const std::vector<PanelSpec>& panels, PanelKinds kinds,
                                      Errors& errors);

}  // namespace carom
