#include "scene/time/captions.h"

#include <algorithm>
#include <cmath>

#include "scene/scene.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

constexpr double line_height = 2.6;  // grid units, where the template does not say

double bottom(const Slot& slot) { return slot.y + slot.height; }

bool meet(const Slot& a, const Slot& b) {
    const bool across = a.x < b.x + b.width && b.x < a.x + a.width;
    return across && a.y < bottom(b) && b.y < bottom(a);
}

Slot around(const std::vector<Slot>& slots) {
    Slot all = slots.front();
    for (const Slot& slot : slots) {
        const double right = std::max(all.x + all.width, slot.x + slot.width);
        const double low = std::max(bottom(all), bottom(slot));
        all.x = std::min(all.x, slot.x);
        all.y = std::min(all.y, slot.y);
        all.width = right - all.x;
        all.height = low - all.y;
    }
    return all;
}

// Makes room for the line: a place that begins above the line then ends at its top, any other
// begins below it. Several places keep their shares of their common height.
void make_room(std::vector<Slot*> slots, const Slot& line) {
    std::vector<Slot> places;
    for (const Slot* slot : slots) places.push_back(*slot);
    if (std::ranges::none_of(places, [&](const Slot& slot) { return meet(slot, line); })) return;
    const Slot all = around(places);
    const double top = all.y < line.y ? all.y : bottom(line);
    const double end = all.y < line.y ? line.y : bottom(all);
    const double scale = (end - top) / all.height;
    for (Slot* slot : slots) {
        slot->y = top + (slot->y - all.y) * scale;
        slot->height *= scale;
    }
}

}  // namespace

LayoutSpec with_caption_line(LayoutSpec layout) {
    if (!layout.caption) {
        const double height = std::min(line_height, 0.25 * layout.gas.height);
        layout.caption = {layout.gas.x, bottom(layout.gas) - height, layout.gas.width, height};
    }
    const Slot& line = *layout.caption;
    const Slot gas = layout.gas;
    make_room({&layout.title}, line);
    make_room({&layout.gas}, line);
    make_room({&layout.color_bar}, line);
    if (layout.clock) make_room({&*layout.clock}, line);
    if (layout.monitors && !is_one_line(*layout.monitors)) make_room({&*layout.monitors}, line);
    std::vector<Slot*> panels;
    for (Slot& slot : layout.panels)
        if (!is_within(slot, gas)) panels.push_back(&slot);
    if (!panels.empty()) make_room(panels, line);
    return layout;
}

namespace {

// At the place of captions, before the first of them: those that begin with the run wait, others
// end it. None if either would be too short to be read.
std::optional<Showing> showing_of_subtitle(const Scene& scene, const std::vector<Tick>& ticks,
                                           const std::vector<CaptionSpan>& captions) {
    if (scene.subtitle.empty() || !scene.film.layout.caption) return {};
    Showing shown = showing(ticks, scene.film, {}, subtitle_seconds);
    const double least = least_caption_seconds * scene.film.fps;
    const CaptionSpan* waiting = nullptr;
    for (const CaptionSpan& caption : captions) {
        if (caption.first <= shown.first)
            waiting = &caption;
        else
            shown.last = std::min(shown.last, caption.first - 1);
    }
    if (shown.last - shown.first + 1 < least) return {};
    if (waiting && !waiting->words.empty() && waiting->last - shown.last < least) return {};
    return shown;
}

std::vector<CaptionSpan> spans_of_captions(const Scene& scene, const std::vector<Tick>& ticks) {
    const double fps = scene.film.fps;
    std::vector<CaptionSpan> spans;
    for (std::size_t i = 0; i < scene.captions.size(); ++i) {
        const Caption& caption = scene.captions[i];
        TimeSpan time{caption.at, {}};
        if (i + 1 < scene.captions.size()) time.until = scene.captions[i + 1].at;
        const Showing shown = showing(ticks, scene.film, time, caption.seconds);
        spans.push_back({shown, caption.words, shown.first / fps, (shown.last + 1) / fps});
    }
    return spans;
}

}  // namespace

std::vector<CaptionSpan> caption_schedule(const Scene& scene) {
    if (scene.captions.empty()) return {};
    const std::vector<Tick> ticks = timeline(scene);
    std::vector<CaptionSpan> spans = spans_of_captions(scene, ticks);
    if (const auto subtitle = showing_of_subtitle(scene, ticks, spans))
        for (CaptionSpan& span : spans) {
            span.first = std::max(span.first, subtitle->last + 1);
            span.start = span.first / double(scene.film.fps);
        }
    return spans;
}

std::optional<Showing> subtitle_showing(const Scene& scene) {
    const std::vector<Tick> ticks = timeline(scene);
    return showing_of_subtitle(scene, ticks, spans_of_captions(scene, ticks));
}

}  // namespace carom
