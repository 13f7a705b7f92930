#include "draw/text.h"

#include <cairo.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "draw/fonts/fonts.h"
#include "draw/fonts/text_runs.h"
#include "draw/formula/ink.h"
#include "util/text.h"

namespace carom {
namespace {

using Font = Owned<PangoFont, g_object_unref>;
using Layout = Owned<PangoLayout, g_object_unref>;
using Attributes = Owned<PangoAttrList, pango_attr_list_unref>;
using Description = Owned<PangoFontDescription, pango_font_description_free>;
using Glyphs = Owned<PangoGlyphString, pango_glyph_string_free>;
using Surface = Owned<cairo_surface_t, cairo_surface_destroy>;
using CairoContext = Owned<cairo_t, cairo_destroy>;
using GString = Owned<char, g_free>;

struct PlacedGlyph {
    PangoFont* font = nullptr;  ///< kept alive by the line's layout
    PangoGlyph glyph = 0;
    double x = 0, y = 0;  ///< from the start of the baseline
};

// A line that has been shaped. `glyphs` is empty if Pango has to draw it: with colours of its own,
// underlines, or letters from other fonts.
struct TextLine {
    Layout layout;
    TextExtent extent;
    Rect ink;  ///< relative to its origin
    std::vector<PlacedGlyph> glyphs;
};

struct LineKey {
    std::string markup;
    double size;
    int weight;
    bool tabular;
    double max_width;
    const std::string* family;  ///< null: the usual one
    auto operator<=>(const LineKey&) const = default;
};

Attributes parse(const std::string& markup, std::string& text) {
    PangoAttrList* attributes = nullptr;
    char* plain = nullptr;
    if (pango_parse_markup(markup.data(), static_cast<int>(markup.size()), 0, &attributes, &plain,
                           nullptr, nullptr)) {
        text = GString(plain).get();
        return Attributes(attributes);
    }
    text = GString(g_utf8_make_valid(markup.data(), static_cast<gssize>(markup.size()))).get();
    return Attributes(pango_attr_list_new());
}

Layout create_layout(PangoContext* context, const LineKey& key) {
    Layout layout{pango_layout_new(context)};
    std::string text;
    const Attributes attributes = parse(key.markup, text);
    if (key.tabular)
        pango_attr_list_insert_before(attributes.get(), pango_attr_font_features_new("tnum=1"));

    const Description description{pango_font_description_new()};
    // Letters that it lacks come from the usual one.
    const std::string families = key.family != nullptr ? *key.family + "," + font_family : "";
    if (families.empty())
        pango_font_description_set_family_static(description.get(), font_family);
    else
        pango_font_description_set_family(description.get(), families.c_str());
    pango_font_description_set_weight(description.get(), static_cast<PangoWeight>(key.weight));
    pango_font_description_set_absolute_size(description.get(), key.size * PANGO_SCALE);
    pango_layout_set_font_description(layout.get(), description.get());

    pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
    pango_layout_set_attributes(layout.get(), attributes.get());
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    if (key.max_width > 0) {
        pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
        pango_layout_set_width(layout.get(), static_cast<int>(key.max_width * PANGO_SCALE));
    }
    return layout;
}

double to_length(int pango_units) { return static_cast<double>(pango_units) / PANGO_SCALE; }

TextExtent extent_of(PangoLayout* layout) {
    PangoRectangle logical = {};
    pango_layout_line_get_extents(pango_layout_get_line_readonly(layout, 0), nullptr, &logical);
    return {to_length(logical.width), to_length(-logical.y), to_length(logical.y + logical.height)};
}

Rect ink_of(PangoLayout* layout) {
    PangoRectangle ink = {};
    pango_layout_line_get_extents(pango_layout_get_line_readonly(layout, 0), &ink, nullptr);
    return {to_length(ink.x), to_length(ink.y), to_length(ink.width), to_length(ink.height)};
}

void place_glyphs(const PangoGlyphItem& run, int& x, std::vector<PlacedGlyph>& glyphs) {
    const int y = -run.y_offset;
    x += run.start_x_offset;
    for (int i = 0; i < run.glyphs->num_glyphs; ++i) {
        const PangoGlyphInfo& info = run.glyphs->glyphs[i];
        if (info.glyph != PANGO_GLYPH_EMPTY)
            glyphs.push_back({run.item->analysis.font, info.glyph,
                              to_length(x + info.geometry.x_offset),
                              to_length(y + info.geometry.y_offset)});
        x += info.geometry.width;
    }
    x += run.end_x_offset;
}

std::vector<PlacedGlyph> glyphs_of(PangoLayout* layout) {
    std::vector<PlacedGlyph> glyphs;
    int x = 0;
    for (GSList* run = pango_layout_get_line_readonly(layout, 0)->runs; run != nullptr;
         run = run->next) {
        const auto& item = *static_cast<const PangoGlyphItem*>(run->data);
        if (is_decorated(item)) return {};
        place_glyphs(item, x, glyphs);
    }
    return glyphs;
}

// The coverage of one glyph, and the position of its upper left pixel relative to the pixel of its
// origin.
struct GlyphMask {
    Surface coverage;
    int left = 0, top = 0;
};

GlyphMask create_mask(PangoFont* font, PangoGlyph glyph, double shift_x, double shift_y) {
    PangoRectangle ink = {};
    pango_font_get_glyph_extents(font, glyph, &ink, nullptr);
    GlyphMask mask;
    if (ink.width <= 0 || ink.height <= 0) return mask;
    mask.left = static_cast<int>(std::floor(to_length(ink.x))) - 1;
    mask.top = static_cast<int>(std::floor(to_length(ink.y))) - 1;
    const int width = static_cast<int>(std::ceil(to_length(ink.x + ink.width))) + 2 - mask.left;
    const int height = static_cast<int>(std::ceil(to_length(ink.y + ink.height))) + 2 - mask.top;
    mask.coverage.reset(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));

    const CairoContext context{cairo_create(mask.coverage.get())};
    const Glyphs one{pango_glyph_string_new()};
    pango_glyph_string_set_size(one.get(), 1);
    one->glyphs[0] = {};
    one->glyphs[0].glyph = glyph;
    cairo_move_to(context.get(), shift_x - mask.left, shift_y - mask.top);
    pango_cairo_glyph_string_path(context.get(), font, one.get());
    cairo_fill(context.get());
    require_drawn(context.get());
    return mask;
}

// The fonts and caches of one thread. Both caches are emptied when full: what a film shows
// repeatedly is soon cached again.
class Typesetter {
  public:
    const TextLine& line(const LineKey& key) {
        const auto known = lines_.find(key);
        if (known != lines_.end()) return known->second;
        if (lines_.size() >= most_lines) lines_.clear();
        return lines_.emplace(key, set(key)).first->second;
    }

    const GlyphMask& mask(const PlacedGlyph& glyph, int phase_x, int phase_y) {
        const MaskKey key{glyph.font, glyph.glyph, phase_x, phase_y};
        const auto known = masks_.find(key);
        if (known != masks_.end()) return known->second;
        if (masks_.size() >= most_masks) masks_.clear();
        keep(glyph.font);
        return masks_
            .emplace(key, create_mask(glyph.font, glyph.glyph, phase_x / phases, phase_y / phases))
            .first->second;
    }

    /// Lays out words in as many lines as they need.
    Layout paragraph(const LineKey& key, double width) {
        Layout layout = in_declared(key);
        if (!has_all_letters(layout)) layout = in_machine(key);
        pango_layout_set_width(layout.get(), static_cast<int>(width * PANGO_SCALE));
        pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
        return layout;
    }

    /// Whether the line has letters that no font of the machine provides.
    bool lacks(const LineKey& key) {
        return !has_all_letters(in_declared(key)) && !has_all_letters(in_machine(key));
    }

    static constexpr double phases = 8.0;

  private:
    using MaskKey = std::tuple<PangoFont*, PangoGlyph, int, int>;
    static constexpr std::size_t most_lines = 512;
    static constexpr std::size_t most_masks = 4096;

    TextLine set(const LineKey& key) {
        TextLine line;
        line.layout = in_declared(key);
        const bool is_complete = has_all_letters(line.layout);
        if (!is_complete) line.layout = in_machine(key);
        line.extent = extent_of(line.layout.get());
        line.ink = ink_of(line.layout.get());
        if (is_complete) line.glyphs = glyphs_of(line.layout.get());
        return line;
    }

    const Fonts& fonts_in(const std::string* family) {
        if (family == nullptr) return declared_;
        const auto known = own_.find(family);
        if (known != own_.end()) return known->second;
        return own_.emplace(family, declared_fonts(*family)).first->second;
    }

    Layout in_declared(const LineKey& key) {
        Layout layout = create_layout(fonts_in(key.family).context.get(), key);
        const bool has_markup = key.markup.find('<') != std::string::npos;
        const bool has_all_weights = key.family == nullptr;
        require_fonts_of(layout.get(), has_markup || !has_all_weights ? 0 : key.weight);
        return layout;
    }

    Layout in_machine(const LineKey& key) {
        if (!machine_) machine_ = machine_fonts();
        Layout layout = create_layout(machine_->context.get(), key);
        require_fonts_of(layout.get(), 0);
        return layout;
    }

    static bool has_all_letters(const Layout& layout) {
        return pango_layout_get_unknown_glyphs_count(layout.get()) == 0;
    }

    // A font whose address is used as a key must not be freed, or another font might get the same
    // address.
    void keep(PangoFont* font) {
        if (!fonts_.contains(font))
            fonts_.emplace(font, static_cast<PangoFont*>(g_object_ref(font)));
    }

    Fonts declared_ = declared_fonts();
    std::map<const std::string*, Fonts> own_;  ///< of families that styles name
    std::optional<Fonts> machine_;
    std::map<PangoFont*, Font> fonts_;
    std::map<LineKey, TextLine> lines_;
    std::map<MaskKey, GlyphMask> masks_;
};

Typesetter& typesetter() {
    thread_local Typesetter own;
    return own;
}

const std::string* family_of(const TextStyle& style) {
    if (style.fonts == nullptr) return nullptr;
    const std::string& family = style.lettering == Lettering::text      ? style.fonts->text
                                : style.lettering == Lettering::numbers ? style.fonts->numbers
                                                                        : style.fonts->formulas;
    return family.empty() ? nullptr : &family;
}

const TextLine& line_of(const std::string& markup, const TextStyle& style) {
    return typesetter().line(
        {markup, style.size, style.weight, style.tabular, style.max_width, family_of(style)});
}

// The whole pixel at or before a position, and the sub-pixel phase after it.
std::pair<int, int> to_grid(double position) {
    const double steps = std::floor(position * Typesetter::phases + 0.5);
    const double whole = std::floor(steps / Typesetter::phases);
    return {static_cast<int>(whole), static_cast<int>(steps - whole * Typesetter::phases)};
}

void draw_glyphs(Canvas& canvas, Point origin, const TextLine& line) {
    for (const PlacedGlyph& glyph : line.glyphs) {
        const auto [x, phase_x] = to_grid(origin.x + glyph.x);
        const auto [y, phase_y] = to_grid(origin.y + glyph.y);
        const GlyphMask& mask = typesetter().mask(glyph, phase_x, phase_y);
        cairo_surface_t* coverage = mask.coverage.get();
        if (coverage == nullptr) continue;
        const double left = x + mask.left, top = y + mask.top;
        cairo_mask_surface(canvas.handle(), coverage, left, top);
        canvas.touch({left, top, double(cairo_image_surface_get_width(coverage)),
                      double(cairo_image_surface_get_height(coverage))});
    }
}

double start_of(double x, Align align, double width) {
    if (align == Align::left) return x;
    return align == Align::center ? x - 0.5 * width : x - width;
}

thread_local TextLog* current_log = nullptr;

void draw_halo(Canvas& canvas, Point origin, const Rect& ink, const TextLine& line,
               const TextStyle& style) {
    const double w = style.halo + 1.0;
    canvas.touch({ink.x - w, ink.y - w, ink.width + 2 * w, ink.height + 2 * w});
    cairo_t* context = canvas.handle();
    const Color& color = style.behind;
    cairo_set_source_rgba(context, color.red, color.green, color.blue, color.alpha);
    cairo_set_line_width(context, 2.0 * style.halo);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_move_to(context, origin.x, origin.y);
    pango_cairo_layout_line_path(context, pango_layout_get_line_readonly(line.layout.get(), 0));
    cairo_stroke(context);
}

// Whether letters, including their antialiased edges and halo, reach into a raster.
bool meets(const Rect& ink, double halo, PixelSize size) {
    const double around = halo + 2.0;
    return ink.right() + around > 0.0 && ink.bottom() + around > 0.0 &&
           ink.x - around < size.width && ink.y - around < size.height;
}

void draw_line(Canvas& canvas, Point origin, const Rect& ink, const TextLine& line,
               const TextStyle& style) {
    if (canvas.keeps_text()) {
        constexpr std::array kinds{"text", "numbers", "formulas"};
        return canvas.write({.runs = runs_of(line.layout.get(), origin, style.color),
                             .kind = kinds.at(static_cast<std::size_t>(style.lettering)),
                             .tabular = style.tabular,
                             .halo = style.halo,
                             .behind = style.behind});
    }
    cairo_t* context = canvas.handle();
    if (style.halo > 0.0) draw_halo(canvas, origin, ink, line, style);
    const Color& color = style.color;
    cairo_set_source_rgba(context, color.red, color.green, color.blue, color.alpha);
    if (canvas.is_raster() && !line.glyphs.empty()) {
        draw_glyphs(canvas, origin, line);
    } else {
        canvas.touch({ink.x - 1.0, ink.y - 1.0, ink.width + 2.0, ink.height + 2.0});
        cairo_move_to(context, origin.x, origin.y);
        pango_cairo_show_layout_line(context, pango_layout_get_line_readonly(line.layout.get(), 0));
        cairo_new_path(context);
    }
    require_drawn(context);
}

}  // namespace

std::string text_library() { return std::string("pango ") + pango_version_string(); }

TextExtent draw_text(Canvas& canvas, Point at, const std::string& markup, const TextStyle& style) {
    const TextLine& line = line_of(markup, style);
    Point origin{start_of(at.x, style.align, line.extent.width), at.y};
    if (canvas.is_raster()) origin.y = std::round(origin.y);
    const Rect ink{origin.x + line.ink.x, origin.y + line.ink.y, line.ink.width, line.ink.height};
    if (!canvas.is_raster() || meets(ink, style.halo, canvas.size()))
        draw_line(canvas, origin, ink, line, style);
    if (current_log != nullptr)
        current_log->lines.push_back(
            {markup, style.size, ink, pango_layout_is_ellipsized(line.layout.get()) != 0});
    return line.extent;
}

std::vector<std::string> wrapped(const std::string& words, const TextStyle& style,
                                 std::size_t most) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    if (!words.empty()) {
        const LineKey key{escape_markup(words), style.size, style.weight,
                          style.tabular,        0.0,        family_of(style)};
        const Layout layout = typesetter().paragraph(key, style.max_width);
        const GSList* line = pango_layout_get_lines_readonly(layout.get());
        for (; line != nullptr && lines.size() + 1 < most; line = line->next) {
            const auto& one = *static_cast<const PangoLayoutLine*>(line->data);
            begin = static_cast<std::size_t>(one.start_index + one.length);
            lines.push_back(words.substr(static_cast<std::size_t>(one.start_index),
                                         static_cast<std::size_t>(one.length)));
            while (lines.back().ends_with(' ')) lines.back().pop_back();
        }
    }
    while (begin < words.size() && words[begin] == ' ') ++begin;
    if (begin < words.size()) lines.push_back(words.substr(begin));
    return lines;
}

std::vector<std::string> missing_letters(const std::string& text) {
    const auto lacks = [](const std::string& words) {
        return typesetter().lacks({escape_markup(words), 16.0, 400, true, 0.0, nullptr});
    };
    std::vector<std::string> letters;
    std::unordered_set<std::string> seen;
    std::string all;  // separated, so that each letter is set as if alone
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t next = next_code_point(text, i);
        const std::string letter = text.substr(i, next - i);
        i = next;
        if (!seen.insert(letter).second) continue;
        letters.push_back(letter);
        all += letter + " ";
    }
    if (!lacks(all)) return {};
    std::erase_if(letters, [&](const std::string& letter) { return !lacks(letter); });
    return letters;
}

TextLog::TextLog() { current_log = this; }
TextLog::~TextLog() { current_log = nullptr; }

void leave_out(const std::string& markup) {
    if (current_log == nullptr) return;
    parse(markup, current_log->left_out.emplace_back());
}

void name_in_key(const std::string& markup) {
    if (current_log == nullptr) return;
    parse(markup, current_log->in_keys.emplace_back());
}

LineInPieces::LineInPieces(DrawnLine line) : log_(std::exchange(current_log, nullptr)) {
    if (log_ != nullptr) log_->lines.push_back(std::move(line));
}
LineInPieces::~LineInPieces() { current_log = log_; }

TextExtent measure_text(const std::string& markup, const TextStyle& style) {
    return line_of(markup, style).extent;
}

Ink ink_of(const std::string& markup, const TextStyle& style) {
    const TextLine& line = line_of(markup, style);
    return {line.extent.width, line.ink};
}

void require_font() { declared_fonts(); }

std::vector<std::string> installed_families() { return families_of_machine(); }

}  // namespace carom
