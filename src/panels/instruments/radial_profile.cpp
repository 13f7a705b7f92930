// Density against the distance from a point: the particles in rings around it, by the area of the
// ring, and the front of what runs outwards: the ring of the highest density.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "panels/chosen.h"
#include "panels/field/field_layer.h"
#include "panels/field/profile.h"
#include "panels/means/running_mean.h"
#include "panels/means/runs_record.h"
#include "panels/plot/plot_panel.h"
#include "panels/plot/window.h"
#include "panels/registry.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/equation_of_state.h"
#include "stats/histogram.h"
#include "stats/means/measured.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr int usual_rings = 20;

// The densities that each frame shows: a line for each ring, in all rings of the first choice, then
// in those of the second, and so on.
struct RadialRun {
    std::string name = {};  // among compared runs
    Measured frames = {};
    std::vector<double> all = {};  // the highest of each sample, for the axis
    double at_rest = 0.0;          // density of all particles in the box
    void archive(Archive& archive) { archive(name, frames, all, at_rest); }
};

using RadialRecord = RunsRecord<RadialRun>;

RadialRecord mean_of(const std::vector<RadialRecord>& records) {
    RadialRecord mean = begun_mean(records);
    std::vector<const Measured*> of_each;
    for (const RadialRecord& record : records) of_each.push_back(&record.runs.front().frames);
    mean.runs.front().frames = mean_of(of_each);
    return mean;
}

// Rings of equal width around a point, up to the side of the box that is nearest to it.
class RingsAround {
  public:
    RingsAround(const Box& box, const Vec& middle, int count)
        : box_(box), middle_(middle), count_(count) {
        double reach = INFINITY;
        for (const int axis : {0, 1}) {
            const double side = box.size[axis];
            reach = std::min(reach, box.is_periodic(axis)
                                        ? 0.5 * side
                                        : std::min(middle[axis], side - middle[axis]));
        }
        width_ = reach / count;
    }

    int count() const { return count_; }
    double width() const { return width_; }
    double area(int ring) const { return std::numbers::pi * width_ * width_ * (2.0 * ring + 1.0); }

    std::vector<double> densities(const Eigen::ArrayXXd& position,
                                  const std::vector<Eigen::Index>& of) const {
        std::vector<double> found(static_cast<std::size_t>(count_));
        for (const Eigen::Index i : of) {
            const Vec apart = box_.nearest(vec_in(position, i) - middle_);
            const double ring = std::floor(length(apart) / width_);
            if (ring < count_) found[static_cast<std::size_t>(ring)] += 1.0;
        }
        for (int ring = 0; ring < count_; ++ring)
            found[static_cast<std::size_t>(ring)] /= area(ring);
        return found;
    }

    // The distance at which the density is highest, as the mean over three neighbouring rings, and
    // the top of a parabola through three such means; none if it exceeds `at_rest` by no more than
    // three standard deviations of the number of particles in a part of a gas at rest, whose
    // variance is `scatter` times that of points. None either where the density is highest at the
    // side of the box: it may be higher beyond the last ring, or the front is on its way back.
    std::optional<double> front(std::span<const double> density, double at_rest,
                                double scatter) const {
        constexpr double deviations = 3.0;
        std::vector<double> means;
        for (std::size_t k = 1; k + 1 < density.size(); ++k) {
            double number = 0.0;
            for (std::size_t ring = k - 1; ring <= k + 1; ++ring)
                number += density[ring] * area(static_cast<int>(ring));
            means.push_back(number / area_of_three(k));
        }
        const auto highest = std::ranges::max_element(means);
        if (means.empty() || highest == std::prev(means.end())) return {};
        const auto k = static_cast<std::size_t>(highest - means.begin());
        const double deviation = std::sqrt(scatter * at_rest / area_of_three(k + 1));
        if (!(*highest > at_rest + deviations * deviation)) return {};
        double off = 0.0;
        if (k > 0) {
            const double bend = means[k - 1] - 2.0 * means[k] + means[k + 1];
            if (bend < 0.0) off = 0.5 * (means[k - 1] - means[k + 1]) / bend;
        }
        return width_ * (static_cast<double>(k) + 1.5 + off);
    }

  private:
    double area_of_three(std::size_t middle) const { return 3.0 * area(static_cast<int>(middle)); }

    Box box_;
    Vec middle_;
    int count_;
    double width_ = 1.0;
};

class RadialProfilePanel : public FramesPanel<RadialRecord> {
  public:
    RadialProfilePanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context),
          spec_(spec),
          rings_(context.box(), *options().around, options().cells.value_or(usual_rings)),
          over_(spec.over.value_or(usual_window_of_profile(context.run()))),
          mean_(over_),
          choices_(choices(spec)),
          members_(context, choices_) {}

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    std::optional<std::array<double, 2>> time_shown(double at) const override {
        const auto start = start_of_mean(over_, at);
        return start ? std::optional(std::array{*start, at}) : std::nullopt;
    }
    plot::Plot plot(const PanelState* state) const override;

  protected:
    void finish_record() override {
        const Box& box = context_.box();
        record_.runs.front().at_rest =
            static_cast<double>(context_.particles.count()) / (box.size[0] * box.size[1]);
    }
    void make_axes() override;
    void take_axes(const RecordPanel& of) override { take_record(of); }

  private:
    const ProfileOptions& options() const { return spec_.options.as<ProfileOptions>(); }
    std::vector<double> in_rings(const NumberRows& lines, std::size_t choice,
                                 std::size_t frame) const {
        const auto count = static_cast<std::size_t>(rings_.count());
        std::vector<double> all;
        for (std::size_t ring = 0; ring < count; ++ring)
            all.push_back(lines.at(choice * count + ring).at(frame));
        return all;
    }
    plot::Polyline line_of(std::size_t run, std::size_t choice,
                           const std::vector<double>& values) const;
    void add_front(plot::Plot& plot, const std::vector<double>& values) const;
    void add_rest();
    double relative_variance() const;

    PanelContext context_;
    PanelSpec spec_;
    RingsAround rings_;
    Over over_;
    RunningMean mean_;
    std::vector<Chosen> choices_;
    Members members_;
    plot::Plot whole_;
};

void RadialProfilePanel::survey(const FrameInput& input) {
    std::vector<double> now;
    for (const std::vector<Eigen::Index>& list : members_.at(input.sample)) {
        const std::vector<double> one = rings_.densities(input.sample.position, list);
        now.insert(now.end(), one.begin(), one.end());
    }
    now = mean_(input.tick.time, now, input.is_sample);
    RadialRun& run = record_.runs.front();
    if (input.is_sample) run.all.push_back(*std::ranges::max_element(now));
    if (input.is_frame) run.frames.add(input.tick.time, now);
}

void RadialProfilePanel::make_axes() {
    const Language language = context_.language();
    std::vector<double> highest;
    for (const RadialRun& run : record_.runs)
        highest.insert(highest.end(), run.all.begin(), run.all.end());
    constexpr double room = 1.1;
    const double most = highest.empty() ? 1.0 : room * quantile(highest, 0.98);
    const Quantity density = quantities::density(context_.box().dimension);
    whole_ = {
        .language = language,
        .x = plot::axis_of(language, quantities::distance, 0.0, rings_.width() * rings_.count()),
        .y = plot::axis_of(language, density, 0.0, round_up_for_axis(most)),
        .columns = {quantities::distance, density}};
    const std::string title =
        say(language, "{} around a point", capitalised(say(language, density.word)));
    if (spec_.title)
        whole_.titles = {escape_markup(*spec_.title)};
    else if (spec_.of.empty())
        whole_.titles = {title};
    else
        whole_.titles = {title + ": " + names_of(context_, choices_, plot::Swatch::line)};
    if (record_.runs_in_mean > 1) whole_.columns.push_back(standard_error_of(density));
    if (record_.compares()) plot::name_runs(whole_, record_.names());
    plot::Note note{.wraps = true};
    note.entries.push_back(
        {.words = {plot::Text(words_of_moments(context_.wording(), spec_, over_))}});
    if (record_.runs_in_mean > 1)
        note.entries.push_back(
            {.words = {plot::Text(words_of_mean(language, record_.runs_in_mean))}});
    whole_.notes.push_back(std::move(note));
    if (!record_.compares() && spec_.of.empty()) add_rest();
}

// The density of all particles, as if they were spread evenly over the box.
void RadialProfilePanel::add_rest() {
    plot::Level level;
    level.part = "mean density";
    level.still = true;
    level.depth = 1;
    level.stroke = {.role = {.of = plot::Role::Of::muted}, .width = 0.08, .dashes = {0.3}};
    level.x_column = whole_.columns[0];
    level.column = whole_.columns[1];
    level.value = record_.runs.front().at_rest;
    whole_.layers.emplace_back(std::move(level));
}

// A horizontal piece for each ring.
plot::Polyline RadialProfilePanel::line_of(std::size_t run, std::size_t choice,
                                           const std::vector<double>& values) const {
    std::vector<double> along, up;
    for (std::size_t ring = 0; ring < values.size(); ++ring)
        for (const double end : {0.0, 1.0}) {
            along.push_back((static_cast<double>(ring) + end) * rings_.width());
            up.push_back(values[ring]);
        }
    plot::Polyline line;
    line.part = "profile";
    line.of = column_name_of(context_.scene, choices_[choice]);
    if (record_.compares()) line.run = run;
    line.x = plot::column(whole_.columns[0], std::move(along));
    line.y = plot::column(whole_.columns[1], std::move(up));
    line.is_thinned = false;
    line.stroke = record_.compares()
                      ? plot::stroke_of_run(run, 0.22)
                      : plot::Stroke{.role = role_among(context_, choices_, choice),
                                     .width = 0.22,
                                     .print_dashes = plot::dashes_in_print(choice, choices_.size()),
                                     .shade = plot::Shade::legible};
    return line;
}

// Of the number of particles in a part of the gas at rest, relative to that of points.
double RadialProfilePanel::relative_variance() const {
    const double packing = packing_fraction(context_.box(), context_.particles);
    const int dimension = context_.box().dimension;
    return packing > largest_packing_of_fluid(dimension)
               ? 1.0
               : relative_compressibility(dimension, EquationOfState::accurate, packing);
}

void RadialProfilePanel::add_front(plot::Plot& plot, const std::vector<double>& values) const {
    const std::optional<double> at =
        rings_.front(values, record_.runs.front().at_rest, relative_variance());
    if (!at) return;
    const Language language = context_.language();
    const std::string number = plain_number(language, std::round(*at));
    const double middle = 0.5 * (whole_.x.low + whole_.x.high);
    const bool on_left = *at > middle;
    plot::Marker marker;
    marker.part = "front";
    marker.column = whole_.columns[0];
    marker.value = *at;
    marker.stroke = {.role = {.of = plot::Role::Of::highlight}, .width = 0.14};
    plot::Label label;
    label.role = marker.stroke.role;
    label.words = {say(language, "front (highest density): {}", number),
                   say(language, "front: {}", number)};
    label.anchors = {{.at = {*at, 0.0},
                      .y_is_share = true,
                      .offset = {on_left ? -0.5 : 0.5, 1.1},
                      .align = on_left ? Align::right : Align::left,
                      .step = {0.0, 0.5}}};
    marker.label = std::move(label);
    plot.layers.emplace_back(std::move(marker));
    plot.account += " " + say(language, "The density is highest at the distance {}.",
                              three_digits(language, *at));
}

plot::Plot RadialProfilePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const Language language = context_.language();
    const auto& shown = dynamic_cast<const ShownState&>(*state).shown;
    for (std::size_t run = 0; run < record_.runs.size(); ++run) {
        const RadialRun& its = record_.runs[run];
        const std::size_t frame = std::min(shown.at(run), its.frames.x.size()) - 1;
        for (std::size_t k = 0; k < choices_.size(); ++k) {
            const std::vector<double> values = in_rings(its.frames.y, k, frame);
            plot::Polyline line = line_of(run, k, values);
            if (!its.frames.error.empty()) {
                std::vector<double> errors;
                for (const double error : in_rings(its.frames.error, k, frame))
                    errors.insert(errors.end(), 2, error);
                plot::Band band;
                band.x = line.x;
                band.y = line.y;
                band.error = plot::column(whole_.columns[2], std::move(errors));
                band.role = line.stroke.role;
                line.more = {band.error};
                now.layers.emplace_back(std::move(band));
            }
            now.layers.emplace_back(std::move(line));
            const auto [low, high] = std::ranges::minmax(values);
            const std::string between =
                say(language, "between {} and {}", three_digits(language, low),
                    three_digits(language, high));
            if (record_.compares())
                now.accounts_of_runs.push_back(between);
            else
                now.account += (now.account.empty() ? "" : " ") +
                               say(language, "{} around a point, {}: {}.",
                                   capitalised(say(language, "density")),
                                   words_of_moments(context_.wording(), spec_, over_), between);
            if (options().front && !record_.compares() && k == 0) add_front(now, values);
        }
    }
    return now;
}

}  // namespace

std::unique_ptr<Panel> make_radial_profile(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<RadialProfilePanel>(context, spec);
}

}  // namespace carom
