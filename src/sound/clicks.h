// The sound of clicks: tones that die away, mixed to samples that stay within a loudness. A pure
// function of when the clicks begin and how high they are; knows nothing of collisions and files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sound/rate.h"

namespace carom {

/// Hertz. Clicks that would be lower or higher have these pitches.
inline constexpr double lowest_pitch = 220.0, highest_pitch = 7040.0;

/// A click has the nearest of so many pitches to an octave, a fifth of a semitone apart: at most
/// 0.6 % from its own.
inline constexpr int pitches_to_an_octave = 60;

/// The largest sample, as a share of what is asked for: a lossy encoder overshoots by less than the
/// rest.
inline constexpr double share_of_loudness = 0.8;

struct Click {
    std::int64_t sample = 0;  ///< at which it begins
    double pitch = 0.0;       ///< Hz, of any size; infinity and NaN are the highest
};

/// Mixes clicks to samples, as they come. A single click rises within 3 ms to the largest sample
/// and falls with a time constant of 15 ms. Where several together would be louder they are all
/// softer there: the gain falls over 10 ms before and comes back by 6 % in 10 ms. The memory does
/// not depend on the number of clicks. Not for sharing between threads.
class ClickMixer {
  public:
    /// The largest sample is `loudness` * share_of_loudness, from 0 to 1 of full scale, which is
    /// 32767.
    explicit ClickMixer(double loudness);

    /// A click; none begins before the samples that are mixed already.
    void add(const Click& click);

    /// Mixes all samples before number `end`. No later click begins before it.
    void mix_until(std::int64_t end);

    /// Appends to `samples` those that are ready, which are some 20 ms behind.
    void take(std::vector<std::int16_t>& samples);

    /// Mixes all before number `end`, and appends them, `end` in all.
    void finish(std::int64_t end, std::vector<std::int16_t>& samples);

  private:
    static constexpr int block = sound_rate / 100;  ///< samples that share a gain
    static constexpr int lanes = 8;                 ///< oscillators that are worked on side by side
    using Lanes = std::array<double, lanes>;
    using Block = std::array<double, block>;

    /// Damped oscillators, struck by clicks: each answers with (a^n - b^n) sin(w n) after n
    /// samples, as the difference of two rotations.
    struct Oscillators {
        Lanes slow_cos{}, slow_sin{}, fast_cos{}, fast_sin{};  ///< of one step
        Lanes gain{};  ///< by which the largest sample of an answer is 1
        Lanes slow_x{}, slow_y{}, fast_x{}, fast_y{};
        bool rings = false;
    };
    struct Strike {
        std::int64_t sample;
        int oscillator;
    };

    void mix_block();
    void ring(Oscillators& its, std::span<const Strike> strikes, int first, Block& sum) const;
    void settle_gain(double next);

    double scale_;  ///< a sample of 1 in units of the last bit
    std::vector<Oscillators> oscillators_;
    std::vector<Strike> strikes_;  ///< from mixed_ on
    std::int64_t mixed_ = 0;       ///< samples, a whole number of blocks
    Block waiting_{};              ///< the last of them, whose gain at the end is not known
    double most_here_ = 1.0;       ///< the largest gain for it
    double gain_ = 1.0;            ///< at its begin
    std::vector<std::int16_t> ready_;
};

/// All samples of a sound of so many: those of the clicks, in order of their samples, that begin in
/// it. Throws std::invalid_argument where they are not in order or one begins before 0.
std::vector<std::int16_t> sound_of(std::span<const Click> clicks, std::int64_t samples,
                                   double loudness);

}  // namespace carom
