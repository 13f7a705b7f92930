// The kinetic energy of the particles in each half of the box against time.
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "panels/surfaces/box_parts.h"
#include "physics/membership.h"

namespace carom {
namespace {

Meter halves(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const int axis = axis_of(spec);
    const auto words = axis == 0   ? std::array{Phrase{"left half"}, Phrase{"right half"}}
                       : axis == 1 ? std::array{Phrase{"lower half"}, Phrase{"upper half"}}
                                   : std::array{Phrase{"back half"}, Phrase{"front half"}};
    Meter meter{.title = say(language, "Kinetic energy"), .quantity = quantities::energy};
    meter.over = spec.over;
    for (std::size_t k = 0; k < 2; ++k)
        meter.lines.push_back(
            {std::string(words[k].english), say(language, words[k]), surface_role(k, 2)});
    meter.read = [axis, middle = 0.5 * context.box().length(axis)](const FrameInput& now) {
        std::vector<double> energies(2);
        for (Eigen::Index i = 0; i < now.energy.size(); ++i)
            if (is_present(now.sample, i) && std::isfinite(now.energy[i]))
                energies[now.sample.position(i, axis) < middle ? 0 : 1] += now.energy[i];
        return energies;
    };
    return meter;
}

}  // namespace

PanelKind halves_kind() {
    using enum Ability;
    return series_kind<halves>(
        {.name = "halves",
         .words = Phrase{"halves of the box"},
         .shows =
             "The kinetic energy of the particles in each half of the box, as the scene gives it.",
         .abilities = {over, component, means, comparison}});
}

}  // namespace carom
