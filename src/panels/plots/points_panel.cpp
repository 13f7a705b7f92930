#include "panels/plots/points_panel.h"

#include <algorithm>
#include <cmath>

#include "draw/axis.h"
#include "panels/plot/clock_samples.h"
#include "panels/plot/window.h"
#include "physics/sample_times.h"
#include "stats/histogram.h"

namespace carom {
namespace {

using plot::Role;

struct PointsState : PanelState {
    std::vector<std::vector<Point>> sets;
    std::size_t shown = 0;
    double time = 0.0;
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const std::vector<Point>& set : sets) sum += set.size() * sizeof(Point);
        return sum;
    }
};

constexpr std::size_t kept_a_frame = 200;   // numbers that the axis is fixed by
constexpr std::size_t longest_path = 5000;  // points: drawing must not grow with the film

const plot::Stroke faint{.role = {.of = Role::Of::muted}, .width = 0.06, .dashes = {0.3}};

}  // namespace

void show_samples(const PanelContext& context, const PanelSpec& spec, PointsSubject& subject) {
    const bool by_clock = spec.options.as<PointOptions>().by_clock;
    if (!by_clock) return;
    subject.is_sample = [&run = context.run()](double time) { return is_sample_time(run, time); };
    subject.shows_present = context.in_film;
    subject.corners = nullptr;
    PanelSpec so_far = spec;
    so_far.over = Over{Over::Since::start, 0.0};
    subject.remark = with_samples(context.wording(), time_words(context.wording(), so_far),
                                  by_clock, context.run());
}

std::vector<Binding<PanelSpec>> point_keys() {
    return option_keys(std::vector{samples_key(&PointOptions::by_clock)});
}

// The part of a path that a film with many frames or many collisions shows.
plot::Shown PointsPanel::Path::until(std::size_t frames) const {
    if (ends.empty()) return {0, 0};
    const std::size_t end = ends[std::min(frames, ends.size()) - 1];
    return {end > longest_path ? end - longest_path : 0, end};
}

const std::vector<Point>& PointsPanel::points(const PanelState& state, std::size_t set) {
    return static_cast<const PointsState&>(state).sets[set];
}

void PointsPanel::survey(const FrameInput& input) {
    if (subject_.widen) subject_.widen(subject_, input);
    if (subject_.is_sample) return survey_samples(input);
    paths_.resize(subject_.sets.size());
    for (std::size_t k = 0; k < paths_.size(); ++k) {
        const std::vector<Point> now = subject_.points(input, k);
        std::vector<Point> more = now;
        if (now.size() <= 1) {
            Path& path = paths_[k];
            path.ends.resize(surveyed_, path.x.size());  // frames of several points have no path
            if (subject_.corners) more = subject_.corners(input, k);
            if (subject_.corners) more.insert(more.end(), now.begin(), now.end());
            // Older points are shown by no frame and are dropped, as a run may have any number of
            // collisions.
            if (more.size() > longest_path) more.erase(more.begin(), more.end() - longest_path);
            for (const Point& point : more) {
                path.x.push_back(point.x);
                path.y.push_back(point.y);
            }
            path.ends.push_back(path.x.size());
        }
        keep_for_axis(more);
    }
    ++surveyed_;
}

void PointsPanel::keep_for_axis(const std::vector<Point>& points) {
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kept_a_frame);
    for (std::size_t i = surveyed_ % stride; i < points.size(); i += stride)
        pool_.push_back(std::abs(points[i].y));
}

void PointsPanel::survey_samples(const FrameInput& input) {
    if (!subject_.is_sample(input.tick.time)) return;
    clouds_.resize(subject_.sets.size());
    for (std::size_t k = 0; k < clouds_.size(); ++k) {
        const std::vector<Point> now = subject_.points(input, k);
        for (const Point& point : now) {
            clouds_[k].time.push_back(input.tick.time);
            clouds_[k].x.push_back(point.x);
            clouds_[k].y.push_back(point.y);
        }
        keep_for_axis(now);
    }
    ++surveyed_;
}

void PointsPanel::fix_axes() {
    const double most = pool_.empty() ? 0.0 : 1.1 * quantile(pool_, 0.995);
    const double high = round_up_for_axis(most);
    height_ = subject_.height.value_or(std::pair{-high, high});
    pool_ = {};
    make_plot();
}

void PointsPanel::archive(Archive& archive) {
    archive(paths_, clouds_, height_, subject_.width);
    if (archive.is_reading()) make_plot();
}

void PointsPanel::make_plot() {
    whole_ = {.language = subject_.language,
              .titles = subject_.titles,
              .x = {.title = subject_.across,
                    .low = subject_.width.first,
                    .high = subject_.width.second,
                    .quantity = subject_.columns.first.quantity},
              .y = {.title = subject_.up,
                    .low = height_.first,
                    .high = height_.second,
                    .quantity = subject_.columns.second.quantity},
              .columns = {
                  {"piece", quantities::ordinal}, subject_.columns.first, subject_.columns.second}};
    if (!subject_.remark.empty())
        whole_.notes.push_back({.entries = {{.words = {plot::Text(subject_.remark)}}}});
    if (height_.first < 0.0) {
        plot::Level zero;
        zero.still = true;
        zero.stroke = faint;
        whole_.layers.emplace_back(std::move(zero));
    }
    if (subject_.never_equal) {
        const std::vector<double> ends{subject_.width.first, subject_.width.second};
        plot::Polyline equal;
        equal.still = true;
        equal.x = equal.y = plot::column("", ends);
        equal.stroke = faint;
        whole_.layers.emplace_back(std::move(equal));
    }
    lines_.clear();
    for (std::size_t k = 0; k < paths_.size(); ++k) lines_.push_back(line_of(k));
    points_.clear();
    for (std::size_t k = 0; k < clouds_.size(); ++k) {
        plot::Points points;
        points.part = "sample";
        points.of = subject_.sets[k].name;
        points.x = plot::column(whole_.columns[1], clouds_[k].x);
        points.y = plot::column(whole_.columns[2], clouds_[k].y);
        points.dot = {.role = subject_.sets[k].role, .radius = 0.16, .is_hollow_if_pale = true};
        points_.push_back(std::move(points));
    }
}

void PointsPanel::add_cloud(plot::Plot& now, std::size_t set, double time) const {
    plot::Points points = points_[set];
    const std::vector<double>& times = clouds_[set].time;
    points.shown.end =
        static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
    now.layers.emplace_back(std::move(points));
}

// A path that goes around the box has several pieces.
std::vector<int> PointsPanel::pieces_of(const Path& path) const {
    const auto beyond = [](const std::vector<double>& values, std::size_t i, double most) {
        return most > 0.0 && std::abs(values[i] - values[i - 1]) > most;
    };
    std::vector<int> pieces;
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        const bool breaks = i > 0 && (beyond(path.x, i, subject_.breaks_across) ||
                                      beyond(path.y, i, subject_.breaks_up));
        pieces.push_back(i == 0 ? 0 : pieces.back() + (breaks ? 1 : 0));
    }
    return pieces;
}

plot::Polyline PointsPanel::line_of(std::size_t set) const {
    const Path& path = paths_[set];
    plot::Polyline line;
    line.part = "path";
    line.of = subject_.sets[set].name;
    line.depth = 1;
    line.x = plot::column(whole_.columns[1], path.x);
    line.y = plot::column(whole_.columns[2], path.y);
    line.piece = std::make_shared<const std::vector<int>>(pieces_of(path));
    line.piece_column = whole_.columns[0];
    line.is_thinned = false;
    line.stroke = {.role = subject_.sets[set].role, .width = 0.1, .shade = plot::Shade::legible};
    // Dashes of a path that overlaps itself are not legible. Two paths are distinguished by their
    // greys, and by the points at their ends.
    if (paths_.size() > 2) line.stroke.print_dashes = plot::dashes_in_print(set, paths_.size());
    return line;
}

std::shared_ptr<const PanelState> PointsPanel::state(const FrameInput& input) {
    auto state = std::make_shared<PointsState>();
    for (std::size_t k = 0; k < subject_.sets.size(); ++k)
        state->sets.push_back(subject_.points(input, k));
    state->shown = ++seen_;
    state->time = input.tick.time;
    return state;
}

plot::Plot PointsPanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const auto& shown = static_cast<const PointsState&>(*state);
    for (std::size_t k = 0; k < points_.size(); ++k) add_cloud(now, k, shown.time);
    for (std::size_t k = 0; k < shown.sets.size(); ++k) {
        if (subject_.is_sample && !subject_.shows_present) continue;
        const bool has_path = shown.sets[k].size() == 1;
        std::vector<double> x, y;
        for (const Point& point : shown.sets[k]) {
            x.push_back(point.x);
            y.push_back(point.y);
        }
        plot::Points points;
        points.part = "point";
        points.of = subject_.sets[k].name;
        points.x = plot::column(now.columns[1], std::move(x));
        points.y = plot::column(now.columns[2], std::move(y));
        points.dot = {.role = subject_.sets[k].role,
                      .radius = has_path ? 0.35 : 0.16,
                      .is_hollow_if_pale = true,
                      .halo = has_path ? 0.12 : 0.0};  // a gap between point and paths
        now.layers.emplace_back(std::move(points));
        if (k >= lines_.size()) continue;
        add_path(now, k, shown.shown);
    }
    return now;
}

// A fading path is drawn once whole and faint, and over it ever more recent parts, each stronger.
void PointsPanel::add_path(plot::Plot& now, std::size_t set, std::size_t frames) const {
    constexpr double faintest = 0.8;
    constexpr std::size_t steps = 4, frames_of_all = 300;
    const Path& path = paths_[set];
    plot::Polyline line = lines_[set];
    line.shown = path.until(frames);
    if (!subject_.fades || path.ends.empty())
        return now.layers.emplace_back(std::move(line)), void();
    line.stroke.fade = faintest;
    now.layers.emplace_back(line);
    line.part.clear();  // listed once
    for (std::size_t k = 1; k <= steps; ++k) {
        const std::size_t recent = frames_of_all * (steps + 1 - k) / steps;
        const std::size_t from = std::min(frames, path.ends.size());
        if (from > recent)
            line.shown.first = std::max(line.shown.first, path.ends[from - recent - 1]);
        line.stroke.fade = faintest * (1.0 - double(k) / steps);
        now.layers.emplace_back(line);
    }
}

}  // namespace carom
