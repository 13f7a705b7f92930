// The pressure on a wall that moves against the area that the walls enclose, as a path; with the
// isotherm and the adiabat of an ideal gas from its start.
#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/instruments/surface_pressure.h"
#include "panels/plots/points_panel.h"
#include "panels/registry.h"
#include "physics/mechanics.h"

namespace carom {
namespace {

constexpr double share_of_run = 0.05;  // that pressures are taken over

const plot::Stroke of_isotherm{.role = {.of = plot::Role::Of::accent}};
const plot::Stroke of_adiabat{.role = {.of = plot::Role::Of::highlight}, .dashes = {0.5, 0.3}};

plot::Line curve(const plot::Plot& plot, const char* name, const plot::Stroke& stroke,
                 const std::function<double(double)>& pressure) {
    constexpr int steps = 200;
    std::vector<double> across, up;
    for (int i = 0; i <= steps; ++i) {
        const double area = plot.x.low + (plot.x.high - plot.x.low) * i / steps;
        if (!(area > 0.0)) continue;
        across.push_back(area);
        up.push_back(pressure(area));
    }
    plot::Line line;
    line.part = "theory";
    line.of = name;
    line.still = true;
    line.depth = 2;
    line.x = plot::column(plot.columns[1], std::move(across));
    line.y = plot::column(plot.columns[2], std::move(up));
    line.stroke = stroke;
    line.beyond = plot::Beyond::cut;
    return line;
}

// `found`: the number of particles times the temperature, and the area, at the start.
void add_curves(const PointsSubject& subject, int dimension, plot::Plot& plot) {
    if (subject.found.empty()) return;
    const double work = subject.found[0], area = subject.found[1];
    const double exponent = (dimension + 2.0) / dimension;
    const Language language = subject.language;
    plot.layers.emplace_back(
        curve(plot, "isotherm", of_isotherm, [=](double its) { return work / its; }));
    plot.layers.emplace_back(curve(plot, "adiabat", of_adiabat, [=](double its) {
        return work / area * std::pow(area / its, exponent);
    }));
    plot.notes.push_back({.entries = {{{}, {plot::Text(say(language, "ideal gas:"))}},
                                      {of_isotherm, {plot::Text(say(language, "isotherm"))}},
                                      {of_adiabat, {plot::Text(say(language, "adiabat"))}}},
                          .wraps = true});
}

}  // namespace

std::unique_ptr<Panel> make_pressure_volume(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const Box& box = context.scene.gas.box;
    const std::int32_t surface = spec.surfaces.front();
    const Over over =
        spec.over.value_or(Over{Over::Since::window, share_of_run * context.scene.run.until});
    const std::string title = spec.title
                                  ? escape_markup(*spec.title)
                                  : say(language, box.dimension == 1 ? Phrase{"Pressure and length"}
                                                                     : Phrase{"Pressure and area"});
    const Phrase area = box.dimension == 1 ? Phrase{"length"} : Phrase{"area"};
    PointsSubject subject{
        .titles = {title},
        .language = language,
        .across = say(language, area),
        .up = say(language, "pressure"),
        .width = {INFINITY, 0.0},
        .widen =
            [context, theory = spec.theory](PointsSubject& its, const FrameInput& o) {
                const Box& of = context.scene.gas.box;
                const double now = enclosed_area(of, o.advanced.surfaces);
                if (its.found.empty() && theory) {
                    const double finite =
                        static_cast<double>((context.particles.inverse_mass > 0.0).count());
                    const double thermal =
                        thermal_motion(of, context.particles, o.sample).temperature();
                    its.found = {finite * thermal, now};
                }
                its.width = {std::min(its.width.first, 0.95 * now),
                             std::max(its.width.second, 1.05 * now)};
            },
        .height = {},
        .sets = {{"path", {.of = plot::Role::Of::bar}}},
        .points = [context, meter = SurfacePressures(box, {surface}, over)](
                      const FrameInput& o, std::size_t) mutable -> std::vector<Point> {
            const double now = meter(o.tick.time, o.advanced).front();
            if (std::isnan(now)) return {};
            return {{enclosed_area(context.scene.gas.box, o.advanced.surfaces), now}};
        },
        .corners = {},
        .never_negative = true,
        .columns = {column_name(std::string(area.english),
                                box.dimension == 1 ? reduced::length : "length^2"),
                    column_name("pressure", unit_of_pressure(box))}};
    subject.add = [dimension = box.dimension](const PointsSubject& its, plot::Plot& plot) {
        add_curves(its, dimension, plot);
    };
    return std::make_unique<PointsPanel>(std::move(subject));
}

}  // namespace carom
