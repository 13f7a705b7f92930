#include "scene/reading/film_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "physics/gas.h"
#include "scene/limits.h"
#include "scene/reading/film_length.h"
#include "scene/reading/panel_reading.h"
#include "scene/reading/template.h"
#include "util/text.h"

namespace carom {
namespace {

Notation<PictureSize> size_notation() {
    const auto sides = [](const std::vector<std::int64_t>& pixels) {
        return PictureSize{static_cast<int>(pixels.at(0)), static_cast<int>(pixels.at(1))};
    };
    return either(
        one_of<PictureSize>(
            {{"2160p", {3840, 2160}}, {"1080p", {1920, 1080}}, {"720p", {1280, 720}}})
            .with_elsewhere({{"4k", "4K is `2160p`"},
                             {"uhd", "UHD is `2160p`"},
                             {"8k", "8K is `[7680, 4320]`"},
                             {"2k", "write `1080p`, or `[2560, 1440]`"},
                             {"1440p", "write `[2560, 1440]`"},
                             {"480p", "write `[854, 480]`"},
                             {"360p", "write `[640, 360]`"},
                             {"hd", "HD is `720p`, full HD is `1080p`"},
                             {"fhd", "full HD is `1080p`"},
                             {"full hd", "full HD is `1080p`"}}),
        mapped(list_of(whole(smallest_side.value, largest_side), 2, {2}, "[width, height]"),
               sides));
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
                               mapped(number(positive, quantities::time), [](double scale) {
                                   return Arrows{true, scale};
                               }));
    return bind_with<Film>("velocities", fill, arrows,
                           "Velocity arrows on disks and beads: whether to draw them, or their "
                           "scale as a simulated time: an arrow is velocity * time long.")
        .default_value("false");
}

Notation<double> title_card_notation() {
    constexpr double usual_seconds = 3.0;
    Notation<double> seconds =
        either(mapped(flag(), [](bool shown) { return shown ? usual_seconds : 0.0; }),
               number({0.5, most_seconds}));
    seconds.write = [](double value) { return value > 0.0 ? number_text(value) : "false"; };
    return seconds;
}

Notation<Trails> trails_notation() {
    const auto in_a_plane = [](std::int64_t seeds, const Node& node, Reading& reading) {
        if (seeds > 0 && reading.box().dimension != 2)
            reading.errors.add(node, "paths in other runs are drawn in a plane only",
                               "leave it out, or show another run by `beside`");
    };
    const KeyTable<Trails> table{
        .name = "`trails`",
        .keys = {
            bind_key(
                "of", &Trails::of, chosen_notation(),
                "Which particles: all, a species, a particle by its number, or several of these.")
                .default_value("all"),
            bind_key("seconds", &Trails::seconds, number({0.0, most_trail_seconds}),
                     "The length of the trails, in seconds of film.")
                .default_value("1"),
            bind_key("seeds", &Trails::seeds, checked(whole(0, most_seed_paths), in_a_plane),
                     "The number of runs with the seeds after the scene's own in which the paths "
                     "of all particles with trails are drawn too, thin and faint, from the start "
                     "on.")}};
    return mapping(table, "{of: particles, seconds: length}");
}

Notation<SlowSpan> slow_notation() {
    return complete_mapping(KeyTable<SlowSpan>{
        .name = "an item of `slow`",
        .keys = {bind_key("from", &SlowSpan::from, number(not_negative, quantities::time),
                          "The simulated time at which it begins."),
                 bind_key("to", &SlowSpan::to, number(positive, quantities::time),
                          "The simulated time at which it ends, at most `until`.")
                     .default_text("until"),
                 bind_key("factor", &SlowSpan::factor, number({0.001, {1.0}}),
                          "The speed of the film there, relative to the rest.")
                     .required()}});
}

Binding<Film> sound_key() {
    const KeyTable<Sound> table{
        .name = "`sound`",
        .keys = {
            bind_key(
                "of", &Sound::of, one_of<SoundOf>(),
                "What is heard: all collisions, including those with walls and other surfaces."),
            bind_key("loudness", &Sound::loudness, number({0.01, {1.0}}),
                     "The largest sample, as a share of full scale. Where clicks come so close "
                     "that together they would be louder, all of them are softened."),
            bind_key("reference", &Sound::reference, number(positive, quantities::momentum),
                     "The impulse of a collision that sounds at 880 Hz. Twice the impulse is "
                     "an octave higher; pitches lie between 220 and 7040 Hz.")
                .default_text("the momentum of a particle of the mean mass and the mean "
                              "kinetic energy at the start")}};
    using Written = std::optional<Sound>;
    const auto none = mapped(one_of<bool>({{"none", false}}), [](bool) { return Written{}; });
    const auto usual = mapped(one_of<SoundOf>().with_elsewhere({{"yes", "write `collisions`"},
                                                                {"true", "write `collisions`"},
                                                                {"on", "write `collisions`"},
                                                                {"no", "write `none`"},
                                                                {"false", "write `none`"},
                                                                {"off", "write `none`"}}),
                              [](SoundOf of) { return Written{{.of = of}}; });
    const auto whole = mapped(mapping(table, "{of: collisions, loudness: 0.3}"),
                              [](const Sound& sound) { return Written{sound}; });
    return bind_with<Film>(
               "sound", [](Film& film, const Written& sound) { film.sound = sound; },
               either(either(none, usual), whole),
               "A soft click for each collision when the film shows it, higher in pitch for a "
               "larger impulse: AAC in MP4, Opus in WebM; other formats are silent. With two runs "
               "side by side, the scene's own is heard.")
        .default_value("none");
}

// Keys for the length and the pictures of the film.
std::vector<Binding<FilmDraft>> picture_keys() {
    return {
        bind_key("seconds", &FilmDraft::given_seconds, number({0.01, most_seconds}),
                 "The length of the whole film, cards and pauses included.")
            .tried_as({"duration", "length", "time"}),
        bind_key("pace", &FilmDraft::pace, number(positive, quantities::time),
                 "Instead of `seconds`: simulated time per second of film."),
        bind_key("fps", &Film::fps, whole(1, most_frames_per_second), "Frames in a second.")
            .tried_as({"framerate", "frame_rate", "rate", "frames"}),
        bind_key("size", &Film::size, size_notation(),
                 "The size of the picture in pixels: a name, or width and height. H.264 and VP9 "
                 "add a row or a column where these are odd.")
            .tried_as({"resolution", "width", "height"}),
        theme_key(&Film::theme),
        bind_key("language", &Film::language,
                 one_of<Language>().with_elsewhere({{"english", "did you mean `en`?"},
                                                    {"german", "did you mean `de`?"},
                                                    {"deutsch", "did you mean `de`?"},
                                                    {"french", "did you mean `fr`?"},
                                                    {"spanish", "did you mean `es`?"}}),
                 "The language of carom's own words, numbers and lists: English, German, French or "
                 "Spanish. The words of the scene stay as they are."),
        bind_key("ground", &Film::transparent,
                 one_of<bool>({{"theme", false}, {"none", true}})
                     .with_elsewhere({{"transparent", "`none` is transparent"},
                                      {"white", "a theme has its own ground: `theme: light`"},
                                      {"black", "a theme has its own ground: `theme: dark`"}}),
                 "The background of film and figures: the theme's, or none, so that a slide shows "
                 "through. Choose the theme that suits the slide.")};
}

// A circle of colours has a place for each direction of a plane, not for those of space.
void check_color_by(ColorBy quantity, const Node& node, Reading& reading) {
    if (quantity == ColorBy::direction && reading.box().dimension == 3)
        reading.errors.add(node, "there is no colour for each direction of a velocity in space",
                           "write `color_by: speed`, or `species`");
}

// Keys for the drawing of the gas.
std::vector<Binding<Film>> gas_keys(PanelKinds kinds) {
    std::vector<std::string> palettes;
    for (const PanelKind& kind : kinds)
        if (kind.draws_box) palettes = kind.palettes;
    const auto quantity =
        one_of<ColorBy>().with_elsewhere({{"velocity", "did you mean `speed`?"},
                                          {"name", "did you mean `species`?"},
                                          {"kinetic-energy", "did you mean `energy`?"},
                                          {"angle", "did you mean `direction`?"}});
    return {
        bind_key("color_by", &Film::color_by, checked(quantity, check_color_by),
                 "What the colour of a disk means."),
        bind_key("palette", &Film::palette, word(palettes), "The colours from slow to fast.")
            .default_text("the theme's"),
        bind_key("labels", &Film::labels, one_of<Labels>(),
                 "What is written on the disks or beads where there is room: their mass, or their "
                 "number.")
            .default_text("none"),
        velocities_key(),
        bind_key("flashes", &Film::flashes, flag(),
                 "A short flash where two particles touch, or one touches a partition, an obstacle "
                 "or a wall that acts, at most three a second.")};
}

// Beads on a line would hide their own streaks.
std::optional<bool> streaks_of(bool shown, const Node& node, Reading& reading) {
    const int dimension = reading.box().dimension;
    if (!shown || dimension == 2) return shown;
    if (dimension == 1)
        reading.errors.add(
            node, "streaks are drawn behind disks in a plane, and beads on a line have none",
            "leave it out: world lines show where beads have been");
    else
        reading.errors.add(node, "streaks are drawn behind disks in a plane, and spheres have none",
                           "leave it out: `trails` show where spheres have been");
    return std::nullopt;
}

// Keys for what is shown next to the gas, and when.
std::vector<Binding<FilmDraft>> frame_keys(PanelKinds kinds) {
    const auto slow =
        list_of(placed(slow_notation()), 0, most_slow_spans, "a list of {from, to, factor}");
    return {
        bind_key(
            "title_card", &Film::title_card, title_card_notation(),
            "A card with title and subtitle before the film, over its first frame: `true` for "
            "3 seconds, or a number of seconds. In its last 0.8 seconds these go to their "
            "places in the frame. It is included in the film's `seconds`; with `pace` it makes "
            "the film longer."),
        bind_key("end_card", &Film::end_card, with_formulas(text(1, most_title_letters)),
                 "The text of a card shown for 4 seconds after the film, over the gas, and "
                 "included in its `seconds` too. Both cards together take at most a third of the "
                 "film.")
            .default_text("none"),
        bind_key(
            "trails", &Film::trails, trails_notation(),
            "Trails that some of the particles leave; the `trail` of a species takes precedence.")
            .default_text("for a species of a single particle among many"),
        bind_key("streaks", &Film::streaks, parsed(flag(), streaks_of),
                 "Whether each disk is drawn with its path during the last 1/60 s of film, as a "
                 "streak in its colour that fades with time: with it, the eye follows disks that "
                 "travel more than half their diameter from frame to frame. Disks too small to be "
                 "distinguished, and figures, have none.")
            .tried_as({"motion_blur", "blur", "motion-blur"}),
        bind_key(
            "slow", &FilmDraft::spans, slow,
            "Slow motion over spans of simulated time; factor 0.1 is ten times slower. The film "
            "eases in before the span and out after it, over half a second each (in films shorter "
            "than five seconds, a tenth of the film), and shows ×0.1 beside the clock. With "
            "`seconds` the rest becomes faster, with `pace` the film becomes longer.")
            .default_text("none"),
        bind_key("monitors", &Film::monitors, monitors_notation(),
                 "The numbers in the row of monitors, as many as it has room for; all-collisions "
                 "includes those with walls; "
                 "return-distance is the largest distance of a particle from where it was on the "
                 "way out; overlap is the deepest overlap so far of two disks that collided, in "
                 "per cent of the sum of their radii.")
            .default_text(
                "collisions; in a layout without a clock time, collisions, mean-speed and "
                "mean-energy"),
        bind_key("panels", &Film::panels, panels_notation(kinds),
                 "The panels, each a kind or a mapping with options.")
            .tried_as({"plots", "graphs"})
            .default_text("the template's")};
}

std::vector<Binding<FilmDraft>> film_keys(PanelKinds kinds) {
    const std::vector callouts{
        bind_key("callouts", &FilmDraft::written_callouts, callouts_notation(),
                 "Words that point to a particle, or to a place in a plot, for a while.")
            .default_text("none")};
    const std::vector beside{beside_key()}, sound{sound_key()},
        recipe{bind_key("recipe", &Film::has_recipe, flag(),
                        "Whether the film's file contains this scene and what the command line "
                        "changed, so that the film can be made again from it; a page then offers "
                        "the scene, too.")};
    return joined<FilmDraft>(picture_keys(), gas_keys(kinds), frame_keys(kinds), overlay_keys(),
                             callouts, beside, sound, recipe);
}

const std::vector<Choice> film_choices{{{"seconds", "pace"}}};

// Returns whether the command line chose the template while the scene lists the panels: then only
// as many of the panels are shown as the template has places for.
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

void check_slots(const Node& node, Film& film, const std::filesystem::path& templates,
                 Errors& errors) {
    const Node* list = given(node, "panels");
    const std::size_t slots = film.layout.panels.size();
    if (list == nullptr || list->items.size() <= slots) return;
    if (is_laid_over(node, *list)) {
        for (std::size_t i = slots; i < film.panels.size(); ++i)
            film.panels_left_out.push_back(film.panels[i].kind);
        film.panels.resize(std::min(film.panels.size(), slots));
        return;
    }
    errors.add(list->items[slots],
               fmt::format("the template `{}` has {} for panels, found {}", film.template_name,
                           counted(static_cast<long long>(slots), "place"),
                           counted(static_cast<long long>(list->items.size()), "panel")),
               templates_hint(templates_with_places(templates, list->items.size())));
}

Notation<std::int64_t> usual_panels_notation() { return whole(0, most_panels); }

// For a film that lists no panels, chooses from the template's list the first `places` panels that
// have something to show for this gas; if there are none, the first panels of the list.
void choose_panels(Node& film, std::size_t places, PanelKinds kinds, const Reading& reading) {
    Node* panels = find(film, "panels");
    const bool is_beside = find(film, "beside") != nullptr;
    if (panels == nullptr || !panels->valid || !panels->is_list() ||
        panels->source->origin != Origin::template_file)
        return;
    const auto suits = [&](const Node& panel) {
        const Node* name = panel.is_mapping() ? given(panel, "kind") : &panel;
        const PanelKind* kind = name != nullptr ? kind_of(kinds, name->text) : nullptr;
        if (kind == nullptr) return true;
        if (reading.units == UnitSystem::real && !kind->shows_units) return false;
        if (is_beside && !kind->can(Ability::comparison)) return false;
        if (reading.box().dimension == 3 && !kind->in_space_instead.empty()) return false;
        return !kind->suits || kind->suits(reading.gas, reading.run);
    };
    std::vector<Node>& list = panels->items;
    if (reading.errors.empty() && std::ranges::any_of(list, suits))
        std::erase_if(list, std::not_fn(suits));
    list.resize(std::min(list.size(), places));
}

std::vector<Refused> keys_of_other_programs() {
    const std::string captions = "captions are events of the run",
                      event = "`events: [{at: 1, caption: words}]` in `run`";
    const std::string format = "the format of a film is that of the file that it is written to",
                      option = "carom render SCENE -o film.webm";
    return {{"captions", captions, event},
            {"caption", captions, event},
            {"subtitles", captions, event},
            {"font", "a film has the fonts of its style",
             "`style: house.yaml` at the top level of the file, and `font: NAME` in that file"},
            {"format", format, option},
            {"codec", format, option}};
}

KeyTable<FilmDraft> new_film_table(PanelKinds kinds) {
    const std::vector its_template{bind_key(
        "template", &Film::template_name, text(1, most_title_letters),
        "The layout: a file in the scene's folder or in templates/films, by name. If none is "
        "given, a gas of disks with one panel in `panels` has `hero`.")};
    return {.name = "`film`",
            .keys = joined<FilmDraft>(its_template, film_keys(kinds)),
            .choices = film_choices,
            .refused = keys_of_other_programs()};
}

KeyTable<FilmDraft> new_template_table(PanelKinds kinds) {
    const std::vector layout{
        bind_key("layout", &FilmDraft::layout_node, kept(layout_notation()),
                 "The places of everything in a frame.")
            .required(),
        bind_key("usual_panels", &FilmDraft::usual_panels, usual_panels_notation(),
                 "How many of these `panels` a film shows that lists none of its own.")
            .default_text("as many as there are places")};
    return {.name = "a template",
            .keys = joined<FilmDraft>(film_keys(kinds), layout),
            .choices = film_choices};
}

}  // namespace

const FixedTable<FilmDraft>& film_table(PanelKinds kinds) {
    static MadeOnce<FixedTable<FilmDraft>> tables;
    return tables.of(kinds, [&] { return new_film_table(kinds); });
}

const FixedTable<FilmDraft>& template_table(PanelKinds kinds) {
    static MadeOnce<FixedTable<FilmDraft>> tables;
    return tables.of(kinds, [&] { return new_template_table(kinds); });
}

Film read_film(const FilmNodes& nodes, const std::string& template_name, PanelKinds kinds,
               const std::filesystem::path& templates, const std::vector<Placed<Pause>>& pauses,
               Reading& reading) {
    const Node* layout_node = given(nodes.template_file, "layout");
    static const auto layouts = layout_notation();
    const auto layout =
        layout_node != nullptr ? layouts.read(*layout_node, reading) : std::optional<LayoutSpec>();
    Node node = nodes.film;
    if (layout) {
        const Node* usual = given(nodes.template_file, "usual_panels");
        const auto count =
            usual != nullptr ? usual_panels_notation().read(*usual, reading) : std::nullopt;
        const std::size_t places = layout->panels.size();
        choose_panels(node, count ? std::min(places, static_cast<std::size_t>(*count)) : places,
                      kinds, reading);
    }
    FilmDraft film;
    film_table(kinds).read(node, film, reading);
    film.template_name = template_name;
    film.layout = layout.value_or(LayoutSpec{});
    film.callouts = resolve_callouts(film.written_callouts, film.panels, kinds, reading.errors);
    complete_length(film, pauses, nodes, node, reading);
    if (layout) check_slots(node, film, templates, reading.errors);
    if (film.panels.empty()) film.layout = without_panels(film.layout);
    check_beside(film, node, kinds, reading.errors);
    std::erase_if(film.callouts, [&](const Callout& callout) {  // to panels that are left out
        const auto* point = std::get_if<PlotPoint>(&callout.on);
        return point != nullptr && point->panel >= film.panels.size();
    });
    return film;
}

}  // namespace carom
