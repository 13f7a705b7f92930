#include "scene/reading/event_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/limits.h"
#include "scene/reading/gas_reading.h"
#include "scene/time/captions.h"
#include "scene/yaml/scalar.h"
#include "util/overloaded.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr std::int32_t no_surface = -1;  // until its name is resolved

const char* displacement(int dimension) {
    return dimension == 1 ? "dx" : dimension == 2 ? "[dx, dy]" : "[dx, dy, dz]";
}

// The displacement is kept as the text in the file, because a double cannot hold all of its digits.
Notation<Displacement> digits(int dimension) {
    return parsed(vector_of(dimension, any_number, quantities::length, displacement(dimension)),
                  [](const Vec&, const Node& node, Reading&) {
                      Displacement by{"0", "0", "0"};
                      if (node.items.empty()) by[0] = node.text;
                      for (std::size_t axis = 0; axis < node.items.size(); ++axis)
                          by.at(axis) = node.items[axis].text;
                      return std::optional(by);
                  });
}

Notation<Perturbation> nudge_notation(int dimension) {
    const KeyTable<Perturbation> table{
        .name = "`nudge`",
        .keys = {
            bind_key("particle", &Perturbation::particle, whole(0, most_particles),
                     "The number of the particle, counted from 0 in the order in which `gas` "
                     "lists them.")
                .required(),
            bind_key("by", &Perturbation::by, digits(dimension),
                     "The displacement, read with all its digits; it may be as small as 1e-300.")
                .required()}};
    return complete_mapping(table, fmt::format("{{particle: i, by: {}}}", displacement(dimension)));
}

/// An item's `heat`.
struct HeatDraft {
    const Node* of = nullptr;
    std::optional<double> by;
    std::optional<double> to;
};

Notation<Heat> heat_notation() {
    struct Target {
        double temperature = 0.0;
    };
    const auto target = mapped(
        complete_mapping(
            KeyTable<Target>{
                .name = "`to`",
                .keys = {bind_key("temperature", &Target::temperature,
                                  number(positive, quantities::temperature), "The temperature.")
                             .required()}},
            "{temperature: T}"),
        [](const Target& its) { return its.temperature; });
    const KeyTable<HeatDraft> table{
        .name = "`heat`",
        .keys = {bind_key("of", &HeatDraft::of, kept(text(1, most_name_letters)),
                          "A species, or `all` particles.")
                     .default_text("`all`"),
                 bind_key("by", &HeatDraft::by, number(any_number, quantities::energy),
                          "The total energy added; a negative number removes energy."),
                 bind_key("to", &HeatDraft::to, target,
                          "Instead of `by`: the temperature to reach.")},
        .choices = {{{"by", "to"}, true}}};
    return parsed(mapping(table, "{of: all, by: E} or {to: {temperature: T}}"),
                  [](const HeatDraft& draft, const Node&, Reading&) -> std::optional<Heat> {
                      if (!draft.by && !draft.to) return std::nullopt;
                      Heat heat;
                      if (draft.to) heat.amount = Temperature{*draft.to};
                      if (draft.by) heat.amount = *draft.by;
                      return heat;
                  });
}

std::vector<Binding<EventDraft>> event_keys(int dimension) {
    const Notation<const Node*> surface = kept(text(1, most_name_letters));
    return {
        bind_key("at", &EventDraft::at, number(not_negative, quantities::time),
                 "When, in simulated time, before `until`.")
            .required()
            .tried_as({"time", "t", "when"}),
        bind_key("reverse", &EventDraft::reverses, one_of<bool>({{"velocities", true}}),
                 "Reverses all velocities; a run with one reversal must last until the gas has "
                 "returned, at twice the time of the reversal."),
        bind_key("nudge", &EventDraft::nudge, nudge_notation(dimension),
                 "Moves one particle by a small amount, which shows how sensitive the "
                 "return after a reversal is."),
        bind_key("open", &EventDraft::open, surface,
                 "Opens this partition: from now on, particles pass as if it were absent."),
        bind_key("close", &EventDraft::close, surface,
                 "Closes an open partition; no particle may be in its way."),
        bind_key("move", &EventDraft::move, surface,
                 "Moves this side or partition at `velocity` from now on."),
        bind_key("hold", &EventDraft::hold, surface, "Stops this piston and holds it in place."),
        bind_key("release", &EventDraft::release, surface, "Releases a piston that is held."),
        bind_key("wall", &EventDraft::wall, surface,
                 "Changes how this side or partition acts from now on: give `temperature`, `mass` "
                 "(and `force`), `velocity`, `diffuse` or `solid`."),
        bind_key("heat", &EventDraft::heat, heat_notation(),
                 "Adds energy to particles, or removes it, by scaling their velocities; along an "
                 "axis where momentum is conserved, relative to their mean."),
        bind_key("mark", &EventDraft::mark, text(1, most_name_letters),
                 "Outlines the positions that the particles have at this time, with these words, "
                 "until the next mark."),
        bind_key("caption", &EventDraft::caption, with_formulas(text(0, most_caption_letters)),
                 "A line of text under the gas, shown until the next one; \"\" removes it. Write "
                 "formulae between `$` signs.")
            .tried_as({"text", "words", "label", "title", "subtitle"}),
        bind_key("pause", &EventDraft::pause, number({0.1, most_seconds}),
                 "Stops the film, and simulated time, for this many seconds, so that you can "
                 "speak. Pauses are included in the film's `seconds`; with `pace` they make the "
                 "film longer. Together they take at most half of the film."),
        bind_key("for", &EventDraft::seconds, number({least_caption_seconds, most_seconds}),
                 "The longest time that the caption is shown, in seconds of film.")
            .default_text("until the next caption"),
        bind_key(
            "mirror", &EventDraft::is_mirrored, flag(),
            "Whether the event is undone after a reversal of the velocities, as long after the "
            "reversal as it happened before it. If not, the gas does not return the way it came."),
        bind_key("solid", &EventDraft::solid, flag(),
                 "For a `wall` event: the wall only reflects from now on.")};
}

KeyTable<EventDraft> event_table(int dimension) {
    std::vector<Choice> choices = acting_choices(true);
    choices.insert(choices.begin(), {{"reverse", "nudge", "open", "close", "move", "hold",
                                      "release", "wall", "heat", "mark", "caption", "pause"},
                                     true});
    for (const char* key : {"temperature", "mass", "velocity", "diffuse"})
        choices.push_back({{"solid", key}});
    return {.name = "an item of `events`",
            .keys = joined<EventDraft>(event_keys(dimension), acting_keys(),
                                       std::vector<Binding<ActingDraft>>{diffuse_key()}),
            .choices = std::move(choices)};
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

// Returns the one of these keys that is given, and its value.
std::pair<const char*, const Node*> given_of(const Node& node,
                                             std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (const Node* value = given(node, key)) return {key, value};
    return {nullptr, nullptr};
}

// Refuses keys in events to which they do not apply: most of them describe the behaviour of a
// surface, which only some events set.
void check_beside(const EventDraft& event, const Node& node, Errors& errors) {
    const auto refuse = [&](const char* key, const char* applies) {
        if (const Node* its = given(node, key))
            errors.add(*its, fmt::format("`{}` does not apply to this event", key),
                       fmt::format("it applies to {}", applies));
    };
    if (event.wall == nullptr) {
        for (const char* key : {"temperature", "mass", "force", "until", "diffuse", "solid"})
            refuse(key, "`wall`");
        if (event.move == nullptr) refuse("velocity", "`move` and `wall`");
    }
    const auto [action, its] =
        given_of(node, {"open", "close", "move", "hold", "release", "wall", "heat"});
    if (action == nullptr)
        refuse("mirror", "`open`, `close`, `move`, `hold`, `release`, `wall` and `heat`");
    if (event.seconds && find(node, "caption") == nullptr)
        errors.add(*given(node, "for"), "`for` applies only to `caption`", "leave it out");
}

// Returns the new behaviour of a wall; nothing if there is a mistake.
std::optional<Behaviour> change_of(const EventDraft& event, const Node& node, Errors& errors) {
    const auto behaviour = behaviour_of(event, node, errors);
    if (event.until && *event.until <= event.at) {
        errors.add(*given(node, "until"), "`until` is not after `at`: the wall would not move",
                   "it is a time of the run, like `at`, not a duration");
        return std::nullopt;
    }
    if (!behaviour || event.solid || !only_reflects(*behaviour)) return behaviour;
    if (find(node, "solid") == nullptr || given(node, "solid") != nullptr)
        errors.add(node,
                   "a `wall` event needs `temperature`, `mass`, `velocity`, `diffuse` or `solid`",
                   "`solid: true` makes it a wall that only reflects");
    return std::nullopt;
}

}  // namespace

Notation<EventDraft> event_notation(int dimension) {
    return complete_mapping(event_table(dimension));
}

void add_event(const EventDraft& event, const Node& node, RunDraft& run, Errors& errors) {
    const auto add = [&](auto action, const Node* key) {
        run.events.push_back({event.at, std::move(action), event.is_mirrored});
        run.event_nodes.push_back(key);
    };
    check_time(event, *given(node, "at"), run.until, errors);
    check_beside(event, node, errors);
    if (event.reverses) add(ReverseVelocities{}, given(node, "reverse"));
    if (event.nudge) add(*event.nudge, given(node, "nudge"));
    if (event.open != nullptr) add(SetOpen{no_surface, true}, event.open);
    if (event.close != nullptr) add(SetOpen{no_surface, false}, event.close);
    if (event.hold != nullptr) add(HoldPiston{no_surface}, event.hold);
    if (event.release != nullptr) add(ReleasePiston{no_surface}, event.release);
    if (event.heat) add(*event.heat, given(node, "heat"));
    if (event.move != nullptr && event.velocity)
        add(MoveSurface{no_surface, *event.velocity}, event.move);
    if (event.move != nullptr && find(node, "velocity") == nullptr)
        errors.add(node, "a `move` event needs `velocity`", "`velocity: 0` stops it");
    if (event.wall != nullptr)
        if (const auto behaviour = change_of(event, node, errors))
            add(ChangeSurface{no_surface, *behaviour}, event.wall);
    if (event.mark) run.marks.push_back({event.at, *event.mark});
    if (event.pause) run.pauses.push_back({{event.at, *event.pause}, given(node, "pause")});
    if (event.caption)
        run.captions.push_back({{event.at, *event.caption, event.seconds}, given(node, "caption")});
}

namespace {

// Returns false if the name is not found.
bool resolve_species(Heat& heat, const Node& node, const std::vector<std::string>& species,
                     Errors& errors) {
    const Node* of = given(node, "of");
    if (of == nullptr || of->text == "all") return true;
    heat.species = species_named(*of, species, errors);
    return heat.species.has_value();
}

// Returns false if the name is not found.
bool resolve_surface(std::int32_t& surface, const Node& node, const PlacedSurfaces& surfaces,
                     int dimension, Errors& errors) {
    std::vector<std::string> names = surfaces.surfaces.names();
    if (dimension == 1) names.erase(names.begin() + 2, names.begin() + 4);
    const auto found = std::ranges::find(names, node.text);
    surface = static_cast<std::int32_t>(found - names.begin());
    if (found != names.end()) return true;
    if (std::ranges::find(surfaces.others, node.text) != surfaces.others.end()) return false;
    names.insert(names.end(), surfaces.others.begin(), surfaces.others.end());
    constexpr std::size_t most_listed = 12;
    errors.add(
        node, fmt::format("there is no wall, partition or obstacle {}", in_quotes(node.text)),
        spelling_hint(node.text, names,
                      names.size() > most_listed ? "give the `name` of one"
                                                 : "there are " + listed(names, "and", "`")));
    return false;
}

}  // namespace

void resolve_names(RunDraft& run, const PlacedSurfaces& surfaces,
                   const std::vector<std::string>& species, int dimension, Errors& errors) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < run.events.size(); ++k) {
        const Node& node = *run.event_nodes[k];
        const auto at_surface = [&](std::int32_t& surface) {
            return resolve_surface(surface, node, surfaces, dimension, errors);
        };
        const bool is_known = std::visit(
            Overloaded{[](ReverseVelocities&) { return true; }, [](Perturbation&) { return true; },
                       [&](SetOpen& its) { return at_surface(its.surface); },
                       [&](MoveSurface& its) { return at_surface(its.surface); },
                       [&](HoldPiston& its) { return at_surface(its.surface); },
                       [&](ReleasePiston& its) { return at_surface(its.surface); },
                       [&](ChangeSurface& its) { return at_surface(its.surface); },
                       [&](Heat& its) { return resolve_species(its, node, species, errors); }},
            run.events[k].action);
        if (!is_known) continue;
        std::swap(run.events[kept], run.events[k]);
        std::swap(run.event_nodes[kept++], run.event_nodes[k]);
    }
    run.events.resize(kept);
    run.event_nodes.resize(kept);
}

void check_nudges(const RunDraft& run, const Gas& gas, Errors& errors) {
    const auto count = particles_in(gas);
    const double size = gas.box.longest_side();
    const char* example = gas.box.dimension == 1   ? "1.0e-6"
                          : gas.box.dimension == 2 ? "[1.0e-6, 0]"
                                                   : "[1.0e-6, 0, 0]";
    for (std::size_t k = 0; k < run.events.size(); ++k) {
        const auto* nudge = perturbation_of(run.events[k]);
        if (nudge == nullptr) continue;
        const Node& node = *run.event_nodes[k];
        if (count && nudge->particle >= *count)
            report_no_particle(*find(node, "particle"), std::to_string(nudge->particle), *count,
                               errors);
        const auto along = [&](std::size_t axis) {
            return parse_number(nudge->by[axis]).value_or(0.0);
        };
        const double length = std::hypot(along(0), along(1), along(2));
        const Node& by = *find(node, "by");
        // At least ten bits of the displacement itself must be resolved.
        const double bits = 10.0 + std::log2(size) - std::log2(length);
        if (length == 0.0)
            errors.add(by, "a nudge of 0 moves nothing",
                       fmt::format("for instance `by: {}`", example));
        else if (length >= size)
            errors.add(by, fmt::format("a nudge by {:.3g} leads out of the box", length),
                       fmt::format("a nudge is small, for instance `by: {}`", example));
        else if (run.bits && *run.bits < bits)
            errors.add(
                by,
                fmt::format("a nudge by {:.3g} is lost in numbers of {} bits", length, *run.bits),
                fmt::format("`precision: auto`, or {:.0f} bits and more, can hold it",
                            std::max<double>(least_bits, std::ceil(bits + 54.0))));
    }
}

}  // namespace carom
