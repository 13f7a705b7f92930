#include <doctest/doctest.h>

#include <cmath>

#include "panels/histogram_panel.h"

using namespace carom;

namespace {

struct Stage {
    Scene scene;
    Particles particles;
    std::optional<EquilibriumGas> none;

    explicit Stage(Eigen::Index count) {
        particles.radius = Eigen::ArrayXd::Constant(count, 0.5);
        particles.inverse_mass = Eigen::ArrayXd::Ones(count);
        particles.species = Eigen::ArrayXi::Zero(count);
    }
};

HistogramSubject speeds_with(std::function<double(double)> density) {
    return {.title = "Speeds",
            .quantity = "speed",
            .beyond = "faster",
            .values = [](const Observation& o) -> const Eigen::ArrayXd& { return o.speed; },
            .density = std::move(density)};
}

void survey(HistogramPanel& panel, const std::vector<Eigen::ArrayXd>& frames) {
    const Sample sample;
    const Passage passage;
    for (const Eigen::ArrayXd& speed : frames) {
        const Tick tick;
        panel.survey({tick, sample, speed, speed, passage});
    }
    panel.settle();
}

}  // namespace

TEST_CASE("the axis of a histogram holds the run, and round-off never splits equal values") {
    Stage stage(100);
    HistogramPanel panel({stage.scene, stage.particles, 2, stage.none}, {}, speeds_with({}));
    survey(panel, {Eigen::ArrayXd::Constant(100, 2.0), Eigen::ArrayXd::LinSpaced(100, 0.0, 4.0)});
    const Bins& bins = panel.bins();
    CHECK(bins.low == 0.0);
    CHECK(bins.high >= 3.9);
    CHECK(bins.high <= 6.0);
    const double place = 2.0 / bins.width();
    CHECK(std::abs(place - std::round(place)) > 1e-3);
}

TEST_CASE("bins and range of the scene are taken as they are") {
    Stage stage(10);
    PanelSpec spec;
    spec.bins = 7;
    spec.range = {1.0, 3.0};
    HistogramPanel panel({stage.scene, stage.particles, 1, stage.none}, spec, speeds_with({}));
    survey(panel, {Eigen::ArrayXd::LinSpaced(10, 0.0, 4.0)});
    CHECK(panel.bins().count == 7);
    CHECK(panel.bins().low == 1.0);
    CHECK(panel.bins().high == 3.0);
}

TEST_CASE("a start far from equilibrium does not flatten the curve") {
    Stage stage(1000);
    // Expected number in a bin: 1000 * width * density; the start puts all 1000 into one.
    HistogramPanel panel({stage.scene, stage.particles, 2, stage.none}, {},
                         speeds_with([](double v) { return v * std::exp(-v * v / 2); }));
    survey(panel,
           {Eigen::ArrayXd::Constant(1000, 0.01), Eigen::ArrayXd::LinSpaced(1000, 0.0, 4.0)});
    const double curve = 1000 * panel.bins().width() * std::exp(-0.5);  // its top, at v = 1
    CHECK(panel.tallest() >= 1.1 * curve);
    CHECK(panel.tallest() <= 2.5 * curve);
}

TEST_CASE("the curve is that of the particles that share the energy") {
    Stage stage(1000);  // 900 of them infinitely heavy and at rest
    const std::optional<EquilibriumGas> hundred =
        EquilibriumGas{.energy = 100.0, .beta = 99.0, .groups = {{1.0, 100.0, 1.0}}};
    HistogramPanel panel({stage.scene, stage.particles, 1, hundred}, {},
                         speeds_with([](double v) { return v * std::exp(-v * v / 2); }));
    survey(panel, {Eigen::ArrayXd::LinSpaced(1000, 0.0, 4.0)});
    const double curve = 100 * panel.bins().width() * std::exp(-0.5);  // its top, at v = 1
    CHECK(panel.tallest() >= 1.1 * curve);
    CHECK(panel.tallest() <= 2.5 * curve);
}
