// A kind of panel as the scene language sees it: its name, its abilities (which decide the keys
// that it takes), its own keys, and the function that creates it. The list of all kinds is in
// panels/registry.cpp; it is passed to the loader as a value, because scene/ does not depend on
// panels/.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

class Panel;
struct PanelContext;
enum class LawOf;

/// The abilities of a kind of panel. Each gives it the keys named here.
enum class Ability {
    bars,         ///< a histogram: `bins`, `range`, `fit`, `mean_now`, `mean_start`
    from_zero,    ///< its values are never negative, and neither is `range`
    of,           ///< shows particles that the scene chooses: `of`
    pair,         ///< `of` is two particles; without it the first two that collide
    two,          ///< `of` is two particles, and is required
    over,         ///< takes numbers over a time: `over`
    component,    ///< along one axis: `component`, `x` or `y`
    both,         ///< the same, and both axes together: `both`
    theory,       ///< has a curve of theory: `theory`
    equilibrium,  ///< that curve is the equilibrium's, so that bars can be tested against it:
                  ///< `test`
    means,        ///< shows the mean of several runs: `seeds` of a figure
    comparison,   ///< shows several runs, a line of each: `compare` of a figure
    two_runs,     ///< shows what two runs have between them, and nothing of one alone
    strip         ///< shows several moments side by side: `strip` of a figure
};

/// One kind of panel.
struct PanelKind {
    std::string name;   ///< as in scenes
    Phrase words;       ///< as in captions and transcripts
    std::string shows;  ///< a sentence for the reference page, in Markdown
    std::unique_ptr<Panel> (*make)(const PanelContext&, const PanelSpec&) = nullptr;
    std::set<Ability> abilities = {};

    /// Keys that only this kind takes.
    std::vector<Binding<PanelSpec>> keys = {};

    /// Reports errors of a panel of this kind beyond those of single values; the node is the
    /// panel's mapping, or the name of its kind alone.
    std::function<void(PanelSpec&, const Node&, Reading&)> rule = {};

    /// Returns whether the panel has something to show for a gas and its run. A film that lists no
    /// panels gets those of its template's list for which this is true. Empty: always.
    std::function<bool(const Gas&, const Run&)> suits = {};

    /// Returns the quantities whose theory (physics/theory/law.h) the panel may show of a gas.
    /// Empty: none.
    std::function<std::vector<LawOf>(const PanelSpec&, const Gas&)> laws = {};

    /// Returns whether the panel as a figure shows another time than the one asked for, which is
    /// known only after the run, or none. Empty: never.
    std::function<bool(const PanelSpec&)> has_own_time = {};

    /// Whether it has axes that a callout can point to.
    bool has_plot = true;

    /// For a kind that is only for figures: what to do in films instead; empty: for films, too.
    std::string in_films_instead = {};

    /// For the kind that shows the gas: the names of its colour scales from slow to fast.
    std::vector<std::string> palettes = {};

    bool can(Ability ability) const { return abilities.contains(ability); }
};

using PanelKinds = std::span<const PanelKind>;

/// Returns the kind of this name; null if there is none.
inline const PanelKind* kind_of(PanelKinds kinds, std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &PanelKind::name);
    return found == kinds.end() ? nullptr : &*found;
}

}  // namespace carom
