// The pressure against time, measured in two ways that must agree: from the momentum that the walls
// receive, and from the virial of the collisions.
#include "stats/pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "panels/instruments/surface_pressure.h"
#include "panels/means/trailing.h"
#include "panels/plot/window.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "panels/surfaces/place_options.h"
#include "physics/box.h"
#include "physics/mechanics.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

std::vector<Binding<PressureOptions>> pressure_keys() {
    return {bind_within(&PressureOptions::surfaces, surfaces_key()),
            bind_key("gauge", &PressureOptions::gauge, flag(),
                     "Whether to show the mean over a time before the present on round gauges: one "
                     "for each surface, or one for all walls.")};
}

// A gauge needs a solid wall.
void check_pressure(PanelSpec& panel, const Node& node, Reading& reading) {
    if (panel.options.as<PressureOptions>().gauge && reading.units == UnitSystem::real)
        reading.errors.add(*given(node, "gauge"),
                           "gauges do not show the units of a scene with `units: real`",
                           "without `gauge` the pressure is shown against time");
    if (!panel.options.as<PressureOptions>().gauge || is_written(node, "surfaces")) return;
    if (!has_solid_side(reading.box()))
        reading.errors.add(*given(node, "gauge"), "a gauge needs a solid wall of the box",
                           "make a wall solid, or name a partition by `surfaces`");
}

std::vector<LawOf> laws_of_pressure(const PanelSpec& panel, const Gas&) {
    if (!panel.options.as<PressureOptions>().surfaces.empty()) return {};
    return {LawOf::pressure};
}

// The pressures over the time that the scene asks for.
class Gauge {
  public:
    Gauge(const PanelContext& context, Over over)
        : context_(context), accounts_(over), watch_(context.box()) {}

    std::vector<double> operator()(const FrameInput& o) {
        const Box& box = context_.box();
        const bool plain = o.advanced.surfaces.empty();
        if (o.is_sample) watch_.see(o.tick.time, o.advanced.impulses, o.advanced.surfaces);
        if (!watch_.start()) {
            accounts_.clear();
            return {nan_, nan_};
        }
        if (accounts_.empty()) accounts_.add(*watch_.start(), true);
        accounts_.add({o.tick.time, o.advanced.impulses}, o.is_sample);
        const PressureStart& from = accounts_.from();
        const PressureStart& to = accounts_.to();
        if (!(to.time > from.time)) return {nan_, nan_};
        const ImpulseTotals change = from.since(to.impulses);
        const double time = to.time - from.time;
        const ThermalMotion motion = thermal_motion(box, context_.particles, o.sample);
        const double thermal = motion.energy;
        const bool pushed = !plain || infinite_mass_moves(context_.particles, o.sample);
        *thermal_ = pushed ? std::nullopt : std::optional(motion);
        const auto virial = virial_pressure(box, context_.particles, thermal, change, time);
        return {wall_pressure(box, change, time).value_or(nan_),
                pushed ? nan_ : virial.value_or(nan_)};
    }

    // The last thermal motion; none if the gas does not conserve its energy, or if not known yet.
    std::shared_ptr<const std::optional<ThermalMotion>> thermal() const { return thermal_; }

  private:
    static constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
    PanelContext context_;
    Trailing<PressureStart> accounts_;  ///< what has been received by a time
    PressureWatch watch_;
    std::shared_ptr<std::optional<ThermalMotion>> thermal_ =
        std::make_shared<std::optional<ThermalMotion>>();
};

// A gas that is divided by partitions has no single pressure before the last one opens.
std::string time_words(const Wording& language, const Over& over, const Box& box) {
    const bool is_parted = !std::ranges::all_of(box.surfaces.partitions, &Partition::is_open);
    return over.since == Over::Since::start && is_parted
               ? say(language, "mean since the last partition opened")
               : words_of_window(language, over, Phrase{"mean since the last sample"});
}

// The pressure of an ideal gas with the energy of this one, and of hard disks or rods.
ReferenceLevels levels(const PanelContext& context, const std::optional<ThermalMotion>& thermal) {
    if (!thermal) return {};
    const auto pressure_by = [&](LawOf quantity, EquationOfState equation) {
        return law(context.gas, quantity, {.thermal = thermal, .equation = equation});
    };
    const Law ideal = pressure_by(LawOf::ideal_pressure, {});
    if (!ideal) return {};
    ReferenceLevels all{ReferenceLevel{"ideal gas", ideal.value}};
    if (context.gas.are_points()) return all;
    const Law better = pressure_by(LawOf::pressure, EquationOfState::accurate);
    if (!better) return all;
    const int dimension = context.box().dimension;
    const ReferenceLevel of_hard{std::string(name_of_hard(dimension).english), better.value};
    if (dimension == 1) {
        all.push_back(of_hard);
        return all;
    }
    const Law simple = pressure_by(LawOf::pressure, EquationOfState::simple);
    if (!simple) return all;
    constexpr double alike = 0.01;  // relative difference: one line in a plot
    if (std::abs(simple.value / better.value - 1.0) < alike) {
        all.push_back(of_hard);
    } else {
        const auto level = [&](EquationOfState equation, double value) {
            return ReferenceLevel{std::string(name_of(equation, dimension)), value};
        };
        all.push_back(level(EquationOfState::simple, simple.value));
        all.push_back(level(EquationOfState::accurate, better.value));
    }
    return all;
}

// The pressure on the walls has the colour of bars, that from the virial the highlight colour.
const plot::Role of_walls{.of = plot::Role::Of::bar};
const plot::Role of_virial{.of = plot::Role::Of::highlight};

std::vector<plot::Text> titles(Language language, bool has_walls) {
    const plot::Text virial =
        plot::named(say(language, "from collisions"), of_virial, plot::Swatch::line, 1);
    const plot::Text walls =
        plot::named(say(language, "on the walls"), of_walls, plot::Swatch::line, 0);
    if (!has_walls) return {plot::text_of(language, Phrase{"Pressure {}"}, {virial})};
    const auto short_title = [&](const std::string& collisions) {
        return plot::text_of(language, Phrase{"Pressure: {}, {}"},
                             {plot::named(say(language, "walls"), of_walls, plot::Swatch::line, 0),
                              plot::named(collisions, of_virial, plot::Swatch::line, 1)});
    };
    return {plot::text_of(language, Phrase{"Pressure {} and {}"}, {walls, virial}),
            short_title(say(language, "collisions")), short_title(say(language, "virial"))};
}

SeriesSubject pressure(const PanelContext& context, const PanelSpec& spec) {
    if (!spec.options.as<PressureOptions>().surfaces.empty())
        return surface_pressure(context, spec);
    const Over over = spec.over.value_or(Over{Over::Since::start, 0.0});
    const Box& box = context.box();
    const bool walls = !box.is_periodic();
    const Gauge gauge(context, over);
    const Language language = context.language();
    SeriesSubject subject{
        {.title = say(language, "Pressure"),
         .quantity = quantities::pressure(box.dimension),
         .lines = {{"on the walls", say(language, "on the walls"), of_walls},
                   {"from collisions", say(language, "from collisions"), of_virial}},
         .read = gauge,
         .reads_means_since_start = over.since == Over::Since::start,
         .levels = [context, thermal = gauge.thermal()] { return levels(context, *thermal); }}};
    subject.titles = titles(language, walls);
    subject.notes = {time_words(context.wording(), over, box)};
    subject.compared = 1;
    subject.compared_title = say(language, "Pressure from collisions");
    return subject;
}

std::unique_ptr<Panel> make_pressure(const PanelContext& context, const PanelSpec& spec) {
    if (spec.options.as<PressureOptions>().gauge) return make_pressure_gauge(context, spec);
    return std::make_unique<SeriesPanel>(context, spec, pressure(context, spec));
}

}  // namespace

PanelKind pressure_kind() {
    using enum Ability;
    return {.name = "pressure",
            .words = Phrase{"pressure"},
            .shows =
                "The pressure on all walls, or on single `surfaces`, against time; with `gauge: "
                "true` on round gauges.",
            .make = make_pressure,
            .meter = meter_of<pressure>,
            .abilities = {over, means, comparison},
            .asked = {{"pressure", "the pressure, averaged since the start"}},
            .shows_units = true,
            .keys = option_keys(pressure_keys()),
            .rule = check_pressure,
            .laws = laws_of_pressure,
            .measured_at = measured_at(&PressureOptions::surfaces)};
}

}  // namespace carom
