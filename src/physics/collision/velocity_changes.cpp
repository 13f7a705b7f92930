#include "physics/collision/velocity_changes.h"

#include <algorithm>

namespace carom {
namespace {

constexpr int least_slot_bits = 10;

}  // namespace

// If only few slots are occupied, they are cleared one by one, starting with the last entry:
// earlier entries, which the probing for a later one passes, must still be present.
void VelocityLog::open(std::size_t most) {
    most_ = most;
    is_open_ = true;
    if (8 * changes_.size() < slots_.size())
        for (auto change = changes_.rbegin(); change != changes_.rend(); ++change)
            slots_[slot_of(change->particle)] = vacant;
    else
        std::ranges::fill(slots_, vacant);
    changes_.clear();
    if (slots_.empty()) grow();
}

// Fibonacci hashing, then the next free slot.
std::size_t VelocityLog::slot_of(std::int32_t particle) const {
    constexpr std::uint32_t golden = 2'654'435'769U;
    const std::size_t last = slots_.size() - 1;
    std::size_t slot = (static_cast<std::uint32_t>(particle) * golden) >> (32 - slot_bits_);
    while (slots_[slot] != vacant && changes_[slots_[slot] - 1].particle != particle)
        slot = (slot + 1) & last;
    return slot;
}

void VelocityLog::grow() {
    slot_bits_ = std::max(least_slot_bits, slot_bits_ + 1);
    slots_.assign(std::size_t{1} << slot_bits_, vacant);
    for (std::size_t k = 0; k < changes_.size(); ++k)
        slots_[slot_of(changes_[k].particle)] = static_cast<std::uint32_t>(k + 1);
}

void VelocityLog::note(std::int32_t particle, const Vec& before, const Vec& after) {
    std::uint32_t& slot = slots_[slot_of(particle)];
    if (slot != vacant) {
        changes_[slot - 1].after = after;
        return;
    }
    if (changes_.size() >= most_) return give_up();
    changes_.push_back({particle, before, after});
    slot = static_cast<std::uint32_t>(changes_.size());
    if (2 * changes_.size() > slots_.size()) grow();
}

}  // namespace carom
