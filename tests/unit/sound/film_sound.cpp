// When a film's collisions sound, by arithmetic, and how high.
#include "sound/film_sound.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "physics/simulation.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

using Samples = std::vector<std::int16_t>;

struct Heard {
    Scene scene;
    std::vector<Tick> ticks;
    Samples samples;
};

// Of frames [first, end) of a scene's film; end 0: all.
Heard heard(const std::string& text, int first = 0, int end = 0) {
    Heard its{test::scene_from(text), {}, {}};
    its.ticks = timeline(its.scene);
    Simulation simulation(its.scene.gas, its.scene.run);
    FilmSound sound(its.scene.film, its.ticks, simulation.particles(), simulation.energy_account(),
                    first, end > 0 ? end : int(its.ticks.size()));
    simulation.record_collisions(true);
    for (const Tick& tick : its.ticks) sound.see(tick, simulation.advance_to(tick.time));
    its.samples = sound.samples();
    return its;
}

// Where sound begins after silence.
std::vector<std::int64_t> onsets(const Samples& samples) {
    constexpr std::int64_t silence = 4800;
    std::vector<std::int64_t> found;
    std::int64_t last = -silence;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        if (samples[n] == 0) continue;
        if (std::int64_t(n) - last >= silence) found.push_back(std::int64_t(n));
        last = std::int64_t(n);
    }
    return found;
}

// The film's own time at which it shows a simulated one, in samples, from its frames.
std::int64_t shown_at(const Heard& film, double time, int first = 0) {
    for (std::size_t k = 1; k < film.ticks.size(); ++k) {
        const double before = film.ticks[k - 1].time, now = film.ticks[k].time;
        if (before < time && time <= now)
            return std::llround((double(k) - 1.0 + (time - before) / (now - before) - first) *
                                48000.0 / film.scene.film.fps);
    }
    return -1;
}

// The first sample of a click is 0, and the second may round to 0.
void check_onsets(const Heard& film, const std::vector<double>& times, int first = 0) {
    const std::vector<std::int64_t> found = onsets(film.samples);
    REQUIRE(found.size() == times.size());
    for (std::size_t k = 0; k < times.size(); ++k) {
        const std::int64_t late = found[k] - shown_at(film, times[k], first);
        CHECK(late >= 0);
        CHECK(late <= 6);
    }
}

// They meet at time 3 in the middle, and walls at 7 and again each other at 11.
const std::string two_beads =
    "title: T\nbox: {length: 8}\n"
    "gas: [{radius: 0, position: [1, 7], velocity: [1, -1]}]\n";

}  // namespace

TEST_CASE("clicks begin when the film shows the collisions") {
    const Heard plain = heard(two_beads +
                              "run: {until: 12}\nfilm: {seconds: 20, fps: 10, "
                              "sound: collisions}\n");
    CHECK(plain.samples.size() == 20 * 48000);
    check_onsets(plain, {3.0, 7.0, 11.0});

    SUBCASE("in slow motion") {
        const Heard slow = heard(two_beads +
                                 "run: {until: 12}\nfilm: {seconds: 40, fps: 25, sound: "
                                 "collisions, slow: [{from: 6, to: 8, factor: 0.25}]}\n");
        check_onsets(slow, {3.0, 7.0, 11.0});
    }
    SUBCASE("with pauses and cards") {
        const Heard paused =
            heard(two_beads +
                  "run: {until: 12, events: [{at: 5, pause: 2}]}\n"
                  "film: {seconds: 30, fps: 10, sound: collisions, title_card: true, "
                  "end_card: The end}\n");
        check_onsets(paused, {3.0, 7.0, 11.0});
    }
    SUBCASE("there and back: the way back mirrors the way out") {
        const Heard back = heard(two_beads +
                                 "run: {until: 16, events: [{at: 8, reverse: velocities}]}\n"
                                 "film: {seconds: 40, fps: 10, sound: collisions}\n");
        check_onsets(back, {3.0, 7.0, 9.0, 13.0});
    }
    SUBCASE("in a part of it") {
        const Heard part = heard(two_beads +
                                     "run: {until: 12}\nfilm: {seconds: 20, fps: 10, "
                                     "sound: collisions}\n",
                                 100, 160);
        CHECK(part.samples.size() == 6 * 48000);
        check_onsets(part, {7.0}, 100);
        // It is that part of the whole.
        const std::size_t begin = 10 * 48000;
        CHECK(std::equal(part.samples.begin(), part.samples.end(), plain.samples.begin() + begin));
    }
}

TEST_CASE("the impulse gives the pitch: twice as much is an octave") {
    // Both have momentum 1 on average: they exchange 2, and each gives 2 to its wall.
    const Particles none;
    CHECK(usual_impulse(none, {}) == 1.0);
    const Heard film = heard(two_beads +
                             "run: {until: 4}\nfilm: {seconds: 10, fps: 10, sound: "
                             "{loudness: 1}}\n");
    const auto begin = std::size_t(shown_at(film, 3.0));
    const Samples alone(film.samples.begin() + std::ptrdiff_t(begin),
                        film.samples.begin() + std::ptrdiff_t(begin) + 4800);
    CHECK((alone == sound_of(std::vector<Click>{{0, 1760.0}}, 4800, 1.0)));

    const auto with_reference = [&](double reference) {
        const Heard its =
            heard(two_beads +
                  "run: {until: 4}\nfilm: {seconds: 10, fps: 10, sound: {loudness: 1, "
                  "reference: " +
                  std::to_string(reference) + "}}\n");
        return Samples(its.samples.begin() + std::ptrdiff_t(begin),
                       its.samples.begin() + std::ptrdiff_t(begin) + 4800);
    };
    CHECK((with_reference(1.0) == alone));
    CHECK((with_reference(2.0) == sound_of(std::vector<Click>{{0, 880.0}}, 4800, 1.0)));
    CHECK((with_reference(1e6) == sound_of(std::vector<Click>{{0, 220.0}}, 4800, 1.0)));
}

TEST_CASE("the usual impulse is the momentum of a particle of mean mass and mean energy") {
    Particles particles;
    particles.inverse_mass = Eigen::ArrayXd{{1.0, 0.5, 0.0}};  // masses 1, 2 and infinite
    CHECK(usual_impulse(particles, {.kinetic = 6.0}) == doctest::Approx(std::sqrt(2 * 1.5 * 3.0)));
    CHECK(usual_impulse(particles, {.kinetic = 0.0, .potential = 6.0}) ==
          doctest::Approx(std::sqrt(2 * 1.5 * 3.0)));
    CHECK(usual_impulse(particles, {}) == 1.0);
}
