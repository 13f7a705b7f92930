// How many particles have which kinetic energy now, beside what this finite gas has at equilibrium.
#include "panels/histogram_panel.h"
#include "panels/registry.h"
#include "physics/theory.h"

namespace carom {

std::unique_ptr<Panel> make_energy_histogram(const Cast& cast, const PanelSpec& spec) {
    HistogramSubject subject{
        .title = "Particles by energy",
        .quantity = "energy",
        .beyond = "higher",
        .values = [](const Observation& o) -> const Eigen::ArrayXd& { return o.energy; },
        .density = {}};
    if (cast.equilibrium)
        subject.density = [&gas = *cast.equilibrium](double e) { return energy_density(gas, e); };
    if (cast.equilibrium && cast.equilibrium->alpha < 1.0)
        subject.probability = [&gas = *cast.equilibrium](double low, double high) {
            return energy_probability(gas, low, high);
        };
    return std::make_unique<HistogramPanel>(cast, spec, std::move(subject));
}

}  // namespace carom
