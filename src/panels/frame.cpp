#include "panels/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "draw/formula/words.h"
#include "panels/callouts/fade.h"
#include "panels/gas/marks/ghosts.h"
#include "panels/layout.h"
#include "panels/words/monitors_panel.h"

namespace carom {

Color page_color(const Film& film) { return theme_of(film.theme).page; }

namespace {

constexpr double title_line = 1.2;       // of the size of its letters
constexpr double subtitle_line = 1.35;   // units
constexpr double line_of_caption = 1.2;  // of the size of its letters

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
      theme_(theme_of(scene_.film.theme)),
      grid_(scene_.film.layout, scene_.film.size),
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
    const Panel::Key key = this->key();
    panels_.gas().draw_key(canvas, key);
    draw_title(canvas, end_of_title(key));
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

// The title is set in one line, smaller if necessary; if that does not suffice, in two lines as
// large as the place allows.
FramePainter::SetTitle FramePainter::set_title(const Rect& area) const {
    constexpr double largest = 1.73, smallest_in_one = 1.3, smallest = 1.0;  // units
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
    const double room = area.height - (has_subtitle_in_title() ? subtitle_line * unit_ : 0.0);
    for (style.size = std::min(style.size, room / (2.0 * title_line));; style.size *= 0.95) {
        const bool is_smallest = style.size <= smallest * unit_;
        if (is_smallest) style.size = smallest * unit_;
        std::vector<std::string> lines = wrapped(scene_.title, style, 2);
        const double width =
            measure_text(escape_markup(lines.back()), {style.size, style.weight}).width;
        if (is_smallest || width <= area.width) return {style, std::move(lines)};
    }
}

// Where there is no place for captions, which has it at the start.
bool FramePainter::has_subtitle_in_title() const {
    return !scene_.subtitle.empty() && !scene_.film.layout.caption;
}

// Draws the title as far as `end`, and the subtitle in the lines that the title leaves.
void FramePainter::draw_title(Canvas& canvas, double end) const {
    Rect area = grid_.place(scene_.film.layout.title);
    area.width = end - area.x;
    const SetTitle title = set_title(area);
    double y = area.y;
    for (const std::string& words : title.lines) {
        draw_text(canvas, {area.x, y + 0.9 * title.style.size}, escape_markup(words), title.style);
        y += title_line * title.style.size;
    }
    if (!has_subtitle_in_title()) return;
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
    add("the title or the subtitle", [&] {
        draw_title(scratch, before_numbers(grid_.place(scene_.film.layout.title)).right());
    });
    if (subtitle_)
        add(fmt::format("the subtitle “{}”", scene_.subtitle),
            [&] { draw_caption(scratch, scene_.subtitle, 1.0); });
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
        const double out = plate_margin * unit_;
        draw_plate(canvas, {dc.area.x - out, dc.area.y - out, dc.area.width + 2.0 * out,
                            dc.area.height + 2.0 * out});
    }
    placed.panel->draw_ground(canvas, dc);
    placed.panel->draw(canvas, dc, state);
}

// Dims what lies under a panel; toward its edges less and less.
void FramePainter::draw_plate(Canvas& canvas, const Rect& area) const {
    constexpr int rings = 12;
    constexpr double dimmed = 0.82, feather = 0.8;  // share; units
    const double step = feather * unit_ / rings;
    const auto ring = [&](int k) {
        const double in = k * step;
        return Rect{area.x + in, area.y + in, area.width - 2.0 * in, area.height - 2.0 * in};
    };
    for (int k = 0; k < rings; ++k) {
        const double share = (k + 0.5) / rings;
        const Color color = with_alpha(theme_.page, dimmed * smooth(share));
        const Rect outer = ring(k), inner = ring(k + 1);
        canvas.fill({outer.x, outer.y, outer.width, inner.y - outer.y}, color);
        canvas.fill({outer.x, inner.bottom(), outer.width, outer.bottom() - inner.bottom()}, color);
        canvas.fill({outer.x, inner.y, inner.x - outer.x, inner.height}, color);
        canvas.fill({inner.right(), inner.y, outer.right() - inner.right(), inner.height}, color);
    }
    canvas.fill(ring(rings), with_alpha(theme_.page, dimmed));
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
    if (subtitle_) {
        const double alpha = opacity(*subtitle_, scene_.film, tick.frame, caption_fade_seconds);
        if (alpha > 0.0) draw_caption(canvas, scene_.subtitle, still ? 1.0 : alpha);
    }
    for (const CaptionSpan& caption : captions_) {
        const double alpha = opacity(caption, scene_.film, tick.frame, caption_fade_seconds);
        if (alpha > 0.0 && !caption.words.empty())
            draw_caption(canvas, caption.words, still ? 1.0 : alpha);
    }
}

// What numbers and the clock leave of a line in which they stand, too.
Rect FramePainter::before_numbers(Rect line) const {
    for (const PanelSet::Placed& placed : panels_.panels()) {
        if (dynamic_cast<const MonitorsPanel*>(placed.panel.get()) == nullptr) continue;
        line = before(line, placed.panel->frame_in(grid_.place(placed.slot), unit_), unit_);
    }
    return line;
}

// As large as the place allows.
void FramePainter::draw_lines_of_caption(Canvas& canvas, const std::string& words,
                                         const Rect& place, TextStyle style) const {
    style.max_width = place.width * (1.0 + 1e-3);
    for (;; style.size *= 0.95) {
        const bool is_smallest = style.size <= unit_;
        if (is_smallest) style.size = unit_;
        const auto most = static_cast<std::size_t>(
            std::max(1.0, std::floor(place.height / (line_of_caption * style.size) + 1e-6)));
        const std::vector<std::string> lines = wrapped_words(words, style, most);
        TextStyle whole = style;
        whole.max_width = 0.0;
        if (!is_smallest && measure_words(lines.back(), whole).width > place.width) continue;
        double y = place.y;
        for (const std::string& line : lines) {
            const auto [above, height] = line_height_of(line, style, line_of_caption);
            draw_words(canvas, {place.x, y + above}, line, style);
            y += height;
        }
        return;
    }
}

// Draws a caption from the left, in as many lines as its place has room for, smaller if that avoids
// cutting it.
void FramePainter::draw_caption(Canvas& canvas, const std::string& words, double alpha) const {
    constexpr double largest = 1.47, smallest = 1.0;  // units
    constexpr double least_of_larger_lines = 3.0;     // units: lower places have a single such line
    const Rect place = before_numbers(grid_.place(*scene_.film.layout.caption));
    TextStyle style{.size = largest * unit_,
                    .weight = 500,
                    .color = with_alpha(theme_.ink, alpha),
                    .tabular = false};
    const double in_one = place.width / measure_words(words, style).width * style.size;
    const bool has_more_lines = place.height >= 2.0 * line_of_caption * smallest * unit_;
    const bool may_be_large = place.height > least_of_larger_lines * unit_;
    if (has_more_lines && in_one < (may_be_large ? largest : smallest) * unit_)
        return draw_lines_of_caption(canvas, words, place, style);
    const TextExtent whole = measure_words(words, style);
    const bool has_formula = words.find('$') != std::string::npos;
    const double share =
        std::min(place.width / whole.width,
                 has_formula ? place.height / (whole.ascent + whole.descent) : 1.0);
    style.size = std::max(unit_, std::min(1.0, share) * style.size);
    style.max_width = place.width * (1.0 + 1e-3);  // letters are set at whole sizes
    const TextExtent extent = measure_words(words, style);
    const double below_middle =
        has_formula ? 0.5 * (extent.ascent - extent.descent) : 0.36 * style.size;
    draw_words(canvas, {place.x, place.y + 0.5 * place.height + below_middle}, words, style);
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
