#include "panels/gas/particle_panel.h"

#include <cmath>

#include "panels/archived.h"
#include "panels/chosen.h"
#include "physics/gas.h"
#include "physics/mechanics.h"

namespace carom {

KeyRow ParticlePanel::key_row(const Key& key) const {
    KeyRow row(key.at);
    const double scale = scale_in(key.own);
    colors_.add_key(row, key.has_ramp);
    if (field_.shown()) field_.add_key(row, scale);
    arrows_.add_key(row, scale);
    return row;
}

void ParticlePanel::draw_key(Canvas& canvas, const Key& key) const {
    if (key.is_row) return key_row(key).draw(canvas);
    const DrawContext& dc = key.at;
    const double scale = scale_in(key.own);
    DrawContext left{arrows_.draw_key(canvas, dc, scale), dc.unit, dc.theme, dc.disks};
    if (field_.shown()) {
        DrawContext lower = left;
        left.area.height = colors_.key_height(left, key.has_ramp);
        const double taken = left.area.height > 0.0 ? left.area.height + 1.2 * dc.unit : 0.0;
        lower.area = {lower.area.x, lower.area.y + taken, lower.area.width,
                      lower.area.height - taken};
        field_.draw_key(canvas, lower, scale);
        if (taken == 0.0) return;
    }
    colors_.draw_key(canvas, left, key.has_ramp);
}

void ParticlePanel::share_scales(const std::vector<ParticlePanel*>& boxes) {
    ParticlePanel& first = *boxes.front();
    const std::vector<ParticlePanel*> others(boxes.begin() + 1, boxes.end());
    for (const ParticlePanel* other : others) {
        first.colors_.add_survey(other->colors_);
        first.arrows_.add_survey(other->arrows_);
        first.field_.add_survey(other->field_);
    }
    first.fix_axes();
    for (ParticlePanel* other : others) {
        other->fix_axes();
        other->colors_.take_scale(first.colors_);
        other->arrows_.take_scale(first.arrows_);
        other->field_.take_scale(first.field_);
    }
    first.share_span(others);
}

bool ParticlePanel::see(const FrameInput& input, const Eigen::ArrayXXd& places,
                        ParticleState& state) {
    const bool is_changed = membership_.see(input.sample, context_.particles);
    if (is_changed) {
        absent_.clear();
        for (Eigen::Index i = 0; i < context_.particles.count(); ++i)
            if (!is_present(input.sample, i)) absent_.push_back(i);
    }
    const double mean_speed = mean_of_speeds(context_.particles, input.speed);
    state.membership = input.sample.membership;
    state.place = places.cast<float>();
    for (const Eigen::Index i : absent_) state.place.row(i).setConstant(NAN);
    if (arrows_.shown()) state.velocity = input.sample.velocity.cast<float>();
    const Eigen::ArrayXXd& velocity = input.sample.velocity;
    const auto direction = [&](Eigen::Index i) -> Vec {
        return {velocity(i, 0), velocity.cols() > 1 ? velocity(i, 1) : 0.0};
    };
    state.shades.reserve(static_cast<std::size_t>(places.rows()));
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        state.shades.push_back(
            colors_.shade(i, {input.speed[i], direction(i), mean_speed}, state.membership.get()));
    state.label_alpha = name_alpha(context_, input.tick);
    ghosts_.see(input.tick, state.place);
    state.ghosts = ghosts_.present();
    state.ghost_words = ghosts_.words_alpha(input.tick);
    state.flashes = flashes_.at(input.tick);
    spotlights_.see(input.sample);
    state.light = spotlights_.light(input.tick, input.is_still);
    fading_.see(input.tick, input.sample.position, state.light);
    state.rings = spotlights_.rings(input.tick, input.is_still);
    state.callouts = callouts_.at(input.tick, input.is_still);
    std::erase_if(state.callouts,
                  [&](const Callouts::Present& its) { return !state.is_shown(its.particle); });
    state.viewpoint = camera_.next_viewpoint();
    state.view = camera_.next();
    state.field = field_.see(input);
    return is_changed;
}

void ParticlePanel::archive_progress(Archive& archive) {
    archive(ghosts_, fading_);
    camera_.archive_progress(archive);
    field_.archive_progress(archive);
}

std::size_t ParticlePanel::species_of(Eigen::Index particle, const ParticleState& state) const {
    return static_cast<std::size_t>(
        species_in(state.membership.get(), context_.particles)[particle]);
}

bool ParticlePanel::is_filled(Eigen::Index particle, const ParticleState& state) const {
    return context_.looks()[species_of(particle, state)].fill;
}

void ParticlePanel::add_row(Table& table, const ParticleState& state, const char* part,
                            Eigen::Index particle, std::vector<TableCell> cells,
                            bool has_velocity) const {
    std::vector<TableCell>& row = table.rows.emplace_back();
    row = {part, std::int64_t{particle}, context_.species()[species_of(particle, state)].name};
    row.insert(row.end(), cells.begin(), cells.end());
    if (has_velocity && state.velocity.size() > 0)
        for (const float along : state.velocity.row(particle)) row.emplace_back(along);
    row.resize(table.columns.size());
}

}  // namespace carom
