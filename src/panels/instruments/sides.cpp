// A quantity of the particles in parts of the box against time: on the two sides of a partition, or
// in regions that the scene names. The quantity is their number, temperature, mean energy or centre
// of mass.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "panels/instruments/measured_surfaces.h"
#include "panels/registry.h"
#include "panels/surfaces/box_parts.h"
#include "physics/mechanics.h"

namespace carom {
namespace {

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

// What theory knows of the two sides of a partition.
ReferenceLevels levels_of_sides(const PanelContext& context, const PanelSpec& spec) {
    if (!spec.regions.empty() || spec.measure == PartMeasure::center) return {};
    const Law found = law(context.gas, law_of(spec.measure), {.surface = spec.surfaces.front()});
    if (!found) return {};
    ReferenceLevel level = spec.measure == PartMeasure::count ? ReferenceLevel{"half of all"}
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
            thermal_motion(context.scene.gas.box, context.particles, o.sample, list);
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

}  // namespace

std::unique_ptr<Panel> make_sides(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const BoxParts parts(context.scene.gas.box, spec);
    const auto [title, quantity] = measured_in_parts(spec.measure);
    SeriesSubject subject{.quantity = quantity, .over = spec.over};
    subject.names = parts.names(language);
    const std::vector<std::string> columns = parts.names(Language::english);
    for (std::size_t k = 0; k < parts.count(); ++k)
        subject.lines.push_back({columns[k], surface_role(k, parts.count())});
    title_with_names(subject, language, say(language, title));
    const int axis = spec.component == Component::y ? 1 : 0;
    subject.measure = [context, parts, measure = spec.measure, axis](const FrameInput& o) {
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : parts.members(o))
            now.push_back(measured(context, o, measure, axis, list));
        return now;
    };
    subject.references = [context, spec] { return levels_of_sides(context, spec); };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
