// The instruments that a scene reads in its runs (Scene::measure): their numbers, by name, and
// their readings at the end of a run.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "physics/simulation.h"
#include "runs/run.h"

namespace carom {

struct Scene;

class RunMeters {
  public:
    /// Meters of a run that begins with `start`, at time 0. Throws SceneError if two give numbers
    /// of the same name. The scene and the particles must outlive the object.
    RunMeters(const Scene& scene, const Particles& particles, const Sample& start);
    ~RunMeters();
    RunMeters(const RunMeters&) = delete;
    RunMeters& operator=(const RunMeters&) = delete;

    /// Takes collisions in order of time.
    void take(std::span<const Collision> collisions);

    /// Reads the meters at the next sample or event of the run; all collisions until then have been
    /// taken.
    void see(const Sample& sample, const AdvanceResult& advanced);

    /// The last readings, in the order of the scene, without what theory expects.
    std::vector<LastReading> readings() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The numbers that a scene's instruments read. Draws the particles, since what there is to read
/// depends on them. Throws SceneError as RunMeters.
std::vector<RunNumber> numbers_of_instruments(const Scene& scene);

}  // namespace carom
