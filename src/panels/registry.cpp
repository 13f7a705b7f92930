#include "panels/registry.h"

#include <fmt/format.h>

#include <cassert>

#include "panels/collision/collision_map_keys.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/gas/gas_colors.h"
#include "panels/gas/gas_panel.h"
#include "panels/line/line_panel.h"
#include "panels/sweep/sweep_keys.h"
#include "physics/theory/error_growth.h"
#include "scene/instruments/instrument_reading.h"
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
                     "The horizontal axis: the time since the reversal, or the collisions of each "
                     "particle since then, on average.")};
}

// Reports a run without a reversal, and a growth law that is asked for where none is known.
void check_return_distance(PanelSpec& panel, const Node& node, Reading& reading) {
    check_reversal(node.is_mapping() ? *given(node, "kind") : node, reading);
    const Node* asked = given(node, "theory");
    if (asked == nullptr || !panel.theory || reading.gas.species.empty()) return;
    if (asked->source->origin == Origin::template_file) return;
    if (const auto reason = why_no_growth_law(reading.gas))
        reading.errors.add(*asked, *reason,
                           "leave out `theory`; the curve is then drawn where there is one");
}

std::vector<Binding<PanelSpec>> numbers_key() {
    return {
        bind_key(
            "numbers", &PanelSpec::numbers, monitors_notation(),
            "The numbers that it shows; all-collisions includes those with walls, return-distance "
            "is the largest distance of a particle from where it was on the way out, overlap the "
            "deepest so far of two disks that collided, in per cent of the sum of their radii.")
            .default_text("time, collisions, mean-speed and mean-energy")};
}

Binding<PanelSpec> cells_key() {
    return bind_key("cells", &PanelSpec::bins, whole(2, most_field_cells),
                    "How many slabs are along the axis; of an entropy, how many cells are along "
                    "the longer side of the box.")
        .default_text("20; of an entropy, about as many as leave five particles in each");
}

std::vector<Binding<PanelSpec>> profile_keys() {
    return {bind_key("quantity", &PanelSpec::quantity, quantity_notation(false),
                     "What it shows; the flow is that along the axis."),
            cells_key()};
}

std::vector<Binding<PanelSpec>> entropy_keys() {
    return {bind_key("space", &PanelSpec::entropy_of,
                     one_of<EntropyOf>({{"velocities", EntropyOf::velocities},
                                        {"positions", EntropyOf::positions},
                                        {"both", EntropyOf::both}}),
                     "What is counted in cells: the velocities, the positions, or each of them."),
            cells_key()};
}

std::vector<Binding<PanelSpec>> surfaces_key() {
    return {bind_key("surfaces", &PanelSpec::surfaces, surfaces_notation(),
                     "The walls or partitions that it measures at: `left`, `right`, `bottom`, "
                     "`top` or the names of partitions.")
                .default_text("all walls together for a pressure; else what moves, or the only "
                              "partition")};
}

std::vector<Binding<PanelSpec>> gauge_key() {
    return {bind_key("gauge", &PanelSpec::gauge, flag(),
                     "Whether a round gauge for each surface, or one for all walls, shows the mean "
                     "over a time before the present.")};
}

std::unique_ptr<Panel> make_pressure_or_gauge(const PanelContext& context, const PanelSpec& spec) {
    return spec.gauge ? make_pressure_gauge(context, spec) : make_pressure(context, spec);
}

std::vector<Binding<PanelSpec>> line_keys() {
    return joined<PanelSpec>(
        surfaces_key(), std::vector{bind_key("line", &PanelSpec::line, counting_line_notation(),
                                             "A line that particles cross, instead of a partition.")
                                        .default_text("none")});
}

std::vector<Binding<PanelSpec>> flux_keys() {
    return joined<PanelSpec>(
        line_keys(),
        std::vector{bind_key("carried", &PanelSpec::carried,
                             one_of<Carried>({{"particles", Carried::particles},
                                              {"energy", Carried::energy},
                                              {"mean-energy", Carried::mean_energy}}),
                             "What it shows of those that cross: their number in a time, their "
                             "energy in a time, or the mean energy of one.")});
}

std::vector<Binding<PanelSpec>> counter_keys() {
    return joined<PanelSpec>(
        line_keys(),
        std::vector{
            bind_key("count", &PanelSpec::counted,
                     one_of<Counted>({{"hits", Counted::hits}, {"crossings", Counted::crossings}}),
                     "What it counts: collisions with walls and partitions, or what goes "
                     "over partitions, each way.")
                .default_text("crossings of partitions that let particles through, else "
                              "hits")});
}

std::vector<Binding<PanelSpec>> since_key() {
    return {bind_key("since", &PanelSpec::since, watch_start_notation(),
                     "When it starts: a time, or the first event of the run that is called so: "
                     "`reversal`, `heat`, or the wall or partition that it acts on.")
                .default_text("start")};
}

Binding<PanelSpec> regions_key() {
    return bind_key("regions", &PanelSpec::regions, regions_notation(),
                    "Parts of the box, instead of the two sides of a partition, or of particles by "
                    "`of`.")
        .default_text("none");
}

std::vector<Binding<PanelSpec>> sides_keys() {
    std::vector<Binding<PanelSpec>> keys = surfaces_key();
    keys.push_back(regions_key());
    keys.push_back(bind_key("measure", &PanelSpec::measure,
                            one_of<PartMeasure>({{"count", PartMeasure::count},
                                                 {"temperature", PartMeasure::temperature},
                                                 {"mean-energy", PartMeasure::mean_energy},
                                                 {"center", PartMeasure::center}}),
                            "What it shows of the particles in each part: their number, "
                            "temperature, mean energy, or centre of mass along `component`."));
    return keys;
}

std::vector<Binding<PanelSpec>> view_key() {
    return {bind_key("view", &PanelSpec::view, view_notation(),
                     "What the figure shows of the box: `box`, all of it, or a part.")
                .default_text("as the film's camera shows it at that time")};
}

std::vector<Binding<PanelSpec>> words_key() {
    return {
        bind_key(
            "words", &PanelSpec::words, with_formulas(lines(1, most_words_letters)),
            "The text of the panel; an empty line separates paragraphs. Formulae stand between `$` "
            "signs, large where they are a paragraph.")
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

std::int64_t count_of(const Gas& gas) {
    std::int64_t count = 0;
    for (const Species& species : gas.species) count += species.count;
    return count;
}

bool acts_on_gas(const Gas& gas, const Run& run) {
    return !gas.box.surfaces.are_plain() ||
           std::ranges::any_of(run.events, [](const RunEvent& event) {
               return std::holds_alternative<Heat>(event.action);
           });
}

// Whether collisions spread the speeds: equal beads on a line only exchange them, and so does a
// pair.
bool speeds_spread(const Gas& gas, const Run& run) {
    const auto common_mass = [](const Species& species) -> std::optional<double> {
        const auto* mass = std::get_if<Quantity>(&species.mass);
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

std::vector<PanelKind> all_kinds() {
    using enum Ability;
    return {
        {.name = "speed-histogram",
         .words = Phrase{"speed histogram"},
         .make = make_speed_histogram,
         .abilities = {bars, from_zero, of, over, theory, equilibrium, means, comparison},
         .suits = speeds_spread},
        {.name = "energy-histogram",
         .words = Phrase{"energy histogram"},
         .make = make_energy_histogram,
         .abilities = {bars, from_zero, of, over, theory, equilibrium, means, comparison},
         .suits = speeds_spread},
        {.name = "velocity-histogram",
         .words = Phrase{"velocity histogram"},
         .make = make_velocity_histogram,
         .abilities = {bars, of, over, component, both, theory, equilibrium, means, comparison},
         .suits = speeds_spread},
        {.name = "position-histogram",
         .words = Phrase{"position histogram"},
         .make = make_position_histogram,
         .abilities = {bars, of, over, component, means, comparison}},
        {.name = "energy-by-species",
         .words = Phrase{"energy by species"},
         .make = make_energy_by_species,
         .abilities = {means},
         .suits = has_several_species},
        {.name = "speed-classes",
         .words = Phrase{"speed classes"},
         .make = make_speed_classes,
         .abilities = {means},
         .keys = reference_key(),
         .suits = speeds_spread},
        {.name = "temperature",
         .words = Phrase{"temperature"},
         .make = make_temperature,
         .abilities = {of, means, comparison},
         .suits = acts_on_gas},
        {.name = "entropy",
         .words = Phrase{"entropy"},
         .make = make_entropy,
         .abilities = {means, comparison},
         .keys = entropy_keys()},
        {.name = "pressure",
         .words = Phrase{"pressure"},
         .make = make_pressure_or_gauge,
         .abilities = {over, means, comparison},
         .keys = joined<PanelSpec>(surfaces_key(), gauge_key()),
         .rule = check_pressure},
        {.name = "thermometer",
         .words = Phrase{"thermometer"},
         .make = make_thermometer,
         .abilities = {of, over, means, comparison},
         .keys = {regions_key()},
         .rule = check_thermometer,
         .has_plot = false},
        {.name = "stopwatch",
         .words = Phrase{"stopwatch"},
         .make = make_stopwatch,
         .abilities = {comparison},
         .keys = since_key(),
         .has_plot = false},
        {.name = "counter",
         .words = Phrase{"counter"},
         .make = make_counter,
         .abilities = {of, means, comparison},
         .keys = counter_keys(),
         .rule = check_counter,
         .has_plot = false},
        {.name = "pressure-volume",
         .words = Phrase{"pressure and volume"},
         .make = make_pressure_volume,
         .abilities = {over, theory, comparison},
         .keys = surfaces_key(),
         .rule = check_pressure_volume},
        {.name = "piston",
         .words = Phrase{"piston"},
         .make = make_piston,
         .abilities = {theory, means, comparison},
         .keys = surfaces_key(),
         .rule = check_piston},
        {.name = "piston-histogram",
         .words = Phrase{"piston histogram"},
         .make = make_piston_histogram,
         .abilities = {theory, means, comparison},
         .keys = surfaces_key(),
         .rule = check_piston_histogram},
        {.name = "sides",
         .words = Phrase{"sides"},
         .make = make_sides,
         .abilities = {component, means, comparison},
         .keys = sides_keys(),
         .rule = check_sides},
        {.name = "flux",
         .words = Phrase{"flux"},
         .make = make_flux,
         .abilities = {of, over, theory, means, comparison},
         .keys = flux_keys(),
         .rule = check_flux},
        {.name = "energy-account",
         .words = Phrase{"energy account"},
         .make = make_energy_account,
         .abilities = {means, comparison}},
        {.name = "mean-squared-displacement",
         .words = Phrase{"mean squared displacement"},
         .make = make_mean_squared_displacement,
         .abilities = {of, theory, means, comparison},
         .keys = displacement_keys(),
         .rule = check_displacements},
        {.name = "velocity-autocorrelation",
         .words = Phrase{"velocity autocorrelation"},
         .make = make_velocity_autocorrelation,
         .abilities = {of, theory, means, comparison},
         .keys = autocorrelation_keys(),
         .rule = check_autocorrelation},
        {.name = "pair-correlation",
         .words = Phrase{"pair correlation"},
         .make = make_pair_correlation,
         .abilities = {of, over, theory, means, comparison},
         .keys = pair_correlation_keys(),
         .rule = check_pair_correlation},
        {.name = "free-path",
         .words = Phrase{"free path"},
         .make = make_free_path,
         .abilities = {of, over, theory, means, comparison},
         .keys = free_flight_keys(),
         .rule = check_free_flights},
        {.name = "free-time",
         .words = Phrase{"free time"},
         .make = make_free_time,
         .abilities = {of, over, theory, means, comparison},
         .keys = free_flight_keys(),
         .rule = check_free_flights},
        {.name = "orientational-order",
         .words = Phrase{"hexagonal order"},
         .make = make_orientational_order,
         .abilities = {means, comparison},
         .rule = check_orientational_order},
        {.name = "return-distance",
         .words = Phrase{"return distance"},
         .make = make_return_distance,
         .abilities = {theory, comparison},
         .keys = against_key(),
         .rule = check_return_distance,
         .suits = returns},
        {.name = "profile",
         .words = Phrase{"profile"},
         .make = make_profile,
         .abilities = {of, over, component, theory, means, comparison},
         .keys = profile_keys()},
        {.name = "phase",
         .words = Phrase{"phase"},
         .make = make_phase,
         .abilities = {of, component},
         .suits = is_line},
        {.name = "positions",
         .words = Phrase{"positions"},
         .make = make_positions,
         .abilities = {of, two, component}},
        {.name = "monitors",
         .words = Phrase{"monitors"},
         .make = make_monitors,
         .keys = numbers_key(),
         .has_plot = false},
        {.name = "single-collision",
         .words = Phrase{"single collision"},
         .make = make_single_collision,
         .abilities = {of, pair},
         .has_plot = false},
        {.name = "contact-time",
         .words = Phrase{"contact time"},
         .make = make_contact_time,
         .abilities = {of, pair}},
        {.name = "collision-map",
         .words = Phrase{"collision map"},
         .make = make_collision_map,
         .abilities = {of, pair},
         .keys = collision_map_keys(),
         .rule = check_collision_map},
        {.name = "text",
         .words = Phrase{"text"},
         .make = make_text,
         .keys = words_key(),
         .rule = check_words,
         .has_plot = false},
        {.name = "sweep",
         .words = Phrase{"sweep"},
         .make = make_sweep,
         .abilities = {theory, means},
         .keys = sweep_keys(),
         .rule = check_sweep_figure,
         .in_films_instead = "a sweep is of many runs; it is a kind of figure"},
        {.name = "gas",
         .words = Phrase{"gas"},
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
