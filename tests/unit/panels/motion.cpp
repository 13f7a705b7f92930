// What moves in a film moves calmly: numbers can be read, and bars do not break and heal from frame
// to frame. Of the frames of whole films, as tables, plots and words.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "panels/plots/histogram_panel.h"
#include "scene/load.h"
#include "support/library.h"
#include "support/resources.h"
#include "support/shot.h"
#include "support/test_root.h"

using namespace carom;
using namespace carom::test;

namespace {

Scene scene_of(const std::string& name, const std::vector<std::string>& changes = {}) {
    return load_scene(checkout() / "scenes" / (name + ".yaml"), resources(), changes);
}

std::vector<std::string> words_of(FramePainter& painter, const FrameData& frame) {
    const TextLog log;
    painter.paint(frame);
    std::vector<std::string> words;
    for (const DrawnLine& line : log.lines) words.push_back(line.markup);
    return words;
}

struct Bar {
    bool is_taller = false;
    double height = 0.0;  // of the axis
};

// The panel that the scene lists last.
std::size_t last_panel(const Shot& film) { return film.panels->panels().size() - 1; }

const HistogramPanel& histogram_of(const Shot& film) {
    return dynamic_cast<const HistogramPanel&>(*film.panels->panels()[last_panel(film)].panel);
}

// Each bar of the last panel in each frame.
std::vector<std::vector<Bar>> bars_of(const Shot& film) {
    const HistogramPanel& panel = histogram_of(film);
    const std::size_t index = last_panel(film);
    std::vector<std::vector<Bar>> frames;
    for (const FrameData& frame : film.frames) {
        std::vector<Bar>& now = frames.emplace_back();
        const plot::Plot plot = panel.plot(frame.states[index].get());
        for (const plot::AnyLayer& layer : plot.layers)
            if (const auto* bars = std::get_if<plot::Bars>(&layer))
                for (std::size_t i = 0; i < bars->taller.size(); ++i)
                    now.push_back({!bars->taller[i].empty(), bars->value[i] / plot.y.high});
    }
    return frames;
}

}  // namespace

TEST_CASE("numbers in words stay the same for a fifth of a second") {
    // Nothing but numbers changes here: no caption comes, the pace stays.
    for (const auto& changed :
         {std::pair{"one-hot-particle", "run={until: 12}"},  // all broken bars stay so
          {"entropy-reversed", "run={until: 80, events: [{at: 40, reverse: velocities}]}"}}) {
        const std::string name = changed.first, run = changed.second;
        CAPTURE(name);
        const Shot film(scene_of(name, {run, "film.slow=[]"}), 260);
        FramePainter painter(*film.panels);
        painter.paint(film.frames[199]);  // with what is the same in every frame
        int changes = 0;
        std::vector<std::string> before = words_of(painter, film.frames[199]);
        for (std::size_t i = 200; i < 260; ++i) {
            const std::vector<std::string> now = words_of(painter, film.frames[i]);
            changes += now != before;
            before = now;
        }
        CHECK(changes >= 5);
        CHECK(changes <= 10);  // two seconds of film
    }
}

TEST_CASE("a still tells the numbers of its own frame") {
    const Scene scene = scene_of("one-hot-particle");
    StartedScene started = start_scene(scene);
    PanelSet panels(scene, started.simulation.particles(), started.simulation.sample());
    const Recording run = panels.record(started.simulation, timeline(scene),
                                        [](const Tick&, const Sample&, const AdvanceResult&) {});
    panels.fix_axes();
    FrameData held, still;
    run.play(203, [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
        if (tick.frame == 202) held = panels.frame_data(tick, sample, advanced);
        const bool is_still = tick.frame == 202;
        still = panels.frame_data(tick, sample, advanced, is_still);
    });
    FramePainter painter(panels);
    CHECK(words_of(painter, held) != words_of(painter, still));
}

TEST_CASE("a bar that breaks stays so for a second while it is near, and breaks seldom") {
    for (const char* name : {"one-hot-particle", "maxwell-boltzmann", "fifty-in-a-unit-box"}) {
        CAPTURE(name);
        const Shot film(scene_of(name, {"film.panels=[speed-histogram]"}));
        const auto frames = bars_of(film);
        const auto moving = static_cast<std::size_t>(1.5 * film.scene.film.fps);
        for (std::size_t bar = 0; bar < frames.front().size(); ++bar) {
            CAPTURE(bar);
            int breaks = 0;
            std::size_t since = 0;
            for (std::size_t i = 1; i < frames.size(); ++i) {
                const Bar& now = frames[i][bar];
                if (now.is_taller) CHECK(now.height > 0.9);
                if (now.is_taller == frames[i - 1][bar].is_taller) continue;
                if (now.is_taller) {
                    CHECK(now.height > 1.0);
                    ++breaks;
                    since = i;
                }
                if (!now.is_taller && now.height > 0.9 && i > moving)
                    CHECK(i - since >= std::size_t(film.scene.film.fps));
            }
            CHECK(breaks <= 1);
        }
        // Once the gas has settled no bar is broken.
        CHECK(std::ranges::count(frames[frames.size() / 2 + 60], true, &Bar::is_taller) == 0);
    }
}

TEST_CASE("a bar breaks again only where the axis cannot hold it") {
    // A wave runs to and fro, which the axis of the whole film does not hold.
    const Shot film(
        load_scene(library_file("hot-and-cold-mix"), resources(),
                   {"seed=14", "box.size=[72, 36]", "partitions.0.x=36", "gas.0.count=150",
                    "gas.1.count=150", "run.until=640", "film.panels.1.bins=18"}));
    const auto frames = bars_of(film);
    int breaks = 0;
    for (std::size_t bar = 0; bar < frames.front().size(); ++bar)
        for (std::size_t i = 1; i < frames.size(); ++i) {
            if (!frames[i][bar].is_taller || frames[i - 1][bar].is_taller) continue;
            CHECK(frames[i][bar].height > 1.0);
            ++breaks;
        }
    CHECK(breaks > 0);
}

TEST_CASE("a number has the same decimals and the same room in the whole film") {
    Scene scene =
        scene_of("entropy-reversed",
                 {"film.panels=[{kind: velocity-histogram, component: x, mean_now: true}]"});
    const Shot film(std::move(scene), 300);
    FramePainter painter(*film.panels);
    const HistogramPanel& panel = histogram_of(film);
    std::set<std::size_t> lengths;
    for (std::size_t i = 0; i < film.frames.size(); i += 10) {
        const plot::Plot plot = panel.plot(film.frames[i].states[last_panel(film)].get());
        REQUIRE(plot.bar_notes);
        for (const plot::BarNotes::Name& name : plot.bar_notes->names)
            if (name.name.starts_with("mean now")) {
                int letters = 0;  // a minus sign and a figure space take three bytes each
                for (const char byte : name.number)
                    letters += (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
                lengths.insert(static_cast<std::size_t>(letters));
            }
    }
    CHECK(lengths.size() == 1);
}
