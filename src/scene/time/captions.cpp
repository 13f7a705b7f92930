#include "scene/time/captions.h"

#include <algorithm>
#include <cmath>

#include "scene/time/timeline.h"

namespace carom {
namespace {

constexpr double fade_seconds = 0.2;
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

// What begins above the line ends there, anything else begins under it. Several places keep the
// shares that they have of their common height.
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
    make_room({&layout.title}, line);
    make_room({&layout.gas}, line);
    make_room({&layout.color_bar}, line);
    if (layout.monitors) make_room({&*layout.monitors}, line);
    std::vector<Slot*> panels;
    for (Slot& slot : layout.panels) panels.push_back(&slot);
    if (!panels.empty()) make_room(panels, line);
    return layout;
}

std::vector<CaptionSpan> caption_schedule(const Scene& scene) {
    if (scene.captions.empty()) return {};
    const std::vector<Tick> ticks = timeline(scene);
    const double fps = scene.film.fps;
    std::vector<CaptionSpan> spans;
    for (const Caption& caption : scene.captions) {
        const auto begin = std::ranges::find_if(ticks, [&](const Tick& tick) {
            return tick.time >= caption.at && tick.phase != Phase::title_card;
        });
        const int first = static_cast<int>(begin - ticks.begin());
        if (!spans.empty()) spans.back().last = std::min(spans.back().last, first - 1);
        int last = static_cast<int>(ticks.size()) - 1 - card_frames(scene.film).end;
        if (caption.seconds)
            last =
                std::min(last, first - 1 + static_cast<int>(std::lround(*caption.seconds * fps)));
        spans.push_back({caption.words, first, last, 0.0, 0.0});
    }
    for (CaptionSpan& span : spans) {
        span.start = span.first / fps;
        span.end = (span.last + 1) / fps;
    }
    return spans;
}

double caption_opacity(const CaptionSpan& span, const Film& film, int frame) {
    if (frame < span.first || frame > span.last) return 0.0;
    const auto fade = [&](int frames) {
        return std::min(1.0, (frames + 0.5) / film.fps / fade_seconds);
    };
    const CardFrames cards = card_frames(film);
    const bool at_start = span.first == cards.title;
    const bool at_end = span.last + 1 == frame_count(film) - cards.end;
    const double coming = at_start ? 1.0 : fade(frame - span.first);
    const double going = at_end ? 1.0 : fade(span.last - frame);
    return std::min(coming, going);
}

}  // namespace carom
