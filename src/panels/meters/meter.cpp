#include "panels/meters/meter.h"

#include "panels/chosen.h"

namespace carom {

Meter meter_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title,
                       const Quantity& quantity) {
    Meter meter{.title = say(context.language(), title), .quantity = quantity};
    const std::vector<Chosen> chosen = choices(spec);
    for (std::size_t k = 0; k < chosen.size(); ++k)
        meter.lines.push_back({column_name_of(context.scene, chosen[k]),
                               spec.of.empty() ? "" : name_of(context.scene, chosen[k]),
                               role_among(context, chosen, k)});
    return meter;
}

}  // namespace carom
