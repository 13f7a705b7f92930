#include "readback/figures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/csv.h"
#include "support/process.h"

namespace carom::test {
namespace {

std::vector<Row> table_of(const std::string& text) {
    std::vector<Row> rows;
    const auto lines = quoted_rows(text);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        Row& row = rows.emplace_back();
        for (std::size_t k = 0; k < lines[0].size(); ++k) row[lines[0][k]] = lines[i].at(k);
    }
    return rows;
}

// The lines of the axes: they are drawn as filled rectangles on whole pixels.
std::vector<Edges> thin_rectangles(const SvgPicture& picture, bool is_level) {
    constexpr double widest = 1.5;
    std::vector<Edges> thin;
    for (const Shape& shape : picture.shapes) {
        const auto edges = shape.is_stroke ? std::nullopt : shape.rectangle();
        if (edges && (is_level ? edges->height() : edges->width()) <= widest)
            thin.push_back(*edges);
    }
    return thin;
}

// Of an axis and its ticks.
constexpr double near = 1.6, longest_tick = 6.0, shortest_axis = 60.0;  // pixels
constexpr double beside = 20.0;                                         // from a tick to its number

Edges first_longer(const std::vector<Edges>& thin) {
    const auto found = std::ranges::find_if(
        thin, [](const Edges& one) { return std::max(one.width(), one.height()) > shortest_axis; });
    if (found == thin.end()) throw std::runtime_error("no axis");
    return *found;
}

// Adds a tick with the number nearest to it, if that is nearer than `most`.
template <class Distance>
void add_tick(std::vector<Tick>& ticks, double at, const std::vector<Said>& texts, double most,
              const Distance& distance) {
    std::optional<double> value;
    for (const Said& text : texts) {
        const std::optional<double> number = number_in(text.words);
        if (!number || !(distance(text.ink) < most)) continue;
        most = distance(text.ink);
        value = number;
    }
    if (value) ticks.push_back({at, *value});
}

}  // namespace

std::map<std::string, DrawnFigure> figures_of(const std::filesystem::path& set) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run({CAROM_PROGRAM, "figures", set.string(), "-o", (folder.path() / "drawn").string(),
             "--formats", "svg,csv", "--quiet"});
    if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
    std::map<std::string, DrawnFigure> figures;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "drawn")) {
        std::filesystem::path file = entry.path();
        if (file.extension() != ".svg") continue;
        const std::string name = file.stem().string();
        DrawnFigure& figure = figures[name];
        figure = {name, svg_picture(file)};
        if (std::filesystem::exists(file.replace_extension(".csv")))
            figure.table = table_of(contents(file));
    }
    return figures;
}

std::vector<Row> samples_of(const std::filesystem::path& scene, std::size_t count) {
    const Outcome outcome = run({CAROM_PROGRAM, "run", scene.string(), "--csv", "-", "--quiet"});
    if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
    const std::vector<Row> all = table_of(outcome.out);
    return {all.end() - static_cast<std::ptrdiff_t>(count), all.end()};
}

std::vector<Row> rows_of(const DrawnFigure& figure, const std::string& part) {
    std::vector<Row> some;
    std::ranges::copy_if(figure.table, std::back_inserter(some),
                         [&](const Row& row) { return row.at("part") == part; });
    return some;
}

double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

std::vector<Said> texts_of(const SvgPicture& picture) {
    static const Alphabet alphabet;
    std::vector<Said> texts;
    for (const Letters& letters : picture.texts)
        texts.push_back({alphabet.read(letters), letters.edges()});
    return texts;
}

std::vector<Tick> ticks_up(const SvgPicture& picture) {
    const std::vector<Said> texts = texts_of(picture);
    const double axis = first_longer(thin_rectangles(picture, false)).left;
    std::vector<Tick> ticks;
    for (const Edges& tick : thin_rectangles(picture, true))
        if (tick.width() < longest_tick && std::abs(tick.right - axis) < near)
            add_tick(ticks, tick.middle().y, texts, near, [&](const Edges& ink) {
                return ink.right < tick.left ? std::abs(ink.middle().y - tick.middle().y)
                                             : INFINITY;
            });
    return ticks;
}

DrawnAxes axes_of(const SvgPicture& picture) {
    const std::vector<Said> texts = texts_of(picture);
    const std::vector<Edges> upright = thin_rectangles(picture, false);
    const Edges x_axis = first_longer(thin_rectangles(picture, true)),
                y_axis = first_longer(upright);
    DrawnAxes axes;
    axes.lines = {x_axis.left, y_axis.top, x_axis.right, y_axis.bottom};
    axes.up = ticks_up(picture);
    for (const Edges& tick : upright)
        if (tick.height() < longest_tick && std::abs(tick.top - x_axis.top) < near)
            add_tick(axes.across, tick.middle().x, texts, beside, [&](const Edges& ink) {
                const bool is_below = ink.top > tick.bottom && ink.top < tick.bottom + beside;
                return is_below ? std::abs(ink.middle().x - tick.middle().x) : INFINITY;
            });
    if (axes.across.size() < 2 || axes.up.size() < 2)
        throw std::runtime_error("an axis without numbers");
    return axes;
}

LinearMap fitted(const std::vector<Tick>& ticks, const std::vector<Pair>& pairs) {
    constexpr double weight_of_ticks = 1e-3;
    double all = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto middle = [&](const std::vector<Tick>& some, double weight) {
        for (const Tick& one : some) all += weight, x += weight * one.value, y += weight * one.at;
    };
    middle(ticks, weight_of_ticks);
    middle(pairs, 1.0);
    x /= all, y /= all;
    const auto spread = [&](const std::vector<Tick>& some, double weight) {
        for (const Tick& one : some) {
            xx += weight * (one.value - x) * (one.value - x);
            xy += weight * (one.value - x) * (one.at - y);
        }
    };
    spread(ticks, weight_of_ticks);
    spread(pairs, 1.0);
    return {y - xy / xx * x, xy / xx};
}

}  // namespace carom::test
