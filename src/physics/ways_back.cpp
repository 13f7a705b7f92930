#include "physics/ways_back.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Follows a run along its path. The path coordinate equals the time until the first reversal and
// decreases after it; the known part of the path lies between its lowest and its highest value so
// far.
class Walk {
  public:
    std::vector<WayBack> found() && { return std::move(found_); }

    // Advances to a time. At an event on the way that is not mirrored, and therefore not undone,
    // the run leaves the way back.
    void advance(double time) {
        const auto is_ahead = [this](const LeftOut& one) {
            return one.direction != direction_ && direction_ * (one.path - path_) >= 0.0;
        };
        const auto distance = [this](const LeftOut& one) { return std::abs(one.path - path_); };
        const LeftOut* next = nullptr;
        for (const LeftOut& one : left_out_)
            if (is_ahead(one) && (next == nullptr || distance(one) < distance(*next))) next = &one;
        if (next != nullptr && time_ + distance(*next) <= time) {
            const LeftOut here = *next;
            time_ += distance(here);
            path_ = here.path;
            leave_at(here.event);
        }
        path_ += direction_ * (time - time_);
        time_ = time;
        low_ = std::min(low_, path_);
        high_ = std::max(high_, path_);
    }

    void reverse() {
        direction_ = -direction_;
        found_.push_back({time_});
    }

    void see(std::size_t event, bool is_mirrored) {
        if (direction_ > 0.0 ? path_ < high_ : path_ > low_) leave_at(event);
        if (!is_mirrored) left_out_.push_back({path_, direction_, event});
    }

  private:
    struct LeftOut {
        double path, direction;
        std::size_t event;
    };

    // Leaves the way back: the known path ahead is forgotten.
    void leave_at(std::size_t event) {
        if (!found_.empty() && !found_.back().event)
            found_.back() = {found_.back().begin, time_, event};
        std::erase_if(left_out_, [this](const LeftOut& one) {
            return direction_ * (one.path - path_) >= 0.0;
        });
        (direction_ > 0.0 ? high_ : low_) = path_;
    }

    std::vector<WayBack> found_;
    std::vector<LeftOut> left_out_;
    double time_ = 0.0, path_ = 0.0, direction_ = 1.0;
    double low_ = 0.0, high_ = 0.0;
};

}  // namespace

std::vector<WayBack> ways_back(const std::vector<RunEvent>& events) {
    Walk walk;
    for (std::size_t k = 0; k < events.size(); ++k) {
        const RunEvent& event = events[k];
        if (perturbation_of(event)) continue;
        walk.advance(event.at);
        if (reverses(event))
            walk.reverse();
        else
            walk.see(k, event.is_mirrored);
    }
    walk.advance(infinite);
    return std::move(walk).found();
}

}  // namespace carom
