#include "physics/surfaces/driven_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/surfaces/barrier.h"
#include "util/overloaded.h"

namespace carom {
namespace {

// Packing fractions of the densest packings of equal disks, the hexagonal one, and of equal
// spheres, the face-centred cubic one (Hales 2005); with small particles between large ones they
// may be higher.
double densest_packing(int dimension) {
    return dimension == 3 ? std::numbers::pi / (3.0 * std::numbers::sqrt2)
                          : std::numbers::pi / (2.0 * std::numbers::sqrt3);
}

struct Path {
    std::int32_t surface;
    int axis;
    double place;
    Behaviour behaviour;
    bool is_open = false;
    bool is_side = false;

    // Not that of a piston.
    bool is_known() const {
        const bool is_free = std::visit(
            Overloaded{[](const Reflecting&) { return false; }, [](const Bath&) { return false; },
                       [](const Driven&) { return false; }, [](const Piston&) { return true; },
                       [](const Membrane&) { return false; }, [](const Diffuse&) { return false; }},
            behaviour);
        return !is_open && !is_free;
    }

    // An open partition passes the others; its motion ends at the walls of the box.
    bool ends_at(const Path& other, double time) const {
        return is_open && velocity_at(time) != 0.0 && other.is_side && other.is_known();
    }
    double velocity_at(double time) const {
        const auto* driven = driven_of(behaviour);
        return driven != nullptr ? driven->velocity_at(time) : 0.0;
    }
};

class Paths {
  public:
    Paths(const Box& box, double content) : box_(box), content_(content) {
        const std::vector<Behaviour> behaviours = behaviours_of(box);
        for (std::int32_t k = 0; k < box.surfaces.first_obstacle(); ++k) {
            const Partition* line = box.surfaces.partition(k);
            const int axis = box.surfaces.axis_of(k);
            if (!box.has_surface(k) || (line == nullptr && box.is_periodic(axis))) continue;
            paths_.push_back({k, axis, box.place_of(k), behaviours[static_cast<std::size_t>(k)],
                              line != nullptr && line->is_open, line == nullptr});
        }
    }

    // Advances to a time, stopping at the times at which motions end.
    std::optional<DrivenEnd> advance(double time) {
        while (now_ < time) {
            double next = time;
            for (const Path& path : paths_)
                if (const auto* driven = driven_of(path.behaviour))
                    if (driven->until > now_) next = std::min(next, driven->until);
            if (const auto end = first_end(next)) return end;
            for (Path& path : paths_) path.place += path.velocity_at(now_) * (next - now_);
            now_ = next;
        }
        return std::nullopt;
    }

    void apply(const RunEvent& event) {
        if (const auto* set = opening_of(event))
            if (Path* path = find(set->surface)) path->is_open = set->is_open;
        if (const auto given = given_behaviour(event))
            if (Path* path = find(given->first)) path->behaviour = given->second;
    }

  private:
    Path* find(std::int32_t surface) {
        const auto found = std::ranges::find(paths_, surface, &Path::surface);
        return found == paths_.end() ? nullptr : &*found;
    }

    std::optional<DrivenEnd> first_end(double until) const {
        std::optional<DrivenEnd> first;
        const auto keep = [&](const DrivenEnd& end) {
            if (end.time <= until && (!first || end.time < first->time)) first = end;
        };
        for (std::size_t i = 0; i < paths_.size(); ++i)
            for (std::size_t j = 0; j < paths_.size(); ++j) {
                const Path &low = paths_[i], &high = paths_[j];
                if (low.axis != high.axis || !(low.place < high.place)) continue;
                if (!(low.is_known() && high.is_known()) && !low.ends_at(high, now_) &&
                    !high.ends_at(low, now_))
                    continue;
                const double closing = low.velocity_at(now_) - high.velocity_at(now_);
                if (!(closing > 0.0)) continue;
                const double room = high.place - low.place;
                const bool first_moves = low.velocity_at(now_) != 0.0;
                const auto &mover = first_moves ? low : high, &other = first_moves ? high : low;
                keep({now_ + room / closing, 0.0, mover.surface, other.surface});
                if (!low.is_side || !high.is_side || box_.dimension == 1) continue;
                double least = content_ / densest_packing(box_.dimension);
                for (int axis = 0; axis < box_.dimension; ++axis)
                    if (axis != low.axis) least /= extent_at(axis);
                keep({now_ + (room - least) / closing, least, mover.surface, std::nullopt});
            }
        return first;
    }

    // Distance of the outer walls along an axis; infinite if one of them is a piston or is moving.
    double extent_at(int axis) const {
        double size = box_.length(axis);
        for (const Path& path : paths_) {
            if (path.axis != axis || !path.is_side) continue;
            if (!path.is_known() || path.velocity_at(now_) != 0.0) return never<double>;
            const double moved = path.place - box_.place_of(path.surface);
            size += box_.surfaces.is_far_side(path.surface) ? moved : -moved;
        }
        return size;
    }

    const Box& box_;
    double content_, now_ = 0.0;
    std::vector<Path> paths_;
};

}  // namespace

std::optional<DrivenEnd> driven_end(const Box& box, const Run& run, double content) {
    Paths paths(box, content);
    for (const RunEvent& event : run.events) {
        if (const auto end = paths.advance(std::min(event.at, run.until))) return end;
        if (reverses(event)) return std::nullopt;
        paths.apply(event);
    }
    return paths.advance(run.until);
}

}  // namespace carom
