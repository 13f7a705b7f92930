// The pressure on a moving wall against the area or volume that the walls enclose, as a path; with
// the isotherm and the adiabat of the gas through its start, or with the isotherms at the
// temperatures at which heat baths keep it in turn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/axis.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/instruments/surface_pressure.h"
#include "panels/meters/history.h"
#include "panels/plot/plot_panel.h"
#include "panels/plot/window.h"
#include "panels/registry.h"
#include "panels/surfaces/place_options.h"
#include "physics/mechanics.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/panel_kind.h"
#include "stats/histogram.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr std::size_t longest_path = 5000;  // points: drawing must not grow with the film

const plot::Stroke of_isotherm{.role = {.of = plot::Role::Of::accent}};
const plot::Stroke of_adiabat{.role = {.of = plot::Role::Of::accent}, .dashes = {0.5, 0.3}};

struct TheoryCurve {
    bool is_adiabat = false;
    std::optional<double> temperature = {};  // of one isotherm among several
    std::vector<double> pressure = {};
    void archive(Archive& archive) { archive(is_adiabat, temperature, pressure); }
    bool operator==(const TheoryCurve&) const = default;
};

// At areas from an eighth of that of the start to eight times that: the curves of hard disks or
// rods; those of an ideal gas where theory knows none of these.
struct Compression {
    std::vector<double> area = {};
    std::vector<TheoryCurve> curves = {};  // empty: none is known
    double start = 0.0;                    // pressure there
    bool is_ideal = false;
    void archive(Archive& archive) { archive(area, curves, start, is_ideal); }
    bool operator==(const Compression&) const = default;
};

Compression compression_of(const PanelContext& context, std::int32_t surface) {
    constexpr int steps = 150;  // in either direction
    const Box& box = context.box();
    if (!box.surfaces.is_side(surface)) return {};
    const int axis = box.surfaces.axis_of(surface);
    const double across = box.content_across(axis);
    Compression found;
    Asked asked{.surface = surface};
    for (int i = -steps; i <= steps; ++i)
        asked.lengths.push_back(box.length(axis) * std::pow(8.0, double(i) / steps));
    if (!law(context.gas, LawOf::adiabat, asked)) asked.as_points = found.is_ideal = true;
    const Law isotherm = law(context.gas, LawOf::isotherm, asked);
    const Law adiabat = law(context.gas, LawOf::adiabat, asked);
    if (!isotherm || !adiabat) return {};
    for (const double length : asked.lengths) found.area.push_back(length * across);
    found.start = isotherm.curve[steps];
    const bool are_several = isotherm.temperatures.size() > 1;
    const double at_start = adiabat.temperatures[steps];
    for (const double temperature : isotherm.temperatures) {
        TheoryCurve& curve = found.curves.emplace_back();
        if (are_several) curve.temperature = temperature;
        for (const double pressure : isotherm.curve)
            curve.pressure.push_back(pressure * temperature / at_start);
    }
    if (found.curves.empty()) found.curves.push_back({.pressure = isotherm.curve});
    if (!are_several) found.curves.push_back({.is_adiabat = true, .pressure = adiabat.curve});
    return found;
}

// The path of a run, and what theory knows of it.
struct PressureVolumeRun : History {
    static constexpr std::size_t area = 0, pressure = 1;  // lines
    Compression theory = {};
    void archive(Archive& archive) {
        History::archive(archive);
        archive(theory);
    }
};

using PressureVolumeRecord = RunsRecord<PressureVolumeRun>;

plot::Polyline curve(const plot::Plot& plot, std::string name, const plot::Stroke& stroke,
                     const std::vector<double>& area, const std::vector<double>& pressure) {
    std::vector<double> across, up;
    for (std::size_t i = 0; i < area.size(); ++i) {
        if (area[i] < plot.x.low || area[i] > plot.x.high) continue;
        if (!std::isfinite(pressure[i])) continue;
        across.push_back(area[i]);
        up.push_back(pressure[i]);
    }
    plot::Polyline line;
    line.part = "theory";
    line.of = std::move(name);
    line.still = true;
    line.depth = 2;
    line.x = plot::column(plot.columns[0], std::move(across));
    line.y = plot::column(plot.columns[1], std::move(up));
    line.stroke = stroke;
    return line;
}

struct PressureVolumeOptions {
    SurfaceNumbers surfaces = {};
    std::vector<double> levels = {};  // lines, in units of the pressure at the start
};

std::vector<Binding<PressureVolumeOptions>> pressure_volume_keys() {
    return {bind_within(&PressureVolumeOptions::surfaces, surfaces_key()),
            bind_key("levels", &PressureVolumeOptions::levels,
                     list_of(number(positive), 1, most_chosen, "a list of numbers"),
                     "Multiples of the pressure *p* of the start, by theory, at which lines are "
                     "drawn: [1, 2] for *p* and 2 *p*.")
                .default_text("none")};
}

void check_pressure_volume(PanelSpec& panel, const Node& node, Reading& reading) {
    SurfaceNumbers& surfaces = panel.options.change<PressureVolumeOptions>().surfaces;
    keep_suitable(
        panel, surfaces,
        {[&](std::int32_t surface) {
             return reading.box().surfaces.is_side(surface) && may_move(reading, surface);
         },
         "a wall of the box that moves", "give a side in `box.walls` a `velocity` or a `mass`"},
        node, reading);
    require_one(panel, surfaces, node, reading);
}

class PressureVolumePanel : public FramesPanel<PressureVolumeRecord> {
  public:
    PressureVolumePanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context),
          spec_(spec),
          meter_(context.box(), {options().surfaces.front()}, over()) {}

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    plot::Plot plot(const PanelState* state) const override;
    std::optional<std::array<double, 2>> time_shown(double at) const override {
        return {{at, at}};  // the curve is of all times until then
    }

  private:
    const Box& box() const { return context_.box(); }
    const PressureVolumeOptions& options() const {
        return spec_.options.as<PressureVolumeOptions>();
    }
    Over over() const { return spec_.over.value_or(usual_window(context_.run())); }

    // Only over a whole window: soon after the start, single hits would give vertical strokes.
    bool is_measured(double time) const {
        return over().since != Over::Since::window || time >= (1.0 - 1e-9) * over().window;
    }
    void make_axes() override;
    void add_curves(const Compression& theory);
    plot::Polyline path_of(std::size_t run, std::size_t shown) const;
    plot::Polyline whole_path(std::size_t run) const;

    PanelContext context_;
    PanelSpec spec_;
    SurfacePressures meter_;
    plot::Plot whole_;
};

void PressureVolumePanel::survey(const FrameInput& input) {
    PressureVolumeRun& run = record_.runs.front();
    const double area = enclosed_content(box(), input.advanced.surfaces);
    if (run.x.empty()) run.theory = compression_of(context_, options().surfaces.front());
    double pressure = meter_(input).front();
    if (!is_measured(input.tick.time)) pressure = std::numeric_limits<double>::quiet_NaN();
    run.add(input.tick.time, {area, pressure}, input.is_sample, input.is_frame);
}

void PressureVolumePanel::make_axes() {
    const Language language = context_.language();
    const auto dimension = static_cast<std::size_t>(box().dimension);
    const Phrase content =
        std::array{Phrase{"length"}, Phrase{"area"}, Phrase{"volume"}}.at(dimension - 1);
    constexpr std::array titles{Phrase{"Pressure and length"}, Phrase{"Pressure and area"},
                                Phrase{"Pressure and volume"}};
    whole_ = {};
    whole_.language = language;
    const plot::Text title =
        spec_.title ? escape_markup(*spec_.title) : say(language, titles.at(dimension - 1));
    whole_.titles = {plot::text_of(language, Phrase{"{}: {}"},
                                   {title, words_of_moments(context_.wording(), spec_, over())}),
                     title};
    whole_.x =
        plot::axis_of(language, quantities::content(box().dimension).named(content), INFINITY, 0.0);
    std::vector<double> pressures;
    for (const PressureVolumeRun& run : record_.runs) {
        whole_.x.low = std::min(whole_.x.low, 0.95 * *std::ranges::min_element(run.y[run.area]));
        whole_.x.high = std::max(whole_.x.high, 1.05 * *std::ranges::max_element(run.y[run.area]));
        for (const double pressure : run.y[run.pressure])
            if (std::isfinite(pressure)) pressures.push_back(std::abs(pressure));
    }
    const double most = pressures.empty() ? 0.0 : 1.1 * quantile(pressures, 0.995);
    whole_.y = plot::axis_of(language, quantities::pressure(box().dimension), 0.0,
                             round_up_for_axis(most));
    whole_.columns = {*whole_.x.quantity, *whole_.y.quantity};
    if (record_.compares()) plot::name_runs(whole_, record_.names());
    for (std::size_t run = 0; run < record_.runs.size(); ++run)
        whole_.layers.emplace_back(whole_path(run));
    const Compression& theory = record_.runs.front().theory;
    const bool have_one_law = std::ranges::all_of(
        record_.runs, [&](const PressureVolumeRun& run) { return run.theory == theory; });
    if (spec_.theory && have_one_law && !theory.curves.empty()) add_curves(theory);
}

void PressureVolumePanel::add_curves(const Compression& theory) {
    const Language language = context_.language();
    for (const double times : options().levels) {
        plot::Level level;
        level.part = "level";
        level.still = true;
        level.depth = 3;
        level.column = whole_.columns[1];
        level.x_column = whole_.columns[0];
        level.value = times * theory.start;
        level.stroke.role = {.of = plot::Role::Of::accent};
        level.label = plot::Label{};
        level.label->still = true;
        level.label->role = level.stroke.role;
        const std::string p = "<i>p</i>";
        level.label->words = {plot::Text(
            times == 1.0 ? p : localised(language, fmt::format("{:g}", times)) + "\u2009" + p)};
        for (const double share : {0.5, 0.7, 0.3, 0.9, 0.03})
            level.label->anchors.push_back(
                {.at = {whole_.x.low + share * (whole_.x.high - whole_.x.low), level.value},
                 .offset = {0.0, -0.8},
                 .is_inside = true});
        whole_.layers.emplace_back(std::move(level));
        whole_.y.high = std::max(whole_.y.high, round_up_for_axis(1.05 * times * theory.start));
    }
    const Phrase gas = theory.is_ideal ? Phrase{"ideal gas"} : name_of_hard(box().dimension);
    plot::Note key{.entries = {{{}, {say(language, gas)}}},
                   .wraps = true,
                   .of_last_titles = whole_.titles.size()};
    for (const TheoryCurve& one : theory.curves) {
        const plot::Stroke& stroke = one.is_adiabat ? of_adiabat : of_isotherm;
        const plot::Text words =
            one.temperature
                ? fmt::format("<i>T</i> = {}", plain_number(language, *one.temperature))
                : say(language, one.is_adiabat ? Phrase{"adiabat"} : Phrase{"isotherm"});
        std::string name = one.is_adiabat ? "adiabat" : "isotherm";
        if (one.temperature) name += fmt::format(" {}", *one.temperature);
        whole_.layers.emplace_back(
            curve(whole_, std::move(name), stroke, theory.area, one.pressure));
        key.entries.push_back({stroke, {words}});
        plot::name_last_line(whole_, words);
    }
    whole_.notes.push_back(std::move(key));
    // Theory of another gas is named as such; that of this gas needs no name.
    whole_.at_lines = plot::NamedAtLines{.titles = whole_.titles};
    if (theory.is_ideal) whole_.notes.push_back({.entries = {{{}, {say(language, gas)}}}});
}

// All of it, of which nothing is shown: words keep off it in all frames.
plot::Polyline PressureVolumePanel::whole_path(std::size_t run) const {
    const PressureVolumeRun& its = record_.runs[run];
    plot::Polyline line;
    line.shown = {0, 0};
    line.x = plot::column(whole_.columns[0], its.y[its.area]);
    line.y = plot::column(whole_.columns[1], its.y[its.pressure]);
    return line;
}

// The samples up to a frame, and the frame itself.
plot::Polyline PressureVolumePanel::path_of(std::size_t run, std::size_t shown) const {
    const Measured its = record_.runs[run].until(shown);
    plot::Polyline line;
    line.part = "path";
    line.depth = 1;
    line.shown.end = its.x.size();
    line.shown.first = line.shown.end - std::min(line.shown.end, longest_path);
    line.x = plot::column(whole_.columns[0], its.y[PressureVolumeRun::area]);
    line.y = plot::column(whole_.columns[1], its.y[PressureVolumeRun::pressure]);
    line.is_thinned = false;
    line.stroke = {
        .role = {.of = plot::Role::Of::bar}, .width = 0.1, .shade = plot::Shade::legible};
    if (record_.compares()) {
        line.run = run;
        line.stroke = plot::stroke_of_run(run, 0.12);
    }
    line.head = plot::Dot{
        .role = line.stroke.role, .radius = 0.35, .is_hollow_if_pale = true, .halo = 0.12};
    return line;
}

plot::Plot PressureVolumePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const auto& shown = dynamic_cast<const ShownState&>(*state);
    for (std::size_t run = 0; run < record_.runs.size(); ++run) {
        now.layers.emplace_back(path_of(run, shown.shown.at(run)));
        if (!record_.compares()) continue;
        now.accounts_of_runs.push_back(account_of_last(
            context_.wording(), *whole_.y.quantity,
            record_.runs[run].frames.y[PressureVolumeRun::pressure], shown.shown.at(run)));
    }
    return now;
}

std::unique_ptr<Panel> make_pressure_volume(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<PressureVolumePanel>(context, spec);
}

}  // namespace

PanelKind pressure_volume_kind() {
    using enum Ability;
    return {.name = "pressure-volume",
            .words = Phrase{"pressure and volume"},
            .shows =
                "The pressure on a moving wall against the area, in space the volume, as a path; "
                "if the gas fills it and there is no gravity, with the isotherm and the adiabat of "
                "hard disks, spheres or rods from the same start, or with an isotherm at each "
                "temperature to which heat baths change together; where the radii of disks differ "
                "or they are very few, with those of an ideal gas.",
            .make = make_pressure_volume,
            .abilities = {over, theory, comparison},
            .keys = option_keys(pressure_volume_keys()),
            .rule = check_pressure_volume,
            .laws = always(std::vector{LawOf::isotherm}),
            .measured_at = measured_at(&PressureVolumeOptions::surfaces)};
}

}  // namespace carom
