// The temperature as the column of a thermometer: of all particles, of chosen ones, or of those
// that are in given regions. All columns have the same scale.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "panels/chosen.h"
#include "panels/dials/dial_panel.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/means/trailing.h"
#include "panels/plot/layers.h"
#include "panels/plot/window.h"
#include "panels/registry.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/keys/check.h"
#include "scene/panel_kind.h"
#include "stats/paths/thermal_times.h"

namespace carom {
namespace {

struct ThermometerOptions {
    std::vector<NamedRegion> regions = {};  ///< instead of choices of particles
};

std::vector<Binding<ThermometerOptions>> thermometer_keys() {
    return {bind_within(&ThermometerOptions::regions, regions_key())};
}

void check_thermometer(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.options.as<ThermometerOptions>().regions.empty() && is_written(node, "of"))
        refuse_together(reading.errors, *find(node, "of"), {"of", "regions"});
}

// Units.
struct ThermometerSize {
    static constexpr double tube = 0.5, bulb = 0.85, tick_gap = 0.3, tick = 0.45, line_width = 0.09;
    static constexpr double width = 5.8, numbers = 4.1;  // in total; left of the glass
    static constexpr double error_gap = 0.5, error_half_end = 0.2, error_width = 0.14;
    static constexpr double least_height = 5.5;  // with two ticks
};

class ThermometerPanel : public DialPanel {
  public:
    using DialPanel::DialPanel;

  protected:
    Width width() const override { return {ThermometerSize::width, 0.0}; }
    double least_face() const override { return ThermometerSize::least_height; }
    void draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                   const MeterLine& line) const override;
    void draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                    const Reading& reading) const override;

  private:
    // The glass, and where the scale's ends are.
    struct Glass {
        double x, top, bottom, tube, bulb;
        Point middle;  // of the bulb
        Scale scale;
        double level(double share) const { return scale.from + share * (scale.to - scale.from); }
    };
    Glass glass(const DrawContext& dc, const Rect& face) const;
    static void draw_error(Canvas& canvas, const DrawContext& dc, const Glass& glass,
                           const std::array<double, 2>& band, Color color);
};

ThermometerPanel::Glass ThermometerPanel::glass(const DrawContext& dc, const Rect& face) const {
    const double u = dc.unit, size = std::clamp(face.height / (9.0 * u), 1.0, 1.7) * u;
    Glass glass{};
    glass.tube = ThermometerSize::tube * size;
    glass.bulb = ThermometerSize::bulb * size;
    glass.x = face.x + ThermometerSize::numbers / ThermometerSize::width * face.width;
    glass.top = face.y + 0.4 * u;
    glass.middle = {glass.x, face.bottom() - glass.bulb - 0.05 * u};
    glass.bottom = glass.middle.y - glass.bulb;
    const auto [low, high] = written_scale();
    glass.scale = {low, high, glass.bottom - 0.15 * u, glass.top + glass.tube};
    return glass;
}

// The outline of a tube with a round end on a bulb.
std::vector<Point> glass_outline(Point middle, double radius, double half, double top) {
    constexpr int steps = 60;
    const double neck = std::asin(std::min(1.0, half / radius));
    std::vector<Point> points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = neck + (2.0 * std::numbers::pi - 2.0 * neck) * i / steps;
        points.push_back(
            {middle.x + radius * std::sin(angle), middle.y - radius * std::cos(angle)});
    }
    for (int i = 0; i <= steps; ++i) {
        const double angle = std::numbers::pi * i / steps;
        points.push_back({middle.x - half * std::cos(angle), top + half - half * std::sin(angle)});
    }
    return points;
}

void ThermometerPanel::draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                                 const MeterLine&) const {
    const double u = dc.unit;
    const Glass glass = this->glass(dc, face);
    std::vector<Point> rim = glass_outline(glass.middle, glass.bulb, glass.tube, glass.top);
    canvas.fill_polygon(rim, dc.theme.ground);
    rim.push_back(rim.front());
    canvas.stroke_path(rim, ThermometerSize::line_width * u, dc.theme.muted);
    TextStyle style = label_style(dc);
    style.align = Align::right;
    const double height = std::abs(glass.scale.to - glass.scale.from);
    const int most = std::clamp(static_cast<int>(height / (1.3 * u)) + 1, 2, 7);
    const double right = glass.x - glass.tube - ThermometerSize::tick_gap * u;
    for (const TickMark& mark : ticks(glass.scale.low, glass.scale.high, most)) {
        const double y = glass.scale(mark.value);
        canvas.stroke_line({right - ThermometerSize::tick * u, y}, {right, y},
                           ThermometerSize::line_width * u, dc.theme.muted);
        draw_text(canvas, {right - (ThermometerSize::tick + 0.25) * u, y + 0.36 * u},
                  localised(context().language(), mark.label), style);
    }
}

void ThermometerPanel::draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                                  const Reading& reading) const {
    const double u = dc.unit;
    const Glass glass = this->glass(dc, face);
    const Color color = edge_of(plot::color_of(reading.line.role, dc.theme), dc.theme);
    const double inner = 0.16 * u;
    canvas.fill_circle(glass.middle, glass.bulb - inner, color);
    if (std::isnan(reading.value)) return;
    const double level = glass.level(scale().share(reading.value));
    canvas.fill(
        {glass.x - glass.tube + inner, level, 2.0 * (glass.tube - inner), glass.middle.y - level},
        color);
    if (const auto band = error_band(reading)) draw_error(canvas, dc, glass, *band, color);
}

// A bar with ends, right of the glass.
void ThermometerPanel::draw_error(Canvas& canvas, const DrawContext& dc, const Glass& glass,
                                  const std::array<double, 2>& band, Color color) {
    const double u = dc.unit, width = ThermometerSize::error_width * u;
    const double x = glass.x + glass.tube + ThermometerSize::error_gap * u;
    const double half = ThermometerSize::error_half_end * u;
    for (const double share : band) {
        const double y = glass.level(share);
        canvas.stroke_line({x - half, y}, {x + half, y}, width, color);
    }
    canvas.stroke_line({x, glass.level(band[0])}, {x, glass.level(band[1])}, width, color);
}

// The mean over the panel's time window; the present value while no time has passed.
class TemperatureMeter {
  public:
    /// `chosen`: of each part.
    TemperatureMeter(const PanelContext& context, std::vector<ThermalPart> parts,
                     std::vector<Chosen> chosen, Over over)
        : members_(context, std::move(chosen)),
          times_(context.box(), context.particles, std::move(parts),
                 velocity_changes(context.run())),
          accounts_(over),
          is_of_moment_(over.since == Over::Since::now) {
        choose();
    }

    std::vector<double> operator()(const FrameInput& o) {
        accounts_.add({o.tick.time, times_.see(o.sample, o.advanced.collisions)}, o.is_sample);
        if (members_.see(o.sample)) choose();
        const Account &from = accounts_.from(), &to = accounts_.to();
        if (is_of_moment_ || !(to.time > from.time))
            return temperatures({}, times_.moment(o.sample));
        return temperatures(from.of_each, to.of_each);
    }

  private:
    struct Account {
        double time;
        std::vector<ThermalIntegrals> of_each;
    };
    static std::vector<double> temperatures(const std::vector<ThermalIntegrals>& from,
                                            const std::vector<ThermalIntegrals>& to) {
        std::vector<double> all;
        for (std::size_t k = 0; k < to.size(); ++k) {
            const ThermalIntegrals before = from.empty() ? ThermalIntegrals{} : from[k];
            const double freedom = to[k].half_freedom - before.half_freedom;
            all.push_back(freedom > 0.0 ? (to[k].energy - before.energy) / freedom
                                        : std::numeric_limits<double>::quiet_NaN());
        }
        return all;
    }

    void choose() {
        for (std::size_t k = 0; k < members_.lists().size(); ++k)
            times_.choose(k, members_.lists()[k]);
    }

    Members members_;
    ThermalTimes times_;
    Trailing<Account> accounts_;
    bool is_of_moment_;
};

DialSubject thermometer(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const Over over = spec.over.value_or(usual_window(context.run()));
    DialSubject subject{{.title = say(language, "Temperature"),
                         .quantity = quantities::temperature,
                         .needs_collisions = true}};
    subject.note = words_of_moments(context.wording(), spec, over);
    subject.part = "thermometer";
    std::vector<ThermalPart> parts;
    const std::vector<NamedRegion>& regions = spec.options.as<ThermometerOptions>().regions;
    for (const NamedRegion& one : regions) {
        subject.lines.push_back({one.name, one.name, surface_role(parts.size(), regions.size())});
        parts.push_back({.region = one.region});
    }
    const std::vector<Chosen> chosen =
        regions.empty() ? choices(spec) : std::vector<Chosen>(regions.size());
    if (regions.empty())
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            subject.lines.push_back({column_name_of(context.scene, chosen[k]),
                                     spec.of.empty() ? "" : name_of(context.scene, chosen[k]),
                                     role_among(context, chosen, k)});
            parts.push_back({});
        }
    subject.read = TemperatureMeter(context, std::move(parts), chosen, over);
    return subject;
}

}  // namespace

PanelKind thermometer_kind() {
    using enum Ability;
    return dial_kind<ThermometerPanel, thermometer>(
        {.name = "thermometer",
         .words = Phrase{"thermometer"},
         .shows = "The temperature of all particles, of those that `of` names, or of those in "
                  "`regions` of the box, as thermometers with a common scale.",
         .abilities = {of, over, means, comparison},
         .keys = option_keys(thermometer_keys()),
         .rule = check_thermometer,
         .measured_at = measured_at(&ThermometerOptions::regions),
         .work = always(PanelWork{.flights = PanelWork::Flights::recorded}),
         .has_plot = false});
}

}  // namespace carom
