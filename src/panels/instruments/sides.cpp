// A quantity of the particles in parts of the box against time: on the two sides of a partition, or
// in regions that the scene names. The quantity is their number, temperature, mean energy or centre
// of mass.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "panels/instruments/measured_surfaces.h"
#include "panels/registry.h"
#include "panels/surfaces/box_parts.h"
#include "physics/box.h"
#include "physics/mechanics.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/keys/check.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

/// The quantity that is measured for the particles in each part of the box.
enum class PartMeasure { count, temperature, mean_energy, center };

struct SidesOptions {
    MeasuredAt parts = {};
    PartMeasure measure = PartMeasure::count;
};

std::vector<Binding<SidesOptions>> sides_keys() {
    return joined<SidesOptions>(
        bind_within(&SidesOptions::parts, part_keys()),
        std::vector{bind_key("measure", &SidesOptions::measure,
                             one_of<PartMeasure>({{"count", PartMeasure::count},
                                                  {"temperature", PartMeasure::temperature},
                                                  {"mean-energy", PartMeasure::mean_energy},
                                                  {"center", PartMeasure::center}}),
                             "What it shows of the particles in each part: their number, "
                             "temperature, mean energy, or centre of mass along `component`.")});
}

// A panel of sides needs a partition or regions.
void check_sides(PanelSpec& panel, const Node& node, Reading& reading) {
    MeasuredAt& parts = panel.options.change<SidesOptions>().parts;
    if (!parts.regions.empty()) {
        if (!parts.surfaces.empty())
            refuse_together(reading.errors, place_of_surfaces(node), {"surfaces", "regions"});
        return;
    }
    if (is_written(node, "regions")) return;  // reported
    keep_suitable(
        panel, parts.surfaces,
        {[&](std::int32_t surface) { return !reading.box().surfaces.is_side(surface); },
         "a partition of the box",
         fmt::format("{} `regions: [{{name: left, within: {}}}]`",
                     reading.box().dimension == 1 ? "give the panel"
                                                  : "add one to `partitions`, or give the panel",
                     corners(reading.box().dimension))},
        node, reading);
    require_one(panel, parts.surfaces, node, reading);
}

struct MeasuredInParts {
    Phrase title;
    Quantity quantity;
};

MeasuredInParts measured_in_parts(PartMeasure measure) {
    switch (measure) {
        case PartMeasure::count:
            return {Phrase{"Particles"}, quantities::number.named(Phrase{"particles"})};
        case PartMeasure::temperature:
            return {Phrase{"Temperature"}, quantities::temperature};
        case PartMeasure::mean_energy:
            return {Phrase{"Mean energy"}, quantities::mean_energy};
        case PartMeasure::center:
            return {Phrase{"Centre of mass"}, quantities::length.named(Phrase{"centre of mass"})};
    }
    return {};
}

LawOf law_of(PartMeasure measure) {
    if (measure == PartMeasure::count) return LawOf::side_count;
    return measure == PartMeasure::temperature ? LawOf::side_temperature : LawOf::side_energy;
}

std::vector<LawOf> laws_of_sides(const PanelSpec& panel, const Gas&) {
    const auto& [parts, measure] = panel.options.as<SidesOptions>();
    if (!parts.regions.empty() || measure == PartMeasure::center) return {};
    return {law_of(measure)};
}

// What theory knows of the two sides of a partition.
ReferenceLevels levels_of_sides(const PanelContext& context, const SidesOptions& options) {
    const auto& [parts, measure] = options;
    if (!parts.regions.empty() || measure == PartMeasure::center) return {};
    const Law found = law(context.gas, law_of(measure), {.surface = parts.surfaces.front()});
    if (!found) return {};
    ReferenceLevel level = measure == PartMeasure::count ? ReferenceLevel{"half of all"}
                                                         : ReferenceLevel{"equipartition"};
    level.value = found.value;
    level.deviation = found.deviation;
    return {level};
}

double measured(const PanelContext& context, const FrameInput& o, PartMeasure measure, int axis,
                const std::vector<Eigen::Index>& list) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (measure == PartMeasure::count) return static_cast<double>(list.size());
    if (list.empty()) return none;
    if (measure == PartMeasure::temperature) {
        const ThermalMotion motion =
            thermal_motion(context.box(), context.particles, o.sample, list);
        return motion.degrees_of_freedom > 0.0 ? motion.temperature() : none;
    }
    double sum = 0.0, weight = 0.0;
    for (const Eigen::Index i : list) {
        if (context.particles.inverse_mass[i] == 0.0) continue;
        const bool is_mean = measure == PartMeasure::mean_energy;
        const double own = is_mean ? 1.0 : 1.0 / context.particles.inverse_mass[i];
        sum += own * (is_mean ? o.energy[i] : o.sample.position(i, axis));
        weight += own;
    }
    return weight > 0.0 ? sum / weight : none;
}

Meter sides(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const auto& options = spec.options.as<SidesOptions>();
    const BoxParts parts(context.box(), options.parts);
    const auto [title, quantity] = measured_in_parts(options.measure);
    Meter meter{.title = say(language, title), .quantity = quantity, .over = spec.over};
    const std::vector<std::string> columns = parts.names(Language::english);
    const std::vector<std::string> names = parts.names(language);
    for (std::size_t k = 0; k < parts.count(); ++k)
        meter.lines.push_back({columns[k], names[k], surface_role(k, parts.count())});
    const int axis = axis_of(spec);
    meter.read = [context, parts, measure = options.measure, axis](const FrameInput& o) {
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : parts.members(o))
            now.push_back(measured(context, o, measure, axis, list));
        return now;
    };
    meter.levels = [context, options] { return levels_of_sides(context, options); };
    return meter;
}

}  // namespace

PanelKind sides_kind() {
    using enum Ability;
    return series_kind<sides>(
        {.name = "sides",
         .words = Phrase{"sides"},
         .shows = "The number of particles on each side of a partition, or in `regions` of the "
                  "box, against time; or their temperature, mean energy or centre of mass "
                  "(`measure`).",
         .abilities = {over, component, means, comparison},
         .keys = option_keys(sides_keys()),
         .rule = check_sides,
         .laws = laws_of_sides,
         .measured_at = measured_at(&SidesOptions::parts)});
}

}  // namespace carom
