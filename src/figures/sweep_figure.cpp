#include "figures/sweep_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "figures/figure_words.h"
#include "figures/sweep_theory.h"
#include "panels/sweep/sweep_keys.h"
#include "runs/sweep_summary.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/yaml/node.h"
#include "util/diagnostics.h"
#include "util/files/input_file.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr int steps_between = 8;  // number of steps of a curve from one value to the next

std::optional<double> number_from(const std::string& text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

SweepSummary read_joined(const Scene& scene, const FigureSpec& spec) {
    constexpr std::int64_t most_bytes = 256 << 20;
    const fs::path path = path_of_joined(scene, spec);
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        refuse(spec.panel.place, fmt::format("{} is not there", path.string()),
               "make it: carom plan SCENE --vary ... -o SWEEP, carom run SWEEP, carom join SWEEP");
    SweepSummary summary;
    try {
        summary = sweep_summary(read_file(path, most_bytes), path.string());
    } catch (const SystemError& refused) {
        refuse(spec.panel.place, refused.what(), "join the sweep again");
    }
    if (summary.physics != scene.source.physics)
        refuse(spec.panel.place,
               fmt::format("{} is the summary of another scene ({}), or of this one with other "
                           "values",
                           path.string(), summary.scene),
               "plan the sweep again with this scene");
    return summary;
}

// The summary of the sweep that the figure would run itself, still without results.
SweepSummary planned(const FigureSpec& spec) {
    const SweepShown& shown = *sweep_of(spec);
    return {.sweep = shown.sweep,
            .numbers = numbers_of_runs(*shown.scene_with(shown.sweep.changes_at(0)))};
}

SweepSummary run_here(const FigureSpec& spec, int threads, const std::function<void()>& on_run) {
    const SweepShown& shown = *sweep_of(spec);
    const auto scene_at = [&](std::int64_t point) {
        return shown.scene_with(shown.sweep.changes_at(point));
    };
    SweepSummary summary = planned(spec);
    const RunRows rows = run_part(shown.sweep, 0, shown.sweep.runs(), threads, scene_at, on_run);
    const std::int64_t seeds = shown.sweep.seeds.count();
    for (std::int64_t point = 0; point < shown.sweep.points(); ++point) {
        const auto first = rows.begin() + point * seeds;
        summary.points.push_back({seeds, statistics_of(RunRows(first, first + seeds))});
    }
    return summary;
}

/// A figure of a sweep whose summary is given.
class SweptFigure {
  public:
    SweptFigure(const Scene& scene, const FigureSpec& spec, SweepSummary summary)
        : scene_(scene),
          spec_(spec),
          shown_(*sweep_of(spec)),
          summary_(std::move(summary)),
          across_(axis_across()),
          number_(find_number()) {
        check_lines();
    }

    SweptNumbers numbers() {
        const RunNumber& number = summary_.numbers[number_];
        SweptNumbers numbers{.number = {number.name, number.quantity},
                             .across = words_across(),
                             .column = column_across(Language::english)};
        for (const std::vector<std::int64_t>& points : points_of_lines())
            numbers.lines.push_back(line(points));
        if (numbers.lines.size() > 1)
            for (SweptLine& line : numbers.lines) line.ideal = {};
        return numbers;
    }

  private:
    using Changes = std::vector<std::string>;

    bool is_of_gas() const {
        return shown_.against == across_packing || shown_.against == across_density;
    }

    // The axis of the sweep that is plotted across: the one that is named, or else the first with
    // several values.
    std::size_t axis_across() const {
        const std::vector<SweepAxis>& axes = summary_.sweep.axes;
        for (std::size_t k = 0; k < axes.size(); ++k)
            if (shown_.against.empty() || is_of_gas() ? axes[k].values.size() > 1
                                                      : axes[k].key == shown_.against)
                return k;
        refuse(spec_.panel.place,
               shown_.against.empty() || is_of_gas()
                   ? "the sweep varies nothing"
                   : fmt::format("the sweep does not vary `{}`", shown_.against),
               "a figure of kind `sweep` needs a key with several values");
    }

    std::size_t find_number() const {
        std::vector<std::string> names;
        for (const RunNumber& number : summary_.numbers) names.push_back(number.name);
        const auto found = std::ranges::find(names, shown_.number);
        if (found == names.end())
            refuse(spec_.panel.place,
                   fmt::format("a run of this scene has no number {}", in_quotes(shown_.number)),
                   spelling_hint(shown_.number, names,
                                 fmt::format("it has {}", listed(names, "and", "`"))));
        return static_cast<std::size_t>(found - names.begin());
    }

    void check_lines() const {
        for (std::int64_t point = 0; point < summary_.sweep.points(); ++point) key_at(point);
        const std::size_t lines = points_of_lines().size();
        if (lines > most_compared.count())
            refuse(spec_.panel.place, fmt::format("the figure would have {} lines", lines),
                   fmt::format("the limit is {} combinations of the keys that are not across",
                               number_text(most_compared.value)));
    }

    std::string words_across() const {
        return shown_.across.empty() ? column_across(scene_.film.language) : shown_.across;
    }

    std::string column_across(Language language) const {
        if (shown_.against == across_packing) return say(language, "packing fraction");
        if (shown_.against == across_density) return say(language, "density");
        return words_of_key(language, summary_.sweep.axes[across_].key, scene_.gas);
    }

    // The name of a line: the values of the other keys, except keys with a single value.
    std::string name_of_line(Language language, std::int64_t point) const {
        std::vector<std::string> names;
        const Changes values = summary_.sweep.values_at(point);
        for (std::size_t k = 0; k < values.size(); ++k)
            if (const SweepAxis& axis = summary_.sweep.axes[k];
                k != across_ && axis.values.size() > 1)
                names.push_back(words_of_value(language, axis.key, values[k], scene_.gas));
        return fmt::format("{}", fmt::join(names, between_numbers(language)));
    }

    // The points of each line, in the order of the points.
    std::vector<std::vector<std::int64_t>> points_of_lines() const {
        std::vector<std::pair<std::string, std::vector<std::int64_t>>> lines;
        for (std::int64_t point = 0; point < summary_.sweep.points(); ++point) {
            const std::string name = name_of_line(Language::english, point);
            const auto found =
                std::ranges::find(lines, name, [](const auto& one) { return one.first; });
            if (found == lines.end())
                lines.push_back({name, {point}});
            else
                found->second.push_back(point);
        }
        std::vector<std::vector<std::int64_t>> points;
        for (auto& line : lines) points.push_back(std::move(line.second));
        return points;
    }

    double key_at(std::int64_t point) const {
        const std::string value = summary_.sweep.values_at(point)[across_];
        const auto number = number_from(value);
        if (!number)
            refuse(spec_.panel.place,
                   fmt::format("{} is no number: it has no place on an axis", in_quotes(value)),
                   "vary a key that is a number, or say another one in `across`");
        return *number;
    }

    // The abscissa of a scene with this value of the key.
    std::optional<double> place_of(const Scene& scene, double key) const {
        if (shown_.against == across_packing) return packing_of(scene);
        if (shown_.against == across_density) return density_of(scene);
        return key;
    }

    SweptLine line(std::vector<std::int64_t> points) const {
        std::ranges::sort(points, {}, [&](std::int64_t point) { return key_at(point); });
        SweptLine line{.name = name_of_line(scene_.film.language, points.front()),
                       .column = name_of_line(Language::english, points.front())};
        for (const std::int64_t point : points) {
            const NumberStatistics& its =
                summary_.points[static_cast<std::size_t>(point)].numbers[number_];
            if (its.count == 0) continue;
            const double key = key_at(point);
            const auto scene =
                is_of_gas() ? shown_.scene_with(summary_.sweep.changes_at(point)) : nullptr;
            line.x.push_back(is_of_gas() ? place_of(*scene, key).value_or(key) : key);
            line.mean.push_back(its.mean);
            line.error.push_back(its.error);
            line.runs.push_back(its.count);
        }
        if (spec_.panel.theory) add_theory(line, points);
        return line;
    }

    std::vector<double> keys_between(const std::vector<std::int64_t>& points) const {
        std::vector<double> keys;
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            for (int i = 0; i < steps_between; ++i)
                keys.push_back(key_at(points[k]) +
                               (key_at(points[k + 1]) - key_at(points[k])) * i / steps_between);
        keys.push_back(key_at(points.back()));
        return keys;
    }

    // The scene with this value of the key; null if there is no such gas.
    std::shared_ptr<const Scene> scene_at(Changes& changes, double key) const {
        changes[across_] = fmt::format("{}={:.15g}", summary_.sweep.axes[across_].key, key);
        try {
            return shown_.scene_with(changes);
        } catch (const SceneError&) {
            return nullptr;
        }
    }

    // The phase whose theory holds at this value of the key; nothing if there is none.
    std::optional<PhaseOfSpheres> phase_at(Changes& changes, double key) const {
        const std::shared_ptr<const Scene> scene = scene_at(changes, key);
        if (scene == nullptr) return std::nullopt;
        for (const PhaseOfSpheres phase :
             {PhaseOfSpheres::fluid, PhaseOfSpheres::coexistence, PhaseOfSpheres::crystal})
            if (theory_of_number(shown_.number, *scene, summary_.sweep.seeds, phase)) return phase;
        return std::nullopt;
    }

    // Adds values on both sides of where one phase gives way to another, so that their curves meet.
    std::vector<double> with_transitions(const std::vector<double>& keys, Changes& changes) const {
        constexpr int halvings = 12;
        if (keys.size() < 2) return keys;
        std::vector<double> all{keys.front()};
        std::optional<PhaseOfSpheres> before = phase_at(changes, keys.front());
        for (std::size_t k = 1; k < keys.size(); ++k) {
            const std::optional<PhaseOfSpheres> after = phase_at(changes, keys[k]);
            double low = keys[k - 1], high = keys[k];
            if (before && after && *before != *after) {
                for (int i = 0; i < halvings; ++i) {
                    const double middle = 0.5 * (low + high);
                    const std::optional<PhaseOfSpheres> there = phase_at(changes, middle);
                    if (!there) break;
                    (*there == *before ? low : high) = middle;
                }
                if (low > keys[k - 1]) all.push_back(low);
                if (high < keys[k]) all.push_back(high);
            }
            all.push_back(keys[k]);
            before = after;
        }
        return all;
    }

    // Adds the theoretical curve. For a key that takes only whole numbers there are no values in
    // between. The curve has a gap where no gas exists.
    void add_theory(SweptLine& line, const std::vector<std::int64_t>& points) const {
        Changes changes = summary_.sweep.changes_at(points.front());
        double last = std::numeric_limits<double>::quiet_NaN();
        for (double key : with_transitions(keys_between(points), changes)) {
            std::shared_ptr<const Scene> scene = scene_at(changes, key);
            if (scene == nullptr && key != std::round(key)) {
                key = std::round(key);
                scene = key == last ? nullptr : scene_at(changes, key);
            }
            if (scene == nullptr) continue;
            last = key;
            const SeedRange& seeds = summary_.sweep.seeds;
            const auto x = place_of(*scene, key);
            if (!x) continue;
            const auto add = [&](SweptCurve& curve, std::optional<double> y, const Phrase& name) {
                if (!y) return;
                curve.name = name.english;
                curve.x.push_back(*x);
                curve.y.push_back(*y);
            };
            for (const auto& [curve, phase] :
                 {std::pair{&line.theory, PhaseOfSpheres::fluid},
                  std::pair{&line.coexistence, PhaseOfSpheres::coexistence},
                  std::pair{&line.crystal, PhaseOfSpheres::crystal}})
                add(*curve, theory_of_number(shown_.number, *scene, seeds, phase),
                    name_of_theory(shown_.number, *scene, phase));
            add(line.ideal, ideal_gas_of_number(shown_.number, *scene, seeds), name_of_ideal_gas());
        }
    }

    const Scene& scene_;
    const FigureSpec& spec_;
    const SweepShown& shown_;
    SweepSummary summary_;
    std::size_t across_, number_;
};

}  // namespace

fs::path path_of_joined(const Scene& scene, const FigureSpec& spec) {
    fs::path path = *spec.panel.joined;
    if (path.is_relative()) path = fs::path(scene.source.path).parent_path() / path;
    std::error_code error;
    return fs::is_directory(path, error) ? path / "summary.json" : path;
}

void check_swept_figure(const Scene& scene, const FigureSpec& spec) {
    const SweptFigure figure(scene, spec,
                             spec.panel.joined ? read_joined(scene, spec) : planned(spec));
}

SweptNumbers swept_numbers(const Scene& scene, const FigureSpec& spec, int threads,
                           const std::function<void()>& on_run) {
    if (!spec.panel.joined) check_swept_figure(scene, spec);
    SweepSummary summary =
        spec.panel.joined ? read_joined(scene, spec) : run_here(spec, threads, on_run);
    return SweptFigure(scene, spec, std::move(summary)).numbers();
}

}  // namespace carom
