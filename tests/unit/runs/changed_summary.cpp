// The summary of a sweep, changed by others: it is refused with a message, whatever it holds.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "runs/json.h"
#include "runs/sweep_summary.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

std::string summary(const std::string& pointer, const Json& value) {
    const NumberStatistics its{.count = 2, .mean = 1.5};
    Json json = json_in(text_of(SweepSummary{.sweep = {{{"gas.0.radius", {"1", "2"}}}, {1, 2}},
                                             .numbers = {{"pressure", quantities::number}},
                                             .points = {{2, {its}}, {2, {its}}}}));
    json[Json::json_pointer(pointer)] = value;
    return text_of(json);
}

const Json huge = 1e300, large = 9223372036854775807;

}  // namespace

TEST_CASE("the summary of a sweep that cannot be is refused") {
    CHECK_NOTHROW(sweep_summary(summary("/title", "T"), "summary.json"));
    for (const auto& change :
         std::vector<std::pair<std::string, Json>>{{"/seeds/first", -1},
                                                   {"/seeds/last", large},
                                                   {"/seeds/last", huge},
                                                   {"/axes/0/values", Json::array()},
                                                   {"/points/0/runs", huge},
                                                   {"/points/0/numbers/pressure/n", huge}}) {
        const std::string& pointer = change.first;
        CAPTURE(pointer);
        CHECK_THROWS_AS(sweep_summary(summary(pointer, change.second), "summary.json"),
                        SystemError);
    }
}
