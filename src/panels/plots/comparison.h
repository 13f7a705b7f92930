// Several runs in one panel. Those that a figure compares: how their lines are told apart, by
// colour and by dashes in every theme, and the key of them over the plot.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// This panel and those of the other runs, which are of its kind.
template <class Kind>
std::vector<Kind*> runs_of(Kind& first, const std::vector<Panel*>& others) {
    std::vector<Kind*> runs{&first};
    for (Panel* other : others) runs.push_back(&dynamic_cast<Kind&>(*other));
    return runs;
}

/// The state of several runs, each of which is told by one number: how much of it is shown.
template <class State>
std::shared_ptr<const PanelState> shown_of_each(
    const std::vector<std::shared_ptr<const PanelState>>& states) {
    auto all = std::make_shared<State>();
    for (const auto& state : states)
        all->shown.push_back(static_cast<const State&>(*state).shown.front());
    return all;
}

/// The colour of a run's line, to be seen on the page of the theme.
Color compared_color(std::size_t run, const Theme& theme);

/// How its line is dashed; empty: it is solid.
std::vector<double> compared_dashes(std::size_t run, const DrawContext& dc);

/// The rows that the key of these runs (plain words) takes in a panel's width.
int key_rows(const DrawContext& dc, const std::vector<std::string>& names);

/// Draws the key, a sample of its line before each name; `at` is the left end of the first row's
/// baseline.
void draw_key_of_runs(Canvas& canvas, const DrawContext& dc, Point at,
                      const std::vector<std::string>& names);

/// The table of a run with its name in a first column, under those of the runs before it.
void add_table_of_run(Table& all, const std::string& run, Table one);

}  // namespace carom
