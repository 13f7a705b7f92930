#include "panels/gas/marks/view_map.h"

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom {

ViewMap view_map(const DrawContext& dc, const Rect& picture, double shape, double scale) {
    const double u = dc.unit, most = 6.0 * u;
    const double width = shape > 1.0 ? most / shape : most;
    const double least = 0.5 * u;  // a line has a map too
    const double height = std::max(least, width * shape);
    ViewMap its{};
    its.map = {picture.x + 1.1 * u, picture.bottom() - 1.1 * u - height, width, height};
    const double most_length = 0.2 * picture.width / scale;
    const double power = std::pow(10.0, std::floor(std::log10(most_length)));
    its.length = power;
    for (const double digit : {2.0, 5.0})
        if (digit * power <= most_length) its.length = digit * power;
    its.pixels = its.length * scale;
    its.bar = {its.map.right() + 1.2 * u, its.map.bottom()};
    its.plate = {picture.x + 0.4 * u, its.map.y - 0.7 * u,
                 its.bar.x + its.pixels - picture.x + 0.6 * u,
                 picture.bottom() - its.map.y + 0.3 * u};
    return its;
}

double view_map_share(double zoom) { return std::clamp(std::log(zoom) / std::log(1.3), 0.0, 1.0); }

void draw_view_map(Canvas& canvas, const DrawContext& dc, const ViewMap& its, const Rect& part,
                   double share, Language language) {
    const double u = dc.unit;
    const Rect& map = its.map;
    canvas.fill(its.plate, with_alpha(dc.theme.ground, plate_alpha * share));
    canvas.stroke_rect(map, 0.07 * u, with_alpha(dc.theme.muted, share));
    const auto across = [&](double x) { return map.x + std::clamp(x, 0.0, 1.0) * map.width; };
    const auto down = [&](double y) { return map.y + std::clamp(y, 0.0, 1.0) * map.height; };
    canvas.stroke_rect({across(part.x), down(part.y), across(part.right()) - across(part.x),
                        down(part.bottom()) - down(part.y)},
                       0.14 * u, with_alpha(dc.theme.highlight, share));
    const Color ink = with_alpha(dc.theme.ink, share);
    const auto [left, y] = its.bar;
    const double right = left + its.pixels;
    canvas.stroke_line({left, y}, {right, y}, 0.14 * u, ink);
    for (const double end : {left, right})
        canvas.stroke_line({end, y - 0.3 * u}, {end, y + 0.07 * u}, 0.1 * u, ink);
    TextStyle style = label_style(dc);
    style.color = ink;
    style.align = Align::center;
    draw_text(canvas, {left + 0.5 * its.pixels, y - 0.6 * u}, plain_number(language, its.length),
              style);
}

bool Remarks::place(const std::vector<std::string>& forms, double width) {
    const double u = dc_.unit;
    for (const std::string& words : forms) {
        const double wide = measure_text(words, label_style(dc_)).width;
        if (wide > width - 2.0 * u) continue;
        remarks_.push_back(
            {words, {picture_.right() - wide - u, foot_ - 1.7 * u, wide + 0.8 * u, 1.5 * u}});
        foot_ -= 1.5 * u;
        return true;
    }
    return false;
}

void Remarks::add(const std::vector<std::string>& forms) {
    const bool is_beside = map_ && foot_ > map_->plate.y;
    const double width = is_beside ? picture_.right() - map_->plate.right() : picture_.width;
    if (place(forms, width) || !is_beside || forms.empty()) return;
    foot_ = map_->plate.y;
    place(forms, picture_.width);
}

void Remarks::draw(Canvas& canvas) const {
    const double u = dc_.unit;
    TextStyle style = label_style(dc_);
    style.align = Align::right;
    for (const auto& [words, plate] : remarks_) {
        canvas.fill(plate, with_alpha(dc_.theme.ground, plate_alpha));
        draw_text(canvas, {plate.right() - 0.4 * u, plate.y + 1.1 * u}, words, style);
    }
}

void Remarks::take_places(std::vector<Rect>& taken) const {
    const auto take = [&](const Rect& plate) {
        const auto same = std::ranges::find_if(
            taken, [&](const Rect& one) { return one.x == plate.x && one.y == plate.y; });
        if (same == taken.end())
            taken.push_back(plate);
        else
            same->width = std::max(same->width, plate.width);
    };
    if (map_) take(map_->plate);
    for (const Remark& remark : remarks_) take(remark.plate);
}

}  // namespace carom
