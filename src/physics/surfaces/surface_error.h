// The error thrown when a surface does something impossible in a run.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace carom {

/// what() is first a phrase to follow the name of the surface; the event loop extends it with the
/// name, the time and the position.
class SurfaceError : public std::runtime_error {
  public:
    /// `reason` is appended to what() when time and position are added.
    SurfaceError(std::int32_t surface, const std::string& what, std::string reason,
                 std::string hint)
        : std::runtime_error(what),
          surface_(surface),
          reason_(std::move(reason)),
          hint_(std::move(hint)) {}

    std::int32_t surface() const { return surface_; }  ///< its number (surface.h)
    const std::string& reason() const { return reason_; }
    const std::string& hint() const { return hint_; }  ///< suggested change

  private:
    std::int32_t surface_;
    std::string reason_, hint_;
};

/// The hint where a driven surface reaches another, or leaves no room.
inline constexpr const char* how_to_stop =
    "end its motion earlier, by its `until` or by an event, or shorten the run";

/// The error for a surface that crushes the gas or a piston, which has nowhere to go.
inline SurfaceError crushes(std::int32_t surface, const char* what = "the gas") {
    return {surface, std::string("crushes ") + what, "",
            "stop it earlier, a driven wall by its `until` and others by an event, let it press "
            "less, or shorten the run"};
}

}  // namespace carom
