// Clicks against their formula, written down again, and the bounds that a mix keeps.
#include "sound/clicks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "util/random.h"

using namespace carom;

namespace {

using Samples = std::vector<std::int16_t>;

// Of one click, so many samples after it began; not scaled.
double answer(double pitch, std::int64_t n) {
    const double seconds = static_cast<double>(n) / 48000.0;
    return (std::exp(-seconds / 0.015) - std::exp(-seconds / 0.001)) *
           std::sin(2.0 * std::numbers::pi * pitch * seconds);
}

int largest(const Samples& samples) {
    int most = 0;
    for (const std::int16_t one : samples) most = std::max(most, std::abs(int(one)));
    return most;
}

// Hz, from the places where the sign changes in a part, interpolated.
double pitch_by_crossings(const Samples& samples, std::size_t first, std::size_t end) {
    std::vector<double> places;
    for (std::size_t n = first; n + 1 < end; ++n)
        if ((samples[n] < 0) != (samples[n + 1] < 0))
            places.push_back(double(n) + double(samples[n]) / (samples[n] - samples[n + 1]));
    REQUIRE(places.size() > 4);
    return 48000.0 * 0.5 * double(places.size() - 1) / (places.back() - places.front());
}

std::vector<Click> many_clicks(int count, std::int64_t samples) {
    Random random(3, "clicks");
    std::vector<Click> clicks;
    for (int k = 0; k < count; ++k)
        clicks.push_back({static_cast<std::int64_t>(random.below(std::uint64_t(samples))),
                          220.0 + double(random.below(6000))});
    std::ranges::sort(clicks, {}, &Click::sample);
    return clicks;
}

}  // namespace

TEST_CASE("a single click is the difference of two decays on a tone, as loud as asked") {
    constexpr std::int64_t begin = 1234, count = 9600;
    for (const double loudness : {0.05, 0.3, 1.0})
        for (const double pitch : {220.0, 440.0, 880.0, 3520.0, 7040.0}) {
            CAPTURE(pitch);
            const Samples sound = sound_of(std::vector<Click>{{begin, pitch}}, count, loudness);
            REQUIRE(sound.size() == count);
            const int most = int(std::lround(32767 * 0.8 * loudness));
            CHECK(largest(sound) == most);
            double peak = 0.0;
            for (std::int64_t n = 0; n < 2400; ++n)
                peak = std::max(peak, std::abs(answer(pitch, n)));
            for (std::int64_t n = 0; n < count; ++n) {
                const double expected = n < begin ? 0.0 : most * answer(pitch, n - begin) / peak;
                // Rounded to a whole number, of a scale that is rounded too.
                CHECK(std::abs(sound[std::size_t(n)] - expected) <= 1.0);
            }
        }
}

TEST_CASE("a click has the pitch that it is given, to a fifth of a semitone, within five octaves") {
    for (const double pitch : {300.0, 523.25, 880.0, 1000.0, 2345.0, 6000.0}) {
        const Samples sound = sound_of(std::vector<Click>{{0, pitch}}, 4800, 1.0);
        // Half a step of the pitches, and what is left of a rounded sample.
        CHECK(pitch_by_crossings(sound, 20, 2400) == doctest::Approx(pitch).epsilon(0.0063));
    }
    const auto of = [](double pitch) {
        return sound_of(std::vector<Click>{{0, pitch}}, 4800, 1.0);
    };
    CHECK(of(0.0) == of(220.0));
    CHECK(of(1e9) == of(7040.0));
    CHECK(of(std::numeric_limits<double>::infinity()) == of(7040.0));
    CHECK(of(std::numeric_limits<double>::quiet_NaN()) == of(7040.0));
}

TEST_CASE("any number of clicks stays within the loudness, and close to it") {
    constexpr std::int64_t count = 2 * 48000;
    for (const int clicks : {50, 3000, 200'000}) {
        CAPTURE(clicks);
        const Samples sound = sound_of(many_clicks(clicks, count), count, 0.25);
        const int most = int(std::lround(32767 * 0.8 * 0.25));
        CHECK(largest(sound) <= most);
        CHECK(largest(sound) >= 0.9 * most);
    }
    // All at once, alike.
    const Samples together = sound_of(std::vector<Click>(100'000, Click{4800, 880.0}), count, 1.0);
    CHECK(largest(together) <= 26214);
    CHECK(largest(together) >= 26000);
    CHECK(std::all_of(together.begin(), together.begin() + 4800, [](int one) { return one == 0; }));
}

TEST_CASE("what is softer is softer as a whole: a mix is its clicks times a gain that is slow") {
    constexpr std::int64_t count = 9600;
    const std::vector<Click> clicks = many_clicks(400, count);
    std::vector<double> sum(count);
    for (const Click& click : clicks) {
        // The pitch that it has.
        const double steps = std::round(60.0 * std::log2(std::max(click.pitch, 220.0) / 220.0));
        const double pitch = 220.0 * std::exp2(steps / 60.0);
        double peak = 0.0;
        for (std::int64_t n = 0; n < 960; ++n) peak = std::max(peak, std::abs(answer(pitch, n)));
        for (std::int64_t n = click.sample; n < count; ++n)
            sum[std::size_t(n)] += answer(pitch, n - click.sample) / peak;
    }
    const Samples sound = sound_of(clicks, count, 1.0);
    std::optional<double> last;
    std::size_t last_place = 0;
    for (std::size_t n = 0; n < count; ++n) {
        if (std::abs(sum[n]) < 1.0) continue;  // where rounding hides the gain
        const double gain = sound[n] / (32767 * 0.8 * sum[n]);
        CHECK(gain <= 1.0 / std::abs(sum[n]) + 1e-4);
        // At most from 1 to 0 in the 480 samples of a block.
        if (last) CHECK(std::abs(gain - *last) <= double(n - last_place) / 480.0 + 1e-3);
        last = gain;
        last_place = n;
    }
    CHECK(last.value_or(1.0) < 0.5);  // it was needed
}

TEST_CASE("the samples do not depend on how they are asked for") {
    constexpr std::int64_t count = 30'000;
    const std::vector<Click> clicks = many_clicks(2000, count);
    const Samples whole = sound_of(clicks, count, 0.5);
    for (const std::int64_t step : {std::int64_t{1}, std::int64_t{479}, std::int64_t{7000}}) {
        ClickMixer mixer(0.5);
        Samples sound;
        auto next = clicks.begin();
        for (std::int64_t n = 0; n < count; n += step) {
            for (; next != clicks.end() && next->sample < n + step; ++next) mixer.add(*next);
            mixer.mix_until(n + step);
            mixer.take(sound);
        }
        sound.resize(std::min<std::size_t>(sound.size(), count));
        mixer.finish(count, sound);
        CHECK((sound == whole));
    }
    CHECK_THROWS_AS(sound_of(std::vector<Click>{{5, 880.0}, {4, 880.0}}, 10, 1.0),
                    std::invalid_argument);
    CHECK_THROWS_AS(sound_of(std::vector<Click>{{-1, 880.0}}, 10, 1.0), std::invalid_argument);
    CHECK(sound_of({}, 0, 1.0).empty());
    CHECK(sound_of({}, 1000, 1.0) == Samples(1000, 0));
}
