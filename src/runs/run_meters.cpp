#include "runs/run_meters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "panels/meters/meter.h"
#include "panels/precision.h"
#include "panels/recording.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "runs/run_numbers.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {
namespace {

struct Instrument {
    const PanelSpec* spec;
    MeterReader reader;
    std::vector<double> last = {};
};

// "temperature at the end", "pressure at the end (on the walls)", or the title that the scene
// gives.
std::string name_of_number(const Instrument& instrument, const MeterLine& line,
                           std::ptrdiff_t lines) {
    const std::string what =
        instrument.spec->title
            ? *instrument.spec->title
            : std::string(instrument.reader.meter().quantity.word.english) + " at the end";
    const bool is_enough = line.name.empty() || (instrument.spec->title && lines == 1);
    return is_enough ? what : fmt::format("{} ({})", what, line.column);
}

// Those that are measured.
std::vector<RunNumber> numbers_of(const Instrument& instrument) {
    const Meter& meter = instrument.reader.meter();
    const auto lines = std::ranges::count(meter.lines, false, &MeterLine::is_theory);
    std::vector<RunNumber> numbers;
    for (const MeterLine& line : meter.lines)
        if (!line.is_theory)
            numbers.push_back({name_of_number(instrument, line, lines), meter.quantity});
    return numbers;
}

}  // namespace

struct RunMeters::Parts {
    const Particles& particles;
    BoxedGas gas;
    std::vector<Instrument> instruments = {};
    JoinedCollisions collisions = {};
    bool needs_collisions = false;
};

RunMeters::~RunMeters() = default;

RunMeters::RunMeters(const Scene& scene, const Particles& particles, const Sample& start)
    : parts_(new Parts{particles, {scene.gas.box, scene.run.events, particles, start}}) {
    constexpr bool in_film = false;
    const PanelContext context{scene, parts_->particles, 0, parts_->gas, in_film};
    for (const PanelSpec& spec : scene.measure) {
        Meter meter = kind_of(spec).meter(context, spec);
        if (!meter.read)
            refuse(spec.place,
                   fmt::format("`{}` reads no single numbers with these options", spec.kind),
                   "show it in a figure");
        parts_->needs_collisions = parts_->needs_collisions || meter.needs_collisions;
        parts_->instruments.push_back({&spec, MeterReader(std::move(meter))});
    }
    std::set<std::string> known;
    for (const RunNumber& number : numbers_of_summary(scene)) known.insert(number.name);
    for (const Instrument& instrument : parts_->instruments)
        for (const RunNumber& number : numbers_of(instrument))
            if (!known.insert(number.name).second)
                refuse(instrument.spec->place,
                       fmt::format("another number is called `{}`, too", number.name),
                       "give the instrument a `title`, by which its number is called");
}

void RunMeters::take(std::span<const Collision> collisions) {
    if (parts_->needs_collisions) parts_->collisions.add(collisions);
}

void RunMeters::see(const Sample& sample, const AdvanceResult& advanced) {
    const Eigen::ArrayXd speed = speeds(sample);
    const Eigen::ArrayXd energy = kinetic_energies(parts_->particles, sample);
    Tick tick;
    tick.time = sample.time;
    AdvanceResult whole = advanced;
    whole.collisions = parts_->collisions.take({});
    for (Instrument& instrument : parts_->instruments)
        instrument.last = instrument.reader({tick, sample, speed, energy, whole});
}

std::vector<LastReading> RunMeters::readings() const {
    std::vector<LastReading> all;
    for (const Instrument& instrument : parts_->instruments) {
        const std::vector<MeterLine>& lines = instrument.reader.meter().lines;
        std::vector<RunNumber> numbers = numbers_of(instrument);
        for (std::size_t line = 0, k = 0; line < lines.size(); ++line)
            if (!lines[line].is_theory)
                all.push_back({std::move(numbers.at(k++)),
                               instrument.last.empty() ? std::nan("") : instrument.last.at(line)});
    }
    return all;
}

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
