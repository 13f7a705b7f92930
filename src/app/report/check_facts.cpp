#include "app/report/check_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/progress.h"
#include "app/report/facts.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "util/text.h"

namespace carom {
namespace {

Fact shown(const char* label, const std::string& words) { return {"", nullptr, label, words}; }

// Two digits: it is an estimate.
std::string about(double value) {
    if (value >= 1e15) return three_digits(value);
    if (value < 0.01) return value > 0.0 ? "less than 0.01" : "0";
    if (value < 10.0) return fmt::format("{:.2g}", value);
    const double digits = std::floor(std::log10(std::max(1.0, value))) - 1.0;
    const double unit = std::pow(10.0, std::max(0.0, digits));
    return grouped(static_cast<long long>(unit * std::round(value / unit)));
}

std::string walls(const Box& box) {
    const bool across = box.is_periodic(0);
    if (box.dimension == 1) return across ? "ends joined" : "between walls";
    const bool up = box.is_periodic(1);
    if (across == up) return across ? "periodic" : "solid walls";
    return across ? "periodic across, solid below and above"
                  : "periodic up and down, solid left and right";
}

Json walls_value(const Box& box) {
    const auto word = [](Wall wall) { return wall == Wall::solid ? "solid" : "periodic"; };
    Json walls{{"left", word(box.walls[0])}, {"right", word(box.walls[0])}};
    if (box.dimension == 2) {
        walls["bottom"] = word(box.walls[1]);
        walls["top"] = word(box.walls[1]);
    }
    return walls;
}

Fact box_fact(const Box& box) {
    if (box.dimension == 1)
        return {"box", Json{{"length", box.size[0]}, {"walls", walls_value(box)}}, "box",
                fmt::format("one dimension, length {}, {}", box.size[0], walls(box))};
    return {
        "box", Json{{"size", Json::array({box.size[0], box.size[1]})}, {"walls", walls_value(box)}},
        "box", fmt::format("two dimensions, {} by {}, {}", box.size[0], box.size[1], walls(box))};
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

std::string collision_words(const SceneFacts& facts) {
    if (!facts.collisions) return "no estimate: the gas has no equilibrium that theory knows";
    const double of_each = 2.0 * *facts.collisions / static_cast<double>(facts.particles);
    return fmt::format("{} between particles, {} for each (kinetic theory, in equilibrium)",
                       (*facts.collisions < 0.01 ? "" : "about ") + about(*facts.collisions),
                       about(of_each));
}

std::string run_words(const Run& run) {
    std::string text = fmt::format("time 0 to {}", run.until);
    if (run.equilibrate > 0.0) text += fmt::format(", after {} not shown", run.equilibrate);
    if (!run.events.empty())
        text +=
            fmt::format(", {} {}", run.events.size(), run.events.size() == 1 ? "event" : "events");
    return text;
}

std::string film_words(const Film& film, const SceneFacts& facts) {
    if (facts.costs.empty()) return "none: for `carom run` only";
    return fmt::format("{} frames, {} at {} a second, {} by {}, template {}", grouped(facts.frames),
                       clock_text(film.seconds), film.fps, film.size.width, film.size.height,
                       film.template_name);
}

std::string cost_words(const std::vector<FilmCost>& costs) {
    std::vector<std::string> words;
    for (const FilmCost& cost : costs)
        words.push_back(fmt::format("{} {}, {} MB", cost.format,
                                    cost.seconds < 1.0 ? "0:01" : clock_text(cost.seconds),
                                    about(1e-6 * cost.bytes)));
    const int cores = costs.front().cores;
    return fmt::format("{} (on {} {}, quality standard; half or twice as much is possible)",
                       fmt::join(words, "; "), cores, cores == 1 ? "core" : "cores");
}

// Of an MP4, and of every format by its name.
Json rough_costs(const std::vector<FilmCost>& costs) {
    Json formats = Json::object();
    for (const FilmCost& cost : costs)
        formats[cost.format] = {{"seconds", cost.seconds}, {"bytes", std::round(cost.bytes)}};
    return Json{{"seconds", costs.front().seconds},
                {"cores", costs.front().cores},
                {"bytes", std::round(costs.front().bytes)},
                {"formats", std::move(formats)}};
}

Facts film_facts(const Film& film, const SceneFacts& facts) {
    const std::string words = film_words(film, facts);
    if (facts.costs.empty()) return {{"film", nullptr, "film", words}};
    return {{"film",
             Json{{"template", film.template_name},
                  {"frames", facts.frames},
                  {"seconds", film.seconds},
                  {"fps", film.fps},
                  {"size", Json::array({film.size.width, film.size.height})},
                  {"passes", facts.passes},
                  {"rough", rough_costs(facts.costs)}},
             "film", words},
            shown("simulated",
                  fmt::format("{}: {}", counted(static_cast<long long>(facts.passes.size()), "run"),
                              fmt::join(facts.passes, "; "))),
            shown("rough cost", cost_words(facts.costs))};
}

Facts scene_facts(const Scene& scene, const SceneFacts& facts) {
    const Box& box = scene.gas.box;
    Facts all{{"title", scene.title, "title", scene.title},
              {"seed", scene.seed},
              {"dimension", box.dimension},
              box_fact(box),
              {"particles", facts.particles},
              species(scene.gas, facts.particles),
              {"packing_fraction", facts.packing_fraction, "packing",
               fmt::format("{:.4g} of the {}", facts.packing_fraction,
                           box.dimension == 1 ? "length" : "area")},
              {"time", scene.run.until, "run", run_words(scene.run)},
              {"equilibrate", scene.run.equilibrate},
              {"expected_collisions", facts.collisions ? Json(*facts.collisions) : Json(),
               "collisions", collision_words(facts)}};
    for (Fact& fact : film_facts(scene.film, facts)) all.push_back(std::move(fact));
    return all;
}

// "speeds, a speed-histogram at time 4, 8.9 by 6.2 cm".
std::string figure_words(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    const bool over = spec.panel.over && spec.panel.over->since == Over::Since::window;
    const std::string kind =
        spec.compare.empty() ? spec.panel.kind
                             : fmt::format("{} of {} runs", spec.panel.kind, spec.compare.size());
    return fmt::format("{}: {} {} time {}, {:.3g} by {:.3g} cm", spec.name, kind,
                       over ? "over" : "at", shown_times(spec), width, height);
}

double two_digits(double centimetres) { return std::round(100.0 * centimetres) / 100.0; }

Json figure_value(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    Json fields{{"name", spec.name},
                {"kind", spec.panel.kind},
                {"times", spec.times},
                {"size_cm", Json::array({two_digits(width), two_digits(height)})}};
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

Facts set_facts(const FigureSet& set) {
    Json sections = Json::array();
    std::size_t figures = 0;
    for (const SetPart& part : set.parts) {
        sections.push_back(section_value(part));
        figures += part.figures.size();
    }
    std::vector<std::string> pages;
    for (const PageTemplate& page : set.pages) pages.push_back(set.stem + page.ending);
    Facts facts{{"title", set.title, "title", set.title}, {"sections", std::move(sections)}};
    for (Fact& fact : section_rows(set)) facts.push_back(std::move(fact));
    facts.push_back({"formats", set.formats, "figures",
                     fmt::format("{}, each as {}", figures, listed(set.formats))});
    facts.push_back({"pages", pages, "pages", listed(pages)});
    return facts;
}

Json error_value(const Diagnostic& error) {
    const auto position = [](int value) { return value > 0 ? Json(value) : Json(); };
    return Json{{"file", error.span.file},
                {"line", position(error.span.line)},
                {"column", position(error.span.column)},
                {"length", error.span.length},
                {"message", error.message},
                {"hint", error.hint.empty() ? Json() : Json(error.hint)}};
}

Facts facts_of(const CheckedScene& checked) {
    const std::string errors = counted(static_cast<long long>(checked.errors.size()), "error");
    Facts facts{{checked.is_set ? "set" : "scene", checked.path, "",
                 fmt::format("{}: {}\n", checked.path,
                             checked.is_valid() ? "valid" : "not valid, " + errors)},
                {"valid", checked.is_valid()}};
    const auto add = [&](const Facts& more) {
        facts.insert(facts.end(), more.begin(), more.end());
    };
    if (checked.set) add(set_facts(*checked.set));
    if (checked.scene) add(scene_facts(*checked.scene, checked.facts));
    Json list = Json::array();
    for (const Diagnostic& error : checked.errors) list.push_back(error_value(error));
    facts.push_back({"errors", std::move(list)});
    return facts;
}

}  // namespace

std::string check_table(std::span<const CheckedScene> scenes) {
    constexpr int label_width = 12;
    std::string text;
    for (const CheckedScene& checked : scenes) {
        if (!text.empty() && checked.is_valid()) text += "\n";
        text += table_of(facts_of(checked), label_width);
    }
    return text;
}

std::string check_json(std::span<const CheckedScene> scenes) {
    Json list = Json::array();
    for (const CheckedScene& checked : scenes) list.push_back(json_of(facts_of(checked)));
    return text_of(list, 2) + "\n";
}

}  // namespace carom
