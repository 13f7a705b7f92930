#include "app/report/check_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/chunks/source_fingerprint.h"
#include "app/command.h"
#include "app/film/frame_span.h"
#include "app/progress.h"
#include "app/report/cut_distributions.h"
#include "app/report/players.h"
#include "app/report/theory_facts.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "media/formats.h"
#include "panels/field/field_layer.h"
#include "panels/frame.h"
#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/law.h"
#include "scene/describe.h"
#include "scene/time/timeline.h"
#include "scene/words.h"
#include "util/fingerprint.h"
#include "util/joined.h"
#include "util/text.h"

namespace carom {
namespace {

Fact shown(const char* label, const std::string& words) { return {"", nullptr, label, words}; }

std::string_view side_word(const Box& box, std::size_t side) {
    const Behaviour& behaviour = box.surfaces.sides[side];
    if (std::holds_alternative<Bath>(behaviour)) return "bath";
    if (std::holds_alternative<Piston>(behaviour)) return "piston";
    if (std::holds_alternative<Driven>(behaviour)) return "driven";
    return word_of(box.walls[side / 2]);
}

Fact box_fact(const Box& box) {
    const bool across = box.is_periodic(0), up = box.is_periodic(1);
    Json walls{{"left", side_word(box, 0)}, {"right", side_word(box, 1)}};
    if (box.dimension == 1)
        return {"box", Json{{"length", box.size[0]}, {"walls", walls}}, "box",
                fmt::format("one dimension, length {}, {}", box.size[0],
                            across ? "ends joined" : "between walls")};
    walls["bottom"] = side_word(box, 2);
    walls["top"] = side_word(box, 3);
    const bool walls_act = !box.surfaces.sides_reflect();
    std::string words = across ? "periodic" : walls_act ? "walls that act" : "solid walls";
    if (across != up)
        words = across ? "periodic across, solid below and above"
                       : "periodic up and down, solid left and right";
    return {"box", Json{{"size", Json::array({box.size[0], box.size[1]})}, {"walls", walls}}, "box",
            fmt::format("two dimensions, {} by {}, {}", box.size[0], box.size[1], words)};
}

std::string species_words(const Gas& gas, std::int64_t particles) {
    constexpr std::size_t most_shown = 8;
    std::vector<std::string> words;
    for (const Species& one : gas.species) {
        if (words.size() == most_shown) {
            words.push_back(fmt::format("{} more", gas.species.size() - most_shown));
            break;
        }
        words.push_back(fmt::format("{} {}", grouped(one.count), one.name));
    }
    std::string text = fmt::format("{}", fmt::join(words, ", "));
    if (gas.species.size() > 1) text += fmt::format("; {} in all", grouped(particles));
    return text;
}

Fact species(const Gas& gas, std::int64_t particles) {
    Json list = Json::array();
    for (const Species& one : gas.species)
        list.push_back(Json{{"name", one.name}, {"count", one.count}});
    return {"species", std::move(list), "species", species_words(gas, particles)};
}

// Expected between particles up to the end of the run.
Fact collisions(const Scene& scene, const Law& rate, double expected, std::int64_t particles) {
    if (rate.none)
        return {"expected_collisions", nullptr, "collisions",
                "no estimate: " + to_text(Language::english, *rate.none, scene.gas.species)};
    return {"expected_collisions", number_or_null(expected), "collisions",
            fmt::format("{} between particles, {} for each (kinetic theory, in equilibrium)",
                        (expected < 0.01 ? "" : "about ") + about(expected),
                        about(2.0 * expected / std::max(1.0, static_cast<double>(particles))))};
}

std::string run_words(const Run& run) {
    std::string text = fmt::format("time 0 to {}", run.until);
    if (run.equilibrate > 0.0) text += fmt::format(", after {} not shown", run.equilibrate);
    if (!run.events.empty())
        text += ", " + counted(static_cast<long long>(run.events.size()), "event");
    return text;
}

Facts distribution_rows(const Gas& gas) {
    std::vector<std::string> lines;
    Json list = Json::array();
    for (CutDistribution& cut : cut_distributions(gas)) {
        lines.push_back(std::move(cut.words));
        list.push_back(std::move(cut.value));
    }
    Facts rows = rows_of("cut_distributions", lines);
    rows.front().value = std::move(list);
    if (!lines.empty()) rows.front().label = "drawn";
    return rows;
}

// Whether nothing ever moves, which is hardly meant.
Facts rest_rows(const BoxedGas& gas) {
    const Law motion = law(gas, LawOf::displacement);
    if (!motion.none || motion.none->why != NoLaw::Why::at_rest) return {{"at_rest", false}};
    return {{"at_rest", true, "warning",
             "all particles are at rest, and nothing moves them: give `temperature` or `speed`"}};
}

Facts theory_rows(const Scene& scene, const BoxedGas& gas) {
    Facts rows = rows_of("no_theory", missing_theory(scene, gas));
    if (!rows.front().label.empty()) rows.front().label = "no theory";
    return rows;
}

Facts event_rows(const Scene& scene) {
    std::vector<std::string> lines;
    for (const Happening& one : happenings(Language::english, scene.run, scene.gas))
        lines.push_back(one.when + ": " + one.words);
    return rows_of("events", lines);
}

const char* word_of(Quality quality) {
    if (quality == Quality::standard) return "standard";
    return quality == Quality::draft ? "draft" : "final";
}

// "mp4 0:07, 7.7 MB".
std::string cost_words(const FilmCost& cost) {
    return fmt::format("{} {}, {} MB", cost.format,
                       cost.seconds < 1.0 ? "0:01" : clock_text(cost.seconds),
                       about(1e-6 * cost.bytes));
}

std::string rough_words(const std::vector<FilmCost>& costs, const FilmOptions& options) {
    std::vector<std::string> words;
    for (const FilmCost& cost : costs) words.push_back(cost_words(cost));
    return fmt::format(
        "{} (on {}, quality {}; several times as much where all moves fast: --measure)",
        fmt::join(words, "; "), counted(options.threads, "core"), word_of(options.quality));
}

std::string memory_words(const std::vector<FilmCost>& costs, int cores) {
    std::vector<std::string> words;
    for (const FilmCost& cost : costs)
        words.push_back(fmt::format("{} {} MB", cost.format, about(1e-6 * cost.memory)));
    return fmt::format("at most: {} (on {}, any quality)", fmt::join(words, "; "),
                       counted(cores, "core"));
}

Json to_json(const FilmCost& cost) {
    return {{"seconds", cost.seconds},
            {"bytes", std::round(cost.bytes)},
            {"memory_bytes", std::round(cost.memory)}};
}

// Of the first format, and of each by its name.
Json rough_costs(const std::vector<FilmCost>& costs, int cores) {
    Json formats = Json::object();
    for (const FilmCost& cost : costs) formats[cost.format] = to_json(cost);
    return Json{{"seconds", costs.front().seconds},
                {"cores", cores},
                {"bytes", std::round(costs.front().bytes)},
                {"formats", std::move(formats)}};
}

// The other run's gas, drawn and not placed.
std::optional<RunStart> start_beside(const Film& film) {
    if (!film.beside) return std::nullopt;
    auto [particles, state] = draw_gas(film.beside->scene->gas);
    return RunStart{std::move(particles), std::move(state)};
}

// A row where a field of so many particles has mostly blank cells.
Facts field_rows(const Scene& scene, std::int64_t particles) {
    if (!scene.film.field) return {};
    const Cells cells = square_cells(scene.gas.box, scene.film.field->cells);
    const double mean = static_cast<double>(particles) / static_cast<double>(cells.all());
    if (mean >= least_in_cell) return {};
    return {shown("field", fmt::format("{:.2g} particles in a cell on average, and cells with "
                                       "fewer than {:g} are blank: fewer cells show more",
                                       mean, least_in_cell))};
}

std::vector<FilmCost> estimated_costs(const Scene& scene, const CheckedFilm& film,
                                      const FilmCollisions& collisions) {
    std::vector<FilmCost> costs;
    for (const OutputFormat* format : film.formats)
        costs.push_back(estimated_cost(*format, scene, film.options, film.counts, collisions));
    return costs;
}

Facts measured_rows(const std::optional<FilmCost>& measured, const FilmOptions& options) {
    if (!measured) return {};
    return {shown("measured", fmt::format("{} (on {}, quality {}; from a few frames of the film)",
                                          cost_words(*measured), counted(options.threads, "core"),
                                          word_of(options.quality)))};
}

// "a click for each collision, at most 0.3 of full scale, captioned; AAC in mp4, Opus in webm".
Facts sound_rows(const Film& film) {
    if (!film.sound) return {};
    std::vector<std::string> codecs;
    for (const OutputFormat& format : output_formats())
        if (format.sound)
            codecs.push_back(fmt::format("{} in {}", format.sound->codec, format.name));
    return {shown("sound", fmt::format("a click for each collision, at most {} of full scale, with "
                                       "captions; {}, none in others",
                                       film.sound->loudness, fmt::join(codecs, ", ")))};
}

Json sound_value(const Film& film) {
    if (!film.sound) return {};
    const std::optional<double>& reference = film.sound->reference;
    return {{"of", word_of(film.sound->of)},
            {"loudness", film.sound->loudness},
            {"reference", reference ? Json(*reference) : Json()}};
}

// With so many collisions in all of its runs.
Facts film_facts(const Scene& scene, const CheckedFilm& checked, std::int64_t particles,
                 const FilmCollisions& collisions) {
    const Film& film = scene.film;
    const FilmOptions& options = checked.options;
    const int frames = frames_of(scene, options);
    const int runs = film.beside ? 2 : 1;
    const std::vector<std::string> passes = expected_passes(scene, runs * particles);
    const std::vector<FilmCost> costs = estimated_costs(scene, checked, collisions);
    const double seconds = static_cast<double>(frames) / film.fps;
    Json value{{"template", film.template_name},
               {"frames", frames},
               {"seconds", frames == frame_count(film) ? film.seconds : seconds},
               {"fps", film.fps},
               {"size", Json::array({film.size.width, film.size.height})},
               {"h264_level", h264_level_of(film, checked.formats)},
               {"sound", sound_value(film)},
               {"passes", passes},
               {"rough", rough_costs(costs, options.threads)}};
    if (checked.measured) {
        value["measured"] = to_json(*checked.measured);
        value["measured"]["format"] = checked.measured->format;
        value["measured"]["cores"] = options.threads;
    }
    Facts facts = joined<Fact>(
        {{{"film", std::move(value), "film",
           fmt::format("{} frames, {} at {} a second, {} by {}, template {}", grouped(frames),
                       clock_text(seconds), film.fps, film.size.width, film.size.height,
                       film.template_name)},
          shown("simulated",
                fmt::format("{}: {}", counted(static_cast<long long>(passes.size()), "run"),
                            fmt::join(passes, "; "))),
          shown("rough cost", rough_words(costs, options))},
         measured_rows(checked.measured, options),
         sound_rows(film),
         {shown("memory", memory_words(costs, options.threads))},
         player_rows(film, checked.formats)});
    if (film.beside)
        facts.push_back({"beside", Json::array({film.beside->own_label, film.beside->label}),
                         "side by side", film.beside->own_label + " | " + film.beside->label});
    return facts;
}

// Whether the time that a figure shows is known only after the run, or it shows none.
bool has_unknown_time(const PanelSpec& panel) {
    return panel.kind == "single-collision" || panel.kind == "contact-time" ||
           (panel.kind == "collision-map" && !panel.walk) || panel.kind == "sweep";
}

// " at time 4", " over time 6 to 12".
std::string words_of_time(const FigureSpec& spec) {
    if (has_unknown_time(spec.panel)) return "";
    const ShownTimes shown = times_of(spec);
    return fmt::format(" {} time {}", shown.over ? "over" : "at",
                       words_of(Language::english, shown));
}

// "speeds: speed-histogram at time 4, 8.9 by 6.2 cm".
std::string figure_words(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    const std::string kind =
        spec.compare.empty() ? spec.panel.kind
                             : fmt::format("{} of {} runs", spec.panel.kind, spec.compare.size());
    return fmt::format("{}: {}{}, {:.3g} by {:.3g} cm", spec.name, kind, words_of_time(spec), width,
                       height);
}

Json figure_value(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    Json fields{{"name", spec.name},
                {"kind", spec.panel.kind},
                {"times", spec.times},
                {"size_cm", Json::array({width, height})}};
    Json runs = Json::array();
    for (const ComparedRun& run : spec.compare) runs.push_back(run.label);
    if (!runs.empty()) fields["runs"] = std::move(runs);
    return fields;
}

Json section_value(const SetPart& part) {
    Json figures = Json::array();
    for (const std::string& name : part.figures)
        figures.push_back(figure_value(part.scene, *figure_spec(part.scene, name)));
    return Json{{"scene", part.compares ? Json() : Json(part.stem)},
                {"title", part.title},
                {"figures", std::move(figures)}};
}

// Comparisons behind the scenes.
Facts section_rows(const FigureSet& set) {
    Facts rows;
    for (const SetPart& part : set.parts) {
        if (part.compares) continue;
        rows.push_back(shown("scene", part.stem));
        for (const std::string& name : part.figures)
            rows.push_back(shown(" ", figure_words(part.scene, *figure_spec(part.scene, name))));
    }
    for (const SetPart& part : set.parts) {
        if (!part.compares) continue;
        const FigureSpec& spec = part.scene.figures.front();
        std::vector<std::string> labels;
        for (const ComparedRun& run : spec.compare) labels.push_back(run.label);
        rows.push_back(shown("comparison", figure_words(part.scene, spec)));
        rows.push_back(shown(" ", listed(labels)));
    }
    return rows;
}

Facts note_rows(const Scene& scene) {
    std::vector<std::string> lines;
    Json values = Json::array();
    for (const Diagnostic& note : scene.notes) {
        lines.push_back(note_text(note));
        values.push_back(error_value(note));
    }
    Facts rows = rows_of("note", lines);
    rows.front().name = "notes";
    rows.front().value = std::move(values);
    return rows;
}

Fact name_of(const CheckedFile& checked) {
    const std::string errors = counted(static_cast<long long>(checked.errors.size()), "error");
    return {checked.is_set ? "set" : "scene", checked.path, "",
            fmt::format("{}: {}\n", printable(checked.path),
                        checked.facts ? "valid" : "not valid, " + errors)};
}

// For people. Without lists of JSON, whose destructor takes memory, which may be what is missing.
Facts rows_of(const CheckedFile& checked) {
    Facts facts;
    facts.push_back(name_of(checked));
    if (checked.facts) facts.insert(facts.end(), checked.facts->begin(), checked.facts->end());
    return facts;
}

Facts facts_of(const CheckedFile& checked) {
    const auto list = [](const std::vector<Diagnostic>& found) {
        Json values = Json::array();
        for (const Diagnostic& one : found) values.push_back(error_value(one));
        return values;
    };
    Facts facts = joined<Fact>({{name_of(checked), {"valid", checked.facts.has_value()}},
                                checked.facts.value_or(Facts{}),
                                {{"errors", list(checked.errors)}}});
    if (checked.barriers) facts.push_back({"barriers", list(*checked.barriers)});
    return facts;
}

// What pictures and films of a scene depend on, in one word.
std::string made_from(const SceneSource& source) {
    std::string all = source_fingerprint;
    const auto add = [&](const std::string& text) {
        all += fmt::format(" {}:{}", text.size(), text);
    };
    for (const std::string& text : {source.text, source.template_text}) add(text);
    for (const std::string& one : source.overrides) add(one);
    for (const auto& [path, text] : source.files) {
        add(path);
        add(text);
    }
    return fingerprint(all);
}

}  // namespace

std::vector<const OutputFormat*> formats_with_costs() {
    std::vector<const OutputFormat*> formats;
    for (const OutputFormat& format : output_formats())
        if (format.film && !format.in_one_piece) formats.push_back(&format);
    return formats;
}

Facts facts_of(const Scene& scene, const std::optional<CheckedFilm>& film, const NamedWork& works,
               const std::vector<CommandsRefused>& refused) {
    const Box& box = scene.gas.box;
    const Run& run = scene.run;
    const auto gas = draw_gas(scene.gas);
    const Particles& drawn = gas.first;
    const Sample& sample = gas.second;
    const std::int64_t particles = drawn.count();
    const double packing = packing_fraction(box, drawn);
    const BoxedGas boxed(box, run.events, drawn, sample);
    const Law of_each = law(boxed, LawOf::collision_rate);
    const double rate = 0.5 * static_cast<double>(particles) * (of_each ? of_each.value : 0.0);
    const auto facts_of_film = [&](const CheckedFilm& its) {
        const std::optional<RunStart> beside = start_beside(scene.film);
        const PanelSet panels(scene, drawn, sample, beside ? &*beside : nullptr);
        const double expected = (beside ? 2.0 : 1.0) * rate * run.until;
        const FilmCollisions collisions{its.collisions.value_or(expected),
                                        panels.wants_collisions()};
        std::vector<std::string> cut = FramePainter(panels).cut_words();
        cut.insert(cut.end(), its.cut.begin(), its.cut.end());
        return joined<Fact>({film_facts(scene, its, particles, collisions),
                             field_rows(scene, particles), rows_of("cut", cut)});
    };
    return joined<Fact>(
        {{{"title", scene.title, "title", scene.title},
          {"description", scene.description},
          {"language", word_of(scene.film.language)},
          {"made_from", made_from(scene.source)},
          {"seed", scene.seed},
          {"dimension", box.dimension},
          box_fact(box)},
         rows_of("surfaces", words_of_surfaces(Language::english, scene.gas)),
         {{"particles", particles}, species(scene.gas, particles)},
         distribution_rows(scene.gas),
         {{"packing_fraction", packing, "packing",
           fmt::format("{:.4g} of the {}", packing, box.dimension == 1 ? "length" : "area")},
          {"time", run.until, "run", run_words(run)}},
         event_rows(scene),
         {{"equilibrate", run.equilibrate},
          collisions(scene, of_each, rate * run.until, particles)},
         rest_rows(boxed),
         theory_rows(scene, boxed),
         film ? facts_of_film(*film)
              : Facts{{"film", nullptr, "film", "none: for `carom run` and figures only"}},
         note_rows(scene),
         work_rows(works),
         refused_rows(refused)});
}

Facts facts_of(const FigureSet& set, const NamedWork& works,
               const std::vector<CommandsRefused>& refused) {
    Json sections = Json::array();
    std::size_t figures = 0;
    for (const SetPart& part : set.parts) {
        sections.push_back(section_value(part));
        figures += part.figures.size();
    }
    std::vector<std::string> pages;
    for (const PageTemplate& page : set.pages) pages.push_back(set.stem + page.ending);
    return joined<Fact>(
        {{{"title", set.title, "title", set.title}, {"sections", std::move(sections)}},
         section_rows(set),
         {{"formats", set.formats, "figures",
           fmt::format("{}, each as {}", figures, listed(set.formats))},
          {"pages", pages, "pages", listed(pages)}},
         work_rows(works),
         refused_rows(refused)});
}

std::string check_table(std::span<const CheckedFile> files) {
    constexpr int label_width = 12;
    std::string text;
    for (const CheckedFile& checked : files) {
        if (!text.empty() && checked.facts) text += "\n";
        text += table_of(rows_of(checked), label_width);
    }
    return text;
}

std::string check_json(std::span<const CheckedFile> files) {
    Json list = Json::array();
    for (const CheckedFile& checked : files) list.push_back(json_of(facts_of(checked)));
    return text_of(list, 2) + "\n";
}

}  // namespace carom
