#include "panels/correlations/correlation_keys.h"

#include <fmt/format.h>

namespace carom {
namespace {

constexpr double usual_share = 0.1;  // of the measured time: the longest lag, unless given

}  // namespace

Binding<double> from_key() {
    return bind_value("from", number(not_negative, quantities::time),
                      "The simulated time from which displacements are measured, or velocities "
                      "compared.");
}

Binding<std::optional<double>> lags_key() {
    return bind_with<std::optional<double>>(
               "lags", [](std::optional<double>& lags, double longest) { lags = longest; },
               number(positive, quantities::time),
               "The longest time lag, between two velocities or, with `origins: all`, two "
               "positions.")
        .default_text("a tenth of the time from `from` to the end; a quarter for displacements");
}

bool is_late(const Node* key, double time, Reading& reading) {
    const double until = reading.run.until;
    if (key == nullptr || time < until) return false;
    reading.errors.add(*key, fmt::format("expected a time below {}", until),
                       fmt::format("the run ends at {}", until));
    return true;
}

void check_lags(std::optional<double> longest, double from, const Node& node, Reading& reading) {
    const Node* lags = given(node, "lags");
    const double span = reading.run.until - from;
    if (lags == nullptr || *longest <= span) return;
    reading.errors.add(*lags, fmt::format("`lags` is longer than the measured time of {}", span),
                       fmt::format("give at most {}, much less for a good mean", span));
}

double longest_lag(const DisplacementOptions& options, const Run& run) {
    const double share = options.all_origins ? 0.25 : usual_share;
    return options.lags.value_or(share * (run.until - options.from));
}

double longest_lag(const AutocorrelationOptions& options, const Run& run) {
    return options.lags.value_or(usual_share * (run.until - options.from));
}

}  // namespace carom
