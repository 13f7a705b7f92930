#include "panels/correlations/diffusion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/gas.h"
#include "stats/displacements.h"
#include "util/text.h"

namespace carom {
namespace {

const plot::Stroke of_fit{.role = {.of = plot::Role::Of::highlight},
                          .width = 0.08,
                          .dashes = {0.3},
                          .shade = plot::Shade::legible};
const plot::Stroke of_ballistic{.role = {.of = plot::Role::Of::accent},
                                .width = 0.1,
                                .dashes = {0.5, 0.35},
                                .shade = plot::Shade::legible};

const plot::Stroke of_plateau{.width = 0.08, .dashes = {0.9, 0.3}};

plot::Polyline straight_line(const plot::Plot& plot, const LineFit& fit, double from, double to) {
    plot::Polyline line;
    line.part = "fit";
    line.still = true;
    line.x = plot::column(plot.columns[0], {from, to});
    line.y = plot::column(plot.columns[1], {fit.at(from), fit.at(to)});
    line.stroke = of_fit;
    return line;
}

// What may stand in the way of a diffusion coefficient for a while, in few words; empty: for good.
std::string short_words(Language language, NoLaw::Why why) {
    if (why == NoLaw::Why::no_collisions) return say(language, "no collisions yet");
    if (why == NoLaw::Why::few_collisions) return say(language, "too few collisions");
    return "";
}

std::string short_words(Language language, SlopeProblem problem) {
    return problem == SlopeProblem::few_pieces ? say(language, "too few data")
                                               : say(language, "not straight yet");
}

std::string named(Language language, const std::string& name, const std::string& words) {
    return name.empty() ? words : say(language, "{}: {}", escape_markup(name), words);
}

}  // namespace

std::string with_error(Language language, const MeanError& number) {
    return carom::with_error(language, number.mean, number.error);
}

LineLaw displacement_law(const PanelContext& context, const Chosen& chosen,
                         std::optional<double> collisions) {
    const Law found = law(context.gas, LawOf::displacement,
                          {.of = members(context, chosen), .collisions = collisions});
    LineLaw its{.value = found.value};
    if (found.none) {
        its.reason = to_text(context.language(), *found.none, context.species());
        its.short_reason = short_words(context.language(), found.none->why);
    }
    return its;
}

Finding finding_of(const std::string& name, LineLaw law, const std::vector<MeanError>& numbers,
                   int runs) {
    Finding finding{.name = name, .law = std::move(law), .diffusion = numbers[of_diffusion]};
    if (finding.is_known())
        finding.problem =
            problem_of({numbers[of_diffusion], numbers[of_bend], numbers[of_pieces].mean * runs,
                        runs > 1 ? double(runs) : numbers[of_pieces].mean});
    return finding;
}

std::string reason_of(Language language, const Finding& finding) {
    return finding.problem ? to_text(language, *finding.problem) : finding.law.reason;
}

std::optional<plot::Polyline> fit_of(const plot::Plot& plot, const std::vector<double>& x,
                                     const std::vector<double>& y, double from, double until) {
    std::vector<double> times, squares;
    for (std::size_t i = 0; i < x.size() && x[i] <= until; ++i) {
        const bool stands = !times.empty() && times.back() == x[i];
        if (x[i] < from || stands || !std::isfinite(y[i])) continue;
        times.push_back(x[i]);
        squares.push_back(y[i]);
    }
    if (times.size() < 2) return {};
    return straight_line(plot, fit_line(times, squares), times.front(), times.back());
}

bool add_ballistic(const PanelContext& context, double from, double square_speed, bool is_still,
                   plot::Plot& plot) {
    constexpr double least_seen = 0.015;  // of the axis
    constexpr int points = 40;
    const double reach = std::sqrt(plot.y.high / square_speed);
    const double span = plot.x.high - plot.x.low;
    if (!(square_speed > 0.0) || !(reach > least_seen * span) ||
        context.gas.influences.has_gravity())
        return false;
    std::vector<double> x, y;
    for (int i = 0; i <= points; ++i) {
        const double time = std::min(reach, plot.x.high - from) * i / points;
        x.push_back(from + time);
        y.push_back(square_speed * time * time);
    }
    plot::Polyline line;
    line.part = "ballistic";
    line.still = is_still;
    line.x = plot::column(plot.columns[0], std::move(x));
    line.y = plot::column(plot.columns[1], std::move(y));
    line.stroke = of_ballistic;
    line.depth = 1;
    plot.layers.emplace_back(std::move(line));
    return true;
}

plot::KeyEntry ballistic_entry(Language language) {
    const std::string formula = "⟨<i>v</i>²⟩<i>t</i>²";
    return {of_ballistic, {say(language, "without collisions {}", formula), formula}};
}

bool add_plateau(const Finding& finding, const std::string& of, plot::Plot& plot) {
    if (!finding.has_plateau() || finding.law.value > plot.y.high) return false;
    plot::Level level;
    level.part = "plateau";
    level.of = of;
    level.still = true;
    level.x_column = plot.columns[0];
    level.column = plot.columns[1];
    level.value = finding.law.value;
    level.stroke = of_plateau;
    plot.layers.emplace_back(std::move(level));
    return true;
}

plot::KeyEntry plateau_entry(Language language, const Finding& finding) {
    return {of_plateau,
            {named(language, finding.name,
                   say(language, "plateau {}", three_digits(language, finding.law.value)))}};
}

namespace {

plot::Text words_without_coefficient(Language language, const std::string& name,
                                     const std::string& reason) {
    return named(language, name, say(language, "no <i>D</i>: {}", reason));
}

// With short words for a reason that may pass, if there are any.
plot::KeyEntry entry_without_coefficient(Language language, const std::string& name,
                                         const std::string& reason,
                                         const std::string& short_reason) {
    const std::string& shown = short_reason.empty() ? reason : short_reason;
    return {.words = {words_without_coefficient(language, name, shown)}, .breaks = true};
}

// Why a line has no coefficient now, in few words, if that may pass.
std::string short_reason_of(Language language, const Finding& finding) {
    return finding.problem ? short_words(language, *finding.problem) : finding.law.short_reason;
}

}  // namespace

plot::KeyEntry finding_entry(Language language, const Finding& finding) {
    const std::string short_reason = short_reason_of(language, finding);
    if (!finding.is_known() && short_reason.empty())
        return entry_without_coefficient(language, finding.name, finding.law.reason, "");
    const auto words = [&](const std::string& number) {
        return plot::Text(named(language, finding.name, "<i>D</i> = " + number));
    };
    plot::KeyEntry entry = entry_without_coefficient(language, finding.name, "", short_reason);
    const auto reserve = [&](const std::string& passing) {
        entry.reserved.push_back(
            {words_without_coefficient(language, finding.name, passing), false});
    };
    for (const NoLaw::Why why : {NoLaw::Why::no_collisions, NoLaw::Why::few_collisions})
        reserve(short_words(language, why));
    for (const SlopeProblem problem : {SlopeProblem::few_pieces, SlopeProblem::bends})
        reserve(short_words(language, problem));
    entry.reserved.push_back({words("0.0000 ± 0.0000")});
    if (!finding.is_known()) return entry;
    entry.swatch = of_fit;
    const bool is_known = std::isfinite(finding.diffusion.mean);
    entry.words = {words(is_known ? with_error(language, finding.diffusion) : "")};
    return entry;
}

void add_findings(Language language, double from, const std::vector<Finding>& all,
                  plot::Plot& plot) {
    const std::string since = three_digits(language, from);
    std::vector<std::string> values;
    struct Reason {
        std::string words, short_words, names;  // of the lines that have it
    };
    std::vector<Reason> reasons;
    for (const Finding& one : all) {
        if (one.is_known()) {
            const std::string value = with_error(language, one.diffusion);
            values.push_back(one.name.empty() ? value : one.name + " " + value);
            continue;
        }
        const std::string reason = reason_of(language, one);
        if (reasons.empty() || reasons.back().words != reason)
            reasons.push_back({reason, short_reason_of(language, one), one.name});
        else
            reasons.back().names += ", " + one.name;
    }
    plot::Note note{.wraps = true};
    if (!values.empty()) {
        const std::string found = "<i>D</i> = " + escape_markup(listed(language, values));
        note.entries.push_back(
            {of_fit, {say(language, "fit 2<i>dDt</i> from time {}: {}", since, found), found}});
        plot.account = say(language, "The line 2dDt fitted from time {} on has D = {}.", since,
                           listed(language, values));
    }
    for (const auto& [reason, in_short, names] : reasons) {
        note.entries.push_back(entry_without_coefficient(language, names, reason, in_short));
        plot.account +=
            (plot.account.empty() ? "" : " ") +
            (names.empty() ? say(language, "No diffusion coefficient: {}.", reason)
                           : say(language, "No diffusion coefficient of {}: {}.", names, reason));
    }
    if (!note.entries.empty()) plot.notes.push_back(std::move(note));
}

}  // namespace carom
