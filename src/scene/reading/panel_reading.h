// The keys of panels, which of them each kind takes, and what their values mean for the gas:
// whether there are the particles that they choose, and the components.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// Particles: all, a species, a number, or a list of these.
Notation<std::vector<Chosen>> chosen_notation();

/// A list of numbers to show.
Notation<std::vector<Monitor>> monitors_notation();

/// Which values are counted: those at present, all since time 0, those of a time before.
Notation<Over> over_notation();

/// The panels of a film.
Notation<std::vector<PanelSpec>> panels_notation(PanelKinds kinds);

/// The keys that panels and figures share; `kind` and `over` are each one's own.
std::vector<Binding<PanelSpec>> panel_keys(PanelKinds kinds, const Binding<PanelSpec>& kind,
                                           const std::vector<Binding<PanelSpec>>& over);

/// The key `kind` that takes these words.
Binding<PanelSpec> kind_key(const Notation<std::string>& words);

/// The key `theme` of films and figures.
template <typename T>
Binding<T> theme_key(ThemeName T::*theme) {
    return bind_key("theme", theme, one_of<ThemeName>(),
                    "The colours of background and text; `print` is black, white and greys, except "
                    "for colours that the scene gives.");
}

/// The rules between the keys of a panel, which is a mapping or the name of a kind alone.
void complete_panel(PanelSpec& panel, const Node& node, PanelKinds kinds, Reading& reading);

/// The kinds that can do something, by name.
std::vector<std::string> kinds_that_can(PanelKinds kinds, Ability ability);

/// Reports what is wrong with return distances of this gas: that there is no reversal to measure
/// them from, or that they would take too much memory.
void check_reversal(const Node& place, Reading& reading);

}  // namespace carom
