#include "scene/reading/film_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/limits.h"
#include "scene/time/pace.h"
#include "scene/time/timeline.h"
#include "util/text.h"

namespace carom {
namespace {

using Spans = std::vector<Placed<SlowSpan>>;

void check_spans(const Spans& spans, const Run& run, Errors& errors) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const auto& [span, node] = spans[i];
        if (span.from >= span.to)
            errors.add(
                *node,
                fmt::format("expected `from` below `to`, found {} and {}", span.from, span.to),
                "write the earlier time as `from`");
        else if (span.to > run.until)
            errors.add(*node,
                       fmt::format("slow motion from {} to {} goes beyond `until` ({})", span.from,
                                   span.to, run.until),
                       "without `to` it lasts until the end of the run");
        else if (i > 0 && spans[i - 1].value.to > span.from)
            errors.add(
                *node,
                fmt::format("slow motion from {} to {} overlaps that from {} to {}", span.from,
                            span.to, spans[i - 1].value.from, spans[i - 1].value.to),
                "end the first before the second begins");
    }
}

// Returns the spans in order of time; a span without an end lasts until the end of the run.
Spans spans_of(Spans spans, Reading& reading) {
    const double until = reading.run.until;
    if (until <= 0.0) return {};  // there is a mistake in it
    for (auto& [span, node] : spans)
        if (span.to == 0.0) span.to = until;
    std::ranges::stable_sort(spans, {}, [](const Placed<SlowSpan>& one) { return one.value.from; });
    check_spans(spans, reading.run, reading.errors);
    return spans;
}

void check_easing(const Film& film, const Run& run, const Spans& drafts, const Node& node,
                  Errors& errors) {
    const double seconds = static_cast<double>(moving_steps(film, run)) / film.fps;
    const auto shortage = easing_shortage(film.slow, run.until, seconds);
    if (!shortage) return;
    const SlowSpan& span = film.slow[shortage->span];
    const Node& place = *drafts[shortage->span].node;
    const std::string longer =
        seconds < seconds_of_short_film
            ? fmt::format("let the gas move for more than {} seconds", seconds_of_short_film)
            : "make the film longer";
    const std::string lengthen = fmt::format("{} ({})", longer, key_of_length(node));
    if (!std::isfinite(shortage->needed))
        return errors.add(
            place,
            fmt::format(
                "the gas moves for {:.3g} seconds of this film, too short to ease in and out "
                "of slow motion over {:.3g} seconds each time",
                seconds, easing_seconds(seconds)),
            lengthen);
    errors.add(
        place,
        fmt::format("slow motion from {} to {} needs {:.3g} time units {} it to ease {} ({:.3g} "
                    "seconds of film); there are {:.3g}",
                    span.from, span.to, shortage->needed, shortage->before ? "before" : "after",
                    shortage->before ? "in" : "out", easing_seconds(seconds),
                    std::max(0.0, shortage->room)),
        shortage->before && shortage->span == 0 ? lengthen + ", or begin with `from: 0`"
        : !shortage->before && shortage->span + 1 == film.slow.size()
            ? fmt::format("{}, or end with `to: {}`", lengthen, run.until)
            : lengthen + ", or put the spans farther apart");
}

// Returns the node where the user can change the length: that of the key that gives it, or else the
// end of the run.
const Node& place_of_length(const Node& film, const Node& root) {
    for (const char* key : {"seconds", "pace"})
        if (const Node* node = given(film, key)) return *node;
    if (const Node* run = given(root, "run"))
        if (const Node* until = given(*run, "until")) return *until;
    return film;
}

// Returns whether all given lengths are invalid; their errors have already been reported. A length
// that one of a later origin has replaced is invalid without an error, but then the other one is
// valid.
bool has_length_in_error(const Node& film) {
    const std::array keys{"seconds", "pace"};
    return std::ranges::any_of(keys, [&](const char* key) { return find(film, key) != nullptr; }) &&
           std::ranges::none_of(keys, [&](const char* key) { return given(film, key) != nullptr; });
}

bool check_frames(const Film& film, const Node& node, const Node& root, Errors& errors) {
    if (has_length_in_error(node)) return false;
    const double frames = std::round(film.seconds * film.fps);
    if (frames >= 2.0 && frames <= most_frames.value) return true;
    const bool has_seconds = given(node, "seconds") != nullptr;
    std::string hint = frames < 2.0 ? "a film has at least 2 frames" : to_text(most_frames);
    if (!has_seconds) hint += "; give `film.seconds`, or another `film.pace`";
    errors.add(place_of_length(node, root),
               fmt::format("a film of {:.6g} seconds at {} frames a second has {:.6g} {}",
                           film.seconds, film.fps, frames, frames == 1.0 ? "frame" : "frames"),
               hint);
    return false;
}

// If the command line sets the length of the film, nothing is reported: the film then shows its
// pauses as well as it can.
void check_pauses(const Film& film, const std::vector<Placed<Pause>>& pauses, const Node& node,
                  Errors& errors) {
    const Node* length = given(node, "seconds");
    const double asked = pause_seconds(film), most = most_pause_seconds(film);
    if (asked <= most || (length != nullptr && length->source->origin == Origin::command_line))
        return;
    // Without `seconds`, shortening the pauses also shortens the film.
    const double enough = length != nullptr ? most : film.seconds - card_seconds(film) - asked;
    errors.add(*pauses.back().node,
               fmt::format("pauses of {:.3g} seconds in all, in a film of {:.3g} seconds{}", asked,
                           film.seconds, card_seconds(film) > 0.0 ? " with its cards" : ""),
               fmt::format("pauses take at most half of a film: make it longer ({}), or the pauses "
                           "{:.6g} seconds or less in all",
                           key_of_length(node), std::floor(100.0 * enough) / 100.0));
}

void check_sound(const Film& film, const Node& node, Errors& errors) {
    const Node* sound = given(node, "sound");
    if (!film.sound || sound == nullptr || film.seconds <= most_sound_seconds.value) return;
    errors.add(*sound, fmt::format("a film of {:.6g} seconds is too long for sound", film.seconds),
               to_text(most_sound_seconds));
}

// Each part of the run between reversals needs a frame for its end.
void check_legs(const Film& film, const Run& run, const Node& film_node, const Node& root,
                Errors& errors) {
    const int legs = branch_count(run);
    const int steps = moving_steps(film, run);
    const Node* node = given(root, "run");
    const Node* events = node != nullptr ? given(*node, "events") : nullptr;
    if (legs <= steps || events == nullptr) return;
    const int enough = (4 * (legs + 1) + 2) / 3;  // pauses leave at least 3/4 of the frames, less 1
    const double with_cards = card_seconds(film) > 0.0 ? 1.5 : 1.0;
    const double gas =
        std::max(enough / double(film.fps) + pause_seconds(film), 2.0 * pause_seconds(film));
    const double seconds = std::ceil(10.0 * with_cards * gas) / 10.0;
    errors.add(*events,
               fmt::format("{} {} the run into {} parts, but a film of {} can show only {}",
                           counted(legs - 1, "reversal"), legs == 2 ? "divides" : "divide", legs,
                           counted(frame_count(film), "frame"), steps),
               given(film_node, "pace") != nullptr
                   ? "give fewer reversals, or a smaller `film.pace`"
                   : fmt::format("give fewer reversals, or a film of {} seconds (`film.seconds`)",
                                 seconds));
}

// Gives the film of a run whose length nobody asked for, which only figures see, a length that a
// film can have: if not that at the usual pace, then the usual one, or longer where the run has
// many parts between reversals.
void give_some_length(Film& film, const Run& run) {
    const double frames = std::round(film.seconds * film.fps);
    const double parts = branch_count(run);
    if (frames < 2.0 || frames > most_frames.value || parts > moving_steps(film, run))
        film.seconds = std::max(Film{}.seconds, 8.0 * (parts + 1.0) / film.fps);
    const double moving = static_cast<double>(moving_steps(film, run)) / film.fps;
    if (easing_shortage(film.slow, run.until, moving)) film.slow.clear();
}

}  // namespace

std::string key_of_length(const Node& film) {
    return given(film, "pace") != nullptr ? "a smaller `film.pace`" : "`film.seconds`";
}

void complete_length(FilmDraft& film, const std::vector<Placed<Pause>>& pauses,
                     const FilmNodes& nodes, const Node& node, Reading& reading) {
    const Run& run = reading.run;
    const Spans spans = spans_of(film.spans, reading);
    film.slow = values_of(spans);
    film.pauses = values_of(pauses);
    film.seconds = film.given_seconds.value_or(seconds_at_pace(film.slow, run.until, film.pace) +
                                               card_seconds(film) + pause_seconds(film));
    if (!nodes.has_length) return give_some_length(film, run);
    if (!(film.seconds > 0.0) || !check_frames(film, node, nodes.root, reading.errors)) return;
    check_pauses(film, pauses, node, reading.errors);
    check_sound(film, node, reading.errors);
    check_legs(film, run, node, nodes.root, reading.errors);
    if (reading.errors.empty()) check_easing(film, run, spans, node, reading.errors);
}

}  // namespace carom
