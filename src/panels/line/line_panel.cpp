#include "panels/line/line_panel.h"

#include <algorithm>
#include <cmath>

#include "panels/archived.h"
#include "panels/chosen.h"
#include "panels/gas/bead_words.h"
#include "panels/surfaces/surface_words.h"
#include "scene/film.h"
#include "stats/histogram.h"

namespace carom {
namespace {

constexpr double most_film_seconds = 12.0;  // that world lines go back
constexpr double least_film_seconds = 2.5;  // below, they would rush by
constexpr double bends_in_memory = 8.0;     // of each bead, where film seconds allow

double film_seconds_of(const Film& film, const Run& run) {
    return static_cast<double>(moving_steps(film, run)) / film.fps;
}

}  // namespace

void LinePanel::survey(const FrameInput& input) {
    if (!map_) map_.emplace(context_, input.sample);
    colors_.survey(input);
    arrows_.survey(input);
    ends_.survey(input);
    camera_.survey(input);
    field_.survey(input);
    survey_places(input);
    const CollisionCounts& counts = input.advanced.counts;
    bends_.push_back(
        {input.tick.time, 2.0 * static_cast<double>(counts.particle) + double(counts.wall)});
}

// Flashes are drawn between the two beads, or between the bead and the end, at their drawn places.
void LinePanel::survey_places(const FrameInput& input) {
    if (!flashes_.asked() && context_.film().callouts.empty()) return;
    if (surveyed_places_.size() == 0) surveyed_places_ = map_->places(input.sample, {});
    flashes_.survey(input, [this](const Collision& collision) {
        const Eigen::Index i = collision.first;
        const double toward = collision.second_position[0] - collision.first_position[0];
        const double now = map_->place(i, collision.first_position[0], surveyed_places_[i]);
        const bool is_right = toward != 0.0 || collision.second.is_surface()
                                  ? toward > 0.0
                                  : now < surveyed_places_[collision.second.particle()];
        return Vec{now + (is_right ? map_->radius(i) : -map_->radius(i)), 0.0};
    });
    surveyed_places_ = map_->places(input.sample, surveyed_places_);
    callouts_.survey(input, surveyed_places_);
}

// The median over parts of the run, so that a short burst has no influence.
double LinePanel::usual_rate() const {
    constexpr std::size_t parts = 20;
    std::vector<double> rates;
    for (std::size_t part = 0; part < parts; ++part) {
        const Bends& from = bends_[part * (bends_.size() - 1) / parts];
        const Bends& to = bends_[(part + 1) * (bends_.size() - 1) / parts];
        if (to.time > from.time) rates.push_back((to.count - from.count) / (to.time - from.time));
    }
    return rates.empty() ? 0.0
                         : quantile(rates, 0.5) / static_cast<double>(context_.particles.count());
}

// The memory is long enough for a few collisions of each bead most of the time, within limits that
// keep the world lines neither too fast nor too slow for the eye.
void LinePanel::fix_axes() {
    colors_.fix_scale();
    flashes_.fix_scale();
    field_.fix_scale();
    camera_.fix_way(ends_.extent());
    const double length = map_->length();
    const double spacing = length / static_cast<double>(context_.particles.count());
    arrows_.fix_scale(std::clamp(0.8 * spacing, 0.02 * length, 0.15 * length));
    const double until = context_.run().until;
    const double pace = until / film_seconds_of(context_.film(), context_.run());
    const double rate = usual_rate();
    const double wanted = rate > 0.0 ? bends_in_memory / rate : until;
    const double bounded = std::clamp(wanted, least_film_seconds * pace, most_film_seconds * pace);
    memory_ = std::min(until, bounded);
    if (memory_ < until) memory_ = round_up_for_axis(memory_);
    lines_.emplace(context_, *map_, colors_, memory_);
}

void LinePanel::share_span(const std::vector<ParticlePanel*>& others) {
    std::vector<LinePanel*> all{this};
    for (ParticlePanel* other : others) all.push_back(&dynamic_cast<LinePanel&>(*other));
    double memory = 0.0;
    for (const LinePanel* panel : all) memory = std::max(memory, panel->memory_);
    for (LinePanel* panel : all) {
        panel->memory_ = memory;
        panel->lines_.emplace(panel->context_, *panel->map_, panel->colors_, memory);
    }
}

void LinePanel::archive(Archive& archive) {
    archive(colors_, arrows_, flashes_, map_, memory_, ends_, camera_, callouts_, field_);
    if (archive.is_reading()) lines_.emplace(context_, *map_, colors_, memory_);
}

std::shared_ptr<const PanelState> LinePanel::state(const FrameInput& input) {
    auto state = std::make_shared<State>();
    state->time = input.tick.time;
    if (last_places_.size() == 0) last_places_ = map_->places(input.sample, {});
    const Eigen::ArrayXd places = map_->places(input.sample, last_places_);
    see(input, places, *state);
    lines_->see(input, places, last_places_);
    last_places_ = places;
    for (std::size_t line = 0; line < lines_->count(); ++line) {
        const Eigen::Index i = lines_->particle(line);
        std::vector<WorldLines::Bend>& its = state->lines.emplace_back();
        if (state->is_shown(i))
            its = lines_->line(
                line, {state->time, places[i], state->shades[static_cast<std::size_t>(i)]});
    }
    state->reversals = lines_->reversals(state->time);
    state->ends = ends_.see(input, memory_);
    return state;
}

void LinePanel::archive_progress(Archive& archive) {
    ParticlePanel::archive_progress(archive);
    archive(*lines_, last_places_);
    ends_.archive_progress(archive);
}

std::string LinePanel::account(const PanelState& state) const {
    const auto& now = static_cast<const State&>(state);
    std::vector<SurfaceState> states;
    for (const LineEnds::End& end : now.ends) states.push_back(end.state);
    if (!states.empty()) states.resize(4);
    const std::string words =
        words_at_present(context_.language(), context_.gas_in_scene(), states);
    if (!now.field) return words;
    return words + (words.empty() ? "" : " ") + field_.account(*now.field);
}

// Masses are shown by default if they differ.
Labels LinePanel::shown_labels() const {
    const Labels asked = context_.film().labels;
    const Eigen::ArrayXd& inverse_mass = context_.particles.inverse_mass;
    const bool differ = (inverse_mass != inverse_mass[0]).any();
    return asked == Labels::none && differ ? Labels::mass : asked;
}

// Places are as drawn: enlarged beads are shifted apart, and on a ring places continue beyond its
// length without jumps.
Table LinePanel::table(const PanelState& state, const Theme& theme) const {
    const auto& now = static_cast<const State&>(state);
    Table table{{"part",
                 "particle",
                 "species",
                 {"x as drawn", quantities::length},
                 quantities::time,
                 {"radius as drawn", quantities::length},
                 "colour",
                 "label"}};
    if (arrows_.shown()) table.columns.emplace_back(quantities::velocity);
    field_.add_columns(table);
    const std::vector<Color> colors = colors_.of_shades(theme);
    const auto color = [&](std::uint16_t shade) { return hex_of(colors[shade % colors.size()]); };
    for (Eigen::Index i = 0; i < now.place.rows(); ++i) {
        if (!now.is_shown(i)) continue;
        std::string label = words_on(context_, i, shown_labels());
        if (label.empty() && now.label_alpha > 0.0 && stands_out(context_, i))
            label = single_name(context_, i);
        add_row(table, now, "bead", i,
                {now.place(i, 0), now.time, map_->radius(i),
                 color(now.shades[static_cast<std::size_t>(i)]), label},
                true);
    }
    for (std::size_t line = 0; line < now.lines.size(); ++line)
        for (const WorldLines::Bend& bend : now.lines[line])
            add_row(table, now, "world line", lines_->particle(line),
                    {bend.place, bend.time, {}, color(bend.shade)});
    if (now.ghosts)
        for (Eigen::Index i = 0; i < now.ghosts->place.rows(); ++i)
            if (!std::isnan(now.ghosts->place(i, 0)))
                add_row(table, now, "mark", i,
                        {now.ghosts->place(i, 0), now.time, map_->radius(i), hex_of(theme.muted),
                         now.ghosts->words});
    if (now.field) field_.add_rows(table, *now.field, 3, {});
    return table;
}

}  // namespace carom
