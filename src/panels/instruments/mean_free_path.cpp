// The mean free path so far: the way that the particles chosen at the start have gone, divided by
// the number of their collisions with particles and obstacles.
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/paths/free_flights.h"

namespace carom {
namespace {

Meter mean_free_path(const PanelContext& context, const PanelSpec& spec) {
    Meter meter = meter_of_choices(context, spec, Phrase{"Mean free path so far"},
                                   quantities::length.named(Phrase{"mean free path"}));
    meter.needs_collisions = true;
    meter.read = [flights = FreeFlights(context.box(), false, velocity_changes(context.run())),
                  of = members_that_collide(context, choices(spec)),
                  sums = std::map<std::size_t, FlightTotals>()](const FrameInput& now) mutable {
        flights.see(now.sample, now.advanced.collisions);
        std::vector<double> means;
        for (std::size_t k = 0; k < of.size(); ++k) {
            for (const Eigen::Index i : of[k]) sums[k] += flights.totals()[std::size_t(i)];
            means.push_back(sums[k].collisions > 0.0 ? sums[k].way / sums[k].collisions : NAN);
        }
        return means;
    };
    if (const Law exact = law(context.gas, LawOf::free_flight))
        meter.levels = [exact] { return ReferenceLevels{ReferenceLevel{"exact", exact.value}}; };
    return meter;
}

}  // namespace

PanelKind mean_free_path_kind() {
    using enum Ability;
    return series_kind<mean_free_path>(
        {.name = "mean-free-path",
         .words = Phrase{"mean free path"},
         .shows = "The mean way between collisions with particles and obstacles, since the start.",
         .abilities = {of, means, comparison},
         .asked = {{"mean_free_path", "the mean free path since the start"}},
         .shows_units = true,
         .laws = always(std::vector{LawOf::free_flight}),
         .work = always(PanelWork{.flights = PanelWork::Flights::followed})});
}

}  // namespace carom
