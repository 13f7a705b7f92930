#include "app/figures/figure_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "app/resources.h"
#include "figures/figure_words.h"
#include "media/base64.h"
#include "media/formats.h"
#include "scene/limits.h"
#include "scene/yaml/file_text.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_picture_bytes = 256 << 20;

const std::array<std::pair<std::string, PageKind>, 3> kinds{
    {{".md", PageKind::markdown}, {".html", PageKind::html}, {".tex", PageKind::latex}}};

std::string file_of(const SetFigure& figure, const std::string& format) {
    const std::string name = figure.name + "." + format;
    return std::ranges::find(figure.files, name) != figure.files.end() ? name : "";
}

// What a page of this kind shows: vectors where it can.
std::string picture_of(const SetFigure& figure, PageKind kind) {
    const std::string vectors = file_of(figure, kind == PageKind::latex ? "pdf" : "svg");
    return vectors.empty() ? file_of(figure, "png") : vectors;
}

std::string inlined(const fs::path& picture) {
    const std::string type = picture.extension() == ".svg" ? "image/svg+xml" : "image/png";
    return "data:" + type + ";base64," + base64(read_file(picture, most_picture_bytes));
}

PageFields fields_of(const FigureSet& set, const SetFigure& figure, int number, PageKind kind) {
    require_picture(set, figure, kind);
    const std::string picture = picture_of(figure, kind);
    PageFields fields;
    fields.words = {{"name", figure.name},
                    {"number", std::to_string(number)},
                    {"caption", figure.caption},
                    {"alt", figure.alt},
                    {"kind", figure.spec->panel.kind},
                    {"time", shown_times(*figure.spec)},
                    {"title", figure.part->title},
                    {"scene", as_utf8(figure.part->stem)},
                    {"seed", std::to_string(figure.part->scene.seed)},
                    {"width", fmt::format("{:g}", figure.size[0])},
                    {"height", fmt::format("{:g}", figure.size[1])}};
    fields.files = {{"picture", picture}, {"csv", file_of(figure, "csv")}};
    for (const std::string& format : figure_formats())
        fields.files[format] = file_of(figure, format);
    if (kind == PageKind::html) fields.files["inline"] = inlined(set.folder / picture);
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
        errors.add(source, fmt::format("the file has more than {} bytes", most_file_bytes.count()));
    errors.throw_if_any();
    source.text = *text;
    return source;
}

}  // namespace

void require_picture(const FigureSet& set, const SetFigure& figure, PageKind kind) {
    if (picture_of(figure, kind).empty())
        throw UsageError(fmt::format(
            "{}: this page shows figures as {}, and there is no such file of `{}`; ask for more "
            "--formats",
            set.of, kind == PageKind::latex ? "pdf or png" : "svg or png", figure.name));
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
    all.words = {{"title", set.title}, {"description", set.description}, {"carom", CAROM_VERSION}};
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

}  // namespace carom
