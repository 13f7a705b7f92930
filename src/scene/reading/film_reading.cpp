#include "scene/reading/film_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scene/limits.h"
#include "scene/reading/panel_reading.h"
#include "scene/time/captions.h"
#include "scene/time/pace.h"
#include "scene/time/timeline.h"
#include "util/text.h"

namespace carom {
namespace {

Notation<PictureSize> size_notation() {
    const auto sides = [](const std::vector<std::int64_t>& pixels) {
        return PictureSize{static_cast<int>(pixels.at(0)), static_cast<int>(pixels.at(1))};
    };
    return either(
        one_of<PictureSize>(
            {{"2160p", {3840, 2160}}, {"1080p", {1920, 1080}}, {"720p", {1280, 720}}}),
        mapped(list_of(whole(smallest_side.value, largest_side), 2, 2, "[width, height]"), sides));
}

Binding<Film> velocities_key() {
    using Arrows = std::pair<bool, std::optional<double>>;
    const auto fill = [](Film& film, const Arrows& arrows) {
        std::tie(film.velocities, film.velocity_scale) = arrows;
    };
    const auto arrows = either(mapped(flag(),
                                      [](bool shown) {
                                          return Arrows{shown, {}};
                                      }),
                               mapped(number(positive), [](double scale) {
                                   return Arrows{true, scale};
                               }));
    return bind_with<Film>("velocities", fill, arrows,
                           "Arrows of velocity on disks and beads: whether to draw them, or the "
                           "simulated time that makes an arrow velocity * time long.")
        .default_value("false");
}

Notation<double> title_card_notation() {
    constexpr double usual_seconds = 3.0;
    Notation<double> seconds =
        either(mapped(flag(), [](bool shown) { return shown ? usual_seconds : 0.0; }),
               number({0.5, most_seconds.value, most_seconds.meaning}));
    seconds.write = [](double value) { return value > 0.0 ? number_text(value) : "false"; };
    return seconds;
}

Notation<Trails> trails_notation() {
    const KeyTable<Trails> table{
        .name = "`trails`",
        .keys =
            {bind_key(
                 "of", &Trails::of, chosen_notation(),
                 "Which particles: all, a species, a particle by its number, or several of these.")
                 .default_value("all"),
             bind_key("seconds", &Trails::seconds,
                      number({0.0, most_trail_seconds.value, most_trail_seconds.meaning}),
                      "How long they are, in seconds of film.")
                 .default_value("1")},
        .rule = [](Trails& trails, const Node& node, Reading&) {
            if (find(node, "of") != nullptr && given(node, "of") == nullptr) trails.of.clear();
        }};
    return mapping(table, "{of: particles, seconds: length}");
}

Notation<SlowDraft> slow_notation() {
    return mapping(KeyTable<SlowDraft>{
        .name = "an item of `slow`",
        .keys = {bind_key("from", &SlowDraft::from, number(not_negative), "Its first time."),
                 bind_key("to", &SlowDraft::to, number(positive), "Its last time, at most `until`.")
                     .default_text("until"),
                 bind_key("factor", &SlowDraft::factor, number({0.001, 1.0, {}}),
                          "The speed of the film there, relative to the rest.")
                     .required()}});
}

// How long the film is, and of what pictures.
std::vector<Binding<FilmDraft>> picture_keys() {
    return {
        bind_key("seconds", &FilmDraft::given_seconds,
                 number({0.01, most_seconds.value, most_seconds.meaning}),
                 "The length of the whole film, holds and pauses included."),
        bind_key("pace", &FilmDraft::pace, number(positive),
                 "Instead of seconds: simulated time in a second of film."),
        bind_key("fps", &Film::fps, whole(1, most_frames_per_second), "Frames in a second."),
        bind_key("size", &Film::size, size_notation(),
                 "The picture in pixels: a name, or width and height. H.264 and VP9 add a row or "
                 "a column to odd ones."),
        bind_key("theme", &Film::theme, one_of<ThemeName>(),
                 "The colours of background and text; `print` is black, white and greys, except "
                 "for colours that the scene gives."),
        bind_key("ground", &Film::transparent, one_of<bool>({{"theme", false}, {"none", true}}),
                 "The background: the theme's, or none, so that a slide shows through. Choose the "
                 "theme that suits the slide.")};
}

// What is drawn of the gas.
std::vector<Binding<Film>> gas_keys() {
    const auto palettes = word({"viridis", "cividis", "plasma", "inferno", "magma", "netlogo"});
    return {
        bind_key("color_by", &Film::color_by, one_of<ColorBy>(),
                 "What the colour of a disk means."),
        bind_key("palette", &Film::palette, palettes, "The colours from slow to fast.")
            .default_text("the theme's"),
        bind_key("labels", &Film::labels, one_of<Labels>(),
                 "What is written on the disks or beads where there is room: their mass, or their "
                 "number.")
            .default_text("none"),
        velocities_key(),
        bind_key("flashes", &Film::flashes, flag(),
                 "A short flash where two particles touch, at most three a second.")};
}

std::vector<Binding<FilmDraft>> film_keys(PanelKinds kinds) {
    std::vector<Binding<FilmDraft>> keys = picture_keys();
    for (const Binding<Film>& key : gas_keys()) keys.push_back(key);
    return joined(
        keys,
        {bind_key(
             "title_card", &Film::title_card, title_card_notation(),
             "A card with title and subtitle before the film: `true` for 3 seconds, or a number of "
             "seconds. It is part of the film's `seconds`; with `pace` it is added to them."),
         bind_key("end_card", &Film::end_card, text(1, most_title_letters),
                  "The text of a card of 4 seconds after the film, which is part of its `seconds` "
                  "too. Both cards together take at most a third of the film.")
             .default_text("none"),
         bind_key(
             "trails", &Film::trails, trails_notation(),
             "Trails that some of the particles leave; the `trail` of a species takes precedence.")
             .default_text("of single disks among many"),
         bind_key(
             "slow", &FilmDraft::spans,
             list_of(placed(slow_notation()), 0, most_slow_spans, "a list of {from, to, factor}"),
             "Slow motion over spans of simulated time; factor 0.1 is ten times slower. The film "
             "eases in before the span and out after it, over half a second each (in films shorter "
             "than five seconds, a tenth of the film), and shows ×0.1 beside the clock. With "
             "`seconds` the rest is "
             "faster, with `pace` the film is longer.")
             .default_text("none"),
         bind_key("monitors", &Film::monitors, monitors_notation(),
                  "The numbers in the row of monitors; all-collisions includes those with walls, "
                  "return-distance is the largest distance of a particle from where it was on the "
                  "way out.")
             .default_text("all but all-collisions and return-distance"),
         bind_key("panels", &Film::panels, panels_notation(kinds),
                  "What the panels show, each a kind or a mapping with options.")
             .default_text("the template's")});
}

const std::vector<Choice> film_choices{{{"seconds", "pace"}}};

bool is_inside(const Slot& slot, const LayoutSpec& layout) {
    constexpr double rounding = 1e-9;
    return slot.x + slot.width <= layout.grid_width + rounding &&
           slot.y + slot.height <= layout.grid_height + rounding;
}

void check_caption_line(const Node& line, const LayoutSpec& layout, Errors& errors) {
    const LayoutSpec with_line = with_caption_line(layout);
    std::vector<Slot> slots{with_line.title, with_line.gas, with_line.color_bar};
    if (with_line.monitors) slots.push_back(*with_line.monitors);
    slots.insert(slots.end(), with_line.panels.begin(), with_line.panels.end());
    if (std::ranges::any_of(slots, [](const Slot& slot) { return slot.height <= 0.0; }))
        errors.add(line, "the place for captions leaves another place without room");
}

/// A layout with the nodes of its places.
struct LayoutDraft : LayoutSpec {
    std::optional<Eigen::Array2d> grid;
    std::vector<Placed<Slot>> places;
};

// A place in the grid, which is looked at when the grid is known.
template <typename Field>
Binding<LayoutDraft> slot_key(std::string name, Field LayoutSpec::*field,
                              const Notation<Placed<Slot>>& slot, std::string meaning) {
    const auto fill = [field](LayoutDraft& layout, const Placed<Slot>& place) {
        layout.*field = place.value;
        layout.places.push_back(place);
    };
    return bind_with<LayoutDraft>(std::move(name), fill, slot, std::move(meaning));
}

Notation<Placed<Slot>> slot_notation() {
    const Range units{0.0, largest_grid.value, largest_grid.meaning};
    const auto slot = [](const std::vector<double>& sides) {
        return Slot{sides.at(0), sides.at(1), sides.at(2), sides.at(3)};
    };
    const auto check = [](const Slot& place, const Node& node, Reading& reading) {
        if (place.width <= 0.0 || place.height <= 0.0)
            reading.errors.add(node,
                               "expected [x, y, width, height] with a positive width and height");
    };
    return placed(
        checked(mapped(list_of(number(units), 4, 4, "[x, y, width, height]"), slot), check));
}

void complete_layout(LayoutDraft& layout, const Node& node, Reading& reading) {
    if (!layout.grid) return;
    layout.grid_width = (*layout.grid)[0];
    layout.grid_height = (*layout.grid)[1];
    for (const Placed<Slot>& place : layout.places)
        if (!is_inside(place.value, layout))
            reading.errors.add(*place.node,
                               fmt::format("the place reaches outside the grid of {} by {}",
                                           layout.grid_width, layout.grid_height));
    if (layout.caption) check_caption_line(*given(node, "caption"), layout, reading.errors);
}

KeyTable<LayoutDraft> layout_table() {
    const Range sides{1.0, largest_grid.value, largest_grid.meaning};
    const auto slot = slot_notation();
    const auto panels = [](LayoutDraft& layout, const std::vector<Placed<Slot>>& places) {
        for (const Placed<Slot>& place : places) layout.panels.push_back(place.value);
        layout.places.insert(layout.places.end(), places.begin(), places.end());
    };
    return {
        .name = "`layout`",
        .keys = {bind_key("grid", &LayoutDraft::grid, pair_of(sides, "[width, height]"),
                          "Width and height of the picture in units of the layout; one unit is the "
                          "smallest size of text.")
                     .required(),
                 slot_key("title", &LayoutSpec::title, slot, "The place of title and subtitle.")
                     .required(),
                 slot_key("gas", &LayoutSpec::gas, slot, "The place of the box.").required(),
                 slot_key("color_bar", &LayoutSpec::color_bar, slot,
                          "The place of the colour scale.")
                     .required(),
                 slot_key("caption", &LayoutSpec::caption, slot,
                          "The place of captions in films that have any; whatever overlaps it is "
                          "made smaller.")
                     .default_text("the foot of the gas's place"),
                 slot_key("monitors", &LayoutSpec::monitors, slot, "The place of the numbers.")
                     .default_text("none"),
                 bind_with<LayoutDraft>(
                     "panels", panels,
                     list_of(slot, 0, most_panels, "a list of [x, y, width, height]"),
                     "The places of the panels, in their order.")
                     .default_text("none")},
        .rule = complete_layout};
}

// A template laid over a scene by the command line shows the first of the scene's panels.
bool is_laid_over(const Node& film, const Node& panels) {
    const Node* asked = given(film, "template");
    return asked != nullptr && asked->source->origin == Origin::command_line &&
           panels.source->origin == Origin::scene;
}

std::string templates_hint(const std::vector<std::string>& names) {
    if (names.empty())
        return "no template that comes with carom has so many; write one of your own";
    return fmt::format("the {} {} enough", names.size() == 1 ? "template" : "templates",
                       listed(names, "and", "`") + (names.size() == 1 ? " has" : " have"));
}

void check_slots(const Node& node, Film& film, const TemplatesFor& templates, Errors& errors) {
    const Node* list = given(node, "panels");
    const std::size_t slots = film.layout.panels.size();
    if (list == nullptr || list->items.size() <= slots) return;
    if (is_laid_over(node, *list)) {
        film.panels.resize(std::min(film.panels.size(), slots));
        return;
    }
    errors.add(list->items[slots],
               fmt::format("the template `{}` has {} for panels, found {}", film.template_name,
                           counted(static_cast<long long>(slots), "place"),
                           counted(static_cast<long long>(list->items.size()), "panel")),
               templates_hint(templates(list->items.size())));
}

using Spans = std::vector<Placed<SlowSpan>>;

void check_spans(const Spans& spans, const Run& run, Errors& errors) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const auto& [span, node] = spans[i];
        if (span.from >= span.to)
            errors.add(*node, fmt::format("expected `from` below `to`, found {} and {}", span.from,
                                          span.to));
        else if (run.until > 0.0 && span.to > run.until)
            errors.add(*node, fmt::format("slow motion from {} to {} goes beyond `until` ({})",
                                          span.from, span.to, run.until));
        else if (i > 0 && spans[i - 1].value.to > span.from)
            errors.add(*node, fmt::format("slow motion from {} to {} overlaps that from {} to {}",
                                          span.from, span.to, spans[i - 1].value.from,
                                          spans[i - 1].value.to));
    }
}

// In order of time; those of which nothing is missing.
Spans spans_of(const FilmDraft& draft, Reading& reading) {
    Spans spans;
    const double until = reading.run.until;
    for (const auto& [span, node] : draft.spans)
        if (span.factor && until > 0.0)
            spans.push_back({{span.from, span.to.value_or(until), *span.factor}, node});
    std::ranges::stable_sort(spans, {}, [](const Placed<SlowSpan>& one) { return one.value.from; });
    check_spans(spans, reading.run, reading.errors);
    return spans;
}

void check_easing(const Film& film, const Run& run, const Spans& drafts, Errors& errors) {
    const double seconds = static_cast<double>(moving_steps(film, run)) / film.fps;
    const auto shortage = easing_shortage(film.slow, run.until, seconds);
    if (!shortage) return;
    const SlowSpan& span = film.slow[shortage->span];
    const Node& place = *drafts[shortage->span].node;
    const std::string longer = "a longer film (`film.seconds`) needs less";
    if (!std::isfinite(shortage->needed))
        return errors.add(
            place,
            fmt::format(
                "the gas moves for {:.3g} seconds of this film, too short to ease in and out "
                "of slow motion over {:.3g} seconds each time",
                seconds, easing_seconds(seconds)),
            "give a longer film (`film.seconds`)");
    errors.add(
        place,
        fmt::format("slow motion from {} to {} eases {} over {:.3g} seconds of film, {:.3g} of "
                    "simulated time; {} it there is {:.3g}",
                    span.from, span.to, shortage->before ? "in" : "out", easing_seconds(seconds),
                    shortage->needed, shortage->before ? "before" : "after",
                    std::max(0.0, shortage->room)),
        shortage->before && shortage->span == 0 ? longer + ", one that begins with `from: 0` none"
        : !shortage->before && shortage->span + 1 == film.slow.size()
            ? fmt::format("{}, one that ends with `to: {}` none", longer, run.until)
            : longer + "; or put the spans farther apart");
}

// The place to mend a length: where it is given, or where the run's end is.
const Node& place_of_length(const Node& film, const Node& root) {
    for (const char* key : {"seconds", "pace"})
        if (const Node* node = given(film, key)) return *node;
    if (const Node* run = given(root, "run"); run != nullptr && run->is_mapping())
        if (const Node* until = given(*run, "until")) return *until;
    return film;
}

bool check_frames(const Film& film, const Node& node, const Node& root, Errors& errors) {
    const double frames = std::round(film.seconds * film.fps);
    if (frames >= 2.0 && frames <= most_frames.value) return true;
    const bool has_seconds = given(node, "seconds") != nullptr;
    std::string hint =
        frames < 2.0 ? "a film has at least 2 frames"
                     : fmt::format("the limit is {} {}", most_frames.value, most_frames.meaning);
    if (!has_seconds) hint += "; give `film.seconds`, or another `film.pace`";
    errors.add(place_of_length(node, root),
               fmt::format("a film of {:.6g} seconds at {} frames a second has {:.6g} {}",
                           film.seconds, film.fps, frames, frames == 1.0 ? "frame" : "frames"),
               hint);
    return false;
}

// Each part of the run between reversals needs a frame for its end.
void check_legs(const Film& film, const Run& run, const Node& root, Errors& errors) {
    const int legs = branch_count(run);
    const int steps = moving_steps(film, run);
    const Node* node = given(root, "run");
    const Node* events = node != nullptr && node->is_mapping() ? given(*node, "events") : nullptr;
    if (legs <= steps || events == nullptr) return;
    const int enough = (4 * (legs + 1) + 2) / 3;  // pauses leave at least 3/4 of the frames, less 1
    const double with_cards = card_seconds(film) > 0.0 ? 1.5 : 1.0;
    const double seconds = std::ceil(10.0 * with_cards * enough / film.fps) / 10.0;
    errors.add(
        *events,
        fmt::format("{} {} the run into {} parts, but a film of {} can show only {}",
                    counted(legs - 1, "reversal"), legs == 2 ? "divides" : "divide", legs,
                    counted(frame_count(film), "frame"), steps),
        fmt::format("give fewer events, or a longer film: {} seconds are enough (`film.seconds`)",
                    seconds));
}

}  // namespace

KeyTable<FilmDraft> film_table(PanelKinds kinds) {
    std::vector<Binding<FilmDraft>> keys{
        bind_key("template", &Film::template_name, text(1, most_title_letters),
                 "The layout: a file in the scene's folder or in templates/films, by name.")};
    return {.name = "`film`", .keys = joined(keys, film_keys(kinds)), .choices = film_choices};
}

KeyTable<FilmDraft> template_table(PanelKinds kinds) {
    std::vector<Binding<FilmDraft>> keys = film_keys(kinds);
    const auto ignore = [](FilmDraft&, const Node*) {};  // read_layout() reads it
    keys.push_back(bind_with<FilmDraft>("layout", ignore, kept(mapping(layout_table())),
                                        "Where everything is in a frame.")
                       .required());
    return {.name = "a template", .keys = std::move(keys), .choices = film_choices};
}

std::optional<LayoutSpec> read_layout(const Node& template_file, Reading& reading) {
    const Node* node = given(template_file, "layout");
    if (node == nullptr || !node->is_mapping()) return std::nullopt;
    LayoutDraft layout;
    layout_table().read(*node, layout, reading);
    const bool has_panels = find(*node, "panels") == nullptr || given(*node, "panels") != nullptr;
    return layout.grid && has_panels ? std::optional<LayoutSpec>(layout) : std::nullopt;
}

Film complete_film(const FilmDraft& draft, const Node& node, const Node& root,
                   const std::optional<LayoutSpec>& layout, const TemplatesFor& templates,
                   Reading& reading) {
    Film film = draft;
    const Run& run = reading.run;
    film.layout = layout.value_or(LayoutSpec{});
    const Spans spans = spans_of(draft, reading);
    for (const Placed<SlowSpan>& span : spans) film.slow.push_back(span.value);
    film.seconds = draft.given_seconds.value_or(seconds_at_pace(film.slow, run.until, draft.pace) +
                                                card_seconds(film));
    if (film.seconds > 0.0 && check_frames(film, node, root, reading.errors)) {
        check_legs(film, run, root, reading.errors);
        if (reading.errors.empty()) check_easing(film, run, spans, reading.errors);
    }
    if (layout) check_slots(node, film, templates, reading.errors);
    return film;
}

}  // namespace carom
