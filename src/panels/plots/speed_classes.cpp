// The share of slow, medium and fast particles against time, in the colours that disks have by
// their class.
#include "stats/speed_classes.h"

#include <fmt/format.h>

#include "panels/gas/gas_colors.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {
namespace {

// Samples in print take the room of words.
std::vector<plot::Text> titles(const std::vector<SeriesSubject::Line>& lines,
                               const PanelSpec& spec) {
    if (spec.title) return {escape_markup(*spec.title)};
    const auto name = [&](std::size_t k, const std::string& words) {
        return plot::named(words, lines[k].role, plot::Sample::line, k);
    };
    const plot::Text slow = name(0, "Slow"), medium = name(1, "medium"), fast = name(2, "fast");
    return {slow + ", " + medium + " and " + fast + ", in per cent",
            slow + ", " + medium + ", " + fast + " (per cent)", slow + ", " + medium + ", " + fast};
}

}  // namespace

std::unique_ptr<Panel> make_speed_classes(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject{
        .measure = {},
        .lines = {{"slow"}, {"medium"}, {"fast"}},
        .titles = {},
        .notes =
            spec.reference_initial
                ? std::vector<std::string>{"slow: &lt; ½ mean speed at the start; fast: &gt; 1½",
                                           "slow: &lt; ½ initial mean; fast: &gt; 1½",
                                           "&lt; ½, &gt; 1½ of the initial mean"}
                : std::vector<std::string>{"slow: &lt; ½ mean speed; fast: &gt; 1½",
                                           "slow: &lt; ½ mean; fast: &gt; 1½",
                                           "slow &lt; ½, fast &gt; 1½"},
        .top = 100.0,
        .quantity = "share",
        .unit = "per cent"};
    for (std::size_t k = 0; k < subject.lines.size(); ++k)
        subject.lines[k].role = plot::own_role(
            [&](const Theme& theme) { return speed_class_colors(context.scene, theme)[k]; });
    subject.titles = titles(subject.lines, spec);
    // Called for every frame in order: the first gives the mean at the start.
    subject.measure = [first = std::optional<double>{},
                       spec](const FrameInput& o) mutable -> std::vector<double> {
        const double now = o.speed.mean();
        if (!first) first = now;
        std::vector<double> percent;
        for (const double share : class_shares(o.speed, spec.reference_initial ? *first : now))
            percent.push_back(100.0 * share);
        return percent;
    };
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
