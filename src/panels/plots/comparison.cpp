#include "panels/plots/comparison.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include "draw/palette.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double sample_width = 2.6, sample_gap = 0.5, entry_gap = 1.5;  // units
constexpr double line_width = 0.16;                                      // units

struct Entry {
    Point at;  ///< of its sample, from the first row's left end
    double width;
};

double width_of(const DrawContext& dc, const std::string& name) {
    const double words = measure_text(escape_markup(name), label_style(dc)).width;
    return std::min(dc.area.width, (sample_width + sample_gap) * dc.unit + words);
}

// One after the other, in as many rows as they need.
std::vector<Entry> places(const DrawContext& dc, const std::vector<std::string>& names) {
    std::vector<Entry> entries;
    double x = 0.0, y = 0.0;
    for (const std::string& name : names) {
        const double width = width_of(dc, name);
        if (x > 0.0 && x + width > dc.area.width) {
            x = 0.0;
            y += note_height * dc.unit;
        }
        entries.push_back({{x, y}, width});
        x += width + entry_gap * dc.unit;
    }
    return entries;
}

}  // namespace

Color compared_color(std::size_t run, const Theme& theme) {
    const std::array ground{theme.page};
    return toward_ink(kind_color(run, theme), theme, ground, least_contrast_of_marks);
}

std::vector<double> compared_dashes(std::size_t run, const DrawContext& dc) {
    static const std::array<std::vector<double>, 6> patterns{{{},
                                                              {0.8, 0.4},
                                                              {0.2, 0.25},
                                                              {0.9, 0.3, 0.2, 0.3},
                                                              {1.6, 0.4},
                                                              {0.9, 0.25, 0.2, 0.25, 0.2, 0.25}}};
    std::vector<double> dashes = patterns.at(run % patterns.size());
    for (double& length : dashes) length *= dc.unit;
    return dashes;
}

int key_rows(const DrawContext& dc, const std::vector<std::string>& names) {
    if (names.empty()) return 0;
    return 1 + static_cast<int>(places(dc, names).back().at.y / (note_height * dc.unit) + 0.5);
}

void draw_key_of_runs(Canvas& canvas, const DrawContext& dc, Point at,
                      const std::vector<std::string>& names) {
    const double u = dc.unit;
    const std::vector<Entry> entries = places(dc, names);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const Point left{at.x + entries[k].at.x, at.y + entries[k].at.y};
        const Color color = compared_color(k, dc.theme);
        canvas.stroke_path(std::array{Point{left.x, left.y - 0.35 * u},
                                      Point{left.x + sample_width * u, left.y - 0.35 * u}},
                           line_width * u, color, compared_dashes(k, dc));
        TextStyle style = label_style(dc);
        style.color = legible(color, dc.theme);
        style.max_width = entries[k].width - (sample_width + sample_gap) * u + 0.1 * u;
        draw_text(canvas, {left.x + (sample_width + sample_gap) * u, left.y},
                  escape_markup(names[k]), style);
    }
}

void add_table_of_run(Table& all, const std::string& run, Table one) {
    one.columns.insert(one.columns.begin(), "run");
    all.columns = std::move(one.columns);
    for (std::vector<Cell>& row : one.rows) {
        std::vector<Cell>& named = all.rows.emplace_back();
        named.reserve(row.size() + 1);
        named.emplace_back(run);
        std::ranges::move(row, std::back_inserter(named));
    }
}

}  // namespace carom
