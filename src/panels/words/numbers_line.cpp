// Numbers of a film in one line, which ends at the right: each after its name.
#include <algorithm>

#include "panels/registry.h"
#include "panels/words/monitors_panel.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double number_size = 4.0 / 3.0;                  // units
constexpr double between_numbers = 1.6, after_name = 0.4;  // units
constexpr double widest_share = 0.55;                      // of the line
constexpr std::size_t most_numbers = 2;

class NumbersLine : public MonitorsPanel {
  public:
    NumbersLine(const PanelContext& context, const std::vector<Monitor>& numbers)
        : MonitorsPanel(context, numbers) {}

    void draw_ground(Canvas&, const DrawContext&) const override {}
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Rect frame_in(const Rect& area, double unit) const override;
    std::vector<std::string> left_out(const DrawContext& dc) const override {
        return names_after(widths(dc.area, dc.unit).size());
    }

  private:
    std::vector<double> widths(const Rect& area, double unit) const;
    double width_of(Monitor number, double unit) const;
    double fitted(const Rect& area, double unit) const;
    TextStyle style_in(double unit, Color color) const {
        TextStyle style = style_of_numbers(number_size * unit, 400);
        style.color = color;
        style.align = Align::right;
        return style;
    }
    TextStyle name_style_in(double unit, Color color) const {
        TextStyle style = style_in(unit, color);
        style.lettering = Lettering::text;
        return style;
    }
};

// With its name.
double NumbersLine::width_of(Monitor number, double unit) const {
    const TextStyle style = style_in(unit, {});
    return measure_text(label(number), name_style_in(unit, {})).width + after_name * unit +
           measure_text(text(number, widest_value(number)), style).width;
}

// The unit with which the first number fits.
double NumbersLine::fitted(const Rect& area, double unit) const {
    return unit * std::min(1.0, area.width / width_of(numbers_.front(), unit));
}

// Of as many numbers as have room, at most two, beginning with the first.
std::vector<double> NumbersLine::widths(const Rect& area, double unit) const {
    std::vector<double> all;
    double sum = 0.0;
    for (const Monitor number : numbers_) {
        const double width = width_of(number, unit);
        sum += width + (all.empty() ? 0.0 : between_numbers * unit);
        if (!all.empty() && sum > widest_share * area.width) break;
        if (all.size() == most_numbers) break;
        all.push_back(width);
    }
    return all;
}

Rect NumbersLine::frame_in(const Rect& area, double unit) const {
    unit = fitted(area, unit);
    const std::vector<double> all = widths(area, unit);
    double sum = 0.0;
    for (const double width : all) sum += width;
    if (all.size() > 1) sum += between_numbers * unit * static_cast<double>(all.size() - 1);
    return {area.right() - sum, area.y, sum, area.height};
}

// From right to left, so that the last number ends at the edge, however many digits it has now.
void NumbersLine::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const MonitorsState&>(state);
    const double unit = fitted(dc.area, dc.unit);
    const double baseline = dc.area.y + 0.5 * dc.area.height + 0.36 * number_size * unit;
    double x = dc.area.right();
    for (std::size_t i = widths(dc.area, unit).size(); i-- > 0;) {
        const double number = now.readouts.at(index_of(numbers_[i]));
        if (is_absent(numbers_[i], number)) {
            x -= width_of(numbers_[i], unit) + between_numbers * unit;
            continue;
        }
        TextStyle style = style_in(unit, dc.theme.ink);
        const std::string value = text(numbers_[i], number);
        draw_text(canvas, {x, baseline}, value, style);
        x -= measure_text(value, style).width + after_name * unit;
        style = name_style_in(unit, dc.theme.muted);
        draw_text(canvas, {x, baseline}, label(numbers_[i]), style);
        x -= measure_text(label(numbers_[i]), style).width + between_numbers * unit;
    }
}

}  // namespace

std::unique_ptr<Panel> make_numbers_line(const PanelContext& context,
                                         const std::vector<Monitor>& numbers) {
    return std::make_unique<NumbersLine>(context, numbers);
}

}  // namespace carom
