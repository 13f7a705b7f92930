// The numbers for which words of a scene may ask, by name: readings of instruments, of all
// particles, of a species or a particle, or of a surface.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/numbers_in_words.h"
#include "scene/panel_kind.h"
#include "util/diagnostics.h"

namespace carom {

struct FigureSpec;
struct Scene;

/// Finds what reads each number for which words of the scene ask. Returns an error for each that
/// nothing reads, or whose time is beyond the run.
std::vector<Diagnostic> find_instruments(Scene& scene, PanelKinds kinds);

/// A number of a scene: its name, and the words for what it is, in English.
struct KnownNumber {
    std::string name, meaning;
};

/// Returns the numbers that words of the scene may ask for.
std::vector<KnownNumber> known_numbers(const Scene& scene, PanelKinds kinds);

/// Returns those that words of a figure may ask for besides: what the figure itself shows.
std::vector<KnownNumber> known_numbers(const FigureSpec& figure, PanelKinds kinds);

}  // namespace carom
