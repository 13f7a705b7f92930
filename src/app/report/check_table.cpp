#include "app/report/check_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/progress.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "util/text.h"

namespace carom {
namespace {

std::string row(const char* name, const std::string& words) {
    return fmt::format("  {:<12} {}\n", name, words);
}

// Two digits: it is an estimate.
std::string about(double value) {
    if (value >= 1e15) return three_digits(value);
    if (value < 0.01) return value > 0.0 ? "less than 0.01" : "0";
    if (value < 10.0) return fmt::format("{:.2g}", value);
    const double digits = std::floor(std::log10(std::max(1.0, value))) - 1.0;
    const double unit = std::pow(10.0, std::max(0.0, digits));
    return grouped(static_cast<long long>(unit * std::round(value / unit)));
}

std::string walls(const Box& box) {
    const bool across = box.walls[0] == Wall::periodic;
    if (box.dimension == 1) return across ? "ends joined" : "between walls";
    const bool up = box.walls[1] == Wall::periodic;
    if (across == up) return across ? "periodic" : "solid walls";
    return across ? "periodic across, solid below and above"
                  : "periodic up and down, solid left and right";
}

std::string box(const Box& box) {
    if (box.dimension == 1)
        return fmt::format("one dimension, length {}, {}", box.size[0], walls(box));
    return fmt::format("two dimensions, {} by {}, {}", box.size[0], box.size[1], walls(box));
}

std::string species(const Gas& gas, std::int64_t particles) {
    constexpr std::size_t most_shown = 8;
    std::vector<std::string> words;
    for (const Species& one : gas.species) {
        if (words.size() == most_shown) {
            words.push_back(fmt::format("{} more", gas.species.size() - most_shown));
            break;
        }
        words.push_back(fmt::format("{} {}", grouped(one.count), one.name));
    }
    std::string text = fmt::format("{}", fmt::join(words, ", "));
    if (gas.species.size() > 1) text += fmt::format("; {} in all", grouped(particles));
    return text;
}

std::string packing(const Scene& scene, const SceneFacts& facts) {
    return fmt::format("{:.4g} of the {}", facts.packing_fraction,
                       scene.gas.box.dimension == 1 ? "length" : "area");
}

std::string collisions(const SceneFacts& facts) {
    if (!facts.collisions) return "no estimate: the gas has no equilibrium that theory knows";
    const double of_each = 2.0 * *facts.collisions / static_cast<double>(facts.particles);
    return fmt::format("{} between particles, {} for each (kinetic theory, in equilibrium)",
                       (*facts.collisions < 0.01 ? "" : "about ") + about(*facts.collisions),
                       about(of_each));
}

std::string run(const Run& run) {
    std::string text = fmt::format("time 0 to {}", run.until);
    if (run.equilibrate > 0.0) text += fmt::format(", after {} not shown", run.equilibrate);
    if (!run.events.empty())
        text +=
            fmt::format(", {} {}", run.events.size(), run.events.size() == 1 ? "event" : "events");
    return text;
}

std::string film(const Film& film, const SceneFacts& facts) {
    if (facts.costs.empty()) return "none: for `carom run` only";
    return fmt::format("{} frames, {} at {} a second, {} by {}, template {}", grouped(facts.frames),
                       clock_text(film.seconds), film.fps, film.size.width, film.size.height,
                       film.template_name);
}

std::string costs(const std::vector<FilmCost>& costs) {
    std::vector<std::string> words;
    for (const FilmCost& cost : costs)
        words.push_back(fmt::format("{} {}, {} MB", cost.format,
                                    cost.seconds < 1.0 ? "0:01" : clock_text(cost.seconds),
                                    about(1e-6 * cost.bytes)));
    const int cores = costs.front().cores;
    return fmt::format("{} (on {} {}, quality standard; half or twice as much is possible)",
                       fmt::join(words, "; "), cores, cores == 1 ? "core" : "cores");
}

// "speeds, a speed-histogram at time 4, 8.9 by 6.2 cm".
std::string figure(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    const bool over = spec.panel.over && spec.panel.over->since == Over::Since::window;
    const std::string kind =
        spec.compare.empty() ? spec.panel.kind
                             : fmt::format("{} of {} runs", spec.panel.kind, spec.compare.size());
    return fmt::format("{}: {} {} time {}, {:.3g} by {:.3g} cm", spec.name, kind,
                       over ? "over" : "at", shown_times(spec), width, height);
}

std::string table_of_set(const CheckedScene& checked) {
    const FigureSet& set = *checked.set;
    std::string text = fmt::format("{}: valid\n", checked.path) + row("title", set.title);
    std::size_t figures = 0;
    for (const SetPart& part : set.parts) {
        figures += part.figures.size();
        if (part.compares) continue;
        text += row("scene", part.stem);
        for (const std::string& name : part.figures)
            text += row("", figure(part.scene, *figure_spec(part.scene, name)));
    }
    for (const SetPart& part : set.parts)
        if (part.compares) {
            std::vector<std::string> labels;
            const FigureSpec& spec = part.scene.figures.front();
            for (const ComparedRun& run : spec.compare) labels.push_back(run.label);
            text += row("comparison", figure(part.scene, spec)) + row("", listed(labels));
        }
    text += row("figures", fmt::format("{}, each as {}", figures, listed(set.formats)));
    std::vector<std::string> pages;
    for (const PageTemplate& page : set.pages) pages.push_back(set.stem + page.ending);
    return text + row("pages", listed(pages));
}

std::string table(const CheckedScene& checked) {
    if (checked.set) return table_of_set(checked);
    if (!checked.scene)
        return fmt::format("{}: not valid, {} {}\n", checked.path, checked.errors.size(),
                           checked.errors.size() == 1 ? "error" : "errors");
    const Scene& scene = *checked.scene;
    const SceneFacts& facts = checked.facts;
    std::string text = fmt::format("{}: valid\n", checked.path);
    text += row("title", scene.title) + row("box", box(scene.gas.box)) +
            row("species", species(scene.gas, facts.particles)) +
            row("packing", packing(scene, facts)) + row("run", run(scene.run)) +
            row("collisions", collisions(facts)) + row("film", film(scene.film, facts));
    if (!facts.costs.empty()) text += row("rough cost", costs(facts.costs));
    return text;
}

}  // namespace

std::string check_table(std::span<const CheckedScene> scenes) {
    std::string text;
    for (const CheckedScene& checked : scenes) {
        if (!text.empty() && checked.is_valid()) text += "\n";
        text += table(checked);
    }
    return text;
}

}  // namespace carom
