#include "panels/correlations/correlation_keys.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

Binding<PanelSpec> from_key() {
    return bind_key("from", &PanelSpec::from, number(not_negative),
                    "The simulated time from which displacements are measured, or velocities "
                    "compared.");
}

Binding<PanelSpec> lags_key() {
    return bind_key("lags", &PanelSpec::lags, number(positive),
                    "The longest time lag, between two velocities or, with `origins: all`, two "
                    "positions.")
        .default_text("a tenth of the time from `from` to the end; a quarter for displacements");
}

// Reports a time at or after the end of the run; returns whether it did.
bool is_late(const Node* key, double time, Reading& reading) {
    const double until = reading.run.until;
    if (key == nullptr || time < until) return false;
    reading.errors.add(*key, fmt::format("expected a time below {}", until),
                       fmt::format("the run ends at {}", until));
    return true;
}

void check_lags(const PanelSpec& panel, const Node& node, Reading& reading) {
    const Node* lags = given(node, "lags");
    const double span = reading.run.until - panel.from;
    if (lags == nullptr || *panel.lags <= span) return;
    reading.errors.add(*lags, fmt::format("`lags` is longer than the measured time of {}", span),
                       fmt::format("give at most {}, much less for a good mean", span));
}

}  // namespace

std::vector<Binding<PanelSpec>> displacement_keys() {
    return {
        from_key(),
        bind_key("origins", &PanelSpec::all_origins, one_of<bool>({{"one", false}, {"all", true}}),
                 "Displacements since `from`, or their mean over all starting times from then on, "
                 "against the time lag."),
        lags_key(),
        bind_key("fit_from", &PanelSpec::fit_from, number(not_negative),
                 "The time from which the line 2 d D t is fitted; D is the diffusion "
                 "coefficient. With `origins: all`, the time lag.")
            .default_text("half-way from `from` to the end; with `origins: all`, half of `lags`")};
}

std::vector<Binding<PanelSpec>> pair_correlation_keys() {
    return {bind_key("to", &PanelSpec::to, number(positive), "The largest distance.")
                .default_text("five diameters, or less in a smaller box; for points half of the "
                              "largest distance")};
}

std::vector<Binding<PanelSpec>> autocorrelation_keys() { return {lags_key(), from_key()}; }

std::vector<Binding<PanelSpec>> free_flight_keys() {
    return {
        bind_key("log", &PanelSpec::logarithmic, flag(),
                 "Whether the vertical axis is logarithmic: an exponential law is then straight."),
        bind_key("walls", &PanelSpec::ends_at_walls, flag(),
                 "Whether walls and partitions end a free flight too; otherwise only other "
                 "particles and obstacles do.")};
}

double usual_lags(const PanelSpec& spec, const Run& run) {
    return spec.lags.value_or((spec.all_origins ? 0.25 : 0.1) * (run.until - spec.from));
}

// The fitted line needs a part of the run in which displacements are measured.
void check_displacements(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!(reading.run.until > 0.0)) return;
    const Node *from = given(node, "from"), *fit_from = given(node, "fit_from");
    if (is_late(from, panel.from, reading)) return;
    if (panel.all_origins) {
        check_lags(panel, node, reading);
        const double lags = usual_lags(panel, reading.run);
        if (fit_from != nullptr && *panel.fit_from >= lags)
            reading.errors.add(*fit_from, fmt::format("expected a time below {}", lags),
                               fmt::format("times since a start go up to {}", lags));
        return;
    }
    if (const Node* lags = given(node, "lags"))
        reading.errors.add(*lags, "`lags` belongs to `origins: all`", "add that, or leave it out");
    if (fit_from == nullptr || is_late(fit_from, *panel.fit_from, reading)) return;
    if (*panel.fit_from < panel.from)
        reading.errors.add(
            *fit_from,
            fmt::format("displacements are measured from {}, which is later", panel.from),
            "give a time from there on, or an earlier `from`");
}

double most_distance(const Box& box) {
    double nearest = INFINITY, longest = 0.0;
    for (int axis = 0; axis < box.dimension; ++axis) {
        if (box.is_periodic(axis)) nearest = std::min(nearest, 0.5 * box.length(axis));
        longest = std::max(longest, box.length(axis));
    }
    return std::min(nearest, longest);
}

void check_pair_correlation(PanelSpec& panel, const Node& node, Reading& reading) {
    const Box& box = reading.gas.box;
    const Node& place = node.is_mapping() ? *given(node, "kind") : node;
    if (!box.surfaces.partitions.empty() || !box.surfaces.obstacles.empty())
        reading.errors.add(
            place, "`pair-correlation` needs a box without partitions and obstacles",
            "leave it out, or remove these: with them its normalisation is not known exactly");
    if (panel.of.size() > 2)
        reading.errors.add(*given(node, "of"), "`of` takes at most two choices, for pairs",
                           "for more, add a panel for each pair");
    const Node* to = given(node, "to");
    if (to == nullptr || !(box.size[0] > 0.0) || *panel.to <= most_distance(box)) return;
    reading.errors.add(*to, "`to` is too large for this box",
                       fmt::format("give at most {}: half of a periodic side, or the longest side",
                                   most_distance(box)));
}

void check_autocorrelation(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!(reading.run.until > 0.0) || is_late(given(node, "from"), panel.from, reading)) return;
    check_lags(panel, node, reading);
}

void check_free_flights(PanelSpec& panel, const Node& node, Reading& reading) {
    const Node* over = given(node, "over");
    if (over == nullptr || !panel.over || panel.over->since != Over::Since::now) return;
    reading.errors.add(*over, "no free flight ends at a single moment",
                       "give `start`, or a time: {window: 5}");
}

void check_orientational_order(PanelSpec&, const Node& node, Reading& reading) {
    if (reading.gas.box.dimension == 2) return;
    reading.errors.add(node.is_mapping() ? *given(node, "kind") : node,
                       "beads on a line have no hexagonal order",
                       "give a box with a `size`, or another panel");
}

}  // namespace carom
