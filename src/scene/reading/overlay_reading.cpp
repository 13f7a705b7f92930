#include "scene/reading/overlay_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/limits.h"
#include "scene/reading/panel_reading.h"

namespace carom {
namespace {

// What begins at the end of the run or later is never seen.
void check_begin(const Node& place, const char* key, double time, Reading& reading) {
    const double until = reading.run.until;
    if (until > 0.0 && time >= until)
        reading.errors.add(place,
                           fmt::format("expected a time from 0 on and below `until` ({}) "
                                       "for `{}`, found {}",
                                       until, key, described(place)),
                           "times are simulated time, as those of `run.events`");
}

// The keys of a span of time, the second of them by this name.
std::vector<Binding<TimeSpan>> span_keys(const char* until) {
    return {
        bind_key("from", &TimeSpan::from, number(not_negative),
                 "The simulated time at which it comes."),
        bind_key(until, &TimeSpan::until, number(positive), "The simulated time at which it goes.")
            .default_text("the end of the film")};
}

void check_span(const TimeSpan& span, const Node& node, const char* until, Reading& reading) {
    if (span.until && *span.until <= span.from)
        reading.errors.add(node, fmt::format("expected `from` below `{}`, found {} and {}", until,
                                             span.from, *span.until));
    else if (const Node* from = given(node, "from"))
        check_begin(*from, "from", span.from, reading);
}

}  // namespace

Notation<TimeSpan> show_notation() {
    return mapping(KeyTable<TimeSpan>{.name = "`show`",
                                      .keys = span_keys("until"),
                                      .rule =
                                          [](TimeSpan& span, const Node& node, Reading& reading) {
                                              check_span(span, node, "until", reading);
                                          }},
                   "{from: time, until: time}");
}

}  // namespace carom
