#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "runs/json.h"
#include "runs/number_json.h"
#include "runs/sweep_summary.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr const char* format_name = "carom-sweep-summary";
constexpr int format_version = 1;
constexpr const char* quantiles_in_words =
    "by linear interpolation between order statistics: of n sorted values x[0] to x[n-1] the value "
    "at the place p (n - 1)";

double number_of(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::string name_of_share(double share) { return fmt::format("{}", share); }

// Writes a value such as 0.15 as a JSON number; one that is not a number stays text.
Json value_of(const std::string& text) {
    const Json json = json_in(text);
    return json.is_number() ? json : Json(text);
}

Json to_json(const NumberStatistics& its, const Quantity& quantity) {
    const auto amount = [&](double value) { return Amount{value, quantity}; };
    Json quantiles = Json::object();
    for (std::size_t k = 0; k < quantile_shares.size(); ++k)
        quantiles[name_of_share(quantile_shares[k])] = amount(its.quantiles[k]);
    return {{"n", its.count},
            {"mean", amount(its.mean)},
            {"standard_error", amount(its.error)},
            {"standard_deviation", amount(its.deviation)},
            {"min", amount(its.least)},
            {"max", amount(its.most)},
            {"quantiles", std::move(quantiles)}};
}

NumberStatistics statistics_from(const Json& json) {
    NumberStatistics its{.count = whole_in<std::int64_t>(json.at("n")),
                         .mean = number_of(json.at("mean")),
                         .error = number_of(json.at("standard_error")),
                         .deviation = number_of(json.at("standard_deviation")),
                         .least = number_of(json.at("min")),
                         .most = number_of(json.at("max"))};
    for (std::size_t k = 0; k < quantile_shares.size(); ++k)
        its.quantiles[k] = number_of(json.at("quantiles").at(name_of_share(quantile_shares[k])));
    return its;
}

Json point_to_json(const SweepSummary& summary, std::size_t point) {
    const PointSummary& its = summary.points[point];
    const std::vector<std::string> values =
        summary.sweep.values_at(static_cast<std::int64_t>(point));
    Json at = Json::object(), numbers = Json::object();
    for (std::size_t k = 0; k < values.size(); ++k)
        at[summary.sweep.axes[k].key] = value_of(values[k]);
    for (std::size_t k = 0; k < its.numbers.size(); ++k)
        numbers[summary.numbers[k].name] = to_json(its.numbers[k], summary.numbers[k].quantity);
    return {{"values", std::move(at)}, {"runs", its.runs}, {"numbers", std::move(numbers)}};
}

Json to_json(const SweepSummary& summary) {
    Json build = Json::object(), axes = Json::array(), numbers = Json::array(),
         points = Json::array();
    for (const auto& [name, value] : summary.build) build[name] = value;
    for (const SweepAxis& axis : summary.sweep.axes)
        axes.push_back(Json{{"key", axis.key}, {"values", axis.values}});
    for (const RunNumber& number : summary.numbers) numbers.push_back(to_json(number));
    for (std::size_t k = 0; k < summary.points.size(); ++k)
        points.push_back(point_to_json(summary, k));
    const SeedRange& seeds = summary.sweep.seeds;
    return {{"format", format_name},
            {"format_version", format_version},
            {"carom", summary.carom},
            {"build", std::move(build)},
            {"scene", summary.scene},
            {"title", summary.title},
            {"overrides", summary.overrides},
            {"physics", summary.physics},
            {"seeds", {{"first", seeds.first}, {"last", seeds.last}}},
            {"axes", std::move(axes)},
            {"runs", summary.sweep.runs()},
            {"units", words_of(UnitSystem::reduced)},
            {"quantiles", quantiles_in_words},
            {"numbers", std::move(numbers)},
            {"points", std::move(points)}};
}

PointSummary point_from(const Json& json, const std::vector<RunNumber>& numbers) {
    PointSummary point{.runs = whole_in<std::int64_t>(json.at("runs"))};
    for (const RunNumber& number : numbers)
        point.numbers.push_back(statistics_from(json.at("numbers").at(number.name)));
    return point;
}

SweepSummary summary_from(const Json& json) {
    SweepSummary summary{.carom = json.at("carom"),
                         .scene = json.at("scene"),
                         .title = json.at("title"),
                         .overrides = json.at("overrides"),
                         .physics = json.at("physics")};
    for (const auto& [name, value] : json.at("build").items())
        summary.build.emplace_back(name, value.get<std::string>());
    const Json& seeds = json.at("seeds");
    summary.sweep.seeds = {whole_in<std::uint64_t>(seeds.at("first")),
                           whole_in<std::uint64_t>(seeds.at("last"))};
    for (const Json& axis : json.at("axes"))
        summary.sweep.axes.push_back({axis.at("key"), axis.at("values")});
    check_sweep(summary.sweep);
    for (const Json& number : json.at("numbers"))
        summary.numbers.push_back(run_number_from(number));
    for (const Json& point : json.at("points"))
        summary.points.push_back(point_from(point, summary.numbers));
    return summary;
}

}  // namespace

std::string text_of(const SweepSummary& summary) { return text_of(to_json(summary), 1) + "\n"; }

SweepSummary sweep_summary(std::string_view text, const std::string& name) {
    const Json json = json_in(text);
    const auto refuse = [&](const std::string& cause) {
        throw SystemError(fmt::format("cannot read {}: {}", name, cause));
    };
    if (!json.is_object() || json.value("format", Json()) != format_name)
        refuse("this is not the summary of a sweep (carom join SWEEP -o summary.json writes one)");
    if (json.value("format_version", Json()) != format_version)
        refuse(fmt::format("its format is not version {}", format_version));
    try {
        SweepSummary summary = summary_from(json);
        if (std::ssize(summary.points) != summary.sweep.points()) refuse("points are missing");
        return summary;
    } catch (const Json::exception& error) {
        refuse(fmt::format("it was changed after it was written ({})", cause_of(error)));
    } catch (const SweepError& error) {
        refuse(fmt::format("it was changed after it was written ({})", error.what()));
    }
    throw std::logic_error("a summary is read or refused");
}

}  // namespace carom
