// A surface to draw on: pixels or, with the same calls, SVG and PDF. The only interface to Cairo.
// Lengths are pixels, y down: in SVG one pixel is one user unit, in PDF three quarters of a point
// (96 pixels per inch). A PNG says the same unless another resolution is set. Independent of gases.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "draw/color.h"
#include "draw/fonts/written_text.h"
#include "draw/geometry.h"

// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is Cairo's
struct _cairo;  // what Cairo's handle points to, so that text.cpp can set text on a canvas

namespace carom {

/// Pixels 0xAARRGGBB, with colours premultiplied by alpha, in native byte order (B, G, R, A in
/// memory on little-endian machines).
struct PixelView {
    std::uint32_t* data = nullptr;
    int width = 0, height = 0;
    int stride = 0;      ///< pixels from one row to the next
    bool opaque = true;  ///< alpha is 255 everywhere or has no meaning
};

enum class VectorFormat { svg, pdf };

/// A description of a picture, for viewers who cannot see it and for catalogues.
struct PictureWords {
    std::string title;
    std::string description;
    std::string origin = {};  ///< what it was made from, so that it can be reproduced
};

struct Circle {
    Point center;
    double radius = 0;
    Color color;
};

/// The name and version of the drawing library.
std::string drawing_library();

enum class Backdrop { black, transparent };

class Canvas {
  public:
    /// A raster of 1 to 16384 pixels each way, at first black (and always opaque) or transparent.
    /// Throws SystemError if there is no memory or the size is out of these bounds; so does every
    /// drawing call that Cairo refuses.
    explicit Canvas(PixelSize size, Backdrop backdrop = Backdrop::black);

    /// An empty page of a vector document, within the same bounds.
    Canvas(PixelSize size, VectorFormat format, PictureWords words);

    ~Canvas();
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;

    /// Sets the description that file() stores with a raster.
    void describe(PictureWords words);

    /// Sets the resolution of a raster, which its PNG states: 96 dots per inch if it is not called.
    void set_resolution(double dots_per_inch);

    /// Whether an SVG keeps its words as text, with the names of their fonts, instead of the
    /// outlines of the letters: from then on.
    void keep_text(bool kept);
    bool keeps_text() const;

    /// Writes a line of text into an SVG that keeps text.
    void write(WrittenText text);

    PixelSize size() const;
    bool is_raster() const;

    void fill_all(Color color);
    void fill(Rect rect, Color color);
    /// Takes a share, from 0 to 1, of all that has been drawn in a rectangle away.
    void fade(Rect rect, double share);
    void fill_circle(Point center, double radius, Color color);

    /// Fills it with colours that depend on the distance from a point in it: those at these shares
    /// of `reach`, in ascending order, and mixtures between them.
    struct Stop {
        double share;
        Color color;
    };
    void fill_circle(Point center, double radius, Point light, double reach,
                     std::span<const Stop> stops);

    /// Draws in order, later circles over earlier ones, clipped to `clip` and to the clips of
    /// clip_to().
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
    void clip_to(Rect rect);  ///< until the matching release_clip(); nested clips intersect
    void release_clip();

    /// Makes this raster equal to `ground`, which must have the same size: copies the regions drawn
    /// on since it last equalled `ground`, or everything if it never did.
    void restore(const Canvas& ground);

    /// The number of the present picture, which ends with the next restore(). It is unique in this
    /// process; 0 is never used.
    std::uint64_t picture() const;

    /// Boxes outside of which the pixels equal those of an earlier `picture` of this raster. None
    /// if they are not known: only the last picture before the present one is remembered.
    std::optional<std::vector<PixelBounds>> changes_since(std::uint64_t picture) const;

    /// Marks pixels as drawn on that were written other than by the calls above.
    void touch(Rect rect);

    /// The pixels, after all drawing so far; after writing to them call pixels_changed() and
    /// touch(). Raster only.
    PixelView pixels();
    PixelView pixels() const;  ///< for reading
    void pixels_changed();

    /// The pixels as a PNG file in memory. Raster only. Throws SystemError.
    std::vector<std::uint8_t> png() const;

    /// The picture as a file in memory: a PNG for a raster, otherwise the document; the same
    /// drawing gives the same bytes. This ends a document, which accepts no more drawing. Throws
    /// SystemError.
    std::vector<std::uint8_t> file();

    /// Cairo's own handle, for text.cpp only.
    _cairo* handle() const;

  private:
    void fill_path(Color color);
    void stroke(double width, Color color);
    void stroke_untouched(double width, Color color);  ///< the caller has marked the pixels

    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
