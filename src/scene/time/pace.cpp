#include "scene/time/pace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr double easing_of_short = 0.1;  // of the seconds of a short film
constexpr double longest_easing = easing_of_short * seconds_of_short_film;  // seconds

double eases(const SlowSpan& span, double until) {
    return (span.from > 0.0 ? 1.0 : 0.0) + (span.to < until ? 1.0 : 0.0);
}

// Returns the film time that all easing adds, in units of one easing's duration. Each easing covers
// (1 + factor)/2 times the simulated time of normal pace, and so adds (1 - factor)/2.
double cost_of_easing(const std::vector<SlowSpan>& spans, double until) {
    double cost = 0.0;
    for (const SlowSpan& span : spans) cost += eases(span, until) * (1.0 - span.factor) / 2.0;
    return cost;
}

double stretched_length(const std::vector<SlowSpan>& spans, double until) {
    double length = until;
    for (const SlowSpan& span : spans) length += (span.to - span.from) * (1.0 / span.factor - 1.0);
    return length;
}

// Returns the units of simulated time in a second of film outside slow motion.
double usual_pace(const std::vector<SlowSpan>& spans, double until, double seconds) {
    const double eased = easing_seconds(seconds) * cost_of_easing(spans, until);
    return stretched_length(spans, until) / (seconds - eased);
}

// Returns the simulated time that passes while the film slows down or speeds up.
double eased_time(const SlowSpan& span, double easing, double pace) {
    return easing * pace * (1.0 + span.factor) / 2.0;
}

// The integral of smooth() from 0.
double smooth_sum(double share) { return share * share * share * (1.0 - share / 2.0); }

}  // namespace

double easing_seconds(double seconds) {
    return std::min(longest_easing, easing_of_short * seconds);
}

double Pace::Piece::time_after(double stretched) const {
    if (speed_begin == speed_end) return begin + speed_begin * (stretched - stretched_begin);
    const double length = stretched_end - stretched_begin;
    const double share = (stretched - stretched_begin) / length;
    return begin + length * (speed_begin * share + (speed_end - speed_begin) * smooth_sum(share));
}

double Pace::Piece::speed_after(double stretched) const {
    if (speed_begin == speed_end) return speed_begin;
    const double share = (stretched - stretched_begin) / (stretched_end - stretched_begin);
    return speed_begin + (speed_end - speed_begin) * smooth(std::clamp(share, 0.0, 1.0));
}

void Pace::add(double end, double stretched_length, Speeds speeds, double factor) {
    const double begin = pieces_.empty() ? 0.0 : pieces_.back().end;
    const double stretched_begin = pieces_.empty() ? 0.0 : pieces_.back().stretched_end;
    if (end > begin)
        pieces_.push_back({begin, end, stretched_begin, stretched_begin + stretched_length,
                           speeds.begin, speeds.end, factor});
}

Pace::Pace(const std::vector<SlowSpan>& spans, double until, double seconds) {
    const double pace = usual_pace(spans, until, seconds);
    const double easing = easing_seconds(seconds), eased_length = easing * pace;
    const auto usual_until = [&](double end) {
        add(end, end - (pieces_.empty() ? 0.0 : pieces_.back().end), {1.0, 1.0}, 1.0);
    };
    for (const SlowSpan& span : spans) {
        const double eased = eased_time(span, easing, pace);
        const double slow = span.factor;
        if (span.from > 0.0) {
            usual_until(span.from - eased);
            add(span.from, eased_length, {1.0, slow}, slow);
        }
        add(span.to, (span.to - span.from) / slow, {slow, slow}, slow);
        if (span.to < until) add(span.to + eased, eased_length, {slow, 1.0}, slow);
    }
    usual_until(until);
}

const Pace::Piece& Pace::piece_at(double time) const {
    const auto found =
        std::ranges::find_if(pieces_, [&](const Piece& piece) { return time <= piece.end; });
    return found == pieces_.end() ? pieces_.back() : *found;
}

double Pace::stretched_in(const Piece& piece, double time) {
    if (piece.speed_begin == piece.speed_end)
        return piece.stretched_begin + (time - piece.begin) / piece.speed_begin;
    double low = piece.stretched_begin, high = piece.stretched_end;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (piece.time_after(middle) < time ? low : high) = middle;
    }
    return high;
}

double Pace::stretched(double time) const { return stretched_in(piece_at(time), time); }

double Pace::time(double stretched) const {
    const auto found = std::ranges::find_if(
        pieces_, [&](const Piece& piece) { return stretched <= piece.stretched_end; });
    const Piece& piece = found == pieces_.end() ? pieces_.back() : *found;
    return std::min(piece.end, piece.time_after(stretched));
}

Slowness Pace::slowness(double time) const {
    const Piece& piece = piece_at(time);
    if (piece.factor >= 1.0) return {};
    const double speed = piece.speed_after(stretched_in(piece, time));
    return {piece.factor, (1.0 - speed) / (1.0 - piece.factor)};
}

double seconds_at_pace(const std::vector<SlowSpan>& spans, double until, double pace) {
    const double uneased = stretched_length(spans, until) / pace;
    const double cost = cost_of_easing(spans, until), long_film = uneased + longest_easing * cost;
    return easing_seconds(long_film) < longest_easing ? uneased / (1.0 - easing_of_short * cost)
                                                      : long_film;
}

std::optional<EasingShortage> easing_shortage(const std::vector<SlowSpan>& spans, double until,
                                              double seconds) {
    if (spans.empty()) return std::nullopt;
    const double easing = easing_seconds(seconds);
    if (seconds <= easing * cost_of_easing(spans, until))
        return EasingShortage{0, true, 0.0, std::numeric_limits<double>::infinity()};
    const double pace = usual_pace(spans, until, seconds);
    double free_from = 0.0;  // the end of the easing after the span before
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const double eased = eased_time(spans[i], easing, pace);
        const double next = i + 1 < spans.size() ? spans[i + 1].from : until;
        if (spans[i].from > 0.0 && spans[i].from - free_from < eased)
            return EasingShortage{i, true, spans[i].from - free_from, eased};
        if (spans[i].to < until && next - spans[i].to < eased)
            return EasingShortage{i, false, next - spans[i].to, eased};
        free_from = spans[i].to + eased;
    }
    return std::nullopt;
}

}  // namespace carom
