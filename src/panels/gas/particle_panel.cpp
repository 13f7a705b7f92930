#include "panels/gas/particle_panel.h"

#include <algorithm>
#include <cmath>

#include "panels/archived.h"
#include "panels/chosen.h"
#include "physics/mechanics.h"
#include "util/text.h"

namespace carom {

void ParticlePanel::draw_key(Canvas& canvas, const DrawContext& dc, const DrawContext& own) const {
    DrawContext left{arrows_.draw_key(canvas, dc, scale_in(own)), dc.unit, dc.theme, dc.disks};
    if (field_.shown()) {
        DrawContext lower = left;
        left.area.height = colors_.key_height(left);
        const double taken = left.area.height > 0.0 ? left.area.height + 1.2 * dc.unit : 0.0;
        lower.area = {lower.area.x, lower.area.y + taken, lower.area.width,
                      lower.area.height - taken};
        field_.draw_key(canvas, lower, scale_in(own));
        if (taken == 0.0) return;
    }
    colors_.draw_key(canvas, left);
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
}

void ParticlePanel::see(const FrameInput& input, const Eigen::ArrayXXd& places,
                        ParticleState& state) {
    const double mean_speed = mean_of_speeds(context_.particles, input.speed);
    state.place = places.cast<float>();
    if (arrows_.shown()) state.velocity = input.sample.velocity.cast<float>();
    const Eigen::ArrayXXd& velocity = input.sample.velocity;
    const auto direction = [&](Eigen::Index i) -> Eigen::Array2d {
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
    state.rings = spotlights_.rings(input.tick, input.is_still);
    state.callouts = callouts_.at(input.tick, input.is_still);
    if (camera_.moves()) state.view = camera_.next();
    state.field = field_.see(input);
}

void draw_where(Canvas& canvas, const DrawContext& dc, const Rect& picture, const Rect& part,
                double shape, double scale, double share, Language language) {
    const double u = dc.unit, most = 6.0 * u;
    const double width = shape > 1.0 ? most / shape : most, height = width * shape;
    const double least = 0.5 * u;  // a line has a map too
    const Rect map{picture.x + 1.1 * u, picture.bottom() - 1.1 * u - std::max(least, height), width,
                   std::max(least, height)};
    const double most_length = 0.2 * picture.width / scale;
    const double power = std::pow(10.0, std::floor(std::log10(most_length)));
    double length = power;
    for (const double digit : {2.0, 5.0})
        if (digit * power <= most_length) length = digit * power;
    const double bar = length * scale, left = map.right() + 1.2 * u;
    canvas.fill({picture.x + 0.4 * u, map.y - 0.7 * u, left + bar - picture.x + 0.6 * u,
                 picture.bottom() - map.y + 0.3 * u},
                with_alpha(dc.theme.ground, plate_alpha * share));
    canvas.stroke_rect(map, 0.07 * u, with_alpha(dc.theme.muted, share));
    const auto across = [&](double x) { return map.x + std::clamp(x, 0.0, 1.0) * map.width; };
    const auto down = [&](double y) { return map.y + std::clamp(y, 0.0, 1.0) * map.height; };
    canvas.stroke_rect({across(part.x), down(part.y), across(part.right()) - across(part.x),
                        down(part.bottom()) - down(part.y)},
                       0.14 * u, with_alpha(dc.theme.highlight, share));
    const double y = map.bottom();
    const Color ink = with_alpha(dc.theme.ink, share);
    canvas.stroke_line({left, y}, {left + bar, y}, 0.14 * u, ink);
    for (const double end : {left, left + bar})
        canvas.stroke_line({end, y - 0.3 * u}, {end, y + 0.07 * u}, 0.1 * u, ink);
    TextStyle style = label_style(dc);
    style.color = ink;
    style.align = Align::center;
    draw_text(canvas, {left + 0.5 * bar, y - 0.6 * u}, plain_number(language, length), style);
}

void ParticlePanel::archive_progress(Archive& archive) {
    archive(ghosts_);
    camera_.archive_progress(archive);
    field_.archive_progress(archive);
}

bool ParticlePanel::is_filled(Eigen::Index particle) const {
    return context_.scene.looks[static_cast<std::size_t>(context_.particles.species[particle])]
        .fill;
}

void ParticlePanel::add_row(Table& table, const char* part, Eigen::Index particle,
                            std::vector<Cell> cells, const Eigen::ArrayXXf& velocity) const {
    const auto species = static_cast<std::size_t>(context_.particles.species[particle]);
    std::vector<Cell>& row = table.rows.emplace_back();
    row = {part, std::int64_t{particle}, context_.scene.gas.species[species].name};
    row.insert(row.end(), cells.begin(), cells.end());
    if (velocity.size() > 0)
        for (const float along : velocity.row(particle)) row.emplace_back(along);
    row.resize(table.columns.size());
}

}  // namespace carom
