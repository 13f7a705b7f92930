// The keys of panels, which of them each kind of panel takes, and the checks against the gas: that
// the particles and components that a panel names exist.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/looks.h"
#include "scene/panel_kind.h"
#include "scene/panel_spec.h"

namespace carom {

/// A choice of particles: all, a species, a particle's number, or a list of these.
Notation<std::vector<Chosen>> chosen_notation();

/// The quantities in a row of monitors, as a list.
Notation<std::vector<Monitor>> monitors_notation();

/// The values that are counted: those at present, all since time 0, or those in a window of time
/// before the present.
Notation<Over> over_notation();

/// The panels of a film.
Notation<std::vector<PanelSpec>> panels_notation(PanelKinds kinds);

/// The instruments whose last readings are numbers of a run.
const Notation<std::vector<PanelSpec>>& measure_notation(PanelKinds kinds);

/// The keys that the panels of films and figures share. `kind` and `over`, which differ between the
/// two, are given by the caller.
std::vector<Binding<PanelSpec>> panel_keys(PanelKinds kinds, const Binding<PanelSpec>& kind,
                                           const std::vector<Binding<PanelSpec>>& over);

/// The key `kind`, whose values are these words.
Binding<PanelSpec> kind_key(const Notation<std::string>& words);

/// The names of themes.
Notation<ThemeName> theme_notation();

/// The key `theme` of films and figures.
template <typename T>
Binding<T> theme_key(ThemeName T::*theme) {
    return bind_key("theme", theme, theme_notation(),
                    "The colours of background and text; `print` is black, white and greys, except "
                    "for colours that the scene gives.");
}

/// Applies the rules between the keys of a panel. `node` is the panel's mapping, or the name of its
/// kind alone.
/// Refuses a kind that does not show real units, in a scene that has them. For the panels of films
/// and for figures.
void check_units(const PanelSpec& panel, const Node& node, PanelKinds kinds, Reading& reading);

void complete_panel(PanelSpec& panel, const Node& node, PanelKinds kinds, Reading& reading);

/// Returns the names of the kinds that have an ability.
std::vector<std::string> kinds_that_can(PanelKinds kinds, Ability ability);

/// Reports at `place` why return distances cannot be shown for this gas and run: there is no
/// reversal to measure them from, or they would take too much memory.
void check_reversal(const Node& place, Reading& reading);

}  // namespace carom
