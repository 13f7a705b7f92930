// The share of slow, medium and fast particles against time, in the colours that disks have by
// their class.
#include "stats/speed_classes.h"

#include <fmt/format.h>

#include "panels/gas/gas_colors.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {
namespace {

std::string title(const PanelContext& context, const PanelSpec& spec, const Theme& theme) {
    if (spec.title) return escape_markup(*spec.title);
    const std::vector<Color> colors = speed_class_colors(context.scene, theme);
    const auto name = [&](std::size_t k, const std::string& words) {
        return line_sample(k, colors[k], theme) + colored(words, colors[k], theme);
    };
    const std::string slow = name(0, "Slow"), medium = name(1, "medium"), fast = name(2, "fast");
    if (theme.kind == ThemeKind::print)  // samples take the room of words
        return fmt::format("{}, {}, {} (per cent)", slow, medium, fast);
    return fmt::format("{}, {} and {}, in per cent", slow, medium, fast);
}

}  // namespace

std::unique_ptr<Panel> make_speed_classes(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject{
        .measure = {},
        .color = [context](
                     std::size_t k,
                     const Theme& theme) { return speed_class_colors(context.scene, theme)[k]; },
        .title = [context, spec](const Theme& theme) { return title(context, spec, theme); },
        .notes =
            spec.reference_initial
                ? std::vector<std::string>{"slow below ½, fast above 1½ of the mean at the start",
                                           "below ½, above 1½ of the mean at the start"}
                : std::vector<
                      std::string>{spec.at ? "slow below ½, fast above 1½ of each time’s "
                                             "mean speed"
                                           : "slow below ½, fast above 1½ of the mean speed now",
                                   "slow below ½, fast above 1½ of the mean"},
        .top = 100.0,
        .column = "share (per cent)",
        .names = {"slow", "medium", "fast"}};
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
