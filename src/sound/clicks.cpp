#include "sound/clicks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace carom {
namespace {

constexpr double decay_seconds = 0.015, rise_seconds = 0.001;
constexpr double recovery = 1.06;  // largest factor by which the gain rises from block to block

// Far below half a step of 16 bits, whatever the loudness.
constexpr double silence = 1e-6;

const int pitch_count =
    static_cast<int>(std::lround(pitches_to_an_octave * std::log2(highest_pitch / lowest_pitch))) +
    1;

int number_of(double pitch) {
    if (!(pitch < highest_pitch)) return pitch_count - 1;
    const double steps =
        pitches_to_an_octave * std::log2(std::max(pitch, lowest_pitch) / lowest_pitch);
    return std::min(static_cast<int>(std::lround(steps)), pitch_count - 1);
}

double pitch_of(int number) {
    return lowest_pitch * std::exp2(static_cast<double>(number) / pitches_to_an_octave);
}

double damping(double seconds) { return std::exp(-1.0 / (seconds * sound_rate)); }

// The largest sample of a response, which occurs within a few rise times and periods.
double largest_answer(double angle) {
    constexpr int enough = sound_rate / 50;
    double largest = 0.0;
    for (int n = 1; n < enough; ++n) {
        const double envelope =
            std::pow(damping(decay_seconds), n) - std::pow(damping(rise_seconds), n);
        largest = std::max(largest, std::abs(envelope * std::sin(angle * n)));
    }
    return largest;
}

}  // namespace

ClickMixer::ClickMixer(double loudness) : scale_(32767.0 * share_of_loudness * loudness) {
    oscillators_.resize(static_cast<std::size_t>((pitch_count + lanes - 1) / lanes));
    const double slow = damping(decay_seconds), fast = damping(rise_seconds);
    for (int number = 0; number < pitch_count; ++number) {
        Oscillators& oscillators = oscillators_[static_cast<std::size_t>(number / lanes)];
        const auto lane = static_cast<std::size_t>(number % lanes);
        const double angle = 2.0 * std::numbers::pi * pitch_of(number) / sound_rate;
        oscillators.slow_cos[lane] = slow * std::cos(angle);
        oscillators.slow_sin[lane] = slow * std::sin(angle);
        oscillators.fast_cos[lane] = fast * std::cos(angle);
        oscillators.fast_sin[lane] = fast * std::sin(angle);
        oscillators.gain[lane] = 1.0 / largest_answer(angle);
    }
}

void ClickMixer::add(const Click& click) {
    strikes_.push_back({click.sample, number_of(click.pitch)});
}

void ClickMixer::mix_until(std::int64_t end) {
    while (mixed_ + block <= end) mix_block();
}

// Adds the response of these oscillators during a block to its sum; `strikes` are the clicks that
// excite them, in order.
void ClickMixer::ring(Oscillators& oscillators, std::span<const Strike> strikes, int first,
                      Block& sum) const {
    auto strike = strikes.begin();
    for (int n = 0; n < block; ++n) {
        for (; strike != strikes.end() && strike->sample == mixed_ + n; ++strike) {
            const auto lane = static_cast<std::size_t>(strike->oscillator - first);
            oscillators.slow_x[lane] += oscillators.gain[lane];
            oscillators.fast_x[lane] += oscillators.gain[lane];
        }
        Lanes out;
        for (std::size_t k = 0; k < lanes; ++k) {
            out[k] = oscillators.slow_y[k] - oscillators.fast_y[k];
            const double slow_x = oscillators.slow_x[k], fast_x = oscillators.fast_x[k];
            oscillators.slow_x[k] =
                oscillators.slow_cos[k] * slow_x - oscillators.slow_sin[k] * oscillators.slow_y[k];
            oscillators.slow_y[k] =
                oscillators.slow_sin[k] * slow_x + oscillators.slow_cos[k] * oscillators.slow_y[k];
            oscillators.fast_x[k] =
                oscillators.fast_cos[k] * fast_x - oscillators.fast_sin[k] * oscillators.fast_y[k];
            oscillators.fast_y[k] =
                oscillators.fast_sin[k] * fast_x + oscillators.fast_cos[k] * oscillators.fast_y[k];
        }
        double all = 0.0;
        for (const double one : out) all += one;
        sum[static_cast<std::size_t>(n)] += all;
    }
    double largest = 0.0;
    for (std::size_t k = 0; k < lanes; ++k)
        largest =
            std::max({largest, std::abs(oscillators.slow_x[k]), std::abs(oscillators.slow_y[k])});
    oscillators.rings = largest > silence;
    if (!oscillators.rings)
        oscillators.slow_x = oscillators.slow_y = oscillators.fast_x = oscillators.fast_y = {};
}

void ClickMixer::mix_block() {
    const auto later = std::partition(strikes_.begin(), strikes_.end(), [&](const Strike& one) {
        return one.sample < mixed_ + block;
    });
    const std::span<Strike> now(strikes_.begin(), later);
    // Strikes of one pitch at the same sample are identical, so that their order does not matter.
    std::ranges::sort(
        now, {}, [](const Strike& one) { return std::pair(one.oscillator / lanes, one.sample); });
    Block sum{};
    auto strike = now.begin();
    for (std::size_t group = 0; group < oscillators_.size(); ++group) {
        const auto begin = strike;
        while (strike != now.end() && strike->oscillator / lanes == static_cast<int>(group))
            ++strike;
        Oscillators& oscillators = oscillators_[group];
        if (oscillators.rings || begin != strike)
            ring(oscillators, {begin, strike}, static_cast<int>(group) * lanes, sum);
    }
    strikes_.erase(strikes_.begin(), later);
    double largest = 0.0;
    for (const double one : sum) largest = std::max(largest, std::abs(one));
    const double most = largest > 1.0 ? 1.0 / largest : 1.0;
    if (mixed_ > 0) settle_gain(most);
    waiting_ = sum;
    most_here_ = most;
    if (mixed_ == 0) gain_ = most;
    mixed_ += block;
}

// Finishes the waiting block: its gain changes linearly from gain_ to a value that also suits the
// next block, so that neither block exceeds the largest sample.
void ClickMixer::settle_gain(double next) {
    const double end = std::min({most_here_, next, recovery * gain_});
    for (int n = 0; n < block; ++n) {
        const double gain = gain_ + (end - gain_) * n / block;
        const double sample = std::clamp(gain * waiting_[static_cast<std::size_t>(n)], -1.0, 1.0);
        ready_.push_back(static_cast<std::int16_t>(std::lround(scale_ * sample)));
    }
    gain_ = end;
}

void ClickMixer::take(std::vector<std::int16_t>& samples) {
    samples.insert(samples.end(), ready_.begin(), ready_.end());
    ready_.clear();
}

void ClickMixer::finish(std::int64_t end, std::vector<std::int16_t>& samples) {
    while (mixed_ < end + block) mix_block();
    take(samples);
    samples.resize(static_cast<std::size_t>(end));
}

std::vector<std::int16_t> sound_of(std::span<const Click> clicks, std::int64_t samples,
                                   double loudness) {
    ClickMixer mixer(loudness);
    std::vector<std::int16_t> sound;
    std::int64_t last = 0;
    for (const Click& click : clicks) {
        if (click.sample < last)
            throw std::invalid_argument("clicks are in order of their samples, from 0 on");
        last = click.sample;
        if (click.sample >= samples) break;
        mixer.mix_until(click.sample);
        mixer.add(click);
    }
    mixer.finish(samples, sound);
    return sound;
}

}  // namespace carom
