// The rate at which simulated time passes in a film with slow motion: constant, except in the spans
// that are shown slower and during the easing before and after each of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/film.h"

namespace carom {

/// A film is short if the gas moves for fewer seconds than this: easing then takes a fixed share of
/// them.
inline constexpr double seconds_of_short_film = 5.0;

/// Returns the seconds of film that a change from one pace to another takes, in a film in which the
/// gas moves for `seconds`: half a second, or a tenth of `seconds` if these are fewer than five.
double easing_seconds(double seconds);

/// A share of the way, from 0 to 1, that begins and ends slowly.
inline double smooth(double share) { return share * share * (3.0 - 2.0 * share); }

/// How slowly a film runs at a given time.
struct Slowness {
    double factor = 1.0;  ///< of the current or adjacent slow motion; 1: none
    double share = 0.0;   ///< progress of the easing, from 0 (normal pace) to 1 (slow)
};

/// Maps simulated time to stretched time and back. Stretched time is proportional to film time: it
/// is longer than simulated time where the film is slow. All of a span is shown at its factor;
/// easing lies before and after the span, except where the run begins or ends.
class Pace {
  public:
    /// For a run up to time `until`, with `seconds` of film in which the gas moves. `spans` are in
    /// order and do not overlap, and there is room for their easing (easing_shortage() finds none).
    Pace(const std::vector<SlowSpan>& spans, double until, double seconds);

    double stretched(double time) const;
    double time(double stretched) const;  ///< the inverse
    Slowness slowness(double time) const;

  private:
    // A change from one speed to another; speed is simulated time per stretched time.
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

/// Returns the seconds of film in which the gas moves, if simulated time passes at `pace` units per
/// second outside slow motion.
double seconds_at_pace(const std::vector<SlowSpan>& spans, double until, double pace);

/// A span that has too little simulated time before or after it for the easing.
struct EasingShortage {
    std::size_t span = 0;
    bool before = false;  ///< whether the shortage is before the span; otherwise after it
    double room = 0.0;    ///< simulated time that there is, up to the next span's easing
    double needed = 0.0;  ///< infinite if the whole film is too short for all easing
};

/// Returns the first span without enough room for its easing, in a film in which the gas moves for
/// `seconds`; nothing if all have enough.
std::optional<EasingShortage> easing_shortage(const std::vector<SlowSpan>& spans, double until,
                                              double seconds);

}  // namespace carom
