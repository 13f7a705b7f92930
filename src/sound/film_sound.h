// The sound of a film: a click for each collision of its run, when the film shows it, the higher
// the larger its impulse is.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/advance_result.h"
#include "physics/particles.h"
#include "physics/surface.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "sound/clicks.h"

namespace carom {

/// Hz of a collision whose impulse is the reference; twice the impulse is an octave higher.
inline constexpr double reference_pitch = 880.0;

/// The impulse of a collision that sounds at reference_pitch where the scene does not say it: the
/// momentum of a particle of the mean mass and the mean kinetic energy. `start` is the energy at
/// time 0. Where all are at rest the mean potential energy counts instead, and without any it is
/// 1. Particles of infinite mass are left out. In units of the scene.
double usual_impulse(const Particles& particles, const EnergyAccount& start);

/// The sound of frames of a film, made as its run is simulated. The frame number k shows the run at
/// a time, and so does the beginning of its k-th frame in sound; between two frames time passes
/// evenly. What happens at time 0 sounds when the gas is first shown. Not for sharing between
/// threads.
class FilmSound {
  public:
    /// Of frames [first, end) of a film with these `ticks`, its timeline, which need not outlive
    /// this; `particles` do. The film has a sound (Film::sound).
    FilmSound(const Film& film, const std::vector<Tick>& ticks, const Particles& particles,
              const EnergyAccount& start, int first, int end);

    /// Each frame of the timeline in order, with the collisions since the one before.
    void see(const Tick& tick, const AdvanceResult& advanced);

    /// After the last frame: samples_before(end - first) of them, all within the loudness of the
    /// film.
    std::vector<std::int16_t> samples();

  private:
    std::int64_t sample_at(double frame) const;

    const Particles& particles_;
    int fps_, first_, end_;
    int first_shown_ = 0;  ///< frame of the gas
    double reference_;
    ClickMixer mixer_;
    double time_before_ = 0.0;  ///< of the frame before
    std::vector<std::int16_t> samples_;
};

}  // namespace carom
