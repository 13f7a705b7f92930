// The pressure on walls or partitions as round gauges. It is a mean over a time window before the
// present, since the impulses of single particles would make the needle unreadable.
#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/dials/round_dial.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/instruments/surface_pressure.h"
#include "panels/plot/layers.h"
#include "panels/plot/window.h"
#include "panels/registry.h"

namespace carom {
namespace {

// A needle rests until the mean covers this part of its window; before, it would jump.
constexpr double least_share = 0.25;

class GaugePanel : public DialPanel {
  public:
    using DialPanel::DialPanel;

  protected:
    Width width() const override { return {0.0, 2.0 / gauge_shape.depth}; }
    void draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                   const MeterLine&) const override {
        RoundDial(dc, face, gauge_shape).draw_face(canvas, written_scale(), context().language());
    }
    void draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                    const Reading& reading) const override {
        const double value = std::isnan(reading.value) ? 0.0 : reading.value;
        const Color color = plot::color_of(reading.line.role, dc.theme);
        const RoundDial dial(dc, face, gauge_shape);
        if (const auto band = error_band(reading)) dial.draw_band(canvas, *band, color);
        dial.draw_needle(canvas, scale().share(value), color);
    }
};

// If no surfaces are named: all sides that are not periodic, as one.
SurfaceNumbers gauged_surfaces(const Box& box, const SurfaceNumbers& named) {
    if (!named.empty()) return named;
    SurfaceNumbers sides;
    for (std::int32_t side = 0; side < 2 * box.dimension; ++side)
        if (!box.is_periodic(side / 2)) sides.push_back(side);
    return sides;
}

}  // namespace

std::unique_ptr<Panel> make_pressure_gauge(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const Box& box = context.box();
    const Over over = spec.over.value_or(usual_window(context.run()));
    const SurfaceNumbers& named = spec.options.as<PressureOptions>().surfaces;
    const SurfaceNumbers surfaces = gauged_surfaces(box, named);
    const bool is_one = named.empty();
    DialSubject subject{
        {.title = say(language, "Pressure"), .quantity = quantities::pressure(box.dimension)}};
    subject.note = words_of_window(context.wording(), over, Phrase{"mean since the last sample"});
    subject.part = "gauge";
    subject.enough = 11.0;
    subject.read = [meter = SurfacePressures(box, surfaces, over), is_one,
                    least = over.window * least_share](const FrameInput& o) mutable {
        std::vector<double> now = meter(o);
        if (is_one) now = {meter.of_all()};
        if (o.tick.time < least) std::ranges::fill(now, std::numeric_limits<double>::quiet_NaN());
        return now;
    };
    if (is_one) {
        subject.lines = {{"all walls", say(language, "all walls")}};
    } else {
        const std::vector<std::string> columns = box.surfaces.names();
        for (std::size_t k = 0; k < surfaces.size(); ++k)
            subject.lines.push_back({columns[static_cast<std::size_t>(surfaces[k])],
                                     short_name(language, box, surfaces[k]),
                                     surface_role(k, surfaces.size())});
    }
    return std::make_unique<GaugePanel>(context, spec, std::move(subject));
}

}  // namespace carom
