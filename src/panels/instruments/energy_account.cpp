// The parts of the energy against time, stacked: the kinetic energy of the gas, above it the
// potential energy of gravity and of forces on pistons, and at the top the kinetic energy of
// pistons.
#include "physics/events/energy_account.h"

#include <algorithm>
#include <array>

#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

struct Part {
    Phrase name;
    plot::Role role;
};

// The parts of the energy that are possible for this gas.
std::vector<Part> parts_of(const PanelContext& context) {
    const Surfaces& surfaces = context.box().surfaces;
    bool has_pistons = false;
    for (const auto& one : behaviours_in_time(surfaces, context.run()))
        has_pistons = has_pistons || std::ranges::any_of(one, piston_of);
    std::vector<Part> parts{{Phrase{"kinetic"}, {.of = plot::Role::Of::bar}}};
    if (has_pistons || surfaces.has_gravity())
        parts.push_back({Phrase{"potential"}, {.of = plot::Role::Of::run, .index = 0}});
    if (has_pistons) parts.push_back({Phrase{"pistons"}, {.of = plot::Role::Of::run, .index = 1}});
    return parts;
}

// The bands between each line of the record and the one below.
void fill_stack(const HistoryRecord& record, const std::vector<Part>& parts, plot::Plot& whole) {
    if (record.compares()) return;
    const History& run = record.runs.front();
    for (std::size_t k = 0; k < run.y.size(); ++k) {
        std::vector<double> middle, half;
        for (std::size_t i = 0; i < run.x.size(); ++i) {
            const double high = run.y[k][i], low = k == 0 ? 0.0 : run.y[k - 1][i];
            middle.push_back(0.5 * (low + high));
            half.push_back(0.5 * std::abs(high - low));
        }
        plot::Band band;
        band.x = plot::column("", run.x);
        band.y = plot::column("", std::move(middle));
        band.error = plot::column("", std::move(half));
        band.role = parts[k].role;
        band.alpha = 0.45;
        band.depth = 2000;  // behind all lines
        whole.layers.emplace_back(std::move(band));
    }
}

SeriesSubject energy_account(const PanelContext& context, const PanelSpec&) {
    const Language language = context.language();
    const std::vector<Part> parts = parts_of(context);
    SeriesSubject subject{{.title = say(language, "Energy"), .quantity = quantities::energy}};
    std::string column;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        column += (column.empty() ? "" : " + ") + std::string(parts[k].name.english);
        subject.lines.push_back({column, say(language, parts[k].name), parts[k].role});
    }
    subject.compared = parts.size() - 1;
    subject.read = [context, parts = parts.size()](const FrameInput& o) {
        const EnergyAccount now =
            energies(context.box(), context.particles, o.sample, o.advanced.surfaces);
        const std::array all{now.kinetic, now.kinetic + now.potential, now.in_all()};
        return std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(parts));
    };
    subject.add = [parts](const HistoryRecord& record, plot::Plot& whole) {
        fill_stack(record, parts, whole);
    };
    return subject;
}

}  // namespace

PanelKind energy_account_kind() {
    using enum Ability;
    return series_kind<energy_account>(
        {.name = "energy-account",
         .words = Phrase{"energy account"},
         .shows =
             "Kinetic energy, potential energy and the energy of pistons against time, stacked.",
         .abilities = {means, comparison}});
}

}  // namespace carom
