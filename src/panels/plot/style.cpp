// Roles, strokes and dots as colours, dashes and disks of a theme.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/palette.h"
#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

// On a screen a film may show the boxes too, with speeds in the colours of the usual scale: then
// none of these.
Color color_of_run(std::size_t run, const Theme& theme) {
    if (run < theme.runs.size() && theme.runs[run]) return *theme.runs[run];
    if (theme.kind == ThemeKind::print || !theme.series.empty()) return kind_color(run, theme);
    static const auto sets = [] {
        std::array<std::vector<Color>, 3> all;
        for (const Theme* one : {&carom::theme(ThemeKind::light), &carom::theme(ThemeKind::dark)})
            all.at(static_cast<std::size_t>(one->kind)) =
                kind_colors_beside(color_map_on("viridis", *one).samples(), *one);
        return all;
    }();
    const std::vector<Color>& set = sets.at(static_cast<std::size_t>(theme.kind));
    return set[run % set.size()];
}

}  // namespace

Color color_of(const Role& role, const Theme& theme) {
    switch (role.of) {
        case Role::Of::ink:
            return theme.ink;
        case Role::Of::muted:
            return theme.muted;
        case Role::Of::accent:
            return theme.accent;
        case Role::Of::bar:
            return theme.bar;
        case Role::Of::highlight:
            return theme.highlight;
        case Role::Of::page:
            return theme.page;
        case Role::Of::run:
            return toward_ink(color_of_run(role.index, theme), theme, std::array{theme.page},
                              least_contrast_of_marks);
        case Role::Of::own:
            break;
    }
    return role.own.at(static_cast<std::size_t>(theme.kind));
}

Color color_of(const Stroke& stroke, const Theme& theme) {
    const Color color = color_of(stroke.role, theme);
    return mix(stroke.shade == Shade::legible ? edge_of(color, theme) : color, theme.page,
               stroke.fade);
}

std::vector<double> dashes_of(const Stroke& stroke, const DrawContext& dc) {
    const bool in_print = dc.theme.kind == ThemeKind::print && !stroke.print_dashes.empty();
    std::vector<double> dashes = in_print ? stroke.print_dashes : stroke.dashes;
    for (double& length : dashes) length *= dc.unit;
    return dashes;
}

void draw_stroke(Canvas& canvas, const DrawContext& dc, std::span<const Point> path,
                 const Stroke& stroke) {
    const double width = stroke.width * dc.unit;
    const std::vector<double> dashes = dashes_of(stroke, dc);
    Color color = color_of(stroke, dc.theme);
    if (stroke.shade == Shade::rimmed) {
        const Color rim = edge_of(color, dc.theme);
        if (!dashes.empty())
            color = rim;
        else if (to_pixel(rim) != to_pixel(color))
            canvas.stroke_path(path, width + 0.1 * dc.unit, rim);
    }
    canvas.stroke_path(path, width, color, dashes);
}

void draw_straight(Canvas& canvas, const DrawContext& dc, Point from, Point to,
                   const Stroke& stroke) {
    if (dashes_of(stroke, dc).empty())
        canvas.stroke_line(from, to, stroke.width * dc.unit, color_of(stroke, dc.theme));
    else
        draw_stroke(canvas, dc, std::array{from, to}, stroke);
}

void draw_dot(Canvas& canvas, const DrawContext& dc, Point at, const Dot& dot) {
    const double u = dc.unit, radius = dot.radius * u;
    const Color color = color_of(dot.role, dc.theme);
    const Color edge = mix(dot.shade == Shade::as_it_is ? color : edge_of(color, dc.theme),
                           dc.theme.page, dot.fade);
    if (dot.ring > 0.0) return canvas.stroke_circle(at, radius, dot.ring * u, edge);
    if (dot.halo > 0.0) canvas.fill_circle(at, radius + dot.halo * u, dc.theme.page);
    canvas.fill_circle(at, radius, edge);
    if (dot.shade == Shade::rimmed)
        canvas.fill_circle(at, radius - (to_pixel(edge) != to_pixel(color) ? 0.1 * u : 0.0), color);
    const bool is_pale =
        dot.is_hollow_if_pale && dc.theme.kind == ThemeKind::print && looks_hollow(color, dc.theme);
    if (dot.is_hollow || is_pale) canvas.fill_circle(at, 0.6 * radius, dc.theme.page);
}

void draw_strip(Canvas& canvas, const Rect& rect, const std::function<Color(double)>& color_at) {
    constexpr double step = 4.0;  // pixels
    const double begin = std::round(rect.x), end = std::round(rect.right());
    for (double left = begin; left < end; left += step) {
        const double right = std::min(left + step, end);
        canvas.fill({left, rect.y, right - left, rect.height},
                    color_at((0.5 * (left + right) - rect.x) / rect.width));
    }
}

ArrowStyle arrow_style(const DrawContext& dc, Color color, Color edge_color, double edge) {
    const double u = dc.unit;
    return {.shaft = std::max(1.5, 0.17 * u),
            .head_length = 0.7 * u,
            .head_width = 0.65 * u,
            .edge = std::max(0.8, edge * u),
            .color = color,
            .edge_color = edge_color};
}

void draw_arrow(Canvas& canvas, const DrawContext& dc, Point from, Point to, const Arrow& arrow) {
    const double whole = std::hypot(to.x - from.x, to.y - from.y);
    const double length = whole - arrow.gap * dc.unit;
    if (!(length > arrow.shortest * dc.unit)) return;
    const double share = length / whole;
    carom::draw_arrow(
        canvas, from, {std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share)},
        arrow_style(dc, color_of(arrow.role, dc.theme), color_of(arrow.edge, dc.theme), 0.08));
}

TextStyle clear_of_grid(const Frame& frame, TextStyle style, const Rect& words) {
    const bool is_crossed = std::ranges::any_of(
        frame.grid, [&](double y) { return y > words.y && y < words.bottom(); });
    if (!is_crossed) return style;
    style.halo = halo_of_words * frame.dc.unit;
    style.behind = frame.dc.theme.page;
    return style;
}

namespace {

std::string swatch_of(const Text::Piece& piece, const Theme& theme) {
    const Color color = color_of(*piece.role, theme);
    return piece.swatch == Swatch::line ? line_swatch(piece.line, color, theme)
                                        : disk_swatch(color, theme);
}

}  // namespace

std::string markup_of(const Text& text, const Theme& theme, double fade) {
    std::string markup;
    for (const Text::Piece& piece : text.pieces) {
        if (!piece.role) {
            markup += piece.markup;
            continue;
        }
        if (piece.swatch != Swatch::none) markup += swatch_of(piece, theme);
        const Color color = mix(legible(color_of(*piece.role, theme), theme), theme.page, fade);
        markup += fmt::format("<span foreground=\"{}\">{}</span>", hex_of(color), piece.markup);
    }
    return markup;
}

}  // namespace carom::plot
