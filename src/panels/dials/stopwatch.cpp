// A stopwatch that runs from the start, from a given time, or from an event of the run: a hand, and
// the time in digits. After a reversal it runs backwards, as the clock does, and rests at 0 before
// its start.
#include <algorithm>
#include <cmath>

#include "panels/dials/round_dial.h"
#include "panels/plot/layers.h"
#include "panels/registry.h"
#include "scene/describe.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/panel_kind.h"
#include "scene/time/timeline.h"
#include "util/text.h"

namespace carom {
namespace {

struct StopwatchOptions {
    WatchStart since = {};
};

std::vector<Binding<StopwatchOptions>> stopwatch_keys() {
    return {bind_key("since", &StopwatchOptions::since, watch_start_notation(),
                     "When it starts: a time, or the first event of this name: `reversal`, `heat`, "
                     "or the wall or partition that the event acts on.")
                .default_text("start")};
}

class StopwatchPanel : public DialPanel {
  public:
    using DialPanel::DialPanel;
    bool shows_time() const override { return false; }

  protected:
    Width width() const override { return {0.0, 2.0 / watch_shape.depth}; }
    void draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                   const MeterLine&) const override {
        RoundDial(dc, face, watch_shape).draw_face(canvas, written_scale(), context().language());
    }
    void draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                    const Reading& reading) const override {
        RoundDial(dc, face, watch_shape)
            .draw_needle(canvas, scale().share(reading.value),
                         plot::color_of(reading.line.role, dc.theme));
    }
};

// The time since the start of the watch, decreasing after a reversal.
double time_on_watch(const Run& run, const WatchStart& since, double now) {
    Run from = run;
    std::erase_if(from.events, [&](const RunEvent& event) { return event.at <= since.at; });
    if (now <= since.at) return 0.0;
    return std::max(0.0, folded_time(from, now) - since.at);
}

std::string words_of_start(const PanelContext& context, const WatchStart& since) {
    const Language language = context.language();
    if (since.at == 0.0 && !since.event) return say(language, "since the start");
    const std::string when = say(language, "since time {}", plain_number(language, since.at));
    if (!since.event) return when;
    const RunEvent& event = context.run().events.at(*since.event);
    const std::string what =
        reverses(event) ? say(language, "velocities reversed")
                        : words_of_surface_event(context.wording(), event, context.gas_in_scene());
    return what.empty() ? when : say(language, "{}: {}", when, what);
}

DialSubject stopwatch(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const WatchStart& since = spec.options.as<StopwatchOptions>().since;
    DialSubject subject{{.title = say(language, "Stopwatch"),
                         .quantity = quantities::time,
                         .lines = {{"stopwatch"}}}};
    subject.note = words_of_start(context, since);
    subject.part = "stopwatch";
    subject.enough = 11.0;
    subject.read = [run = context.run(), since](const FrameInput& o) {
        return std::vector{time_on_watch(run, since, o.tick.time)};
    };
    return subject;
}

}  // namespace

PanelKind stopwatch_kind() {
    using enum Ability;
    return dial_kind<StopwatchPanel, stopwatch>(
        {.name = "stopwatch",
         .words = Phrase{"stopwatch"},
         .shows = "The time since the start, since a time, or since an event.",
         .abilities = {comparison},
         .keys = option_keys(stopwatch_keys()),
         .has_plot = false});
}

}  // namespace carom
