// carom figures: the figures of scenes and of sets, those of each in a folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "app/command.h"
#include "app/depfile.h"
#include "app/figures/figure_set.h"
#include "app/figures/set_loading.h"
#include "app/figures/set_work.h"
#include "app/output.h"
#include "figures/sweep_figure.h"
#include "media/formats.h"
#include "panels/registry.h"
#include "scene/keys/keys.h"
#include "scene/load.h"
#include "scene/panel_kind.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct FiguresArguments : SceneOptions {
    std::vector<std::string> scenes;
    std::string output;
    std::vector<std::string> formats;
    std::vector<std::string> pages;
    std::string depfile;
    SetOptions options;
};

fs::path folder_of(const FiguresArguments& arguments, const std::string& name) {
    if (arguments.output.empty()) return fs::path("out") / scene_stem(name);
    const fs::path output = arguments.output;
    return arguments.scenes.size() > 1 ? output / scene_stem(name) : output;
}

// Options of the command line take precedence over the file.
FigureSet set_of(const FiguresArguments& arguments, const std::string& name) {
    FigureSet set =
        load_set(name, resources_of(arguments), overrides_of(arguments), arguments.formats,
                 arguments.pages, arguments.options.films ? Wanted::film : Wanted::figures);
    set.folder = folder_of(arguments, name);
    return set;
}

// Loads all scenes before any work, so that a mistake in the last one shows before time is spent on
// the first.
std::vector<FigureSet> sets_of(const FiguresArguments& arguments) {
    return all_made(arguments.scenes,
                    [&](const std::string& name) { return set_of(arguments, name); });
}

void refuse_standard_output(const FiguresArguments& arguments) {
    if (Output::is_standard_output(arguments.output))
        throw UsageError(
            fmt::format("-o {}: figures are several files; name a folder", arguments.output));
    if (!arguments.output.empty()) refuse_file_for_folder(arguments.output, "a set of figures");
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
        fmt::print("{}: {} rendered\n", printable(set.folder.string()),
                   counted(report.films, "film"));
    if (report.made == 0)
        return fmt::print("{}: up to date, {}\n", printable(set.folder.string()),
                          counted(report.up_to_date, "figure"));
    fmt::print("{}: {} made{}\n", printable(set.folder.string()), counted(report.made, "figure"),
               report.up_to_date > 0 ? fmt::format(", {} up to date", report.up_to_date) : "");
}

void warn(const FigureSet& set, const SetReport& report) {
    if (!report.replaced.empty())
        print_to_stderr(
            fmt::format("carom: {}: replaced {}, not written by carom or changed since\n",
                        printable(set.folder.string()), printable(listed(report.replaced))));
    for (const auto& [page, letters] : report.unset)
        print_to_stderr(
            fmt::format("carom: {}: pdfLaTeX cannot set {}; LuaLaTeX and XeLaTeX can, with a font "
                        "that has {}\n",
                        printable((set.folder / page).string()), fmt::join(letters, " "),
                        letters.size() == 1 ? "it" : "them"));
    if (!report.gone.empty())
        print_to_stderr(fmt::format("carom: {}: {} of figures that no longer exist; left as {}\n",
                                    printable(set.folder.string()), printable(listed(report.gone)),
                                    report.gone.size() == 1 ? "it is" : "they are"));
}

// What the figures and pages of the set in the file `name` are made from.
std::vector<std::string> files_of(const FigureSet& set, const std::string& name) {
    std::vector<std::string> files;
    const auto add = [&](const std::string& file) { files.push_back(file); };
    if (name != standard_input) add(name);
    for (const SetPart& part : set.parts) {
        std::ranges::for_each(files_of(part.scene), add);
        for (const FigureSpec& figure : part.scene.figures) {
            for (const ComparedRun& run : figure.compare)
                if (run.scene) std::ranges::for_each(files_of(*run.scene), add);
            if (figure.panel.joined) add(path_of_joined(part.scene, figure).string());
        }
    }
    for (const PageTemplate& page : set.pages) add(page.source.name);
    return files;
}

// Refuses a set that exceeds --limits as a whole.
void refuse_much_work(const FigureSet& set, const SetOptions& options) {
    const SceneSource& first = set.parts.front().scene.source;
    if (first.is_held_to_classroom)
        refuse_much_work(work_of_set(set, options.only, options.films), first);
}

constexpr const char* finished = "figures that were finished stay, and are not made again";

void make_all(const FiguresArguments& arguments) {
    refuse_standard_output(arguments);
    refuse_same_folders(arguments);
    SetOptions options = arguments.options;
    options.threads = threads_of(arguments);
    options.quiet = arguments.quiet;
    const std::vector<FigureSet> sets = sets_of(arguments);
    for (const FigureSet& set : sets)
        for (const SetPart& part : set.parts) say_notes(arguments, part.scene);
    for (const FigureSet& set : sets) refuse_much_work(set, options);
    FolderRules rules(arguments.depfile);
    for (std::size_t i = 0; i < sets.size(); ++i)
        rules.add(sets[i].folder / captions_name, files_of(sets[i], arguments.scenes[i]));
    for (const FigureSet& set : sets)
        std::ranges::for_each(outputs_of(set, options), Output::refuse_used);
    try {
        for (const FigureSet& set : sets) {
            const SetReport report = make_figures(set, options);
            warn(set, report);
            if (!arguments.quiet) print_report(set, report);
        }
        rules.commit();
    } catch (const Interrupted&) {
        throw Interrupted(finished);
    } catch (const TemporaryError& error) {
        throw TemporaryError(fmt::format("{}; {}", error.what(), finished));
    } catch (const SystemError& error) {
        throw SystemError(fmt::format("{}; {}", error.what(), finished));
    }
}

// The figure that `carom figure` draws. The scene need not list it.
struct FigureAsked {
    std::string kind;
    std::optional<double> at;
    std::string over, theme, width;
    std::vector<std::string> of;
};

std::string as_width(const std::string& width) {
    const bool is_number =
        !width.empty() && width.find_first_not_of("0123456789.") == std::string::npos;
    if (!is_number && !parse_length(width, LengthUnit::cm))
        throw UsageError(
            fmt::format("--width {}: expected a width in centimetres, for instance 8cm, or in mm, "
                        "in, pt or px",
                        printable(width)));
    return width;
}

// A text as YAML, whatever its letters.
std::string single_quoted(const std::string& text) {
    std::string quoted;
    for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
    return "'" + quoted + "'";
}

// One or several choices of particles, as the scene writes them.
std::string as_choices(const std::vector<std::string>& of) {
    std::vector<std::string> choices;
    for (const std::string& one : of) {
        const bool is_number =
            !one.empty() && one.find_first_not_of("0123456789") == std::string::npos;
        choices.push_back(is_number ? one : single_quoted(one));
    }
    return choices.size() == 1 ? choices.front() : fmt::format("[{}]", fmt::join(choices, ", "));
}

// A word, a window or an interval, as the scene writes it.
std::string as_times(const std::string& over) {
    const auto has_only = [&](const char* letters) {
        return over.find_first_not_of(letters) == std::string::npos;
    };
    if (has_only("abcdefghijklmnopqrstuvwxyz")) return over;
    const auto commas = std::ranges::count(over, ',');
    if (!has_only("0123456789.e+-,") || commas > 1)
        throw UsageError(
            fmt::format("--over {}: expected now, start, a window of time such as 5, "
                        "or an interval such as 6,12",
                        printable(over)));
    return commas == 0 ? "{window: " + over + "}" : "[" + over + "]";
}

void check_kind(const std::string& kind) {
    if (kind.empty())
        throw UsageError("carom figure needs the kind of the figure: --kind gas, for instance");
    if (kind.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos) return;
    std::vector<std::string> names;
    for (const PanelKind& one : panel_kinds()) names.push_back(one.name);
    const auto near = nearest_spelling(kind, names);
    throw UsageError(fmt::format("--kind {}: expected a name such as {}", printable(kind),
                                 near ? *near : names.front()));
}

// A key of the figure, and the option by which it was given.
struct AskedKey {
    std::string key, flag, typed, value;
};

std::vector<AskedKey> keys_of(const FigureAsked& asked) {
    check_kind(asked.kind);
    std::vector<AskedKey> keys{{"name", "--kind", asked.kind, asked.kind},
                               {"kind", "--kind", asked.kind, asked.kind}};
    if (asked.at) {
        const std::string time = fmt::format("{}", *asked.at);
        keys.push_back({"at", "--at", time, time});
    }
    if (!asked.over.empty()) keys.push_back({"over", "--over", asked.over, as_times(asked.over)});
    if (!asked.of.empty())
        keys.push_back(
            {"of", "--of", fmt::format("{}", fmt::join(asked.of, ",")), as_choices(asked.of)});
    if (!asked.theme.empty()) keys.push_back({"theme", "--theme", asked.theme, asked.theme});
    if (!asked.width.empty())
        keys.push_back({"size", "--width", asked.width, as_width(asked.width)});
    return keys;
}

// All keys as one override of the scene, and the column (from 1) at which each value begins in its
// text.
std::pair<std::string, std::vector<int>> change_by(const std::vector<AskedKey>& keys) {
    std::string change = "figures=[{";
    std::vector<int> places;
    for (const AskedKey& one : keys) {
        if (!places.empty()) change += ", ";
        change += one.key + ": ";
        places.push_back(static_cast<int>(text_of_change(change).size()) + 1);
        change += one.value;
    }
    return {change + "}]", places};
}

// Makes errors in the figure that was asked for quote the option as it was typed. If the name is
// wrong, the reason is the kind.
SceneError at_options(const SceneError& error, const std::vector<AskedKey>& keys) {
    const auto [change, places] = change_by(keys);
    std::vector<Diagnostic> all;
    for (Diagnostic one : error.diagnostics()) {
        const SourceSpan span = one.span;
        if (span.file != text_of_change(change)) {
            all.push_back(one);
            continue;
        }
        if (span.column == places[0] && error.diagnostics().size() > 1) continue;
        std::size_t at = 0;
        while (at + 1 < places.size() && places[at + 1] <= span.column) ++at;
        const bool is_of_all = span.column < places[0];
        if (is_of_all && !one.hint.empty())
            one.hint += "; `carom figures` draws what a scene lists under `figures`";
        show_at_option(one, keys[at].flag, keys[at].typed);
        all.push_back(one);
    }
    return SceneError(std::move(all));
}

void make_one(FiguresArguments arguments, const FigureAsked& asked) {
    const std::vector<AskedKey> keys = keys_of(asked);
    arguments.shortcuts.push_back(change_by(keys).first);
    if (arguments.output.empty())
        arguments.output = (fs::path("out") /
                            fmt::format("{}-{}", scene_stem(arguments.scenes.front()), asked.kind))
                               .string();
    try {
        make_all(arguments);
    } catch (const SceneError& error) {
        throw at_options(error, keys);
    }
}

Option formats_option(FiguresArguments& arguments) {
    return {"--formats FORMAT,...",
            fmt::format("{}; several separated by commas", fmt::join(figure_formats(), ", ")),
            CommaSeparated{&arguments.formats}, figure_formats()};
}

std::vector<Option> drawing_options(FiguresArguments& arguments) {
    return joined<Option>({scene_options(arguments),
                           {style_option(arguments),
                            language_option(arguments),
                            {"--threads N", "cores to use; the result is the same for any number",
                             &arguments.threads}}});
}

CommandText figures_text() {
    return {{"carom figures SCENE|SET... [options]"},
            "Draws the figures that a scene lists under `figures`, or those of all scenes of a "
            "figure set, with their data as CSV and a caption for each. A figure is made again "
            "only when it has changed.",
            {{"carom figures scenes/sets/collisions.yaml",
              "writes the figures of the set into out/collisions"},
             {"carom figures scenes/sets/collisions.yaml --page html --formats svg,csv",
              "a page that shows the figures"},
             {"carom figures scenes/sets/collisions.yaml -o book --force",
              "draws all again, into another folder"}}};
}

CommandText figure_text() {
    return {
        {"carom figure SCENE --kind KIND [options]"},
        "Draws one figure, whether or not the scene lists it, as SVG, PDF and PNG with its data as "
        "CSV.",
        {{"carom figure scenes/one-hot-particle.yaml --kind gas --at 5 --width 8cm",
          "writes out/one-hot-particle-gas/gas.svg and others"},
         {"carom figure scenes/one-hot-particle.yaml --kind speed-histogram --formats pdf",
          "only the PDF, for LaTeX"},
         {"carom figure scenes/mixed-masses.yaml --kind energy-by-species -o lecture --language de",
          "in German, into another folder"}}};
}

}  // namespace

Command figure_command() {
    struct Arguments : FiguresArguments {
        std::string scene;
        FigureAsked asked;
    };
    const auto arguments = std::make_shared<Arguments>();
    Arguments& its = *arguments;
    return {"figure", "draw one figure, whether or not the scene lists it",
            joined<Option>(
                {{{"scene", "a scene file, or - for standard input", &its.scene},
                  {"--kind KIND", "the kind of the figure: gas, speed-histogram, pressure, ...",
                   &its.asked.kind},
                  {"--at T", "the time that it shows; default: the end of the run", &its.asked.at},
                  {"--over TIME",
                   "the time over which values are taken: now, start, a window such as 5, or an "
                   "interval such as 6,12",
                   &its.asked.over},
                  {"--of PARTICLES",
                   "the particles that it shows: all, a species, a number; several separated by "
                   "commas",
                   CommaSeparated{&its.asked.of}},
                  {"--theme",
                   "colours; default: the style's, or light",
                   &its.asked.theme,
                   {"light", "dark", "print"}},
                  {"--width WIDTH", "its width in centimetres, or with its unit: 8cm, 80mm, 3.2in",
                   &its.asked.width},
                  {"-o,--output FOLDER", "output folder; default: out/SCENE-KIND", &its.output},
                  formats_option(its),
                  {"--force", "draw it again, and replace files that carom did not write",
                   &its.options.force},
                  depfile_option(its.depfile)},
                 {limits_option(its.is_classroom)},
                 drawing_options(its)}),
            [arguments] {
                arguments->scenes = {arguments->scene};
                make_one(*arguments, arguments->asked);
            },
            figure_text()};
}

Command figures_command() {
    const auto arguments = std::make_shared<FiguresArguments>();
    FiguresArguments& its = *arguments;
    return {
        "figures", "draw the figures of scenes and figure sets",
        joined<Option>(
            {{{"scenes", "scene files and figure sets; - for a scene from standard input",
               &its.scenes},
              {"-o,--output FOLDER",
               "output folder, with a subfolder for each of several scenes; default: out/SCENE",
               &its.output},
              formats_option(its),
              {"--only NAME,...", "only the figures with these names, separated by commas",
               CommaSeparated{&its.options.only}},
              {"--force", "draw all again, and replace files that carom did not write",
               &its.options.force},
              depfile_option(its.depfile),
              {"--page PAGE,...",
               "write a page with the figures: markdown, html, latex, or a template of your own "
               "(.md, .html, .tex); several separated by commas",
               CommaSeparated{&its.pages}},
              {"--films", "also render the films of the scenes, which pages then show",
               &its.options.films}},
             {limits_option(its.is_classroom)},
             drawing_options(its)}),
        [arguments] { make_all(*arguments); }, figures_text()};
}

}  // namespace carom
