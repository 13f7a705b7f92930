#include "panels/callouts/scrim.h"

#include "scene/time/pace.h"

namespace carom {

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
        const Rect outer = ring(k), inner = ring(k + 1);
        canvas.fill({outer.x, outer.y, outer.width, inner.y - outer.y}, thin);
        canvas.fill({outer.x, inner.bottom(), outer.width, outer.bottom() - inner.bottom()}, thin);
        canvas.fill({outer.x, inner.y, inner.x - outer.x, inner.height}, thin);
        canvas.fill({inner.right(), inner.y, outer.right() - inner.right(), inner.height}, thin);
    }
    canvas.fill(ring(rings), color);
}

}  // namespace carom
