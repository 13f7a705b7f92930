#include "scene/reading/run_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "physics/ways_back.h"
#include "scene/limits.h"
#include "scene/reading/event_reading.h"
#include "scene/reading/film_length.h"
#include "scene/reading/gas_reading.h"
#include "scene/time/captions.h"
#include "scene/yaml/scalar.h"

namespace carom {
namespace {

/// A run with the intermediate values that the rules between its keys need.
struct RunReading : RunDraft {
    std::vector<Placed<EventDraft>> written_events;
};

Notation<std::optional<int>> bits_notation() {
    using Bits = std::optional<int>;
    const Notation<Bits> words = one_of<Bits>({{"double", Bits(bits_of_double)}, {"auto", Bits()}});
    const auto check = [](const Bits& bits, const Node& node, Reading& reading) {
        if (bits > bits_of_double && bits < least_bits)
            reading.errors.add(
                node,
                fmt::format("expected `double`, `auto` or a whole number from {} to {} for "
                            "`precision`, found {}",
                            least_bits, most_bits, described(node)),
                fmt::format("double precision has {} bits", bits_of_double));
    };
    const auto number =
        whole(bits_of_double, most_precise)
            .called(fmt::format("a whole number from {} to {}", least_bits, most_bits));
    return checked(
        either(words,
               mapped(number, [](std::int64_t bits) { return Bits(static_cast<int>(bits)); })),
        check);
}

void check_steps(const Run& run, const Node* node, Errors& errors) {
    if (node == nullptr || !run.time_step) return;
    const double steps = (run.equilibrate + run.until) / *run.time_step;
    if (steps > most_time_steps.value)
        errors.add(*node,
                   fmt::format("a run until {} in steps of {} has {:.6g} steps", run.until,
                               *run.time_step, steps),
                   to_text(most_time_steps));
}

void check_samples(const Run& run, const Node* node, Errors& errors) {
    const double samples = run.until / run.sample_every;
    if (node != nullptr && samples > most_samples.value)
        errors.add(*node,
                   fmt::format("a run until {} sampled every {} has {:.6g} samples", run.until,
                               run.sample_every, samples),
                   to_text(most_samples));
}

bool is_overridden(const Node& root, const char* section, const char* key) {
    const Node* mapping = given(root, section);
    const Node* node = mapping != nullptr ? given(*mapping, key) : nullptr;
    return node != nullptr && node->source->origin == Origin::command_line;
}

// Checks that the run is long enough for the gas to return after a reversal. With several reversals
// nothing is checked, because each ends the way back of the one before it.
void check_way_home(const RunDraft& run, Errors& errors) {
    const std::vector<WayBack> ways = ways_back(run.events);
    if (ways.size() != 1) return;
    const double home = std::min(2.0 * ways.front().begin, ways.front().end);
    if (home <= run.until || run.until <= 0.0) return;  // another error is reported
    const auto reversal = std::ranges::find_if(run.events, reverses);
    const bool is_left = ways.front().event.has_value();
    errors.add(
        *run.event_nodes[static_cast<std::size_t>(reversal - run.events.begin())],
        fmt::format("the gas returns to {} at {}, but the run ends at {}",
                    is_left ? "the event after which it no longer retraces its path" : "its start",
                    home, run.until),
        fmt::format("use `until: {}` or more{}; to render a part of a film, use `--to`", home,
                    is_left ? "" : fmt::format(", or `at: {}` or less", 0.5 * run.until)));
}

void complete_run(RunReading& run, const Node& node, Reading& reading) {
    run.precision = given(node, "precision");
    const Node* most = given(node, "most_collisions");
    run.ceiling = most != nullptr ? most : &node;
    run.step = given(node, "time_step");
    check_samples(run, given(node, "sample_every"), reading.errors);
    check_steps(run, run.step, reading.errors);
    std::ranges::stable_sort(run.written_events, {},
                             [](const Placed<EventDraft>& one) { return one.value.at; });
    for (const Placed<EventDraft>& event : run.written_events)
        add_event(event.value, *event.node, run, reading.errors);
    check_way_home(run, reading.errors);
}

KeyTable<RunReading> run_table(int dimension) {
    return {
        .name = "`run`",
        .keys =
            {bind_key("until", &Run::until, number(positive, quantities::time),
                      "The end of the run, in simulated time.")
                 .required()
                 .tried_as(
                     {"duration", "end", "time", "length", "t_end", "t", "stop", "to", "for"}),
             bind_key("equilibrate", &Run::equilibrate, number(not_negative, quantities::time),
                      "Simulated time before time 0, neither shown nor counted."),
             bind_key("sample_every", &Run::sample_every, number(positive, quantities::time),
                      "Simulated time between samples of the statistics, which are taken at 0, at "
                      "multiples of this time, and at the end: the rows of `run --csv`, and "
                      "the points of curves against time in films and figures. They do not "
                      "depend on the frames of a film.")
                 .tried_as({"sample", "interval", "every"})
                 .default_text("until / 1000"),
             bind_key(
                 "precision", &Run::bits, bits_notation(),
                 "The precision of the arithmetic: `double`, with 53 bits; a number of bits; or "
                 "`auto`: as many bits as the return after every reversal needs, found by trial."),
             bind_key("time_step", &Run::time_step, number(positive, quantities::time),
                      "Advances disks in steps of this length instead of from contact to contact, "
                      "as simple programs do: at the end of each step, disks that overlap and "
                      "approach each other collide at the places they have then. For comparison "
                      "only: disks overlap, and may pass through one another.")
                 .tried_as({"dt", "step"})
                 .default_text("none: from contact to contact"),
             bind_key("tolerance", &Run::tolerance,
                      number({1e-300, {1.0, "radius from the exact return"}}),
                      "How close to its exact place `precision: auto` must return every particle, "
                      "in units of the smallest radius; for points on a wire, in units of the "
                      "length per point."),
             bind_key(
                 "most_collisions", &Run::most_collisions, whole(1, most_run_collisions),
                 "The run ends with an error after this many collisions, including those before "
                 "time 0 and with walls, because trapped particles collide ever faster.")
                 .default_text("1e9, or 5000 for each particle if that is more"),
             bind_key(
                 "events", &RunReading::written_events,
                 list_of(placed(event_notation(dimension)), 0, most_events, "a list of events"),
                 "What happens during the run: a list of {at: time, action}.")
                 .default_text("none")},
        .refused = inelastic_keys(),
        .rule = complete_run};
}

}  // namespace

Notation<RunDraft> run_notation(int dimension) {
    return as<RunDraft>(mapping(run_table(dimension)));
}

void check_captions(const Scene& scene, const std::vector<Placed<Caption>>& drafts,
                    const Node& root, Errors& errors) {
    for (const auto& [section, key] :
         {std::pair{"run", "until"}, {"film", "seconds"}, {"film", "pace"}})
        if (is_overridden(root, section, key)) return;
    const Node* film = given(root, "film");
    const std::vector<CaptionSpan> spans = caption_schedule(scene);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const CaptionSpan& span = spans[i];
        const double half_a_frame = 0.5 / scene.film.fps;
        if (span.words.empty() || span.end - span.start >= least_caption_seconds - half_a_frame)
            continue;
        errors.add(*drafts[i].node,
                   fmt::format("the caption is on the screen for {:.3g} seconds of film, until {}; "
                               "expected at least {}",
                               span.end - span.start,
                               i + 1 < spans.size()
                                   ? fmt::format("the next one at time {}", drafts[i + 1].value.at)
                                   : "the film ends",
                               least_caption_seconds),
                   fmt::format("make the film longer ({}), this `at` earlier, or that of the next "
                               "caption later",
                               film != nullptr ? key_of_length(*film) : "`film.seconds`"));
    }
}

}  // namespace carom
