#include "scene/run_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/captions.h"
#include "scene/limits.h"

namespace carom {
namespace {

void read_caption(const Fields& fields, double at, RunDraft& draft, Errors& errors) {
    const Node* seconds = fields.given("for");
    if (const auto words = fields.text("caption"))
        draft.captions.push_back({{at, *words, fields.number("for")}, fields.given("caption")});
    else if (seconds != nullptr && !fields.mentions("caption"))
        errors.add(*seconds, "`for` has no meaning without a caption", "it goes with `caption`");
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
    if (reverses) draft.run.events.push_back({*at, ReverseVelocities{}});
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

}  // namespace

RunDraft read_run(const Fields& scene, Errors& errors) {
    RunDraft draft;
    const auto fields = scene.inner("run");
    if (!fields) return draft;
    Run& run = draft.run;
    run.until = fields->number("until").value_or(0.0);
    run.equilibrate = fields->number("equilibrate").value_or(0.0);
    run.sample_every = read_sample_every(*fields, run, errors);
    if (const Node* events = fields->given("events"))
        for (const Node& item : events->items)
            if (item.is_mapping())
                read_event({item, section_of(fields->section(), "events")}, draft, errors);
    std::ranges::stable_sort(run.events, {}, &RunEvent::at);
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
