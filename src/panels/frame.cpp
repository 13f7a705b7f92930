#include "panels/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "draw/formula/words.h"
#include "panels/callouts/fade.h"
#include "panels/gas/marks/ghosts.h"
#include "panels/layout.h"

namespace carom {

Color page_color(const Film& film) { return theme_of(film.theme).page; }

namespace {

constexpr double title_line = 1.2;      // of the size of its letters
constexpr double subtitle_line = 1.35;  // units

}  // namespace

FramePainter::FramePainter(const PanelSet& panels)
    : scene_(panels.scene()),
      panels_(panels),
      theme_(theme_of(scene_.film.theme)),
      grid_(scene_.film.layout, scene_.film.size),
      unit_(grid_.unit()),
      captions_(caption_schedule(scene_)),
      callouts_(panels),
      ground_(blank(scene_.film)),
      canvas_(blank(scene_.film)) {}

Canvas FramePainter::blank(const Film& film) {
    return Canvas({film.size.width, film.size.height},
                  film.transparent ? Backdrop::transparent : Backdrop::black);
}

// Of each panel.
std::vector<double> FramePainter::opacities(const Tick& tick, bool still) const {
    std::vector<double> all;
    for (const PanelSet::Placed& placed : panels_.panels()) {
        const double one = placed.opacity(scene_.film, tick);
        all.push_back(still && one > 0.0 ? 1.0 : one);
    }
    return all;
}

// Those that come or go are not in it.
void FramePainter::prepare_ground(const std::vector<double>& opacities) {
    std::vector<bool> whole;
    for (const double one : opacities) whole.push_back(one == 1.0);
    if (whole == grounded_) return;
    const bool is_first = grounded_.empty();
    grounded_ = whole;
    if (!is_first) {
        ground_ = blank(scene_.film);
        canvas_ = blank(scene_.film);
    }
    draw_ground(ground_, opacities);
}

void FramePainter::draw_ground(Canvas& canvas, const std::vector<double>& opacities) {
    if (!scene_.film.transparent) canvas.fill_all(theme_.page);
    draw_title(canvas);
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        const PanelSet::Placed& placed = panels_.panels()[i];
        if (opacities[i] == 1.0) placed.panel->draw_ground(canvas, context_at(placed.slot));
    }
    const DrawContext key = context_at(scene_.film.layout.color_bar);
    const std::vector<Rect> boxes = panels_.boxes(grid_);
    const Rect &first = boxes.front(), &last = boxes.back();
    // Not across the lines of words under boxes that stand one above the other.
    const bool is_stacked = last.y > first.y;
    const double left = is_stacked ? key.area.x : last.right() + 0.8 * unit_;
    const Rect beside{left, first.y, std::max(key.area.width, key.area.right() - left),
                      std::min(last.bottom(), key.area.bottom()) - first.y};
    panels_.gas().draw_key(canvas, {beside, unit_, theme_, disks_},
                           context_at(panels_.panels().front().slot));
}

DrawContext FramePainter::context_at(const Slot& slot) {
    return {grid_.place(slot), unit_, theme_, disks_};
}

// The title is set in one line, smaller if necessary; if that does not suffice, in two lines as
// large as the place allows.
FramePainter::SetTitle FramePainter::set_title(const Rect& area) const {
    constexpr double largest = 1.5, smallest_in_one = 1.2, smallest = 1.0;  // units
    TextStyle style{.size = largest * unit_,
                    .weight = 600,
                    .color = theme_.ink,
                    .tabular = false,
                    .max_width = area.width};
    const double share =
        area.width / measure_text(escape_markup(scene_.title), {style.size, style.weight}).width;
    if (share >= smallest_in_one / largest) {
        style.size *= std::min(1.0, share);
        style.max_width *= 1.0 + 1e-3;  // letters are set at whole sizes
        return {style, {scene_.title}};
    }
    const double room = area.height - (scene_.subtitle.empty() ? 0.0 : subtitle_line * unit_);
    for (style.size = std::min(style.size, room / (2.0 * title_line));; style.size *= 0.95) {
        const bool is_smallest = style.size <= smallest * unit_;
        if (is_smallest) style.size = smallest * unit_;
        std::vector<std::string> lines = wrapped(scene_.title, style, 2);
        const double width =
            measure_text(escape_markup(lines.back()), {style.size, style.weight}).width;
        if (is_smallest || width <= area.width) return {style, std::move(lines)};
    }
}

// Draws title and subtitle; the subtitle gets the lines that the title leaves.
void FramePainter::draw_title(Canvas& canvas) const {
    const Rect area = grid_.place(scene_.film.layout.title);
    const SetTitle title = set_title(area);
    double y = area.y;
    for (const std::string& words : title.lines) {
        draw_text(canvas, {area.x, y + 0.9 * title.style.size}, escape_markup(words), title.style);
        y += title_line * title.style.size;
    }
    const TextStyle style{.size = 1.05 * unit_,
                          .weight = 400,
                          .color = theme_.muted,
                          .tabular = false,
                          .max_width = area.width};
    const double line = subtitle_line * unit_;
    const auto most = static_cast<std::size_t>(std::max(0.0, area.bottom() - y) / line + 1e-6);
    for (const std::string& words :
         wrapped(scene_.subtitle, style, std::max<std::size_t>(1, most))) {
        draw_text(canvas, {area.x, y + style.size}, escape_markup(words), style);
        y += line;
    }
}

const Canvas& FramePainter::paint(const FrameData& frame) {
    const std::vector<double> seen = opacities(frame.tick, false);
    prepare_ground(seen);
    canvas_.restore(ground_);
    draw_changing(canvas_, frame, seen, false);
    return canvas_;
}

void FramePainter::paint_on(Canvas& canvas, const FrameData& frame) {
    const std::vector<double> seen = opacities(frame.tick, true);
    draw_ground(canvas, seen);
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
    add("the title or the subtitle", [&] { draw_title(scratch); });
    for (const CaptionSpan& caption : captions_)
        if (!caption.words.empty())
            add(fmt::format("the caption “{}”", caption.words),
                [&] { draw_caption(scratch, caption.words, 1.0); });
    if (scene_.film.title_card > 0.0)
        add("the title card", [&] { draw_card(scratch, false, 1.0); });
    if (!scene_.film.end_card.empty()) add("the end card", [&] { draw_card(scratch, true, 1.0); });
    const std::vector<Rect> boxes = panels_.boxes(grid_);
    for (const Mark& mark : scene_.marks)
        add(fmt::format("the mark “{}”", mark.words), [&] {
            draw_ghost_words(scratch, context_at(scene_.film.layout.gas), {}, boxes.front().width,
                             {mark.words, 0, {}}, 1.0);
        });
    if (const auto& beside = scene_.film.beside)
        for (std::size_t run = 0; run < boxes.size(); ++run) {
            const PanelSet::Placed& line = panels_.line_of_run(run);
            add(fmt::format("the label “{}”", run == 0 ? beside->own_label : beside->label),
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

// Draws a panel that is fading in or out. On raster canvases only, since stills show panels at full
// opacity.
void FramePainter::draw_fading(Canvas& canvas, const PanelSet::Placed& placed,
                               const PanelState& state, double opacity) {
    const DrawContext dc = context_at(placed.slot);
    const double around = 2.0 * unit_;
    Fade fade(canvas, {dc.area.x - around, dc.area.y - around, dc.area.width + 2.0 * around,
                       dc.area.height + 2.0 * around});
    placed.panel->draw_ground(canvas, dc);
    placed.panel->draw(canvas, dc, state);
    fade.leave(opacity);
}

void FramePainter::draw_changing(Canvas& canvas, const FrameData& frame,
                                 const std::vector<double>& opacities, bool still) {
    for (std::size_t i = 0; i < frame.states.size(); ++i) {
        const PanelSet::Placed& placed = panels_.panels()[i];
        if (opacities[i] == 1.0)
            placed.panel->draw(canvas, context_at(placed.slot), *frame.states[i]);
        else if (opacities[i] > 0.0)
            draw_fading(canvas, placed, *frame.states[i], opacities[i]);
    }
    callouts_.draw(canvas, frame, opacities, still);
    if (frame.tick.phase == Phase::reversing) draw_announcement(canvas, frame.tick);
    draw_slowness(canvas, frame.tick);
    if (!is_card(frame.tick.phase)) draw_captions(canvas, frame.tick, still);
    const bool has_card =
        still ? is_card(frame.tick.phase) : card_cover(scene_.film, frame.tick) > 0.0;
    if (has_card) draw_card(canvas, is_end_card(frame.tick), card_cover(scene_.film, frame.tick));
}

bool FramePainter::is_end_card(const Tick& tick) const {
    return 2 * tick.frame > frame_count(scene_.film) || scene_.film.title_card <= 0.0;
}

// Title and subtitle, or the last words over the title.
void FramePainter::draw_card(Canvas& canvas, bool is_end, double alpha) const {
    const Rect all{0.0, 0.0, double(scene_.film.size.width), double(scene_.film.size.height)};
    canvas.fill(all, with_alpha(theme_.page, alpha));
    const double words_alpha = std::max(0.0, 2.0 * alpha - 1.0);  // not over the gas's own words
    const TextStyle large{.size = (is_end ? 2.6 : 3.4) * unit_,
                          .weight = 600,
                          .color = with_alpha(theme_.ink, words_alpha),
                          .align = Align::center,
                          .tabular = false,
                          .max_width = 0.84 * all.width};
    TextStyle small = large;
    small.size = 1.6 * unit_;
    small.weight = 400;
    small.color = with_alpha(theme_.muted, words_alpha);
    constexpr std::size_t most_lines = 6;
    const auto heading = is_end ? wrapped_words(scene_.film.end_card, large, most_lines)
                                : wrapped(scene_.title, large, most_lines);
    const auto rest = wrapped(is_end ? scene_.title : scene_.subtitle, small, most_lines);
    const auto line = [&](const std::string& words) {
        return is_end ? line_height_of(words, large, 1.3)
                      : LineHeight{large.size, 1.3 * large.size};
    };
    double height = 1.4 * small.size * static_cast<double>(rest.size());
    for (const std::string& words : heading) height += line(words).all;
    Point at{0.5 * all.width, 0.5 * (all.height - height)};
    for (const std::string& words : heading) {
        const auto [above, whole] = line(words);
        if (is_end)
            draw_words(canvas, {at.x, at.y + above}, words, large);
        else
            draw_text(canvas, {at.x, at.y + above}, escape_markup(words), large);
        at.y += whole;
    }
    at.y += 0.9 * small.size + 0.6 * large.size;
    for (const std::string& words : rest) {
        draw_text(canvas, at, escape_markup(words), small);
        at.y += 1.4 * small.size;
    }
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
                    .align = Align::right};
    const double width = measure_text(words, style).width + 1.2 * unit_;
    canvas.fill({box.right() - width, box.y, width, 2.3 * unit_},
                with_alpha(theme_.ground, plate_alpha * tick.slow.share));
    draw_text(canvas, {box.right() - 0.6 * unit_, box.y + 1.7 * unit_}, words, style);
}

void FramePainter::draw_captions(Canvas& canvas, const Tick& tick, bool still) const {
    for (const CaptionSpan& caption : captions_) {
        const double alpha = opacity(caption, scene_.film, tick.frame, caption_fade_seconds);
        if (alpha > 0.0 && !caption.words.empty())
            draw_caption(canvas, caption.words, still ? 1.0 : alpha);
    }
}

// Draws a caption in one line, smaller if that avoids cutting it; centred on the gas if nothing is
// beside the gas.
void FramePainter::draw_caption(Canvas& canvas, const std::string& words, double alpha) const {
    const LayoutSpec& layout = scene_.film.layout;
    const Rect line = grid_.place(*layout.caption);
    const Rect place = grid_.place(layout.gas);
    const Rect box = panels_.gas().frame_in(place, unit_);
    TextStyle style{.size = 1.3 * unit_,
                    .weight = 500,
                    .color = with_alpha(theme_.ink, alpha),
                    .tabular = false};
    const TextExtent whole = measure_words(words, style);
    const bool has_formula = words.find('$') != std::string::npos;
    const double share = std::min(line.width / whole.width,
                                  has_formula ? line.height / (whole.ascent + whole.descent) : 1.0);
    style.size = std::max(unit_, std::min(1.0, share) * style.size);
    style.max_width = line.width * (1.0 + 1e-3);  // letters are set at whole sizes
    const bool centered = box.x > place.x;
    const TextExtent extent = measure_words(words, style);
    const double half = 0.5 * std::min(line.width, extent.width);
    const double middle =
        std::max(line.x + half, std::min(box.x + 0.5 * box.width, line.right() - half));
    const double below_middle =
        has_formula ? 0.5 * (extent.ascent - extent.descent) : 0.36 * style.size;
    draw_words(canvas,
               {centered ? middle - half : line.x, line.y + 0.5 * line.height + below_middle},
               words, style);
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
                        .align = Align::center};
        const double padding = 3.0 * unit_;
        style.size *= std::min(1.0, box.width / (measure_text(words, style).width + padding));
        const double width = measure_text(words, style).width + padding;
        const Rect plate{box.x + 0.5 * (box.width - width), box.y + 0.5 * box.height - 2.0 * unit_,
                         width, 4.0 * unit_};
        canvas.fill(plate, with_alpha(theme_.page, 0.82 * alpha));
        draw_text(canvas, {box.x + 0.5 * box.width, plate.y + 2.75 * unit_}, words, style);
    }
}

}  // namespace carom
