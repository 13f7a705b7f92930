#include "panels/echo/echo_record.h"

#include <algorithm>
#include <cmath>

#include "physics/reversal/precision.h"
#include "scene/scene.h"

namespace carom {
namespace {

constexpr double most_kept = 256e6;  // bytes of coordinates

int bits_of(const Run& run) { return run.bits.value_or(bits_of_double); }

// The bytes of one coordinate; a number with many bits has a header and a memory block of its own.
double bytes_of(int bits) { return bits > bits_of_double ? 64.0 + bits / 8.0 : 8.0; }

int stride_of(const Scene& scene, Eigen::Index particles, int frames) {
    const double bytes =
        static_cast<double>(particles) * scene.gas.box.dimension * bytes_of(bits_of(scene.run));
    return std::max(1, static_cast<int>(std::ceil(bytes * frames / most_kept)));
}

std::optional<double> known(const Law& law) {
    return law ? std::optional(law.value) : std::nullopt;
}

bool is_kept(const Tick& tick, int stride, const std::vector<double>& reversals, double end) {
    return tick.frame % stride == 0 || tick.time == end ||
           std::ranges::binary_search(reversals, tick.time);
}

}  // namespace

std::vector<double> return_times(const Scene& scene, Eigen::Index particles,
                                 const std::vector<Tick>& ticks) {
    const std::vector<double> reversals = reversal_times(scene.run);
    const int stride = stride_of(scene, particles, static_cast<int>(ticks.size()));
    std::vector<double> times;
    for (const Tick& tick : ticks)
        if (is_kept(tick, stride, reversals, scene.run.until)) times.push_back(tick.time);
    return times;
}

EchoRecord::EchoRecord(const PanelContext& context)
    : context_(context),
      reversals_(reversal_times(context.run())),
      bits_per_collision_(known(law(context.gas, LawOf::error_growth))),
      stride_(stride_of(context.scene, context.particles.count(), context.frames)) {}

void EchoRecord::survey(const FrameInput& input) {
    const double time = input.tick.time;
    const auto passed = std::ranges::upper_bound(reversals_, time) - reversals_.begin();
    if (passed == 0) return;
    const auto reversal = static_cast<std::size_t>(passed) - 1;
    const double since = time - reversals_[reversal];
    const std::int64_t collisions = input.advanced.counts.particle;
    while (collisions_until_.size() <= reversal) collisions_until_.push_back(collisions);
    const bool stands_still =
        !steps_.empty() && steps_.back().reversal == reversal && steps_.back().since == since;
    if (stands_still || !is_kept(input.tick, stride_, reversals_, context_.run().until)) return;
    const double of_each = 2.0 * static_cast<double>(collisions - collisions_until_[reversal]) /
                           static_cast<double>(context_.particles.count());
    const std::optional<ReturnDistance>& distance = input.advanced.return_distance;
    Step step{input.tick.frame,    reversal, since, of_each, distance.value_or(ReturnDistance{}),
              distance.has_value()};
    if (bits_per_collision_) step.log10_law = log10_law(step);
    steps_.push_back(step);
}

// The law starts from the round-off of coordinates of the size of the box, and from the
// perturbations.
double EchoRecord::log10_law(const Step& step) const {
    const double digits = std::log10(2.0);
    double law = std::log10(context_.box().longest_side()) - bits_of(context_.run()) * digits;
    double collisions = 0.0, before = -1.0;
    if (!steps_.empty() && steps_.back().reversal == step.reversal) {
        law = steps_.back().log10_law;
        collisions = steps_.back().collisions;
        before = steps_.back().since;
    }
    law += (step.collisions - collisions) * *bits_per_collision_ * digits;
    for (const RunEvent& event : context_.run().events) {
        const auto* perturbation = perturbation_of(event);
        const double since = event.at - reversals_[step.reversal];
        if (perturbation && since > before && since >= 0.0 && since <= step.since)
            law = std::max(law, moved_by({*perturbation}, 1).log10_largest);
    }
    return law;
}

std::size_t EchoRecord::shown(int frame) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(steps_, frame, {}, &Step::frame) -
                                    steps_.begin());
}

std::optional<ReturnDistance> EchoRecord::at(int frame) const {
    const std::size_t count = shown(frame);
    if (count == 0 || !steps_[count - 1].is_known) return std::nullopt;
    return steps_[count - 1].apart;
}

}  // namespace carom
