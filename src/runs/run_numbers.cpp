#include "runs/run_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "physics/vec.h"
#include "physics/ways_back.h"
#include "runs/run_meters.h"
#include "scene/scene.h"

namespace carom {
namespace {

using Row = std::pair<RunNumber, std::optional<double>>;
using Rows = std::vector<Row>;

// A scene and, optionally, one of its runs; without a run all values are missing. Names and values
// are made by the same list, so that they cannot disagree.
struct SceneAndRun {
    const Scene& scene;
    const RunReport* report;

    template <class Value>
    std::optional<double> of_report(const Value& value) const {
        if (report == nullptr) return std::nullopt;
        return value(*report);
    }

    template <class Value>
    std::optional<double> of_summary(const Value& value) const {
        return of_report([&](const RunReport& reported) { return value(reported.summary); });
    }
};

bool is_infinite(const Species& species) { return std::holds_alternative<Infinite>(species.mass); }

// The mean over all particles of finite mass, computed from the means of each species.
std::optional<double> over_species(const Scene& scene, const RunSummary& summary,
                                   std::optional<double> SpeciesMeans::*mean) {
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < summary.species.size(); ++k) {
        const SpeciesMeans& means = summary.species[k];
        if (means.count == 0 || is_infinite(scene.gas.species.at(k))) continue;
        if (!(means.*mean)) return std::nullopt;
        sum += static_cast<double>(means.count) * *(means.*mean);
        count += static_cast<double>(means.count);
    }
    if (count == 0.0) return std::nullopt;
    return sum / count;
}

// Collisions per particle and unit of time; each collision involves two particles.
double collision_rate(const Scene& scene, const RunReport& report) {
    return 2.0 * static_cast<double>(report.collisions.particle) /
           (static_cast<double>(report.particles) * scene.run.until);
}

// The total path length of all particles, divided by the number of their collisions. Not available
// with infinite masses, because collisions with these are not counted separately.
std::optional<double> mean_free_path(const Scene& scene, const RunReport& report) {
    if (std::ranges::any_of(scene.gas.species, is_infinite)) return std::nullopt;
    const std::optional<double> speed = over_species(scene, report.summary, &SpeciesMeans::speed);
    if (!speed || report.collisions.particle == 0) return std::nullopt;
    return *speed / collision_rate(scene, report);
}

void add_thermal(Rows& rows, const SceneAndRun& from) {
    const Quantity pressure = quantities::pressure(from.scene.gas.box.dimension);
    rows.push_back(
        {{"temperature", quantities::temperature},
         from.of_summary([](const RunSummary& summary) { return summary.temperature; })});
    rows.push_back(
        {{"mean energy", quantities::energy}, from.of_summary([&](const RunSummary& summary) {
             return over_species(from.scene, summary, &SpeciesMeans::energy);
         })});
    rows.push_back(
        {{"mean speed", quantities::speed}, from.of_summary([&](const RunSummary& summary) {
             return over_species(from.scene, summary, &SpeciesMeans::speed);
         })});
    rows.push_back({{"wall pressure", pressure}, from.of_summary([](const RunSummary& summary) {
                        return summary.wall_pressure;
                    })});
    rows.push_back({{"virial pressure", pressure}, from.of_summary([](const RunSummary& summary) {
                        return summary.virial_pressure;
                    })});
}

void add_collisions(Rows& rows, const SceneAndRun& from) {
    rows.push_back(
        {{"particle collisions", quantities::count}, from.of_report([](const RunReport& report) {
             return static_cast<double>(report.collisions.particle);
         })});
    rows.push_back(
        {{"wall collisions", quantities::count}, from.of_report([](const RunReport& report) {
             return static_cast<double>(report.collisions.wall);
         })});
    rows.push_back(
        {{"collision rate", quantities::rate}, from.of_report([&](const RunReport& report) {
             return collision_rate(from.scene, report);
         })});
    rows.push_back(
        {{"mean free path", quantities::length}, from.of_report([&](const RunReport& report) {
             return mean_free_path(from.scene, report);
         })});
}

void add_conserved(Rows& rows, const SceneAndRun& from) {
    rows.push_back(
        {{"energy at the start", quantities::energy},
         from.of_summary([](const RunSummary& summary) { return summary.energy_initial; })});
    rows.push_back(
        {{"energy at the end", quantities::energy},
         from.of_summary([](const RunSummary& summary) { return summary.energy_final; })});
    rows.push_back(
        {{"largest energy error", quantities::number},
         from.of_summary([](const RunSummary& summary) { return summary.largest_energy_error; })});
    rows.push_back(
        {{"largest overlap", quantities::overlap},
         from.of_summary([](const RunSummary& summary) { return summary.largest_overlap; })});
}

// Adds the means of each species, if there are several.
void add_species(Rows& rows, const SceneAndRun& from) {
    const std::vector<Species>& all = from.scene.gas.species;
    for (std::size_t k = 0; all.size() > 1 && k < all.size(); ++k) {
        rows.push_back({{"mean energy of " + all[k].name, quantities::energy},
                        from.of_summary(
                            [&](const RunSummary& summary) { return summary.species[k].energy; })});
        rows.push_back(
            {{"mean speed of " + all[k].name, quantities::speed},
             from.of_summary([&](const RunSummary& summary) { return summary.species[k].speed; })});
    }
}

void add_surface(Rows& rows, const SceneAndRun& from, const std::string& name) {
    const auto of = [&](const auto& value) {
        return from.of_report([&](const RunReport& report) -> std::optional<double> {
            const auto found = std::ranges::find(report.surfaces, name, &SurfaceReport::name);
            if (found == report.surfaces.end()) return std::nullopt;
            return value(*found);
        });
    };
    rows.push_back({{"hits on " + name, quantities::count}, of([](const SurfaceReport& surface) {
                        return static_cast<double>(surface.totals.hits);
                    })});
    for (int axis = 0; axis < from.scene.gas.box.dimension; ++axis)
        rows.push_back(
            {{fmt::format("impulse on {} along {}", name, name_of_axis(axis)),
              quantities::momentum},
             of([&](const SurfaceReport& surface) { return surface.totals.impulse[axis]; })});
    rows.push_back({{"work of " + name, quantities::energy},
                    of([](const SurfaceReport& surface) { return surface.totals.work; })});
    rows.push_back({{"heat from " + name, quantities::energy},
                    of([](const SurfaceReport& surface) { return surface.totals.heat; })});
    rows.push_back(
        {{"mean position of " + name, quantities::length}, of([](const SurfaceReport& surface) {
             return surface.position ? std::optional(surface.position->mean) : std::nullopt;
         })});
    rows.push_back(
        {{"last position of " + name, quantities::length}, of([](const SurfaceReport& surface) {
             return surface.position ? std::optional(surface.position->last) : std::nullopt;
         })});
}

// Whether there are surfaces to report. Walls that only reflect are covered by the pressures above.
bool has_surfaces(const Scene& scene) {
    return !scene.gas.box.surfaces.are_plain() || change_behaviours(scene.run.events);
}

void add_surfaces(Rows& rows, const SceneAndRun& from) {
    const Box& box = from.scene.gas.box;
    const std::vector<std::string> names = box.surfaces.names();
    for (std::size_t k = 0; has_surfaces(from.scene) && k < names.size(); ++k)
        if (box.has_surface(k)) add_surface(rows, from, names[k]);
}

void add_reversals(Rows& rows, const SceneAndRun& from) {
    const std::size_t count = ways_back(from.scene.run.events).size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::string which = count > 1 ? fmt::format(" of reversal {}", k + 1) : "";
        const auto of = [&](double ReturnDistance::*member) {
            return from.of_report([&](const RunReport& report) -> std::optional<double> {
                const auto& distance = report.reversals[k].distance;
                return distance ? std::optional((*distance).*member) : std::nullopt;
            });
        };
        rows.push_back(
            {{"return distance" + which, quantities::length}, of(&ReturnDistance::largest)});
        rows.push_back({{"r.m.s. return distance" + which, quantities::length},
                        of(&ReturnDistance::root_mean_square)});
    }
}

Rows rows_of(const SceneAndRun& from) {
    Rows rows;
    add_thermal(rows, from);
    add_collisions(rows, from);
    add_conserved(rows, from);
    add_species(rows, from);
    add_surfaces(rows, from);
    add_reversals(rows, from);
    return rows;
}

}  // namespace

std::vector<RunNumber> numbers_of_summary(const Scene& scene) {
    std::vector<RunNumber> numbers;
    for (Row& row : rows_of({scene, nullptr})) numbers.push_back(std::move(row.first));
    return numbers;
}

std::vector<RunNumber> numbers_of_runs(const Scene& scene) {
    std::vector<RunNumber> numbers = numbers_of_summary(scene);
    for (RunNumber& number : numbers_of_instruments(scene)) numbers.push_back(std::move(number));
    return numbers;
}

std::vector<double> values_of(const Scene& scene, const RunReport& report) {
    std::vector<double> values;
    const auto add = [&](std::optional<double> value) {
        values.push_back(value && std::isfinite(*value) ? *value
                                                        : std::numeric_limits<double>::quiet_NaN());
    };
    for (const auto& [number, value] : rows_of({scene, &report})) add(value);
    for (const LastReading& reading : report.readings) add(reading.value);
    return values;
}

}  // namespace carom
