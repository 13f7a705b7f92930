#include "app/check/cut_distributions.h"

#include <fmt/format.h>

#include <variant>

#include "physics/gas.h"
#include "physics/sampling/cut_normal.h"
#include "physics/units/number_text.h"
#include "runs/number_json.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double least_share = 0.01;

void add(std::vector<ListItem>& all, const Species& species, const char* key,
         const Quantity& quantity, const ValueRule& rule, bool is_folded, UnitSystem units) {
    const auto number = [&](double value) {
        return three_digits({Language::english, units}, quantity, value);
    };
    const auto* normal = std::get_if<NormalDistribution>(&rule);
    if (normal == nullptr) return;
    const CutNormal cut = is_folded ? folded_at_zero(*normal) : truncated_at_zero(*normal);
    if (!(cut.share > least_share)) return;
    all.push_back(
        {fmt::format("{} of {}: {} % of the normal distribution is below 0 and {}; the "
                     "mean is {}, not {}, the deviation {}, not {}",
                     key, species.name, three_digits(100.0 * cut.share),
                     is_folded ? "loses its sign" : "is drawn again", number(cut.mean),
                     number(normal->mean), number(cut.deviation), number(normal->deviation)),
         Json{{"species", species.name},
              {"key", key},
              {"below_zero", Amount{cut.share, quantities::share}},
              {"instead", is_folded ? "sign removed" : "drawn again"},
              {"mean", Amount{cut.mean, quantity, units}},
              {"deviation", Amount{cut.deviation, quantity, units}}}});
}

}  // namespace

std::vector<ListItem> cut_distributions(const Gas& gas, UnitSystem units) {
    std::vector<ListItem> all;
    for (const Species& species : gas.species) {
        add(all, species, "radius", quantities::length, species.radius, false, units);
        if (const auto* mass = std::get_if<ValueRule>(&species.mass))
            add(all, species, "mass", quantities::mass, *mass, false, units);
        if (const auto* density = std::get_if<Density>(&species.mass))
            add(all, species, "density", quantities::mass / quantities::content(gas.box.dimension),
                density->value, false, units);
        if (const auto* speed = std::get_if<Speed>(&species.velocity))
            add(all, species, "speed", quantities::speed, speed->value, true, units);
    }
    return all;
}

}  // namespace carom
