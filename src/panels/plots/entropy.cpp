// The entropy of the velocities against time, beside what the same count gives in equilibrium.
#include "stats/entropy.h"

#include <memory>
#include <optional>

#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {

std::unique_ptr<Panel> make_entropy(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const auto entropy = std::make_shared<std::optional<VelocityEntropy>>();
    SeriesSubject subject{
        .measure = [context, entropy](const FrameInput& o) -> std::vector<double> {
            if (!*entropy) {
                const auto start =
                    thermal_motion(context.scene.gas.box, context.particles, o.sample);
                if (start.energy > 0.0) entropy->emplace(context.particles, start);
            }
            return {*entropy ? (*entropy)->of(o.sample.velocity) : 0.0};
        },
        .lines = {{"all"}},
        .titles = {say(language, "Entropy of the velocities, −<i>H</i>")},
        .notes = {say(language, "−Σ <i>p</i> ln <i>p</i> over velocity cells; 0 if all move alike"),
                  say(language, "−Σ <i>p</i> ln <i>p</i> over velocity cells")},
        .quantity = Phrase{"entropy"},
        .unit = "1"};
    if (context.equilibrium)
        subject.reference = [context, entropy]() -> std::optional<ReferenceLevel> {
            if (!*entropy) return std::nullopt;
            return ReferenceLevel{"equilibrium",
                                  (*entropy)->in_equilibrium(context.scene.gas.box.dimension)};
        };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
