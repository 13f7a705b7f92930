// How a film colours, labels and measures what it shows: the words of its keys as values.
#pragma once

#include <optional>
#include <string>

namespace carom {

enum class ThemeName { light, dark, print };

enum class ColorBy { speed, speed_class, energy, direction, species, mass };

enum class Labels { none, mass, index };

/// A quantity that a row of monitors can show.
enum class Monitor {
    time,
    collisions,  ///< between particles
    mean_speed,
    mean_energy,
    slow,
    medium,
    fast,
    all_collisions,   ///< between particles and with walls
    return_distance,  ///< the largest of all particles, after a reversal
    overlap           ///< the largest so far of two colliding particles
};

/// How a species is drawn.
struct SpeciesLook {
    std::optional<std::string> color;    ///< #rrggbb, of its disks and lines in all pictures
    bool fill = true;                    ///< false: rings
    std::string label;                   ///< a word shown next to it, may be empty
    std::optional<double> trail;         ///< seconds of film; none: as the film's Trails say
    std::optional<double> drawn_radius;  ///< as a length; none: their radius times `scale`
    double scale = 1.0;                  ///< of the picture's disks, at least 1
};

/// What a field or a profile shows of the particles in a cell.
enum class FieldOf {
    density,       ///< particles in a unit of area
    temperature,   ///< of their motion relative to the cell's mean velocity
    speed,         ///< their mean
    flow,          ///< their mean velocity, as arrows
    concentration  ///< the share of a species
};

enum class SoundOf { collisions };

}  // namespace carom
