// The entropy of the velocities, of the positions, or both against time, with the value that the
// same counting gives in equilibrium.
#include "stats/entropy.h"

#include <memory>
#include <optional>
#include <utility>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "panels/surfaces/place_options.h"
#include "physics/gas.h"
#include "physics/theory/velocity_entropy.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

/// The distribution whose entropy is shown.
enum class EntropyOf { velocities, positions, both };

struct EntropyOptions {
    EntropyOf of = EntropyOf::velocities;
    std::optional<int> cells = {};  ///< none: by rule
};

std::vector<Binding<EntropyOptions>> entropy_keys() {
    return {bind_key("space", &EntropyOptions::of,
                     one_of<EntropyOf>({{"velocities", EntropyOf::velocities},
                                        {"positions", EntropyOf::positions},
                                        {"both", EntropyOf::both}}),
                     "Which entropy it shows: of the velocities, of the positions, or both."),
            cells_key(&EntropyOptions::cells)};
}

std::optional<SeveralShown> several_entropies(const PanelSpec& panel) {
    if (panel.options.as<EntropyOptions>().of != EntropyOf::both) return std::nullopt;
    return SeveralShown{"space", "one of the two",
                        "make a figure for `velocities`, and one for `positions`"};
}

std::vector<LawOf> laws_of_entropy(const PanelSpec& spec, const Gas&) {
    const EntropyOf of = spec.options.as<EntropyOptions>().of;
    std::vector<LawOf> laws;
    if (of != EntropyOf::positions) laws.push_back(LawOf::velocity_entropy);
    if (of != EntropyOf::velocities) laws.push_back(LawOf::position_entropy);
    return laws;
}

// Data that are known once the gas has been seen.
struct Entropies {
    std::optional<VelocityEntropy> velocities;  ///< none of a gas at rest
    bool is_known = false;
};

const plot::Role of_velocities{.of = plot::Role::Of::bar};
const plot::Role of_positions{.of = plot::Role::Of::highlight};

void add_titles(Language language, EntropyOf what, SeriesSubject& subject) {
    const std::string sum = "−Σ <i>p</i> ln <i>p</i>";
    if (what == EntropyOf::velocities) {
        subject.titles = {
            say(language, "Entropy of the velocities, −<i>H</i>"),
            plot::text_of(language, Phrase{"{}, {}"}, {say(language, "Entropy"), "−<i>H</i>"})};
        subject.notes = {
            say(language,
                "−Σ <i>p</i> ln <i>p</i> over velocity cells; 0 if all velocities are equal"),
            say(language, "−Σ <i>p</i> ln <i>p</i> over velocity cells"), sum};
    } else if (what == EntropyOf::positions) {
        subject.titles = {say(language, "Entropy of the positions")};
        subject.notes = {say(language, "−Σ <i>p</i> ln <i>p</i> over cells of the box"), sum};
    } else {
        subject.lines[0].name = say(language, "velocities");
        subject.lines[1].name = say(language, "positions");
        const plot::Text names = joined(
            language, {plot::named(subject.lines[0].name, of_velocities, plot::Swatch::line, 0),
                       plot::named(subject.lines[1].name, of_positions, plot::Swatch::line, 1)});
        subject.titles = {plot::text_of(language, Phrase{"Entropy of {}"}, {names}), subject.title};
        subject.notes = {say(language, "−Σ <i>p</i> ln <i>p</i> over cells"), sum};
    }
}

SeriesSubject entropy(const PanelContext& context, const PanelSpec& spec) {
    const EntropyOf what = spec.options.as<EntropyOptions>().of;
    const auto known = std::make_shared<Entropies>();
    const PositionEntropy places(context.box(), context.particles,
                                 spec.options.as<EntropyOptions>().cells);
    SeriesSubject subject{
        {.title = say(context.language(), "Entropy"), .quantity = quantities::entropy}};
    if (what != EntropyOf::positions) subject.lines.push_back({"velocities", "", of_velocities});
    if (what != EntropyOf::velocities) subject.lines.push_back({"positions", "", of_positions});
    if (what == EntropyOf::velocities) subject.lines = {{"all"}};
    subject.read = [context, known, places, what](const FrameInput& o) {
        if (!std::exchange(known->is_known, true)) {
            const auto start = thermal_motion(context.box(), context.particles, o.sample);
            if (start.energy > 0.0) known->velocities.emplace(context.particles, start);
        }
        std::vector<double> now;
        if (what != EntropyOf::positions)
            now.push_back(known->velocities ? known->velocities->of(o.sample.velocity) : 0.0);
        if (what != EntropyOf::velocities) now.push_back(places.of(o.sample.position));
        return now;
    };
    add_titles(context.language(), what, subject);
    subject.levels = [context, places, what] {
        ReferenceLevels levels;
        if (what != EntropyOf::positions)
            if (const Law velocities = law(context.gas, LawOf::velocity_entropy))
                levels.push_back(ReferenceLevel{"equilibrium", velocities.value});
        const auto& cells = places.cells().count;
        if (what != EntropyOf::velocities)
            if (const Law positions =
                    law(context.gas, LawOf::position_entropy,
                        {.cells = cells[0], .cells_up = cells[1], .cells_deep = cells[2]}))
                levels.push_back(ReferenceLevel{"evenly spread", positions.value});
        return levels;
    };
    return subject;
}

}  // namespace

PanelKind entropy_kind() {
    using enum Ability;
    return series_kind<entropy>(
        {.name = "entropy",
         .words = Phrase{"entropy"},
         .shows = "The entropy of the velocities, of the positions, or both (`space`), against "
                  "time.",
         .abilities = {means, comparison},
         .asked = {{"entropy", "the entropy"}},
         .keys = option_keys(entropy_keys()),
         .laws = laws_of_entropy,
         .several = several_entropies});
}

}  // namespace carom
