#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "figures/figure_drawing.h"
#include "films/cost/work_parts.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

// A run whose figures are drawn: how often it is done, and with which panels.
struct FigureRuns {
    const Scene* scene;
    std::vector<SeeingPanel> panels;
    RunCounts counts;
    double times = 1.0;
};

// The figure, where its run is done; it is read at its own times only.
SeeingPanel seeing(const FigureSpec& figure, const PanelSpec& panel) {
    return {fmt::format("the figure `{}`", figure.name), panel,
            static_cast<double>(std::max<std::size_t>(1, figure.times.size()))};
}

// Adds the runs of a figure that compares others.
void add_compared(const FigureSpec& figure, std::vector<FigureRuns>& runs) {
    for (const ComparedRun& run : figure.compare)
        runs.push_back({run.scene.get(),
                        {seeing(figure, run.scene->figures.front().panel)},
                        counts_of(*run.scene)});
}

// The moments of a run that its figures see: the samples of those that measure, and the frames of
// those that are drawn as in a film.
double moments_seen(const FigureRuns& runs) {
    const auto is_drawn = [](const SeeingPanel& one) { return kind_of(one.panel).draws_particles; };
    const bool draws = std::ranges::any_of(runs.panels, is_drawn);
    const bool measures = !std::ranges::all_of(runs.panels, is_drawn);
    return (draws ? frame_count(runs.scene->film) : 0.0) +
           (measures ? samples_of(runs.scene->run) : 0.0);
}

double points_drawn(const Scene& scene, const FigureSpec& figure) {
    return kind_of(figure.panel).draws_box
               ? count_of(scene) * static_cast<double>(figure.times.size())
               : 0.0;
}

// A figure as files: pictures and a table.
struct DrawnFigure {
    double seconds = 0.0, bytes = 0.0;
};
DrawnFigure drawn(const Scene& scene, const FigureSpec& figure, std::string_view format) {
    constexpr double of_figure = 0.006, of_disk = 8e-6, of_pdf_disk = 14e-6, of_png_disk = 5e-6;
    constexpr double of_vector_disk = 110.0, of_vector = 80e3, of_pixel = 0.3;  // bytes
    constexpr double of_many_pixels = 20e-9;                                    // seconds
    constexpr double pixels_per_cm = 300.0 / 2.54;
    const double disks = points_drawn(scene, figure);
    if (format == "csv") return {2.5e-6 * disks, 60.0 * disks + 20e3};
    if (format == "svg") return {of_figure + of_disk * disks, of_vector + of_vector_disk * disks};
    if (format == "pdf")
        return {of_figure + of_pdf_disk * disks, of_vector + of_vector_disk * disks};
    const auto [width, height] = figure_size(scene, figure);
    const double pixels = width * height * pixels_per_cm * pixels_per_cm;
    return {of_figure + of_png_disk * disks + of_many_pixels * pixels, of_pixel * pixels};
}

WorkPart drawing_part(const Scene& scene, const FigureSpec& figure,
                      std::span<const std::string> formats, double& bytes) {
    WorkPart part{.what = fmt::format("drawing the figure `{}`", figure.name),
                  .reduce = "`figures` or `--formats`",
                  .place = figure.panel.place};
    for (const std::string& format : formats) {
        const DrawnFigure one = drawn(scene, figure, format);
        part.seconds += one.seconds;
        bytes += one.bytes;
    }
    return part;
}

// The runs of a scene's own seeds, which all of its figures share, and those of the others.
std::vector<FigureRuns> runs_of(const Scene& scene, const std::vector<const FigureSpec*>& figures,
                                const RunCounts& counts) {
    std::map<int, std::vector<SeeingPanel>> by_seeds;  // of figures that show so many seeds
    std::vector<FigureRuns> runs;
    for (const FigureSpec* figure : figures) {
        if (!figure->compare.empty())
            add_compared(*figure, runs);
        else if (sweep_of(*figure) == nullptr)
            by_seeds[figure->panel.seeds].push_back(seeing(*figure, figure->panel));
    }
    double seeds = 0.0;
    std::vector<SeeingPanel> panels;
    for (const auto& [count, of_count] : by_seeds)
        panels.insert(panels.end(), of_count.begin(), of_count.end());
    for (const auto& [count, of_count] : by_seeds) {
        runs.push_back({&scene, panels, counts, count - seeds});
        seeds = count;
        panels.erase(panels.begin(), panels.begin() + std::ssize(of_count));
    }
    return runs;
}

}  // namespace

Work work_of_figures(const Scene& scene, std::span<const std::string> names,
                     std::span<const std::string> formats, const RunCounts& counts) {
    std::vector<const FigureSpec*> figures;
    for (const FigureSpec& figure : scene.figures)
        if (names.empty() || std::ranges::find(names, figure.name) != names.end())
            figures.push_back(&figure);
    Work work{.memory = bytes_of_program + static_cast<double>(Recording::most_bytes),
              .reduces_memory = "the particles, or the `seeds` of a figure",
              .reduces_bytes = "`figures` or the particles"};
    for (const FigureRuns& runs : runs_of(scene, figures, counts)) {
        const double frames = moments_seen(runs);
        const bool is_kept =
            Recording::fits(static_cast<std::size_t>(frames), total_count(runs.scene->gas),
                            runs.scene->gas.box.dimension);
        work.parts.push_back(
            simulation_part(*runs.scene, runs.counts, runs.times * (is_kept ? 1.0 : 2.0)));
        std::ranges::move(panel_parts(*runs.scene, runs.panels, frames, runs.counts, runs.times),
                          std::back_inserter(work.parts));
        work.memory += runs.times * count_of(*runs.scene) * bytes_of_particle;
    }
    for (const FigureSpec* figure : figures) {
        work.parts.push_back(drawing_part(scene, *figure, formats, work.bytes));
        if (!runs_sweep(*figure)) continue;
        const SweepShown& shown = *sweep_of(*figure);
        const Work runs = work_of_sweep(shown.sweep, [&](std::int64_t point) {
            return shown.scene_with(shown.sweep.changes_at(point));
        });
        work = together(work, runs);
        work.parts.back().place = figure->panel.place;
    }
    return work;
}

}  // namespace carom
