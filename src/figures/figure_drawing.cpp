#include "figures/figure_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "panels/gas/gas_colors.h"
#include "panels/gas/velocity_arrows.h"
#include "panels/registry.h"
#include "panels/words/text_panel.h"
#include "scene/panel_kind.h"
#include "scene/style/style.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double print_type = 6.9, slide_type = 24.0;  // points; a title of 7.9 in print
constexpr double vector_dots = 96.0, print_dots = 300.0, slide_dots = 144.0;  // to the inch
constexpr double tallest = 17.0;  // centimetres: the height available on a page of text
constexpr double key_width = 6.4, key_gap = 0.8, margin = 0.8;  // units
constexpr double under_key = 0.8;                               // units
constexpr double strip_gap = 1.2, row_of_times = 2.2;           // units
constexpr double shape_of_plots = 0.68;                         // height over width
constexpr double shape_of_wires = 0.6;

double centimetres(double points) { return points / 72.0 * 2.54; }

bool draws_box(const FigureSpec& spec) { return kind_of(spec.panel).draws_box; }

/// Lengths of a figure in units of its smallest type.
struct Sheet {
    double width, height;
    double box_width = 0.0;  ///< of one box of a strip
};

// The least height of a colour key next to a low box.
double least_key(const Scene& scene) {
    return GasColors::least_bar + under_key +
           (scene.film.velocities ? VelocityArrows::key_height : 0.0);
}

Sheet sheet_of(const Scene& scene, const FigureSpec& spec) {
    const double unit = centimetres(smallest_type(spec));
    Sheet sheet{spec.width / unit, 0.0};
    const double most = (spec.height ? *spec.height : tallest) / unit;
    const double pictures = static_cast<double>(spec.times.size());
    sheet.box_width = sheet.width - 2.0 * margin;
    if (draws_box(spec))
        sheet.box_width =
            (sheet.box_width - key_gap - key_width - (pictures - 1.0) * strip_gap) / pictures;
    const Box& box = scene.gas.box;
    double shape = shape_of_plots;
    if (draws_box(spec)) shape = box.dimension == 1 ? shape_of_wires : box.size[1] / box.size[0];
    const double times = pictures > 1.0 ? row_of_times : 0.0;
    const double least = draws_box(spec) ? least_key(scene) : 0.0;
    sheet.height =
        spec.height
            ? most
            : std::min(most, 2.0 * margin + std::max(least, times + shape * sheet.box_width));
    return sheet;
}

// Writes the times below the pictures of a strip, whose spacing is `apart`. If the pictures are
// narrow only the numbers are written, and if these do not fit either, only those of every second
// picture or fewer.
void draw_times(Canvas& canvas, const DrawContext& first, Language language, double apart,
                const std::vector<double>& times) {
    TextStyle style = label_style(first);
    style.align = Align::center;
    const double gap = 0.6 * first.unit;
    const auto widest = [&](const std::string& name) {
        double width = 0.0;
        for (const double time : times)
            width = std::max(width, measure_text(name + plain_number(language, time), style).width);
        return width + gap;
    };
    const std::string name = widest("<i>t</i> = ") <= apart ? "<i>t</i> = " : "";
    const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(widest(name) / apart)));
    for (std::size_t k = 0; k < times.size(); k += every)
        draw_text(canvas,
                  {first.area.x + static_cast<double>(k) * apart + first.area.width / 2,
                   first.area.bottom() + 1.6 * first.unit},
                  name + plain_number(language, times[k]), style);
}

void draw_gas(Canvas& canvas, const DrawContext& whole, const Sheet& sheet, const Figure& figure,
              const Scene& scene) {
    const Language language = scene.film.language;
    const double least = least_key(scene);
    const double u = whole.unit;
    const bool several = figure.moments.size() > 1;
    DrawContext dc = whole;
    dc.area = {margin * u, margin * u, sheet.box_width * u,
               (sheet.height - 2.0 * margin - (several ? row_of_times : 0.0)) * u};
    const DrawContext first = dc;
    for (const FigureMoment& moment : figure.moments) {
        figure.panel->draw_ground(canvas, dc);
        figure.panel->draw(canvas, dc, *moment.state);
        dc.area.x += dc.area.width + strip_gap * u;
    }
    const Rect box = figure.panel->frame_in(first.area, u);
    if (several)
        draw_times(canvas, {box, u, dc.theme, dc.disks}, language, first.area.width + strip_gap * u,
                   figure.spec->times);
    const double right = first.area.x + (sheet.width - 2.0 * margin - key_width) * u;
    // Next to a low box the key begins higher and ends lower than the box.
    const double end = (sheet.height - margin) * u;
    const double top = std::max(first.area.y, std::min(box.y, end - least * u));
    const double bottom = std::max(box.bottom(), std::min(end, top + least * u));
    figure.panel->draw_key(
        canvas, {{{right, top, key_width * u, bottom - top}, u, dc.theme, dc.disks}, first});
}

Rect plot_in(const Sheet& sheet, double unit) {
    return {margin * unit, margin * unit, (sheet.width - 2.0 * margin) * unit,
            (sheet.height - 2.0 * margin) * unit};
}

void draw_plot(Canvas& canvas, const DrawContext& whole, const Sheet& sheet, const Figure& figure) {
    DrawContext dc = whole;
    dc.area = plot_in(sheet, dc.unit);
    figure.panel->draw_ground(canvas, dc);
    figure.panel->draw(canvas, dc, *figure.moments.front().state);
}

}  // namespace

double smallest_type(const FigureSpec& spec) {
    const Style* style = spec.style.get();
    if (spec.slide) return slide_type * (style != nullptr ? style->film_text : 1.0);
    return style != nullptr ? style->figure_text.value_or(print_type) : print_type;
}

std::array<double, 2> figure_size(const Scene& scene, const FigureSpec& spec) {
    const double unit = centimetres(smallest_type(spec));
    const Sheet sheet = sheet_of(scene, spec);
    const auto rounded = [&](double length) { return std::round(100.0 * length * unit) / 100.0; };
    return {rounded(sheet.width), rounded(sheet.height)};
}

void refuse_long_words(const Scene& scene, const FigureSpec& spec) {
    const double unit = smallest_type(spec) / 72.0 * print_dots;
    auto problem = problem_of_words(spec.panel, plot_in(sheet_of(scene, spec), unit), unit,
                                    theme_of(spec).fonts);
    if (!problem) return;
    problem->hint = "write fewer or shorter words, or make the figure larger";
    throw SceneError({*problem});
}

Canvas draw_figure(const FigureRun& run, const Figure& figure, std::optional<VectorFormat> format,
                   const PictureWords& words) {
    const FigureSpec& spec = *figure.spec;
    const double usual = spec.slide ? slide_dots : print_dots;
    const double raster = spec.style != nullptr ? spec.style->dots.value_or(usual) : usual;
    const double dots = format ? vector_dots : raster;
    const double unit = smallest_type(spec) / 72.0 * dots;
    const Sheet sheet = sheet_of(run.scene(), spec);
    const PixelSize size{static_cast<int>(std::lround(sheet.width * unit)),
                         static_cast<int>(std::lround(sheet.height * unit))};
    const bool transparent = run.scene().film.transparent;
    Canvas canvas = format ? Canvas(size, *format, words)
                           : Canvas(size, transparent ? Backdrop::transparent : Backdrop::black);
    if (canvas.is_raster()) {
        canvas.describe(words);
        canvas.set_resolution(raster);
    }
    canvas.keep_text(spec.svg_has_text);
    DiskPainter disks;
    const DrawContext dc{
        {0.0, 0.0, double(size.width), double(size.height)}, unit, theme_of(spec), disks};
    if (!transparent) canvas.fill_all(dc.theme.page);
    if (draws_box(spec))
        draw_gas(canvas, dc, sheet, figure, run.scene());
    else
        draw_plot(canvas, dc, sheet, figure);
    return canvas;
}

Table table_of(const Figure& figure) {
    const Theme& colors = theme_of(*figure.spec);
    Table whole;
    for (const FigureMoment& moment : figure.moments) {
        Table table = figure.panel->table(*moment.state, colors);
        if (figure.moments.size() == 1) return table;
        for (std::vector<TableCell>& row : table.rows) {
            std::vector<TableCell>& timed = whole.rows.emplace_back();
            timed.reserve(row.size() + 1);
            timed.emplace_back(moment.time);
            std::ranges::move(row, std::back_inserter(timed));
        }
        whole.columns = std::move(table.columns);
        whole.units = table.units;
    }
    whole.columns.emplace(whole.columns.begin(), "picture at", quantities::time);
    return whole;
}

}  // namespace carom
