#include "panels/registry.h"

#include <cassert>

#include "panels/gas/gas_panel.h"
#include "panels/line/line_panel.h"
#include "panels/plot/plot_panel.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

PanelKinds panel_kinds() {
    static const std::vector<PanelKind> kinds{speed_histogram_kind(),
                                              energy_histogram_kind(),
                                              velocity_histogram_kind(),
                                              position_histogram_kind(),
                                              energy_by_species_kind(),
                                              speed_classes_kind(),
                                              temperature_kind(),
                                              entropy_kind(),
                                              pressure_kind(),
                                              thermometer_kind(),
                                              stopwatch_kind(),
                                              counter_kind(),
                                              pressure_volume_kind(),
                                              piston_kind(),
                                              piston_histogram_kind(),
                                              sides_kind(),
                                              flux_kind(),
                                              energy_account_kind(),
                                              particle_speed_kind(),
                                              mean_free_path_kind(),
                                              halves_kind(),
                                              mean_squared_displacement_kind(),
                                              velocity_autocorrelation_kind(),
                                              pair_correlation_kind(),
                                              free_path_kind(),
                                              free_time_kind(),
                                              orientational_order_kind(),
                                              return_distance_kind(),
                                              run_distance_kind(),
                                              profile_kind(),
                                              phase_kind(),
                                              positions_kind(),
                                              monitors_kind(),
                                              single_collision_kind(),
                                              contact_time_kind(),
                                              collision_map_kind(),
                                              text_kind(),
                                              sweep_kind(),
                                              gas_kind()};
    return kinds;
}

const PanelKind& kind_of(const PanelSpec& spec) {
    const PanelKind* kind = kind_of(panel_kinds(), spec.kind);
    assert(kind != nullptr && "a validated scene names only kinds that there are");
    return *kind;
}

PanelWork work_of(const PanelSpec& spec, const Run& run) {
    const PanelKind& kind = kind_of(spec);
    return kind.work ? kind.work(spec, run) : PanelWork{};
}

MeasuredAt places_of(const PanelSpec& spec) {
    const PanelKind& kind = kind_of(spec);
    return kind.measured_at ? kind.measured_at(spec) : MeasuredAt{};
}

std::string name_of_panel(const Scene& scene, const PanelSpec& spec) {
    if (spec.title) return *spec.title;
    const PanelKind& kind = kind_of(spec);
    const bool is_deep = scene.gas.box.dimension == 3;
    return say(scene.film.language,
               is_deep ? kind.words_in_space.value_or(kind.words) : kind.words);
}

std::unique_ptr<Panel> make_gas_panel(const PanelContext& context) {
    return make_gas_panel(context, {});
}

std::unique_ptr<Panel> make_gas_panel(const PanelContext& context, const FixedView& fixed) {
    if (context.box().dimension == 1) return std::make_unique<LinePanel>(context, fixed.view);
    return std::make_unique<GasPanel>(context, fixed);
}

std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec) {
    std::unique_ptr<Panel> panel = kind_of(spec).make(context, spec);
    if (auto* plot = dynamic_cast<PlotPanel*>(panel.get())) {
        plot->set_axis_words(spec.x_title, spec.y_title);
        plot->set_units(context.wording().units);
    }
    return panel;
}

}  // namespace carom
