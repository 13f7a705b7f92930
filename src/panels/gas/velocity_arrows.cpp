#include "panels/gas/velocity_arrows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/means/thinning.h"
#include "physics/membership.h"
#include "scene/film.h"
#include "stats/histogram.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr Eigen::Index few = 10;          // particles: none of their arrows is cut
constexpr double fast = 0.98;             // of all speeds are slower, where there are many
constexpr double beyond_a_wall = 0.7;     // units, that an arrow may reach
constexpr Eigen::Index most_arrows = 80;  // arrows: more are a thicket

// The largest of 1, 2 and 5 times a power of ten that is not above `most`.
double round_down(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= most) return digit * power;
    return power;
}

bool touches(const Rect& rect, Point from, Point to, double margin) {
    return std::max(from.x, to.x) > rect.x - margin &&
           std::min(from.x, to.x) < rect.right() + margin &&
           std::max(from.y, to.y) > rect.y - margin &&
           std::min(from.y, to.y) < rect.bottom() + margin;
}

}  // namespace

// Short arrows are slender: many large heads would hide the disks.
ArrowStyle VelocityArrows::style(const DrawContext& dc, double scale, Color ground) const {
    const double u = dc.unit;
    const double size = u * std::clamp(fast_ * reach_ * scale / (2.2 * u), 0.45, 1.0);
    return {.shaft = std::max(1.5, 0.2 * size),
            .head_length = 0.85 * size,
            .head_width = 0.8 * size,
            .edge = std::max(0.8, 0.08 * size),
            .color = dc.theme.ink,
            .edge_color = ground};
}

// Every n-th particle of the list has an arrow, which prefers neither species nor place.
Eigen::Index VelocityArrows::apart() const {
    return std::max<Eigen::Index>(1, (context_.particles.count() + most_arrows - 1) / most_arrows);
}

void VelocityArrows::survey(const FrameInput& input) {
    if (!shown()) return;
    const Eigen::Index n = input.speed.size();
    for_each_kept(n, static_cast<double>(n), surveyed_++, context_.frames, [&](Eigen::Index i) {
        if (is_present(input.sample, i)) pool_.push_back(input.speed[i]);
    });
}

void VelocityArrows::fix_scale(double length) {
    if (!shown()) return;
    const bool all = context_.particles.count() <= few;
    fast_ = pool_.empty() ? 0.0 : quantile(pool_, all ? 1.0 : fast);
    pool_ = {};
    const double wanted = context_.film().velocity_scale.value_or(length / fast_);
    reach_ = fast_ > 0.0 ? wanted : 0.0;
}

Rect VelocityArrows::bounds(const DrawContext& dc, const ArrowField& field) {
    const double more = beyond_a_wall * dc.unit;
    const double across = field.joined[0] ? 0.0 : more, up = field.joined[1] ? 0.0 : more;
    return {field.box.x - across, field.box.y - up, field.box.width + 2.0 * across,
            field.box.height + 2.0 * up};
}

void VelocityArrows::draw(Canvas& canvas, const DrawContext& dc, const ArrowField& field,
                          Point center, double radius, Point velocity, Color ground,
                          double light) const {
    const double ahead = reach_ * field.scale;
    const Point way{ahead * velocity.x, ahead * velocity.y};
    const double length = std::hypot(way.x, way.y);
    ArrowStyle drawn = style(dc, field.scale, ground);
    if (light < 1.0) drawn.color = mix(ground, drawn.color, light);
    if (!(length >= drawn.shaft)) return;
    const double start = context_.film().labels == Labels::none ? 0.0 : radius / length;
    const Rect within = bounds(dc, field);
    Rect limits = within;  // what leaves by a joined side comes in again, and is not cut
    constexpr double everywhere = 1e9;
    if (field.joined[0]) limits.x = -everywhere, limits.width = 2.0 * everywhere;
    if (field.joined[1]) limits.y = -everywhere, limits.height = 2.0 * everywhere;
    for (const int across : {0, -1, 1})
        for (const int up : {0, -1, 1}) {
            if ((across != 0 && !field.joined[0]) || (up != 0 && !field.joined[1])) continue;
            const Point from{center.x + start * way.x + across * field.box.width,
                             center.y + start * way.y + up * field.box.height};
            const Point to{from.x + way.x, from.y + way.y};
            if (touches(within, from, to, dc.unit))
                draw_arrow_within(canvas, limits, from, to, drawn);
        }
}

Rect VelocityArrows::draw_key(Canvas& canvas, const DrawContext& dc, double scale) const {
    Rect above = dc.area;
    if (!shown() || reach_ <= 0.0) return above;
    const double u = dc.unit;
    const double speed = round_down(std::min(fast_, dc.area.width / (reach_ * scale)));
    const double below = apart() > 1 ? 1.5 * u : 0.0, y = dc.area.bottom() - 0.6 * u - below;
    draw_arrow(canvas, {dc.area.x, y}, {dc.area.x + speed * reach_ * scale, y},
               style(dc, scale, dc.theme.page));
    const std::string number = plain_number(context_.language(), speed);
    std::string words = say(context_.language(), "speed {}", number);
    if (measure_text(words, label_style(dc)).width > dc.area.width) words = "<i>v</i> = " + number;
    draw_text(canvas, {dc.area.x, y - 0.9 * u}, words, label_style(dc));
    above.height = std::max(u, above.height - key_height * u - below);
    if (apart() > 1) {
        const std::string some = say(context_.language(), "of 1 in {}", apart());
        draw_text(canvas, {dc.area.x, y + 1.3 * u}, some, label_style(dc));
    }
    return above;
}

void VelocityArrows::add_key(KeyRow& row, double scale) const {
    if (!shown() || reach_ <= 0.0) return;
    const DrawContext dc = row.context();
    constexpr double longest = 5.0, after_arrow = 0.4;  // units
    const double speed = round_down(std::min(fast_, longest * dc.unit / (reach_ * scale)));
    const double length = speed * reach_ * scale;
    std::string words =
        say(context_.language(), "speed {}", plain_number(context_.language(), speed));
    if (apart() > 1) words += ", " + say(context_.language(), "of 1 in {}", apart());
    const ArrowStyle arrow = style(dc, scale, dc.theme.page);
    const double before = length + after_arrow * dc.unit;
    row.add(before + measure_text(words, label_style(dc)).width, [=](Canvas& canvas, Point at) {
        const double y = at.y - 0.35 * dc.unit;
        draw_arrow(canvas, {at.x, y}, {at.x + length, y}, arrow);
        draw_text(canvas, {at.x + before, at.y}, words, label_style(dc));
    });
}

}  // namespace carom
