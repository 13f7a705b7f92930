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

void read_caption(const Fields& fields, double at, RunDraft& draft, Errors& errors) {
    const Node* seconds = fields.given("for");
    if (const auto words = fields.text("caption"))
        draft.captions.push_back({{at, *words, fields.number("for")}, fields.given("caption")});
    else if (seconds != nullptr && !fields.mentions("caption"))
        errors.add(*seconds, "`for` has no meaning without a caption", "it goes with `caption`");
}

void add_event(RunEvent event, const Node& node, RunDraft& draft) {
    draft.run.events.push_back(std::move(event));
    draft.event_nodes.push_back(&node);
}

// What is moved is kept as it is written: no double has all its digits.
void read_nudge(const Fields& fields, double at, RunDraft& draft) {
    const Node* by = fields.given("by");
    const auto particle = fields.integer("particle");
    if (by == nullptr || !particle) return;
    Perturbation nudge{.particle = *particle};
    if (by->is_scalar())
        nudge.by[0] = by->text;
    else
        nudge.by = {by->items[0].text, by->items[1].text};
    add_event({at, nudge}, fields.node(), draft);
}

std::optional<int> read_bits(const Fields& fields, RunDraft& draft, Errors& errors) {
    draft.precision = fields.given("precision");
    const std::string word = fields.text("precision").value_or("double");
    if (word == "auto") return std::nullopt;
    const int bits = static_cast<int>(fields.number("precision").value_or(bits_of_double));
    if (bits > bits_of_double && bits < least_bits)
        errors.add(*draft.precision,
                   fmt::format("expected `double`, `auto` or a whole number from {} to {} for "
                               "`precision`, found {}",
                               least_bits, most_bits, described(*draft.precision)),
                   fmt::format("{} bits are a double", bits_of_double));
    return bits;
}

void read_event(const Fields& fields, RunDraft& draft, Errors& errors) {
    const auto at = fields.number("at");
    if (!at) return;
    const Node& place = *fields.given("at");
    const double until = draft.run.until;
    const bool reverses = fields.given("reverse") != nullptr;
    if (until > 0.0 && *at >= until)
        errors.add(place,
                   fmt::format("expected a time {} and below `until` ({}) for `at`, found {}",
                               reverses ? "above 0" : "from 0 on", until, described(place)),
                   "the film ends at `until`: what happens then or later is never shown");
    else if (reverses && *at == 0.0)
        errors.add(place, "expected a positive number for `at` of a reversal, found `0`",
                   "nothing has happened yet that could be undone");
    if (reverses) add_event({*at, ReverseVelocities{}}, *fields.given("reverse"), draft);
    if (const auto nudge = fields.inner("nudge")) read_nudge(*nudge, *at, draft);
    if (const auto words = fields.text("mark")) draft.marks.push_back({*at, *words});
    read_caption(fields, *at, draft, errors);
}

double read_sample_every(const Fields& fields, const Run& run, Errors& errors) {
    const Node* node = fields.given("sample_every");
    if (node == nullptr) return 0.0;
    const double every = fields.number("sample_every").value_or(0.0);
    const double samples = run.until / every;
    if (samples > most_samples.value)
        errors.add(
            *node,
            fmt::format("a run until {} sampled every {} has {:.6g} samples", run.until, every,
                        samples),
            fmt::format("the ceiling is {:.0f} {}", most_samples.value, most_samples.meaning));
    return every;
}

bool is_overridden(const Fields& scene, const char* section, const char* key) {
    const auto fields = scene.inner(section);
    const Node* node = fields ? fields->given(key) : nullptr;
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
        node, fmt::format("the gas would be home at {}, and the run ends at {}", home, run.until),
        fmt::format("`until: {}` and more, or `at: {}` and less, have room for the way back; "
                    "`--to` renders a part of a film",
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
}

}  // namespace

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
            errors.add(by, "a nudge by 0 moves nothing");
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

RunDraft read_run(const Fields& scene, Errors& errors) {
    RunDraft draft;
    const auto fields = scene.inner("run");
    if (!fields) return draft;
    Run& run = draft.run;
    run.until = fields->number("until").value_or(0.0);
    run.equilibrate = fields->number("equilibrate").value_or(0.0);
    run.bits = read_bits(*fields, draft, errors);
    run.tolerance = fields->number("tolerance").value_or(run.tolerance);
    run.sample_every = read_sample_every(*fields, run, errors);
    if (const Node* events = fields->given("events"))
        for (const Node& item : events->items)
            if (item.is_mapping())
                read_event({item, section_of(fields->section(), "events")}, draft, errors);
    sort_events(draft);
    check_way_home(draft, errors);
    std::ranges::stable_sort(draft.marks, {}, &Mark::at);
    std::ranges::stable_sort(draft.captions, {},
                             [](const CaptionDraft& one) { return one.caption.at; });
    return draft;
}

void check_captions(const Scene& scene, const std::vector<CaptionDraft>& drafts,
                    const Fields& fields, Errors& errors) {
    for (const auto& [section, key] :
         {std::pair{"run", "until"}, {"film", "seconds"}, {"film", "pace"}})
        if (is_overridden(fields, section, key)) return;
    const std::vector<CaptionSpan> spans = caption_schedule(scene);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const CaptionSpan& span = spans[i];
        const double half_a_frame = 0.5 / scene.film.fps;
        if (span.words.empty() || span.end - span.start >= least_caption_seconds - half_a_frame)
            continue;
        errors.add(
            *drafts[i].node,
            fmt::format("the caption is on the screen for {:.3g} seconds of film, until {}; "
                        "expected at least {}",
                        span.end - span.start,
                        i + 1 < spans.size()
                            ? fmt::format("the next one at time {}", drafts[i + 1].caption.at)
                            : "the film ends",
                        least_caption_seconds),
            "a longer film (`film.seconds`) gives it more time, and so does an earlier `at`, or a "
            "later one for the next");
    }
}

}  // namespace carom
