#include "physics/reversal/collision_history.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace carom {

bool CollisionHistory::record(const Branch& branch, const Collision& collision) {
    const double path = branch.path_at(collision.time);
    const bool first_agrees = record(branch.direction, path, collision.first, collision.second);
    return first_agrees &&
           (collision.second.is_surface() ||
            record(branch.direction, path, collision.second.particle(), collision.first));
}

std::vector<std::ptrdiff_t> CollisionHistory::checkpoint() const {
    std::vector<std::ptrdiff_t> positions;
    for (const OfParticle& its : of_particle_) positions.push_back(its.position - its.before_start);
    return positions;
}

bool CollisionHistory::is_at(const std::vector<std::ptrdiff_t>& checkpoint, double path) const {
    for (std::size_t i = 0; i < of_particle_.size(); ++i) {
        const OfParticle& its = of_particle_[i];
        const auto [from, to] = std::minmax({its.position, checkpoint[i] + its.before_start});
        for (std::ptrdiff_t k = from; k < to; ++k)
            if (std::abs(its.entries[static_cast<std::size_t>(k)].path - path) > slack_)
                return false;
    }
    return true;
}

void CollisionHistory::extend_to(double path) {
    low_ = std::min(low_, path);
    high_ = std::max(high_, path);
}

void CollisionHistory::forget_ahead(const Branch& branch) {
    for (OfParticle& its : of_particle_) {
        const auto present = its.entries.begin() + its.position;
        if (branch.direction > 0) {
            its.entries.erase(present, its.entries.end());
        } else {
            its.before_start -= its.position;
            its.entries.erase(its.entries.begin(), present);
            its.position = 0;
        }
    }
    (branch.direction > 0 ? high_ : low_) = branch.path;
}

bool CollisionHistory::record(int direction, double path, std::int32_t particle, Partner partner) {
    OfParticle& its = of_particle_[static_cast<std::size_t>(particle)];
    const bool forward = direction > 0;
    const std::ptrdiff_t next = forward ? its.position : its.position - 1;
    const bool is_new = next < 0 || next == static_cast<std::ptrdiff_t>(its.entries.size());
    if (!is_new) {
        its.position += direction;
        // Contacts that coincide are carried out in one order in either direction.
        for (std::ptrdiff_t k = next; k >= 0 && k < std::ssize(its.entries); k += direction) {
            Entry& entry = its.entries[static_cast<std::size_t>(k)];
            if (k != next && std::abs(entry.path - path) > slack_) break;
            if (entry.partner != partner) continue;
            std::swap(entry, its.entries[static_cast<std::size_t>(next)]);
            return true;
        }
        return false;
    }
    if (path > low_ + slack_ && path < high_ - slack_) return false;
    if (forward) {
        its.entries.push_back({partner, path});
        ++its.position;
    } else {
        its.entries.push_front({partner, path});
        ++its.before_start;  // and the position stays 0
    }
    return true;
}

}  // namespace carom
