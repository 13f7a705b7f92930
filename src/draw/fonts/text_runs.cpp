#include "draw/fonts/text_runs.h"

#include <algorithm>
#include <string>

#include "draw/fonts/fonts.h"

namespace carom {
namespace {

using Description = Owned<PangoFontDescription, pango_font_description_free>;

double length_of(int pango_units) { return static_cast<double>(pango_units) / PANGO_SCALE; }

// The colour that the markup gives a run, or that of the line.
Color color_of_run(const PangoGlyphItem& run, Color color) {
    constexpr double most = 65535.0;
    for (GSList* link = run.item->analysis.extra_attrs; link != nullptr; link = link->next) {
        const auto* attribute = static_cast<const PangoAttribute*>(link->data);
        if (attribute->klass->type != PANGO_ATTR_FOREGROUND) continue;
        const PangoColor& its = reinterpret_cast<const PangoAttrColor*>(attribute)->color;
        return {its.red / most, its.green / most, its.blue / most, color.alpha};
    }
    return color;
}

}  // namespace

bool is_decorated(const PangoGlyphItem& run) {
    for (GSList* link = run.item->analysis.extra_attrs; link != nullptr; link = link->next) {
        switch (static_cast<const PangoAttribute*>(link->data)->klass->type) {
            case PANGO_ATTR_FOREGROUND:
            case PANGO_ATTR_FOREGROUND_ALPHA:
            case PANGO_ATTR_BACKGROUND:
            case PANGO_ATTR_BACKGROUND_ALPHA:
            case PANGO_ATTR_UNDERLINE:
            case PANGO_ATTR_OVERLINE:
            case PANGO_ATTR_STRIKETHROUGH:
            case PANGO_ATTR_SHAPE:
                return true;
            default:
                break;
        }
    }
    return false;
}

std::vector<TextRun> runs_of(PangoLayout* layout, Point origin, Color color) {
    std::vector<TextRun> runs;
    const std::string text = pango_layout_get_text(layout);
    int x = 0;
    for (GSList* link = pango_layout_get_line_readonly(layout, 0)->runs; link != nullptr;
         link = link->next) {
        const auto& item = *static_cast<const PangoGlyphItem*>(link->data);
        const int width = pango_glyph_string_get_width(item.glyphs);
        const PangoFont* font = item.item->analysis.font;
        x += item.start_x_offset;
        if (font != nullptr && item.item->length > 0) {
            const Description description{
                pango_font_describe_with_absolute_size(item.item->analysis.font)};
            TextRun run{
                .words = text.substr(static_cast<std::size_t>(item.item->offset),
                                     static_cast<std::size_t>(item.item->length)),
                .x = origin.x + length_of(x),
                .y = origin.y - length_of(item.y_offset),
                .width = length_of(width),
                .family = pango_font_description_get_family(description.get()),
                .size = pango_font_description_get_size(description.get()) / double(PANGO_SCALE),
                .weight = pango_font_description_get_weight(description.get()),
                .is_italic =
                    pango_font_description_get_style(description.get()) != PANGO_STYLE_NORMAL,
                .is_right_to_left = item.item->analysis.level % 2 == 1,
                .color = color_of_run(item, color)};
            if (run.is_right_to_left) run.x += run.width;
            runs.push_back(std::move(run));
        }
        x += width + item.end_x_offset;
    }
    return runs;
}

}  // namespace carom
