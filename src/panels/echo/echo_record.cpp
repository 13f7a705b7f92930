#include "panels/echo/echo_record.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "physics/reversal/echo.h"
#include "physics/theory/error_growth.h"
#include "util/interrupt.h"

namespace carom {
namespace {

constexpr double most_kept = 256e6;  // bytes of coordinates

// Of one coordinate; a number of many bits has a header, and a block of memory of its own.
double bytes_of(int bits) { return bits > bits_of_double ? 64.0 + bits / 8.0 : 8.0; }

}  // namespace

EchoRecord::EchoRecord(const PanelContext& context)
    : context_(context),
      reversals_(reversal_times(context.scene.run)),
      bits_per_collision_(bits_lost_per_collision(context.scene.gas.box, context.particles)) {
    const int bits = context.scene.run.bits.value_or(bits_of_double);
    in_full_ = bits > bits_of_double;
    const double bytes = static_cast<double>(context.particles.count()) *
                         context.scene.gas.box.dimension * bytes_of(bits);
    stride_ = std::max(1, static_cast<int>(std::ceil(bytes * context.frames / most_kept)));
}

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
    const bool is_kept =
        input.tick.frame % stride_ == 0 || since == 0.0 || time == context_.scene.run.until;
    if (stands_still || !is_kept) return;
    const double before = reversal > 0 ? reversals_[reversal - 1] : 0.0;
    const double rounding = 1e-12 * reversals_[reversal];
    const double mirror = reversals_[reversal] - since;
    const bool is_known = mirror >= before - rounding;
    const double of_each = 2.0 * static_cast<double>(collisions - collisions_until_[reversal]) /
                           static_cast<double>(context_.particles.count());
    steps_.push_back({input.tick.frame, reversal, since, of_each, {}, is_known});
    kept_.push_back({std::max(mirror, before), {}, {}});
    if (is_known && !in_full_) kept_.back().position = input.sample.position;
}

// Both ways once more, to compare all bits: samples have no more than those of a double.
void EchoRecord::compare_in_full() {
    struct Moment {
        double time;
        bool is_back;
        std::size_t step;
    };
    std::vector<Moment> moments;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        if (!steps_[k].is_known) continue;
        moments.push_back({kept_[k].time, false, k});
        moments.push_back({reversals_[steps_[k].reversal] + steps_[k].since, true, k});
    }
    std::ranges::stable_sort(moments, [](const Moment& a, const Moment& b) {
        return a.time != b.time ? a.time < b.time : a.is_back < b.is_back;
    });
    Simulation both_ways(context_.scene.gas, context_.scene.run);
    std::map<std::size_t, ExactPositions> out;
    for (const Moment& moment : moments) {
        throw_if_interrupted();
        both_ways.advance_to(moment.time);
        if (!moment.is_back) {
            out.emplace(moment.step, both_ways.exact_positions());
            continue;
        }
        const auto mirror = out.find(moment.step);
        steps_[moment.step].apart = return_distance(mirror->second, both_ways.exact_positions());
        out.erase(mirror);
    }
}

void EchoRecord::settle() {
    if (in_full_)
        compare_in_full();
    else
        compare();
    begin_at_perturbations();
    apply_law();
}

std::vector<Perturbation> EchoRecord::perturbations_at(double time) const {
    std::vector<Perturbation> perturbations;
    for (const RunEvent& event : context_.scene.run.events)
        if (const auto* perturbation = std::get_if<Perturbation>(&event.action);
            perturbation && event.at == time)
            perturbations.push_back(*perturbation);
    return perturbations;
}

// At the instant of a reversal both ways are one state, but for the perturbations of that instant.
void EchoRecord::begin_at_perturbations() {
    for (Step& step : steps_) {
        if (!step.is_known || step.since > 0.0) continue;
        const std::vector<Perturbation> perturbations = perturbations_at(reversals_[step.reversal]);
        if (!perturbations.empty())
            step.apart = moved_by(perturbations, context_.particles.count());
    }
}

// From the round-off of coordinates as large as the box, and from the perturbations.
void EchoRecord::apply_law() {
    if (!bits_per_collision_) return;
    const double digits = std::log10(2.0);
    const int bits = context_.scene.run.bits.value_or(bits_of_double);
    const double round_off = std::log10(context_.scene.gas.box.size.maxCoeff()) - bits * digits;
    double law = 0.0, collisions = 0.0, before = 0.0;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        Step& step = steps_[k];
        if (k == 0 || step.reversal != steps_[k - 1].reversal) {
            law = round_off;
            collisions = 0.0;
            before = -1.0;
        }
        law += (step.collisions - collisions) * *bits_per_collision_ * digits;
        collisions = step.collisions;
        for (const RunEvent& event : context_.scene.run.events) {
            const auto* perturbation = std::get_if<Perturbation>(&event.action);
            const double since = event.at - reversals_[step.reversal];
            if (perturbation && since > before && since >= 0.0 && since <= step.since)
                law = std::max(law, moved_by({*perturbation}, 1).log10_largest);
        }
        before = step.since;
        step.log10_law = law;
    }
}

void EchoRecord::compare() {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < steps_.size(); ++k)
        if (steps_[k].is_known) order.push_back(k);
    if (order.empty()) return;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return kept_[k].time; });
    Simulation way_out(context_.scene.gas, context_.scene.run);
    for (const std::size_t k : order) {
        throw_if_interrupted();
        way_out.advance_to(kept_[k].time);
        steps_[k].apart = return_distance(context_.scene.gas.box, way_out.sample(), kept_[k]);
    }
    kept_ = {};
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
