// carom figures: the figures of scenes.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/command.h"
#include "app/letters.h"
#include "app/resources.h"
#include "app/simulate.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct FiguresArguments : SceneOptions {
    std::vector<std::string> scenes;
    std::string output;
    std::vector<std::string> formats = {"svg", "pdf", "png"};
};

void write_figure(const FigureRun& run, const Figure& figure, FigureFormat format,
                  const fs::path& folder) {
    const FigureWords words = words_of(run, figure);
    Canvas canvas = draw_figure(run, figure, format, {run.scene().title, words.alt});
    AtomicFile file(folder / (figure.spec->name + "." + name_of(format)));
    file.write(canvas.file());
    file.commit();
}

void write_table(const Figure& figure, const fs::path& folder) {
    const Table table = table_of(figure);
    if (table.columns.empty()) return;  // words
    AtomicFile file(folder / (figure.spec->name + ".csv"));
    file.write(csv(table));
    file.commit();
}

void make_figures(const FiguresArguments& arguments, const std::string& name) {
    const Scene scene = load_scene(name, templates_folder(), overrides_of(arguments));
    require_letters(scene);
    if (scene.figures.empty())
        throw UsageError(fmt::format("{}: the scene lists no `figures`", scene.source.path));
    const fs::path folder =
        arguments.output.empty() ? fs::path("out") / scene_stem(name) : fs::path(arguments.output);
    const FigureRun run(scene, [&] { return simulate(scene); });
    for (const Figure& figure : run.figures()) {
        for (const FigureFormat format : {FigureFormat::svg, FigureFormat::pdf, FigureFormat::png})
            if (std::ranges::find(arguments.formats, name_of(format)) != arguments.formats.end())
                write_figure(run, figure, format, folder);
        write_table(figure, folder);
    }
    if (!arguments.quiet) fmt::print("{}: {} figures\n", folder.string(), run.figures().size());
}

}  // namespace

void add_figures(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("figures", "draw the figures of scenes");
    const auto arguments = std::make_shared<FiguresArguments>();
    command.add_option("scenes", arguments->scenes, "scene files")->required();
    command.add_option("-o,--output", arguments->output, "a folder; out/SCENE if not given");
    command.add_option("--formats", arguments->formats, "svg, pdf, png, with commas between them")
        ->delimiter(',')
        ->check(CLI::IsMember({"svg", "pdf", "png"}));
    add_scene_options(command, *arguments);
    command.callback([arguments] {
        for (const std::string& scene : arguments->scenes) make_figures(*arguments, scene);
    });
}

}  // namespace carom
