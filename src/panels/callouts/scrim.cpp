#include "panels/callouts/scrim.h"

#include "scene/time/pace.h"

namespace carom {

void cover_around(const Rect& all, const Rect& area,
                  const std::function<void(const Rect&)>& cover) {
    cover({all.x, all.y, all.width, area.y - all.y});
    cover({all.x, area.bottom(), all.width, all.bottom() - area.bottom()});
    cover({all.x, area.y, area.x - all.x, area.height});
    cover({area.right(), area.y, all.right() - area.right(), area.height});
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
        cover_around(ring(k), ring(k + 1), [&](const Rect& part) { canvas.fill(part, thin); });
    }
    canvas.fill(ring(rings), color);
}

}  // namespace carom
