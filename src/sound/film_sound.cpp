#include "sound/film_sound.h"

#include <algorithm>
#include <cmath>

#include "physics/mechanics.h"

namespace carom {

double usual_impulse(const Particles& particles, const EnergyAccount& start) {
    double mass = 0.0, count = 0.0;
    for (const double inverse : particles.inverse_mass)
        if (inverse > 0.0) mass += 1.0 / inverse, count += 1.0;
    const double energy = start.kinetic > 0.0 ? start.kinetic : start.potential;
    if (count == 0.0 || !(energy > 0.0)) return 1.0;
    return std::sqrt(2.0 * mass * energy) / count;
}

FilmSound::FilmSound(const Film& film, const std::vector<Tick>& ticks, const Particles& particles,
                     const EnergyAccount& start, int first, int end)
    : particles_(particles),
      fps_(film.fps),
      first_(first),
      end_(end),
      reference_(film.sound->reference.value_or(usual_impulse(particles, start))),
      mixer_(film.sound->loudness) {
    const auto shown =
        std::ranges::find_if(ticks, [](const Tick& tick) { return !is_card(tick.phase); });
    if (shown != ticks.end()) first_shown_ = shown->frame;
    samples_.reserve(static_cast<std::size_t>(samples_before(end - first, fps_)));
}

std::int64_t FilmSound::sample_at(double frame) const {
    return std::llround((frame - first_) * sound_rate / fps_);
}

void FilmSound::see(const Tick& tick, const AdvanceResult& advanced) {
    const double passed = tick.time - time_before_;
    for (const Collision& one : advanced.collisions) {
        const double frame =
            tick.frame == 0 ? first_shown_
            : passed > 0.0  ? tick.frame - 1 + std::min(1.0, (one.time - time_before_) / passed)
                            : tick.frame;
        const std::int64_t sample = sample_at(frame);
        if (sample < 0 || frame >= end_) continue;
        const double impulse = length(impulse_of(particles_, one));
        mixer_.add({sample, reference_pitch * impulse / reference_});
    }
    time_before_ = tick.time;
    if (tick.frame <= first_ || tick.frame > end_) return;
    mixer_.mix_until(sample_at(tick.frame));
    mixer_.take(samples_);
}

std::vector<std::int16_t> FilmSound::samples() {
    mixer_.finish(samples_before(end_ - first_, fps_), samples_);
    return std::move(samples_);
}

}  // namespace carom
