// What a surface does in a run that cannot be.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace carom {

/// Says it of the surface, as it follows its name, and from the event loop on with its name, the
/// time and its place.
class SurfaceError : public std::runtime_error {
  public:
    /// `reason` follows what() where time and place are named.
    SurfaceError(std::int32_t surface, const std::string& what, std::string reason,
                 std::string hint)
        : std::runtime_error(what),
          surface_(surface),
          reason_(std::move(reason)),
          hint_(std::move(hint)) {}

    std::int32_t surface() const { return surface_; }  ///< its number (surface.h)
    const std::string& reason() const { return reason_; }
    const std::string& hint() const { return hint_; }  ///< what to change

  private:
    std::int32_t surface_;
    std::string reason_, hint_;
};

/// The hint where a driven surface reaches another, or leaves no room.
inline constexpr const char* how_to_stop =
    "end its motion earlier, by its `until` or by an event, or shorten the run";

/// What it presses on, the gas or a piston, has nowhere to go.
inline SurfaceError crushes(std::int32_t surface, const char* what = "the gas") {
    return {surface, std::string("crushes ") + what, "",
            "stop it earlier, a driven wall by its `until` and others by an event, let it press "
            "less, or shorten the run"};
}

}  // namespace carom
