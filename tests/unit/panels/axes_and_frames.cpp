// Axes are drawn once for a film, and data in each frame: both must be laid out alike.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "draw/disks/disks.h"
#include "panels/plot/layers.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

namespace {

bool are_alike(const plot::Frame& a, const plot::Frame& b) {
    const auto same = [](const Scale& one, const Scale& other) {
        return one.low == other.low && one.high == other.high && one.from == other.from &&
               one.to == other.to;
    };
    return same(a.x_scale, b.x_scale) && same(a.y_scale, b.y_scale) && a.area.x == b.area.x &&
           a.area.y == b.area.y && a.area.width == b.area.width && a.area.height == b.area.height;
}

// Returns the number of plots compared.
int check_frames(const Shot& shot) {
    DiskPainter disks;
    int plots = 0;
    for (std::size_t k = 0; k < shot.panels->panels().size(); ++k) {
        const auto* panel = dynamic_cast<const PlotPanel*>(shot.panels->panels()[k].panel.get());
        if (panel == nullptr) continue;
        ++plots;
        const plot::Plot axes = panel->plot(nullptr);
        std::vector<plot::Plot> shown;
        for (const FrameData& frame : shot.frames)
            shown.push_back(panel->plot(frame.states[k].get()));
        for (const double width : {9.0, 14.0, 20.0, 30.0, 50.0})
            for (const double height : {8.0, 14.0}) {
                const DrawContext dc{
                    {0, 0, 20.0 * width, 20.0 * height}, 20.0, theme(ThemeKind::light), disks};
                plot::LabelPlacer placer({}), other({});
                const plot::Frame of_axes = plot::frame_of(axes, dc, placer);
                int apart = 0;
                for (const plot::Plot& plot : shown)
                    apart += !are_alike(of_axes, plot::frame_of(plot, dc, other));
                CAPTURE(width);
                CAPTURE(height);
                CHECK(apart == 0);
            }
    }
    return plots;
}

}  // namespace

TEST_CASE("axes and frames of each kind of plot are laid out alike") {
    int plots = 0;
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        Scene scene =
            load_scene((test::checkout() / "docs/panels" / (kind.name + ".yaml")).string(),
                       test::resources(), {.set = {"film.seconds=2", "film.fps=6"}});
        REQUIRE(scene.figures.size() == 1);
        if (kind.name == "sweep") continue;  // not in films
        scene.film.panels = {scene.figures.front().panel};
        scene.film.panels.front().at.reset();
        plots += check_frames(Shot(scene));
    }
    CHECK(plots >= 24);
}

TEST_CASE("axes and frames of plots whose notes change are laid out alike") {
    const std::string one_line =
        "[{kind: mean-squared-displacement, origins: all, lags: 5, fit_from: 3}, "
        "{kind: mean-squared-displacement, origins: all, of: b, lags: 5}, {kind: free-time, walls: "
        "true}]";
    const std::string several_lines =
        "[{kind: mean-squared-displacement, origins: all, of: [a, b], lags: 5}, {kind: "
        "velocity-autocorrelation, of: [a, b], lags: 5}, {kind: free-path, of: [a, b]}]";
    const std::string others = "[{kind: speed-histogram, fit: true}, energy-by-species, pressure]";
    for (const std::string box :
         {"walls: periodic", "walls: solid", "walls: {left: periodic, right: periodic}"})
        for (const std::string& panels : {one_line, several_lines, others}) {
            CAPTURE(box);
            CAPTURE(panels);
            const Shot shot(test::scene_from(fmt::format(
                "title: T\nbox: {{size: [20, 16], {}}}\n"
                "gas: [{{name: a, count: 40, radius: 0.4, temperature: 1}}, {{name: b, count: 3, "
                "radius: 1, mass: 8, temperature: 1}}]\n"
                "run: {{until: 60}}\nfilm: {{seconds: 5, fps: 4, panels: {}}}\n",
                box, panels)));
            CHECK(check_frames(shot) == 3);
        }
}
