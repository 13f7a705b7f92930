#include "panels/gas/gas_panel.h"

#include <algorithm>
#include <cmath>

#include "panels/archived.h"
#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/gas_state.h"

namespace carom {
namespace {

constexpr double default_trail_seconds = 1.0;

}  // namespace

GasPanel::GasPanel(const PanelContext& context)
    : context_(context),
      colors_(context),
      arrows_(context),
      ghosts_(context.scene),
      flashes_(context) {
    choose_particles();
    trails_.resize(chosen_.size());
}

void GasPanel::survey(const FrameInput& input) {
    colors_.survey(input);
    arrows_.survey(input);
    flashes_.survey(input, [this](const Collision& collision) {
        const double first = context_.particles.radius[collision.first];
        const double share =
            first / (first + context_.particles.radius[collision.second.particle()]);
        Eigen::Array2d at = collision.first_position +
                            share * (collision.second_position - collision.first_position);
        const Box& box = context_.scene.gas.box;
        return Point{box.wrapped(0, at[0]), box.wrapped(1, at[1])};
    });
}

// A fast disk's arrow is twice as long as a disk is wide, unless that is hardly seen or fills the
// box.
void GasPanel::fix_axes() {
    colors_.fix_scale();
    flashes_.fix_scale();
    const double side = context_.scene.gas.box.size.minCoeff();
    arrows_.fix_scale(std::clamp(4.0 * context_.particles.radius.mean(), 0.05 * side, 0.2 * side));
}

void GasPanel::archive(Archive& archive) { archive(colors_, arrows_, flashes_); }

// Those that should have a trail, and a single particle among many, which is what the film is
// about.
void GasPanel::choose_particles() {
    for (Eigen::Index i = 0; i < context_.particles.count(); ++i) {
        const auto species = static_cast<std::size_t>(context_.particles.species[i]);
        const bool single =
            context_.scene.gas.species[species].count == 1 && context_.particles.count() > 10;
        const double trail =
            asked_trail(context_, i).value_or(single ? default_trail_seconds : 0.0);
        if (trail > 0.0) chosen_.push_back({i, trail});
    }
}

void GasPanel::extend_trails(const FrameInput& input) {
    const double elapsed = 1.0 / context_.scene.film.fps;
    const bool moves = input.tick.time > last_time_;
    if (moves) moving_seconds_ += elapsed;
    const double pace = moves ? elapsed / (input.tick.time - last_time_) : 0.0;
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
        std::deque<TrailPoint>& trail = trails_[k];
        const auto particle = static_cast<std::int32_t>(chosen_[k].particle);
        for (const Collision& collision : input.advanced.collisions) {
            if (collision.first != particle && collision.second != particle) continue;
            const Eigen::Array2d& at =
                collision.first == particle ? collision.first_position : collision.second_position;
            trail.push_back(
                {moving_seconds_ - (input.tick.time - collision.time) * pace, {at[0], at[1]}});
        }
        trail.push_back({moving_seconds_,
                         {input.sample.position(chosen_[k].particle, 0),
                          input.sample.position(chosen_[k].particle, 1)}});
        while (trail.front().film_time < moving_seconds_ - chosen_[k].trail_seconds)
            trail.pop_front();
    }
    last_time_ = input.tick.time;
}

std::shared_ptr<const PanelState> GasPanel::state(const FrameInput& input) {
    auto state = std::make_shared<GasState>();
    const double mean_speed = input.speed.mean();
    const Eigen::Index n = context_.particles.count();
    for (Eigen::Index i = 0; i < n; ++i) {
        state->x.push_back(static_cast<float>(input.sample.position(i, 0)));
        state->y.push_back(static_cast<float>(input.sample.position(i, 1)));
        state->shades.push_back(colors_.shade(i, input.speed[i], mean_speed));
        if (!arrows_.shown()) continue;
        state->vx.push_back(static_cast<float>(input.sample.velocity(i, 0)));
        state->vy.push_back(static_cast<float>(input.sample.velocity(i, 1)));
    }
    ghosts_.see(input.tick, input.sample.position);
    state->ghosts = ghosts_.present();
    state->ghost_words = ghosts_.words_alpha(input.tick);
    state->flashes = flashes_.at(input.tick);
    extend_trails(input);
    for (const std::deque<TrailPoint>& trail : trails_) {
        GasState::Trail& copy = state->trails.emplace_back();
        for (const TrailPoint& point : trail) {
            copy.places.push_back(point.place);
            copy.ages.push_back(static_cast<float>(moving_seconds_ - point.film_time));
        }
    }
    state->label_alpha = static_cast<float>(name_alpha(context_, input.tick));
    return state;
}

bool GasPanel::stands_alone() const {
    const LayoutSpec& layout = context_.scene.film.layout;
    const double right = layout.gas.x + layout.gas.width;
    return std::ranges::none_of(layout.panels, [&](const Slot& slot) { return slot.x >= right; });
}

Rect GasPanel::frame_in(const Rect& area) const {
    const Eigen::Array2d& size = context_.scene.gas.box.size;
    const double scale = std::min(area.width / size[0], area.height / size[1]);
    const double width = size[0] * scale, height = size[1] * scale;
    const double left = stands_alone() ? (area.width - width) / 2 : 0.0;
    return {area.x + left, area.y + (area.height - height) / 2, width, height};
}

std::string GasPanel::label(std::size_t particle, const PanelState& state) const {
    const auto i = static_cast<Eigen::Index>(particle);
    const std::string words = words_on(context_, i, context_.scene.film.labels);
    const bool named =
        static_cast<const GasState&>(state).label_alpha > 0.0F &&
        std::ranges::any_of(chosen_, [i](const Chosen& c) { return c.particle == i; });
    return words.empty() && named ? single_name(context_, i) : words;
}

// Places are those of the picture, in single precision.
Table GasPanel::table(const PanelState& state, const Theme& theme) const {
    const auto& gas = static_cast<const GasState&>(state);
    Table table{{"part", "particle", "species", column_name("x", reduced::length),
                 column_name("y", reduced::length), column_name("radius", reduced::length),
                 "colour", "label"}};
    if (arrows_.shown())
        for (const char* name : {"velocity x", "velocity y"})
            table.columns.push_back(column_name(name, reduced::speed));
    const std::vector<Color> colors = colors_.of_shades(theme);
    const auto add = [&](const char* part, std::size_t i, Cell x, Cell y, Cell radius, Cell color,
                         Cell label) {
        const int species = context_.particles.species[static_cast<Eigen::Index>(i)];
        table.rows.push_back({part, static_cast<std::int64_t>(i),
                              context_.scene.gas.species[static_cast<std::size_t>(species)].name,
                              std::move(x), std::move(y), std::move(radius), std::move(color),
                              std::move(label)});
        table.rows.back().resize(table.columns.size());
    };
    const Eigen::ArrayXd& radius = context_.particles.radius;
    for (std::size_t i = 0; i < gas.x.size(); ++i) {
        add("disk", i, gas.x[i], gas.y[i], radius[static_cast<Eigen::Index>(i)],
            hex_of(colors[gas.shades[i] % colors.size()]), label(i, state));
        if (gas.vx.empty()) continue;
        table.rows.back()[8] = gas.vx[i];
        table.rows.back()[9] = gas.vy[i];
    }
    for (std::size_t k = 0; k < gas.trails.size(); ++k)
        for (const Point& place : gas.trails[k].places)
            add("trail", static_cast<std::size_t>(chosen_[k].particle), place.x, place.y, {},
                hex_of(theme.ink), {});
    if (gas.ghosts)
        for (std::size_t i = 0; i < gas.ghosts->x.size(); ++i)
            add("mark", i, gas.ghosts->x[i], gas.ghosts->y[i], radius[static_cast<Eigen::Index>(i)],
                hex_of(theme.muted), gas.ghosts->words);
    return table;
}

}  // namespace carom
