// A panel that shows a plot: what it draws, lists and says all comes from the plot of a state.
// What it has seen of a run is a record, a value; means and comparisons of runs combine records.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "util/archive.h"

namespace carom {

/// How much of a plot that grows is shown, of each of the runs in it.
struct ShownState : PanelState {
    std::vector<std::size_t> shown;
};

class PlotPanel : public Panel {
  public:
    /// The plot of a state; of none, its axes, its notes and what is the same in every frame. After
    /// fix_axes(), from any thread.
    virtual plot::Plot plot(const PanelState* state) const = 0;

    void draw_ground(Canvas& canvas, const DrawContext& dc) const final;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const final;
    Table table(const PanelState& state, const Theme& theme) const final;
    std::string finding(const PanelState& state) const final { return plot(&state).finding; }
    std::string account(const PanelState& state) const final { return plot(&state).account; }
    std::vector<std::string> told_of_runs(const PanelState& state) const final;

    /// Of states that are a ShownState; kinds with others combine these.
    std::shared_ptr<const PanelState> beside(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
};

/// Whether there are means of such records.
template <class Record>
concept HasMean = requires(std::vector<Record> records) {
    mean_of(std::move(records));
};

/// A plot of what was recorded in the first pass. For a Record there are mean_of(records) and
/// compare(records, names), which give the record of several runs.
template <class Record>
class RecordPanel : public PlotPanel {
  public:
    void fix_axes() final {
        finish_record();
        make_axes();
    }
    void settle_with(const std::vector<Panel*>& others) final {
        if constexpr (HasMean<Record>)
            join(others, [](std::vector<Record> records) { return mean_of(std::move(records)); });
        else
            Panel::settle_with(others);
    }
    void settle_beside(const std::vector<Panel*>& others,
                       const std::vector<std::string>& names) final {
        join(others,
             [&](std::vector<Record> records) { return compare(std::move(records), names); });
    }
    const Record& record() const { return record_; }

  protected:
    /// After the first pass of this run.
    virtual void finish_record() {}

    /// Fixes the axes by the record, which may be that of several runs.
    virtual void make_axes() = 0;

    /// Takes the axes of a panel that will show this one's run too.
    virtual void take_axes(const RecordPanel& of) { (void)of; }

    Record record_;

  private:
    template <class Combine>
    void join(const std::vector<Panel*>& others, const Combine& combine) {
        finish_record();
        std::vector<Record> records{std::move(record_)};
        for (Panel* other : others) {
            auto& run = dynamic_cast<RecordPanel&>(*other);
            run.finish_record();
            records.push_back(run.record_);
        }
        record_ = combine(std::move(records));
        make_axes();
        for (Panel* other : others) dynamic_cast<RecordPanel&>(*other).take_axes(*this);
    }
};

}  // namespace carom
