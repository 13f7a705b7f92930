#include "panels/callouts/fade.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

int within(double at, int most) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, double(most)));
}

}  // namespace

Fade::Fade(Canvas& canvas, const Rect& area)
    : canvas_(canvas),
      left_(within(area.x, canvas.size().width)),
      top_(within(area.y, canvas.size().height)),
      right_(within(area.right(), canvas.size().width)),
      bottom_(within(area.bottom(), canvas.size().height)) {
    const PixelView pixels = canvas.pixels();
    for (int y = top_; y < bottom_; ++y) {
        const std::uint32_t* row = pixels.data + std::ptrdiff_t{y} * pixels.stride;
        before_.insert(before_.end(), row + left_, row + right_);
    }
}

void Fade::leave(double share) {
    const PixelView pixels = canvas_.pixels();
    const auto weight = static_cast<std::uint32_t>(std::lround(256.0 * share));
    auto before = before_.begin();
    for (int y = top_; y < bottom_; ++y)
        for (int x = left_; x < right_; ++x, ++before) {
            std::uint32_t& pixel = pixels.data[std::ptrdiff_t{y} * pixels.stride + x];
            std::uint32_t mixed = 0;
            for (int shift = 0; shift < 32; shift += 8) {
                const std::uint32_t old = *before >> shift & 0xFF, now = pixel >> shift & 0xFF;
                mixed |= (old * (256 - weight) + now * weight + 128) / 256 << shift;
            }
            pixel = mixed;
        }
    canvas_.pixels_changed();
}

}  // namespace carom
