// The disks of the gas and their ghosts. They are drawn one by one or, if they are too small and
// too many to be distinguished, by the share of each pixel that they cover.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "draw/disks/small_disks.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/gas_drawing.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double rim_line = 0.09;     // units: of disks whose colour hardly differs from the ground
constexpr double least_cover = 0.25;  // share of the box that enlarged small disks may cover

std::uint32_t rgb_of(Color color) { return to_pixel(color) & 0xFFFFFF; }

// A disk of one colour, and where `inside` is positive one of another within it.
void add_disk(std::vector<Disk>& disks, Point at, double radius, std::uint32_t edge, double inside,
              std::uint32_t color) {
    const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
    disks.push_back({x, y, static_cast<float>(radius), edge});
    if (inside > 0.0) disks.push_back({x, y, static_cast<float>(inside), color});
}

// The inner radius of a ring; 0 for disks that are too small for one and are filled.
double inside_ring(double radius, double line) { return radius > 2.0 * line ? radius - line : 0.0; }

}  // namespace

// Small disks are enlarged, but only until all of them together cover a quarter of the box; more
// would fill it.
double GasPanel::Drawing::radius_in_crowd() const {
    const double below = least_radius / scale;
    const auto count = static_cast<double>(gas.radii->below(below));
    const double pixels = box.size[0] * box.size[1] * scale * scale;
    const double most = std::sqrt(least_cover * pixels / (std::numbers::pi * std::max(1.0, count)));
    return std::min(least_radius, most);
}

// Draws the crowd of small disks; their order is not visible.
template <class ColorOf>
void GasPanel::Drawing::draw_crowd(const Eigen::ArrayXXf& places, const ColorOf& color_of) const {
    if (least_shown == least_radius) return;
    const auto for_each = [&](const auto& add) {
        for (Eigen::Index i = 0; i < radius.size(); ++i) {
            if (!is_in_crowd(i) || std::isnan(places(i, 0))) continue;
            const auto shown =
                static_cast<float>(std::max(least_shown, radius[i] * scale_at(places, i)));
            const std::uint32_t color = color_of(i);
            for_each_image(place_of(places, i), radius[i], [&](Point at) {
                add(Disk{static_cast<float>(at.x), static_cast<float>(at.y), shown, color});
            });
        }
    };
    if (!canvas.is_raster()) {
        std::vector<Disk> disks;
        for_each([&](const Disk& disk) { disks.push_back(disk); });
        return dc.disks.draw(canvas, disks, frame);
    }
    SmallDisks& small = dc.disks.small_disks();
    small.begin(canvas.size(), frame);
    for_each([&](const Disk& disk) { small.add(disk); });
    small.draw(canvas);
}

void GasPanel::Drawing::draw_crowd_of_spheres() const {
    const Inks its = inks();
    draw_crowd(gas.place, [&](Eigen::Index i) {
        const Color color = faded(rgb(its.edges[shade(i)]), place_of(gas.place, i));
        return dimmed(rgb_of(color), i);
    });
}

// Those that are there and are drawn one by one, in space from the back to the front.
std::vector<Eigen::Index> GasPanel::Drawing::drawn_alone(const Eigen::ArrayXXf& places) const {
    std::vector<Eigen::Index> order;
    order.reserve(static_cast<std::size_t>(places.rows()));
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        if (!is_in_crowd(i) && !std::isnan(places(i, 0))) order.push_back(i);
    return order;
}

// They, and disks of the crowd with a ring, a callout or, in space, a trail.
std::vector<Eigen::Index> GasPanel::Drawing::with_marks(const Eigen::ArrayXXf& places) const {
    std::vector<Eigen::Index> order = drawn_alone(places);
    const auto add_from_crowd = [&](Eigen::Index i) {
        if (is_in_crowd(i)) order.push_back(i);
    };
    for (const Spotlights::Ring& ring : gas.rings) add_from_crowd(ring.particle);
    for (const Callouts::Present& callout : gas.callouts) add_from_crowd(callout.particle);
    if (is_deep())
        for (const TrailedParticle& one : panel.followed_)
            if (gas.is_shown(one.particle)) add_from_crowd(one.particle);
    return order;
}

// They hide nothing of what is behind them.
void GasPanel::Drawing::draw_outlines() const {
    constexpr double opacity = 0.55;  // the field is what is to be seen
    const auto color_of = [&](Eigen::Index i) {
        return with_alpha(gas.seen(edge_of(colors[shade(i)], dc.theme), i, ground), opacity);
    };
    draw_crowd(gas.place, [&](Eigen::Index i) { return rgb_of(color_of(i)); });
    const bool is_laid_over = panel.context_.is_laid_over();
    const double line = std::max(1.0, (is_laid_over ? 0.25 : 0.08) * dc.unit);
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        if (is_in_crowd(i) || !gas.is_shown(i)) continue;
        const Color color = color_of(i);
        const double shown = shown_radius(i);
        for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
            if (shown < 2.0 * line)
                canvas.fill_circle(at, shown, color);
            else
                canvas.stroke_circle(at, shown - 0.5 * line, line, color);
        });
    }
}

void GasPanel::Drawing::draw_ghosts() const {
    if (!gas.ghosts) return;
    const std::uint32_t muted = rgb_of(dc.theme.muted);
    draw_crowd(gas.ghosts->place, [&](Eigen::Index) { return muted; });
    std::vector<Disk> disks;
    for (const Eigen::Index i : drawn_alone(gas.ghosts->place)) {
        const double shown = shown_radius(gas.ghosts->place, i);
        for_each_image(place_of(gas.ghosts->place, i), radius[i], [&](Point at) {
            add_disk(disks, at, shown, muted, inside_ring(shown, ghost_line(dc)), rgb_of(ground));
        });
    }
    dc.disks.draw(canvas, disks, frame);
}

GasPanel::Drawing::Inks GasPanel::Drawing::inks() const {
    Inks its{.ground = rgb_of(ground), .rim = std::max(2.0, rim_line * dc.unit)};
    for (const Color& color : colors) {
        its.pixels.push_back(rgb_of(color));
        its.edges.push_back(rgb_of(edge_of(color, dc.theme)));
    }
    return its;
}

std::uint32_t GasPanel::Drawing::dimmed(std::uint32_t color, Eigen::Index i) const {
    return gas.light.empty() ? color : rgb_of(gas.seen(rgb(color), i, ground));
}

void GasPanel::Drawing::add_body(std::vector<Disk>& disks, Eigen::Index i, const Inks& its) const {
    const double shown = shown_radius(i);
    const bool is_filled = panel.is_filled(i, gas);
    const std::uint32_t color = dimmed(its.pixels[shade(i)], i);
    const std::uint32_t edge = dimmed(its.edges[shade(i)], i);
    double inside = 0.0;
    if (!is_filled || edge != color)
        inside = inside_ring(shown, is_filled ? its.rim : ring_line(shown, dc.unit));
    for_each_image(place_of(gas.place, i), radius[i], [&](Point at) {
        add_disk(disks, at, shown, edge, inside, is_filled ? color : its.ground);
    });
}

// The ring around a disk with a trail.
void GasPanel::Drawing::add_ring(std::vector<Disk>& disks, Eigen::Index i) const {
    const double ring = radius[i] * scale_at(gas.place, i) + followed_line * dc.unit;
    for_each_image(place_of(gas.place, i), radius[i],
                   [&](Point at) { add_disk(disks, at, ring, rgb_of(dc.theme.ink), 0.0, 0); });
}

// Disks of the crowd are drawn below all others, except those with a ring, a callout or a trail.
void GasPanel::Drawing::draw_disks() const {
    const Inks its = inks();
    draw_crowd(gas.place, [&](Eigen::Index i) { return dimmed(its.edges[shade(i)], i); });
    std::vector<Disk> disks;
    for (const Eigen::Index i : with_marks(gas.place)) add_body(disks, i, its);
    for (const TrailedParticle& one : panel.followed_) {
        if (!gas.is_shown(one.particle)) continue;
        add_ring(disks, one.particle);
        add_body(disks, one.particle, its);
    }
    dc.disks.draw(canvas, disks, frame);
    draw_marks();
}

// Whether a disk may bear a label or the hatching of an infinite mass.
bool GasPanel::Drawing::has_mark(Eigen::Index i) const {
    if (film.labels != Labels::none) return true;
    return panel.colors_.tells_infinite() &&
           GasColors::is_of_infinite(gas.shades[static_cast<std::size_t>(i)]) &&
           panel.is_disk(i, gas);
}

void GasPanel::Drawing::draw_mark(Eigen::Index i) const {
    const double shown = radius[i] * scale_at(gas.place, i);
    if (film.labels == Labels::none)
        return for_each_image(place_of(gas.place, i), radius[i],
                              [&](Point at) { draw_hatching(canvas, dc, at, shown); });
    draw_words_on(canvas, dc, pixel(i), shown, words_on(panel.context_, i, film.labels),
                  panel.is_disk(i, gas) ? gas.seen(colors[shade(i)], i, ground) : ground);
}

void GasPanel::Drawing::draw_marks() const {
    if (film.labels == Labels::none && !panel.colors_.tells_infinite()) return;
    for (Eigen::Index i = 0; i < radius.size(); ++i)
        if (gas.is_shown(i) && has_mark(i)) draw_mark(i);
}

// Remarks on what would mislead: enlarged disks make a gas look denser than it is, and omitted
// flashes make it look calmer. Also labels for which there is no room.
Remarks GasPanel::Drawing::remarks() const {
    const Language language = panel.context_.language();
    Remarks all(dc, frame, gas.view ? std::optional(map_of(map)) : std::nullopt);
    all.add(panel.flashes_.remarks());
    if (!labels_fit())
        all.add({is_deep() ? say(language, "No room for labels on the spheres")
                           : say(language, "No room for labels on the disks")});
    const Eigen::ArrayXd& true_radius = panel.context_.particles.radius;
    if (gas.radii->smallest * scale >= least_shown && !gas.radii->enlarges) return all;
    const auto is_enlarged = radius * scale < least_shown || radius > true_radius;
    if (!is_enlarged.any()) return all;
    // All by the factor that the scene gives, none further to be seen.
    const double factor = panel.context_.looks().front().scale;
    if (factor > 1.0 && gas.radii->smallest * scale >= least_shown &&
        (radius == factor * true_radius).all()) {
        const std::string number = plain_number(language, factor);
        all.add({is_deep() ? say(language, "Spheres drawn {} times as large", number)
                           : say(language, "Disks drawn {} times as large", number)});
        return all;
    }
    const double smallest = is_enlarged.select(true_radius, true_radius.maxCoeff()).minCoeff();
    const double largest = is_enlarged.select(true_radius, smallest).maxCoeff();
    const std::string low = three_digits(language, smallest),
                      high = three_digits(language, largest);
    if (is_deep())
        all.add({largest > smallest
                     ? say(language, "Spheres enlarged for visibility; radii {} to {}", low, high)
                     : say(language, "Spheres enlarged for visibility; radius {}", low),
                 say(language, "Spheres enlarged for visibility")});
    else
        all.add({largest > smallest
                     ? say(language, "Disks enlarged for visibility; radii {} to {}", low, high)
                     : say(language, "Disks enlarged for visibility; radius {}", low),
                 say(language, "Disks enlarged for visibility")});
    return all;
}

}  // namespace carom
