// The entropy of the velocities, of the positions, or both against time, with the value that the
// same counting gives in equilibrium.
#include "stats/entropy.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {
namespace {

// Data that are known once the gas has been seen.
struct Entropies {
    std::optional<VelocityEntropy> velocities;  ///< none of a gas at rest
    bool is_known = false;
};

// Whether the gas fills its box uniformly in equilibrium: there is nothing in the box that prevents
// it, no gravity, and no change of surfaces.
bool spreads_evenly(const Scene& scene) {
    const bool changes = std::ranges::any_of(scene.run.events, [](const RunEvent& event) {
        return std::holds_alternative<ChangeSurface>(event.action) ||
               std::holds_alternative<MoveSurface>(event.action);
    });
    const Surfaces& surfaces = scene.gas.box.surfaces;
    const auto reflects = [](const Behaviour& side) {
        return std::holds_alternative<Reflecting>(side) || std::holds_alternative<Bath>(side);
    };
    const auto can_open = [&](const Partition& one) {
        if (one.is_open || !one.gaps.empty()) return true;
        const auto number = static_cast<std::int32_t>(&one - surfaces.partitions.data()) +
                            Surfaces::first_partition;
        return std::ranges::any_of(scene.run.events, [&](const RunEvent& event) {
            const auto* open = std::get_if<SetOpen>(&event.action);
            return open != nullptr && open->surface == number;
        });
    };
    return !changes && surfaces.obstacles.empty() && (surfaces.gravity == 0.0).all() &&
           std::ranges::all_of(surfaces.sides, reflects) &&
           std::ranges::all_of(surfaces.partitions, can_open);
}

const plot::Role of_velocities{.of = plot::Role::Of::bar};
const plot::Role of_positions{.of = plot::Role::Of::highlight};

void add_titles(Language language, EntropyOf what, SeriesSubject& subject) {
    const std::string sum = "−Σ <i>p</i> ln <i>p</i>";
    if (what == EntropyOf::velocities) {
        subject.titles = {
            say(language, "Entropy of the velocities, −<i>H</i>"),
            plot::text_of(language, Phrase{"{}, {}"}, {say(language, "Entropy"), "−<i>H</i>"})};
        subject.notes = {
            say(language, "−Σ <i>p</i> ln <i>p</i> over velocity cells; 0 if all move alike"),
            say(language, "−Σ <i>p</i> ln <i>p</i> over velocity cells"), sum};
    } else if (what == EntropyOf::positions) {
        subject.titles = {say(language, "Entropy of the positions")};
        subject.notes = {say(language, "−Σ <i>p</i> ln <i>p</i> over cells of the box"), sum};
    } else {
        subject.names = {say(language, "velocities"), say(language, "positions")};
        const plot::Text names =
            joined(language, {plot::named(subject.names[0], of_velocities, plot::Sample::line, 0),
                              plot::named(subject.names[1], of_positions, plot::Sample::line, 1)});
        subject.titles = {plot::text_of(language, Phrase{"Entropy of {}"}, {names}),
                          say(language, "Entropy")};
        subject.last_title_names = false;
        subject.notes = {say(language, "−Σ <i>p</i> ln <i>p</i> over cells"), sum};
    }
}

}  // namespace

std::unique_ptr<Panel> make_entropy(const PanelContext& context, const PanelSpec& spec) {
    const EntropyOf what = spec.entropy_of;
    const auto known = std::make_shared<Entropies>();
    const PositionEntropy places(context.scene.gas.box, context.particles, spec.bins);
    SeriesSubject subject{.quantity = Phrase{"entropy"}, .unit = "1"};
    if (what != EntropyOf::positions) subject.lines.push_back({"velocities", of_velocities});
    if (what != EntropyOf::velocities) subject.lines.push_back({"positions", of_positions});
    if (what == EntropyOf::velocities) subject.lines = {{"all"}};
    subject.measure = [context, known, places, what](const FrameInput& o) {
        if (!std::exchange(known->is_known, true)) {
            const auto start = thermal_motion(context.scene.gas.box, context.particles, o.sample);
            if (start.energy > 0.0) known->velocities.emplace(context.particles, start);
        }
        std::vector<double> now;
        if (what != EntropyOf::positions)
            now.push_back(known->velocities ? known->velocities->of(o.sample.velocity) : 0.0);
        if (what != EntropyOf::velocities) now.push_back(places.of(o.sample.position));
        return now;
    };
    add_titles(context.language(), what, subject);
    subject.references = [context, known, places, what] {
        ReferenceLevels levels;
        if (what != EntropyOf::positions && context.equilibrium && known->velocities)
            levels.push_back(ReferenceLevel{
                "equilibrium", known->velocities->in_equilibrium(context.scene.gas.box.dimension)});
        if (what != EntropyOf::velocities && spreads_evenly(context.scene))
            levels.push_back(ReferenceLevel{"evenly spread", places.of_even_spread()});
        return levels;
    };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
