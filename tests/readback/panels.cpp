// For every kind of panel: checks that the numbers read from its picture are those of its table.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>

#include "readback/checks.h"
#include "support/files.h"
#include "support/test_root.h"

using namespace carom::test;

namespace {

using Check = std::function<Problems(const DrawnFigure&)>;

Check plot(PlotColumns columns) {
    return [columns](const DrawnFigure& figure) { return plot_problems(figure, columns); };
}

// The check of each figure in docs/panels/; a figure has the name of its kind.
const std::map<std::string, Check>& checks() {
    static const std::map<std::string, Check> all{
        {"speed-histogram",
         plot({"speed from (length/time)", "value (count)", "speed to (length/time)"})},
        {"energy-histogram", plot({"energy from (mass length^2/time^2)", "value (count)",
                                   "energy to (mass length^2/time^2)"})},
        {"velocity-histogram", plot({"velocity along x from (length/time)", "value (count)",
                                     "velocity along x to (length/time)"})},
        {"position-histogram",
         plot({"position along y from (length)", "value (count)", "position along y to (length)"})},
        {"energy-by-species", plot({"time (time)", "mean energy (mass length^2/time^2)"})},
        {"speed-classes", plot({"time (time)", "share (per cent)"})},
        {"temperature", plot({"time (time)", "temperature (mass length^2/time^2)"})},
        {"entropy", plot({"time (time)", "entropy (1)"})},
        {"pressure", plot({"time (time)", "pressure (mass/time^2)"})},
        {"thermometer", thermometer_problems},
        {"stopwatch", needle_problems},
        {"counter", counter_problems},
        {"pressure-volume", plot({"area (length^2)", "pressure (mass/time^2)"})},
        {"piston", plot({"time (time)", "position (length)"})},
        {"piston-histogram",
         plot({"position from (length)", "share (per cent)", "position to (length)"})},
        {"sides", plot({"time (time)", "particles (1)"})},
        {"flux", plot({"time (time)", "crossing rate (1/time)"})},
        {"energy-account",
         [](const DrawnFigure& figure) {
             return stack_problems(figure, {"time (time)", "energy (mass length^2/time^2)"});
         }},
        {"particle-speed", plot({"time (time)", "speed (length/time)"})},
        {"mean-free-path", plot({"time (time)", "mean free path (length)"})},
        {"halves", plot({"time (time)", "energy (mass length^2/time^2)"})},
        {"mean-squared-displacement",
         plot({"time (time)", "mean squared displacement (length^2)"})},
        {"velocity-autocorrelation", plot({"time lag (time)", "velocity autocorrelation (1)"})},
        {"pair-correlation",
         plot({"distance from (length)", "pair correlation (1)", "distance to (length)"})},
        {"free-path",
         plot({"free path from (length)", "share (per cent)", "free path to (length)", true})},
        {"free-time", plot({"free time from (time)", "share (per cent)", "free time to (time)"})},
        {"orientational-order", plot({"time (time)", "hexagonal order (1)"})},
        {"return-distance",
         plot({"collisions of each (count)", "log10 of distance", "", false, true})},
        {"run-distance", plot({"time (time)", "log10 of distance", "", false, true})},
        {"profile", plot({"density (1/length^2)", "y (length)"})},
        {"phase", plot({"position (length)", "velocity (length/time)"})},
        {"positions", plot({"position of particle 0 (length)", "position of particle 1 (length)"})},
        {"monitors", monitor_problems},
        {"single-collision", collision_problems},
        {"contact-time", plot({"time (time)", "squared distance (length^2)"})},
        {"collision-map",
         plot({"sqrt(m1) v1 (mass^0.5 length/time)", "sqrt(m0) v0 (mass^0.5 length/time)"})},
        {"text",  // has no numbers, and so no table
         [](const DrawnFigure& figure) {
             return text_problems(figure, "In equilibrium the speeds have the distribution");
         }},
        {"sweep", plot({"packing fraction", "virial pressure (energy/area)"})},
        {"gas", [](const DrawnFigure& figure) { return gas_problems(figure, 60.0, 40.0); }},
    };
    return all;
}

const std::filesystem::path set = checkout() / "docs" / "panels" / "panels.yaml";

const std::map<std::string, DrawnFigure>& gallery() {
    static const std::map<std::string, DrawnFigure> all = figures_of(set);
    return all;
}

// The set is generated from the registry of kinds; a test of the scene language checks that it is
// up to date.
std::vector<std::string> kinds() {
    std::vector<std::string> all;
    std::istringstream lines(contents(set));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  - ") && line.ends_with(".yaml"))
            all.push_back(line.substr(4, line.size() - 9));
    return all;
}

// Whether a column is shown in the picture; `others` lists those that are not.
bool is_read(const std::string& kind, const std::string& column) {
    static const std::multimap<std::string, std::string> others{
        {"collision-map", "step (number)"},  // the order of the steps
        {"collision-map", "time (time)"},
        {"collision-map", "coefficient of sqrt(m1) v1 (number)"},
        {"collision-map", "coefficient of sqrt(m0) v0 (number)"},
        {"contact-time", "r.v (length^2/time)"},
        {"contact-time", "v.v (length^2/time^2)"},
        {"return-distance", "reversal (number)"},
        {"return-distance", "since the reversal (time)"},  // the axis shows collisions instead
        {"return-distance", "distance (length)"},          // it shows logarithms
        {"sweep", "runs"},                                 // stands in the caption
    };
    if (column == "part" || column == "of" || column == "particle" || column == "piece (number)")
        return false;
    const auto [first, last] = others.equal_range(kind);
    return std::none_of(first, last, [&](const auto& other) { return other.second == column; });
}

// A copy of the figure with a larger number in one row: the one at the rank `rank`, from 0 (lowest)
// to 1.
std::optional<DrawnFigure> changed(DrawnFigure figure, const std::string& column, double rank) {
    std::vector<std::pair<double, std::string*>> numbers;
    for (Row& row : figure.table) {
        std::string& cell = row.at(column);
        const bool is_number =
            !cell.empty() && cell.find_first_not_of("+-.0123456789e") == std::string::npos;
        if (is_drawn(row) && is_number && std::stod(cell) != 0.0)
            numbers.emplace_back(std::abs(std::stod(cell)), &cell);
    }
    if (numbers.empty()) return {};
    std::ranges::sort(numbers);
    const double last = static_cast<double>(numbers.size() - 1);
    std::string& cell = *numbers[static_cast<std::size_t>(rank * last)].second;
    const double factor = column.starts_with("standard ") ? 4.0 : 1.2;  // errors are small
    cell = std::to_string(std::stod(cell) * factor);
    return figure;
}

// Does not throw: a picture that cannot be read counts as a problem, too.
Problems problems_of(const DrawnFigure& figure, const Check& check) {
    try {
        return check(figure);
    } catch (const std::exception& error) {
        return {figure.name + ": " + error.what()};
    }
}

}  // namespace

TEST_CASE("every kind of panel is read back") {
    for (const std::string& kind : kinds()) {
        CAPTURE(kind);
        CHECK(checks().contains(kind));
        CHECK(gallery().contains(kind));
    }
    CHECK(checks().size() == kinds().size());
}

TEST_CASE("the numbers of each picture are those of its table, within half a pixel") {
    for (const auto& [kind, check] : checks())
        for (const std::string& problem : problems_of(gallery().at(kind), check)) {
            MESSAGE(problem);
            CHECK(problem.empty());
        }
}

TEST_CASE("a wrong number in a table, of any column, is seen in the picture") {
    std::size_t columns = 0;
    for (const auto& checked : checks()) {
        const auto& kind = checked.first;
        const auto& check = checked.second;
        const DrawnFigure& figure = gallery().at(kind);
        if (figure.table.empty()) continue;
        for (const auto& in_row : figure.table.front()) {
            const auto& column = in_row.first;
            if (!is_read(kind, column)) continue;
            if (!changed(figure, column, 0.0)) continue;  // text
            CAPTURE(kind);
            CAPTURE(column);
            // Two are tried, as some numbers lie beyond the axes and some on a straight line
            // between others.
            const bool is_seen = std::ranges::any_of(std::array{0.7, 1.0}, [&](double rank) {
                return !problems_of(*changed(figure, column, rank), check).empty();
            });
            CHECK(is_seen);
            ++columns;
        }
    }
    CHECK(columns > 2 * 30);
}
