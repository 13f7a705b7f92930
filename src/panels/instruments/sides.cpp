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
#include "physics/theory/collision_rate.h"
#include "physics/theory/equation_of_state.h"

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

    // Whether the two sides are equal in equilibrium by symmetry: the partition is in the middle,
    // lets all particles through and does nothing else.
    bool are_alike(const Scene& scene, const Particles& particles) const {
        const Surfaces& surfaces = box_.surfaces;
        const double diameter = 2.0 * particles.radius.maxCoeff();
        const auto lets_all_through = [&](const Partition& one) {
            return one.is_open || (std::holds_alternative<Reflecting>(one.behaviour) &&
                                   std::ranges::any_of(one.gaps, [&](const auto& gap) {
                                       return gap.second - gap.first > diameter;
                                   }));
        };
        const bool is_alike = (surfaces.gravity == 0.0).all() && surfaces.obstacles.empty() &&
                              std::ranges::all_of(surfaces.partitions, lets_all_through) &&
                              (particles.inverse_mass > 0.0).all() && surfaces.sides_reflect() &&
                              !acts_on_box(scene.run.events);
        if (!is_alike || !regions_.empty()) return false;
        const double place = box_.place_of(static_cast<std::size_t>(surfaces_.front()));
        return place == 0.5 * box_.size[axis()];
    }

  private:
    int axis() const { return box_.surfaces.axis_of(surfaces_.front()); }

    Box box_;
    std::vector<std::int32_t> surfaces_;
    std::vector<NamedRegion> regions_;
};

// The level is half of all particles, with the standard deviation of their number. The number is
// binomial for points, with variance N / 4; for equal disks the variance is smaller by the relative
// compressibility of the fluid.
ReferenceLevels levels_of_count(const PanelContext& context) {
    const Particles& particles = context.particles;
    const auto count = static_cast<double>(particles.count());
    ReferenceLevel level = ReferenceLevel{"half of all", 0.5 * count};
    const double packing = packing_fraction(context.scene.gas.box, particles);
    const bool are_points = (particles.radius == 0.0).all();
    const bool is_fluid =
        (particles.radius == particles.radius[0]).all() && packing < largest_packing_of_fluid;
    if (context.scene.gas.box.dimension == 2 && (are_points || is_fluid))
        level.deviation = std::sqrt(
            0.25 * count * relative_compressibility(EquationOfState::kolafa_rottner, packing));
    return {level};
}

// Each degree of freedom has the same mean energy; the energy of half of them has a beta
// distribution.
ReferenceLevels levels_of_energy(const PanelContext& context, const ThermalMotion& start,
                                 PartMeasure measure) {
    const double freedom = start.degrees_of_freedom;
    const double value = measure == PartMeasure::temperature
                             ? start.temperature()
                             : start.energy / static_cast<double>(context.particles.count());
    return {ReferenceLevel{"equipartition", value, value * std::sqrt(2.0 / (freedom + 2.0))}};
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
    SeriesSubject subject{.quantity = quantity, .unit = unit};
    subject.names = parts.names(language);
    const std::vector<std::string> columns = parts.names(Language::english);
    for (std::size_t k = 0; k < parts.count(); ++k)
        subject.lines.push_back({columns[k], surface_role(k, parts.count())});
    title_with_names(subject, language, say(language, title));
    const int axis = spec.component == Component::y ? 1 : 0;
    const auto start = std::make_shared<std::optional<ThermalMotion>>();
    subject.measure = [context, parts, measure = spec.measure, axis, start](const FrameInput& o) {
        if (!*start) *start = thermal_motion(context.scene.gas.box, context.particles, o.sample);
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : parts.members(o))
            now.push_back(measured(context, o, measure, axis, list));
        return now;
    };
    if (parts.are_alike(context.scene, context.particles) && spec.measure != PartMeasure::center)
        subject.references = [context, start, measure = spec.measure] {
            return measure == PartMeasure::count ? levels_of_count(context)
                                                 : levels_of_energy(context, **start, measure);
        };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
