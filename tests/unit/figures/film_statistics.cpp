// What the panels of a film measure does not depend on its frames, and is what figures measure.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "panels/correlations/curve_panel.h"
#include "panels/dials/dial_panel.h"
#include "panels/plot/plot_panel.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "runs/run.h"
#include "support/figure_run.h"
#include "support/measured_gases.h"
#include "support/scene_text.h"
#include "support/shot.h"
#include "util/text.h"

using namespace carom;
using namespace carom::test;

namespace {

struct FilmCase {
    std::string gas, run;
    std::vector<std::string> panels;
};

const std::string parted =
    "box: {size: [20, 15]}\npartitions: [{name: wall, x: 10, gaps: [[5, 10]]}]\n"
    "gas: [{count: 30, radius: 0.3, temperature: 1, position: {side: left, of: wall}}]\n";
const std::string under_piston =
    "box: {size: [12, 18], walls: {top: {mass: 20, force: -2}}}\n"
    "gas: [{count: 16, radius: 0.15, temperature: 1}]\n";

const std::vector<FilmCase> film_cases{
    {two_masses,
     "",
     {"{kind: speed-histogram}",
      "{kind: speed-histogram, over: start}",
      "{kind: speed-histogram, over: start, bins: 12, range: [0, 4]}",
      "{kind: energy-histogram, over: {window: 3}, of: [light, heavy]}",
      "{kind: velocity-histogram, over: start, fit: true, bins: 14, range: [-4, 4]}",
      "{kind: position-histogram, over: start}",
      "{kind: temperature, of: [heavy]}",
      "{kind: pressure}",
      "{kind: pressure, over: {window: 2}}",
      "{kind: pressure, over: now}",
      "{kind: pressure, gauge: true}",
      "{kind: pressure, surfaces: [left, top], over: {window: 2}}",
      "{kind: thermometer, over: {window: 2}}",
      "{kind: entropy, space: both}",
      "{kind: energy-by-species}",
      "{kind: speed-classes}",
      "{kind: energy-by-species, over: {window: 3}}",
      "{kind: profile, around: [9, 7], cells: 5, over: {window: 3}}",
      "{kind: free-path}",
      "{kind: free-time, over: {window: 4}}",
      "{kind: pair-correlation}",
      "{kind: pair-correlation, over: {window: 3}}",
      "{kind: velocity-autocorrelation}",
      "{kind: mean-squared-displacement}",
      "{kind: mean-squared-displacement, origins: all}",
      "{kind: profile, over: {window: 3}}",
      "{kind: profile, quantity: temperature, over: start}",
      "{kind: orientational-order}",
      "{kind: flux, line: {x: 10}, over: {window: 3}}",
      "{kind: counter, line: {x: 10}}",
      "{kind: particle-speed, of: [0, heavy], over: {window: 2}}",
      "{kind: mean-free-path, of: [light, heavy]}",
      "{kind: halves, component: y}"}},
    {parted,
     ", events: [{at: 4.3, open: wall}]",
     {"{kind: sides}", "{kind: sides, measure: temperature}", "{kind: counter}", "{kind: pressure}",
      "{kind: pressure, over: now}", "{kind: flux, over: {window: 2}}"}},
    {under_piston,
     "",
     {"{kind: piston}", "{kind: piston-histogram}", "{kind: energy-account}",
      "{kind: pressure-volume, over: {window: 2}}", "{kind: pressure, surfaces: [top]}",
      "{kind: pressure, surfaces: [top], over: now}"}},
    {falling_disks,
     "",
     {"{kind: velocity-histogram, over: start, component: y}",
      "{kind: position-histogram, over: {window: 4}, component: y, bins: 10, range: [0, 15]}",
      "{kind: profile, component: y}", "{kind: energy-account}", "{kind: temperature}"}},
    {rods_and_points,
     "",
     {"{kind: velocity-histogram, over: start, fit: true}", "{kind: pressure, over: {window: 2}}",
      "{kind: pair-correlation}"}}};

// Kinds that measure nothing over time: what they draw is a present, a path or words; and one that
// needs a second run.
const std::set<std::string> shows_the_present{
    "phase", "positions", "monitors", "single-collision", "contact-time",    "collision-map",
    "text",  "sweep",     "gas",      "stopwatch",        "return-distance", "run-distance"};

std::string film_scene(const FilmCase& of, const std::string& panel, int fps, bool is_figure) {
    std::string text = fmt::format(
        "title: T\nrun: {{until: 9{}}}\nfilm: {{template: data, size: [640, 360], seconds: 4, "
        "fps: {}, panels: [{}]}}\n",
        of.run, fps, is_figure ? "" : panel);
    text += of.gas;
    if (is_figure) text += "figures: [" + panel.substr(0, panel.size() - 1) + ", name: f}]\n";
    return text;
}

struct Numbers {
    std::string words;
    std::vector<double> all;
};

Numbers numbers_in(const Table& table) {
    Numbers found;
    const std::string text = csv(table);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(",\n", at), text.size());
        const std::string one = text.substr(at, end - at);
        char* behind = nullptr;
        const double value = std::strtod(one.c_str(), &behind);
        if (!one.empty() && behind == one.c_str() + one.size())
            found.all.push_back(value);
        else
            found.words += one + "\n";
        at = end + 1;
    }
    return found;
}

Numbers axes_of(const Panel& panel) {
    const auto* plotted = dynamic_cast<const PlotPanel*>(&panel);
    if (plotted == nullptr) return {};
    const plot::Plot plot = plotted->plot(nullptr);
    return {"", {plot.x.low, plot.x.high, plot.y.low, plot.y.high}};
}

struct EndOfFilm {
    Numbers shown, axes;
};

EndOfFilm end_of_film(const FilmCase& of, const std::string& panel, int fps) {
    const test::Shot film(test::scene_from(film_scene(of, panel, fps, false)));
    const Panel& last = *film.panels->panels().back().panel;
    const std::shared_ptr<const PanelState>& state = film.frames.back().states.back();
    return {numbers_in(last.table(*state, theme(ThemeKind::print))), axes_of(last)};
}

Numbers in_figure(const FilmCase& of, const std::string& panel) {
    const FigureRun run = test::run_of(test::scene_from(film_scene(of, panel, 30, true)));
    const Figure& figure = run.figures().front();
    return numbers_in(figure.panel->table(*figure.moments.back().state, theme(ThemeKind::print)));
}

// Sums over flights that are cut at other times differ by rounding.
void check_alike(const Numbers& one, const Numbers& other) {
    constexpr double rounding = 1e-9;
    CHECK(one.words == other.words);
    REQUIRE(one.all.size() == other.all.size());
    double worst = 0.0;
    for (std::size_t k = 0; k < one.all.size(); ++k)
        worst = std::max(worst,
                         std::abs(one.all[k] - other.all[k]) / std::max(1.0, std::abs(one.all[k])));
    CHECK(worst < rounding);
}

// The bars of a mean at one time are chosen from its window alone, those of a film from all of it.
bool has_own_bars(const std::string& panel) {
    return panel.find("-histogram") != std::string::npos &&
           panel.find("piston") == std::string::npos && panel.find("range") == std::string::npos;
}

}  // namespace

TEST_CASE("panels of films measure the same whatever the frames, and the same as figures") {
    for (const FilmCase& of : film_cases)
        for (const std::string& panel : of.panels) {
            CAPTURE(panel);
            const EndOfFilm few = end_of_film(of, panel, 7), many = end_of_film(of, panel, 30);
            check_alike(few.shown, many.shown);
            check_alike(few.axes, many.axes);
            if (!has_own_bars(panel)) check_alike(few.shown, in_figure(of, panel));
        }
}

TEST_CASE("every kind of panel that measures is compared between films of different frames") {
    std::set<std::string> compared = shows_the_present;
    for (const FilmCase& of : film_cases)
        for (const std::string& panel : of.panels)
            compared.insert(panel.substr(7, panel.find_first_of(",}") - 7));
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        CHECK(compared.contains(kind.name));
    }
}

namespace {

const HistoryRecord* history_of(const Panel& panel) {
    if (const auto* series = dynamic_cast<const SeriesPanel*>(&panel)) return &series->record();
    if (const auto* dials = dynamic_cast<const DialPanel*>(&panel)) return &dials->record();
    return nullptr;
}

const std::vector<std::vector<MeanError>>& numbers_of_curves(const PanelState& state) {
    return dynamic_cast<const CurveState&>(state).runs.front().numbers;
}

}  // namespace

TEST_CASE("a run reads the instruments of its scene as figures do, bit for bit") {
    std::set<std::string> read;
    for (const FilmCase& of : film_cases)
        for (const std::string& panel : of.panels) {
            const std::string kind = panel.substr(7, panel.find_first_of(",}") - 7);
            if (kind_of(panel_kinds(), kind)->meter == nullptr) continue;
            CAPTURE(panel);
            read.insert(kind);
            if (panel.find("gauge: true") != std::string::npos) continue;  // of another time
            const RunReport report = run_physics(
                test::scene_from(film_scene(of, panel, 30, true) + "measure: [" + panel + "]\n"));
            const FigureRun run = test::run_of(test::scene_from(film_scene(of, panel, 30, true)));
            const Figure& figure = run.figures().front();
            std::vector<double> shown;
            if (const HistoryRecord* record = history_of(*figure.panel))
                for (const auto& line : record->runs.front().frames.y) shown.push_back(line.back());
            else
                for (const auto& line : numbers_of_curves(*figure.moments.back().state))
                    shown.push_back(line.front().mean);
            REQUIRE(report.readings.size() >= shown.size());
            for (std::size_t k = 0; k < shown.size(); ++k) {
                const double value = report.readings[k].value;
                CHECK((value == shown[k] || std::isnan(value)));
                // Of what does not diffuse the fit is no reading.
                if (kind != "mean-squared-displacement")
                    CHECK(std::isnan(value) == std::isnan(shown[k]));
            }
        }
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        if (kind.meter != nullptr && !shows_the_present.contains(kind.name))
            CHECK(read.contains(kind.name));
    }
}

namespace {

const Figure& figure_named(const FigureRun& run, const std::string& name) {
    for (const Figure& figure : run.figures())
        if (figure.spec->name == name) return figure;
    throw std::out_of_range(name);
}

double mean_shown(const FigureRun& run, const std::string& name) {
    return HistogramPanel::histograms(*figure_named(run, name).moments.back().state).front().mean;
}

double temperature_shown(const FigureRun& run, const std::string& name) {
    const Figure& figure = figure_named(run, name);
    return dynamic_cast<const DialPanel&>(*figure.panel)
        .readings(*figure.moments.back().state)
        .front()
        .value;
}

}  // namespace

TEST_CASE("the report of a run has the numbers that figures show, whatever its samples") {
    for (const std::string& gas : {two_masses, falling_disks})
        for (const char* clock : {"", ", sample_every: 3"}) {
            CAPTURE(gas);
            const bool has_two = gas == two_masses;
            const std::string second = has_two ? "heavy" : "light";
            const Scene scene = test::scene_from(
                fmt::format("title: T\nrun: {{until: 9{}}}\n", clock) + gas +
                "figures:\n"
                "  - {name: speed, kind: speed-histogram, of: [light], over: start}\n"
                "  - {name: energy, kind: energy-histogram, of: [" +
                second +
                "], over: start}\n"
                "  - {name: heat, kind: thermometer, over: start}\n"
                "  - {name: push, kind: pressure, over: start}\n");
            const FigureRun figures = test::run_of(scene);
            const RunSummary& report = run_physics(scene).summary;
            CHECK(*report.species.front().speed ==
                  doctest::Approx(mean_shown(figures, "speed")).epsilon(1e-10));
            CHECK(*report.species.back().energy ==
                  doctest::Approx(mean_shown(figures, "energy")).epsilon(1e-10));
            CHECK(*report.temperature ==
                  doctest::Approx(temperature_shown(figures, "heat")).epsilon(1e-10));
            if (!has_two) continue;
            const auto& push =
                dynamic_cast<const SeriesPanel&>(*figure_named(figures, "push").panel);
            CHECK(*report.wall_pressure ==
                  doctest::Approx(push.record().runs.front().y[0].back()).epsilon(1e-12));
        }
}
