// A surface to draw on: pixels, or (by the same calls) SVG and PDF. The one door to Cairo.
// Lengths are pixels, y down: in SVG one user unit each, in PDF three quarters of a point (96 to
// the inch). Knows nothing of gases.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "draw/color.h"
#include "draw/geometry.h"

// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is Cairo's
struct _cairo;  // what Cairo's handle points to, so that text.cpp can set text on a canvas

namespace carom {

/// Pixels 0xAARRGGBB, colours already multiplied by alpha, in native byte order (B, G, R, A in
/// memory on little-endian machines).
struct PixelView {
    std::uint32_t* data = nullptr;
    int width = 0, height = 0;
    int stride = 0;      ///< pixels from one row to the next
    bool opaque = true;  ///< alpha is 255 everywhere, or without a meaning
};

enum class VectorFormat { svg, pdf };

/// What a picture is, for those who cannot see it and for catalogues.
struct PictureWords {
    std::string title;
    std::string description;
    std::string origin = {};  ///< what it was made from, for those who want to make it again
};

struct Circle {
    Point center;
    double radius = 0;
    Color color;
};

/// The library that draws, with its version.
std::string drawing_library();

enum class Backdrop { black, transparent };

class Canvas {
  public:
    /// A raster that is black all over and stays opaque, or is transparent at first, 1 to 16384
    /// pixels each way. Throws SystemError when there is no memory or the size is out of these
    /// bounds; so does every drawing call that Cairo refuses.
    explicit Canvas(PixelSize size, Backdrop backdrop = Backdrop::black);

    /// An empty page of a vector document, within the same bounds.
    Canvas(PixelSize size, VectorFormat format, PictureWords words);

    ~Canvas();
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;

    /// What file() says of a raster.
    void describe(PictureWords words);

    PixelSize size() const;
    bool is_raster() const;

    void fill_all(Color color);
    void fill(Rect rect, Color color);
    void fill_circle(Point center, double radius, Color color);

    /// In order, later ones over earlier ones; cut at `clip`, and at what clip_to() has asked for.
    void fill_circles(std::span<const Circle> circles, Rect clip);

    void stroke_circle(Point center, double radius, double width, Color color);
    void stroke_rect(Rect rect, double width,
                     Color color);  ///< the line lies on the edge, half of it on each side
    void stroke_line(Point from, Point to, double width, Color color,
                     double dash = 0.0);  ///< dash and gap; 0: solid
    void stroke_path(std::span<const Point> points, double width, Color color,
                     std::span<const double> dashes = {});  ///< line, gap, ...; none: solid, with
                                                            ///< round joins and caps
    void fill_polygon(std::span<const Point> points, Color color);
    void clip_to(Rect rect);  ///< until its release_clip(); the inner of two cuts what is left
    void release_clip();

    /// Makes this raster the same as `ground`, of the same size: copies what has been drawn on
    /// since it last was so, or everything if it never was.
    void restore(const Canvas& ground);

    /// The number of the present picture, which lasts until the next restore(). No other picture of
    /// this process has it; 0 is none's.
    std::uint64_t picture() const;

    /// Boxes outside of which the pixels are those of an earlier picture of this raster. Nothing
    /// where that is not known: of other pictures than the last one.
    std::optional<std::vector<PixelBounds>> changes_since(std::uint64_t picture) const;

    /// Tells of pixels written other than by the calls above.
    void touch(Rect rect);

    /// The pixels, after all drawing so far; pixels_changed() and touch() must follow own writes.
    /// Raster only.
    PixelView pixels();
    PixelView pixels() const;  ///< to read
    void pixels_changed();

    /// The pixels as a PNG file in memory. Raster only. Throws SystemError.
    std::vector<std::uint8_t> png() const;

    /// The picture as a file in memory: a PNG of a raster, otherwise the document, the same bytes
    /// for the same drawing. A document is ended by it and takes no more drawing. Throws
    /// SystemError.
    std::vector<std::uint8_t> file();

    /// Cairo's own handle, for text.cpp only.
    _cairo* handle() const;

  private:
    void fill_path(Color color);
    void stroke(double width, Color color);
    void stroke_untouched(double width, Color color);  ///< what it touches is told already

    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
