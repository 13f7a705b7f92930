#include "scene/reading/run_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/limits.h"
#include "scene/reading/gas_reading.h"
#include "scene/time/captions.h"
#include "scene/yaml/scalar.h"

namespace carom {
namespace {

/// A nudge, as far as it is given. What is moved is kept as it is written: no double has all its
/// digits.
struct NudgeDraft {
    std::optional<std::int64_t> particle;
    std::optional<std::array<std::string, 2>> by;
};

/// An item of `events`.
struct EventDraft {
    double at = 0.0;
    bool reverses = false;
    std::optional<Perturbation> nudge;
    std::optional<std::string> mark, caption;
    std::optional<double> seconds;
};

/// A run with what only the rules between its keys need.
struct RunReading : RunDraft {
    std::vector<Placed<EventDraft>> events;
};

Notation<std::array<std::string, 2>> digits(int dimension) {
    using Digits = std::array<std::string, 2>;
    const auto as_written = [](const Eigen::Array2d&, const Node& node, Reading&) {
        return std::optional(node.is_scalar() ? Digits{node.text, "0"}
                                              : Digits{node.items[0].text, node.items[1].text});
    };
    if (dimension == 2) return parsed(pair_of(any_number, "[dx, dy]"), as_written);
    return parsed(mapped(number(any_number), [](double x) { return Eigen::Array2d(x, 0.0); }),
                  as_written);
}

Notation<Perturbation> nudge_notation(int dimension) {
    const KeyTable<NudgeDraft> table{
        .name = "`nudge`",
        .keys = {bind_key("particle", &NudgeDraft::particle, whole(0, most_particles),
                          "The number of the particle, counted from 0 in the order in which `gas` "
                          "lists them.")
                     .required(),
                 bind_key("by", &NudgeDraft::by, digits(dimension),
                          "How far it is moved, read with all its digits: as little as 1e-300.")
                     .required()}};
    return parsed(
        mapping(table, dimension == 1 ? "{particle: i, by: dx}" : "{particle: i, by: [dx, dy]}"),
        [](const NudgeDraft& draft, const Node&, Reading&) -> std::optional<Perturbation> {
            if (!draft.particle || !draft.by) return std::nullopt;
            return Perturbation{*draft.particle, *draft.by};
        });
}

KeyTable<EventDraft> event_table(int dimension) {
    return {
        .name = "an item of `events`",
        .keys = {bind_key("at", &EventDraft::at, number(not_negative),
                          "When, in simulated time, before `until`.")
                     .required(),
                 bind_key("reverse", &EventDraft::reverses, one_of<bool>({{"velocities", true}}),
                          "Reverses all velocities; a run with one reversal must last until the "
                          "gas has returned, at twice its time."),
                 bind_key("nudge", &EventDraft::nudge, nudge_notation(dimension),
                          "Moves one particle by a small amount, which shows how sensitive the "
                          "return after a reversal is."),
                 bind_key("mark", &EventDraft::mark, text(1, most_name_letters),
                          "Shows the places that the particles have at this time as outlines, with "
                          "these words, until the next mark."),
                 bind_key(
                     "caption", &EventDraft::caption, text(0, most_caption_letters),
                     "A line of text under the gas, shown until the next one; \"\" removes it."),
                 bind_key("for", &EventDraft::seconds,
                          number({least_caption_seconds, most_seconds.value, most_seconds.meaning}),
                          "How long the caption is shown at most, in seconds of film.")
                     .default_text("until the next caption")},
        .choices = {{{"reverse", "nudge", "mark", "caption"}, true}}};
}

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

void check_time(const EventDraft& event, const Node& place, double until, Errors& errors) {
    if (until > 0.0 && event.at >= until)
        errors.add(place,
                   fmt::format("expected a time {} and below `until` ({}) for `at`, found {}",
                               event.reverses ? "above 0" : "from 0 on", until, described(place)),
                   "the film ends at `until`: what happens at this time or later is never shown");
    else if (event.reverses && event.at == 0.0)
        errors.add(place, "expected a positive number for `at` of a reversal, found `0`",
                   "at time 0 there is nothing to reverse");
}

// One event at its time: of the run, or of the film.
void add_event(const EventDraft& event, const Node& node, RunDraft& draft, Errors& errors) {
    const auto add = [&](RunEvent one, const Node& place) {
        draft.run.events.push_back(std::move(one));
        draft.event_nodes.push_back(&place);
    };
    const Node* at = given(node, "at");
    if (at == nullptr) return;
    check_time(event, *at, draft.run.until, errors);
    if (event.reverses) add({event.at, ReverseVelocities{}}, *given(node, "reverse"));
    if (event.nudge) add({event.at, *event.nudge}, *given(node, "nudge"));
    if (event.mark) draft.marks.push_back({event.at, *event.mark});
    if (event.caption)
        draft.captions.push_back(
            {{event.at, *event.caption, event.seconds}, given(node, "caption")});
    else if (event.seconds && find(node, "caption") == nullptr)
        errors.add(*given(node, "for"), "`for` applies only to a caption",
                   "it applies to `caption`");
}

void check_samples(const Run& run, const Node* node, Errors& errors) {
    const double samples = run.until / run.sample_every;
    if (node != nullptr && samples > most_samples.value)
        errors.add(*node,
                   fmt::format("a run until {} sampled every {} has {:.6g} samples", run.until,
                               run.sample_every, samples),
                   fmt::format("the limit is {:.0f} {}", most_samples.value, most_samples.meaning));
}

bool is_overridden(const Node& root, const char* section, const char* key) {
    const Node* mapping = given(root, section);
    const Node* node = mapping != nullptr && mapping->is_mapping() ? given(*mapping, key) : nullptr;
    return node != nullptr && node->source->origin == Origin::command_line;
}

// A gas that turns round must have the time to come home. Of several reversals each ends the way
// back of the one before it.
void check_way_home(const RunDraft& draft, Errors& errors) {
    const Run& run = draft.run;
    const auto reverses = [](const RunEvent& event) {
        return std::holds_alternative<ReverseVelocities>(event.action);
    };
    if (std::ranges::count_if(run.events, reverses) != 1) return;
    const auto reversal = std::ranges::find_if(run.events, reverses);
    const double home = 2.0 * reversal->at;
    if (home <= run.until || run.until <= 0.0) return;  // there is another mistake
    const Node& node = *draft.event_nodes[static_cast<std::size_t>(reversal - run.events.begin())];
    errors.add(
        node,
        fmt::format("the gas returns to its start at {}, but the run ends at {}", home, run.until),
        fmt::format("use `until: {}` or more, or `at: {}` or less; "
                    "to render a part of a film, use `--to`",
                    home, 0.5 * run.until));
}

// In order of time, with their nodes.
void sort_events(RunDraft& draft) {
    std::vector<std::size_t> order(draft.run.events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return draft.run.events[k].at; });
    const RunDraft before = draft;
    for (std::size_t k = 0; k < order.size(); ++k) {
        draft.run.events[k] = before.run.events[order[k]];
        draft.event_nodes[k] = before.event_nodes[order[k]];
    }
    std::ranges::stable_sort(draft.marks, {}, &Mark::at);
    std::ranges::stable_sort(draft.captions, {},
                             [](const Placed<Caption>& one) { return one.value.at; });
}

KeyTable<RunReading> run_table(int dimension) {
    std::vector<Binding<RunReading>> keys = within<RunReading>(
        &RunDraft::run,
        {bind_key("until", &Run::until, number(positive), "The end of the run, in simulated time.")
             .required(),
         bind_key("equilibrate", &Run::equilibrate, number(not_negative),
                  "Simulated time before time 0, neither shown nor counted."),
         bind_key("sample_every", &Run::sample_every, number(positive),
                  "Simulated time between two samples of the statistics: at 0, at its "
                  "multiples, and at the end.")
             .default_text("until / (frames - 1) with a film, until / 1000 without"),
         bind_key("precision", &Run::bits, bits_notation(),
                  "The precision of the arithmetic: `double`, with 53 bits; a number of bits; or "
                  "`auto`, as many bits as the return after every reversal needs, found by trial."),
         bind_key("tolerance", &Run::tolerance,
                  number({1e-300, 1.0, "radius from the exact return"}),
                  "How close to its place `precision: auto` must return every particle, in units "
                  "of the smallest radius; for points on a wire, of the length per point.")});
    keys.push_back(bind_key("events", &RunReading::events,
                            list_of(placed(mapping(event_table(dimension))), 0, most_events,
                                    "a list of events"),
                            "What happens during the run, a list of {at: time, action}.")
                       .default_text("none"));
    return {.name = "`run`",
            .keys = std::move(keys),
            .refused = inelastic_keys(),
            .rule = [](RunReading& draft, const Node& node, Reading& reading) {
                draft.precision = given(node, "precision");
                check_samples(draft.run, given(node, "sample_every"), reading.errors);
                for (const Placed<EventDraft>& event : draft.events)
                    add_event(event.value, *event.node, draft, reading.errors);
                sort_events(draft);
                check_way_home(draft, reading.errors);
            }};
}

}  // namespace

Notation<RunDraft> run_notation(int dimension) {
    return mapped(mapping(run_table(dimension)),
                  [](RunReading draft) { return RunDraft(std::move(draft)); });
}

void check_nudges(const RunDraft& draft, const Gas& gas, Errors& errors) {
    const auto count = particles_in(gas);
    const double size = gas.box.size.maxCoeff();
    for (std::size_t k = 0; k < draft.run.events.size(); ++k) {
        const auto* nudge = std::get_if<Perturbation>(&draft.run.events[k].action);
        if (nudge == nullptr) continue;
        const Node& node = *draft.event_nodes[k];
        if (count && nudge->particle >= *count)
            errors.add(*find(node, "particle"),
                       fmt::format("there is no particle {}", nudge->particle),
                       fmt::format("particles are numbered from 0 to {}, in the order in which "
                                   "`gas` lists them",
                                   *count - 1));
        const double x = parse_number(nudge->by[0]).value_or(0.0);
        const double y = parse_number(nudge->by[1]).value_or(0.0);
        const double length = std::hypot(x, y);
        const Node& by = *find(node, "by");
        // Ten bits of the nudge itself, at least, are to be seen.
        const double bits = 10.0 + std::log2(size) - std::log2(length);
        if (length == 0.0)
            errors.add(by, "a nudge of 0 moves nothing");
        else if (length >= size)
            errors.add(by, fmt::format("a nudge by {:.3g} leads out of the box", length));
        else if (draft.run.bits && *draft.run.bits < bits)
            errors.add(by,
                       fmt::format("a nudge by {:.3g} is lost in numbers of {} bits", length,
                                   *draft.run.bits),
                       fmt::format("`precision: auto`, or {:.0f} bits and more, have room for it",
                                   std::max<double>(least_bits, std::ceil(bits + 54.0))));
    }
}

void check_captions(const Scene& scene, const std::vector<Placed<Caption>>& drafts,
                    const Node& root, Errors& errors) {
    for (const auto& [section, key] :
         {std::pair{"run", "until"}, {"film", "seconds"}, {"film", "pace"}})
        if (is_overridden(root, section, key)) return;
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
                   "give a longer film (`film.seconds`), an earlier `at`, or a later one for the "
                   "next caption");
    }
}

}  // namespace carom
