// What particles do in parts of the box against time: beside a partition, or in regions that the
// scene names. How many they are, their temperature, mean energy, or centre of mass.
#include <algorithm>
#include <limits>

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

// In the order of the regions, or below and above the partition's place.
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

    // The mean number on each side of a partition in the middle that lets all through, by symmetry.
    std::optional<double> half_of_all(const Scene& scene, double particles) const {
        const Surfaces& surfaces = box_.surfaces;
        const auto never_reflects = [](const Partition& one) {
            return !one.gaps.empty() || one.is_open;
        };
        const bool is_alike = (surfaces.gravity == 0.0).all() && surfaces.obstacles.empty() &&
                              std::ranges::all_of(surfaces.partitions, never_reflects) &&
                              std::ranges::all_of(surfaces.sides, [](const Behaviour& side) {
                                  return std::holds_alternative<Reflecting>(side);
                              });
        const bool changes = std::ranges::any_of(scene.run.events, [](const RunEvent& event) {
            return !std::holds_alternative<ReverseVelocities>(event.action) &&
                   !std::holds_alternative<Perturbation>(event.action);
        });
        if (!is_alike || changes || !regions_.empty()) return std::nullopt;
        const double place = box_.place_of(static_cast<std::size_t>(surfaces_.front()));
        if (place != 0.5 * box_.size[axis()]) return std::nullopt;
        return 0.5 * particles;
    }

  private:
    int axis() const { return box_.surfaces.axis_of(surfaces_.front()); }

    Box box_;
    std::vector<std::int32_t> surfaces_;
    std::vector<NamedRegion> regions_;
};

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
    subject.measure = [context, parts, measure = spec.measure, axis](const FrameInput& o) {
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : parts.members(o))
            now.push_back(measured(context, o, measure, axis, list));
        return now;
    };
    const auto share =
        parts.half_of_all(context.scene, static_cast<double>(context.particles.count()));
    if (share && spec.measure == PartMeasure::count)
        subject.reference = [share = *share] { return ReferenceLevel{"half of all", share}; };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
