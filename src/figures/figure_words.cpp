#include "figures/figure_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "util/formula/formula.h"
#include "util/text.h"

namespace carom {
namespace {

std::string kind_words(const Scene& scene, const FigureSpec& spec) {
    if (spec.panel.title) return *spec.panel.title;
    if (spec.panel.kind == "gas")
        return scene.gas.box.dimension == 2 ? "The gas" : "The beads on their wire";
    std::string words = spec.panel.kind;
    std::ranges::replace(words, '-', ' ');
    return capitalised(words);
}

std::string time_words(const FigureSpec& spec) {
    const bool over = spec.panel.over && spec.panel.over->since == Over::Since::window;
    return fmt::format("{} {}{}", over ? "from" : "at", spec.times.size() > 1 ? "times " : "time ",
                       shown_times(spec));
}

bool have_one_time(const Figure& figure) {
    return std::ranges::all_of(figure.sides, [&](const FigureSide& side) {
        return side.time == figure.sides.front().time;
    });
}

// The thin spaces of numbers as such where no line breaks.
std::string unbroken(std::string words) {
    const std::string thin = "\u2009", narrow = "\u202F";
    for (std::size_t at = words.find(thin); at != std::string::npos; at = words.find(thin, at))
        words.replace(at, thin.size(), narrow);
    return words;
}

// "Speed histogram at time 20 of 3 runs", "Entropy of 2 runs, each to its end".
std::string comparison_words(const Scene& scene, const Figure& figure) {
    const std::string kind = kind_words(scene, *figure.spec);
    const std::size_t runs = figure.sides.size();
    if (have_one_time(figure))
        return fmt::format("{} {} of {} runs", kind, time_words(*figure.spec), runs);
    return fmt::format("{} of {} runs, each at its end", kind, runs);
}

// "gas.0.radius=0.35" as "radius of disks: 0.35".
std::string words_of_value(const std::string& value, const Gas& gas) {
    const std::size_t sign = value.find('=');
    const std::string path = value.substr(0, sign), number = value.substr(sign + 1);
    const std::size_t dot = path.rfind('.');
    std::string words = dot == std::string::npos ? path : path.substr(dot + 1);
    std::ranges::replace(words, '_', ' ');
    for (std::size_t k = 0; k < gas.species.size(); ++k)
        if (gas.species.size() > 1 && path.starts_with(fmt::format("gas.{}.", k)))
            words += " of " + gas.species[k].name;
    return words + " " + number;
}

// How a run that is compared differs from the scene, or from the others by its scene; empty where
// its label says it.
std::string difference(const FigureSpec& spec, const ComparedRun& run) {
    std::vector<std::string> differences;
    const bool have_one_scene = std::ranges::all_of(spec.compare, [&](const ComparedRun& other) {
        return other.scene->source.path == run.scene->source.path;
    });
    if (!have_one_scene && run.label != run.scene->title)
        differences.push_back("“" + run.scene->title + "”");
    for (const std::string& value : run.values)
        if (run.label.find(value.substr(value.find('=') + 1)) == std::string::npos &&
            !value.starts_with("seed="))
            differences.push_back(words_of_value(value, run.scene->gas));
    return differences.empty() ? "" : fmt::format("{}; ", fmt::join(differences, ", "));
}

std::string caption_of_runs(const Scene& scene, const Figure& figure) {
    std::vector<std::string> runs;
    for (std::size_t k = 0; k < figure.sides.size(); ++k) {
        const FigureSide& side = figure.sides[k];
        const Scene& its = *figure.spec->compare[k].scene;
        std::string words =
            fmt::format("{} ({}{}, {} between them, {}", side.label,
                        difference(*figure.spec, figure.spec->compare[k]),
                        counted(side.particles, its.gas.box.dimension == 2 ? "disk" : "bead"),
                        counted(side.collisions.particle, "collision"), side.account);
        if (!have_one_time(figure)) words += " at time " + plain_number(side.time);
        runs.push_back(words + ")");
    }
    return fmt::format("{} {}: {}; reduced units.", sentence(scene.title),
                       comparison_words(scene, figure), listed(runs));
}

std::string alt_of_runs(const Scene& scene, const Figure& figure) {
    std::vector<std::string> runs;
    for (const FigureSide& side : figure.sides) runs.push_back(side.label + ", " + side.account);
    return fmt::format("{} in one panel: {}.", comparison_words(scene, figure),
                       fmt::join(runs, "; "));
}

std::string made_caption(const Scene& scene, const Figure& figure, Eigen::Index particles) {
    if (!figure.sides.empty()) return caption_of_runs(scene, figure);
    const char* things = scene.gas.box.dimension == 2 ? "disks" : "beads";
    const std::string account = figure.panel->account(*figure.moments.back().state);
    if (figure.spec->panel.seeds > 1)
        return fmt::format(
            "{} {} {}: mean of {} independent runs of {} {} each, with its standard error; reduced "
            "units.{}{}",
            sentence(scene.title), kind_words(scene, *figure.spec), time_words(*figure.spec),
            figure.spec->panel.seeds, grouped(particles), things, account.empty() ? "" : " ",
            account);
    if (!account.empty())
        return fmt::format("{} {} {}", sentence(scene.title),
                           sentence(kind_words(scene, *figure.spec)), account);
    const std::int64_t collisions = figure.moments.back().collisions.particle;
    return fmt::format("{} {} {}: {} {}, {} {} between them by then; reduced units.",
                       sentence(scene.title), kind_words(scene, *figure.spec),
                       time_words(*figure.spec), grouped(particles), things, grouped(collisions),
                       collisions == 1 ? "collision" : "collisions");
}

std::string account_of(const Figure& figure) {
    return figure.panel->account(*figure.moments.back().state);
}

// What the scene shows is said once: with the first of its figures that says nothing itself.
std::string made_alt(const FigureRun& run, const Figure& figure) {
    const Scene& scene = run.scene();
    const std::string account = account_of(figure);
    const std::string kind = kind_words(scene, *figure.spec);
    if (figure.spec->panel.given) return fmt::format("{} {}", sentence(kind), account);
    const std::string what = fmt::format("{} {}", kind, time_words(*figure.spec));
    if (!account.empty()) return what + ". " + account;
    const auto first = std::ranges::find_if(run.figures(), [](const Figure& one) {
        return one.sides.empty() && account_of(one).empty();
    });
    if (&*first == &figure) return what + ". " + scene.description;
    return fmt::format("{} of “{}”, after {}.", what, scene.title,
                       counted(figure.moments.back().collisions.particle, "collision"));
}

}  // namespace

std::string shown_times(const FigureSpec& spec) {
    const auto& over = spec.panel.over;
    if (over && over->since == Over::Since::window)
        return fmt::format("{} to {}", plain_number(spec.times.back() - over->window),
                           plain_number(spec.times.back()));
    std::vector<std::string> times;
    for (const double time : spec.times) times.push_back(plain_number(time));
    return listed(times);
}

FigureWords words_of(const FigureRun& run, const Figure& figure) {
    const Scene& scene = run.scene();
    FigureWords words;
    const auto plain = [](const std::string& made) { return formula::without_formulas(made); };
    words.caption = figure.spec->caption.value_or(
        plain(unbroken(made_caption(scene, figure, run.particles().count()))));
    const std::string finding = figure.panel->finding(*figure.moments.back().state);
    if (!finding.empty()) words.caption += " " + plain(finding);
    const bool compares = !figure.sides.empty();
    if (figure.spec->alt)
        words.alt = formula::spoken_text(*figure.spec->alt);
    else
        words.alt = compares ? alt_of_runs(scene, figure) : made_alt(run, figure);
    return words;
}

}  // namespace carom
