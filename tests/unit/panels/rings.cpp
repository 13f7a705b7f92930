// The density in rings around a point, and its front.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "panels/registry.h"
#include "scene/scene.h"
#include "support/scene_text.h"
#include "support/seen_panel.h"

using namespace carom;

namespace {

// So many particles evenly in each ring of width 1 around (10, 10), in a box of 20 by 30.
struct RingsOfParticles {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 30]}\ngas: [{count: 900, radius: 0.001, speed: 1}]\nrun: "
        "{until: "
        "5}\n"
        "film: {seconds: 5, template: lecture, panels: [{kind: profile, around: [10, 10], cells: "
        "10, "
        "mark_front: true, over: now}]}\n");
    Simulation simulation{scene.gas, scene.run};
    BoxedGas none;
    std::unique_ptr<Panel> panel =
        make_panel({scene, simulation.particles(), 1, none}, scene.film.panels.front());
    std::shared_ptr<const PanelState> state;

    explicit RingsOfParticles(const std::vector<int>& in_ring) {
        Eigen::ArrayXXd places = Eigen::ArrayXXd::Constant(900, 2, 0.01);  // beyond all rings
        Eigen::Index next = 0;
        for (std::size_t ring = 0; ring < in_ring.size(); ++ring)
            for (int k = 0; k < in_ring[ring]; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / in_ring[ring];
                const double r = static_cast<double>(ring) + 0.5;
                places(next, 0) = 10.0 + r * std::cos(angle);
                places(next++, 1) = 10.0 + r * std::sin(angle);
            }
        const Sample sample{0.0, places, Eigen::ArrayXXd::Zero(900, 2)};
        const Eigen::ArrayXd nothing = Eigen::ArrayXd::Zero(900);
        const AdvanceResult advanced;
        const Tick tick;
        const FrameInput input{tick, sample, nothing, nothing, advanced};
        panel->survey(input);
        panel->fix_axes();
        state = panel->state(input);
    }

    plot::Plot plot() const { return dynamic_cast<const PlotPanel&>(*panel).plot(state.get()); }
    std::optional<double> front() const {
        for (const plot::AnyLayer& layer : plot().layers)
            if (const auto* marker = std::get_if<plot::Marker>(&layer)) return marker->value;
        return {};
    }
};

}  // namespace

TEST_CASE("a profile around a point shows particles in each ring by its area") {
    const RingsOfParticles rings({3, 9, 15, 21, 0, 33, 39, 45, 51, 57});
    const plot::Plot plot = rings.plot();
    CHECK(plot.x.high == 10.0);  // to the nearest side
    for (const plot::AnyLayer& layer : plot.layers)
        if (const auto* line = std::get_if<plot::Polyline>(&layer))
            for (std::size_t ring = 0; ring < 10; ++ring)
                CHECK(line->y[2 * ring] ==
                      doctest::Approx(ring == 4 ? 0.0 : 3.0 / std::numbers::pi).epsilon(1e-12));
}

TEST_CASE("the front is the ring of the highest density, if that is no chance") {
    // 900 points in 600: 4.7, 14.1, ... in the rings of an even density; from 6 to 7 it is highest
    const RingsOfParticles ring({2, 6, 9, 13, 18, 60, 80, 90, 60, 60});
    REQUIRE(ring.front());
    CHECK(*ring.front() == doctest::Approx(6.5).epsilon(0.05));
    const RingsOfParticles even({5, 14, 24, 33, 44, 53, 61, 73, 80, 88});
    CHECK(!even.front());
}
