#include "panels/collision/velocity_plane.h"

#include <algorithm>
#include <array>

namespace carom {

Point VelocityPlane::operator()(const Eigen::Array2d& velocity) const {
    const Eigen::Array2d v = scale * factor * velocity;
    return {area.x + area.width / 2 + v[0], area.y + area.height / 2 - v[1]};
}

Scale VelocityPlane::across() const {
    const double end = area.width / 2 / scale;
    return {-end, end, area.x, area.right()};
}

Scale VelocityPlane::up() const {
    const double end = area.height / 2 / scale;
    return {-end, end, area.bottom(), area.y};
}

void VelocityPlane::draw_line(Canvas& canvas, const Eigen::Array2d& through,
                              const Eigen::Array2d& direction, double width, Color color,
                              std::span<const double> dashes) const {
    const Eigen::Array2d step =
        direction * ((area.width + area.height) / scale / (factor * direction).abs().maxCoeff());
    const std::array line{(*this)(through - step), (*this)(through + step)};
    canvas.clip_to(area);
    canvas.stroke_path(line, width, color, dashes);
    canvas.release_clip();
}

double scale_in(const Rect& area, const Eigen::Array2d& reach) {
    constexpr double beyond = 1.08;  // of the largest velocities
    return std::min(area.width / (2.0 * beyond * reach[0]),
                    area.height / (2.0 * beyond * reach[1]));
}

}  // namespace carom
