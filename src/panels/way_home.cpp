#include "panels/way_home.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "util/interrupt.h"

namespace carom {
namespace {

constexpr double most_kept = 32e6;  // coordinates: a quarter of a gigabyte

}  // namespace

WayHome::WayHome(const Cast& cast) : cast_(cast) {
    for (const RunEvent& event : cast.scene.run.events)
        if (std::holds_alternative<ReverseVelocities>(event.action)) reversals_.push_back(event.at);
    const double coordinates =
        static_cast<double>(cast.particles.count()) * cast.scene.gas.box.dimension;
    stride_ = std::max(1, static_cast<int>(std::ceil(coordinates * cast.frames / most_kept)));
}

void WayHome::survey(const Observation& observation) {
    const double time = observation.tick.time;
    const auto passed = std::ranges::upper_bound(reversals_, time) - reversals_.begin();
    if (passed == 0) return;
    const auto reversal = static_cast<std::size_t>(passed) - 1;
    const double since = time - reversals_[reversal];
    const bool stands_still =
        !steps_.empty() && steps_.back().reversal == reversal && steps_.back().since == since;
    const bool is_kept =
        observation.tick.frame % stride_ == 0 || since == 0.0 || time == cast_.scene.run.until;
    if (stands_still || !is_kept) return;
    const double before = reversal > 0 ? reversals_[reversal - 1] : 0.0;
    const double rounding = 1e-12 * reversals_[reversal];
    const double mirror = reversals_[reversal] - since;
    const bool is_known = mirror >= before - rounding;
    steps_.push_back({observation.tick.frame, reversal, since, {}, is_known});
    kept_.push_back({std::max(mirror, before), {}, {}});
    if (is_known) kept_.back().position = observation.sample.position;
}

void WayHome::settle() {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < steps_.size(); ++k)
        if (steps_[k].is_known) order.push_back(k);
    if (order.empty()) return;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return kept_[k].time; });
    Simulation way_out(cast_.scene.gas, cast_.scene.run);
    for (const std::size_t k : order) {
        throw_if_interrupted();
        way_out.advance_to(kept_[k].time);
        steps_[k].apart = return_distance(cast_.scene.gas.box, way_out.sample(), kept_[k]);
    }
    kept_ = {};
}

std::size_t WayHome::shown(int frame) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(steps_, frame, {}, &Step::frame) -
                                    steps_.begin());
}

std::optional<ReturnDistance> WayHome::at(int frame) const {
    const std::size_t count = shown(frame);
    if (count == 0 || !steps_[count - 1].is_known) return std::nullopt;
    return steps_[count - 1].apart;
}

}  // namespace carom
