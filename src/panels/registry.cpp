#include "panels/registry.h"

#include <fmt/format.h>

#include <cassert>

#include "panels/collision/collision_map_keys.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/gas/gas_colors.h"
#include "panels/gas/gas_panel.h"
#include "panels/instruments/instrument_keys.h"
#include "panels/line/line_panel.h"
#include "panels/plot/clock_samples.h"
#include "panels/plots/histogram_panel.h"
#include "panels/sweep/sweep_keys.h"
#include "physics/theory/law.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/limits.h"
#include "scene/reading/gas_reading.h"
#include "scene/reading/overlay_reading.h"
#include "scene/reading/panel_reading.h"

namespace carom {
namespace {

std::vector<Binding<PanelSpec>> reference_key() {
    return {bind_key("reference", &PanelSpec::reference_initial,
                     one_of<bool>({{"now", false}, {"initial", true}}),
                     "The mean speed that defines slow and fast: at present, or at the start.")};
}

std::vector<Binding<PanelSpec>> against_key() {
    return {bind_key("against", &PanelSpec::against_collisions,
                     one_of<bool>({{"time", false}, {"collisions", true}}),
                     "The horizontal axis: the time since the reversal, or the mean number of "
                     "collisions per particle since then.")};
}

// Reports a run without a reversal, and a growth law that is asked for although none is known.
void check_return_distance(PanelSpec& panel, const Node& node, Reading& reading) {
    check_reversal(node.is_mapping() ? *given(node, "kind") : node, reading);
    const Node* asked = given(node, "theory");
    if (asked == nullptr || !panel.theory || reading.gas.species.empty()) return;
    if (asked->source->origin == Origin::template_file) return;
    if (const auto reason = why_no_law(reading.gas, reading.run, LawOf::error_growth))
        reading.errors.add(*asked,
                           "the law by which errors grow is not known for this gas: " +
                               to_text(Language::english, *reason, reading.gas.species),
                           "leave out `theory`; the curve is then drawn where there is one");
}

std::vector<Binding<PanelSpec>> numbers_key() {
    return {
        bind_key(
            "numbers", &PanelSpec::numbers, monitors_notation(),
            "The numbers that it shows. `all-collisions` includes those with walls; "
            "`return-distance` is the largest distance of a particle from where it was on the way "
            "out; `overlap` is the largest so far of two colliding disks, in per cent of the sum "
            "of their radii.")
            .default_text("time, collisions, mean-speed and mean-energy")};
}

Binding<PanelSpec> cells_key() {
    return bind_key("cells", &PanelSpec::bins, whole(2, most_field_cells),
                    "The number of slabs along the axis; for an entropy, of cells along the longer "
                    "side of the box.")
        .default_text("20; for an entropy, as many as give about five particles per cell");
}

std::vector<Binding<PanelSpec>> profile_keys() {
    return {bind_key("quantity", &PanelSpec::quantity, quantity_notation(false),
                     "What it shows; `flow` is the mean velocity along the axis."),
            cells_key(),
            bind_key("around", &PanelSpec::around, plane_vector(not_negative),
                     "A point: the density then is shown in rings around it, against the distance "
                     "from it, up to the nearest side of the box.")
                .default_text("none: along an axis"),
            bind_key("mark_front", &PanelSpec::front, flag(),
                     "With `around`: whether to mark the distance at which the density is highest, "
                     "as the mean over three neighbouring rings, where it exceeds the mean density "
                     "of the box by more than three standard deviations of a gas at rest.")};
}

void check_profile(PanelSpec& panel, const Node& node, Reading& reading) {
    const Box& box = reading.gas.box;
    const auto refuse_key = [&](const char* key, const char* message, const char* hint) {
        if (const Node* written = given(node, key)) reading.errors.add(*written, message, hint);
    };
    if (!panel.around) {
        if (panel.front)
            refuse_key("mark_front",
                       "`mark_front` needs `around`, the point that it runs away from",
                       "for instance around: [20, 15]");
        return;
    }
    if (box.dimension == 1)
        return refuse_key("around", "on a wire there are no rings around a point",
                          "leave it out: a profile along the wire shows the density");
    for (const char* key : {"component", "quantity"})
        refuse_key(key, "a profile `around` a point is of the density in rings", "leave it out");
    const bool is_inside = on_each_axis(box.dimension, [&](int axis) {
        const double size = box.size[axis], at = (*panel.around)[axis];
        return size <= 0.0 || (at > 0.0 && at < size);  // a size of 0 is reported
    });
    if (!is_inside)
        refuse_key("around", "this point is not inside the box",
                   "rings reach from the point to the nearest side");
}

std::unique_ptr<Panel> make_profile_or_rings(const PanelContext& context, const PanelSpec& spec) {
    return spec.around ? make_radial_profile(context, spec) : make_profile(context, spec);
}

std::vector<Binding<PanelSpec>> entropy_keys() {
    return {bind_key("space", &PanelSpec::entropy_of,
                     one_of<EntropyOf>({{"velocities", EntropyOf::velocities},
                                        {"positions", EntropyOf::positions},
                                        {"both", EntropyOf::both}}),
                     "Which entropy it shows: of the velocities, of the positions, or both."),
            cells_key()};
}

std::unique_ptr<Panel> make_pressure_or_gauge(const PanelContext& context, const PanelSpec& spec) {
    return spec.gauge ? make_pressure_gauge(context, spec) : make_pressure(context, spec);
}

std::vector<Binding<PanelSpec>> view_key() {
    return {bind_key("view", &PanelSpec::view, view_notation(),
                     "What the figure shows: the whole `box`, or a part of it.")
                .default_text("as the film's camera shows it at that time")};
}

std::vector<Binding<PanelSpec>> words_key() {
    return {
        bind_key("words", &PanelSpec::words, with_formulas(lines(1, most_words_letters)),
                 "The text of the panel; an empty line separates paragraphs. Formulae are written "
                 "between `$` signs; one that is a paragraph of its own is large.")
            .default_text("required for a text")};
}

void check_words(PanelSpec&, const Node& node, Reading& reading) {
    if (!node.is_mapping() || find(node, "words") == nullptr)
        reading.errors.add(node, "a panel of kind `text` needs `words`",
                           "for instance {kind: text, words: \"Watch the red disk.\"}");
}

std::unique_ptr<Panel> make_gas(const PanelContext& context, const PanelSpec& spec) {
    return make_gas_panel(context, spec.view);
}

void check_run_distance(PanelSpec& panel, const Node& node, Reading& reading) {
    std::int64_t count = panel.of.empty() ? particles_in(reading.gas).value_or(0) : 0;
    for (const Chosen& chosen : panel.of) count += count_of(chosen, reading.gas).value_or(0);
    if (count > static_cast<std::int64_t>(most_in_both_runs.count()))
        reading.errors.add(node, fmt::format("`run-distance` of {} particles", count),
                           to_text(most_in_both_runs) + ": name some in `of`");
}

std::int64_t count_of(const Gas& gas) {
    std::int64_t count = 0;
    for (const Species& species : gas.species) count += species.count;
    return count;
}

bool acts_on_gas(const Gas& gas, const Run& run) {
    return !gas.box.surfaces.are_plain() || std::ranges::any_of(run.events, heats);
}

// Whether collisions redistribute speeds: equal beads on a line, and a single pair, only exchange
// them.
bool speeds_spread(const Gas& gas, const Run& run) {
    const auto common_mass = [](const Species& species) -> std::optional<double> {
        const auto* mass = std::get_if<ValueRule>(&species.mass);
        const double* value = mass == nullptr ? nullptr : std::get_if<double>(mass);
        return value == nullptr ? std::nullopt : std::optional(*value);
    };
    const std::optional<double> first = common_mass(gas.species.front());
    const bool all_equal = first && std::ranges::all_of(gas.species, [&](const Species& species) {
                               return common_mass(species) == first;
                           });
    if (acts_on_gas(gas, run)) return true;
    return count_of(gas) > 2 && !(gas.box.dimension == 1 && all_equal);
}

bool has_several_species(const Gas& gas, const Run&) { return gas.species.size() > 1; }

bool returns(const Gas&, const Run& run) { return !reversal_times(run).empty(); }

bool is_line(const Gas& gas, const Run&) { return gas.box.dimension == 1; }

std::function<std::vector<LawOf>(const PanelSpec&, const Gas&)> always(LawOf quantity) {
    return [quantity](const PanelSpec&, const Gas&) { return std::vector{quantity}; };
}

std::vector<LawOf> laws_of_species(const PanelSpec&, const Gas& gas) {
    if (gas.species.size() < 2) return {};
    return {LawOf::mean_energy};
}

std::vector<LawOf> laws_of_entropy(const PanelSpec& spec, const Gas&) {
    if (spec.entropy_of == EntropyOf::velocities) return {LawOf::velocity_entropy};
    if (spec.entropy_of == EntropyOf::positions) return {LawOf::position_entropy};
    return {LawOf::velocity_entropy, LawOf::position_entropy};
}

std::vector<LawOf> laws_of_pressure(const PanelSpec& spec, const Gas&) {
    if (!spec.surfaces.empty()) return {};
    return {LawOf::pressure};
}

std::vector<LawOf> laws_of_sides(const PanelSpec& spec, const Gas&) {
    if (!spec.regions.empty()) return {};
    if (spec.measure == PartMeasure::count) return {LawOf::side_count};
    if (spec.measure == PartMeasure::mean_energy) return {LawOf::side_energy};
    if (spec.measure == PartMeasure::temperature) return {LawOf::side_temperature};
    return {};
}

bool always_has_own_time(const PanelSpec&) { return true; }

std::vector<PanelKind> all_kinds() {
    using enum Ability;
    return {
        {.name = "speed-histogram",
         .words = Phrase{"speed histogram"},
         .shows = "A histogram of the speeds, now or averaged over a time (`over`), with the "
                  "equilibrium distribution.",
         .make = make_speed_histogram,
         .abilities = {bars, from_zero, of, over, theory, equilibrium, means, comparison},
         .keys = histogram_keys(),
         .rule = check_scalar_histogram,
         .suits = speeds_spread,
         .laws = laws_of_histogram},
        {.name = "energy-histogram",
         .words = Phrase{"energy histogram"},
         .shows = "A histogram of the kinetic energies of the particles, with the equilibrium "
                  "distribution.",
         .make = make_energy_histogram,
         .abilities = {bars, from_zero, of, over, theory, equilibrium, means, comparison},
         .keys = histogram_keys(),
         .rule = check_scalar_histogram,
         .suits = speeds_spread,
         .laws = laws_of_histogram},
        {.name = "velocity-histogram",
         .words = Phrase{"velocity histogram"},
         .shows = "A histogram of the velocities along one axis, or of both components together, "
                  "with the equilibrium distribution.",
         .make = make_velocity_histogram,
         .abilities = {bars, of, over, component, both, theory, equilibrium, means, comparison},
         .keys = histogram_keys(),
         .rule = check_velocity_histogram,
         .suits = speeds_spread,
         .laws = laws_of_histogram},
        {.name = "position-histogram",
         .words = Phrase{"position histogram"},
         .shows = "A histogram of the positions along one axis; on a Galton board of pegs with the "
                  "binomial distribution that balls would have if each row sent them to the left "
                  "or to the right independently.",
         .make = make_position_histogram,
         .abilities = {bars, of, over, component, means, comparison},
         .keys = histogram_keys(),
         .rule = check_position_histogram},
        {.name = "energy-by-species",
         .words = Phrase{"energy by species"},
         .shows = "The mean kinetic energy of each species against time.",
         .make = make_energy_by_species,
         .abilities = {over, means},
         .suits = has_several_species,
         .laws = laws_of_species},
        {.name = "speed-classes",
         .words = Phrase{"speed classes"},
         .shows = "The shares of slow (below half of the mean speed), medium and fast particles "
                  "(above one and a half times it) against time.",
         .make = make_speed_classes,
         .abilities = {over, means},
         .keys = reference_key(),
         .suits = speeds_spread},
        {.name = "temperature",
         .words = Phrase{"temperature"},
         .shows = "The temperature against time, of all particles or of those that `of` names.",
         .make = make_temperature,
         .abilities = {of, over, means, comparison},
         .suits = acts_on_gas},
        {.name = "entropy",
         .words = Phrase{"entropy"},
         .shows = "The entropy of the velocities, of the positions, or both (`space`), against "
                  "time.",
         .make = make_entropy,
         .abilities = {means, comparison},
         .keys = entropy_keys(),
         .laws = laws_of_entropy},
        {.name = "pressure",
         .words = Phrase{"pressure"},
         .shows = "The pressure on all walls, or on single `surfaces`, against time; with `gauge: "
                  "true` on round gauges.",
         .make = make_pressure_or_gauge,
         .abilities = {over, means, comparison},
         .keys = pressure_keys(),
         .rule = check_pressure,
         .laws = laws_of_pressure},
        {.name = "thermometer",
         .words = Phrase{"thermometer"},
         .shows = "The temperature of all particles, of those that `of` names, or of those in "
                  "`regions` of the box, as thermometers with a common scale.",
         .make = make_thermometer,
         .abilities = {of, over, means, comparison},
         .keys = regions_key(),
         .rule = check_thermometer,
         .has_plot = false},
        {.name = "stopwatch",
         .words = Phrase{"stopwatch"},
         .shows = "The time since the start, since a time, or since an event.",
         .make = make_stopwatch,
         .abilities = {comparison},
         .keys = stopwatch_key(),
         .has_plot = false},
        {.name = "counter",
         .words = Phrase{"counter"},
         .shows = "The number of hits on walls and partitions, or of crossings of partitions or a "
                  "`line` in each direction, in large digits.",
         .make = make_counter,
         .abilities = {of, means, comparison},
         .keys = counter_keys(),
         .rule = check_counter,
         .has_plot = false},
        {.name = "pressure-volume",
         .words = Phrase{"pressure and volume"},
         .shows =
             "The pressure on a moving wall against the area, as a path; if the gas fills the "
             "area and there is no gravity, with the isotherm and the adiabat of hard disks or "
             "rods from the same start, or with an isotherm at each temperature to which heat "
             "baths change together; where the radii of disks differ or they are very few, with "
             "those of an ideal gas.",
         .make = make_pressure_volume,
         .abilities = {over, theory, comparison},
         .keys = pressure_volume_keys(),
         .rule = check_pressure_volume,
         .laws = always(LawOf::isotherm)},
        {.name = "piston",
         .words = Phrase{"piston"},
         .shows = "The position of moving walls and partitions against time; for a free piston, "
                  "with the mean position over an ideal gas, its standard deviation as a band, and "
                  "the period of the slow oscillations.",
         .make = make_piston,
         .abilities = {theory, means, comparison},
         .keys = surfaces_key(),
         .rule = check_piston,
         .laws = always(LawOf::piston)},
        {.name = "piston-histogram",
         .words = Phrase{"piston histogram"},
         .shows = "The share of the time that a moving wall or partition spends at each position, "
                  "with the exact distribution for a free piston over an ideal gas.",
         .make = make_piston_histogram,
         .abilities = {theory, means, comparison},
         .keys = surfaces_key(),
         .rule = check_piston_histogram,
         .laws = always(LawOf::piston)},
        {.name = "sides",
         .words = Phrase{"sides"},
         .shows = "The number of particles on each side of a partition, or in `regions` of the "
                  "box, against time; or their temperature, mean energy or centre of mass "
                  "(`measure`).",
         .make = make_sides,
         .abilities = {over, component, means, comparison},
         .keys = sides_keys(),
         .rule = check_sides,
         .laws = laws_of_sides},
        {.name = "flux",
         .words = Phrase{"flux"},
         .shows = "Particles that cross a partition or a `line` per unit of time, in each "
                  "direction, the energy that they carry, or their mean energy (`carried`), with "
                  "the values of kinetic theory.",
         .make = make_flux,
         .abilities = {of, over, theory, means, comparison},
         .keys = flux_keys(),
         .rule = check_flux},
        {.name = "energy-account",
         .words = Phrase{"energy account"},
         .shows =
             "Kinetic energy, potential energy and the energy of pistons against time, stacked.",
         .make = make_energy_account,
         .abilities = {means, comparison}},
        {.name = "mean-squared-displacement",
         .words = Phrase{"mean squared displacement"},
         .shows = "The mean squared displacement, unwrapped across periodic sides, with the fitted "
                  "line 2*dDt*, the diffusion coefficient *D* with its error (or the reason why "
                  "there is none, and the plateau between walls), and the parabola of free flight; "
                  "with `origins: all` averaged over all starting times.",
         .make = make_mean_squared_displacement,
         .abilities = {of, theory, means, comparison},
         .keys = displacement_keys(),
         .rule = check_displacements,
         .laws = always(LawOf::displacement)},
        {.name = "velocity-autocorrelation",
         .words = Phrase{"velocity autocorrelation"},
         .shows = "The mean of **v**(0)·**v**(*t*) over all starting times, divided by that of "
                  "*v*², with the initial slope that collisions give it in equilibrium.",
         .make = make_velocity_autocorrelation,
         .abilities = {of, theory, means, comparison},
         .keys = autocorrelation_keys(),
         .rule = check_autocorrelation,
         .laws = always(LawOf::autocorrelation)},
        {.name = "pair-correlation",
         .words = Phrase{"pair correlation"},
         .shows = "*g*(*r*): the number of pairs at each distance, relative to that of random "
                  "points in the same box, with Henderson's value for equal disks at contact.",
         .make = make_pair_correlation,
         .abilities = {of, over, theory, means, comparison},
         .keys = pair_correlation_keys(),
         .rule = check_pair_correlation,
         .laws = always(LawOf::contact)},
        {.name = "free-path",
         .words = Phrase{"free path"},
         .shows = "The distribution of the distances that particles fly between collisions, with "
                  "the exponential law of memoryless flight.",
         .make = make_free_path,
         .abilities = {of, over, theory, means, comparison},
         .keys = free_flight_keys(),
         .rule = check_free_flights,
         .laws = always(LawOf::memoryless)},
        {.name = "free-time",
         .words = Phrase{"free time"},
         .shows = "The distribution of the times that particles fly between collisions, with the "
                  "exponential law of memoryless flight.",
         .make = make_free_time,
         .abilities = {of, over, theory, means, comparison},
         .keys = free_flight_keys(),
         .rule = check_free_flights,
         .laws = always(LawOf::memoryless)},
        {.name = "orientational-order",
         .words = Phrase{"hexagonal order"},
         .shows =
             "The hexagonal order against time: of each disk's neighbours, and of the whole gas.",
         .make = make_orientational_order,
         .abilities = {means, comparison},
         .rule = check_orientational_order},
        {.name = "return-distance",
         .words = Phrase{"return error"},
         .shows =
             "The deviation from an exact return after a reversal, against time or collisions.",
         .make = make_return_distance,
         .abilities = {theory, comparison},
         .keys = against_key(),
         .rule = check_return_distance,
         .suits = returns,
         .laws = always(LawOf::error_growth)},
        {.name = "run-distance",
         .words = Phrase{"distance between the runs"},
         .shows =
             "The distance between two runs (`beside` of the film, or `compare` of the figure), "
             "as the root mean square over the particles that `of` names, on a logarithmic "
             "axis; where it grows exponentially, with the exponent.",
         .make = make_run_distance,
         .abilities = {of, two_runs, comparison},
         .rule = check_run_distance},
        {.name = "profile",
         .words = Phrase{"profile"},
         .shows = "Density, temperature, mean speed or flow (`quantity`) in slabs along an axis, "
                  "which is vertical for y. A density in gravity comes with that of an ideal gas "
                  "of as many disks that share a fixed energy. With `around`, the density in rings "
                  "around a point against the distance from it.",
         .make = make_profile_or_rings,
         .abilities = {of, over, component, theory, means, comparison},
         .keys = profile_keys(),
         .rule = check_profile},
        {.name = "phase",
         .words = Phrase{"phase space"},
         .shows = "Position and velocity along one axis, a point for each particle; a single "
                  "particle leaves a path that fades with age.",
         .make = make_phase,
         .abilities = {of, component},
         .keys = samples_key(),
         .rule = check_samples_of_points,
         .suits = is_line},
        {.name = "positions",
         .words = Phrase{"positions"},
         .shows = "The position of one particle against that of another, with the path so far.",
         .make = make_positions,
         .abilities = {of, two, component},
         .keys = samples_key(),
         .rule = check_samples_of_points},
        {.name = "monitors",
         .words = Phrase{"monitors"},
         .shows = "Numbers: time, collisions, mean speed and others.",
         .make = make_monitors,
         .keys = numbers_key(),
         .has_plot = false},
        {.name = "single-collision",
         .words = Phrase{"single collision"},
         .shows = "One collision in a plane: the velocities before, at and after contact.",
         .make = make_single_collision,
         .abilities = {of, pair},
         .has_own_time = always_has_own_time,
         .has_plot = false},
        {.name = "contact-time",
         .words = Phrase{"contact time"},
         .shows = "The squared distance of two particles against time, and the time of contact "
                  "that follows from it.",
         .make = make_contact_time,
         .abilities = {of, pair},
         .has_own_time = always_has_own_time},
        {.name = "collision-map",
         .words = Phrase{"collision map"},
         .shows = "Collisions of two beads on a line, in the plane of their two velocities: see "
                  "[Figures](figures.md#collision-maps).",
         .make = make_collision_map,
         .abilities = {of, pair},
         .keys = collision_map_keys(),
         .rule = check_collision_map,
         .has_own_time = [](const PanelSpec& spec) { return !spec.walk; }},
        {.name = "text",
         .words = Phrase{"text"},
         .shows = "Your own text, with formulae.",
         .make = make_text,
         .keys = words_key(),
         .rule = check_words,
         .has_plot = false},
        {.name = "sweep",
         .words = Phrase{"sweep"},
         .shows = "A number measured in many runs against a key that is varied, with its standard "
                  "error and theory: see [Figures](figures.md#sweeps).",
         .make = make_sweep,
         .abilities = {theory, means},
         .keys = sweep_keys(),
         .rule = check_sweep_figure,
         .has_own_time = always_has_own_time,
         .in_films_instead = "a sweep is of many runs; it is a kind of figure"},
        {.name = "gas",
         .words = Phrase{"gas"},
         .shows =
             "The box and everything in it, at one moment, or at several side by side (`strip`).",
         .make = make_gas,
         .abilities = {strip},
         .keys = view_key(),
         .in_films_instead = "the box is in every film; the template says where",
         .palettes = palette_names()},
    };
}

}  // namespace

PanelKinds panel_kinds() {
    static const std::vector<PanelKind> kinds = all_kinds();
    return kinds;
}

std::string name_of_panel(Language language, const PanelSpec& spec) {
    return spec.title ? *spec.title : say(language, kind_of(panel_kinds(), spec.kind)->words);
}

std::unique_ptr<Panel> make_gas_panel(const PanelContext& context,
                                      const std::optional<View>& view) {
    if (context.scene.gas.box.dimension == 1) return std::make_unique<LinePanel>(context, view);
    return std::make_unique<GasPanel>(context, view);
}

std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec) {
    const PanelKind* kind = kind_of(panel_kinds(), spec.kind);
    assert(kind != nullptr && "a validated scene names only kinds that there are");
    return kind->make(context, spec);
}

}  // namespace carom
