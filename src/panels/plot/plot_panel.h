// A panel that shows a plot: its picture, its table and its texts are all made from the plot of a
// state. What the panel has seen of a run is a record, which is a value; means and comparisons of
// runs are made by combining records.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "panels/shared_panel.h"
#include "util/archive.h"

namespace carom {

/// How much of a growing plot is shown, for each of its runs.
struct ShownState : PanelState {
    std::vector<std::size_t> shown;
};

class PlotPanel : public SharedPanel {
  public:
    /// The plot of a state. With nullptr: axes, notes and what is the same in every frame. May be
    /// called from any thread after fix_axes().
    virtual plot::Plot plot(const PanelState* state) const = 0;

    /// Sets words at the axes (plain text) instead of the panel's own; none: these.
    void set_axis_words(std::optional<std::string> x, std::optional<std::string> y);

    /// Sets the units in which its numbers are shown.
    void set_units(UnitSystem units) { units_ = units; }

    Room least_room() const override { return {8.0, 7.0}; }
    void draw_ground(Canvas& canvas, const DrawContext& dc) const final;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const final;
    Table table(const PanelState& state, const Theme& theme) const final;
    std::optional<Point> place_of(const DrawContext& dc, const PanelState& state,
                                  const PlotPoint& point) const final;
    std::string finding(const PanelState& state) const final { return plot(&state).finding; }
    std::string account(const PanelState& state) const final { return plot(&state).account; }

    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    std::vector<std::string> accounts_of_runs(const PanelState& state) const final {
        return plot(&state).accounts_of_runs;
    }

  private:
    /// The plot with the words that the scene gives.
    plot::Plot shown(const PanelState* state) const;
    std::optional<std::string> x_words_, y_words_;
    UnitSystem units_ = UnitSystem::reduced;

    /// The names of growing lines, placed once for all frames.
    std::shared_ptr<const plot::Plot> with_fixed_names(const DrawContext& dc) const;
    struct Names {
        std::mutex access = {};
        std::shared_ptr<const plot::Plot> plot = {};
        std::array<double, 5> place = {};
        const Theme* theme = nullptr;
    };
    mutable Names names_;
};

/// Whether mean_of() is defined for such records.
template <class Record>
concept HasMean = requires(std::vector<Record> records) {
    mean_of(std::move(records));
};

/// Shows what was recorded in the first pass: a plot, or another panel that can show several runs.
/// For a Record, compare(records, names) and, if HasMean, mean_of(records) must be defined; they
/// give the record of several runs.
template <class Record, class Base = PlotPanel>
class RecordPanel : public Base {
  public:
    void fix_axes() final {
        finish_record();
        make_axes();
    }
    void fix_axes_of_runs(const std::vector<Panel*>& others,
                          const std::vector<std::string>& names) final {
        finish_record();
        std::vector<Record> records{std::move(record_)};
        for (Panel* other : others) {
            auto& run = dynamic_cast<RecordPanel&>(*other);
            run.finish_record();
            records.push_back(run.record_);
        }
        if (!names.empty())
            record_ = compare(std::move(records), names);
        else if constexpr (HasMean<Record>)
            record_ = mean_of(std::move(records));
        else
            Base::fix_axes_of_runs(others, names);
        make_axes();
        for (Panel* other : others) dynamic_cast<RecordPanel&>(*other).take_axes(*this);
    }
    const Record& record() const { return record_; }

  protected:
    /// Called after the first pass of this run.
    virtual void finish_record() {}

    /// Fixes the axes from the record, which may be that of several runs.
    virtual void make_axes() = 0;

    /// Takes the axes of the panel `of`, which also shows the run of this panel: what its states
    /// depend on. None if that is nothing but the number of the frame.
    virtual void take_axes(const RecordPanel& of) { (void)of; }

    /// Panel::archive() of a panel all of whose axes follow from its record.
    void archive_record(Archive& archive) {
        archive(record_);
        if (archive.is_reading()) make_axes();
    }

    /// Shows what the panel `of` shows.
    void take_record(const RecordPanel& of) {
        record_ = of.record_;
        make_axes();
    }

    Record record_;
};

/// A RecordPanel whose record holds what all frames show: a state is the number of frames so far.
template <class Record>
class FramesPanel : public RecordPanel<Record> {
  public:
    std::shared_ptr<const PanelState> state(const FrameInput&) override {
        auto state = std::make_shared<ShownState>();
        state->shown = {++seen_};
        return state;
    }
    void archive_progress(Archive& archive) override { archive(seen_); }
    void archive(Archive& archive) override { this->archive_record(archive); }

  private:
    std::size_t seen_ = 0;
};

}  // namespace carom
