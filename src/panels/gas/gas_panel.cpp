#include "panels/gas/gas_panel.h"

#include <algorithm>
#include <cmath>

#include "panels/archived.h"
#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/registry.h"
#include "panels/surfaces/surface_words.h"
#include "physics/gas.h"
#include "physics/vec.h"
#include "scene/panel_kind.h"
#include "scene/reading/camera/camera_reading.h"

namespace carom {
namespace {

constexpr double default_trail_seconds = 1.0;

// The point of contact.
Vec contact_of(const Collision& collision, const Particles& particles) {
    if (collision.second.is_surface()) return collision.second_position;
    const double first = particles.radius[collision.first];
    const double share = first / (first + particles.radius[collision.second.particle()]);
    return collision.first_position +
           share * (collision.second_position - collision.first_position);
}

}  // namespace

GasPanel::GasPanel(const PanelContext& context, const FixedView& fixed)
    : ParticlePanel(context, fixed),
      surfaces_(context, camera_.viewpoints()),
      streaks_(context),
      radii_(std::make_shared<const DrawnRadii>(context.looks(), context.particles, Sample{})) {
    choose_particles();
    trails_.resize(followed_.size());
}

void GasPanel::survey(const FrameInput& input) {
    colors_.survey(input);
    arrows_.survey(input);
    surfaces_.survey(input);
    camera_.survey(input);
    callouts_.survey(input, input.sample.position);
    field_.survey(input);
    flashes_.survey(input, [this](const Collision& collision) {
        const Vec at = contact_of(collision, context_.particles);
        const Box& box = context_.box();
        return Vec{box.wrapped(0, at[0]), box.wrapped(1, at[1]), box.wrapped(2, at[2])};
    });
}

// The arrow of a fast disk is two diameters long, within limits relative to the box.
void GasPanel::fix_axes() {
    colors_.fix_scale();
    flashes_.fix_scale();
    field_.fix_scale();
    camera_.fix_way(surfaces_.extent());
    const double side = context_.box().shortest_side();
    arrows_.fix_scale(std::clamp(4.0 * context_.particles.radius.mean(), 0.05 * side, 0.2 * side));
    std::vector<Eigen::Index> particles;
    for (const TrailedParticle& one : followed_) particles.push_back(one.particle);
    seed_paths_ = seed_paths(context_, particles);
}

void GasPanel::archive(Archive& archive) {
    archive(colors_, arrows_, flashes_, surfaces_, camera_, callouts_, field_, seed_paths_);
}

// The particles for which a trail is asked, and those that the film is about.
void GasPanel::choose_particles() {
    for (Eigen::Index i = 0; i < context_.particles.count(); ++i) {
        const bool single = is_single_among_many(context_.scene, context_.particles, i);
        const double trail = asked_trail(context_.scene, context_.particles, i)
                                 .value_or(single ? default_trail_seconds : 0.0);
        if (trail > 0.0) followed_.push_back({i, trail});
    }
    if (followed_.empty()) return;
    trail_of_.assign(static_cast<std::size_t>(context_.particles.count()), -1);
    for (std::size_t k = 0; k < followed_.size(); ++k)
        trail_of_[static_cast<std::size_t>(followed_[k].particle)] = static_cast<std::ptrdiff_t>(k);
}

void GasPanel::extend_trails(const FrameInput& input) {
    const double elapsed = 1.0 / context_.film().fps;
    const bool moves = input.tick.time > last_time_;
    if (moves) moving_seconds_ += elapsed;
    const double pace = moves ? elapsed / (input.tick.time - last_time_) : 0.0;
    const auto visit = [&](std::int64_t particle, double time, const Vec& at) {
        const std::ptrdiff_t k = trail_of_[static_cast<std::size_t>(particle)];
        if (k < 0) return;
        trails_[static_cast<std::size_t>(k)].push_back(
            {moving_seconds_ - (input.tick.time - time) * pace, at});
    };
    if (!followed_.empty())
        for (const Collision& collision : input.advanced.collisions) {
            visit(collision.first, collision.time, collision.first_position);
            if (collision.second.is_particle())
                visit(collision.second.particle(), collision.time, collision.second_position);
        }
    for (std::size_t k = 0; k < followed_.size(); ++k) {
        const auto [particle, seconds] = followed_[k];
        std::deque<TrailPoint>& trail = trails_[k];
        if (is_present(input.sample, particle))
            visit(particle, input.tick.time, vec_in(input.sample.position, particle));
        while (!trail.empty() && trail.front().film_time < moving_seconds_ - seconds)
            trail.pop_front();
    }
    last_time_ = input.tick.time;
}

std::shared_ptr<const PanelState> GasPanel::state(const FrameInput& input) {
    auto state = std::make_shared<State>();
    state->time = input.tick.time;
    if (see(input, input.sample.position, *state))
        radii_ =
            std::make_shared<const DrawnRadii>(context_.looks(), context_.particles, input.sample);
    state->radii = radii_;
    state->surfaces = surfaces_.states(input);
    state->streaks = streaks_.see(input);
    extend_trails(input);
    state->trails.reserve(trails_.size());
    for (const std::deque<TrailPoint>& trail : trails_) {
        Trail& copy = state->trails.emplace_back();
        copy.places.reserve(trail.size());
        copy.ages.reserve(trail.size());
        for (const TrailPoint& point : trail) {
            copy.places.push_back(point.place);
            copy.ages.push_back(static_cast<float>(moving_seconds_ - point.film_time));
        }
    }
    return state;
}

void GasPanel::archive_progress(Archive& archive) {
    ParticlePanel::archive_progress(archive);
    streaks_.archive_progress(archive);
    archive(trails_, moving_seconds_, last_time_);
}

bool GasPanel::stands_alone() const { return context_.film().layout.panels.empty(); }

BoxMap GasPanel::map_in(const DrawContext& own) const {
    return surfaces_.map_in(own.area, own.unit, stands_alone());
}

BoxMap GasPanel::map_from(const DrawContext& own, const Viewpoint& from) const {
    BoxMap map = map_in(own);
    if (map.space) map.space = map.space->seen_from(from);
    return map;
}

// The map of a view, which is drawn in the same rectangle as the whole box.
BoxMap GasPanel::part_of(const BoxMap& whole, const CameraView& view) const {
    BoxMap part = whole;
    if (whole.space) {
        const Region& all = surfaces_.extent();
        const double zoom = (all.high[0] - all.low[0]) / view.width;
        part.space = whole.space->magnified(view.middle, zoom);
        part.scale = zoom * whole.scale;
        return part;
    }
    part.scale = whole.frame.width / view.width;
    part.low = {view.middle[0] - 0.5 * view.width,
                view.middle[1] - 0.5 * whole.frame.height / part.scale};
    return part;
}

Rect GasPanel::frame_in(const Rect& area, double unit) const {
    return surfaces_.whole(surfaces_.map_in(area, unit, stands_alone()), unit);
}

double GasPanel::scale_in(const DrawContext& own) const { return map_in(own).scale; }

std::string GasPanel::account(const PanelState& state) const {
    const auto& now = static_cast<const State&>(state);
    const std::string words =
        words_at_present(context_.language(), context_.gas_in_scene(), now.surfaces);
    if (!now.field) return words;
    return words + (words.empty() ? "" : " ") + field_.account(*now.field);
}

std::string GasPanel::label(Eigen::Index particle, const State& state) const {
    const std::string words = words_on(context_, particle, context_.film().labels);
    const bool named =
        state.label_alpha > 0.0 && std::ranges::any_of(followed_, [&](const TrailedParticle& f) {
            return f.particle == particle;
        });
    return words.empty() && named ? single_name(context_, particle) : words;
}

// Positions are those of the picture, in single precision.
Table GasPanel::table(const PanelState& state, const Theme& theme) const {
    const auto& gas = static_cast<const State&>(state);
    const int dimension = context_.box().dimension;
    Table table{{"part", "particle", "species"}};
    for (int axis = 0; axis < dimension; ++axis)
        table.columns.emplace_back(name_of_axis(axis), quantities::length);
    for (const Heading& heading :
         {Heading("radius", quantities::length), Heading("colour"), Heading("label")})
        table.columns.push_back(heading);
    if (arrows_.shown())
        for (int axis = 0; axis < dimension; ++axis)
            table.columns.emplace_back(std::string("velocity ") + name_of_axis(axis),
                                       quantities::velocity);
    field_.add_columns(table);
    const auto cells = [&](const auto& place, const std::vector<TableCell>& more) {
        std::vector<TableCell> all;
        for (int axis = 0; axis < dimension; ++axis) all.emplace_back(place(axis));
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const std::vector<Color> colors = colors_.of_shades(theme);
    const Eigen::ArrayXd& radius = context_.particles.radius;
    const char* body = dimension == 3 ? "sphere" : "disk";
    for (Eigen::Index i = 0; i < gas.place.rows(); ++i) {
        if (!gas.is_shown(i)) continue;
        const std::uint16_t shade = gas.shades[static_cast<std::size_t>(i)];
        add_row(table, gas, body, i,
                cells([&](int axis) { return gas.place(i, axis); },
                      {radius[i], hex_of(colors[shade % colors.size()]), label(i, gas)}),
                true);
    }
    for (std::size_t k = 0; k < gas.trails.size(); ++k) {
        const std::uint16_t shade = gas.shades[static_cast<std::size_t>(followed_[k].particle)];
        const Color color = GasColors::is_of_species(shade) ? colors[shade] : theme.ink;
        for (const Vec& place : gas.trails[k].places)
            add_row(table, gas, "trail", followed_[k].particle,
                    cells([&](int axis) { return place[axis]; }, {{}, hex_of(color)}));
    }
    if (gas.ghosts)
        for (Eigen::Index i = 0; i < gas.ghosts->place.rows(); ++i)
            if (!std::isnan(gas.ghosts->place(i, 0)))
                add_row(table, gas, "mark", i,
                        cells([&](int axis) { return gas.ghosts->place(i, axis); },
                              {radius[i], hex_of(theme.muted), gas.ghosts->words}));
    for (std::size_t k = 0; k < gas.surfaces.size(); ++k) {
        const SurfaceState& surface = gas.surfaces[k];
        if (context_.box().surfaces.is_side(k) && !surface.motion &&
            only_reflects(surface.behaviour))
            continue;
        const Gas& its = context_.gas_in_scene();
        const int its_axis = its.box.surfaces.axis_of(k);
        const double at = place_of_surface(its.box, gas.surfaces, k);
        std::vector<TableCell>& row = table.rows.emplace_back();
        row = {"surface", {}, {}};
        const std::vector<TableCell> rest =
            cells([&](int axis) { return axis == its_axis ? TableCell(at) : TableCell(); },
                  {{}, {}, table_entry_of_surface(its, surface, k)});
        row.insert(row.end(), rest.begin(), rest.end());
        row.resize(table.columns.size());
    }
    if (gas.field) field_.add_rows(table, *gas.field, 3, 4);
    return table;
}

namespace {

struct GasOptions {
    std::optional<View> view = {};             // in a figure; none: as in the film
    std::optional<ViewpointChange> from = {};  // the same
};

std::vector<Binding<GasOptions>> gas_keys() {
    return {bind_key("view", &GasOptions::view, view_notation(),
                     "What the figure shows: the whole `box`, or a part of it.")
                .default_text("as the film's camera shows it at that time"),
            bind_key("viewpoint", &GasOptions::from, viewpoint_notation(),
                     "In space, from where the figure shows the box.")
                .default_text("as the film shows it at that time")};
}

std::unique_ptr<Panel> make_gas(const PanelContext& context, const PanelSpec& spec) {
    const auto& options = spec.options.as<GasOptions>();
    return make_gas_panel(context, {options.view, options.from});
}

}  // namespace

PanelKind gas_kind() {
    using enum Ability;
    return {
        .name = "gas",
        .words = Phrase{"gas"},
        .shows =
            "The box and everything in it, at one moment, or at several side by side (`strip`).",
        .make = make_gas,
        .abilities = {strip},
        .keys = option_keys(gas_keys()),
        .draws_box = true,
        .draws_particles = true,
        .in_films_instead = "the box is in every film; the template says where",
        .palettes = palette_names()};
}

}  // namespace carom
