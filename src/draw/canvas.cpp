#include "draw/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "draw/pages/pages.h"
#include "draw/png.h"
#include "draw/raster/simplified_path.h"
#include "draw/svg.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

constexpr int largest_side = 16384;

void check(cairo_status_t status, const char* action) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw SystemError(fmt::format("cannot {}: {}", action, cairo_status_to_string(status)));
}

struct SurfaceDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

struct ContextDeleter {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

void check(PixelSize size) {
    if (size.width < 1 || size.height < 1 || size.width > largest_side ||
        size.height > largest_side)
        throw SystemError(
            fmt::format("cannot draw a picture of {} × {} pixels: each side must be "
                        "between 1 and {}",
                        size.width, size.height, largest_side));
}

Surface create_raster(PixelSize size, Backdrop backdrop) {
    check(size);
    Surface surface{cairo_image_surface_create(
        backdrop == Backdrop::black ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, size.width,
        size.height)};
    check(cairo_surface_status(surface.get()), "create a picture");
    return surface;
}

// Called by Cairo from C: no exception may leave it.
cairo_status_t append(void* closure, const unsigned char* data, unsigned length) noexcept {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(closure);
    try {
        bytes.insert(bytes.end(), data, data + length);
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
    return CAIRO_STATUS_SUCCESS;
}

constexpr double points_of_a_pixel = 0.75;
constexpr double usual_resolution = 72.0 / points_of_a_pixel;  // dots per inch

// A fixed date: otherwise the file of the same picture would change every second.
void set_metadata(cairo_surface_t* pdf, const PictureWords& words) {
    constexpr const char* date = "2000-01-01T00:00:00Z";
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_TITLE, words.title.c_str());
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_SUBJECT, words.description.c_str());
    if (!words.origin.empty())
        cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_KEYWORDS, words.origin.c_str());
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, date);
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_MOD_DATE, date);
}

// Cairo writes the document to memory, so that a full disk cannot go unnoticed.
Surface create_document(PixelSize size, VectorFormat format, const PictureWords& words,
                        std::vector<std::uint8_t>& bytes) {
    check(size);
    Surface surface;
    if (format == VectorFormat::svg) {
        surface.reset(cairo_svg_surface_create_for_stream(append, &bytes, size.width, size.height));
        check(cairo_surface_status(surface.get()), "create an SVG");
        cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    } else {
        surface.reset(cairo_pdf_surface_create_for_stream(
            append, &bytes, points_of_a_pixel * size.width, points_of_a_pixel * size.height));
        check(cairo_surface_status(surface.get()), "create a PDF");
        // PDF 1.4 instead of 1.7, the default since Cairo 1.18: old readers, pdfTeX among them,
        // accept 1.4.
        cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
        set_metadata(surface.get(), words);
    }
    return surface;
}

Context create_context(cairo_surface_t* surface) {
    Context context{cairo_create(surface)};
    check(cairo_status(context.get()), "draw");
    cairo_set_antialias(context.get(), CAIRO_ANTIALIAS_GRAY);
    return context;
}

void set_color(cairo_t* context, Color color) {
    cairo_set_source_rgba(context, color.red, color.green, color.blue, color.alpha);
}

// Cairo keeps these settings between calls, and they affect how it rounds straight and bent lines:
// every call sets its own, so that the result does not depend on earlier drawing.
void set_ends(cairo_t* context, cairo_line_cap_t cap, cairo_line_join_t join) {
    cairo_set_line_cap(context, cap);
    cairo_set_line_join(context, join);
}

void trace(cairo_t* context, std::span<const Point> points) {
    for (const Point& point : points) cairo_line_to(context, point.x, point.y);
}

std::uint64_t new_picture() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

void trace_circle(cairo_t* context, Point center, double radius) {
    cairo_new_sub_path(context);
    cairo_arc(context, center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(context);
}

}  // namespace

std::string drawing_library() { return std::string("cairo ") + cairo_version_string(); }

struct Canvas::Implementation {
    Implementation(PixelSize wanted, Backdrop wanted_backdrop)
        : size(wanted),
          backdrop(wanted_backdrop),
          surface(create_raster(wanted, wanted_backdrop)),
          context(create_context(surface.get())) {}

    Implementation(PixelSize wanted, VectorFormat wanted_format, PictureWords its_words)
        : size(wanted),
          format(wanted_format),
          words(std::move(its_words)),
          surface(create_document(size, wanted_format, words, bytes)),
          context(create_context(surface.get())) {
        if (format == VectorFormat::pdf)
            cairo_scale(context.get(), points_of_a_pixel, points_of_a_pixel);
    }

    PixelView pixels() const {
        assert(!format);
        cairo_surface_flush(surface.get());
        // Cairo aligns its pixels for the widest access that it makes itself.
        auto* data = static_cast<void*>(cairo_image_surface_get_data(surface.get()));
        const int stride = cairo_image_surface_get_stride(surface.get());
        return {static_cast<std::uint32_t*>(data), size.width, size.height, stride / 4,
                backdrop == Backdrop::black};
    }

    void touch(Rect rect) {
        if (format || all_touched) return;
        const auto within = [](double value, int most) {
            return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
        };
        const PixelBounds box{within(std::floor(rect.x), size.width),
                              within(std::floor(rect.y), size.height),
                              within(std::ceil(rect.right()), size.width),
                              within(std::ceil(rect.bottom()), size.height)};
        if (box.left < box.right && box.top < box.bottom) touched.push_back(box);
    }

    // Marks the box around the present path, enlarged by `reach`, as drawn on.
    void touch_path(double reach) {
        Rect rect;
        double right = 0.0, bottom = 0.0;
        cairo_path_extents(context.get(), &rect.x, &rect.y, &right, &bottom);
        touch({rect.x - reach, rect.y - reach, right - rect.x + 2.0 * reach,
               bottom - rect.y + 2.0 * reach});
    }

    // Marks boxes along a path, each enlarged by `reach`, as drawn on: a single box around a whole
    // curve would be many times as large.
    void touch_along(std::span<const Point> path, double reach) {
        constexpr std::size_t most_boxes = 64;
        const std::size_t together = path.size() / most_boxes + 1;
        for (std::size_t first = 0; first < path.size(); first += together) {
            const auto piece = path.subspan(first, std::min(together + 1, path.size() - first));
            const auto [left, right] = std::ranges::minmax(piece, {}, &Point::x);
            const auto [top, bottom] = std::ranges::minmax(piece, {}, &Point::y);
            touch({left.x - reach, top.y - reach, right.x - left.x + 2.0 * reach,
                   bottom.y - top.y + 2.0 * reach});
        }
    }

    PixelSize size;
    Backdrop backdrop = Backdrop::transparent;
    std::optional<VectorFormat> format;  ///< none: a raster
    PictureWords words;
    bool keeps_text = false;
    std::vector<WrittenText> texts;  ///< in the order of their marks
    double resolution = usual_resolution;
    std::vector<std::uint8_t> bytes;  ///< of the document; outlives the surface that writes them
    Surface surface;
    Context context;
    std::vector<PixelBounds> touched;   ///< since the last restore()
    std::vector<PixelBounds> restored;  ///< by the last restore()
    bool all_touched = true;
    std::uint64_t picture = new_picture();
    std::uint64_t last_picture = 0;  ///< before the last restore()
};

Canvas::Canvas(PixelSize size, Backdrop backdrop)
    : implementation_(std::make_unique<Implementation>(size, backdrop)) {}
Canvas::Canvas(PixelSize size, VectorFormat format, PictureWords words)
    : implementation_(std::make_unique<Implementation>(size, format, std::move(words))) {}

void Canvas::describe(PictureWords words) {
    assert(is_raster());
    implementation_->words = std::move(words);
}

void Canvas::set_resolution(double dots_per_inch) {
    assert(is_raster());
    implementation_->resolution = dots_per_inch;
}

void Canvas::keep_text(bool kept) {
    implementation_->keeps_text = kept && implementation_->format == VectorFormat::svg;
}

bool Canvas::keeps_text() const { return implementation_->keeps_text; }

// Cairo writes outlines only: it draws a mark for the text, which finished_svg() replaces.
void Canvas::write(WrittenText text) {
    if (text.runs.empty()) return;
    const Point place{text.runs.front().x, text.runs.front().y};
    std::vector<WrittenText>& texts = implementation_->texts;
    const PixelSize size = implementation_->size;
    const Point at{std::clamp(std::round(place.x), 0.0, size.width - 1.0),
                   std::clamp(std::round(place.y), 0.0, size.height - 1.0)};
    fill_polygon(std::vector{at, Point{at.x + 1.0, at.y},
                             Point{at.x, at.y + length_of_text_mark(texts.size())}},
                 with_alpha(rgb(0x000000), alpha_of_text_marks));
    texts.push_back(std::move(text));
}

Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

PixelSize Canvas::size() const { return implementation_->size; }

bool Canvas::is_raster() const { return !implementation_->format; }

cairo_t* Canvas::handle() const { return implementation_->context.get(); }

void Canvas::touch(Rect rect) { implementation_->touch(rect); }

void Canvas::fill_path(Color color) {
    implementation_->touch_path(1.0);
    set_color(handle(), color);
    cairo_fill(handle());
    check(cairo_status(handle()), "draw");
}

// The corners of a rectangle reach farthest: half the line width times the square root of 2.
void Canvas::stroke(double width, Color color) {
    implementation_->touch_path(0.75 * width + 1.0);
    stroke_untouched(width, color);
}

void Canvas::stroke_untouched(double width, Color color) {
    set_color(handle(), color);
    cairo_set_line_width(handle(), width);
    cairo_stroke(handle());
    check(cairo_status(handle()), "draw");
}

void Canvas::fill_all(Color color) {
    implementation_->all_touched = true;
    set_color(handle(), color);
    cairo_paint(handle());
    check(cairo_status(handle()), "draw");
}

void Canvas::fill(Rect rect, Color color) {
    cairo_rectangle(handle(), rect.x, rect.y, rect.width, rect.height);
    fill_path(color);
}

void Canvas::fade(Rect rect, double share) {
    cairo_save(handle());
    cairo_set_operator(handle(), CAIRO_OPERATOR_DEST_OUT);
    fill(rect, {0.0, 0.0, 0.0, share});
    cairo_restore(handle());
}

void Canvas::fill_circle(Point center, double radius, Color color) {
    trace_circle(handle(), center, radius);
    fill_path(color);
}

void Canvas::fill_circle(Point center, double radius, Point light, double reach,
                         std::span<const Stop> stops) {
    cairo_pattern_t* colors =
        cairo_pattern_create_radial(light.x, light.y, 0.0, light.x, light.y, reach);
    for (const auto& [share, its] : stops)
        cairo_pattern_add_color_stop_rgb(colors, share, its.red, its.green, its.blue);
    trace_circle(handle(), center, radius);
    implementation_->touch_path(1.0);
    cairo_set_source(handle(), colors);
    cairo_pattern_destroy(colors);  // the context keeps it
    cairo_fill(handle());
    check(cairo_status(handle()), "draw");
}

void Canvas::fill_circles(std::span<const Circle> circles, Rect clip) {
    clip_to(clip);
    for (const Circle& circle : circles) fill_circle(circle.center, circle.radius, circle.color);
    release_clip();
}

void Canvas::stroke_circle(Point center, double radius, double width, Color color) {
    set_ends(handle(), CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_ROUND);
    trace_circle(handle(), center, radius);
    stroke(width, color);
}

void Canvas::stroke_rect(Rect rect, double width, Color color) {
    set_ends(handle(), CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
    cairo_rectangle(handle(), rect.x, rect.y, rect.width, rect.height);
    stroke(width, color);
}

void Canvas::stroke_line(Point from, Point to, double width, Color color, double dash) {
    set_ends(handle(), CAIRO_LINE_CAP_BUTT, CAIRO_LINE_JOIN_MITER);
    cairo_set_dash(handle(), &dash, dash > 0.0 ? 1 : 0, 0.0);
    trace(handle(), std::array{from, to});
    stroke(width, color);
    cairo_set_dash(handle(), nullptr, 0, 0.0);
}

void Canvas::stroke_path(std::span<const Point> points, double width, Color color,
                         std::span<const double> dashes) {
    set_ends(handle(), dashes.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT,
             CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(handle(), dashes.data(), static_cast<int>(dashes.size()), 0.0);
    if (is_raster()) {
        // Cairo's time grows with the number of corners.
        const std::vector<Point> corners = simplified(points, cairo_get_tolerance(handle()));
        trace(handle(), corners);
        implementation_->touch_along(corners, 0.5 * width + 1.0);
    } else {
        trace(handle(), points);  // unsimplified, as it may be viewed at any size
    }
    stroke_untouched(width, color);
    cairo_set_dash(handle(), nullptr, 0, 0.0);
}

void Canvas::fill_polygon(std::span<const Point> points, Color color) {
    trace(handle(), points);
    cairo_close_path(handle());
    fill_path(color);
}

void Canvas::clip_to(Rect rect) {
    cairo_save(handle());
    cairo_rectangle(handle(), rect.x, rect.y, rect.width, rect.height);
    cairo_clip(handle());
    check(cairo_status(handle()), "draw");
}

void Canvas::release_clip() { cairo_restore(handle()); }

void Canvas::restore(const Canvas& ground) {
    const PixelView from = ground.pixels();
    const PixelView to = pixels();
    assert(from.width == to.width && from.height == to.height && from.stride == to.stride);
    Implementation& own = *implementation_;
    if (own.all_touched) own.touched = {{0, 0, to.width, to.height}};
    for (const PixelBounds& box : own.touched)
        for (int y = box.top; y < box.bottom; ++y) {
            const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(y) * to.stride + box.left;
            std::copy_n(from.data + start, box.right - box.left, to.data + start);
        }
    own.restored.swap(own.touched);
    own.touched.clear();
    own.all_touched = false;
    own.last_picture = std::exchange(own.picture, new_picture());
    pixels_changed();
}

std::uint64_t Canvas::picture() const { return implementation_->picture; }

std::optional<std::vector<PixelBounds>> Canvas::changes_since(std::uint64_t picture) const {
    const Implementation& own = *implementation_;
    if (picture == 0 || picture != own.last_picture || own.all_touched) return std::nullopt;
    std::vector<PixelBounds> boxes = own.restored;
    boxes.insert(boxes.end(), own.touched.begin(), own.touched.end());
    return boxes;
}

PixelView Canvas::pixels() { return implementation_->pixels(); }

PixelView Canvas::pixels() const { return implementation_->pixels(); }

void Canvas::pixels_changed() { cairo_surface_mark_dirty(implementation_->surface.get()); }

void end_page(Canvas& document) {
    assert(!document.is_raster());
    cairo_show_page(document.handle());
    check(cairo_status(document.handle()), "write a page");
}

std::vector<std::uint8_t> Canvas::png() const {
    assert(is_raster());
    std::vector<std::uint8_t> bytes;
    check(cairo_surface_write_to_png_stream(implementation_->surface.get(), append, &bytes),
          "encode a PNG");
    return with_resolution(std::move(bytes), implementation_->resolution);
}

std::vector<std::uint8_t> Canvas::file() {
    if (is_raster()) return with_words(png(), implementation_->words);
    cairo_surface_finish(implementation_->surface.get());
    check(cairo_surface_status(implementation_->surface.get()), "write the picture");
    if (implementation_->format == VectorFormat::svg)
        return finished_svg(implementation_->bytes, implementation_->words, implementation_->texts);
    return std::move(implementation_->bytes);
}

}  // namespace carom
