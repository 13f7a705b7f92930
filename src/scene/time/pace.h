// How fast simulated time passes in a film with slow motion: evenly, but for the spans that are
// shown slower and the easing before and after them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace carom {

/// Seconds in which the gas moves: in shorter films easing takes a share of these.
inline constexpr double short_film = 5.0;

/// How long a film in which the gas moves for `seconds` takes from one pace to another: half a
/// second, in films of less than five a tenth of them.
double easing_seconds(double seconds);

/// How slowly a film runs at some time.
struct Slowness {
    double factor = 1.0;  ///< of the slow motion that is there or near; 1: none
    double share = 0.0;   ///< how far it has been eased into, from 0 to 1
};

/// Simulated time against the film's own, which is stretched where the film is slow: a stretched
/// unit takes the same film everywhere. A whole span is shown at its factor, the easing lies before
/// and after it; there is none where the run begins or ends.
class Pace {
  public:
    /// Of a run to `until`, with `seconds` of film in which the gas moves. `spans` are in order and
    /// apart, and there is room for the easing (easing_shortage() finds none).
    Pace(const std::vector<SlowSpan>& spans, double until, double seconds);

    double stretched(double time) const;
    double time(double stretched) const;  ///< the inverse
    Slowness slowness(double time) const;

  private:
    // From one speed to another, as simulated for stretched time.
    struct Piece {
        double begin, end;  // simulated
        double stretched_begin, stretched_end;
        double speed_begin, speed_end;
        double factor;  // of the span that the piece belongs to, or 1
        double time_after(double stretched) const;
        double speed_after(double stretched) const;
    };
    struct Speeds {
        double begin, end;
    };
    void add(double end, double stretched_length, Speeds speeds, double factor);
    const Piece& piece_at(double time) const;
    static double stretched_in(const Piece& piece, double time);

    std::vector<Piece> pieces_;
};

/// The film in which the gas moves, in seconds, at `pace` units of simulated time a second where it
/// is not slow.
double seconds_at_pace(const std::vector<SlowSpan>& spans, double until, double pace);

/// A span that has too little simulated time before or after it for the easing.
struct EasingShortage {
    std::size_t span = 0;
    bool before = false;  ///< or after it
    double room = 0.0;    ///< simulated time that there is, up to the next span's easing
    double needed = 0.0;  ///< infinite where the whole film is too short for all easing
};

/// The first span without room for its easing in a film in which the gas moves for `seconds`.
std::optional<EasingShortage> easing_shortage(const std::vector<SlowSpan>& spans, double until,
                                              double seconds);

}  // namespace carom
