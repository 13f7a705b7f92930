#include "panels/frame.h"

#include <algorithm>

#include "panels/gas_panel.h"
#include "panels/monitors_panel.h"
#include "panels/registry.h"
#include "panels/wire_panel.h"

namespace carom {
namespace {

const Theme& theme_of(ThemeName name) {
    switch (name) {
        case ThemeName::light:
            return theme(ThemeKind::light);
        case ThemeName::print:
            return theme(ThemeKind::print);
        default:
            return theme(ThemeKind::dark);
    }
}

double unit_of(const Scene& scene) {
    const LayoutSpec& layout = scene.film.layout;
    return std::min(scene.film.size.width / layout.grid_width,
                    scene.film.size.height / layout.grid_height);
}

// A film with fewer panels than its template has places for gives their column's whole height to
// those it has.
std::vector<Slot> panel_slots(const LayoutSpec& layout, std::size_t count) {
    std::vector<Slot> slots = layout.panels;
    const auto in_column = [&](const Slot& slot) { return slot.x == slots.front().x; };
    if (count == 0 || count >= slots.size() || !std::ranges::all_of(slots, in_column)) return slots;
    const double gap = slots[1].y - (slots[0].y + slots[0].height);
    const double whole = slots.back().y + slots.back().height - slots.front().y;
    const double height =
        (whole - gap * static_cast<double>(count - 1)) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        slots[i].y = slots.front().y + (height + gap) * static_cast<double>(i);
        slots[i].height = height;
    }
    return slots;
}

std::unique_ptr<Panel> make_gas_panel(const Cast& cast) {
    if (cast.scene.gas.box.dimension == 1) return std::make_unique<WirePanel>(cast);
    return std::make_unique<GasPanel>(cast);
}

}  // namespace

Observers::Observers(const Scene& scene, const Particles& particles, const Sample& start)
    : particles_(particles), equilibrium_(equilibrium(scene.gas.box, particles, start)) {
    const Cast cast{scene, particles_, frame_count(scene.film), equilibrium_};
    const LayoutSpec& layout = scene.film.layout;
    panels_.push_back({layout.gas, make_gas_panel(cast)});
    if (layout.monitors)
        panels_.push_back({*layout.monitors, std::make_unique<MonitorsPanel>(cast)});
    const std::vector<Slot> slots = panel_slots(layout, scene.film.panels.size());
    for (std::size_t i = 0; i < scene.film.panels.size(); ++i)
        panels_.push_back({slots[i], make_panel(cast, scene.film.panels[i])});
}

bool Observers::wants_collisions() const {
    return std::ranges::any_of(
        panels_, [](const Placed& placed) { return placed.panel->wants_collisions(); });
}

void Observers::survey(const Tick& tick, const Sample& sample, const Passage& passage) {
    const Eigen::ArrayXd speed = speeds(sample);
    const Eigen::ArrayXd energy = kinetic_energies(particles_, sample);
    const Observation observation{tick, sample, speed, energy, passage};
    for (const Placed& placed : panels_) placed.panel->survey(observation);
}

void Observers::settle() {
    for (const Placed& placed : panels_) placed.panel->settle();
}

FrameData Observers::frame_data(const Tick& tick, const Sample& sample, const Passage& passage) {
    const Eigen::ArrayXd speed = speeds(sample);
    const Eigen::ArrayXd energy = kinetic_energies(particles_, sample);
    const Observation observation{tick, sample, speed, energy, passage};
    FrameData frame{tick, {}, 0};
    for (const Placed& placed : panels_) {
        frame.states.push_back(placed.panel->state(observation));
        frame.bytes += frame.states.back()->bytes();
    }
    return frame;
}

FramePainter::FramePainter(const Scene& scene, const Observers& observers)
    : scene_(scene),
      observers_(observers),
      theme_(theme_of(scene.film.theme)),
      unit_(unit_of(scene)),
      origin_{(scene.film.size.width - scene.film.layout.grid_width * unit_) / 2,
              (scene.film.size.height - scene.film.layout.grid_height * unit_) / 2},
      ground_({scene.film.size.width, scene.film.size.height}),
      canvas_({scene.film.size.width, scene.film.size.height}) {
    ground_.fill_all(theme_.page);
    draw_title();
    for (const Observers::Placed& placed : observers_.panels())
        placed.panel->draw_ground(ground_, page(placed.slot));
    const Page key = page(scene_.film.layout.color_bar);
    const Rect box = observers_.gas().frame_in(place(scene_.film.layout.gas));
    const Rect beside{box.right() + 0.8 * unit_, box.y, key.area.width, box.height};
    observers_.gas().draw_key(ground_, {beside, unit_, theme_, disks_});
    for (const Observers::Placed& placed : observers_.panels()) {
        const Rect area = place(placed.slot);
        changing_.push_back(
            {area.x - unit_, area.y - unit_, area.width + 2.0 * unit_, area.height + 2.0 * unit_});
    }
    canvas_.copy_from(ground_);
}

Rect FramePainter::place(const Slot& slot) const {
    return {origin_.x + slot.x * unit_, origin_.y + slot.y * unit_, slot.width * unit_,
            slot.height * unit_};
}

Page FramePainter::page(const Slot& slot) { return {place(slot), unit_, theme_, disks_}; }

void FramePainter::draw_title() {
    const Rect area = place(scene_.film.layout.title);
    const TextStyle title{.size = 1.98 * unit_,
                          .weight = 600,
                          .color = theme_.ink,
                          .tabular = false,
                          .max_width = area.width};
    draw_text(ground_, {area.x, area.y + 1.7 * unit_}, escape_markup(scene_.title), title);
    TextStyle subtitle{.size = 1.17 * unit_,
                       .weight = 400,
                       .color = theme_.muted,
                       .tabular = false,
                       .max_width = area.width - 14.0 * unit_};
    const double baseline = area.y + 3.7 * unit_;
    draw_text(ground_, {area.x, baseline}, escape_markup(scene_.subtitle), subtitle);
    subtitle.size = unit_;
    subtitle.align = Align::right;
    draw_text(ground_, {area.right(), baseline}, "reduced units", subtitle);
}

const Canvas& FramePainter::paint(const FrameData& frame) {
    for (const Rect& rect : changing_) canvas_.copy_from(ground_, rect);
    for (std::size_t i = 0; i < frame.states.size(); ++i) {
        const Observers::Placed& placed = observers_.panels()[i];
        placed.panel->draw(canvas_, page(placed.slot), *frame.states[i]);
    }
    if (frame.tick.phase == Phase::reversing) draw_announcement(frame.tick);
    return canvas_;
}

void FramePainter::draw_announcement(const Tick& tick) {
    const Rect box = observers_.gas().frame_in(place(scene_.film.layout.gas));
    const double alpha = std::clamp(5.0 * std::min(tick.progress, 1.0 - tick.progress), 0.0, 1.0);
    const Rect plate{box.x, box.y + 0.5 * box.height - 2.0 * unit_, box.width, 4.0 * unit_};
    canvas_.fill(plate, with_alpha(theme_.page, 0.82 * alpha));
    const TextStyle style{.size = 2.2 * unit_,
                          .weight = 600,
                          .color = with_alpha(theme_.ink, alpha),
                          .align = Align::center};
    draw_text(canvas_, {box.x + 0.5 * box.width, plate.y + 2.75 * unit_}, "velocities reversed",
              style);
}

}  // namespace carom
