// The keys of partitions, obstacles and gravity, and all surfaces of a box put together.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/reading/wall_reading.h"
#include "scene/scene.h"

namespace carom {

/// What a partition lets through.
struct PassesDraft {
    std::vector<Placed<std::string>> species = {};  ///< names
    Membrane::Speeds upward = {}, downward = {};
    const Node* node = nullptr;  ///< null: it lets nothing through
};

struct PartitionDraft : Partition, ActingDraft {
    std::optional<double> x, y;
    PassesDraft passes;
    const Node* node = nullptr;
    bool is_known = true;  ///< false: there is a mistake in it
};

Notation<std::vector<PartitionDraft>> partitions_notation();

struct ObstacleDraft : Obstacle {
    std::optional<Eigen::Array2d> disk;
    std::optional<double> radius;
    std::optional<std::array<double, 4>> rectangle;  ///< x0, y0, x1, y1
    std::vector<Eigen::Array2d> polygon, segment;
    const Node* node = nullptr;
    bool is_known = true;
};

Notation<std::vector<ObstacleDraft>> obstacles_notation();

/// The acceleration of all that can move: [x, y], or a number on a wire.
Notation<Eigen::Array2d> gravity_notation(int dimension);

/// The surfaces of a scene as they are written, but for the sides.
struct SurfacesDraft {
    Placed<Eigen::Array2d> gravity{{0.0, 0.0}, nullptr};
    std::vector<PartitionDraft> partitions;
    std::vector<ObstacleDraft> obstacles;
};

/// Surfaces and where they are written.
struct PlacedSurfaces {
    Surfaces surfaces;
    std::vector<const Node*> nodes;   ///< by their numbers; null: a side that is not written
    std::vector<std::string> others;  ///< names of those that a mistake leaves out
};

/// All that are written without mistakes. Species are found by their names.
PlacedSurfaces surfaces_of(const SidesDraft& sides, const SurfacesDraft& draft,
                           const std::vector<std::string>& species, Errors& errors);

/// Where among species this name is; reported at its node if it is nowhere.
std::optional<std::int32_t> species_named(const Node& name, const std::vector<std::string>& species,
                                          Errors& errors);

}  // namespace carom
