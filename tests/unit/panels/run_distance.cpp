// The distance between two runs, and the exponent with which it grows.
#include <doctest/doctest.h>

#include <cmath>

#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

// Two disks whose counterparts are start exp(rate t) away from them along x, up to a distance of 3.
struct TwoRuns {
    Scene scene;
    Simulation simulation;
    BoxedGas none;
    std::unique_ptr<Panel> own, other;
    std::shared_ptr<const PanelState> state;

    TwoRuns(double start, double rate, bool is_linear = false)
        : scene(test::scene_from("title: T\nbox: {size: [20, 10]}\ngas: [{count: 2, radius: 0.1, "
                                 "speed: 1}]\nrun: {until: 100}\n")),
          simulation(scene.gas, scene.run) {
        const PanelContext context{scene, simulation.particles(), 101, none};
        own = make_panel(context, {.kind = "run-distance"});
        other = make_panel(context, {.kind = "run-distance"});
        std::vector<std::shared_ptr<const PanelState>> states(2);
        for (const bool is_second_pass : {false, true}) {
            for (int time = 0; time <= 100; ++time) {
                const double apart = std::min(
                    3.0, is_linear ? start * (1.0 + rate * time) : start * std::exp(rate * time));
                for (const bool is_other : {false, true}) {
                    Eigen::ArrayXXd place = Eigen::ArrayXXd::Constant(2, 2, 5.0);
                    if (is_other) place.col(0) += apart;
                    const Sample sample{double(time), place, Eigen::ArrayXXd::Zero(2, 2)};
                    const Eigen::ArrayXd nothing = Eigen::ArrayXd::Zero(2);
                    const AdvanceResult advanced;
                    Tick tick;
                    tick.time = time;
                    const FrameInput input{tick, sample, nothing, nothing, advanced};
                    Panel& panel = is_other ? *other : *own;
                    if (is_second_pass)
                        states[is_other] = panel.state(input);
                    else
                        panel.survey(input);
                }
            }
            if (!is_second_pass)
                dynamic_cast<SharedPanel&>(*own).fix_axes_of_runs({other.get()}, {"a", "b"});
        }
        state = dynamic_cast<SharedPanel&>(*own).state_of_runs(states);
    }

    plot::Plot plot() const { return dynamic_cast<const PlotPanel&>(*own).plot(state.get()); }
    std::optional<plot::Polyline> line(const std::string& part) const {
        for (const plot::AnyLayer& layer : plot().layers)
            if (const auto* one = std::get_if<plot::Polyline>(&layer); one && one->part == part)
                return *one;
        return {};
    }
};

}  // namespace

TEST_CASE("the distance of two runs is drawn as its logarithm, with the exponent of its growth") {
    const TwoRuns runs(1e-9, 0.4);
    const auto line = runs.line("line");
    REQUIRE(line);
    CHECK(line->y[0] == doctest::Approx(-9.0).epsilon(1e-6));
    CHECK(line->y[line->y.size() - 1] == doctest::Approx(std::log10(3.0)));
    const auto fit = runs.line("fit");
    REQUIRE(fit);
    const double exponent = (fit->y[1] - fit->y[0]) / (fit->x[1] - fit->x[0]) * std::log(10.0);
    CHECK(exponent == doctest::Approx(0.4).epsilon(1e-3));
    // before a hundredth of the shorter side: 0.1 = 1e-9 exp(0.4 t)
    CHECK(fit->x[1] == std::floor(std::log(1e8) / 0.4));
    CHECK(runs.plot().finding.find("0.4") != std::string::npos);
}

TEST_CASE("a distance that does not grow exponentially has no exponent") {
    CHECK(!TwoRuns(1e-9, 1.0, true).line("fit"));  // free flights: hardly two powers of ten
    CHECK(!TwoRuns(1e-3, 0.05).line("fit"));       // rises less than three powers of ten
}
