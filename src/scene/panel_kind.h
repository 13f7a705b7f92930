// What a kind of panel is to the scene language: its name, what it can do (which decides the keys
// that it takes), keys of its own, and what makes it. The list of all kinds is in
// panels/registry.cpp; the loader gets it as a value, because scene/ knows no panels.
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

/// What a kind of panel can do. Each gives it the keys named here.
enum class Ability {
    bars,         ///< a histogram: `bins`, `range`, `fit`, `mean_now`, `mean_start`
    from_zero,    ///< of numbers that are never negative: so is `range`
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
    strip         ///< shows several moments side by side: `strip` of a figure
};

/// One kind of panel.
struct PanelKind {
    std::string name;   ///< as scenes write it
    Phrase words;       ///< as captions and transcripts do
    std::string shows;  ///< a sentence for the reference page, in Markdown
    std::unique_ptr<Panel> (*make)(const PanelContext&, const PanelSpec&) = nullptr;
    std::set<Ability> abilities = {};

    /// Keys that this kind alone takes.
    std::vector<Binding<PanelSpec>> keys = {};

    /// Reports what is wrong with a panel of this kind beyond the single values; the node is the
    /// panel's mapping, or its name alone.
    std::function<void(PanelSpec&, const Node&, Reading&)> rule = {};

    /// Whether it has something to show of a gas and its run: a film that names no panels has those
    /// of its template's list that do. None: always.
    std::function<bool(const Gas&, const Run&)> suits = {};

    /// Whether it has axes that a callout can point to.
    bool has_plot = true;

    /// Of a kind for figures only: what to do in films instead; empty: it is for both.
    std::string in_films_instead = {};

    /// Of the kind that shows the gas: names of the colours that it can have from slow to fast.
    std::vector<std::string> palettes = {};

    bool can(Ability ability) const { return abilities.contains(ability); }
};

using PanelKinds = std::span<const PanelKind>;

/// The kind of this name; null if there is none.
inline const PanelKind* kind_of(PanelKinds kinds, std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &PanelKind::name);
    return found == kinds.end() ? nullptr : &*found;
}

}  // namespace carom
