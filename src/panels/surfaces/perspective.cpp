#include "panels/surfaces/perspective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carom {
namespace {

// As a share of the distance of the eye: what is nearer to it, as the tip of an arrow may be, is
// taken to be there.
constexpr double nearest_to_eye = 0.1;

}  // namespace

Perspective::Perspective(const Viewpoint& from, const Region& box, Point origin, double scale)
    : box_(box), middle_(0.5 * (box.low + box.high)), origin_(origin), scale_(scale) {
    constexpr double degree = std::numbers::pi / 180.0;
    const double across = std::cos(from.turn * degree), deep = std::sin(from.turn * degree);
    const double level = std::cos(from.tilt * degree), high = std::sin(from.tilt * degree);
    right_ = {across, 0.0, deep};
    up_ = {high * deep, level, -high * across};
    toward_ = {-level * deep, high, level * across};
    const Vec size = box.high - box.low;
    distance_ = from.lens * length(size);
    half_depth_ = 0.5 * dot(abs(toward_), size);
    eye_ = middle_ + distance_ * toward_;
}

Perspective::Image Perspective::image(const Vec& place) const {
    const Vec off = place - middle_;
    const double left = std::max(distance_ - dot(off, toward_), nearest_to_eye * distance_);
    const double scale = scale_ * distance_ / left;
    return {{origin_.x + scale * dot(off, right_), origin_.y - scale * dot(off, up_)}, scale};
}

Point Perspective::velocity(const Vec& place, const Vec& of) const {
    const Vec off = place - middle_;
    const double left = std::max(distance_ - dot(off, toward_), nearest_to_eye * distance_);
    const double nearing = dot(of, toward_) / left;
    return {dot(of, right_) + nearing * dot(off, right_),
            -(dot(of, up_) + nearing * dot(off, up_))};
}

double Perspective::depth(const Vec& place) const {
    return std::clamp(0.5 - 0.5 * dot(place - middle_, toward_) / half_depth_, 0.0, 1.0);
}

Perspective Perspective::magnified(const Vec& middle, double zoom) const {
    const Point target = at(middle);
    Perspective other = *this;
    other.origin_ = {origin_.x + zoom * (origin_.x - target.x),
                     origin_.y + zoom * (origin_.y - target.y)};
    other.scale_ = zoom * scale_;
    return other;
}

std::vector<Vec> corners_of(const Region& region) {
    std::vector<Vec> corners;
    for (const double z : {region.low[2], region.high[2]})
        for (const double y : {region.low[1], region.high[1]})
            for (const double x : {region.low[0], region.high[0]}) corners.emplace_back(x, y, z);
    return corners;
}

Rect rect_around(const Region& box, std::span<const Viewpoint> viewpoints) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double left = infinite, top = infinite, right = -infinite, bottom = -infinite;
    const std::vector<Vec> corners = corners_of(box);
    for (const Viewpoint& from : viewpoints) {
        const Perspective seen(from, box, {}, 1.0);
        for (const Vec& corner : corners) {
            const Point at = seen.at(corner);
            left = std::min(left, at.x), right = std::max(right, at.x);
            top = std::min(top, at.y), bottom = std::max(bottom, at.y);
        }
    }
    return {left, top, right - left, bottom - top};
}

}  // namespace carom
