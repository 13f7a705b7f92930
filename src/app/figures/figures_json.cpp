#include "app/figures/figures_json.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) {
    constexpr int indent = 2;
    constexpr bool ascii_only = false;
    // A path may hold bytes that are no UTF-8.
    return json.dump(indent, ' ', ascii_only, Json::error_handler_t::replace) + "\n";
}

Json figure_json(const SetFigure& figure) {
    const Scene& scene = figure.part->scene;
    const FigureSpec& spec = *figure.spec;
    Json json{{"name", figure.name},        {"kind", spec.panel.kind},
              {"caption", figure.caption},  {"alt", figure.alt},
              {"scene", figure.part->stem}, {"scene_title", scene.title},
              {"seed", scene.seed},         {"overrides", scene.source.overrides},
              {"times", spec.times}};
    if (spec.panel.over && spec.panel.over->since == Over::Since::window)
        json["over"] = {spec.times.back() - spec.panel.over->window, spec.times.back()};
    for (const ComparedRun& run : spec.compare)
        json["runs"].push_back(
            {{"label", run.label},
             {"scene", std::filesystem::path(run.scene->source.path).stem().string()},
             {"scene_title", run.scene->title},
             {"seed", run.scene->seed},
             {"overrides", run.scene->source.overrides},
             {"times", run.scene->figures.front().times}});
    json["size_cm"] = figure.size;
    json["files"] = figure.files;
    return json;
}

}  // namespace

std::string captions_json(const std::string& title, std::span<const SetFigure> figures) {
    Json list = Json::array();
    for (const SetFigure& figure : figures) list.push_back(figure_json(figure));
    return dumped({{"carom", CAROM_VERSION}, {"title", title}, {"figures", std::move(list)}});
}

std::string manifest_json(const Manifest& manifest) {
    Json files = Json::object(), figures = Json::object();
    for (const auto& [name, file] : manifest.files) {
        files[name] = {{"figure", file.figure}, {"inputs", file.inputs}, {"content", file.content}};
        if (!file.coming.empty()) files[name]["coming"] = file.coming;
    }
    for (const auto& [name, words] : manifest.figures)
        figures[name] = {{"inputs", words.inputs}, {"caption", words.caption}, {"alt", words.alt}};
    return dumped({{"about", "what carom wrote into this folder, and from what; keep it here"},
                   {"of", manifest.of},
                   {"figures", std::move(figures)},
                   {"files", std::move(files)}});
}

std::optional<Manifest> read_manifest(std::string_view text) {
    try {
        const Json json = Json::parse(text);
        Manifest manifest{json.at("of").get<std::string>(), {}, {}};
        for (const auto& [name, file] : json.at("files").items())
            manifest.files[name] = {
                file.at("figure").get<std::string>(), file.at("inputs").get<std::string>(),
                file.at("content").get<std::string>(), file.value("coming", "")};
        for (const auto& [name, words] : json.at("figures").items())
            manifest.figures[name] = {words.at("inputs").get<std::string>(),
                                      words.at("caption").get<std::string>(),
                                      words.at("alt").get<std::string>()};
        return manifest;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace carom
