// The perspective of a box in space: a pure function from places in the box to the picture. The
// picture plane goes through the middle of the box, across the line to the eye; a length that lies
// in it has the same size from every viewpoint.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "draw/geometry.h"
#include "physics/box.h"
#include "scene/film.h"

namespace carom {

class Perspective {
  public:
    /// Where something appears, and how large: pixels for each unit of length at its depth.
    struct Image {
        Point at;
        double scale = 1.0;
    };

    /// `origin`: the place of the middle of the box in the picture; `scale`: pixels for each unit
    /// of length there.
    Perspective(const Viewpoint& from, const Region& box, Point origin, double scale);

    /// The image of a place. Of a sphere, a disk around it with the radius times the scale is taken
    /// for the image. Exactly, that is an ellipse, which at an angle a from the line of sight is
    /// longer by 1/cos a: less than 4 % with the usual lens, 16 % with the shortest.
    Image image(const Vec& place) const;
    Point at(const Vec& place) const { return image(place).at; }

    /// The direction in which something moves in the picture (y down), and how fast in units of
    /// length at its depth, if it is at this place with this velocity.
    Point velocity(const Vec& place, const Vec& of) const;

    /// The power of the eye with respect to a sphere: |eye - center|^2 - radius^2. Of two spheres
    /// that do not overlap, the one with the smaller power is in front wherever both are seen:
    /// their radical plane, on which the powers are equal, separates them.
    double power(const Vec& center, double radius) const {
        return square(eye_ - center) - radius * radius;
    }

    const Vec& eye() const { return eye_; }
    Point origin() const { return origin_; }

    /// Whether the eye is beyond a plane across an axis, on the side to which the axis grows.
    bool is_beyond(std::size_t axis, double place) const { return eye_[axis] > place; }

    /// How far back something is, from 0 at the part of the box that is nearest to the picture's
    /// viewer to 1 at the farthest.
    double depth(const Vec& place) const;

    /// The same place in the picture, from another viewpoint.
    Perspective seen_from(const Viewpoint& from) const { return {from, box_, origin_, scale_}; }

    /// The same picture, magnified so that `middle` appears where the middle of the box did.
    Perspective magnified(const Vec& middle, double zoom) const;

  private:
    Region box_;
    Vec middle_, right_, up_, toward_, eye_;
    double distance_, half_depth_;
    Point origin_;
    double scale_;
};

/// The corners of a region.
std::vector<Vec> corners_of(const Region& region);

/// The smallest rectangle that holds the pictures of a box from all these viewpoints, with one
/// pixel for each unit of length and the middle of the box at the origin.
Rect rect_around(const Region& box, std::span<const Viewpoint> viewpoints);

}  // namespace carom
