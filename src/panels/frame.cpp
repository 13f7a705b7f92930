#include "panels/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "draw/formula/words.h"
#include "panels/callouts/fade.h"
#include "panels/callouts/scrim.h"
#include "panels/gas/marks/ghosts.h"
#include "panels/layout.h"
#include "panels/words/monitors_panel.h"
#include "scene/scene.h"

namespace carom {

Color page_color(const Film& film) { return theme_of(film).page; }

namespace {

// What is left of a line, from its left end, before something that stands in it, too.
Rect before(Rect line, const Rect& other, double unit) {
    constexpr double gap = 1.2;  // units
    const bool is_in_line = other.width > 0.0 && other.y < line.bottom() &&
                            line.y < other.bottom() && other.x < line.right() && other.x > line.x;
    if (is_in_line) line.width = other.x - gap * unit - line.x;
    return line;
}

}  // namespace

FramePainter::FramePainter(const PanelSet& panels)
    : scene_(panels.scene()),
      panels_(panels),
      theme_(theme_of(scene_.film)),
      grid_(scene_.film),
      unit_(grid_.unit()),
      captions_(caption_schedule(scene_)),
      subtitle_(subtitle_showing(scene_)),
      callouts_(panels),
      ground_(blank(scene_.film)),
      canvas_(blank(scene_.film)) {}

Canvas FramePainter::blank(const Film& film) {
    return Canvas({film.size.width, film.size.height},
                  film.transparent ? Backdrop::transparent : Backdrop::black);
}

// Of each panel. Those over the box give way to an end card, which shows the boxes alone.
std::vector<double> FramePainter::opacities(const Tick& tick, bool still) const {
    const double cover = tick.phase == Phase::title_card ? 0.0 : card_cover(scene_.film, tick);
    std::vector<double> all;
    for (const PanelSet::Placed& placed : panels_.panels()) {
        double one = placed.opacity(scene_.film, tick);
        if (placed.is_over_box()) one *= 1.0 - cover;
        if (tick.phase == Phase::end_card && !placed.is_box()) one = 0.0;
        all.push_back(still && one > 0.0 ? 1.0 : one);
    }
    return all;
}

// Panels that come or go are not in it, nor is a title that is still on its card.
void FramePainter::prepare_ground(const std::vector<double>& opacities, bool has_title) {
    std::vector<bool> whole{has_title};
    for (const double one : opacities) whole.push_back(one == 1.0);
    if (whole == grounded_) return;
    const bool is_first = grounded_.empty();
    grounded_ = whole;
    if (!is_first) {
        ground_ = blank(scene_.film);
        canvas_ = blank(scene_.film);
    }
    draw_ground(ground_, opacities, has_title);
}

void FramePainter::draw_ground(Canvas& canvas, const std::vector<double>& opacities,
                               bool has_title) {
    if (!scene_.film.transparent) canvas.fill_all(theme_.page);
    const Panel::Key key = this->key();
    panels_.gas().draw_key(canvas, key);
    draw_title(canvas, end_of_title(key), has_title);
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        const PanelSet::Placed& placed = panels_.panels()[i];
        if (opacities[i] == 1.0 && !placed.is_over_box())
            placed.panel->draw_ground(canvas, context_at(placed.slot));
    }
}

// Before a key in the same line.
double FramePainter::end_of_title(const Panel::Key& key) const {
    const Rect title = before_numbers(grid_.place(scene_.film.layout.title));
    return before(title, key.is_row ? panels_.gas().place_of_key(key) : key.at.area, unit_).right();
}

// Upright beside the box, or in a line.
Panel::Key FramePainter::key() {
    const auto& panels = panels_.panels();
    Panel::Key key{context_at(scene_.film.layout.color_bar), context_at(panels.front().slot),
                   is_one_line(scene_.film.layout.color_bar)};
    key.has_ramp = std::ranges::none_of(
        panels, [](const PanelSet::Placed& placed) { return placed.panel->explains_colors(); });
    if (key.is_row) {
        key.at.area = before_numbers(key.at.area);
        return key;
    }
    const std::vector<Rect> boxes = panels_.boxes(grid_);
    const Rect &first = boxes.front(), &last = boxes.back();
    // Not across the lines of words under boxes that stand one above the other.
    const bool is_stacked = last.y > first.y;
    Rect& area = key.at.area;
    const double left = is_stacked ? area.x : last.right() + 0.8 * unit_;
    area = {left, first.y, std::max(area.width, area.right() - left),
            std::min(last.bottom(), area.bottom()) - first.y};
    return key;
}

DrawContext FramePainter::context_at(const Slot& slot) {
    return {grid_.place(slot), unit_, theme_, disks_};
}

// Where there is no place for captions, which has it at the start.
bool FramePainter::has_subtitle_in_title() const {
    return !scene_.subtitle.empty() && !scene_.film.layout.caption;
}

const Canvas& FramePainter::paint(const FrameData& frame) {
    const std::vector<double> seen = opacities(frame.tick, false);
    prepare_ground(seen, frame.tick.phase != Phase::title_card);
    canvas_.restore(ground_);
    draw_changing(canvas_, frame, seen, false);
    return canvas_;
}

void FramePainter::paint_on(Canvas& canvas, const FrameData& frame) {
    const std::vector<double> seen = opacities(frame.tick, true);
    draw_ground(canvas, seen, frame.tick.phase != Phase::title_card);
    draw_changing(canvas, frame, seen, true);
}

std::vector<std::string> FramePainter::cut_words() {
    Canvas scratch({1, 1});  // words are set, not drawn
    std::vector<std::string> cut;
    const auto add = [&](const std::string& what, const auto& draw) {
        const TextLog log;
        draw();
        if (std::ranges::any_of(log.lines, &DrawnLine::is_cut)) cut.push_back(what);
    };
    add("the title or the subtitle", [&] {
        draw_title(scratch, before_numbers(grid_.place(scene_.film.layout.title)).right(), true);
    });
    if (subtitle_)
        add(fmt::format("the subtitle “{}”", scene_.subtitle),
            [&] { draw_caption(scratch, words_of_text(scene_.subtitle), 1.0); });
    for (const CaptionSpan& caption : captions_)
        if (!caption.words.empty())
            add(fmt::format("the caption “{}”", caption.words),
                [&] { draw_caption(scratch, caption.words, 1.0); });
    if (scene_.film.title_card > 0.0)
        add("the title card", [&] { draw_card(scratch, {.phase = Phase::title_card}, 1.0); });
    if (!scene_.film.end_card.empty())
        add("the end card", [&] {
            draw_card(scratch, {frame_count(scene_.film), 0.0, Phase::end_card}, 1.0);
        });
    const std::vector<Rect> boxes = panels_.boxes(grid_);
    for (const Mark& mark : scene_.marks)
        add(fmt::format("the mark “{}”", mark.words), [&] {
            draw_ghost_words(scratch, context_at(scene_.film.layout.gas), {}, boxes.front().width,
                             {mark.words, 0, {}}, 1.0);
        });
    const std::vector<std::string> labels = scene_.film.runs.labels();
    for (std::size_t run = 0; labels.size() > 1 && run < labels.size(); ++run) {
        const PanelSet::Placed& line = panels_.line_of_run(run);
        add(fmt::format("the label “{}”", labels[run]),
            [&] { line.panel->draw_ground(scratch, context_at(line.slot)); });
    }
    const std::vector<PanelSpec>& specs = scene_.film.panels;
    const std::size_t first = panels_.panels().size() - specs.size();
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const PanelSet::Placed& placed = panels_.panels()[first + i];
        const DrawContext dc = context_at(placed.slot);
        const double width = dc.area.width / dc.unit, height = dc.area.height / dc.unit;
        const auto [least_width, least_height] = placed.panel->least_room();
        if (width < least_width || height < least_height)
            cut.push_back(
                fmt::format("the panel `{}` (its place is {:.4g} by {:.4g} units, it "
                            "needs {:g} by {:g})",
                            specs[i].kind, width, height, least_width, least_height));
        if (specs[i].title)
            add(fmt::format("the title “{}” of a panel", *specs[i].title),
                [&] { draw_panel_title(scratch, dc, escape_markup(*specs[i].title)); });
    }
    for (const PanelSet::Placed& placed : panels_.panels())
        for (std::string& what : placed.panel->left_out(context_at(placed.slot)))
            cut.push_back(std::move(what));
    for (const std::string& kind : scene_.film.panels_left_out)
        cut.push_back(fmt::format("the panel `{}` (template {} has places for {})", kind,
                                  scene_.film.template_name, specs.size()));
    return cut;
}

// Draws a panel that is fading in or out; in the place of the gas, its bars grow meanwhile. On
// raster canvases only, since stills show panels at full opacity.
void FramePainter::draw_fading(Canvas& canvas, const PanelSet::Placed& placed,
                               const PanelState& state, double opacity) {
    DrawContext dc = context_at(placed.slot);
    const double around = 2.0 * unit_;
    Fade fade(canvas, {dc.area.x - around, dc.area.y - around, dc.area.width + 2.0 * around,
                       dc.area.height + 2.0 * around});
    if (placed.stand != PanelSet::Placed::Stand::own_place) dc.growth = smooth(opacity);
    draw_whole(canvas, placed, dc, state);
    fade.leave(opacity);
}

// A panel that is not in the ground.
void FramePainter::draw_whole(Canvas& canvas, const PanelSet::Placed& placed, const DrawContext& dc,
                              const PanelState& state) {
    if (placed.is_over_box()) {
        constexpr double dimmed = 0.82, feather = 0.8;  // share; units
        const double out = plate_margin * unit_;
        draw_scrim(canvas,
                   {dc.area.x - out, dc.area.y - out, dc.area.width + 2.0 * out,
                    dc.area.height + 2.0 * out},
                   feather * unit_, with_alpha(theme_.page, dimmed));
    }
    placed.panel->draw_ground(canvas, dc);
    placed.panel->draw(canvas, dc, state);
}

void FramePainter::draw_changing(Canvas& canvas, const FrameData& frame,
                                 const std::vector<double>& opacities, bool still) {
    for (std::size_t i = 0; i < frame.states.size(); ++i) {
        const PanelSet::Placed& placed = panels_.panels()[i];
        if (opacities[i] == 1.0 && placed.is_over_box())
            draw_whole(canvas, placed, context_at(placed.slot), *frame.states[i]);
        else if (opacities[i] == 1.0)
            placed.panel->draw(canvas, context_at(placed.slot), *frame.states[i]);
        else if (opacities[i] > 0.0)
            draw_fading(canvas, placed, *frame.states[i], opacities[i]);
    }
    callouts_.draw(canvas, frame, opacities, still);
    if (frame.tick.phase == Phase::reversing) draw_announcement(canvas, frame.tick);
    draw_slowness(canvas, frame.tick);
    if (frame.tick.phase != Phase::end_card) draw_captions(canvas, frame.tick, still);
    const bool has_card =
        still ? is_card(frame.tick.phase) : card_cover(scene_.film, frame.tick) > 0.0;
    if (has_card) draw_card(canvas, frame.tick, card_cover(scene_.film, frame.tick));
}

void FramePainter::draw_card(Canvas& canvas, const Tick& tick, double cover) {
    const Cards cards(scene_.film, scene_.subtitle, theme_, unit_);
    if (tick.phase == Phase::title_card) {
        std::optional<PlacedWords> subtitle;
        if (subtitle_) subtitle = caption_place(words_of_text(scene_.subtitle));
        return cards.draw_title(canvas, title_place(end_of_title(key())), subtitle, tick);
    }
    const std::vector<Rect> boxes = panels_.boxes(grid_);
    const Rect &first = boxes.front(), &last = boxes.back();
    const double x = std::min(first.x, last.x), y = std::min(first.y, last.y);
    cards.draw_end(canvas,
                   {x, y, std::max(first.right(), last.right()) - x,
                    std::max(first.bottom(), last.bottom()) - y},
                   cover);
}

// Draws the factor of slow motion in a corner of the gas, if no clock shows it.
void FramePainter::draw_slowness(Canvas& canvas, const Tick& tick) const {
    if (tick.slow.share <= 0.0) return;
    if (std::ranges::any_of(panels_.panels(), [](const PanelSet::Placed& placed) {
            return placed.panel->shows_time();
        }))
        return;
    const Rect box = panels_.boxes(grid_).back();
    const std::string words = localised(scene_.film.language, slow_words(tick.slow));
    TextStyle style{.size = 1.5 * unit_,
                    .weight = 600,
                    .color = with_alpha(theme_.highlight, tick.slow.share),
                    .align = Align::right,
                    .fonts = theme_.fonts};
    const double width = measure_text(words, style).width + 1.2 * unit_;
    canvas.fill({box.right() - width, box.y, width, 2.3 * unit_},
                with_alpha(theme_.ground, plate_alpha * tick.slow.share));
    draw_text(canvas, {box.right() - 0.6 * unit_, box.y + 1.7 * unit_}, words, style);
}

// What numbers and the clock leave of a line in which they stand, too.
Rect FramePainter::before_numbers(Rect line) const {
    for (const PanelSet::Placed& placed : panels_.panels()) {
        if (dynamic_cast<const MonitorsPanel*>(placed.panel.get()) == nullptr) continue;
        line = before(line, placed.panel->frame_in(grid_.place(placed.slot), unit_), unit_);
    }
    return line;
}

void FramePainter::draw_announcement(Canvas& canvas, const Tick& tick) const {
    const double alpha = std::clamp(5.0 * std::min(tick.progress, 1.0 - tick.progress), 0.0, 1.0);
    const std::string words = say(scene_.film.language, "velocities reversed");
    const std::vector<Rect> boxes = panels_.boxes(grid_);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const std::vector<double> times = reversal_times(panels_.run_in(i));
        if (std::ranges::find(times, tick.time) == times.end()) continue;
        const Rect& box = boxes[i];
        TextStyle style{.size = 2.2 * unit_,
                        .weight = 600,
                        .color = with_alpha(theme_.ink, alpha),
                        .align = Align::center,
                        .fonts = theme_.fonts};
        const double padding = 3.0 * unit_;
        const bool is_covered =
            std::ranges::any_of(panels_.panels(), &PanelSet::Placed::is_over_box);
        const double middle = box.y + (is_covered ? 0.25 : 0.5) * box.height;
        style.size *= std::min(1.0, box.width / (measure_text(words, style).width + padding));
        const double width = measure_text(words, style).width + padding;
        const Rect plate{box.x + 0.5 * (box.width - width), middle - 2.0 * unit_, width,
                         4.0 * unit_};
        canvas.fill(plate, with_alpha(theme_.page, 0.82 * alpha));
        draw_text(canvas, {box.x + 0.5 * box.width, plate.y + 2.75 * unit_}, words, style);
    }
}

}  // namespace carom
