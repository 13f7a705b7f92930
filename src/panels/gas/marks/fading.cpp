#include "panels/gas/marks/fading.h"

#include <algorithm>
#include <cmath>

#include "scene/film.h"

namespace carom {

void Fading::see(const Tick& tick, const Eigen::ArrayXXd& position, std::vector<float>& light) {
    constexpr double trace = 0.12;  // what is left of a colour
    const std::optional<FadeOut>& fade = context_.film().fade_out;
    if (!fade || !context_.in_film) return;
    const auto count = static_cast<std::size_t>(position.rows());
    since_.resize(count, NAN);
    if (light.empty()) light.assign(count, 1.0f);
    for (std::size_t i = 0; i < count; ++i) {
        bool is_in = true;
        for (Eigen::Index axis = 0; axis < position.cols(); ++axis) {
            const double at = position(static_cast<Eigen::Index>(i), axis);
            is_in = is_in && at >= fade->within.low[axis] && at <= fade->within.high[axis];
        }
        if (!is_in) {
            since_[i] = NAN;
            continue;
        }
        if (std::isnan(since_[i])) since_[i] = tick.seconds;
        const double share = std::min(1.0, (tick.seconds - since_[i]) / fade->seconds);
        light[i] *= static_cast<float>(1.0 - (1.0 - trace) * share);
    }
}

}  // namespace carom
