#include "scene/reading/film_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/limits.h"
#include "scene/reading/panel_reading.h"
#include "scene/time/captions.h"
#include "scene/time/pace.h"
#include "scene/time/timeline.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

Slot read_slot(const Node& list, const LayoutSpec& layout, Errors& errors) {
    const std::vector<double> sides = numbers(list);
    const Slot slot{sides[0], sides[1], sides[2], sides[3]};
    if (slot.width <= 0.0 || slot.height <= 0.0)
        errors.add(list, "expected [x, y, width, height] with a positive width and height");
    constexpr double rounding = 1e-9;
    if (slot.x + slot.width > layout.grid_width + rounding ||
        slot.y + slot.height > layout.grid_height + rounding)
        errors.add(list, fmt::format("the place reaches outside the grid of {} by {}",
                                     layout.grid_width, layout.grid_height));
    return slot;
}

void check_caption_line(const Node& line, const LayoutSpec& layout, Errors& errors) {
    const LayoutSpec with_line = with_caption_line(layout);
    std::vector<Slot> slots{with_line.title, with_line.gas, with_line.color_bar};
    if (with_line.monitors) slots.push_back(*with_line.monitors);
    slots.insert(slots.end(), with_line.panels.begin(), with_line.panels.end());
    if (std::ranges::any_of(slots, [](const Slot& slot) { return slot.height <= 0.0; }))
        errors.add(line, "the place for captions leaves no room for another one");
}

PictureSize read_size(const Fields& film) {
    static const std::map<std::string, PictureSize> named{
        {"2160p", {3840, 2160}}, {"1080p", {1920, 1080}}, {"720p", {1280, 720}}};
    const Node& node = *film.value("size");
    if (node.is_scalar()) return named.at(node.text);
    const Eigen::Array2d sides = pair(node);
    return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

ColorBy read_color_by(const std::string& word) {
    static const std::map<std::string, ColorBy> ways{{"speed", ColorBy::speed},
                                                     {"speed-class", ColorBy::speed_class},
                                                     {"energy", ColorBy::energy},
                                                     {"species", ColorBy::species},
                                                     {"mass", ColorBy::mass}};
    return ways.at(word);
}

Labels read_labels(const std::optional<std::string>& word) {
    if (!word) return Labels::none;
    return word == "mass" ? Labels::mass : Labels::index;
}

void read_velocities(const Fields& fields, Film& film) {
    const Node& node = *fields.value("velocities");
    const auto flag = flag_in(node);
    film.velocities = flag.value_or(true);
    if (!flag) film.velocity_scale = fields.number("velocities");
}

// A template laid over a scene by the command line shows the first of the scene's panels.
bool is_laid_over(const Fields& fields, const Node& panels) {
    const Node* asked = fields.given("template");
    return asked != nullptr && asked->source->origin == Origin::command_line &&
           panels.source->origin == Origin::scene;
}

std::string templates_hint(const std::vector<std::string>& names) {
    if (names.empty()) return "no template of carom has so many; one of your own may";
    return fmt::format("the {} {} enough", names.size() == 1 ? "template" : "templates",
                       listed(names, "and", "`") + (names.size() == 1 ? " has" : " have"));
}

void check_slots(const Fields& fields, Film& film, const TemplatesFor& templates, Errors& errors) {
    const Node* list = fields.given("panels");
    const std::size_t slots = film.layout.panels.size();
    if (list == nullptr || list->items.size() <= slots) return;
    if (is_laid_over(fields, *list)) {
        film.panels.resize(std::min(film.panels.size(), slots));
        return;
    }
    errors.add(list->items[slots],
               fmt::format("the template `{}` has {} for panels, found {}", film.template_name,
                           counted(static_cast<long long>(slots), "place"),
                           counted(static_cast<long long>(list->items.size()), "panel")),
               templates_hint(templates(list->items.size())));
}

void read_cards(const Fields& fields, Film& film) {
    constexpr double usual_seconds = 3.0;
    const bool asked = flag_in(*fields.value("title_card")).value_or(false);
    film.title_card = fields.number("title_card").value_or(asked ? usual_seconds : 0.0);
    film.end_card = fields.text("end_card").value_or("");
}

Trails read_trails(const Fields& film, const Gas& gas, Errors& errors) {
    Trails trails;
    const auto fields = film.inner("trails");
    if (!fields || (fields->mentions("of") && fields->given("of") == nullptr)) return trails;
    trails.of = read_of(*fields->value("of"), gas, errors);
    trails.seconds = fields->number("seconds").value_or(0.0);
    return trails;
}

/// A span of slow motion and where it is written.
struct SlowDraft {
    SlowSpan span;
    const Node* node;
};

void check_spans(const std::vector<SlowDraft>& drafts, const Run& run, Errors& errors) {
    for (std::size_t i = 0; i < drafts.size(); ++i) {
        const SlowSpan& span = drafts[i].span;
        if (span.from >= span.to)
            errors.add(*drafts[i].node, fmt::format("expected `from` below `to`, found {} and {}",
                                                    span.from, span.to));
        else if (run.until > 0.0 && span.to > run.until)
            errors.add(*drafts[i].node,
                       fmt::format("slow motion from {} to {} goes beyond `until` ({})", span.from,
                                   span.to, run.until));
        else if (i > 0 && drafts[i - 1].span.to > span.from)
            errors.add(
                *drafts[i].node,
                fmt::format("slow motion from {} to {} overlaps that from {} to {}", span.from,
                            span.to, drafts[i - 1].span.from, drafts[i - 1].span.to));
    }
}

std::vector<SlowDraft> read_slow(const Fields& film, const Run& run, Errors& errors) {
    std::vector<SlowDraft> drafts;
    const Node* list = film.given("slow");
    if (list == nullptr) return drafts;
    for (const Node& item : list->items) {
        const Fields fields{item, section_of(film.section(), "slow")};
        const auto from = fields.number("from"), factor = fields.number("factor");
        const double to = fields.number("to").value_or(run.until);
        if (from && factor && run.until > 0.0) drafts.push_back({{*from, to, *factor}, &item});
    }
    std::ranges::stable_sort(drafts, {}, [](const SlowDraft& draft) { return draft.span.from; });
    check_spans(drafts, run, errors);
    return drafts;
}

void check_easing(const Film& film, const Run& run, const std::vector<SlowDraft>& drafts,
                  Errors& errors) {
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

double read_seconds(const Fields& fields, const Film& film, const Run& run) {
    if (const auto seconds = fields.number("seconds")) return *seconds;
    return seconds_at_pace(film.slow, run.until, fields.number("pace").value_or(1.0)) +
           card_seconds(film);
}

// The place to mend a length: where it is given, or where the run's end is.
const Node& place_of_length(const Fields& film, const Fields& scene) {
    for (const char* key : {"seconds", "pace"})
        if (const Node* node = film.given(key)) return *node;
    if (const auto run = scene.inner("run"))
        if (const Node* until = run->given("until")) return *until;
    return film.node();
}

bool check_frames(const Film& film, const Fields& fields, const Fields& scene, Errors& errors) {
    const double frames = std::round(film.seconds * film.fps);
    if (frames >= 2.0 && frames <= most_frames.value) return true;
    const bool given = fields.given("seconds") != nullptr;
    std::string hint =
        frames < 2.0 ? "a film has at least 2 frames"
                     : fmt::format("the ceiling is {} {}", most_frames.value, most_frames.meaning);
    if (!given) hint += "; give `film.seconds`, or another `film.pace`";
    errors.add(place_of_length(fields, scene),
               fmt::format("a film of {:.6g} seconds at {} frames a second has {:.6g} {}",
                           film.seconds, film.fps, frames, frames == 1.0 ? "frame" : "frames"),
               hint);
    return false;
}

// Each part of the run between reversals needs a frame for its end.
void check_legs(const Film& film, const Run& run, const Fields& scene, Errors& errors) {
    const int legs = branch_count(run);
    const int steps = moving_steps(film, run);
    const auto fields = scene.inner("run");
    if (legs <= steps || !fields || fields->given("events") == nullptr) return;
    const int enough = (4 * (legs + 1) + 2) / 3;  // pauses leave at least 3/4 of the frames, less 1
    const double with_cards = card_seconds(film) > 0.0 ? 1.5 : 1.0;
    const double seconds = std::ceil(10.0 * with_cards * enough / film.fps) / 10.0;
    errors.add(
        *fields->given("events"),
        fmt::format("{} {} the run into {} parts, a film of {} has room for {}",
                    counted(legs - 1, "reversal"), legs == 2 ? "divides" : "divide", legs,
                    counted(frame_count(film), "frame"), steps),
        fmt::format("give fewer events, or a longer film: {} seconds are enough (`film.seconds`)",
                    seconds));
}

}  // namespace

ThemeName read_theme(const std::string& word) {
    static const std::map<std::string, ThemeName> themes{
        {"light", ThemeName::light}, {"dark", ThemeName::dark}, {"print", ThemeName::print}};
    return themes.at(word);
}

std::optional<LayoutSpec> read_layout(const Fields& template_file, Errors& errors) {
    const auto fields = template_file.inner("layout");
    if (!fields || fields->given("grid") == nullptr) return std::nullopt;
    LayoutSpec layout;
    const Eigen::Array2d sides = pair(*fields->given("grid"));
    layout.grid_width = sides[0];
    layout.grid_height = sides[1];
    const auto slot = [&](const char* key, Slot& place) {
        if (const Node* node = fields->given(key)) place = read_slot(*node, layout, errors);
    };
    slot("title", layout.title);
    slot("gas", layout.gas);
    slot("color_bar", layout.color_bar);
    if (fields->given("monitors")) slot("monitors", layout.monitors.emplace());
    if (fields->given("caption")) slot("caption", layout.caption.emplace());
    const Node* panels = fields->given("panels");
    if (panels == nullptr && fields->mentions("panels")) return std::nullopt;
    if (panels != nullptr)
        for (const Node& item : panels->items)
            layout.panels.push_back(read_slot(item, layout, errors));
    if (layout.caption) check_caption_line(*fields->given("caption"), layout, errors);
    return layout;
}

Film read_film(const Fields& fields, const Fields& scene, const Run& run, const Gas& gas,
               const std::optional<LayoutSpec>& layout, const TemplatesFor& templates,
               Errors& errors) {
    Film film;
    film.template_name = fields.text("template").value_or("");
    film.layout = layout.value_or(LayoutSpec{});
    film.fps = static_cast<int>(fields.integer("fps").value_or(30));
    film.size = read_size(fields);
    film.theme = read_theme(fields.text("theme").value());
    film.transparent = fields.text("ground").value() == "none";
    film.color_by = read_color_by(fields.text("color_by").value());
    film.palette = fields.text("palette");
    film.labels = read_labels(fields.text("labels"));
    read_velocities(fields, film);
    film.flashes = fields.flag("flashes").value_or(false);
    film.monitors = read_monitors(fields.given("monitors"), {gas, run}, errors);
    read_cards(fields, film);
    film.trails = read_trails(fields, gas, errors);
    const std::vector<SlowDraft> slow = read_slow(fields, run, errors);
    for (const SlowDraft& draft : slow) film.slow.push_back(draft.span);
    film.seconds = read_seconds(fields, film, run);
    if (film.seconds > 0.0 && check_frames(film, fields, scene, errors)) {
        check_legs(film, run, scene, errors);
        if (errors.empty()) check_easing(film, run, slow, errors);
    }
    film.panels = read_panels(fields, {gas, run}, errors);
    if (layout) check_slots(fields, film, templates, errors);
    return film;
}

}  // namespace carom
