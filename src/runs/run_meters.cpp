#include "runs/run_meters.h"

#include <fmt/format.h>

#include <set>
#include <string>

#include "panels/meters/instruments.h"
#include "panels/precision.h"
#include "panels/recording.h"
#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "runs/run_numbers.h"
#include "scene/scene.h"

namespace carom {

struct RunMeters::Parts {
    const Particles& particles;
    BoxedGas gas;
    PanelContext context;
    Instruments instruments;
    JoinedCollisions collisions = {};

    Parts(const Scene& scene, const Particles& of, const Sample& start)
        : particles(of),
          gas{scene.gas.box, scene.run.events, particles, start},
          context{scene, particles, 0, gas, false},
          instruments(context, scene.measure) {}
};

RunMeters::~RunMeters() = default;

RunMeters::RunMeters(const Scene& scene, const Particles& particles, const Sample& start)
    : parts_(new Parts(scene, particles, start)) {
    std::set<std::string> known;
    for (const RunNumber& number : numbers_of_summary(scene)) known.insert(number.name);
    std::size_t k = 0;
    for (const std::vector<RunNumber>& numbers : parts_->instruments.numbers()) {
        const PanelSpec& spec = scene.measure.at(k++);
        for (const RunNumber& number : numbers)
            if (!known.insert(number.name).second)
                refuse(spec.place, fmt::format("another number is called `{}`, too", number.name),
                       "give the instrument a `title`, by which its number is called");
    }
}

void RunMeters::take(std::span<const Collision> collisions) {
    if (parts_->instruments.need_collisions()) parts_->collisions.add(collisions);
}

void RunMeters::see(const Sample& sample, const AdvanceResult& advanced) {
    Tick tick;
    tick.time = sample.time;
    AdvanceResult whole = advanced;
    whole.collisions = parts_->collisions.take({});
    parts_->instruments.see(
        {tick, sample, speeds(sample), kinetic_energies(parts_->particles, sample), whole});
}

std::vector<LastReading> RunMeters::readings() const { return parts_->instruments.readings(); }

std::vector<RunNumber> numbers_of_instruments(const Scene& scene) {
    if (scene.measure.empty()) return {};
    std::vector<RunNumber> numbers;
    with_places_of_errors(scene, [&] {
        const auto [particles, sample] = draw_gas(scene.gas);
        for (LastReading& reading : RunMeters(scene, particles, sample).readings())
            numbers.push_back(std::move(reading.number));
    });
    return numbers;
}

}  // namespace carom
