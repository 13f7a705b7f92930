#include "panels/gas/particle_panel.h"

#include "panels/chosen.h"

namespace carom {

void ParticlePanel::draw_key(Canvas& canvas, const DrawContext& dc, const DrawContext& own) const {
    const Rect left = arrows_.draw_key(canvas, dc, scale_in(own));
    colors_.draw_key(canvas, {left, dc.unit, dc.theme, dc.disks});
}

void ParticlePanel::see(const FrameInput& input, const Eigen::ArrayXXd& places,
                        ParticleState& state) {
    const double mean_speed = input.speed.mean();
    state.place = places.cast<float>();
    if (arrows_.shown()) state.velocity = input.sample.velocity.cast<float>();
    const Eigen::ArrayXXd& velocity = input.sample.velocity;
    const auto direction = [&](Eigen::Index i) -> Eigen::Array2d {
        return {velocity(i, 0), velocity.cols() == 2 ? velocity(i, 1) : 0.0};
    };
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        state.shades.push_back(colors_.shade(i, {input.speed[i], direction(i), mean_speed}));
    state.label_alpha = name_alpha(context_, input.tick);
    ghosts_.see(input.tick, places);
    state.ghosts = ghosts_.present();
    state.ghost_words = ghosts_.words_alpha(input.tick);
    state.flashes = flashes_.at(input.tick);
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
