// The line of text under the box of one of several runs: its name and its numbers.
#include <algorithm>

#include "panels/plot/layers.h"
#include "panels/registry.h"
#include "panels/words/monitors_panel.h"
#include "scene/film.h"
#include "util/text.h"

namespace carom {
namespace {

// A name, and the numbers after it in one line, each in a place of its own.
class RunLinePanel : public MonitorsPanel {
  public:
    RunLinePanel(const PanelContext& context, const std::vector<Monitor>& numbers,
                 const std::vector<std::string>& labels, std::size_t run)
        : MonitorsPanel(context, numbers), labels_(labels), run_(run) {
        std::erase(numbers_, Monitor::time);
    }

    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    std::vector<std::string> left_out(const DrawContext& dc) const override {
        return names_after(line(dc).x.size());
    }

  private:
    // Where the numbers begin that have room, and the line.
    struct Line {
        std::vector<double> x;
        double y;
    };
    Line line(const DrawContext& dc) const;
    TextStyle name_style(const DrawContext& dc) const;
    void draw_name_of_number(Canvas& canvas, const DrawContext& dc, Point at, Monitor number) const;

    std::vector<std::string> labels_;  ///< of all runs
    std::size_t run_;
};

// A name has the colour of its run's lines, if there are plots.
TextStyle RunLinePanel::name_style(const DrawContext& dc) const {
    TextStyle style = title_style(dc);
    if (!context_.film().panels.empty())
        style.color = plot::color_of(plot::stroke_of_run(run_).role, dc.theme);
    style.max_width = dc.area.width;
    return style;
}

// The same in the lines of all runs, so that these show the same numbers at the same places: after
// the longest of the names.
RunLinePanel::Line RunLinePanel::line(const DrawContext& dc) const {
    constexpr double gap = 1.4, after_words = 0.4, least = 0.2;  // units
    const TextStyle style = label_style(dc);
    double longest = 0.0;
    for (const std::string& label : labels_)
        longest = std::max(longest, measure_text(escape_markup(label), name_style(dc)).width);
    double x = dc.area.x + longest + gap * dc.unit;
    Line line{{}, dc.area.y + 1.4 * dc.unit};
    for (const Monitor number : numbers_) {
        const double words = measure_text(label(number), style).width;
        const double end = x + words + after_words * dc.unit +
                           measure_text(text(number, widest_value(number)), style).width;
        if (end > dc.area.right() + least * dc.unit) break;
        line.x.push_back(x + words + after_words * dc.unit);
        x = end + gap * dc.unit;
    }
    return line;
}

void RunLinePanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const Line line = this->line(dc);
    draw_text(canvas, {dc.area.x, line.y}, escape_markup(labels_.at(run_)), name_style(dc));
    for (std::size_t i = 0; i < line.x.size(); ++i)
        if (!comes_and_goes(numbers_[i]))
            draw_name_of_number(canvas, dc, {line.x[i], line.y}, numbers_[i]);
}

// Before its number, which begins at `at`.
void RunLinePanel::draw_name_of_number(Canvas& canvas, const DrawContext& dc, Point at,
                                       Monitor number) const {
    constexpr double before_number = 0.4;  // units
    TextStyle style = label_style(dc);
    style.align = Align::right;
    draw_text(canvas, {at.x - before_number * dc.unit, at.y}, label(number), style);
}

void RunLinePanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const MonitorsState&>(state);
    const Line line = this->line(dc);
    TextStyle style = label_style(dc);
    style.color = dc.theme.ink;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        const double value = now.readouts.at(index_of(numbers_[i]));
        if (is_absent(numbers_[i], value)) continue;
        if (comes_and_goes(numbers_[i]))
            draw_name_of_number(canvas, dc, {line.x[i], line.y}, numbers_[i]);
        draw_text(canvas, {line.x[i], line.y}, text(numbers_[i], value), style);
    }
}

}  // namespace

std::unique_ptr<Panel> make_run_line(const PanelContext& context,
                                     const std::vector<Monitor>& numbers,
                                     const std::vector<std::string>& labels, std::size_t run) {
    return std::make_unique<RunLinePanel>(context, numbers, labels, run);
}

}  // namespace carom
