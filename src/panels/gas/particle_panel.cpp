#include "panels/gas/particle_panel.h"

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

void ParticlePanel::share_scales(ParticlePanel& other) {
    colors_.add_survey(other.colors_);
    arrows_.add_survey(other.arrows_);
    field_.add_survey(other.field_);
    fix_axes();
    other.fix_axes();
    other.colors_.take_scale(colors_);
    other.arrows_.take_scale(arrows_);
    other.field_.take_scale(field_);
    share_span(other);
}

void ParticlePanel::see(const FrameInput& input, const Eigen::ArrayXXd& places,
                        ParticleState& state) {
    const double mean_speed = mean_of_speeds(context_.particles, input.speed);
    state.place = places.cast<float>();
    if (arrows_.shown()) state.velocity = input.sample.velocity.cast<float>();
    const Eigen::ArrayXXd& velocity = input.sample.velocity;
    const auto direction = [&](Eigen::Index i) -> Vec {
        return {velocity(i, 0), velocity.cols() == 2 ? velocity(i, 1) : 0.0};
    };
    state.shades.reserve(static_cast<std::size_t>(places.rows()));
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        state.shades.push_back(colors_.shade(i, {input.speed[i], direction(i), mean_speed}));
    state.label_alpha = name_alpha(context_, input.tick);
    ghosts_.see(input.tick, places);
    state.ghosts = ghosts_.present();
    state.ghost_words = ghosts_.words_alpha(input.tick);
    state.flashes = flashes_.at(input.tick);
    state.light = spotlights_.light(input.tick, input.is_still);
    fading_.see(input.tick, input.sample.position, state.light);
    state.rings = spotlights_.rings(input.tick, input.is_still);
    state.callouts = callouts_.at(input.tick, input.is_still);
    if (camera_.moves()) state.view = camera_.next();
    state.field = field_.see(input);
}

void ParticlePanel::archive_progress(Archive& archive) {
    archive(ghosts_, fading_);
    camera_.archive_progress(archive);
    field_.archive_progress(archive);
}

bool ParticlePanel::is_filled(Eigen::Index particle) const {
    return context_.looks()[static_cast<std::size_t>(context_.particles.species[particle])].fill;
}

void ParticlePanel::add_row(Table& table, const char* part, Eigen::Index particle,
                            std::vector<TableCell> cells, const Eigen::ArrayXXf& velocity) const {
    const auto species = static_cast<std::size_t>(context_.particles.species[particle]);
    std::vector<TableCell>& row = table.rows.emplace_back();
    row = {part, std::int64_t{particle}, context_.species()[species].name};
    row.insert(row.end(), cells.begin(), cells.end());
    if (velocity.size() > 0)
        for (const float along : velocity.row(particle)) row.emplace_back(along);
    row.resize(table.columns.size());
}

}  // namespace carom
