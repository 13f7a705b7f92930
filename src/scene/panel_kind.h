// A kind of panel, declared in the panel's own file: its name, its abilities (which decide the keys
// that it takes), its own keys, the function that creates it, and all else that others must know of
// it, which they never tell by its name. The list of all kinds is in panels/registry.cpp; it is
// passed to the loader as a value, because scene/ does not depend on panels/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "physics/run.h"
#include "scene/instruments/places.h"
#include "scene/keys/binding.h"
#include "scene/panel_spec.h"
#include "util/language.h"

namespace carom {

class Panel;
struct Gas;
struct PanelContext;
struct Meter;
enum class LawOf;

/// The abilities of a kind of panel. Each gives it the keys named here.
enum class Ability {
    bars,         ///< a histogram
    of,           ///< shows particles that the scene chooses: `of`
    pair,         ///< `of` is two particles; without it the first two that collide
    two,          ///< `of` is two particles, and is required
    over,         ///< takes numbers over a time: `over`
    component,    ///< along one axis: `component`, `x`, `y` or `z`
    both,         ///< the same, and all axes together: `both`, in space `all`
    two_axes,     ///< the same, and in space two axes: `xy`, `xz` or `yz`
    theory,       ///< has a curve of theory: `theory`
    equilibrium,  ///< that curve is the equilibrium's, so that bars can be tested against it:
                  ///< `test`
    means,        ///< shows the mean of several runs: `seeds` of a figure
    comparison,   ///< shows several runs, a line of each: `compare` of a figure
    any_space,    ///< its axes mean the same on a line, in a plane and in space: a comparison may
                  ///< show runs of several dimensions
    two_runs,     ///< shows what two runs have between them, and nothing of one alone
    sweep,        ///< shows the runs of a sweep: its options are a SweepShown, and `seeds` of a
                  ///< figure may name a sweep that is joined already
    strip         ///< shows several moments side by side: `strip` of a figure
};

/// An option by which a panel draws several things of one run, where a comparison shows one line
/// for each run.
struct SeveralShown {
    const char* key;    ///< that the scene gives
    const char* takes;  ///< what it may say in a comparison: "one"
    const char* hint = "make a figure for each";
};

/// What a panel does with a run, beyond a look at each particle of each frame. Its time and memory
/// depend on it.
struct PanelWork {
    /// What it does with each free flight: nothing, has it recorded, follows it exactly, sums
    /// displacements, averages over time lags, or finds the pairs that are near in it.
    enum class Flights { unseen, recorded, followed, displaced, lags, pairs };
    Flights flights = Flights::unseen;
    double longest_lag = 0.0;          ///< simulated time, of time lags
    std::optional<double> reach = {};  ///< largest distance of pairs; none: the usual one
    bool finds_neighbours = false;     ///< of each particle in each frame
    bool keeps_places = false;         ///< of its particles in all frames and samples
};

/// A number of a run for which words of a scene ask by name: what an instrument reads.
struct AskedNumber {
    std::string name;          ///< "temperature"
    std::string meaning;       ///< in plain words, for lists: "the temperature"
    std::string options = {};  ///< of the instrument, as in a scene: "origins: all"
    bool is_result = false;    ///< of the instrument; otherwise its reading
    bool is_by_line = false;   ///< a species is the name of a line; otherwise it is chosen by `of`
};

/// One kind of panel.
struct PanelKind {
    std::string name;   ///< as in scenes
    Phrase words;       ///< as in captions and transcripts
    std::string shows;  ///< a sentence for the reference page, in Markdown
    std::unique_ptr<Panel> (*make)(const PanelContext&, const PanelSpec&) = nullptr;
    /// What it reads of a run at each moment (panels/meters/meter.h), which may read nothing for
    /// the options given; null if it reads nothing.
    Meter (*meter)(const PanelContext&, const PanelSpec&) = nullptr;
    std::set<Ability> abilities = {};

    /// The numbers of its meter for which words of a scene may ask.
    std::vector<AskedNumber> asked = {};

    /// Whether it shows numbers with their units in scenes with real units; others are refused
    /// there.
    bool shows_units = false;

    /// The names of the numbers that Panel::scalars() gives, for which words of a figure may ask.
    std::vector<std::string> numbers = {};

    /// Other names that users are likely to try: the hint for them is this kind.
    std::vector<std::string> tried_as = {};

    /// Keys that only kinds like this one take; those of bars stand before those of theory. Keys of
    /// one name are the same key for all kinds that have it, but each reads it for its own options.
    std::vector<Binding<PanelSpec>> bar_keys = {}, keys = {};

    /// Reports errors of a panel of this kind beyond those of single values; the node is the
    /// panel's mapping, or the name of its kind alone.
    std::function<void(PanelSpec&, const Node&, Reading&)> rule = {};

    /// Returns whether the panel has something to show for a gas and its run. A film that lists no
    /// panels gets those of its template's list for which this is true. Empty: always.
    std::function<bool(const Gas&, const Run&)> suits = {};

    /// Returns the quantities whose theory (physics/theory/law.h) the panel may show of a gas, and
    /// of the first surface at which it measures. Empty: none.
    std::function<std::vector<LawOf>(const PanelSpec&, const Gas&)> laws = {};

    /// Returns whether the panel as a figure shows another time than the one asked for, which is
    /// known only after the run, or none. Empty: never.
    std::function<bool(const PanelSpec&)> has_own_time = {};

    /// Returns the surfaces or regions at which it measures. Empty: none.
    std::function<MeasuredAt(const PanelSpec&)> measured_at = {};

    /// Returns the option by which it draws several things of one run, beside `of`, `surfaces` and
    /// `regions`. Empty: none.
    std::function<std::optional<SeveralShown>(const PanelSpec&)> several = {};

    /// Returns the words in its options that it draws as they are written, beside names of regions.
    /// Empty: none.
    std::function<std::vector<std::string>(const PanelSpec&)> names = {};

    /// Returns the text of the scene that it shows, with formulae. Empty: none.
    std::function<std::string(const PanelSpec&)> text = {};

    /// Changes that text.
    void (*set_text)(PanelSpec&, std::string) = nullptr;

    /// Returns what it does with the run. Empty: nothing more than a look.
    std::function<PanelWork(const PanelSpec&, const Run&)> work = {};

    /// What it is called in captions and transcripts of a gas in space, if not by `words`.
    std::optional<Phrase> words_in_space = {};

    /// Whether it shows something of the run; otherwise it has no numbers, and is the same for two
    /// runs.
    bool shows_run = true;

    /// Whether it draws the box: its figure has the shape of the box, and a key beside it.
    bool draws_box = false;

    /// Whether it draws particles: in figures, too, it sees the frames of the film, not the samples
    /// of the run.
    bool draws_particles = false;

    /// Whether it has axes that a callout can point to.
    bool has_plot = true;

    /// For a kind that is only for figures: what to do in films instead; empty: for films, too.
    std::string in_films_instead = {};

    /// For a kind that has no meaning in space: what to do there instead; empty: it has one.
    std::string in_space_instead = {};

    /// For the kind that shows the gas: the names of its colour scales from slow to fast.
    std::vector<std::string> palettes = {};

    bool can(Ability ability) const { return abilities.contains(ability); }
};

/// Returns keys of a kind's options, of the type T, as keys of its panels.
template <class T>
std::vector<Binding<PanelSpec>> option_keys(std::vector<Binding<T>> keys) {
    std::vector<Binding<PanelSpec>> all;
    for (Binding<T>& key : keys)
        all.push_back(bind_within<PanelSpec>(
            [](PanelSpec& panel) -> T& { return panel.options.change<T>(); }, std::move(key)));
    return all;
}

/// A property that all panels of a kind share.
template <class Value>
auto always(Value value) {
    return [value = std::move(value)](const auto&...) { return value; };
}

using PanelKinds = std::span<const PanelKind>;

/// Returns the kind of this name; null if there is none.
inline const PanelKind* kind_of(PanelKinds kinds, std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &PanelKind::name);
    return found == kinds.end() ? nullptr : &*found;
}

}  // namespace carom
