// carom figures: the figures of scenes and of sets, those of each in a folder.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "app/command.h"
#include "app/figures/figure_set.h"
#include "app/figures/set_loading.h"
#include "app/output.h"
#include "app/progress.h"
#include "media/formats.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct FiguresArguments : SceneOptions {
    std::vector<std::string> scenes;
    std::string output;
    std::vector<std::string> formats;
    std::vector<std::string> pages;
    SetOptions options;
};

fs::path folder_of(const FiguresArguments& arguments, const std::string& name) {
    if (arguments.output.empty()) return fs::path("out") / scene_stem(name);
    const fs::path output = arguments.output;
    return arguments.scenes.size() > 1 ? output / scene_stem(name) : output;
}

// What is said on the command line wins over the file.
FigureSet set_of(const FiguresArguments& arguments, const std::string& name) {
    FigureSet set = load_set(name, overrides_of(arguments), arguments.formats, arguments.pages);
    set.folder = folder_of(arguments, name);
    return set;
}

// All scenes before any work: a mistake in the last one must not cost the time of the first.
std::vector<FigureSet> sets_of(const FiguresArguments& arguments) {
    return all_made(arguments.scenes,
                    [&](const std::string& name) { return set_of(arguments, name); });
}

void refuse_standard_output(const FiguresArguments& arguments) {
    if (Output::is_standard_output(arguments.output))
        throw UsageError(
            fmt::format("-o {}: figures are several files; name a folder", arguments.output));
}

void refuse_same_folders(const FiguresArguments& arguments) {
    refuse_second_standard_input(arguments.scenes);
    std::set<fs::path> folders;
    for (const std::string& name : arguments.scenes)
        if (const fs::path folder = folder_of(arguments, name).lexically_normal();
            !folders.insert(folder).second)
            throw UsageError(
                fmt::format("the figures of two scenes would go into {}; make them one by one "
                            "with -o",
                            folder.string()));
}

void print_report(const FigureSet& set, const SetReport& report) {
    if (report.films > 0)
        fmt::print("{}: {} rendered\n", set.folder.string(), counted(report.films, "film"));
    if (report.made == 0)
        return fmt::print("{}: up to date, {}\n", set.folder.string(),
                          counted(report.up_to_date, "figure"));
    fmt::print("{}: {} made{}\n", set.folder.string(), counted(report.made, "figure"),
               report.up_to_date > 0 ? fmt::format(", {} up to date", report.up_to_date) : "");
}

void warn(const FigureSet& set, const SetReport& report) {
    if (!report.replaced.empty())
        say(fmt::format("carom: {}: replaced {}, not written by carom or changed since\n",
                        set.folder.string(), listed(report.replaced)));
    for (const auto& [page, letters] : report.unset)
        say(
            fmt::format("carom: {}: pdfLaTeX cannot set {}; LuaLaTeX and XeLaTeX can, with a font "
                        "that has {}\n",
                        (set.folder / page).string(), fmt::join(letters, " "),
                        letters.size() == 1 ? "it" : "them"));
    if (!report.gone.empty())
        say(fmt::format("carom: {}: {} of figures that no longer exist; left as {}\n",
                        set.folder.string(), listed(report.gone),
                        report.gone.size() == 1 ? "it is" : "they are"));
}

void make_all(const FiguresArguments& arguments) {
    refuse_standard_output(arguments);
    refuse_same_folders(arguments);
    SetOptions options = arguments.options;
    options.threads = threads_of(arguments);
    options.quiet = arguments.quiet;
    const std::vector<FigureSet> sets = sets_of(arguments);
    try {
        for (const FigureSet& set : sets) {
            const SetReport report = make_figures(set, options);
            warn(set, report);
            if (!arguments.quiet) print_report(set, report);
        }
    } catch (const Interrupted&) {
        throw Interrupted("figures that were finished stay, and are not made again");
    }
}

}  // namespace

Command figures_command() {
    const auto arguments = std::make_shared<FiguresArguments>();
    FiguresArguments& its = *arguments;
    return {
        "figures", "draw the figures of scenes and figure sets",
        joined<Option>(
            {{{"scenes", "files of scenes and of figure sets; - for a scene from standard input",
               &its.scenes},
              {"-o,--output",
               "output folder, for several scenes with a subfolder for each; default: out/SCENE",
               &its.output},
              {"--formats",
               fmt::format("{}; several separated by commas", fmt::join(figure_formats(), ", ")),
               CommaSeparated{&its.formats}, figure_formats()},
              {"--only", "only the figures with these names, separated by commas",
               CommaSeparated{&its.options.only}},
              {"--force", "draw all again, and replace files that carom did not write",
               &its.options.force},
              {"--page",
               "write a page that shows them: markdown, html, latex, or a template of your own "
               "(.md, .html, .tex); several separated by commas",
               CommaSeparated{&its.pages}},
              {"--films", "also render the films of the scenes, which pages then show",
               &its.options.films}},
             scene_options(its),
             {language_option(its),
              {"--threads", "cores to use; the result is the same for any number", &its.threads}}}),
        [arguments] { make_all(*arguments); }};
}

}  // namespace carom
