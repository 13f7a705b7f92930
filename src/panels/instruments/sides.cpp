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
#include "panels/surfaces/surface_words.h"
#include "physics/mechanics.h"

namespace carom {
namespace {

struct Quantities {
    Phrase title, quantity;
    std::string unit;
};

Quantities quantities(PartMeasure measure) {
    switch (measure) {
        case PartMeasure::count:
            return {Phrase{"Particles"}, Phrase{"particles"}, "1"};
        case PartMeasure::temperature:
            return {Phrase{"Temperature"}, Phrase{"temperature"}, reduced::energy};
        case PartMeasure::mean_energy:
            return {Phrase{"Mean energy"}, Phrase{"mean energy"}, reduced::energy};
        case PartMeasure::center:
            return {Phrase{"Centre of mass"}, Phrase{"centre of mass"}, reduced::length};
    }
    return {};
}

// The parts: in the order of the regions, or below and above the partition's place.
class Parts {
  public:
    Parts(const Box& box, const PanelSpec& spec)
        : box_(box), surfaces_(spec.surfaces), regions_(spec.regions) {}

    std::size_t count() const { return regions_.empty() ? 2 : regions_.size(); }

    std::vector<std::string> names(Language language) const {
        std::vector<std::string> all;
        for (const NamedRegion& one : regions_) all.push_back(one.name);
        if (!all.empty()) return all;
        if (axis() == 0) return {say(language, "left"), say(language, "right")};
        return {say(language, "below"), say(language, "above")};
    }

    std::vector<std::vector<Eigen::Index>> members(const FrameInput& input) const {
        std::vector<std::vector<Eigen::Index>> all(count());
        const Eigen::ArrayXXd& position = input.sample.position;
        if (regions_.empty()) {
            const double place = place_of_surface(box_, input.advanced.surfaces,
                                                  static_cast<std::size_t>(surfaces_.front()));
            for (Eigen::Index i = 0; i < position.rows(); ++i)
                all[position(i, axis()) < place ? 0 : 1].push_back(i);
            return all;
        }
        for (Eigen::Index i = 0; i < position.rows(); ++i)
            for (std::size_t k = 0; k < regions_.size(); ++k) {
                bool is_in = true;
                for (Eigen::Index a = 0; a < position.cols(); ++a)
                    is_in = is_in && position(i, a) >= regions_[k].region.low[a] &&
                            position(i, a) < regions_[k].region.high[a];
                if (is_in) all[k].push_back(i);
            }
        return all;
    }

  private:
    int axis() const { return box_.surfaces.axis_of(surfaces_.front()); }

    Box box_;
    std::vector<std::int32_t> surfaces_;
    std::vector<NamedRegion> regions_;
};

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
    const Parts parts(context.scene.gas.box, spec);
    const auto [title, quantity, unit] = quantities(spec.measure);
    SeriesSubject subject{.quantity = quantity, .unit = unit, .over = spec.over};
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
