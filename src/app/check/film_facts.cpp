#include "app/check/film_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/check/disk_motion.h"
#include "app/check/players.h"
#include "films/first_pass.h"
#include "films/frame_span.h"
#include "media/formats.h"
#include "panels/field/field_layer.h"
#include "panels/frame.h"
#include "physics/placement/draws.h"
#include "scene/describe.h"
#include "scene/time/timeline.h"
#include "scene/words.h"
#include "util/joined.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

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

// A row where a field of so many particles has mostly blank cells.
Facts field_rows(const Scene& scene, std::int64_t particles) {
    if (!scene.film.field) return {};
    const double mean =
        static_cast<double>(particles) / static_cast<double>(cells_of_field(scene).all());
    if (mean >= least_in_cell) return {};
    return {for_people("field", fmt::format("{:.2g} particles in a cell on average, and cells with "
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
    return {for_people(
        "measured",
        fmt::format("{} (on {}, quality {}; from a few frames of the film)", cost_words(*measured),
                    counted(options.threads, "core"), word_of(options.quality)))};
}

// "a click for each collision, at most 0.3 of full scale, captioned; AAC in mp4, Opus in webm".
Facts sound_rows(const Film& film) {
    if (!film.sound) return {};
    std::vector<std::string> codecs;
    for (const OutputFormat& format : output_formats())
        if (format.sound)
            codecs.push_back(fmt::format("{} in {}", format.sound->codec, format.name));
    return {for_people("sound",
                       fmt::format("a click for each collision, at most {} of full scale, with "
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

// Of all runs of a film.
std::vector<DiskMotion> disks_of(const Scene& scene, const CheckedFilm& checked,
                                 const PanelSet& panels, const std::vector<RunStart>& starts) {
    if (scene.gas.box.dimension == 1) return {};
    const double scale = panels.scale(Grid(scene.film));
    const std::vector<const Scene*> scenes = scenes_of_film(scene);
    std::vector<DiskMotion> all;
    for (std::size_t k = 0; k < scenes.size(); ++k)
        for (DiskMotion& one :
             disk_motion(*scenes[k], starts[k].particles, checked.counts.at(k).speeds, scale)) {
            if (scenes.size() > 1) one.run = scene.film.runs.labels()[k];
            all.push_back(std::move(one));
        }
    return all;
}

// With so many collisions in all of its runs.
Facts rows_of_film(const Scene& scene, const CheckedFilm& checked, std::int64_t particles,
                   const FilmCollisions& collisions, const std::vector<DiskMotion>& disks) {
    const Film& film = scene.film;
    const FilmOptions& options = checked.options;
    const int frames = frames_of(scene, options);
    const auto runs = static_cast<std::int64_t>(film.runs.count());
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
               {"disks", motion_value(disks)},
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
          for_people("simulated",
                     fmt::format("{}: {}", counted(static_cast<long long>(passes.size()), "run"),
                                 fmt::join(passes, "; "))),
          for_people("rough cost", rough_words(costs, options))},
         measured_rows(checked.measured, options),
         sound_rows(film),
         {for_people("memory", memory_words(costs, options.threads))},
         motion_rows(scene, disks),
         player_rows(film, checked.formats)});
    if (const std::vector<std::string> labels = film.runs.labels(); labels.size() > 1)
        facts.push_back(
            {"beside", labels, "side by side", fmt::format("{}", fmt::join(labels, " | "))});
    return facts;
}

}  // namespace

std::vector<const OutputFormat*> formats_with_costs() {
    std::vector<const OutputFormat*> formats;
    for (const OutputFormat& format : output_formats())
        if (format.film && !format.in_one_piece) formats.push_back(&format);
    return formats;
}

Facts film_facts(const Scene& scene, const CheckedFilm& asked, const Particles& drawn,
                 const Sample& start, double expected) {
    CheckedFilm checked = asked;
    checked.counts.resize(scene.film.runs.count());  // of runs that were not counted nothing
    const std::int64_t particles = drawn.count();
    std::vector<RunStart> starts{{drawn, start}};  // of other runs drawn and not placed
    for (const ComparedRun& run : scene.film.runs.others) {
        auto [others, state] = draw_gas(run.scene->gas);
        starts.push_back({std::move(others), std::move(state)});
    }
    const Scene shown = with_usual_numbers(scene);
    const PanelSet panels(shown, starts);
    const FilmCollisions collisions{
        checked.collisions.value_or(static_cast<double>(starts.size()) * expected),
        panels.wants_collisions()};
    std::vector<std::string> cut = FramePainter(panels).cut_words();
    cut.insert(cut.end(), checked.cut.begin(), checked.cut.end());
    const std::vector<DiskMotion> disks = disks_of(scene, checked, panels, starts);
    return joined<Fact>({rows_of_film(scene, checked, particles, collisions, disks),
                         field_rows(scene, particles), rows_of("cut", "cut", cut),
                         rows_of("keys", "keys", checked.in_keys)});
}

}  // namespace carom
