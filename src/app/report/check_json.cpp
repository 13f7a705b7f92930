#include "app/report/check_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "figures/figure_drawing.h"

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const Diagnostic& error) {
    const auto position = [](int value) { return value > 0 ? Json(value) : Json(nullptr); };
    return {{"file", error.span.file},
            {"line", position(error.span.line)},
            {"column", position(error.span.column)},
            {"length", error.span.length},
            {"message", error.message},
            {"hint", error.hint.empty() ? Json(nullptr) : Json(error.hint)}};
}

Json walls_json(const Box& box) {
    const auto word = [](Wall wall) { return wall == Wall::solid ? "solid" : "periodic"; };
    Json walls{{"left", word(box.walls[0])}, {"right", word(box.walls[0])}};
    if (box.dimension == 2) {
        walls["bottom"] = word(box.walls[1]);
        walls["top"] = word(box.walls[1]);
    }
    return walls;
}

Json box_json(const Box& box) {
    Json json = Json::object();
    if (box.dimension == 1)
        json["length"] = box.size[0];
    else
        json["size"] = {box.size[0], box.size[1]};
    json["walls"] = walls_json(box);
    return json;
}

Json species_json(const Gas& gas) {
    Json list = Json::array();
    for (const Species& species : gas.species)
        list.push_back({{"name", species.name}, {"count", species.count}});
    return list;
}

// Of an MP4, and of every format by its name.
Json rough_json(const std::vector<FilmCost>& costs) {
    Json formats = Json::object();
    for (const FilmCost& cost : costs)
        formats[cost.format] = {{"seconds", cost.seconds}, {"bytes", std::round(cost.bytes)}};
    return {{"seconds", costs.front().seconds},
            {"cores", costs.front().cores},
            {"bytes", std::round(costs.front().bytes)},
            {"formats", std::move(formats)}};
}

Json film_json(const Film& film, const SceneFacts& facts) {
    if (facts.costs.empty()) return nullptr;
    return {{"template", film.template_name},
            {"frames", facts.frames},
            {"seconds", film.seconds},
            {"fps", film.fps},
            {"size", {film.size.width, film.size.height}},
            {"rough", rough_json(facts.costs)}};
}

Json facts_json(const Scene& scene, const SceneFacts& facts) {
    return {{"title", scene.title},
            {"seed", scene.seed},
            {"dimension", scene.gas.box.dimension},
            {"box", box_json(scene.gas.box)},
            {"particles", facts.particles},
            {"species", species_json(scene.gas)},
            {"packing_fraction", facts.packing_fraction},
            {"time", scene.run.until},
            {"equilibrate", scene.run.equilibrate},
            {"expected_collisions", facts.collisions ? Json(*facts.collisions) : Json(nullptr)},
            {"film", film_json(scene.film, facts)}};
}

double two_digits(double centimetres) { return std::round(100.0 * centimetres) / 100.0; }

Json set_json(const FigureSet& set) {
    Json sections = Json::array(), pages = Json::array();
    for (const SetPart& part : set.parts) {
        Json figures = Json::array();
        for (const std::string& name : part.figures) {
            const FigureSpec& spec = *figure_spec(part.scene, name);
            const auto [width, height] = figure_size(part.scene, spec);
            figures.push_back({{"name", name},
                               {"kind", spec.panel.kind},
                               {"times", spec.times},
                               {"size_cm", {two_digits(width), two_digits(height)}}});
            for (const ComparedRun& run : spec.compare) figures.back()["runs"].push_back(run.label);
        }
        sections.push_back({{"scene", part.compares ? Json(nullptr) : Json(part.stem)},
                            {"title", part.title},
                            {"figures", std::move(figures)}});
    }
    for (const PageTemplate& page : set.pages) pages.push_back(set.stem + page.ending);
    return {{"title", set.title},
            {"sections", std::move(sections)},
            {"formats", set.formats},
            {"pages", std::move(pages)}};
}

Json checked_json(const CheckedScene& checked) {
    Json json{{checked.is_set ? "set" : "scene", checked.path}, {"valid", checked.is_valid()}};
    if (checked.set) json.update(set_json(*checked.set));
    if (checked.scene) json.update(facts_json(*checked.scene, checked.facts));
    json["errors"] = Json::array();
    for (const Diagnostic& error : checked.errors) json["errors"].push_back(error_json(error));
    return json;
}

}  // namespace

std::string check_json(std::span<const CheckedScene> scenes) {
    constexpr int indent = 2;
    constexpr bool ascii_only = false;
    Json list = Json::array();
    for (const CheckedScene& checked : scenes) list.push_back(checked_json(checked));
    // A path may hold bytes that are no UTF-8.
    return list.dump(indent, ' ', ascii_only, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom
