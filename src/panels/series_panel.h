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
    std::function<std::vector<double>(const Observation&)>
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
};

class SeriesPanel : public Panel {
  public:
    SeriesPanel(const Cast& cast, SeriesSubject subject);

    void survey(const Observation& observation) override;
    void settle() override;
    void settle_with(const std::vector<Panel*>& others) override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;
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
    struct Scales;
    Scales scales(const Page& page) const;
    double reference_value() const;
    void tell_means(std::size_t runs);
    void draw_band(Canvas& canvas, const Page& page, std::size_t index, std::size_t shown) const;
    void draw_reference(Canvas& canvas, const Page& page) const;
    bool is_crossed(const Rect& part, const Page& page) const;
    void draw_reversals(Canvas& canvas, const Page& page) const;
    void draw_line(Canvas& canvas, const Page& page, std::size_t index, std::size_t shown) const;

    Cast cast_;
    SeriesSubject subject_;
    History history_;
    std::size_t seen_ = 0;
    double low_ = 0.0, high_ = 1.0;    // of the vertical axis; powers of ten if logarithmic
    double first_ = 0.0, last_ = 1.0;  // of the time axis
    std::optional<ReferenceLevel> reference_;
    bool logarithmic_ = false;
};

}  // namespace carom
