// A round dial with ticks, numbers and a needle; values increase clockwise from its start to its
// end.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "draw/axis.h"
#include "panels/dials/dial_panel.h"

namespace carom {

/// The shape of a dial: the angle of its scale, and how much of the circle its plate covers.
struct DialShape {
    double start = 0.0;  ///< degrees clockwise from the top, of the scale's lower end
    double sweep = 0.0;  ///< degrees
    double depth = 2.0;  ///< height of the plate in radii: 2 for a full circle

    double degrees(double share) const { return start + share * sweep; }
};

/// An instrument's: open below.
inline constexpr DialShape gauge_shape{.start = -120.0, .sweep = 240.0, .depth = 1.62};

/// A watch's: once around from the top.
inline constexpr DialShape watch_shape{.start = 0.0, .sweep = 360.0, .depth = 2.0};

/// A dial in a face, as large as fits.
class RoundDial {
  public:
    RoundDial(const DrawContext& dc, const Rect& face, const DialShape& shape);

    /// Plate, ticks and numbers of a scale.
    void draw_face(Canvas& canvas, const DialScale& scale, Language language) const;

    /// An arc outside of the ticks, between two shares of the scale.
    void draw_band(Canvas& canvas, const std::array<double, 2>& shares, Color color) const;

    /// The needle at a share of the scale.
    void draw_needle(Canvas& canvas, double share, Color color) const;

    Point center() const { return center_; }
    double radius() const { return radius_; }

    /// The point at a share of the scale, at a distance of `radii` radii from the centre.
    Point at(double share, double radii) const;

  private:
    void draw_plate(Canvas& canvas) const;
    Rect rect_of(const TickMark& mark, const DialScale& scale) const;
    std::vector<TickMark> marks(const DialScale& scale, Language language) const;

    const DrawContext& dc_;
    DialShape shape_;
    Point center_;
    double radius_;
};

}  // namespace carom
