#include "app/pages/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "app/depfile.h"
#include "app/figures/figure_folder.h"
#include "app/pages/film_page.h"
#include "figures/page_style.h"
#include "films/cost/work.h"
#include "films/film_checks.h"
#include "films/first_pass.h"
#include "runs/json.h"
#include "runs/own_files.h"
#include "scene/sets/set_reading.h"
#include "scene/style/style_reading.h"
#include "util/diagnostics.h"
#include "util/fingerprint.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr int width_of_card = 640;  // pixels
const std::string index_name = "index.html";
const std::string manifest_name = "gallery.json";

// A scene of the folder.
struct GalleryFile {
    fs::path path;       // as it is read
    std::string name;    // in the folder, without its ending: classics/freezing
    std::string folder;  // in which it is there; empty: the folder itself
};

bool is_scene_name(const fs::path& path) {
    const std::string ending = path.extension().string();
    return (ending == ".yaml" || ending == ".yml") && !path.filename().string().starts_with('.');
}

bool is_inside(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    const fs::path relative =
        fs::weakly_canonical(path, error).lexically_relative(fs::weakly_canonical(folder, error));
    return !relative.empty() && *relative.begin() != "..";
}

// Those of a folder and of the folders in it, but for what belongs to the site.
std::vector<GalleryFile> files_in(const GalleryOptions& options) {
    std::error_code error;
    if (!fs::is_directory(options.folder, error))
        throw UsageError(
            fmt::format("{}: expected a folder of scenes; for one scene, carom render "
                        "SCENE --page html makes a page",
                        options.folder.string()));
    std::vector<GalleryFile> files;
    fs::recursive_directory_iterator entry(options.folder, error), end;
    for (; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (entry->is_directory(error) &&
            (path.filename().string().starts_with('.') || is_inside(path, options.site))) {
            entry.disable_recursion_pending();
            continue;
        }
        if (!entry->is_regular_file(error) || !is_scene_name(path)) continue;
        if (!is_inside(path, options.folder))
            throw UsageError(fmt::format(
                "{}: this link leads out of the folder; copy the scene into it", path.string()));
        if (is_figure_set(path) || is_style(path)) continue;
        const fs::path inside = path.lexically_relative(options.folder);
        files.push_back(
            {path, fs::path(inside).replace_extension().string(), inside.parent_path().string()});
    }
    if (error)
        throw_system_error(
            fmt::format("cannot read the folder {}: {}", options.folder.string(), error.message()),
            error.value());
    if (files.empty())
        throw UsageError(
            fmt::format("{}: there is no scene in this folder (a file that ends in "
                        ".yaml)",
                        options.folder.string()));
    // Those of the folder itself come first.
    std::ranges::sort(files, {},
                      [](const GalleryFile& file) { return std::pair(file.folder, file.name); });
    const auto same = std::ranges::adjacent_find(files, {}, &GalleryFile::name);
    if (same != files.end())
        throw UsageError(fmt::format("{} and {} would have one page; rename one of them",
                                     same->path.string(), std::next(same)->path.string()));
    return files;
}

// A scene and what becomes of it.
struct GalleryItem {
    GalleryFile file;
    Scene scene;
    std::string inputs;  // fingerprint of all that its files are made from

    // By what they are.
    std::map<std::string, std::string> files(const std::string& format) const {
        const std::string stem = "films/" + file.name;
        std::map<std::string, std::string> all{{"film", stem + "." + format},
                                               {"poster", stem + ".poster.png"},
                                               {"card", stem + ".card.png"},
                                               {"page", stem + ".html"}};
        if (scene.film.has_recipe) all.emplace("scene", stem + ".yaml");
        return all;
    }
};

std::string title_of(const GalleryOptions& options) {
    return options.title.empty() ? as_utf8(name_of_folder(options.folder)) : options.title;
}

std::string inputs_of(const GalleryOptions& options, const Scene& scene, const Source& page) {
    Json all{CAROM_VERSION,
             scene.source.text,
             scene.source.template_text,
             options.format,
             static_cast<int>(options.film.quality),
             page.text,
             title_of(options)};
    for (const std::string& change : scene.source.overrides) all.push_back(change);
    for (const auto& [name, text] : scene.source.files) all.push_back(text);
    return fingerprint(text_of(all));
}

std::vector<GalleryItem> items_of(const GalleryOptions& options, const Source& page) {
    SceneResources resources = scene_resources();
    resources.is_classroom = options.is_classroom;
    resources.is_strict = options.is_strict;
    const OutputFormat& format = output_format(options.format);
    return all_made(files_in(options), [&](const GalleryFile& file) {
        GalleryItem item{file, load_scene(file.path, resources, options.overrides), ""};
        refuse_unfit(item.scene, options.film, format);
        refuse_much_film(item.scene, options.film, format);
        item.inputs = inputs_of(options, item.scene, page);
        return item;
    });
}

const Placeholders& placeholders_of_gallery() {
    static const Placeholders names{
        {"", {"title", "language", "carom", "shown", "sections", "style"}},
        {"sections", {"number", "title", "films"}},
        {"films",
         {"title", "subtitle", "language", "words", "length", "page", "film", "card", "width",
          "height"}}};
    return names;
}

int height_of_card(const Film& film) {
    return std::max(1, width_of_card * film.size.height / film.size.width);
}

// What the search looks through.
std::string words_of(const GalleryItem& item) {
    const Scene& scene = item.scene;
    std::string words = fmt::format("{} {} {} {}", as_utf8(item.file.name), scene.title,
                                    scene.subtitle, scene.description);
    for (const Species& species : scene.gas.species) words += " " + species.name;
    for (const PanelSpec& panel : scene.film.panels) words += " " + panel.kind;
    return words;
}

PageFields card_of(const GalleryItem& item, const std::string& format) {
    PageFields fields;
    fields.words = {{"title", item.scene.title},
                    {"subtitle", item.scene.subtitle},
                    {"language", std::string(word_of(item.scene.film.language))},
                    {"words", words_of(item)},
                    {"length", clock_text(item.scene.film.seconds)},
                    {"width", std::to_string(width_of_card)},
                    {"height", std::to_string(height_of_card(item.scene.film))}};
    fields.files = item.files(format);
    return fields;
}

// That of a style which all films have.
std::string common_style(const std::vector<GalleryItem>& items) {
    const std::string first = style_properties_of(items.front().scene.film);
    return std::ranges::all_of(items,
                               [&](const GalleryItem& item) {
                                   return style_properties_of(item.scene.film) == first;
                               })
               ? first
               : "";
}

std::string index_page(const GalleryOptions& options, const std::vector<GalleryItem>& items,
                       const Source& page) {
    const std::string counted = "#";  // the script of the page writes the number there
    PageFields all;
    const Language language = items.front().scene.film.language;
    all.language = language;
    all.words = {{"title", title_of(options)},
                 {"language", std::string(word_of(language))},
                 {"carom", CAROM_VERSION},
                 {"shown", say(language, "{} of {} films", counted, items.size())},
                 {"style", common_style(items)}};
    std::vector<PageFields>& sections = all.lists["sections"];
    const std::string* folder = nullptr;
    for (const GalleryItem& item : items) {
        if (folder == nullptr || *folder != item.file.folder) {
            folder = &item.file.folder;
            sections.push_back({.words = {{"title", as_utf8(*folder)},
                                          {"number", std::to_string(sections.size() + 1)}}});
        }
        sections.back().lists["films"].push_back(card_of(item, options.format));
    }
    return filled_page(page, PageKind::html, all, placeholders_of_gallery());
}

// From a page in films/, the address of the index.
std::string way_to_index(const std::string& name) {
    std::string way = "../";
    for (const char letter : name)
        if (letter == '/') way += "../";
    return way + index_name;
}

class GalleryMaker {
  public:
    explicit GalleryMaker(const GalleryOptions& options)
        : options_(options),
          film_template_(document_template("film.html")),
          index_template_(document_template("gallery.html")),
          items_(items_of(options, film_template_)),
          folder_(options.site, "the folder " + as_utf8(name_of_folder(options.folder)),
                  manifest_name) {}

    GalleryReport make() {
        const std::string index = index_page(options_, items_, index_template_);
        refuse_foreign();
        FolderRules rules(options_.depfile);
        rules.add(options_.site / index_name, files_read());
        refuse_used();
        try {
            for (const GalleryItem& item : items_) make_film(item);
            folder_.write(std::vector<NewFile>{
                {index_name, {index.begin(), index.end()}, "", fingerprint(index)}});
            remove_others();
        } catch (...) {
            folder_.save();  // what is written is known, however the work ended
            throw;
        }
        folder_.save();
        rules.commit();
        return report_;
    }

  private:
    // With the folders: a scene that is new changes the time of its folder.
    std::vector<std::string> files_read() const {
        std::vector<std::string> files;
        for (const GalleryItem& item : items_)
            files.push_back(item.file.path.parent_path().string());
        for (const GalleryItem& item : items_)
            std::ranges::copy(files_of(item.scene), std::back_inserter(files));
        for (const Source* page : {&film_template_, &index_template_}) files.push_back(page->name);
        return files;
    }

    bool is_current(const GalleryItem& item) const {
        return !options_.force &&
               std::ranges::all_of(item.files(options_.format), [&](const auto& file) {
                   return folder_.is_current(file.second, item.inputs);
               });
    }

    void refuse_foreign() {
        std::vector<std::string> files{index_name};
        for (const GalleryItem& item : items_)
            if (!is_current(item))
                for (const auto& [what, file] : item.files(options_.format)) files.push_back(file);
        report_.replaced = folder_.foreign(files);
        if (report_.replaced.empty() || options_.force) return;
        throw UsageError(fmt::format(
            "{}: carom did not write {} as {} now; nothing has been written. Choose another "
            "folder, or replace {} with --force",
            options_.site.string(), listed(report_.replaced),
            report_.replaced.size() == 1 ? "it is" : "they are",
            report_.replaced.size() == 1 ? "it" : "them"));
    }

    void refuse_used() const {
        for (const std::string& name : {index_name, manifest_name})
            Output::refuse_used(options_.site / name);
        for (const GalleryItem& item : items_)
            for (const auto& [what, file] : item.files(options_.format))
                Output::refuse_used(options_.site / file);
    }

    void make_film(const GalleryItem& item) {
        if (is_current(item)) {
            ++report_.up_to_date;
            return;
        }
        throw_if_interrupted();
        Progress progress(Progress::fitting_form(options_.quiet), as_utf8(item.file.name));
        const std::string film = item.files(options_.format).at("film");
        FilmOptions options = options_.film;
        options.output = film;
        options.text = true;
        options.take = [&](const FilmWriter& made) { folder_.write(made, film, item.inputs); };
        FilmPlan plan = prepare(item.scene, options, progress);
        render(plan, options, progress);
        folder_.write(files_beside(item, std::move(plan), progress));
        folder_.save();
        ++report_.made;
    }

    // Names in the page are those beside it.
    std::string page_of(const GalleryItem& item, const FilmPlan& plan) const {
        const auto files = item.files(options_.format);
        const auto beside = [&](const char* what) {
            return PageFile{fs::path(files.at(what)).filename().string(), ""};
        };
        return film_page(film_template_,
                         {.scene = plan.scene,
                          .text = plan.text,
                          .film = beside("film"),
                          .poster = beside("poster"),
                          .source = files.contains("scene") ? beside("scene") : PageFile{},
                          .site = title_of(options_),
                          .index = way_to_index(item.file.name)});
    }

    // The page, the scene, and the same frame twice: as large as the film, and for its card. The
    // last use of the plan.
    std::vector<NewFile> files_beside(const GalleryItem& item, FilmPlan plan,
                                      Progress& progress) const {
        const auto names = item.files(options_.format);
        std::vector<NewFile> files;
        const auto add = [&](const char* what, const auto& bytes) {
            files.push_back({names.at(what), {bytes.begin(), bytes.end()}, "", item.inputs});
        };
        add("page", page_of(item, plan));
        if (names.contains("scene")) add("scene", item.scene.source.text);
        const double at = time_of_poster(plan.scene);
        const OutputFormat& png = output_format("png");
        add("poster", draw_still(plan, at, png, progress).file());
        plan.scene.film.size = {width_of_card, height_of_card(plan.scene.film)};
        add("card", draw_still(plan, at, png, progress).file());
        return files;
    }

    void remove_others() {
        std::set<std::string> kept{index_name};
        for (const GalleryItem& item : items_)
            for (const auto& [what, file] : item.files(options_.format)) kept.insert(file);
        report_.left = folder_.remove_all_but(kept, report_.removed);
    }

    const GalleryOptions& options_;
    Source film_template_, index_template_;
    std::vector<GalleryItem> items_;
    FigureFolder folder_;
    GalleryReport report_;
};

}  // namespace

std::string name_of_folder(const fs::path& folder) {
    return fs::absolute(folder / "").lexically_normal().parent_path().filename().string();
}

GalleryReport make_gallery(const GalleryOptions& options) {
    std::error_code error;
    if (fs::weakly_canonical(options.site, error) == fs::weakly_canonical(options.folder, error))
        throw UsageError(
            fmt::format("-o {}: this is the folder of the scenes; name another one for the site",
                        options.site.string()));
    return GalleryMaker(options).make();
}

}  // namespace carom
