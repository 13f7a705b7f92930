// Whether the numbers of every kind of panel say what they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "figures/figure_drawing.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "support/figure_run.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;

namespace {

// Columns of texts, of numbers of particles, and of numbers whose unit stands beside them.
const std::set<std::string> without_quantity{
    "part",    "of",     "run",   "runs",  "stage",          "arrow", "particle",
    "species", "colour", "label", "value", "standard error", "unit",  "packing fraction"};

Scene scene_of_manual(const std::string& kind) {
    return load_scene((test::checkout() / "docs/panels" / (kind + ".yaml")).string(),
                      test::resources());
}

}  // namespace

TEST_CASE("each column of numbers has a quantity, and each unit in a table is that of one") {
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        const Scene scene = scene_of_manual(kind.name);
        const FigureRun run = test::run_of(scene);
        const Table table = table_of(run.figures().front());
        std::set<std::string> names;
        for (const Heading& column : table.columns) {
            CAPTURE(column.name);
            CHECK(names.insert(column.name).second);
            CHECK((column.quantity || without_quantity.contains(column.name)));
        }
        const auto unit = std::ranges::find(table.columns, "unit", &Heading::name);
        if (unit == table.columns.end()) continue;
        for (const std::vector<TableCell>& row : table.rows) {
            const TableCell& cell = row[std::size_t(unit - table.columns.begin())];
            CHECK(quantity_with_unit(std::get<std::string>(cell), table.units));
        }
    }
}

TEST_CASE("what an axis shows is in a column of the table, with the same quantity") {
    int plots = 0;
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        const Scene scene = scene_of_manual(kind.name);
        const FigureRun run = test::run_of(scene);
        const Figure& figure = run.figures().front();
        const auto* panel = dynamic_cast<const PlotPanel*>(figure.panel);
        if (panel == nullptr) continue;
        ++plots;
        const plot::Plot plot = panel->plot(figure.moments.back().state.get());
        for (const plot::Axis* axis : {&plot.x, &plot.y}) {
            if (kind.name == "sweep" && axis == &plot.x) continue;  // any key of the scene
            REQUIRE(axis->quantity);
            const Quantity shown = axis->quantity->named({});
            CHECK(std::ranges::any_of(plot.columns, [&](const Heading& column) {
                return column.quantity && column.quantity->named({}) == shown;
            }));
        }
    }
    CHECK(plots > 20);
}

TEST_CASE("the unit of a sweep's number is written by its name, and none of one that is counted") {
    for (const auto& [number, column] :
         {std::pair{"particle collisions", "particle collisions"},
          {"temperature", "temperature (energy)"},
          {"largest overlap", "largest overlap (contact distances)"}}) {
        const Scene scene = test::scene_from(
            "title: T\nbox: {size: [20, 20]}\ngas: [{count: 10, radius: 0.3, temperature: 1}]\n"
            "run: {until: 1}\nfigures:\n  - {name: s, kind: sweep, vary: 'gas.0.count=5:10:2', "
            "number: " +
            std::string(number) + "}\n");
        const FigureRun run = test::run_of(scene);
        const std::vector<std::string> names = column_names(table_of(run.figures().front()));
        CHECK(names.at(3) == column);
        CHECK(names.at(4) == std::string("standard error of ") + column);
    }
}
