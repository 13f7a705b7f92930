// The numbers under the gas as a panel of their own, for templates that have no row of them.
#include "panels/monitors_panel.h"
#include "panels/registry.h"

namespace carom {

std::unique_ptr<Panel> make_monitors(const Cast& cast, const PanelSpec&) {
    return std::make_unique<MonitorsPanel>(cast, false);
}

}  // namespace carom
