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
    for (const OfParticle& history : of_particle_)
        positions.push_back(history.position - history.before_start);
    return positions;
}

bool CollisionHistory::is_at(const std::vector<std::ptrdiff_t>& checkpoint, double path) const {
    for (std::size_t i = 0; i < of_particle_.size(); ++i) {
        const OfParticle& history = of_particle_[i];
        const auto [from, to] =
            std::minmax({history.position, checkpoint[i] + history.before_start});
        for (std::ptrdiff_t k = from; k < to; ++k)
            if (std::abs(history.entries[static_cast<std::size_t>(k)].path - path) > slack_)
                return false;
    }
    return true;
}

void CollisionHistory::extend_to(double path) {
    low_ = std::min(low_, path);
    high_ = std::max(high_, path);
}

void CollisionHistory::forget_ahead(const Branch& branch) {
    for (OfParticle& history : of_particle_) {
        const auto present = history.entries.begin() + history.position;
        if (branch.direction > 0) {
            history.entries.erase(present, history.entries.end());
        } else {
            history.before_start -= history.position;
            history.entries.erase(history.entries.begin(), present);
            history.position = 0;
        }
    }
    (branch.direction > 0 ? high_ : low_) = branch.path;
}

bool CollisionHistory::record(int direction, double path, std::int32_t particle, Partner partner) {
    OfParticle& history = of_particle_[static_cast<std::size_t>(particle)];
    const bool forward = direction > 0;
    const std::ptrdiff_t next = forward ? history.position : history.position - 1;
    const bool is_new = next < 0 || next == static_cast<std::ptrdiff_t>(history.entries.size());
    if (!is_new) {
        history.position += direction;
        // Contacts that coincide are carried out in one order in either direction.
        for (std::ptrdiff_t k = next; k >= 0 && k < std::ssize(history.entries); k += direction) {
            Entry& entry = history.entries[static_cast<std::size_t>(k)];
            if (k != next && std::abs(entry.path - path) > slack_) break;
            if (entry.partner != partner) continue;
            std::swap(entry, history.entries[static_cast<std::size_t>(next)]);
            return true;
        }
        return false;
    }
    if (path > low_ + slack_ && path < high_ - slack_) return false;
    if (forward) {
        history.entries.push_back({partner, path});
        ++history.position;
    } else {
        history.entries.push_front({partner, path});
        ++history.before_start;  // and the position stays 0
    }
    return true;
}

}  // namespace carom
