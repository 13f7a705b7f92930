// carom gallery: a static site of a folder of scenes.
#include <fmt/format.h>

#include <memory>

#include "app/command.h"
#include "app/depfile.h"
#include "app/film/film_request.h"
#include "app/output.h"
#include "app/pages/gallery.h"
#include "media/formats.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct GalleryArguments : SceneOptions {
    std::string folder, output;
    GalleryOptions gallery;
};

constexpr const char* finished_films = "films that were finished stay, and are not made again";

void warn(const std::string& site, const GalleryReport& report) {
    if (!report.replaced.empty())
        print_to_stderr(
            fmt::format("carom: {}: replaced {}, not written by carom or changed since\n", site,
                        printable(listed(report.replaced))));
    if (!report.left.empty())
        print_to_stderr(
            fmt::format("carom: {}: {} of scenes that no longer exist; changed since, and left\n",
                        site, printable(listed(report.left))));
}

GalleryReport made(const GalleryOptions& options) {
    try {
        return make_gallery(options);
    } catch (const Interrupted&) {
        throw Interrupted(finished_films);
    } catch (const TemporaryError& error) {
        throw TemporaryError(fmt::format("{}; {}", error.what(), finished_films));
    }
}

void make_site(GalleryArguments& arguments) {
    if (Output::is_standard_output(arguments.output))
        throw UsageError(
            fmt::format("-o {}: a site is several files; name a folder", arguments.output));
    GalleryOptions& options = arguments.gallery;
    options.folder = arguments.folder;
    options.site = arguments.output.empty() ? fs::path("out") / name_of_folder(options.folder)
                                            : fs::path(arguments.output);
    options.overrides = overrides_of(arguments);
    options.film.threads = threads_of(arguments);
    options.quiet = arguments.quiet;
    options.is_classroom = arguments.is_classroom;
    options.is_strict = arguments.is_strict;
    const GalleryReport report = made(options);
    const std::string site = printable(options.site.string());
    warn(site, report);
    if (arguments.quiet) return;
    std::string text = fmt::format("{}: ", site);
    text += report.made == 0 ? "up to date, " + counted(report.up_to_date, "film")
                             : counted(report.made, "film") + " made";
    if (report.made > 0 && report.up_to_date > 0)
        text += fmt::format(", {} up to date", report.up_to_date);
    if (!report.removed.empty())
        text += fmt::format(", {} of scenes that no longer exist removed",
                            counted(static_cast<int>(report.removed.size()), "file"));
    fmt::print("{}\n", text);
}

CommandText gallery_text() {
    return {{"carom gallery FOLDER -o SITE/ [options]"},
            "Makes a static site of all scenes in a folder and its subfolders: a page of cards "
            "with a search, and for each scene a page with its film, chapters, transcript and "
            "scene file. The site needs no server. Only what has changed is made again.",
            {{"carom gallery scenes -o site/", "the library that comes with carom"},
             {"carom gallery scenes/classics -o site/ --size 720p --title Classics",
              "smaller films, and a title"},
             {"carom gallery scenes -o site/ --format webm --quality final",
              "in the most compact format"}}};
}

}  // namespace

Command gallery_command() {
    const auto arguments = std::make_shared<GalleryArguments>();
    GalleryArguments& its = *arguments;
    return {"gallery", "make a static site of a folder of scenes",
            joined<Option>(
                {{{"folder", "a folder of scenes", &its.folder},
                  {"-o,--output SITE", "the folder of the site; default: out/FOLDER", &its.output},
                  {"--title WORDS", "the title of the site; default: the folder's name",
                   &its.gallery.title},
                  {"--format", "mp4 or webm", &its.gallery.format, {"mp4", "webm"}},
                  {"--force", "make all films again, and replace files that carom did not write",
                   &its.gallery.force},
                  depfile_option(its.gallery.depfile)},
                 scene_options(its),
                 {limits_option(its.is_classroom)},
                 picture_options(its),
                 film_shape_options(its, its.gallery.film),
                 {threads_option(its)}}),
            [arguments] { make_site(*arguments); }, gallery_text()};
}

}  // namespace carom
