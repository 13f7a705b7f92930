#include "physics/collision_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace carom {
namespace {

std::string rate_of(const CollisionsSeen& seen) {
    const double time = seen.end - seen.begin;
    if (!(time > 0.0)) return fmt::format("the next {} take no time", seen.count);
    return fmt::format("the next {} take {:.3g} units of time, a rate of {:.3g}", seen.count, time,
                       static_cast<double>(seen.count) / time);
}

std::string busiest_of(const CollisionsSeen& seen) {
    if (!seen.particle) return "";
    return fmt::format("; most are of particle {}, at {}{:.6g}{}", *seen.particle,
                       seen.place.size() > 1 ? "(" : "x = ", fmt::join(seen.place, ", "),
                       seen.place.size() > 1 ? ")" : "");
}

}  // namespace

TooManyCollisions::TooManyCollisions(const CollisionsSeen& seen)
    : CollisionError(
          fmt::format(
              "at time {:.6g} the run has had {} collisions, the most that it may have: {}{}",
              seen.begin, seen.most, rate_of(seen), busiest_of(seen)),
          seen.particle,
          fmt::format("{}, or allow more with `run.most_collisions`",
                      seen.particle ? "give it more room, or let the run end before"
                                    : "let the run end before")),
      seen_(seen) {}

}  // namespace carom
