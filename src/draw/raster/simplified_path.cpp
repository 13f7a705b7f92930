#include "draw/raster/simplified_path.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

struct Direction {
    double x = 0, y = 0;  ///< of length 1
};

double cross(const Direction& a, const Direction& b) { return a.x * b.y - a.y * b.x; }

// The cone of straight lines from a point that pass all points so far within the tolerance.
class Cone {
  public:
    Cone(Point apex, double tolerance) : apex_(apex), tolerance_(tolerance) {}

    /// Whether a line that ends at this point passes all earlier points within the tolerance; if
    /// so, the point is added to them.
    bool reaches(const Point& to) {
        const double dx = to.x - apex_.x, dy = to.y - apex_.y;
        const double distance = std::sqrt(dx * dx + dy * dy);
        if (farthest_ > distance) return false;
        if (!(distance > tolerance_)) return true;
        const Direction along{dx / distance, dy / distance};
        const double sine = tolerance_ / distance, cosine = std::sqrt(1.0 - sine * sine);
        const Direction right{along.x * cosine + along.y * sine, along.y * cosine - along.x * sine};
        const Direction left{along.x * cosine - along.y * sine, along.y * cosine + along.x * sine};
        if (farthest_ == 0.0) {
            right_ = right;
            left_ = left;
        } else {
            const bool is_behind = along.x * right_.x + along.y * right_.y <= 0.0;
            if (is_behind || cross(right_, along) < 0.0 || cross(along, left_) < 0.0) return false;
            if (cross(right_, right) > 0.0) right_ = right;
            if (cross(left, left_) > 0.0) left_ = left;
        }
        farthest_ = std::max(farthest_, distance);
        return true;
    }

  private:
    Point apex_;
    double tolerance_;
    double farthest_ = 0.0;  ///< largest distance of a point; 0: all lie at the apex
    Direction right_, left_;
};

}  // namespace

std::vector<Point> simplified(std::span<const Point> path, double tolerance) {
    std::vector<Point> left;
    if (path.empty()) return left;
    left.push_back(path.front());
    Cone cone(path.front(), tolerance);
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (cone.reaches(path[i])) continue;
        left.push_back(path[i - 1]);
        cone = Cone(path[i - 1], tolerance);
        cone.reaches(path[i]);
    }
    if (path.size() > 1) left.push_back(path.back());
    return left;
}

}  // namespace carom
