#include "panels/instruments/instrument_keys.h"

#include "panels/plot/clock_samples.h"
#include "scene/instruments/instrument_reading.h"

namespace carom {
namespace {

std::vector<Binding<PanelSpec>> line_keys() {
    return joined<PanelSpec>(
        surfaces_key(), std::vector{bind_key("line", &PanelSpec::line, counting_line_notation(),
                                             "A line that particles cross, instead of a partition.")
                                        .default_text("none")});
}

}  // namespace

std::vector<Binding<PanelSpec>> surfaces_key() {
    return {bind_key("surfaces", &PanelSpec::surfaces, surfaces_notation(),
                     "The walls or partitions where it measures: `left`, `right`, `bottom`, `top` "
                     "or the names of partitions. A histogram shows the particles on each side of "
                     "the partition that it names.")
                .default_text("all walls together for a pressure; none for a histogram; else what "
                              "moves, or the only partition")};
}

std::vector<Binding<PanelSpec>> pressure_keys() {
    return joined<PanelSpec>(
        surfaces_key(),
        std::vector{bind_key("gauge", &PanelSpec::gauge, flag(),
                             "Whether to show the mean over a time before the present on round "
                             "gauges: one for each surface, or one for all walls.")});
}

std::vector<Binding<PanelSpec>> pressure_volume_keys() {
    return joined<PanelSpec>(
        surfaces_key(),
        std::vector{bind_key("levels", &PanelSpec::levels,
                             list_of(number(positive), 1, most_chosen, "a list of numbers"),
                             "Multiples of the pressure *p* of the start, by theory, at which "
                             "lines are drawn: [1, 2] for *p* and 2 *p*.")
                        .default_text("none")});
}

std::vector<Binding<PanelSpec>> flux_keys() {
    return joined<PanelSpec>(
        line_keys(),
        std::vector{bind_key("carried", &PanelSpec::carried,
                             one_of<Carried>({{"particles", Carried::particles},
                                              {"energy", Carried::energy},
                                              {"mean-energy", Carried::mean_energy}}),
                             "What it shows of the particles that cross: number per unit of time, "
                             "energy per unit of time, or mean energy.")});
}

std::vector<Binding<PanelSpec>> counter_keys() {
    return joined<PanelSpec>(
        line_keys(),
        std::vector{
            bind_key("count", &PanelSpec::counted,
                     one_of<Counted>({{"hits", Counted::hits}, {"crossings", Counted::crossings}}),
                     "What it counts: collisions with walls and partitions, or crossings of "
                     "partitions in each direction.")
                .default_text("crossings of partitions that let particles through, else "
                              "hits")});
}

std::vector<Binding<PanelSpec>> stopwatch_key() {
    return {bind_key("since", &PanelSpec::since, watch_start_notation(),
                     "When it starts: a time, or the first event of this name: `reversal`, `heat`, "
                     "or the wall or partition that the event acts on.")
                .default_text("start")};
}

std::vector<Binding<PanelSpec>> regions_key() {
    return {bind_key("regions", &PanelSpec::regions, regions_notation(),
                     "Parts of the box: `sides` shows them instead of the sides of a partition, a "
                     "thermometer instead of particles by `of`, and a histogram those particles "
                     "that are in each at the time.")
                .default_text("none")};
}

std::vector<Binding<PanelSpec>> histogram_keys() {
    return joined<PanelSpec>(samples_key(), surfaces_key(), regions_key());
}

std::vector<Binding<PanelSpec>> sides_keys() {
    return joined<PanelSpec>(
        surfaces_key(), regions_key(),
        std::vector{bind_key("measure", &PanelSpec::measure,
                             one_of<PartMeasure>({{"count", PartMeasure::count},
                                                  {"temperature", PartMeasure::temperature},
                                                  {"mean-energy", PartMeasure::mean_energy},
                                                  {"center", PartMeasure::center}}),
                             "What it shows of the particles in each part: their number, "
                             "temperature, mean energy, or centre of mass along `component`.")});
}

}  // namespace carom
