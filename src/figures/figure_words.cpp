#include "figures/figure_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "util/text.h"

namespace carom {
namespace {

std::string sentence(const std::string& words) {
    const bool ends = words.ends_with('.') || words.ends_with('!') || words.ends_with('?');
    return ends ? words : words + ".";
}

std::string kind_words(const Scene& scene, const FigureSpec& spec) {
    if (spec.panel.title) return *spec.panel.title;
    if (spec.panel.kind == "gas")
        return scene.gas.box.dimension == 2 ? "The gas" : "The beads on their wire";
    std::string words = spec.panel.kind;
    std::ranges::replace(words, '-', ' ');
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    return words;
}

std::string time_words(const Figure& figure) {
    std::vector<std::string> times;
    for (const FigureMoment& moment : figure.moments) times.push_back(plain_number(moment.time));
    const auto& over = figure.spec->panel.over;
    if (over && over->since == Over::Since::window)
        return fmt::format("from time {} to {}",
                           plain_number(figure.moments.back().time - over->window), times.back());
    return fmt::format("at {} {}", times.size() > 1 ? "times" : "time", listed(times));
}

std::string made_caption(const Scene& scene, const Figure& figure, Eigen::Index particles) {
    const char* things = scene.gas.box.dimension == 2 ? "disks" : "beads";
    if (figure.spec->panel.seeds > 1)
        return fmt::format(
            "{} {} {}: mean of {} independent runs of {} {} each, with its standard error; reduced "
            "units.",
            sentence(scene.title), kind_words(scene, *figure.spec), time_words(figure),
            figure.spec->panel.seeds, grouped(particles), things);
    const std::int64_t collisions = figure.moments.back().collisions.particle;
    return fmt::format("{} {} {}: {} {}, {} {} between them so far; reduced units.",
                       sentence(scene.title), kind_words(scene, *figure.spec), time_words(figure),
                       grouped(particles), things, grouped(collisions),
                       collisions == 1 ? "collision" : "collisions");
}

}  // namespace

FigureWords words_of(const FigureRun& run, const Figure& figure) {
    const Scene& scene = run.scene();
    FigureWords words;
    words.caption =
        figure.spec->caption.value_or(made_caption(scene, figure, run.particles().count()));
    const std::string finding = figure.panel->finding(*figure.moments.back().state);
    if (!finding.empty()) words.caption += " " + finding;
    words.alt = figure.spec->alt.value_or(fmt::format("{} {}. {}", kind_words(scene, *figure.spec),
                                                      time_words(figure), scene.description));
    return words;
}

}  // namespace carom
