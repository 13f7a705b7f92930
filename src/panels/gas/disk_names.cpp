#include "panels/gas/disk_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carom {
namespace {

// The place inside the box: above the disk if there is room, else below it, else on it.
Point usual_foot(const Rect& box, const Rect& disk, double half, double u) {
    const double center = disk.x + disk.width / 2;
    Point foot{std::max(box.x + half, std::min(center, box.right() - half)), disk.y - 0.7 * u};
    if (foot.y - 1.2 * u < box.y) foot.y = disk.bottom() + 1.7 * u;
    if (foot.y + 0.4 * u > box.bottom())
        foot.y =
            std::max(box.y + 1.2 * u, std::min(disk.y + disk.height / 2, box.bottom() - 0.4 * u));
    return foot;
}

// The number of disks under a name, without its own.
int disks_under(const std::vector<Disk>& disks, const Rect& name, const Rect& own) {
    int under = 0;
    for (const Disk& disk : disks) {
        const double x = static_cast<double>(disk.x), y = static_cast<double>(disk.y);
        if (std::hypot(x - own.x - own.width / 2, y - own.y - own.height / 2) < own.width / 2)
            continue;
        const double across = x - std::clamp(x, name.x, name.right());
        const double up = y - std::clamp(y, name.y, name.bottom());
        under += std::hypot(across, up) < static_cast<double>(disk.radius);
    }
    return under;
}

// In a still picture a name may keep clear of the disks around it: of the places around its own
// disk, starting above, the first that covers the fewest disks.
Point free_foot(const Rect& box, const Rect& disk, double half, double u,
                const std::vector<Disk>& disks) {
    constexpr int directions = 24;
    const double high = 1.4 * u, wide = 2.0 * half - 0.4 * u;
    Point best = usual_foot(box, disk, half, u);
    int least = std::numeric_limits<int>::max();
    for (int k = 0; k < 2 * directions; ++k) {
        const int step = k % directions;  // to the right and to the left in turn
        const double turn = step % 2 == 0 ? 0.5 * step : -0.5 * (step + 1);
        const double angle = 2.0 * std::numbers::pi * turn / directions;
        const double x = std::sin(angle), y = -std::cos(angle);
        const double gap = (k < directions ? 0.2 : 0.8) * u + disk.width / 2;
        const double away = std::min((gap + 0.5 * wide) / std::max(1e-9, std::abs(x)),
                                     (gap + 0.5 * high) / std::max(1e-9, std::abs(y)));
        const Rect name{disk.x + disk.width / 2 + away * x - 0.5 * wide,
                        disk.y + disk.height / 2 + away * y - 0.5 * high, wide, high};
        if (name.x < box.x || name.y < box.y || name.right() > box.right() ||
            name.bottom() > box.bottom())
            continue;
        const int under = disks_under(disks, name, disk);
        if (under >= least) continue;
        least = under;
        best = {name.x + 0.5 * wide, name.y + 1.1 * u};
    }
    return best;
}

}  // namespace

void draw_name(Canvas& canvas, const DrawContext& dc, const Rect& box, const Rect& disk,
               const std::string& markup, double alpha, const std::vector<Disk>* disks) {
    const double u = dc.unit;
    TextStyle style = title_style(dc);
    style.align = Align::center;
    style.color = with_alpha(dc.theme.ink, alpha);
    style.max_width = box.width - 0.8 * u;
    style.halo = 0.16 * u;
    style.behind = with_alpha(dc.theme.ground, alpha);
    const double half = measure_text(markup, style).width / 2 + 0.4 * u;
    const Point foot =
        disks == nullptr ? usual_foot(box, disk, half, u) : free_foot(box, disk, half, u, *disks);
    draw_text(canvas, foot, markup, style);
}

}  // namespace carom
