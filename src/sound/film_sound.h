// The sound of a film: a click for each collision of its run, at the time when the film shows it;
// the larger the impulse, the higher the pitch.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/advance_result.h"
#include "physics/particles.h"
#include "physics/surface.h"
#include "scene/time/timeline.h"
#include "sound/clicks.h"

namespace carom {

struct Film;

/// The pitch in Hz of a collision whose impulse equals the reference impulse; twice the impulse
/// sounds an octave higher.
inline constexpr double reference_pitch = 880.0;

/// The default reference impulse, used if the scene does not give one: the momentum of a particle
/// of the mean mass and the mean kinetic energy, in units of the scene. `start` is the energy at
/// time 0. If all particles are at rest, the mean potential energy is used instead; if that is not
/// above 0 either, the impulse is 1. Particles of infinite mass are left out.
double usual_impulse(const Particles& particles, const EnergyAccount& start);

/// The sound of frames of a film, made while its run is simulated. The start of the k-th frame in
/// the sound corresponds to the time that frame number k shows; between two frames time passes
/// uniformly. What happens at time 0 sounds when the gas is first shown. Not thread-safe.
class FilmSound {
  public:
    /// For frames [first, end) of a film. `ticks` is its timeline, which need not outlive this
    /// object; `particles` must. The film must have a sound (Film::sound).
    FilmSound(const Film& film, const std::vector<Tick>& ticks, const Particles& particles,
              const EnergyAccount& start, int first, int end);

    /// To be called for each frame of the timeline in order, with the collisions since the previous
    /// frame.
    void see(const Tick& tick, const AdvanceResult& advanced);

    /// To be called after the last frame. Returns samples_before(end - first) samples, all within
    /// the loudness of the film.
    std::vector<std::int16_t> samples();

  private:
    std::int64_t sample_at(double frame) const;

    const Particles& particles_;
    int fps_, first_, end_;
    int first_shown_ = 0;  ///< the first frame that shows the gas
    double reference_;
    ClickMixer mixer_;
    double time_before_ = 0.0;  ///< time of the previous frame
    std::vector<std::int16_t> samples_;
};

}  // namespace carom
