// What a scene shows, in words for those who cannot see it, in a language.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace carom {

/// What the film shows, in a plain sentence or two.
std::string describe(const Scene& scene);

/// "1 disk", "30 beads": of a gas in so many dimensions.
std::string particles_counted(Language language, long long count, int dimension);

/// "The left wall", "The partition “divider”", "The obstacle “peg”": by its number (surface.h).
std::string name_of_surface(Language language, std::int32_t surface, const Gas& gas);

/// What one does that stands across an axis, as it follows its name: "is a heat bath of temperature
/// 2".
std::string words_of(Language language, const Behaviour& behaviour, const Gas& gas, int axis);

/// What surfaces there are and what they do, each in a sentence without its full stop; none if
/// there are only walls that reflect. Obstacles and gravity come last, a sentence each.
std::vector<std::string> words_of_surfaces(Language language, const Gas& gas);

/// "Particle 3 is moved by 1.00×10⁻²⁰": a whole sentence without its full stop.
std::string words_of(Language language, const Perturbation& nudge);

/// What happens to a surface or to the heat of the gas, as above: "The partition “divider” opens";
/// empty for other events.
std::string words_of_surface_event(Language language, const RunEvent& event, const Gas& gas);

/// What happens at a time: "time 190, on the way back", "The partition “divider” closes".
struct Happening {
    double at;
    std::string when, words;
};

/// What happens to surfaces and to the heat of the gas; then what of it comes again after a
/// reversal; then where the gas does not go on the way it came.
std::vector<Happening> happenings(Language language, const Run& run, const Gas& gas);

/// What the events of a run do, in whole sentences; empty if there are none. Of many nudges only
/// how many they are, and so of many events of surfaces; those that come again after a reversal are
/// last.
std::string words_of_events(Language language, const Run& run, const Gas& gas);

}  // namespace carom
