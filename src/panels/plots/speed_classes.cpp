// The share of slow, medium and fast particles against time, in the colours that disks have by
// their class.
#include "stats/speed_classes.h"

#include "draw/palette.h"
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/plots/suits.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

struct SpeedClassOptions {
    bool is_by_start = false;  // classes by the initial mean, not the present one
};

std::vector<Binding<SpeedClassOptions>> speed_class_keys() {
    return {bind_key("reference", &SpeedClassOptions::is_by_start,
                     one_of<bool>({{"now", false}, {"initial", true}}),
                     "The mean speed that defines slow and fast: at present, or at the start.")};
}

// Samples in print take the room of words.
std::vector<plot::Text> titles(Language language, const std::vector<MeterLine>& lines) {
    const auto name = [&](std::size_t k, const std::string& words) {
        return plot::named(words, lines[k].role, plot::Swatch::line, k);
    };
    const std::vector<plot::Text> names{name(0, capitalised(say(language, "slow"))),
                                        name(1, say(language, "medium")),
                                        name(2, say(language, "fast"))};
    return {
        plot::text_of(language, Phrase{"{}, in per cent"}, {joined(language, names)}),
        plot::text_of(language, Phrase{"{} (per cent)"}, {joined(language, names, Joint::commas)}),
        joined(language, names, Joint::commas)};
}

SeriesSubject speed_classes(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const auto& options = spec.options.as<SpeedClassOptions>();
    SeriesSubject subject{
        {.title = say(language, "{} (per cent)", capitalised(say(language, "share"))),
         .quantity = quantities::per_cent,
         .lines = {{"slow", say(language, "slow")},
                   {"medium", say(language, "medium")},
                   {"fast", say(language, "fast")}},
         .over = spec.over,
         .needs_positions = false}};
    subject.notes =
        options.is_by_start
            ? std::vector{say(language, "slow: &lt; ½ mean speed at the start; fast: &gt; 1½"),
                          say(language, "slow: &lt; ½ initial mean; fast: &gt; 1½"),
                          say(language, "&lt; ½, &gt; 1½ of the initial mean")}
            : std::vector{say(language, "slow: &lt; ½ mean speed; fast: &gt; 1½"),
                          say(language, "slow: &lt; ½ mean; fast: &gt; 1½"),
                          say(language, "slow &lt; ½, fast &gt; 1½")};
    subject.top = 100.0;
    for (std::size_t k = 0; k < subject.lines.size(); ++k)
        subject.lines[k].role = plot::own_role(themes_of(context.film()), [&](const Theme& theme) {
            return speed_class_color(k, theme);
        });
    subject.titles = titles(language, subject.lines);
    // Called for every frame in order: the first gives the mean at the start.
    subject.read = [first = std::optional<double>{}, &particles = context.particles,
                    options](const FrameInput& o) mutable -> std::vector<double> {
        const double now = mean_of_speeds(particles, o.speed);
        if (!first) first = now;
        std::vector<double> percent;
        for (const double share : class_shares(o.speed, options.is_by_start ? *first : now))
            percent.push_back(100.0 * share);
        return percent;
    };
    return subject;
}

}  // namespace

PanelKind speed_classes_kind() {
    using enum Ability;
    return series_kind<speed_classes>(
        {.name = "speed-classes",
         .words = Phrase{"speed classes"},
         .shows = "The shares of slow (below half of the mean speed), medium and fast particles "
                  "(above one and a half times it) against time.",
         .abilities = {over, means},
         .keys = option_keys(speed_class_keys()),
         .suits = speeds_spread});
}

}  // namespace carom
