// The sound of clicks: decaying tones, mixed to samples that stay within a given loudness. A pure
// function of the starts and pitches of the clicks; independent of collisions and files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sound/rate.h"

namespace carom {

/// The range of pitches in Hz; clicks that would be lower or higher are given these pitches.
inline constexpr double lowest_pitch = 220.0, highest_pitch = 7040.0;

/// The number of available pitches per octave, spaced a fifth of a semitone; a click sounds at the
/// nearest one, at most 0.6 % from its own pitch.
inline constexpr int pitches_to_an_octave = 60;

/// The largest sample as a fraction of the loudness asked for: the rest is headroom for lossy
/// encoders, which overshoot by less than that.
inline constexpr double share_of_loudness = 0.8;

struct Click {
    std::int64_t sample = 0;  ///< at which it begins
    double pitch = 0.0;       ///< Hz, of any size; infinity and NaN are the highest
};

/// Mixes clicks to samples as they arrive. A single click rises to its largest sample within 3 ms
/// and decays with a time constant of 15 ms. Where several clicks together would be too loud, all
/// are attenuated: the gain falls during the 10 ms before and recovers by 6 % per 10 ms. The memory
/// does not depend on the number of clicks. Not thread-safe.
class ClickMixer {
  public:
    /// The largest sample is `loudness` * share_of_loudness; `loudness` is from 0 to 1 of full
    /// scale (32767).
    explicit ClickMixer(double loudness);

    /// Adds a click, which must not begin before the samples that are already mixed.
    void add(const Click& click);

    /// Mixes the samples before number `end`, in whole blocks. Clicks added later must not begin
    /// before `end`.
    void mix_until(std::int64_t end);

    /// Appends the finished samples to `samples`; they lag some 20 ms behind mix_until().
    void take(std::vector<std::int16_t>& samples);

    /// Mixes everything before number `end` and appends it to `samples`, which then has `end`
    /// samples in all.
    void finish(std::int64_t end, std::vector<std::int16_t>& samples);

  private:
    static constexpr int block = sound_rate / 100;  ///< samples that share a gain
    static constexpr int lanes = 8;                 ///< oscillators that are computed side by side
    using Lanes = std::array<double, lanes>;
    using Block = std::array<double, block>;

    /// Damped oscillators that clicks excite. The response after n samples is (a^n - b^n) sin(w n),
    /// computed as the difference of two damped rotations.
    struct Oscillators {
        Lanes slow_cos{}, slow_sin{}, fast_cos{}, fast_sin{};  ///< rotation by one sample
        Lanes gain{};  ///< makes the largest sample of a response 1
        Lanes slow_x{}, slow_y{}, fast_x{}, fast_y{};
        bool rings = false;
    };
    struct Strike {
        std::int64_t sample;
        int oscillator;
    };

    void mix_block();
    void ring(Oscillators& oscillators, std::span<const Strike> strikes, int first,
              Block& sum) const;
    void settle_gain(double next);

    double scale_;  ///< the integer value of a sample of 1
    std::vector<Oscillators> oscillators_;
    std::vector<Strike> strikes_;  ///< those not yet mixed, from sample `mixed_` on
    std::int64_t mixed_ = 0;       ///< number of mixed samples, a multiple of `block`
    Block waiting_{};              ///< the last mixed block, whose gain at its end is not yet known
    double most_here_ = 1.0;       ///< the largest gain allowed for `waiting_`
    double gain_ = 1.0;            ///< gain at the beginning of `waiting_`
    std::vector<std::int16_t> ready_;
};

/// Mixes a whole sound of `samples` samples from clicks, which must be in order of their samples;
/// clicks that begin after its end are ignored. Throws std::invalid_argument if they are not in
/// order or one begins before sample 0.
std::vector<std::int16_t> sound_of(std::span<const Click> clicks, std::int64_t samples,
                                   double loudness);

}  // namespace carom
