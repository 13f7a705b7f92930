// Options that say where panels measure, and their keys.
#pragma once

#include <optional>
#include <vector>

#include "scene/instruments/places.h"
#include "scene/keys/binding.h"
#include "scene/limits.h"
#include "scene/panel_kind.h"

namespace carom {

Binding<SurfaceNumbers> surfaces_key();
Binding<std::vector<NamedRegion>> regions_key();
Binding<std::optional<CountingLine>> line_key();
std::vector<Binding<MeasuredAt>> part_keys();

/// The key `cells` of a kind whose options have this field.
template <class T>
Binding<T> cells_key(std::optional<int> T::*cells) {
    return bind_key("cells", cells, whole(2, most_field_cells),
                    "The number of slabs along the axis; for an entropy, of cells along the longer "
                    "side of the box.")
        .default_text("20; for an entropy, as many as give about five particles per cell");
}

/// For PanelKind: the option by which a panel says where it measures.
template <class T>
auto measured_at(MeasuredAt T::*parts) {
    return [parts](const PanelSpec& panel) { return panel.options.as<T>().*parts; };
}
template <class T>
auto measured_at(SurfaceNumbers T::*surfaces) {
    return [surfaces](const PanelSpec& panel) {
        return MeasuredAt{.surfaces = panel.options.as<T>().*surfaces};
    };
}
template <class T>
auto measured_at(std::vector<NamedRegion> T::*regions) {
    return [regions](const PanelSpec& panel) {
        return MeasuredAt{.regions = panel.options.as<T>().*regions};
    };
}

}  // namespace carom
