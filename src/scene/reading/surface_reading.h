// The keys of partitions, obstacles and gravity, and the list of all surfaces of a box.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/box.h"
#include "scene/keys/binding.h"
#include "scene/reading/wall_reading.h"

namespace carom {

/// The particles that a partition lets through.
struct PassesDraft {
    std::vector<Placed<std::string>> species = {};  ///< names
    Membrane::Speeds upward = {}, downward = {};
    const Node* node = nullptr;  ///< null: it lets nothing through
};

struct PartitionDraft : Partition, ActingDraft {
    std::optional<double> x, y, z;
    PassesDraft passes;
    const Node* node = nullptr;
    bool is_known = true;  ///< false: it contains a mistake
};

/// The partitions of a box of two or three dimensions.
Notation<std::vector<PartitionDraft>> partitions_notation(int dimension);

struct ObstacleDraft : Obstacle {
    std::optional<Vec> center;  ///< of a disk or a sphere
    std::optional<double> radius;
    std::optional<Region> block;  ///< a rectangle or a cuboid
    std::vector<Vec> polygon, segment;
    const Node* node = nullptr;
    bool is_known = true;
};

/// The obstacles in a box of two or three dimensions.
Notation<std::vector<ObstacleDraft>> obstacles_notation(int dimension);

/// Gravity and the surfaces of a scene as read from the file, without the sides of the box.
struct SurfacesDraft {
    Placed<Vec> gravity{{0.0, 0.0}, nullptr};
    std::vector<PartitionDraft> partitions;
    std::vector<ObstacleDraft> obstacles;
};

/// The surfaces of a box and their places in the file.
struct PlacedSurfaces {
    Surfaces surfaces;
    std::vector<const Node*> nodes;   ///< indexed by surface number; null: a side not in the file
    std::vector<std::string> others;  ///< names of surfaces left out because of a mistake
};

/// Returns all surfaces of a box of this dimension that are written without mistakes. `species` are
/// the names of the species, to which partitions refer.
PlacedSurfaces surfaces_of(int dimension, const SidesDraft& sides, const SurfacesDraft& draft,
                           const std::vector<std::string>& species, Errors& errors);

/// Returns the index of the species with this name; if there is none, reports it at `name` and
/// returns nothing.
std::optional<std::int32_t> species_named(const Node& name, const std::vector<std::string>& species,
                                          Errors& errors);

}  // namespace carom
