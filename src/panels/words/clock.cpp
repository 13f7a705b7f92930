// The time of a film in one line that ends at the right: "t = 12.0". Slow motion stands before it;
// in runs that are reversed an arrow shows the direction of time.
#include <algorithm>

#include "panels/registry.h"
#include "panels/words/monitors_panel.h"
#include "scene/film.h"
#include "scene/words.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double clock_size = 4.0 / 3.0;  // units
constexpr double before_clock = 0.8;      // units, to what stands before it
constexpr double arrow_of_clock = 0.42;   // units, from its middle to its ends
constexpr int bold = 600;                 // of slow motion

class ClockPanel : public MonitorsPanel {
  public:
    explicit ClockPanel(const PanelContext& context) : MonitorsPanel(context, {Monitor::time}) {}

    void draw_ground(Canvas&, const DrawContext&) const override {}
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Rect frame_in(const Rect& area, double unit) const override;

  private:
    double widest_slowness(TextStyle style) const;
    std::string words(double time) const { return "t = " + text(Monitor::time, time); }
    TextStyle style_in(double unit, Color color) const {
        TextStyle style = style_of_numbers(clock_size * unit, 400);
        style.color = color;
        style.align = Align::right;
        return style;
    }
};

// Of the factors of slow motion, and of pauses; 0 if there are none.
double ClockPanel::widest_slowness(TextStyle style) const {
    style.weight = bold;
    const Film& film = context_.film();
    double widest = 0.0;
    const auto see = [&](double factor) {
        const std::string words = localised(context_.language(), slow_words({factor, 1.0}));
        widest = std::max(widest, measure_text(words, style).width);
    };
    for (const SlowSpan& span : film.slow) see(span.factor);
    if (!film.pauses.empty()) see(0.0);
    return widest;
}

Rect ClockPanel::frame_in(const Rect& area, double unit) const {
    const TextStyle style = style_in(unit, {});
    double width = measure_text(words(widest_value(Monitor::time)), style).width;
    if (const double slowness = widest_slowness(style); slowness > 0.0)
        width += slowness + before_clock * unit;
    if (turns()) width += (before_clock + 2.0 * arrow_of_clock) * unit;
    return {area.right() - width, area.y, width, area.height};
}

void ClockPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const MonitorsState&>(state);
    const double baseline = dc.area.y + 0.5 * dc.area.height + 0.36 * clock_size * dc.unit;
    TextStyle style = style_in(dc.unit, dc.theme.ink);
    const std::string time = words(now.readouts.at(index_of(Monitor::time)));
    draw_text(canvas, {dc.area.right(), baseline}, time, style);
    // At fixed places, however long the time is now.
    double x = dc.area.right() - measure_text(words(widest_value(Monitor::time)), style).width -
               before_clock * dc.unit;
    if (turns()) {
        const double half = arrow_of_clock * dc.unit;
        draw_time_arrow(canvas, {x - half, baseline - 0.36 * clock_size * dc.unit}, half, now.arrow,
                        dc.theme.highlight);
        x -= 2.0 * half + before_clock * dc.unit;
    }
    if (now.slow.share <= 0.0) return;
    style.weight = bold;
    style.color = with_alpha(dc.theme.highlight, now.slow.share);
    draw_text(canvas, {x, baseline}, localised(context_.language(), slow_words(now.slow)), style);
}

}  // namespace

std::unique_ptr<Panel> make_clock(const PanelContext& context) {
    return std::make_unique<ClockPanel>(context);
}

}  // namespace carom
