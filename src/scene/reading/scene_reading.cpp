#include "scene/reading/scene_reading.h"

#include <fmt/format.h>

#include <array>

#include "scene/limits.h"
#include "scene/reading/figure_reading.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/panel_reading.h"

namespace carom {
namespace {

Notation<std::string> style_name_notation() {
    Notation<std::string> name = text(1, most_title_letters);
    name.forms.front().words = {"conference"};
    return name;
}

Notation<double> scale_notation(int dimension) {
    struct Scale {
        double diameter = 1.0;
    };
    const KeyTable<Scale> table{
        .name = "`scale`",
        .keys = {bind_key("diameter", &Scale::diameter, number({1.0, largest_quantity}),
                          fmt::format("The factor of the diameters of all {} that have no "
                                      "`drawn_radius`.",
                                      particles_of(dimension)))
                     .required()}};
    return mapped(mapping(table, "{diameter: FACTOR}"),
                  [](const Scale& scale) { return scale.diameter; });
}

KeyTable<SceneDraft> new_table(PanelKinds kinds, int dimension) {
    const auto format = whole(1, {scene_format, "is the format that this carom reads"});
    KeyTable<SceneDraft> table{
        .name = "a scene",
        .keys = {bind_key("carom", &SceneDraft::format, format, "The version of the scene format."),
                 bind_key("title", &Scene::title, text(1, most_title_letters),
                          "Shown in the film and in the file's metadata.")
                     .required(),
                 bind_key("subtitle", &Scene::subtitle, text(0, most_title_letters),
                          "Shown under the title.")
                     .default_text("none"),
                 bind_key("description", &Scene::description, lines(1, most_letters),
                          "A description for viewers who cannot see the picture.")
                     .default_text("made from the scene's content"),
                 bind_key("seed", &Scene::seed, whole(0, largest_seed),
                          "Fixes every random choice."),
                 bind_key("units", &Scene::units, one_of<UnitSystem>(),
                          "The units of all numbers that describe the gas, its run and what is "
                          "shown of them: `reduced`, plain numbers whose units of length, mass and "
                          "time you choose; or `real`, each with its unit, such as `0.17 nm`, "
                          "`39.948 u`, `60 ps`, `300 K`.")
                     .tried_as({"unit", "unit_system"}),
                 bind_key("box", &SceneDraft::box, box_notation(dimension),
                          "The box that holds the gas.")
                     .required(),
                 bind_key(
                     "gravity", &SurfacesDraft::gravity,
                     placed(vector_of(dimension, any_number, quantities::speed / quantities::time)),
                     "The acceleration of every particle and every piston.")
                     .default_text("none"),
                 bind_key("partitions", &SurfacesDraft::partitions, partitions_notation(dimension),
                          dimension == 3
                              ? "A list of flat walls across the box, from side to side."
                              : "A list of straight walls across the box, from side to side.")
                     .default_text("none"),
                 bind_key("obstacles", &SurfacesDraft::obstacles, obstacles_notation(dimension),
                          "A list of fixed bodies in the box.")
                     .default_text("none"),
                 bind_key("gas", &SceneDraft::species, gas_notation(dimension),
                          "What is in the box: a list of species.")
                     .tried_as({"species", "particles", "disks", "balls", "beads", "gases"})
                     .required(),
                 bind_key("scale", &SceneDraft::scale, scale_notation(dimension),
                          fmt::format("How many times larger than they are pictures show {}; their "
                                      "places and the physics do not change, and pictures say so.",
                                      particles_of(dimension)))
                     .default_text("their own size"),
                 bind_key("run", &SceneDraft::written_run, run_notation(dimension),
                          "What happens to the gas.")
                     .tried_as({"simulation", "simulate", "time", "events"})
                     .required(),
                 bind_key("film", &SceneDraft::film_node, kept(mapping(film_table(kinds))),
                          "What the viewer sees.")
                     .tried_as({"movie", "video", "animation", "output"})
                     .default_text("the template's"),
                 bind_key("figures", &SceneDraft::figures_node, kept(figures_notation(kinds)),
                          "Pictures of single moments for texts and slides.")
                     .tried_as({"plots", "pictures", "images"})
                     .default_text("none"),
                 bind_key("figure_defaults", &SceneDraft::defaults_node,
                          kept(mapping(figure_defaults_table())),
                          "What the `figures` have that do not give it themselves.")
                     .tried_as({"figure_default", "defaults"})
                     .default_text("none"),
                 bind_key("style", &SceneDraft::style_name, style_name_notation(),
                          "The style of film and figures: a file in the scene's folder, or in "
                          "templates/styles, by name.")
                     .tried_as({"styles", "design", "look"})
                     .default_text("none"),
                 bind_key("measure", &SceneDraft::measure_node, kept(measure_notation(kinds)),
                          "Instruments whose readings at the end of the run are listed by `carom "
                          "run` and among the numbers of a sweep: kinds of panels that show "
                          "readings against time or on dials, such as `temperature`, or `{kind: "
                          "temperature, of: hot, over: {window: 5}, title: NAME}`; and those whose "
                          "curves have a result, such as the mean of `free-path`.")
                     .tried_as({"measurements", "meters", "instruments", "observables"})
                     .default_text("none")},
        .refused = inelastic_keys()};
    if (dimension > 1) return table;
    for (const auto& [name, hint] :
         {std::pair{"partitions", "a bead of mass `infinite` divides it"},
          {"obstacles", "a bead of mass `infinite` stands still"},
          {"scale", "give `drawn_radius`"}}) {
        std::erase_if(table.keys,
                      [refused = name](const auto& one) { return one.key.name == refused; });
        table.refused.push_back({name, fmt::format("a wire has no `{}`", name), hint});
    }
    return table;
}

}  // namespace

const FixedTable<SceneDraft>& scene_table(PanelKinds kinds, int dimension) {
    static std::array<MadeOnce<FixedTable<SceneDraft>>, 3> tables;
    return tables.at(static_cast<std::size_t>(dimension - 1)).of(kinds, [&] {
        return new_table(kinds, dimension);
    });
}

}  // namespace carom
