// A plot's numbers as a table, and its words.
#include <algorithm>
#include <cmath>
#include <map>

#include "panels/plot/draw_plot.h"

namespace carom::plot {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Rows of one plot, or of one of the runs in it.
class Rows {
  public:
    Rows(const Plot& plot, std::optional<std::size_t> run, Table& table)
        : plot_(plot), run_(run), table_(table) {}

    void add(const AnyLayer& layer) {
        if (begins(common(layer))) std::visit([&](const auto& one) { rows_of(one); }, layer);
    }
    void add_numbers(const Layer& numbers) {
        if (begins(numbers)) rows_of(numbers);
    }

  private:
    // Whether the layer has rows here; prepares for them.
    bool begins(const Layer& layer) {
        if (layer.part.empty() || (run_ && layer.run && *layer.run != *run_)) return false;
        part_ = layer.part;
        of_ = layer.of;
        last_.clear();
        return true;
    }

    // A number, or none, in each of the columns by name.
    using Numbers = std::map<std::string, double>;

    void row(const Numbers& numbers) {
        std::vector<TableCell> cells;
        if (run_) cells.emplace_back(plot_.runs[*run_]);
        cells.emplace_back(part_);
        cells.emplace_back(of_);
        std::vector<double> values;
        for (const Heading& column : plot_.columns) {
            const auto found = numbers.find(column.name);
            values.push_back(found == numbers.end() ? none : found->second);
            cells.emplace_back();
            if (!std::isnan(values.back())) cells.back() = values.back();
        }
        if (is_repeated(values)) return;
        last_ = std::move(values);
        table_.rows.push_back(std::move(cells));
    }

    bool is_repeated(const std::vector<double>& values) const {
        return std::ranges::equal(values, last_, [](double a, double b) {
            return a == b || (std::isnan(a) && std::isnan(b));
        });
    }

    template <class Curve>
    void rows_of_curve(const Curve& curve, const Column* third = nullptr) {
        const std::size_t end = std::min(curve.shown.end, curve.x.size());
        for (std::size_t i = curve.shown.first; i < end; ++i) {
            if (std::isnan(curve.y[i])) continue;
            Numbers numbers{{curve.x.heading.name, curve.x[i]}, {curve.y.heading.name, curve.y[i]}};
            if (third != nullptr) numbers[third->heading.name] = (*third)[i];
            if constexpr (requires { curve.piece_column; })
                if (!curve.piece_column.name.empty())
                    numbers[curve.piece_column.name] = (*curve.piece)[i];
            for (const Column& more : curve.more) numbers[more.heading.name] = more[i];
            if constexpr (requires { curve.of_each; })
                if (!curve.of_each.empty()) of_ = curve.of_each[i];
            row(numbers);
        }
    }

    void rows_of(const Polyline& line) { rows_of_curve(line); }
    void rows_of(const Points& points) { rows_of_curve(points); }
    void rows_of(const Band& band) { rows_of_curve(band, &band.error); }
    void rows_of(const Bars& bars) {
        const std::size_t count = bars.value.size();
        for (std::size_t i = 0; i < count; ++i) {
            Numbers numbers{{bars.from.heading.name, bars.from[i]},
                            {bars.to.heading.name, bars.to[i]},
                            {bars.value.heading.name, bars.value[i]}};
            if (bars.error.size() > 0) numbers[bars.error.heading.name] = bars.error[i];
            row(numbers);
        }
        part_ = "below";
        row({{bars.to.heading.name, bars.from[0]}, {bars.value.heading.name, bars.below}});
        part_ = "above";
        row({{bars.from.heading.name, bars.to[count - 1]}, {bars.value.heading.name, bars.above}});
    }
    void rows_of(const Level& level) {
        for (const double x : {plot_.x.low, plot_.x.high}) {
            Numbers numbers{{level.x_column.name, x}, {level.column.name, level.value}};
            for (const Column& more : level.more) numbers[more.heading.name] = more[0];
            row(numbers);
        }
    }
    void rows_of(const Marker& marker) { row({{marker.column.name, marker.value}}); }
    void rows_of(const Layer& other) {
        for (std::size_t i = 0; !other.more.empty() && i < other.more.front().size(); ++i) {
            Numbers numbers;
            for (const Column& more : other.more) numbers[more.heading.name] = more[i];
            row(numbers);
        }
    }

    const Plot& plot_;
    std::optional<std::size_t> run_;
    Table& table_;
    std::string part_, of_;
    std::vector<double> last_;
};

}  // namespace

Table table_of(const Plot& plot) {
    Table table{.units = plot.units};
    if (!plot.runs.empty()) table.columns.push_back("run");
    table.columns.insert(table.columns.end(), {"part", "of"});
    table.columns.insert(table.columns.end(), plot.columns.begin(), plot.columns.end());
    for (std::size_t k = 0; k < std::max<std::size_t>(1, plot.runs.size()); ++k) {
        Rows rows(plot, plot.runs.empty() ? std::nullopt : std::optional(k), table);
        for (const AnyLayer& layer : plot.layers) rows.add(layer);
        for (const Layer& numbers : plot.numbers) rows.add_numbers(numbers);
    }
    return table;
}

}  // namespace carom::plot
