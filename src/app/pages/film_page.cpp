#include "app/pages/film_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "figures/page_style.h"
#include "films/first_pass.h"
#include "media/base64.h"
#include "runs/own_files.h"
#include "util/files/input_file.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

const Placeholders& placeholders_of_film() {
    static const Placeholders names{
        {"", {"title",      "subtitle",  "description",  "language",      "carom",
              "film",       "film_file", "type",         "poster",        "width",
              "height",     "captions",  "descriptions", "chapter_track", "scene",
              "scene_file", "offered",   "changed",      "about",         "site",
              "site_index", "chapters",  "passages",     "changes",       "style"}},
        {"chapters", {"at", "clock", "words"}},
        {"passages", {"clock", "words"}},
        {"changes", {"change"}}};
    return names;
}

// As the page shows an address of it.
void put(PageFields& fields, const std::string& name, const PageFile& file) {
    if (file.inlined.empty())
        fields.files[name] = file.name;
    else
        fields.inlined[name] = file.inlined;
}

std::string track(const std::string& words) {
    return words.empty() ? "" : data_address("text/vtt", words);
}

std::vector<PageFields> listed_cues(const std::vector<Cue>& cues) {
    std::vector<PageFields> list;
    for (const Cue& cue : cues)
        list.push_back({.words = {{"at", fmt::format("{:.3f}", cue.start)},
                                  {"clock", clock_text(cue.start)},
                                  {"words", cue.words}}});
    return list;
}

std::string media_type(const fs::path& film) {
    return ending_of(film) == ".webm" ? "video/webm" : "video/mp4";
}

}  // namespace

Source document_template(const std::string& name) {
    const fs::path path = templates_folder() / "pages" / name;
    constexpr std::int64_t most = 1 << 20;
    return {path.string(), read_file(path, most)};
}

PageFields film_fields(const FilmPage& content) {
    const Scene& scene = content.scene;
    PageFields fields;
    fields.language = scene.film.language;
    fields.words = {
        {"title", scene.title},
        {"subtitle", scene.subtitle},
        {"description", scene.description},
        {"language", std::string(word_of(scene.film.language))},
        {"carom", CAROM_VERSION},
        {"type", media_type(content.film.name)},
        {"film_file", as_utf8(fs::path(content.film.name).filename().string())},
        {"scene_file", as_utf8(fs::path(content.source.name).filename().string())},
        {"width", std::to_string(scene.film.size.width)},
        {"height", std::to_string(scene.film.size.height)},
        {"about", content.text.about},
        {"site", content.site},
        {"style", style_properties_of(scene.film)},
        {"offered", scene.film.has_recipe ? "offered" : ""},
        {"changed", scene.film.has_recipe && !scene.source.overrides.empty() ? "changed" : ""}};
    put(fields, "film", content.film);
    put(fields, "poster", content.poster);
    put(fields, "scene", content.source);
    fields.files["site_index"] = content.index;
    fields.inlined["captions"] = track(content.text.captions);
    fields.inlined["descriptions"] = track(content.text.descriptions);
    fields.inlined["chapter_track"] = track(content.text.chapters);
    fields.lists["chapters"] = listed_cues(content.text.chapter_list);
    fields.lists["passages"] = listed_cues(content.text.passages);
    std::vector<PageFields>& changes = fields.lists["changes"];
    for (const std::string& change : scene.source.overrides)
        changes.push_back({.words = {{"change", as_utf8(change)}}});
    return fields;
}

std::string film_page(const Source& page, const FilmPage& content) {
    return filled_page(page, PageKind::html, film_fields(content), placeholders_of_film());
}

std::vector<std::uint8_t> drawn_poster(const FilmPlan& plan, const FilmOptions& options,
                                       Progress& progress) {
    return draw_still(plan, time_of_poster(plan.scene, options), output_format("png"), progress)
        .file();
}

RenderReport render_page(const Scene& scene, FilmOptions options, Output& output,
                         Progress& progress) {
    const std::string page = output.name();
    const Source document = document_template("film.html");
    std::string film_bytes;
    options.take = [&](const FilmWriter& film) {
        film.copy([&](std::string_view piece) { film_bytes += piece; });
    };
    options.text = true;
    const FilmPlan plan = prepare(scene, options, progress);
    RenderReport report = render(plan, options, progress);
    report.path = page;
    if (!fits(report, options)) return report;
    const std::vector<std::uint8_t> poster = drawn_poster(plan, options, progress);
    const std::string stem =
        Output::is_standard_output(page) ? "film" : fs::path(page).stem().string();
    const std::string film = stem + options.output.extension().string();
    output.write(film_page(
        document,
        {.scene = plan.scene,
         .text = plan.text,
         .film = {film, data_address(media_type(film), film_bytes)},
         .poster = {stem + ".png",
                    data_address("image/png",
                                 {reinterpret_cast<const char*>(poster.data()), poster.size()})},
         .source = {stem + ".yaml",
                    scene.film.has_recipe ? data_address("text/yaml", scene.source.text) : ""}}));
    output.commit();
    return report;
}

}  // namespace carom
