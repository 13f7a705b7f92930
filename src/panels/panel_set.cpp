#include "panels/panel_set.h"

#include <algorithm>

#include "panels/archived.h"
#include "panels/echo/echo_record.h"
#include "panels/gas/particle_panel.h"
#include "panels/precision.h"
#include "panels/registry.h"
#include "panels/shared_panel.h"
#include "panels/words/monitors_panel.h"
#include "panels/words/text_panel.h"
#include "scene/describe.h"

namespace carom {
namespace {

std::optional<Showing> showing_of(const Scene& scene, std::size_t panel) {
    const TimeSpan& span = scene.film.panels[panel].show;
    if (span.from <= 0.0 && !span.until) return std::nullopt;
    return showing(timeline(scene), scene.film, span);
}

}  // namespace

void RunStart::archive(Archive& archive) { archive(particles, sample); }

PanelSet::Run::Run(const Scene& its_scene, const Particles& its_particles, const Sample& start)
    : scene(its_scene),
      particles(its_particles),
      gas(scene.gas.box, scene.run.events, particles, start) {}

FrameInput PanelSet::Run::input(const Tick& tick, const Sample& sample,
                                const AdvanceResult& advanced) {
    speed = speeds(sample);
    energy = kinetic_energies(particles, sample);
    return {tick, sample, speed, energy, advanced};
}

PanelSet::PanelSet(const Scene& scene, const std::vector<RunStart>& starts) {
    refuse_long_words(scene);
    const std::vector<const Scene*> scenes = scenes_of_film(scene);
    for (std::size_t run = 0; run < starts.size(); ++run)
        runs_.push_back(
            std::make_unique<Run>(*scenes.at(run), starts[run].particles, starts[run].sample));
    add_boxes(scene.film.layout);
    for (std::size_t run = 0; run < starts.size(); ++run) make_room(run, starts[run].sample);
    if (is_compared()) share_ranges_of_lines();
    add_film_panels(scene.film.layout);
    std::vector<Slot> places;
    for (const Placed& placed : std::span(panels_).last(scene.film.panels.size()))
        places.push_back(placed.slot);
    refuse_long_words(scene, places);
}

// So that which numbers are shown is known before the run.
void PanelSet::make_room(std::size_t run, const Sample& start) {
    const Eigen::ArrayXd speed = speeds(start);
    const Eigen::ArrayXd energy = kinetic_energies(runs_[run]->particles, start);
    for (const Placed& placed : panels_)
        if (auto* numbers = dynamic_cast<MonitorsPanel*>(placed.panel.get());
            numbers && placed.run == run)
            numbers->expect(speed, energy);
}

void PanelSet::share_ranges_of_lines() {
    std::vector<MonitorsPanel*> lines;
    for (std::size_t run = 0; run < runs_.size(); ++run)
        lines.push_back(&dynamic_cast<MonitorsPanel&>(*line_of_run(run).panel));
    MonitorsPanel::share_ranges(lines);
}

PanelSet::PanelSet(const Scene& scene, const Particles& particles, const Sample& start, int frames,
                   const std::vector<PanelSpec>& specs) {
    constexpr bool in_film = false;
    is_film_ = in_film;
    Run& run = *runs_.emplace_back(std::make_unique<Run>(scene, particles, start));
    const PanelContext context{scene, run.particles, frames, run.gas, in_film};
    for (const PanelSpec& spec : specs) panels_.push_back({{}, make_panel(context, spec)});
}

const carom::Run& PanelSet::run_in(std::size_t box) const { return runs_[box]->scene.run; }

PanelContext PanelSet::context_of(std::size_t run) const {
    const Run& its = *runs_[run];
    return {its.scene, its.particles, frame_count(scene().film), its.gas};
}

// Adds the box and the row of numbers. For several runs: a box for each, or one for all, with a
// line of each run's numbers below, and the row shows the time only.
void PanelSet::add_boxes(const LayoutSpec& layout) {
    const Film& film = scene().film;
    if (!is_compared()) {
        panels_.push_back({layout.gas, make_gas_panel(context_of(own))});
        return add_numbers(layout, film.monitors);
    }
    const Box& box = scene().gas.box;
    const double shape = box.dimension == 1 ? 0.0 : box.size[1] / box.size[0];
    const bool is_overlaid = film.runs.is_overlaid;
    const Grid grid(film, layout);
    const std::vector<PlaceBeside> places =
        is_overlaid ? places_overlaid(layout.gas, shape, grid, runs_.size())
                    : places_beside(layout.gas, shape, grid, runs_.size());
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        const PanelContext context = context_of(run);
        PanelContext of_box = context;
        if (is_overlaid) of_box.run_in_box = run;
        panels_.push_back({places.at(run).box, make_gas_panel(of_box), {}, run});
        runs_[run]->line = panels_.size();
        panels_.push_back({places.at(run).words,
                           make_run_line(context, film.monitors, film.runs.labels(), run),
                           {},
                           run});
    }
    add_numbers(layout, {Monitor::time});
}

// A clock and the other numbers, or all in one row.
void PanelSet::add_numbers(const LayoutSpec& layout, std::vector<Monitor> numbers) {
    const PanelContext context = context_of(own);
    if (layout.clock) {
        panels_.push_back({*layout.clock, make_clock(context)});
        if (numbers.empty()) numbers = {Monitor::collisions};
        std::erase(numbers, Monitor::time);
        if (numbers.empty()) return;
    }
    if (!layout.monitors) return;
    panels_.push_back({*layout.monitors, is_one_line(*layout.monitors)
                                             ? make_numbers_line(context, numbers)
                                             : make_monitors(context, numbers)});
}

void PanelSet::add_film_panels(const LayoutSpec& layout) {
    const Film& film = scene().film;
    std::vector<std::unique_ptr<Panel>> panels;
    std::vector<std::optional<double>> enough;
    for (const PanelSpec& spec : film.panels) {
        panels.push_back(make_panel(context_of(own), spec));
        enough.push_back(panels.back()->enough_height());
    }
    const std::vector<Slot> slots =
        with_heights(shared_slots(places_of_panels(layout), panels.size()), enough);
    const Grid grid(film, layout);
    const double end_of_box = boxes(grid).front().right();
    for (std::size_t i = 0; i < panels.size(); ++i) {
        Placed::Stand stand = Placed::Stand::own_place;
        if (is_within(slots[i], layout.gas))
            stand = grid.place(slots[i]).x < end_of_box ? Placed::Stand::over_box
                                                        : Placed::Stand::beside_box;
        panels_.push_back({on_plate(slots[i], layout, grid), std::move(panels[i]),
                           showing_of(scene(), i), own, stand});
        if (dynamic_cast<SharedPanel*>(panels_.back().panel.get()) == nullptr) continue;
        for (std::size_t run = 1; run < runs_.size(); ++run)
            panels_.back().of_others.push_back(
                make_panel(context_of(run), runs_[run]->scene.film.panels.at(i)));
    }
}

// Places over the gas move with the lower right corner of the box. Where the box leaves enough of
// its place free to the right, the first of them stands there instead.
std::vector<Slot> PanelSet::places_of_panels(const LayoutSpec& layout) const {
    constexpr double least_beside = 20.0, gap = 1.6, tallest = 0.8;  // units; of the width
    std::vector<Slot> places = layout.panels;
    const Grid grid(scene().film, layout);
    const Rect box = boxes(grid).front(), whole = grid.place(layout.gas);
    const double right = (whole.right() - box.right()) / whole.width * layout.gas.width;
    const double below = (whole.bottom() - box.bottom()) / whole.height * layout.gas.height;
    bool is_first = true;
    for (Slot& place : places) {
        if (!is_within(place, layout.gas)) continue;
        const double end = layout.gas.x + layout.gas.width;
        if (is_first && right >= grid.width_of(least_beside)) {
            place.x = end - right + grid.width_of(gap);
            place.width = end - place.x;
            place.y = layout.gas.y;
            place.height =
                std::min(layout.gas.height - below, grid.shape_of(tallest) * place.width);
        } else {
            place.x -= right;
            place.y -= below;
        }
        is_first = false;
    }
    return places;
}

bool PanelSet::Placed::is_box() const {
    return dynamic_cast<const ParticlePanel*>(panel.get()) != nullptr;
}

double PanelSet::Placed::opacity(const Film& film, const Tick& tick) const {
    constexpr double fade_seconds = 0.5, enter_seconds = 0.6;
    return showing ? carom::opacity(*showing, film, tick.frame,
                                    stand == Stand::own_place ? fade_seconds : enter_seconds)
                   : 1.0;
}

void PanelSet::enter_with_collisions() {
    if (!is_film_ || !first_collision_) return;
    for (Placed& placed : panels_)
        if (placed.stand != Placed::Stand::own_place && !placed.showing)
            placed.showing = showing(timeline(scene()), scene().film, {*first_collision_, {}});
}

// Those of the film's own run.
void PanelSet::share_colors() {
    if (const auto* gas = dynamic_cast<const ParticlePanel*>(panels_.front().panel.get());
        gas && is_film_)
        for (const Placed& placed : panels_) placed.panel->take_colors(gas->colors());
}

std::vector<Rect> PanelSet::boxes(const Grid& grid) const {
    std::vector<Rect> all;
    for (const Placed& placed : panels_)
        if (placed.is_box())
            all.push_back(placed.panel->frame_in(grid.place(placed.slot), grid.unit()));
    return all;
}

double PanelSet::scale(const Grid& grid) const {
    DiskPainter disks;
    const Placed& box = panels_.front();
    return dynamic_cast<const ParticlePanel&>(*box.panel)
        .scale_in({grid.place(box.slot), grid.unit(), theme_of(scene().film), disks});
}

// Calls f(panel, run) for each panel with the index of the run that it sees.
template <typename Function>
void PanelSet::for_each_panel(Function&& f) const {
    for (const Placed& placed : panels_) {
        f(*placed.panel, placed.run);
        for (std::size_t k = 0; k < placed.of_others.size(); ++k) f(*placed.of_others[k], k + 1);
    }
}

void PanelSet::ask(std::vector<WordRequest> requests) {
    if (!requests.empty()) numbers_.emplace(context_of(own), std::move(requests));
}

std::vector<std::string> PanelSet::number_texts() const {
    return numbers_ ? numbers_->texts() : std::vector<std::string>{};
}

bool PanelSet::wants_collisions() const {
    bool any = numbers_ && numbers_->need_collisions();
    for_each_panel([&](const Panel& panel, std::size_t) {
        any = any || panel.wants_collisions() || panel.surveys_collisions();
    });
    return any;
}

bool PanelSet::wants_return_distances() const {
    bool any = false;
    for_each_panel(
        [&](const Panel& panel, std::size_t) { any = any || panel.wants_return_distances(); });
    return any;
}

// The samples of the run are moments only if a panel measures.
std::vector<SeenMoment> PanelSet::moments(std::size_t run, const std::vector<Tick>& ticks) const {
    bool any = numbers_ && run == own;
    for_each_panel([&](const Panel& panel, std::size_t its) {
        any = any || (its == run && panel.surveyed_at() != SurveyedAt::frames);
    });
    return any ? moments_of(ticks, runs_[run]->scene.run) : moments_of(ticks);
}

std::vector<double> PanelSet::return_times(std::size_t run, const std::vector<Tick>& ticks) const {
    bool any = false;
    for_each_panel([&](const Panel& panel, std::size_t its) {
        any = any || (its == run && panel.wants_return_distances());
    });
    if (!any) return {};
    return carom::return_times(runs_[run]->scene, runs_[run]->particles.count(), ticks);
}

void PanelSet::survey(std::size_t run, const SeenMoment& moment, const Sample& sample,
                      const AdvanceResult& advanced, std::span<const Collision> since_frame) {
    if (is_card(moment.tick.phase)) return;
    if (run == own && moment.is_frame && !first_collision_ && advanced.counts.particle > 0)
        first_collision_ = moment.tick.time;
    FrameInput now = runs_[run]->input(moment.tick, sample, advanced);
    now.is_frame = moment.is_frame;
    now.is_sample = moment.is_sample;
    if (numbers_ && run == own) numbers_->see(now);
    AdvanceResult of_frame = advanced, of_sample = advanced;
    of_frame.collisions = since_frame;
    JoinedCollisions& since_sample = runs_[run]->since_sample;
    if (!moment.is_sample)
        since_sample.add(advanced.collisions);
    else
        of_sample.collisions = since_sample.take(advanced.collisions);
    const auto with = [&](const AdvanceResult& its) {
        return FrameInput{now.tick,     now.sample,   now.speed,
                          now.energy,   its,          now.refreshes_readouts,
                          now.is_still, now.is_frame, now.is_sample};
    };
    for_each_panel([&](Panel& panel, std::size_t its) {
        if (its != run) return;
        const SurveyedAt at = panel.surveyed_at();
        if (at == SurveyedAt::both)
            panel.survey(now);
        else if (at == SurveyedAt::samples && moment.is_sample)
            panel.survey(with(of_sample));
        else if (at == SurveyedAt::frames && moment.is_frame)
            panel.survey(with(of_frame));
    });
}

void PanelSet::fix_axes() {
    if (is_compared())
        fix_axes_of_runs();
    else
        for (const Placed& placed : panels_) placed.panel->fix_axes();
    enter_with_collisions();
    share_colors();
}

// The boxes get common scales of colours and arrows, and each plot has common axes.
void PanelSet::fix_axes_of_runs() {
    std::vector<ParticlePanel*> boxes;
    for (const Placed& placed : panels_) {
        std::vector<Panel*> others;
        for (const auto& panel : placed.of_others) others.push_back(panel.get());
        if (auto* box = dynamic_cast<ParticlePanel*>(placed.panel.get()))
            boxes.push_back(box);
        else if (others.empty())
            placed.panel->fix_axes();
        else
            dynamic_cast<SharedPanel&>(*placed.panel)
                .fix_axes_of_runs(others, scene().film.runs.labels());
    }
    ParticlePanel::share_scales(boxes);
    share_ranges_of_lines();
}

Recording PanelSet::record(std::size_t run, Simulation start, const std::vector<Tick>& ticks,
                           const Recording::Viewer& see, const Survey& how) {
    bool are_positions_wanted = numbers_ && run == own;
    for_each_panel([&](const Panel& panel, std::size_t its) {
        are_positions_wanted = are_positions_wanted || (its == run && panel.surveys_positions());
    });
    const Recording::Wanted wanted{.collisions = wants_collisions(),
                                   .first_collisions = how.all_collisions,
                                   .return_times = return_times(run, ticks),
                                   .frames = how.frames,
                                   .later_positions = !how.frames || are_positions_wanted,
                                   .aside = how.aside};
    Recording recording;
    with_places_of_errors(runs_[run]->scene, [&] {
        recording = Recording(
            std::move(start), how.only_frames ? moments_of(ticks) : moments(run, ticks), wanted,
            [&](const SeenMoment& moment, const Sample& sample, const AdvanceResult& advanced,
                std::span<const Collision> since_frame) {
                AdvanceResult surveyed = advanced;
                if (!wanted.collisions) surveyed.collisions = {};  // as in the second pass
                survey(run, moment, sample, surveyed,
                       wanted.collisions ? since_frame : std::span<const Collision>{});
                if (!moment.is_frame) return;
                AdvanceResult whole = advanced;
                whole.collisions = since_frame;
                see(moment.tick, sample, whole);
            },
            how.room);
    });
    return recording;
}

void PanelSet::archive(Archive& archive) {
    for_each_panel([&](Panel& panel, std::size_t) { panel.archive(archive); });
    archive(first_collision_);
    if (!archive.is_reading()) return;
    enter_with_collisions();
    share_colors();
}

void PanelSet::archive_progress(Archive& archive) {
    for_each_panel([&](Panel& panel, std::size_t) { panel.archive_progress(archive); });
}

bool PanelSet::refreshes_readouts(const Tick& tick) const {
    constexpr int readouts_a_second = 5;
    return !is_film_ || tick.phase != Phase::moving ||
           tick.frame % std::max(1, scene().film.fps / readouts_a_second) == 0;
}

PanelSet::States PanelSet::film_states(const Tick& tick, const std::vector<RunFrame>& runs,
                                       bool is_still) {
    std::vector<FrameInput> inputs;
    for (std::size_t run = 0; run < runs_.size(); ++run)
        inputs.push_back(runs_[run]->input(tick, runs.at(run).sample, runs.at(run).advanced));
    for (FrameInput& input : inputs) {
        input.refreshes_readouts = is_still || refreshes_readouts(tick);
        input.is_still = is_still;
    }
    States states;
    for (const Placed& placed : panels_) {
        States of_runs{placed.panel->state(inputs.at(placed.run))};
        for (const auto& panel : placed.of_others)
            of_runs.push_back(panel->state(inputs.at(of_runs.size())));
        states.push_back(
            of_runs.size() == 1
                ? std::move(of_runs.front())
                : dynamic_cast<const SharedPanel&>(*placed.panel).state_of_runs(of_runs));
    }
    return states;
}

// What is behind a card: the first frame of the gas, or the last. Panels do not keep that they were
// asked for it, since cards are no part of what they see.
PanelSet::States PanelSet::states_behind_card(const Tick& tick, const std::vector<RunFrame>& runs) {
    const CardFrames cards = card_frames(scene().film);
    const bool is_title = tick.phase == Phase::title_card;
    Tick shown = tick;
    shown.frame = is_title ? cards.title : frame_count(scene().film) - cards.end - 1;
    shown.phase = is_title ? Phase::opening : Phase::closing;
    shown.progress = is_title ? 0.0 : 1.0;
    shown.seconds =
        is_title ? 0.0 : static_cast<double>(shown.frame - cards.title) / scene().film.fps;
    Archive written;
    archive_progress(written);
    States states = film_states(shown, runs, false);
    Archive read(written.finished(), "progress");
    archive_progress(read);
    return states;
}

FrameData PanelSet::frame_data(const Tick& tick, const std::vector<RunFrame>& runs, bool is_still) {
    FrameData frame{tick, {}, 0};
    if (!is_card(tick.phase)) {
        frame.states = film_states(tick, runs, is_still);
    } else {
        if (card_phase_ != tick.phase) behind_card_ = states_behind_card(tick, runs);
        card_phase_ = tick.phase;
        frame.states = behind_card_;
    }
    for (const auto& state : frame.states) frame.bytes += state->bytes();
    return frame;
}

std::vector<std::shared_ptr<const PanelState>> PanelSet::states(
    const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
    const std::function<bool(std::size_t)>& is_shown) {
    std::vector<std::shared_ptr<const PanelState>> states(panels_.size());
    const FrameInput input = runs_[own]->input(tick, sample, advanced);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        if (is_shown(i))
            states[i] = panels_[i].panel->state(input);
        else
            panels_[i].panel->see(input);
    }
    return states;
}

}  // namespace carom
