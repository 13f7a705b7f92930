// The pressure on single walls and partitions against time: the momentum that particles give to
// each, divided by time and length, in space by time and area. On a partition it is the difference
// of its two faces.
#include "panels/instruments/surface_pressure.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "panels/instruments/measured_surfaces.h"
#include "panels/plot/window.h"

namespace carom {

Phrase name_of_hard(int dimension) {
    if (dimension == 1) return Phrase{"hard rods"};
    return dimension == 2 ? Phrase{"hard disks"} : Phrase{"hard spheres"};
}

SurfacePressures::SurfacePressures(const Box& box, std::vector<std::int32_t> surfaces, Over over)
    : box_(box), surfaces_(std::move(surfaces)), received_(over) {}

std::vector<double> SurfacePressures::operator()(const FrameInput& input) {
    const double time = input.tick.time;
    const AdvanceResult& advanced = input.advanced;
    if (!received_.empty() && time < received_.last().time) received_.clear();
    const bool is_first = received_.empty();
    Received now{.time = time};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const double size = size_of_surface(box_, advanced.surfaces, surfaces_[i]);
        const double before = is_first ? 0.0 : received_.last().reach[i];
        const double step = is_first ? 0.0 : time - received_.last().time;
        now.push.push_back(push_on_surface(advanced, box_, surfaces_[i]));
        now.reach.push_back(before + 0.5 * step * (size + (is_first ? size : last_size_[i])));
        last_size_.resize(surfaces_.size());
        if (input.is_sample) last_size_[i] = size;
    }
    received_.add(std::move(now), input.is_sample);

    const Received &from = received_.from(), &to = received_.to();
    std::vector<double> pressures;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        pressures.push_back(to.time > from.time
                                ? (to.push[i] - from.push[i]) / (to.reach[i] - from.reach[i])
                                : std::numeric_limits<double>::quiet_NaN());
    return pressures;
}

double SurfacePressures::of_all() const {
    const Received &from = received_.from(), &to = received_.to();
    const auto sum = [](const std::vector<double>& all) {
        return std::accumulate(all.begin(), all.end(), 0.0);
    };
    if (!(to.time > from.time)) return std::numeric_limits<double>::quiet_NaN();
    return (sum(to.push) - sum(from.push)) / (sum(to.reach) - sum(from.reach));
}

SeriesSubject surface_pressure(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const Box& box = context.box();
    const SurfaceNumbers& surfaces = spec.options.as<PressureOptions>().surfaces;
    const Over over = spec.over.value_or(Over{Over::Since::start, 0.0});
    SeriesSubject subject{{.title = say(language, "Pressure"),
                           .quantity = quantities::pressure(box.dimension),
                           .lines = lines_of_surfaces(language, box, surfaces),
                           .read = SurfacePressures(box, surfaces, over)}};
    subject.is_signed = !std::ranges::all_of(
        surfaces, [&](std::int32_t surface) { return box.surfaces.is_side(surface); });
    subject.notes = {
        words_of_window(context.wording(), over, Phrase{"mean since the last sample"})};
    return subject;
}

}  // namespace carom
