#include "app/report/run_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json vector(const std::vector<std::optional<double>>& components) {
    Json list = Json::array();
    for (const auto& component : components) list.push_back(number(component));
    return list;
}

Json histogram(const BinnedCounts& bins) {
    return {{"edges", bins.edges}, {"counts", bins.counts}};
}

Json collisions(const RunReport& report) {
    const double of_each = 2.0 * static_cast<double>(report.collisions.particle) /
                           static_cast<double>(report.particles);
    return {{"particle", report.collisions.particle},
            {"wall", report.collisions.wall},
            {"per_particle", number(of_each)}};
}

Json species(const Scene& scene, const RunSummary& summary) {
    Json list = Json::array();
    for (std::size_t s = 0; s < summary.species.size(); ++s)
        list.push_back({{"name", scene.gas.species[s].name},
                        {"count", summary.species[s].count},
                        {"mean_energy", number(summary.species[s].energy)},
                        {"mean_speed", number(summary.species[s].speed)}});
    return list;
}

Json reversal(const ReversalReport& report, int bits) {
    const auto& distance = report.distance;
    const auto length = [&](double ReturnDistance::*member) {
        return distance ? number((*distance).*member) : Json(nullptr);
    };
    return {{"at", report.at},
            {"bits", bits},
            {"largest_return_distance", length(&ReturnDistance::largest)},
            {"root_mean_square", length(&ReturnDistance::root_mean_square)},
            {"log10_largest_return_distance", length(&ReturnDistance::log10_largest)},
            {"log10_root_mean_square", length(&ReturnDistance::log10_root_mean_square)},
            {"events",
             {{"out", report.events_out},
              {"back", report.events_back ? Json(*report.events_back) : Json(nullptr)}}}};
}

Json reversals(const RunReport& report) {
    Json list = Json::array();
    for (const ReversalReport& one : report.reversals) list.push_back(reversal(one, report.bits));
    return list;
}

Json seconds(const RunReport& report) {
    const auto events = static_cast<double>(report.collisions.particle + report.collisions.wall);
    return {{"total", report.seconds.total},
            {"events_per_second", number(events / report.seconds.simulate)}};
}

Json whole(const Scene& scene, const RunReport& report) {
    const RunSummary& s = report.summary;
    return {
        {"carom", CAROM_VERSION},
        {"scene", scene.source.path},
        {"seed", scene.seed},
        {"dimension", scene.gas.box.dimension},
        {"particles", report.particles},
        {"time", scene.run.until},
        {"precision_bits", report.bits},
        {"collisions", collisions(report)},
        {"energy",
         {{"initial", number(s.energy_initial)},
          {"final", number(s.energy_final)},
          {"largest_relative_error", number(s.largest_energy_error)}}},
        {"momentum",
         {{"initial", vector(s.momentum_initial)}, {"final", vector(s.momentum_final)}}},
        {"overlap", {{"largest_relative", number(s.largest_overlap)}}},
        {"pressure", {{"wall", number(s.wall_pressure)}, {"virial", number(s.virial_pressure)}}},
        {"temperature", number(s.temperature)},
        {"species", species(scene, s)},
        {"histograms", {{"speed", histogram(s.speeds)}, {"energy", histogram(s.energies)}}},
        {"reversals", reversals(report)},
        {"seconds", seconds(report)}};
}

}  // namespace

// A line for each key: long lists of numbers do not fill the screen.
std::string run_json(const Scene& scene, const RunReport& report) {
    constexpr int no_indent = -1;
    constexpr bool ascii_only = false;
    std::string text = "{\n";
    const Json object = whole(scene, report);
    const auto dump = [](const Json& json) {  // a path may hold bytes that are no UTF-8
        return json.dump(no_indent, ' ', ascii_only, Json::error_handler_t::replace);
    };
    for (auto item = object.begin(); item != object.end(); ++item) {
        if (item != object.begin()) text += ",\n";
        text += "  " + dump(item.key()) + ": " + dump(item.value());
    }
    return text + "\n}\n";
}

}  // namespace carom
