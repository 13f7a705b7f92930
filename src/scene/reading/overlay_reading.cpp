#include "scene/reading/overlay_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/limits.h"
#include "scene/reading/camera/camera_reading.h"
#include "scene/reading/figure_reading.h"
#include "scene/reading/panel_reading.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

bool holds(const TimeSpan& span, double time) {
    return span.from <= time && (!span.until || time < *span.until);
}

// The keys of a span of time; `until` is the name of the second one.
std::vector<Binding<TimeSpan>> span_keys(const char* until) {
    return {bind_key("from", &TimeSpan::from, number(not_negative, quantities::time),
                     "The simulated time at which it appears."),
            bind_key(until, &TimeSpan::until, number(positive, quantities::time),
                     "The simulated time at which it disappears.")
                .default_text("the end of the film")};
}

void check_span(const TimeSpan& span, const Node& node, const char* until, Reading& reading) {
    if (span.until && *span.until <= span.from)
        reading.errors.add(node,
                           fmt::format("expected `from` below `{}`, found {} and {}", until,
                                       span.from, *span.until),
                           "write the earlier time as `from`");
    else if (const Node* from = given(node, "from"))
        check_begin(*from, "from", span.from, reading);
}

Notation<Spotlight> spotlight_notation() {
    struct Draft : TimeSpan {
        std::vector<Chosen> of;
    };
    const std::vector of{bind_key("of", &Draft::of, chosen_notation(),
                                  "Which particles: a species, a particle by its number, or "
                                  "several of these.")
                             .required()
                             .formerly("on")
                             .tried_as({"particles", "particle", "species"})};
    const KeyTable<Draft> table{.name = "an item of `spotlight`",
                                .keys = joined<Draft>(span_keys("to"), of),
                                .rule = [](Draft& draft, const Node& node, Reading& reading) {
                                    check_span(draft, node, "to", reading);
                                }};
    return mapped(complete_mapping(table, "{from: time, to: time, of: particles}"),
                  [](const Draft& draft) {
                      return Spotlight{draft, draft.of};
                  });
}

std::optional<CalloutDraft> callout_on_particle(const std::vector<Chosen>& chosen, const Node& node,
                                                Reading& reading) {
    if (chosen.empty()) return std::nullopt;  // reported
    const auto particle = only_one(chosen.front(), reading.gas);
    CalloutDraft draft;
    draft.on_node = &node;
    if (particle && chosen.size() == 1) {
        draft.on = *particle;
        return draft;
    }
    reading.errors.add(node, "a callout points to one particle",
                       "give its number, or a species with `count: 1`");
    return std::nullopt;
}

// The target of a callout, read into a draft without text.
Notation<CalloutDraft> target_notation() {
    struct Target {
        const Node* panel = nullptr;
        PlotPoint point;
        double x = 0.0;
        std::optional<double> y;
    };
    const KeyTable<Target> table{
        .name = "`points_to`",
        .keys = {bind_key("panel", &Target::panel, kept(text(1, most_title_letters)),
                          "A panel of the film, by its kind or its title.")
                     .required(),
                 bind_key("x", &Target::x, number_of_any_quantity(any_number),
                          "The place on its horizontal axis.")
                     .required(),
                 bind_key("y", &Target::y, number_of_any_quantity(any_number),
                          "The place on its vertical axis.")
                     .default_text("the top of the bar or line at `x`")}};
    const auto of_plot = parsed(complete_mapping(table, "{panel: kind, x: value}"),
                                [](const Target& target, const Node& node, Reading&) {
                                    CalloutDraft draft;
                                    draft.on = PlotPoint{0, target.x, target.y};
                                    draft.panel = target.panel;
                                    draft.on_node = &node;
                                    return std::optional(draft);
                                });
    return either(parsed(chosen_notation(), callout_on_particle), of_plot);
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

Notation<std::vector<CalloutDraft>> callouts_notation() {
    struct Written {
        double at = 0.0, seconds = Callout{}.seconds;
        std::optional<CalloutDraft> on;
        std::string words;
    };
    const KeyTable<Written> table{
        .name = "an item of `callouts`",
        .keys = {bind_key("at", &Written::at, number(not_negative, quantities::time),
                          "The simulated time at which it appears.")
                     .required(),
                 bind_key("for", &Written::seconds, number({1.0, most_seconds}),
                          "How long it is shown, in seconds of film."),
                 bind_key("points_to", &Written::on, target_notation(),
                          "What it points to: a particle by its number, the only one of a species, "
                          "or a place in a panel's plot.")
                     .required()
                     .formerly("on")
                     .tried_as({"of", "to", "at_particle", "target", "particle"}),
                 bind_key("text", &Written::words, with_formulas(text(1, most_caption_letters)),
                          "Its words, with formulae between `$` signs.")
                     .tried_as({"words", "label", "caption"})
                     .required()}};
    const auto complete = [](const Written& written, const Node& node, Reading& reading) {
        check_begin(*given(node, "at"), "at", written.at, reading);
        std::optional<CalloutDraft> draft = written.on;
        if (!draft) return draft;
        draft->at = written.at;
        draft->seconds = written.seconds;
        draft->words = written.words;
        return draft;
    };
    return list_of(
        parsed(complete_mapping(table, "{at: time, points_to: particle, text: words}"), complete),
        0, most_overlays, "a list of {at, points_to, text}");
}

namespace {

Binding<Film> fade_out_key() {
    const KeyTable<FadeOut> table{
        .name = "`fade_out`",
        .keys = {
            bind_key("within", &FadeOut::within, region_notation("within"),
                     "The part of the box: [x0, y0, x1, y1]; on a wire [x0, x1]; in space [x0, y0, "
                     "z0, x1, y1, z1].")
                .required(),
            bind_key("seconds", &FadeOut::seconds, number(positive),
                     "How long it takes, in seconds of film.")}};
    return bind_key("fade_out", &Film::fade_out,
                    complete_mapping(table, "{within: [x0, y0, x1, y1], seconds: number}"),
                    "Particles fade out after they have entered this part of the box, until a "
                    "trace of them is left, and stand out again when they leave it.")
        .default_text("none");
}

}  // namespace

std::vector<Binding<Film>> overlay_keys() {
    return {bind_key("spotlight", &Film::spotlights,
                     list_of(spotlight_notation(), 0, most_overlays, "a list of {from, to, of}"),
                     "Highlights particles for a while by dimming all others.")
                .default_text("none"),
            camera_key(), viewpoint_key(), fade_out_key(), field_key()};
}

std::vector<Callout> resolve_callouts(const std::vector<CalloutDraft>& drafts,
                                      const std::vector<PanelSpec>& panels, PanelKinds kinds,
                                      Errors& errors) {
    std::vector<Callout> callouts;
    for (const CalloutDraft& draft : drafts) {
        Callout callout = draft;
        if (draft.panel != nullptr) {
            const std::string& name = draft.panel->text;
            const auto found = std::ranges::find_if(panels, [&](const PanelSpec& panel) {
                return panel.kind == name || panel.title == name;
            });
            std::vector<std::string> names;
            for (const PanelSpec& panel : panels) names.push_back(panel.kind);
            if (found == panels.end()) {
                errors.add(
                    *draft.panel, fmt::format("the film has no panel {}", in_quotes(name)),
                    names.empty() ? "it has no panels" : "there are " + listed(names, "and", "`"));
                continue;
            }
            if (const PanelKind* kind = kind_of(kinds, found->kind);
                kind != nullptr && !kind->has_plot) {
                errors.add(*draft.panel,
                           fmt::format("a panel of kind `{}` has no axes to point to", found->kind),
                           "point to a particle, or to a panel with a plot");
                continue;
            }
            if (!holds(found->show, callout.at)) {
                const auto [from, until] = found->show;
                errors.add(
                    *draft.panel,
                    fmt::format("the panel {} is not shown at {}", in_quotes(name), callout.at),
                    until ? fmt::format("it is shown from {} to {}", from, *until)
                          : fmt::format("it is shown from {} on", from));
                continue;
            }
            std::get<PlotPoint>(callout.on).panel =
                static_cast<std::size_t>(found - panels.begin());
        }
        callouts.push_back(std::move(callout));
    }
    return callouts;
}

// The file is named as templates are: it lies in the scene's folder.
Binding<Film> beside_key() {
    struct Written : ComparedRun {
        std::string own_label, file;
        std::optional<std::string> own_color;
        bool is_overlaid = false;
    };
    const auto check_file = [](const std::string& name, const Node& node, Reading& reading) {
        if (name.find('/') != std::string::npos || !name.ends_with(".yaml"))
            reading.errors.add(node,
                               fmt::format("expected the name of a scene file in the folder of "
                                           "this scene, found {}",
                                           in_quotes(name)),
                               "for instance other.yaml");
    };
    const auto check = [](Written& beside, const Node& node, Reading& reading) {
        place_run(beside, node, reading);
        for (const std::string& change : beside.values)
            if (change.starts_with("film") || change.starts_with("figures") ||
                change.starts_with("run.until="))
                reading.errors.add(
                    *given(node, "set"),
                    fmt::format("{} would change the {}, which both runs share", in_quotes(change),
                                change.starts_with("run") ? "end of the run" : "film"),
                    "set it in the scene itself");
        if (beside.label == beside.own_label)
            reading.errors.add(node, "both runs have the same label",
                               "each run needs a `label` of its own");
    };
    const auto check_box = [](const bool& is_overlaid, const Node& node, Reading& reading) {
        const int dimension = reading.box().dimension;
        if (is_overlaid && dimension != 2)
            reading.errors.add(node, "two runs share one box in a plane only",
                               fmt::format("leave it out: each {} has a place of its own",
                                           dimension == 1 ? "wire" : "box"));
    };
    auto label = label_key();
    label.key.meaning = "The words under the other run, and in legends.";
    const std::vector file{
        bind_key("scene", &Written::file, checked(text(6, most_title_letters), check_file),
                 "Another scene in the same folder, whose gas and run are shown as the other run.")
            .default_text("the scene itself")};
    const std::vector own_label{
        bind_key("own_label", &Written::own_label, text(1, most_name_letters),
                 "The words under the scene's own run.")
            .required(),
        bind_key("own_color", &Written::own_color, color(),
                 "The colour of the scene's own run in plots, and of its disks where both runs are "
                 "in one box.")
            .default_text("by its place"),
        bind_key("overlaid", &Written::is_overlaid, checked(flag(), check_box),
                 "Whether both runs are shown in one box: the disks of the "
                 "scene's own filled, those of the other as rings, each in "
                 "the colour that the run has in plots. Not with a camera "
                 "or a field.")};
    const KeyTable<Written> table{
        .name = "`beside`",
        .keys = joined<Written>(
            std::vector{std::move(label).required(), changes_key(), run_color_key()}, file,
            own_label),
        .choices = {{.names = {"set", "scene"}, .required = true}},
        .rule = check};
    const auto made = [](const Written& written) {
        return FilmRuns{written.own_label, written.own_color, {written}, written.is_overlaid};
    };
    return bind_key(
               "beside", &Film::runs,
               mapped(complete_mapping(table, "{label: words, own_label: words, set: ...}"), made),
               "Another run that the film shows beside its own, at the same times, with the "
               "same colours and axes: the same scene with other values, or another scene.")
        .default_text("none");
}

void check_beside(const Film& film, const Node& node, PanelKinds kinds, Errors& errors) {
    const Node* panels = find(node, "panels");
    for (const PanelSpec& panel : film.panels)
        if (const PanelKind* kind = kind_of(kinds, panel.kind);
            film.runs.others.empty() && kind != nullptr && kind->can(Ability::two_runs))
            errors.add(panels != nullptr ? *panels : node,
                       fmt::format("a panel of kind `{}` needs a second run", panel.kind),
                       "give the film `beside`");
    for (const char* key : {"camera", "field"})
        if (const Node* written = given(node, key); written && film.runs.is_overlaid)
            errors.add(*written, fmt::format("two runs in one box have no `{}`", key),
                       "leave it out, or leave out `overlaid`");
    if (film.runs.others.empty() || panels == nullptr ||
        panels->source->origin == Origin::template_file ||
        film.panels.size() != panels->items.size())  // one could not be read
        return;
    const std::vector<std::string> able = kinds_that_can(kinds, Ability::comparison);
    for (std::size_t i = 0; i < film.panels.size(); ++i) {
        const PanelKind* kind = kind_of(kinds, film.panels[i].kind);
        if (kind != nullptr && (!kind->shows_run || kind->can(Ability::comparison))) continue;
        errors.add(panels->items[i],
                   fmt::format("a panel of kind `{}` cannot show two runs", film.panels[i].kind),
                   "these can: " + listed(able, "and", "`"));
    }
}

}  // namespace carom
