#include "panels/callouts/scrim.h"

#include "scene/time/pace.h"

namespace carom {

void fill_around(Canvas& canvas, const Rect& all, const Rect& area, Color color) {
    canvas.fill({all.x, all.y, all.width, area.y - all.y}, color);
    canvas.fill({all.x, area.bottom(), all.width, all.bottom() - area.bottom()}, color);
    canvas.fill({all.x, area.y, area.x - all.x, area.height}, color);
    canvas.fill({area.right(), area.y, all.right() - area.right(), area.height}, color);
}

void draw_scrim(Canvas& canvas, const Rect& area, double feather, Color color) {
    constexpr int rings = 12;
    const double step = feather / rings;
    const auto ring = [&](int k) {
        const double in = k * step;
        return Rect{area.x + in, area.y + in, area.width - 2.0 * in, area.height - 2.0 * in};
    };
    for (int k = 0; k < rings; ++k) {
        const double share = (k + 0.5) / rings;
        const Color thin = with_alpha(color, color.alpha * smooth(share));
        fill_around(canvas, ring(k), ring(k + 1), thin);
    }
    canvas.fill(ring(rings), color);
}

}  // namespace carom
