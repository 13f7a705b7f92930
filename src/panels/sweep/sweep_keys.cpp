#include "panels/sweep/sweep_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/gas.h"
#include "util/text.h"

namespace carom {
namespace {

std::optional<SweepAxis> read_axis(const std::string& text, const Node& node, Reading& reading) {
    try {
        SweepAxis axis = sweep_axis(text);
        check_sweep({.axes = {axis}});
        return axis;
    } catch (const SweepError& error) {
        reading.errors.add(node, error.what(), error.hint());
        return std::nullopt;
    }
}

void check_vary(const Sweep& sweep, const Node& node, Reading& reading) {
    constexpr std::int64_t most_in_figure = 1'000;
    try {
        check_sweep(sweep);
    } catch (const SweepError& error) {
        reading.errors.add(node, error.what(), error.hint());
        return;
    }
    if (sweep.runs() > most_in_figure)
        reading.errors.add(
            node, fmt::format("the figure needs {} runs", sweep.runs()),
            fmt::format("a figure does up to {}; do more with `carom plan`, `run` and "
                        "`join`, then give `seeds: {{from: FOLDER}}` instead of `vary`",
                        most_in_figure));
}

// Reports a horizontal axis that is neither a varied key nor a property that is known of each gas.
void check_across(const SweepShown& shown, const Node& node, Reading& reading) {
    if (shown.against == across_packing || shown.against == across_density) return;
    std::vector<std::string> names{across_packing, across_density};
    for (const SweepAxis& axis : shown.sweep.axes) names.push_back(axis.key);
    if (std::ranges::find(names, shown.against) != names.end()) return;
    reading.errors.add(
        node, fmt::format("{} is not varied", in_quotes(shown.against)),
        spelling_hint(shown.against, names,
                      "expected a key of `vary`, or `packing` or `density` of the gas"));
}

}  // namespace

std::vector<Binding<SweepShown>> sweep_keys() {
    const auto axis = parsed(text(3, most_title_letters).called("KEY=FIRST:LAST:N"), read_axis);
    const auto fill_number = [](SweepShown& shown, std::string number) {
        shown.number = std::move(number);
    };
    const auto fill_vary = [](SweepShown& shown, const std::vector<SweepAxis>& axes) {
        std::vector<SweepAxis>& all = shown.sweep.axes;
        all.insert(all.begin(), axes.begin(), axes.end());
    };
    // If all runs share the value, the axis has one value only.
    const auto fill_set = [](SweepShown& shown, const std::vector<std::string>& changes) {
        for (const std::string& change : changes) {
            const std::size_t sign = change.find('=');
            shown.sweep.axes.push_back({change.substr(0, sign), {change.substr(sign + 1)}});
        }
    };
    const auto change = checked(
        text(3, most_title_letters).called("KEY.PATH=VALUE"),
        [](const std::string& written, const Node& node, Reading& reading) {
            if (const std::size_t sign = written.find('='); sign == 0 || sign == std::string::npos)
                reading.errors.add(
                    node, fmt::format("expected KEY.PATH=VALUE, found {}", in_quotes(written)),
                    "for instance run.until=40");
        });
    const auto fill_across = [](SweepShown& shown, std::string key) {
        shown.against = std::move(key);
    };
    const auto fill_title = [](SweepShown& shown, std::string words) {
        shown.across = std::move(words);
    };
    const auto line = text(1, most_title_letters);
    return {
        bind_with<SweepShown>("number", fill_number, line,
                              "The number that it shows of each run, as `carom join` names it: "
                              "`temperature`, `virial pressure`, `collision rate`.")
            .default_text("required for a sweep"),
        bind_with<SweepShown>("vary", fill_vary,
                              one_or_list(axis, most_compared, "a list of KEY=FIRST:LAST:N"),
                              "The keys that it varies, each with N equally spaced values, or with "
                              "those listed as KEY=VALUE,VALUE,... Each point is the mean over "
                              "`seeds` runs.")
            .default_text("required without `seeds: {from: FOLDER}`"),
        bind_with<SweepShown>("set", fill_set,
                              one_or_list(change, most_changes, "a list of KEY.PATH=VALUE"),
                              "Values that differ from the scene's in all runs.")
            .default_text("nothing"),
        bind_with<SweepShown>(
            "across", fill_across, line,
            "The horizontal axis: a key that is varied, or `packing` or `density` "
            "of the gas. Each combination of the other varied keys is a line.")
            .default_text("the first key that is varied"),
        bind_with<SweepShown>("across_title", fill_title, line, "The title of the horizontal axis.")
            .default_text("made from the key")};
}

void check_sweep_figure(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!node.is_mapping()) return;
    auto& shown = panel.options.change<SweepShown>();
    if (find(node, "number") == nullptr)
        reading.errors.add(node, "a figure of kind `sweep` needs `number`",
                           "for instance {kind: sweep, number: virial pressure, vary: "
                           "\"gas.0.radius=0.1:0.4:7\", seeds: 8}");
    const Node* vary = find(node, "vary");
    if (vary == nullptr && !panel.joined)
        reading.errors.add(node, "a figure of kind `sweep` needs `vary` or `seeds: {from: FOLDER}`",
                           "it runs what `vary` says, or shows a sweep that is joined already");
    for (const char* key : {"vary", "set"})
        if (const Node* written = given(node, key); written != nullptr && panel.joined)
            reading.errors.add(*written, fmt::format("a joined sweep has its own `{}`", key),
                               fmt::format("leave out `{}`", key));
    for (const char* key : {"at", "over"})
        if (const Node* written = given(node, key))
            reading.errors.add(
                *written, "the numbers of a sweep are those of whole runs",
                fmt::format("leave out `{}`; `run.until` is the length of a run", key));
    const std::uint64_t first = reading.gas.seed;
    shown.sweep.seeds = {first, first + static_cast<std::uint64_t>(std::max(1, panel.seeds)) - 1};
    panel.seeds = 1;  // of the scene's own run, which it does not show
    if (shown.against.empty() && !shown.sweep.axes.empty())
        shown.against = shown.sweep.axes.front().key;
    if (vary == nullptr || !vary->valid || shown.sweep.axes.empty()) return;
    check_vary(shown.sweep, *vary, reading);
    if (const Node* across = given(node, "across")) check_across(shown, *across, reading);
}

}  // namespace carom
