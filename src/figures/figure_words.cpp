#include "figures/figure_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "figures/figure_run.h"
#include "panels/correlations/curve_panel.h"
#include "panels/plot/window.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "panels/words/word_numbers.h"
#include "scene/describe.h"
#include "scene/panel_kind.h"
#include "scene/yaml/scalar.h"
#include "util/formula/formula.h"
#include "util/text.h"

namespace carom {
namespace {

// "Speed histogram", "Speed histogram (left, right)", "The gas": how a caption names what it shows.
std::string kind_words(const Scene& scene, const Figure& figure) {
    const Language language = scene.film.language;
    const PanelSpec& panel = figure.spec->panel;
    if (kind_of(panel).draws_box && !panel.title)
        return scene.gas.box.dimension == 1 ? say(language, "The beads on their wire")
                                            : say(language, "The gas");
    const std::string words = capitalised(name_of_panel(scene, panel));
    const std::vector<std::string> parts = figure.panel->parts();
    if (panel.title || parts.empty()) return words;
    return fmt::format("{} ({})", words, fmt::join(parts, ", "));
}

ShownTimes times_of(const Figure& figure) {
    const FigureSpec& spec = *figure.spec;
    const auto measured = figure.panel->time_shown(spec.times.back());
    if (!measured) return times_of(spec);
    const auto [from, until] = *measured;
    if (from == until) return {.times = {until}, .are_of_collisions = until != spec.times.back()};
    return {spec.times, measured};
}

// "Speed histogram at time 20", "Free path from time 6 to 12".
std::string kind_and_time(const Scene& scene, const Figure& figure) {
    const Wording language = wording_of(scene);
    const std::string kind = kind_words(scene, figure);
    const ShownTimes shown = times_of(figure);
    const std::string times = words_of(language, shown);
    if (shown.over) return say(language, "{} from time {}", kind, times);
    return shown.times.size() > 1 ? say(language, "{} at times {}", kind, times)
                                  : say(language, "{} at time {}", kind, times);
}

bool have_one_time(const Figure& figure) {
    return std::ranges::all_of(figure.sides, [&](const FigureSide& side) {
        return side.time == figure.sides.front().time;
    });
}

// Replaces the thin spaces in numbers by spaces at which no line breaks.
std::string unbroken(std::string words) {
    const std::string thin = "\u2009", narrow = "\u202F";
    for (std::size_t at = words.find(thin); at != std::string::npos; at = words.find(thin, at))
        words.replace(at, thin.size(), narrow);
    return words;
}

// "Speed histogram at time 20 of 3 runs", "Entropy of 2 runs, each at its end".
std::string comparison_words(const Scene& scene, const Figure& figure) {
    const Language language = scene.film.language;
    const std::size_t runs = figure.sides.size();
    if (have_one_time(figure))
        return say(language, "{} of {} runs", kind_and_time(scene, figure), runs);
    return say(language, "{} of {} runs, each at its end", kind_words(scene, figure), runs);
}

std::string collisions_counted(Language language, long long count) {
    return counted(language, count, Phrase{"{} collision between them"},
                   Phrase{"{} collisions between them"});
}

// Whether words have a number, or a word, of this text: "10 of b" has no 1.
bool have_word(std::string_view words, std::string_view text) {
    const auto goes_on = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
    };
    for (std::size_t at = words.find(text); at != std::string_view::npos && !text.empty();
         at = words.find(text, at + 1)) {
        const std::size_t end = at + text.size();
        const bool begins = at == 0 || !goes_on(words[at - 1]);
        if (begins && (end == words.size() || !goes_on(words[end]))) return true;
    }
    return false;
}

// How a compared run differs from the scene, or from the other runs if it is of another scene;
// empty if its label says it.
std::string difference(Language language, const FigureSpec& spec, const ComparedRun& run) {
    std::vector<std::string> differences;
    const bool have_one_scene = std::ranges::all_of(spec.compare, [&](const ComparedRun& other) {
        return other.scene->source.path == run.scene->source.path;
    });
    if (!have_one_scene && run.label != run.scene->title)
        differences.push_back(say(language, "“{}”", run.scene->title));
    for (const std::string& change : run.values) {
        const std::size_t sign = change.find('=');
        const std::string key = change.substr(0, sign), value = change.substr(sign + 1);
        if (key != "seed" && !have_word(run.label, value))
            differences.push_back(words_of_value(language, key, value, run.scene->gas));
    }
    return differences.empty() ? "" : fmt::format("{}; ", fmt::join(differences, ", "));
}

std::string caption_of_runs(const Scene& scene, const Figure& figure) {
    const Language language = scene.film.language;
    std::vector<std::string> runs;
    for (std::size_t k = 0; k < figure.sides.size(); ++k) {
        const FigureSide& side = figure.sides[k];
        const Scene& its = *figure.spec->compare[k].scene;
        std::vector<std::string> facts{
            particles_counted(language, side.particles, its.gas.box.dimension),
            collisions_counted(language, side.collisions.particle), side.account};
        if (!have_one_time(figure))
            facts.push_back(say(language, "at time {}",
                                plain_number(wording_of(scene), quantities::time, side.time)));
        runs.push_back(fmt::format("{} ({}{})", side.label,
                                   difference(language, *figure.spec, figure.spec->compare[k]),
                                   fmt::join(facts, ", ")));
    }
    return fmt::format(
        "{} {}", sentence(scene.title),
        scene.units == UnitSystem::real
            ? say(language, "{}: {}.", comparison_words(scene, figure), listed(language, runs))
            : say(language, "{}: {}; reduced units.", comparison_words(scene, figure),
                  listed(language, runs)));
}

std::string alt_of_runs(const Scene& scene, const Figure& figure) {
    const Language language = scene.film.language;
    std::vector<std::string> runs;
    for (const FigureSide& side : figure.sides) runs.push_back(side.label + ", " + side.account);
    return say(language, "{} in one panel: {}.", comparison_words(scene, figure),
               fmt::format("{}", fmt::join(runs, "; ")));
}

// Whether the account of a panel is a result of the run so far, without its time and its numbers.
bool is_result_of_run(const Panel& panel) {
    return dynamic_cast<const SeriesPanel*>(&panel) != nullptr ||
           dynamic_cast<const CurvePanel*>(&panel) != nullptr ||
           dynamic_cast<const HistogramPanel*>(&panel) != nullptr;
}

// What the panel says of itself: of several moments, if it says the same of all.
std::string account_of(const Figure& figure) {
    const std::string account = figure.panel->account(*figure.moments.back().state);
    const bool holds_of_all = std::ranges::all_of(figure.moments, [&](const FigureMoment& moment) {
        return figure.panel->account(*moment.state) == account;
    });
    return holds_of_all || is_result_of_run(*figure.panel) ? account : "";
}

std::string made_caption(const Scene& scene, const Figure& figure, Eigen::Index particles) {
    if (!figure.sides.empty()) return caption_of_runs(scene, figure);
    const Language language = scene.film.language;
    const std::string account = account_of(figure);
    const std::string count = particles_counted(language, particles, scene.gas.box.dimension);
    const std::string title = sentence(scene.title);
    const bool is_real = scene.units == UnitSystem::real;
    if (sweep_of(*figure.spec) != nullptr) return title + " " + account;
    if (figure.spec->panel.seeds > 1) {
        const std::string caption =
            is_real ? say(language,
                          "{}: mean of {} independent runs of {} each, with its standard error.",
                          kind_and_time(scene, figure), figure.spec->panel.seeds, count)
                    : say(language,
                          "{}: mean of {} independent runs of {} each, with its standard error; "
                          "reduced units.",
                          kind_and_time(scene, figure), figure.spec->panel.seeds, count);
        return fmt::format("{} {}{}{}", title, caption, account.empty() ? "" : " ", account);
    }
    if (!account.empty() && !is_result_of_run(*figure.panel))
        return fmt::format("{} {} {}", title, sentence(kind_words(scene, figure)), account);
    const std::string met = collisions_counted(language, figure.moments.back().collisions.particle);
    const std::string facts =
        is_real ? say(language, "{}: {}, {} by then.", kind_and_time(scene, figure), count, met)
                : say(language, "{}: {}, {} by then; reduced units.", kind_and_time(scene, figure),
                      count, met);
    return fmt::format("{} {}{}{}", title, facts, account.empty() ? "" : " ", account);
}

// The generated alternative text. The description of the scene is given only once, with its first
// figure that has no text of its own.
std::string made_alt(const FigureRun& run, const Figure& figure) {
    const Scene& scene = run.scene();
    const std::string account = account_of(figure);
    if (sweep_of(*figure.spec) != nullptr) return account;
    const std::string kind = kind_words(scene, figure);
    if (!figure.panel->is_of_run()) return fmt::format("{} {}", sentence(kind), account);
    const Language language = scene.film.language;
    const bool is_mean = figure.spec->panel.seeds > 1;
    std::string what = kind_and_time(scene, figure);
    if (is_mean)
        what = say(language, "{}, mean of {} independent runs", what, figure.spec->panel.seeds);
    // The numbers of a histogram or a series say nothing of its gas.
    const auto tells_gas = [](const Figure& one) {
        return dynamic_cast<const HistogramPanel*>(one.panel) != nullptr ||
               dynamic_cast<const SeriesPanel*>(one.panel) != nullptr || account_of(one).empty();
    };
    if (!tells_gas(figure)) return what + ". " + account;
    const auto first = std::ranges::find_if(
        run.figures(), [&](const Figure& one) { return one.sides.empty() && tells_gas(one); });
    if (&*first == &figure)
        return fmt::format("{}. {}{}{}", what, account, account.empty() ? "" : " ",
                           scene.description);
    if (!account.empty()) return what + ". " + account;
    if (is_mean) return say(language, "{} of “{}”.", what, scene.title);
    return say(language, "{} of “{}”, {}.", what, scene.title,
               counted(language, figure.moments.back().collisions.particle,
                       Phrase{"after {} collision"}, Phrase{"after {} collisions"}));
}

// What a figure shows itself, for its own words.
std::string own_number(const Figure& figure, const Wording& wording, const NumberInWords& number) {
    const std::vector<PanelNumber> all = figure.panel->scalars(*figure.moments.back().state);
    const auto found = std::ranges::find(all, number.name, &PanelNumber::name);
    if (found != all.end() && std::isfinite(found->value))
        return number_words(wording, number, found->quantity, found->value);
    std::vector<std::string> names;
    for (const PanelNumber& one : all) names.push_back(one.name);
    Diagnostic error = number.place;
    error.message =
        fmt::format("the figure `{}` {} `{{{}}}`", figure.spec->name,
                    found == all.end() ? "shows no number" : "has no value of", number.name);
    error.hint = names.empty() ? "leave it out" : "it shows " + listed(names, "and", "`");
    throw SceneError({std::move(error)});
}

// Words that the scene gives, with their numbers.
std::string with_numbers(const std::string& words, const FigureRun& run, const Figure& figure) {
    const Scene& scene = run.scene();
    return filled(words, [&](std::size_t k) {
        const NumberInWords& number = scene.numbers.at(k);
        return number.reader ? run.number_texts().at(k)
                             : own_number(figure, wording_of(scene), number);
    });
}

}  // namespace

ShownTimes times_of(const FigureSpec& spec) {
    const double at = spec.times.back();
    if (const auto& over = spec.panel.over)
        if (const auto start = start_of_mean(*over, at)) return {spec.times, {{*start, at}}};
    return {spec.times};
}

std::string words_of(const Wording& language, const ShownTimes& shown) {
    const auto number = [&](double time) {
        return shown.are_of_collisions ? three_digits(language, quantities::time, time)
                                       : plain_number(language, quantities::time, time);
    };
    if (shown.over)
        return say(language, "{} to {}", number((*shown.over)[0]), number((*shown.over)[1]));
    std::vector<std::string> times;
    for (const double time : shown.times) times.push_back(number(time));
    return listed(language, times);
}

std::string words_of_key(Language language, const std::string& key, const Gas& gas) {
    static constexpr std::array translated{Phrase{"radius"}, Phrase{"number of particles"},
                                           Phrase{"mass"},   Phrase{"temperature"},
                                           Phrase{"speed"},  Phrase{"length"}};
    std::string path = key;
    for (const char* form : {".exact", ".each"})
        if (path.ends_with(form)) path.resize(path.size() - std::string_view(form).size());
    std::string words = path.substr(path.rfind('.') + 1);
    std::ranges::replace(words, '_', ' ');
    if (words == "count") words = "number of particles";
    if (const auto found = std::ranges::find(translated, words, &Phrase::english);
        found != translated.end())
        words = say(language, *found);
    for (std::size_t k = 0; k < gas.species.size(); ++k) {
        const std::string& name = gas.species[k].name;
        if (gas.species.size() > 1 && (path.starts_with(fmt::format("gas.{}.", k)) ||
                                       path.starts_with(fmt::format("gas.{}.", name))))
            words = say(language, "{} of {}", words, name);
    }
    return words;
}

std::string words_of_value(Language language, const std::string& key, const std::string& value,
                           const Gas& gas) {
    return words_of_key(language, key, gas) + " " +
           (parse_number(value) ? localised(language, value) : value);
}

FigureWords words_of(const FigureRun& run, const Figure& figure) {
    const Scene& scene = run.scene();
    FigureWords words;
    const auto plain = [](const std::string& made) { return formula::without_formulas(made); };
    words.caption = figure.spec->caption
                        ? with_numbers(*figure.spec->caption, run, figure)
                        : plain(unbroken(made_caption(scene, figure, run.particles().count())));
    const std::string finding = figure.panel->finding(*figure.moments.back().state);
    if (!finding.empty()) words.caption += " " + plain(finding);
    const bool compares = !figure.sides.empty();
    if (figure.spec->alt)
        words.alt =
            formula::spoken_text(scene.film.language, with_numbers(*figure.spec->alt, run, figure));
    else
        words.alt = compares ? alt_of_runs(scene, figure) : made_alt(run, figure);
    words.shown = times_of(figure);
    words.time = words_of(wording_of(scene), words.shown);
    return words;
}

}  // namespace carom
