// Descriptions of what a scene shows, in a given language, for readers who cannot see the film.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "physics/run.h"
#include "physics/units/number_text.h"
#include "util/language.h"

namespace carom {

struct Gas;
struct NamedGas;

struct Scene;

/// Returns what the film shows, in a few plain sentences.
std::string describe(const Scene& scene);

/// Returns a sentence that the molecules among these gases are spheres; empty without molecules.
std::string words_of_molecules(Language language, const std::vector<const NamedGas*>& gases);

/// Returns a count of particles, "1 disk", "30 beads" or "9 spheres", for a gas of the given
/// dimension.
std::string particles_counted(Language language, long long count, int dimension);

/// Returns the two directions across a line or a surface, toward larger coordinates first: "to the
/// right" and "to the left", "upwards" and "downwards", or "to the front" and "to the back".
std::array<Phrase, 2> ways_across(int axis);

/// Returns the name of a surface, given its number (surface.h): "The left wall", "The partition
/// “divider”", "The obstacle “peg”".
std::string name_of_surface(Language language, std::int32_t surface, const Gas& gas);

/// Returns the predicate of a sentence about a surface across an axis, to follow its name: "is a
/// heat bath of temperature 2".
std::string words_of(const Wording& wording, const Behaviour& behaviour, const Gas& gas, int axis);

/// Returns a sentence, without its full stop, for each surface and its behaviour; empty if there
/// are only reflecting walls. The obstacles together and gravity come last, in one sentence each.
std::vector<std::string> words_of_surfaces(const Wording& wording, const Gas& gas);

/// Returns a whole sentence without its full stop: "Particle 3 is moved by 1.00×10⁻²⁰".
std::string words_of(const Wording& wording, const Perturbation& nudge);

/// Returns what an event does to a surface or to the heat of the gas, as a sentence without its
/// full stop: "The partition “divider” opens"; empty for other events.
std::string words_of_surface_event(const Wording& wording, const RunEvent& event, const Gas& gas);

/// What happens at a time, in words: "time 190, on the way back", "The partition “divider” closes".
struct Happening {
    double at;
    std::string when, words;
};

/// Returns what happens to surfaces and to the heat of the gas; then the events that recur mirrored
/// in time after a reversal; then the times at which the gas departs from the way it came.
std::vector<Happening> happenings(const Wording& wording, const Run& run, const Gas& gas);

/// Returns what the events of a run do, in whole sentences; empty if there are none. Many nudges,
/// or many changes of surfaces and heat, are summarised by their number. Events that recur after a
/// reversal come last.
std::string words_of_events(const Wording& wording, const Run& run, const Gas& gas);

}  // namespace carom
