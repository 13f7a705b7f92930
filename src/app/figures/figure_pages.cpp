#include "app/figures/figure_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "figures/page_style.h"
#include "media/base64.h"
#include "media/formats.h"
#include "physics/units/unit_table.h"
#include "runs/json.h"
#include "runs/own_files.h"
#include "scene/limits.h"
#include "scene/words.h"
#include "scene/yaml/file_text.h"
#include "util/diagnostics.h"
#include "util/files/input_file.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr double widest_of_a_column = 12.0;  // centimetres
constexpr std::int64_t most_picture_bytes = 256 << 20;

const std::array<std::pair<std::string, PageKind>, 3> kinds{
    {{".md", PageKind::markdown}, {".html", PageKind::html}, {".tex", PageKind::latex}}};

using Files = std::span<const std::string>;

// Of the files of one figure; empty if there is none.
std::string file_of(Files files, const std::string& format) {
    const auto found = std::ranges::find_if(
        files, [&](const std::string& file) { return file.ends_with("." + format); });
    return found == files.end() ? "" : *found;
}

// What a page of this kind shows: vectors where it can.
std::string picture_of(Files files, PageKind kind) {
    const std::string vectors = file_of(files, kind == PageKind::latex ? "pdf" : "svg");
    return vectors.empty() ? file_of(files, "png") : vectors;
}

std::string inlined(const fs::path& picture) {
    const std::string type = picture.extension() == ".svg" ? "image/svg+xml" : "image/png";
    return data_address(type, read_file(picture, most_picture_bytes));
}

PageFields fields_of(const FigureSet& set, const SetFigure& figure, int number, PageKind kind) {
    require_picture(set, *figure.spec, figure.files, kind);
    const std::string picture = picture_of(figure.files, kind);
    const auto [width, height] = figure_size(figure.part->scene, *figure.spec);
    PageFields fields;
    fields.words = {{"name", figure.spec->name},
                    {"number", std::to_string(number)},
                    {"alt", figure.words.alt},
                    {"kind", figure.spec->panel.kind},
                    {"time", figure.words.time},
                    {"title", figure.part->title},
                    {"scene", as_utf8(figure.part->stem)},
                    {"seed", std::to_string(figure.part->scene.seed)},
                    {"width", fmt::format("{:g}", width)},
                    {"height", fmt::format("{:g}", height)},
                    {"wide", width > widest_of_a_column ? "wide" : ""}};
    fields.formulated = {{"caption", figure.words.caption}};
    fields.files = {{"picture", picture}, {"csv", file_of(figure.files, "csv")}};
    for (const std::string& format : figure_formats())
        fields.files[format] = file_of(figure.files, format);
    if (kind == PageKind::html) fields.inlined["inline"] = inlined(set.folder / picture);
    return fields;
}

PageFields fields_of(const SetFilm& film) {
    PageFields fields;
    fields.words = {{"title", film.part->title},
                    {"description", film.part->scene.description},
                    {"scene", as_utf8(film.part->stem)}};
    for (const auto& [name, file] : film.files) fields.files[name] = file;
    return fields;
}

// What cannot be read is a mistake of the command line or the set, as with scenes.
Source template_file(const fs::path& path) {
    Source source{path.string(), ""};
    Errors errors;
    const std::optional<std::string> text = file_text(path, source, errors);
    if (text && text->size() > most_file_bytes.count())
        errors.add(source, fmt::format("the file has more than {} bytes", most_file_bytes.count()),
                   "a template of pages is a few lines");
    errors.throw_if_any();
    source.text = *text;
    return source;
}

Json figure_json(const SetFigure& figure) {
    const Scene& scene = figure.part->scene;
    const FigureSpec& spec = *figure.spec;
    Json json{{"name", spec.name},
              {"kind", spec.panel.kind},
              {"caption", figure.words.caption},
              {"alt", figure.words.alt},
              {"scene", figure.part->stem},
              {"scene_title", scene.title},
              {"seed", scene.seed},
              {"overrides", scene.source.overrides},
              {"times", figure.words.shown.times}};
    if (figure.words.shown.over) json["over"] = *figure.words.shown.over;
    if (scene.units == UnitSystem::real) json["time_unit"] = unit_of_calculation(quantities::time);
    for (const ComparedRun& run : spec.compare)
        json["runs"].push_back(
            {{"label", run.label},
             {"scene", std::filesystem::path(run.scene->source.path).stem().string()},
             {"scene_title", run.scene->title},
             {"seed", run.scene->seed},
             {"overrides", run.scene->source.overrides},
             {"times", run.scene->figures.front().times}});
    json["size_cm"] = figure_size(scene, spec);
    json["files"] = figure.files;
    return json;
}

}  // namespace

void require_picture(const FigureSet& set, const FigureSpec& figure, Files files, PageKind kind) {
    if (picture_of(files, kind).empty())
        throw UsageError(fmt::format(
            "{}: this page needs figures as {}, and `{}` has neither; add one to --formats", set.of,
            kind == PageKind::latex ? "pdf or png" : "svg or png", figure.name));
}

PageTemplate page_template(const std::string& asked) {
    fs::path path = asked;
    if (std::ranges::find(page_templates, asked) != page_templates.end()) {
        const auto own = static_cast<std::size_t>(std::ranges::find(page_templates, asked) -
                                                  page_templates.begin());
        path = templates_folder() / "documents" / (asked + kinds.at(own).first);
    }
    for (const auto& [ending, kind] : kinds)
        if (path.extension() == ending) return {template_file(path), kind, ending};
    throw UsageError(
        fmt::format("--page {}: expected {} or a template of your own, whose name ends in .md, "
                    ".html or .tex",
                    asked, listed(page_templates, "or")));
}

std::string page_text(const FigureSet& set, const PageTemplate& page,
                      std::span<const SetFigure> figures, std::span<const SetFilm> films) {
    PageFields all;
    const Language language = set.parts.front().scene.film.language;
    all.language = language;
    all.words = {{"title", set.title},
                 {"description", set.description},
                 {"language", std::string(word_of(language))},
                 {"carom", CAROM_VERSION},
                 {"style", style_properties_of(set.parts.front().scene.film)}};
    std::vector<PageFields>&all_figures = all.lists["figures"], &all_films = all.lists["films"];
    std::vector<PageFields> sections;
    for (const SetPart& part : set.parts) {
        PageFields section;
        const bool alone = set.parts.size() == 1 && part.title == set.title;  // says it above
        section.words = {{"title", alone ? "" : part.title},
                         {"subtitle", part.scene.subtitle},
                         {"description", alone ? "" : part.description},
                         {"scene", as_utf8(part.stem)},
                         {"seed", std::to_string(part.scene.seed)}};
        std::vector<PageFields>& shown = section.lists["figures"];
        for (const SetFigure& figure : figures) {
            if (figure.part != &part) continue;
            shown.push_back(
                fields_of(set, figure, static_cast<int>(all_figures.size()) + 1, page.kind));
            all_figures.push_back(shown.back());
        }
        std::vector<PageFields>& played = section.lists["films"];
        for (const SetFilm& film : films)
            if (film.part == &part) played.push_back(fields_of(film));
        all_films.insert(all_films.end(), played.begin(), played.end());
        sections.push_back(std::move(section));
    }
    all.lists["sections"] = std::move(sections);
    return filled_page(page.source, page.kind, all);
}

std::string captions_json(const std::string& title, std::span<const SetFigure> figures) {
    Json list = Json::array();
    for (const SetFigure& figure : figures) list.push_back(figure_json(figure));
    return text_of({{"carom", CAROM_VERSION}, {"title", title}, {"figures", std::move(list)}}, 2) +
           "\n";
}

}  // namespace carom
