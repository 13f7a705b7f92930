#include "panels/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/scene.h"

namespace carom {

const Box& PanelContext::box() const { return scene.gas.box; }
const std::vector<Species>& PanelContext::species() const { return scene.gas.species; }
const Run& PanelContext::run() const { return scene.run; }
const Gas& PanelContext::gas_in_scene() const { return scene.gas; }
const Film& PanelContext::film() const { return scene.film; }
const std::vector<SpeciesLook>& PanelContext::looks() const { return scene.looks; }
Language PanelContext::language() const { return scene.film.language; }
Wording PanelContext::wording() const { return wording_of(scene); }

void refuse(Diagnostic place, std::string message, std::string hint) {
    place.message = std::move(message);
    place.hint = std::move(hint);
    throw SceneError({place});
}

TextStyle label_style(const DrawContext& dc) {
    return {.size = dc.unit, .weight = 400, .color = dc.theme.muted, .fonts = dc.theme.fonts};
}

TextStyle title_style(const DrawContext& dc) {
    return {.size = 1.15 * dc.unit, .weight = 500, .color = dc.theme.ink, .fonts = dc.theme.fonts};
}

AxisStyle axis_style(const DrawContext& dc) {
    TextStyle numbers = label_style(dc);
    numbers.color = dc.theme.second;
    numbers.lettering = Lettering::numbers;
    return {.line_width = 0.07 * dc.unit,
            .tick_length = 0.3 * dc.unit,
            .label = numbers,
            .title = label_style(dc),
            .line = dc.theme.muted};
}

Rect plot_area(const DrawContext& dc) {
    const double left = 3.0 * dc.unit;
    const double top = 2.5 * dc.unit;
    const double bottom = 1.65 * dc.unit;
    return {dc.area.x + left, dc.area.y + top, dc.area.width - left, dc.area.height - top - bottom};
}

void draw_panel_title(Canvas& canvas, const DrawContext& dc, const std::string& markup) {
    TextStyle style = title_style(dc);
    const double width = measure_text(markup, style).width;
    // Down to the smallest size of text. Widths are nearly proportional to it: a little less.
    if (width > dc.area.width)
        style.size = std::max(dc.unit, 0.99 * style.size * dc.area.width / width);
    style.max_width = dc.area.width;
    draw_text(canvas, {dc.area.x, dc.area.y + 1.05 * dc.unit}, markup, style);
}

std::string fitting_title(const DrawContext& dc, const std::vector<std::string>& titles) {
    TextStyle style = title_style(dc);
    style.size = dc.unit;
    for (const std::string& title : titles)
        if (measure_text(title, style).width <= dc.area.width) return title;
    return titles.empty() ? "" : titles.back();
}

std::string line_swatch(std::size_t line, Color color, const Theme& theme) {
    if (theme.kind != ThemeKind::print) return "";
    constexpr std::array<const char*, 4> swatches = {"—", "- -", "···", "–·–"};
    return fmt::format("<span foreground=\"{}\" weight=\"900\">{}</span> ",
                       hex_of(edge_of(color, theme)), swatches[line % swatches.size()]);
}

bool looks_hollow(Color color, const Theme& theme) {
    const bool is_grey = color.red == color.green && color.green == color.blue;
    return is_grey && contrast(color, theme.page) < least_contrast_of_marks;
}

std::string disk_swatch(Color color, const Theme& theme) {
    if (theme.kind != ThemeKind::print) return "";
    return fmt::format("<span foreground=\"{}\">{}</span> ", hex_of(edge_of(color, theme)),
                       looks_hollow(color, theme) ? "○" : "●");
}

std::string slow_words(const Slowness& slow) { return fmt::format("\u00D7{:.3g}", slow.factor); }

}  // namespace carom
