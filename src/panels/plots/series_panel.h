// Numbers against time: lines that grow while their axis is the whole film's, with the reversals
// and the way back. Which numbers is given by the panel's own file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// A level that lines are compared with.
struct ReferenceLevel {
    std::string name;
    double value = 0.0;
};

/// What the lines show.
struct SeriesSubject {
    std::function<std::vector<double>(const FrameInput&)>
        measure;  ///< one number for each line, every frame of the first pass in order; NaN: none
    std::function<Color(std::size_t line, const Theme&)> color;
    std::function<std::string(const Theme&)> title;  ///< markup
    std::vector<std::string> notes =
        {};  ///< markup under the title: the first that is not cut, from the longest on
    std::function<std::optional<ReferenceLevel>()> reference = {};  ///< after the first pass
    std::optional<double> top = {};       ///< of the axis; none: as the run shows
    bool spreads = false;                 ///< over powers of ten, if need be
    std::string column = {};              ///< of a table, with its unit: "entropy (1)"
    std::vector<std::string> names = {};  ///< of the lines, in a table
    std::size_t compared = 0;             ///< the line that stands for a run beside others
    std::string compared_title = {};      ///< markup, of that line; empty: the title
};

class SeriesPanel : public Panel {
  public:
    SeriesPanel(const PanelContext& context, SeriesSubject subject);

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void settle_with(const std::vector<Panel*>& others) override;
    void settle_beside(const std::vector<Panel*>& others,
                       const std::vector<std::string>& names) override;
    std::shared_ptr<const PanelState> beside(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    std::vector<std::string> told_of_runs(const PanelState& state) const override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

    /// For tests: the numbers of a line, one for each frame surveyed; their errors, if means.
    const std::vector<double>& line(std::size_t index) const { return history_.lines[index]; }
    const std::vector<double>& errors(std::size_t index) const { return history_.errors[index]; }

  private:
    // Known whole after the first pass: a frame's state says how much of it to show.
    struct History {
        std::vector<double> time;                      // folded at reversals
        std::vector<int> leg;                          // reversals so far
        std::vector<std::vector<double>> lines;        // line x frame
        std::vector<std::vector<double>> errors = {};  // of means over several runs, or none
    };
    // How a line is drawn.
    struct Look {
        Color color;
        std::vector<double> dashes;
    };
    struct Scales;
    Scales scales(const DrawContext& dc) const;
    bool compares() const { return !names_.empty(); }
    std::vector<const History*> histories() const;
    std::vector<std::string> notes() const;
    double reference_value() const;
    bool rests_at_zero() const;
    Table table_of(const History& history, std::size_t shown,
                   const std::optional<ReferenceLevel>& reference) const;
    void tell_means(std::size_t runs);
    void draw_band(Canvas& canvas, const DrawContext& dc, std::size_t index,
                   std::size_t shown) const;
    void draw_reference(Canvas& canvas, const DrawContext& dc) const;
    void draw_levels(Canvas& canvas, const DrawContext& dc) const;
    bool is_crossed(const Rect& part, const DrawContext& dc) const;
    void draw_reversals(Canvas& canvas, const DrawContext& dc) const;
    Look look(std::size_t index, const DrawContext& dc) const;
    void draw_line(Canvas& canvas, const DrawContext& dc, const History& history, std::size_t index,
                   const Look& look, std::size_t shown) const;

    PanelContext context_;
    SeriesSubject subject_;
    History history_;
    std::size_t seen_ = 0;
    double low_ = 0.0, high_ = 1.0;            // of the vertical axis; powers of ten if logarithmic
    double first_ = 0.0, last_ = 1.0;          // of the time axis
    std::optional<ReferenceLevel> reference_;  // where runs side by side differ in it, none
    std::vector<std::string> names_ = {};      // of runs side by side, this one's first; or none
    std::vector<History> beside_ = {};         // of the other runs
    std::vector<ReferenceLevel> levels_ = {};  // of the runs, where they differ
    bool same_reversals_ = true;
    bool logarithmic_ = false;
};

}  // namespace carom
