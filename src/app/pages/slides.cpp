#include "app/pages/slides.h"

#include <fmt/format.h>

#include <array>
#include <set>
#include <system_error>
#include <utility>

#include "app/output.h"
#include "draw/style.h"
#include "films/first_pass.h"
#include "panels/panel.h"
#include "runs/own_files.h"
#include "util/diagnostics.h"
#include "util/files/input_file.h"
#include "util/fingerprint.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

const std::string slides_manifest = "slides.json";

// The files of Reveal.js as templates/ and as the folder name them.
constexpr std::array<std::pair<const char*, const char*>, 4> reveal_files{
    {{"reveal.js", "reveal.js"},
     {"reveal.css", "reveal.css"},
     {"notes.js", "reveal-notes.js"},
     {"LICENSE.txt", "reveal-license.txt"}}};

const Placeholders& placeholders_of_slides() {
    static const Placeholders names{
        {"", {"title", "language", "carom", "page", "slides"}},
        {"slides",
         {"id",          "number",   "count",    "several",      "title",         "subtitle",
          "description", "about",    "language", "film",         "type",          "poster",
          "width",       "height",   "captions", "descriptions", "chapter_track", "seconds",
          "length",      "chapters", "page",     "ink",          "quiet"}},
        {"chapters", {"at", "clock", "words"}}};
    return names;
}

std::map<std::string, std::string> files_of_reveal() {
    constexpr std::int64_t most_bytes = 1 << 20;
    std::map<std::string, std::string> files;
    for (const auto& [name, file] : reveal_files)
        files[file] = read_file(templates_folder() / "reveal" / name, most_bytes);
    return files;
}

void refuse_other_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error) || fs::is_empty(folder, error)) return;
    if (fs::exists(fs::symlink_status(folder / slides_manifest, error))) return;
    throw UsageError(
        fmt::format("--slides {}: this folder holds files and is none of slides; name a new one, "
                    "for instance {}",
                    folder.string(), (folder / "slides").string()));
}

// Before the list of a folder of slides is read.
const fs::path& with_slides(const fs::path& folder) {
    refuse_other_folder(folder);
    return folder;
}

}  // namespace

Slides::Slides(SlidesOptions options)
    : options_(std::move(options)),
      folder_(with_slides(options_.folder), "slides", slides_manifest),
      page_(document_template("slides.html")),
      reveal_(files_of_reveal()) {
    std::vector<std::string> files = files_of_slides();
    for (const std::string& file : files) Output::refuse_used(options_.folder / file);
    replaced_ = folder_.foreign(files);
    if (replaced_.empty() || options_.force) return;
    const bool one = replaced_.size() == 1;
    throw UsageError(
        fmt::format("--slides {}: carom did not write {} as {} now; nothing has been written. "
                    "Name another folder, or replace {} with --force",
                    options_.folder.string(), listed(replaced_), one ? "it is" : "they are",
                    one ? "it" : "them"));
}

std::vector<std::string> Slides::files_of_slides() const {
    std::vector<std::string> files{"index.html"};
    for (const auto& [file, text] : reveal_) files.push_back(file);
    for (const std::string& name : options_.names) {
        files.push_back(name + "." + options_.format);
        files.push_back(name + ".png");
        if (!options_.words) continue;
        for (const auto& [what, ending] : text_endings) files.push_back(name + ending);
    }
    return files;
}

void Slides::write(const std::string& file, std::string_view bytes) {
    files_->write_pieces(file, [&](const TakePiece& take) { take(bytes); });
    contents_[file] = fingerprint(bytes);
}

RenderReport Slides::add(const Scene& scene, FilmOptions options, Progress& progress) {
    if (!files_) files_.emplace(options_.folder, Earlier::replaced);
    const std::string& name = options_.names.at(slides_.size());
    const std::string film = name + "." + options_.format, poster = name + ".png";
    options.output = film;
    options.text = true;
    options.take = [&](const FilmWriter& made) {
        GrowingFingerprint content;
        files_->write_pieces(film, [&](const TakePiece& take) {
            made.copy([&](std::string_view piece) {
                take(piece);
                content.add(piece);
            });
        });
        contents_[film] = content.digits();
    };
    const FilmPlan plan = prepare(scene, options, progress);
    RenderReport report = render(plan, options, progress);
    report.path = options_.folder / film;
    if (!fits(report, options)) return report;
    const std::vector<std::uint8_t> picture = drawn_poster(plan, options, progress);
    write(poster, {reinterpret_cast<const char*>(picture.data()), picture.size()});
    if (options_.words)
        for (const auto& [what, ending] : text_endings)
            write(name + ending, text_for_file(plan.text, what));
    PageFields slide =
        film_fields({plan.scene, plan.text, {film, ""}, {poster, ""}, {name + ".yaml", ""}});
    const Theme& theme = theme_of(plan.scene.film);
    const double seconds = static_cast<double>(report.frames) / plan.scene.film.fps;
    slide.words.insert({{"id", fmt::format("film-{}", slides_.size() + 1)},
                        {"number", std::to_string(slides_.size() + 1)},
                        {"count", std::to_string(options_.names.size())},
                        {"several", options_.names.size() > 1 ? "several" : ""},
                        {"seconds", fmt::format("{:.3f}", seconds)},
                        {"length", clock_text(seconds)},
                        {"page", hex_of(theme.page)},
                        {"ink", hex_of(theme.ink)},
                        {"quiet", hex_of(theme.second)}});
    slides_.push_back(std::move(slide));
    return report;
}

SlidesReport Slides::finish() {
    PageFields all;
    all.language = slides_.front().language;
    for (const char* name : {"title", "language", "carom", "page"})
        all.words[name] = slides_.front().words.at(name);
    all.lists["slides"] = std::move(slides_);
    write("index.html", filled_page(page_, PageKind::html, all, placeholders_of_slides()));
    for (const auto& [file, text] : reveal_) write(file, text);
    std::set<std::string> kept;
    for (const auto& [file, content] : contents_) kept.insert(file);
    folder_.write(*files_, contents_);
    SlidesReport report;
    report.replaced = std::move(replaced_);
    report.left = folder_.remove_all_but(kept, report.removed);
    folder_.save();
    return report;
}

}  // namespace carom
