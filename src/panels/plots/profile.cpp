// Density, temperature, mean speed or flow along an axis of the box: means over slabs perpendicular
// to it, from exact residence times. A profile along y has the height as its vertical axis, as in
// the box. If a barometric law holds for an ideal gas, it is drawn with the density.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/chosen.h"
#include "panels/field/field_layer.h"
#include "panels/means/thinning.h"
#include "panels/means/trailing.h"
#include "panels/plot/plot_panel.h"
#include "panels/plot/window.h"
#include "panels/registry.h"
#include "physics/sample_times.h"
#include "stats/histogram.h"
#include "stats/mean_error.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::Role;

constexpr int usual_slabs = 20;

using Values = std::vector<Eigen::ArrayXd>;  // choice x slab; NaN: too few particles

struct ProfileState : PanelState {
    std::vector<Values> runs;  // one, or the compared runs
    Values errors;             // of a mean
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Values& values : runs)
            for (const Eigen::ArrayXd& slabs : values)
                sum += static_cast<std::size_t>(slabs.size()) * sizeof(double);
        return sum;
    }
};

// What the first pass of a run has shown.
struct ProfileRun {
    std::string name = {};  // among compared runs
    double length = 1.0;    // of the axis
    double most = 0.0;
    std::vector<std::vector<double>> laws = {};  // choice x slab; or empty
    void archive(Archive& archive) { archive(name, length, most, laws); }
};

struct ProfileRecord {
    std::vector<ProfileRun> runs = {{}};
    int runs_in_mean = 1;
    bool compares() const { return runs.size() > 1; }
    void archive(Archive& archive) { archive(runs, runs_in_mean); }
};

// There is a law only if each run has one.
ProfileRecord mean_of(const std::vector<ProfileRecord>& records) {
    ProfileRecord mean = records.front();
    mean.runs_in_mean = static_cast<int>(records.size());
    ProfileRun& all = mean.runs.front();
    for (const ProfileRecord& record : records) {
        all.most = std::max(all.most, record.runs.front().most);
        if (record.runs.front().laws.size() < all.laws.size()) all.laws.clear();
    }
    for (std::size_t k = 0; k < all.laws.size(); ++k)
        for (std::size_t slab = 0; slab < all.laws[k].size(); ++slab) {
            std::vector<double> each;
            for (const ProfileRecord& record : records)
                each.push_back(record.runs.front().laws[k][slab]);
            all.laws[k][slab] = mean_error(each).mean;
        }
    return mean;
}

ProfileRecord compare(const std::vector<ProfileRecord>& records,
                      const std::vector<std::string>& names) {
    ProfileRecord all{.runs = {}};
    for (std::size_t k = 0; k < records.size(); ++k) {
        all.runs.push_back(records[k].runs.front());
        all.runs.back().name = names[k];
    }
    return all;
}

class ProfilePanel : public RecordPanel<ProfileRecord> {
  public:
    ProfilePanel(const PanelContext& context, const PanelSpec& spec);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::samples; }
    void archive(Archive& archive) override;
    std::optional<std::array<double, 2>> time_shown(double at) const override;
    bool surveys_collisions() const override { return window_of(over_) != 0.0; }
    bool wants_collisions() const override { return surveys_collisions(); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override {
        for (CellQuantity& one : shown_) archive(one);
    }
    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    plot::Plot plot(const PanelState* state) const override;

  protected:
    void finish_record() override;
    void make_axes() override;
    void take_axes(const RecordPanel& of) override;

  private:
    void add_laws();
    bool is_up() const { return axis_ == 1; }
    // A slab without particles has a density, 0, but no temperature.
    Eigen::ArrayXd values_of(const CellQuantity& quantity) const {
        return quantity.values(axis_, spec_.quantity == FieldOf::density ? 0.0 : least_in_cell);
    }
    plot::Line curve(std::size_t run, std::size_t choice, const char* part,
                     std::vector<double> along, std::vector<double> up) const;
    plot::Line line_of(std::size_t run, std::size_t choice, const Eigen::ArrayXd& values,
                       const char* part) const;
    plot::Line law_of(std::size_t run, std::size_t choice) const;
    void add_errors(plot::Plot& plot, plot::Line& line, const Eigen::ArrayXd& values,
                    const Eigen::ArrayXd& errors) const;
    std::string account_of(const Eigen::ArrayXd& values, std::size_t choice) const;
    plot::Stroke stroke_of_law() const;
    std::vector<plot::Text> titles() const;
    plot::Note note() const;

    PanelContext context_;
    PanelSpec spec_;
    int axis_;
    Cells cells_;
    Over over_;
    std::vector<Chosen> choices_;
    std::vector<CellQuantity> surveyed_, shown_;
    std::vector<double> pool_;
    int frames_seen_ = 0;
    plot::Plot whole_;
};

ProfilePanel::ProfilePanel(const PanelContext& context, const PanelSpec& spec)
    : context_(context),
      spec_(spec),
      axis_(spec.component == Component::y ? 1 : 0),
      cells_(slabs(context.scene.gas.box, axis_, spec.bins.value_or(usual_slabs))),
      over_(spec.over.value_or(usual_window_of_profile(context.scene.run))),
      choices_(choices(spec)) {
    for (const std::vector<Eigen::Index>& list : carom::members(context, choices_)) {
        std::vector<bool> members(static_cast<std::size_t>(context.particles.count()));
        for (const Eigen::Index i : list) members[static_cast<std::size_t>(i)] = true;
        surveyed_.emplace_back(context, cells_, spec.quantity, std::nullopt, window_of(over_),
                               members);
    }
    shown_ = surveyed_;
}

// The law of each choice, if all have one.
void ProfilePanel::add_laws() {
    std::vector<std::vector<double>>& laws = record_.runs.front().laws;
    for (const Chosen& chosen : choices_) {
        Law found =
            law(context_.gas, LawOf::heights,
                {.of = members(context_, chosen), .axis = axis_, .cells = cells_.count[axis_]});
        if (!found) return laws.clear();
        laws.push_back(std::move(found.curve));
    }
}

void ProfilePanel::survey(const FrameInput& input) {
    if (frames_seen_ == 0 && spec_.theory && spec_.quantity == FieldOf::density) add_laws();
    const auto slabs = static_cast<double>(cells_.all());
    for (CellQuantity& one : surveyed_) {
        one.see(input);
        const Eigen::ArrayXd values = values_of(one);
        for_each_kept(values.size(), slabs * static_cast<double>(surveyed_.size()), frames_seen_,
                      static_cast<int>(sample_count(context_.scene.run)), [&](Eigen::Index k) {
                          if (!std::isnan(values[k])) pool_.push_back(std::abs(values[k]));
                      });
    }
    ++frames_seen_;
}

void ProfilePanel::finish_record() {
    ProfileRun& run = record_.runs.front();
    run.length = cells_.box[axis_];
    for (const std::vector<double>& law : run.laws)
        pool_.insert(pool_.end(), law.begin(), law.end());
    run.most = pool_.empty() ? 0.0 : quantile(pool_, 0.999);
    pool_ = {};
    surveyed_ = {};
}

void ProfilePanel::take_axes(const RecordPanel& of) {
    record_ = of.record();
    make_axes();
}

void ProfilePanel::archive(Archive& archive) {
    archive(record_);
    if (archive.is_reading()) make_axes();
}

std::vector<plot::Text> ProfilePanel::titles() const {
    if (spec_.title) return {escape_markup(*spec_.title)};
    const Language language = context_.language();
    std::string name = capitalised(name_of_quantity(language, context_.scene, spec_.quantity, {}));
    if (context_.scene.gas.box.dimension == 2)
        name = is_up() ? say(language, "{} along y", name) : say(language, "{} along x", name);
    if (spec_.of.empty()) return {name};
    const plot::Text names = names_of(context_, choices_, plot::Sample::line);
    return {name + ": " + names, names};
}

plot::Line ProfilePanel::curve(std::size_t run, std::size_t choice, const char* part,
                               std::vector<double> along, std::vector<double> up) const {
    plot::Line line;
    line.part = part;
    line.of = column_name_of(context_.scene, choices_[choice]);
    if (record_.compares()) line.run = run;
    line.x = plot::column(whole_.columns[1], is_up() ? up : along);
    line.y = plot::column(whole_.columns[2], is_up() ? along : up);
    line.is_thinned = false;
    return line;
}

// A horizontal piece for each slab; the line is broken at slabs without a value.
plot::Line ProfilePanel::line_of(std::size_t run, std::size_t choice, const Eigen::ArrayXd& values,
                                 const char* part) const {
    const double width = record_.runs[run].length / static_cast<double>(values.size());
    std::vector<double> along, up;
    std::vector<int> piece;
    int pieces = 0;
    for (Eigen::Index slab = 0; slab < values.size(); ++slab) {
        if (std::isnan(values[slab])) {
            ++pieces;
            continue;
        }
        for (const int end : {0, 1}) {
            along.push_back(static_cast<double>(slab + end) * width);
            up.push_back(values[slab]);
            piece.push_back(pieces);
        }
    }
    plot::Line line = curve(run, choice, part, std::move(along), std::move(up));
    line.piece = std::make_shared<const std::vector<int>>(std::move(piece));
    line.piece_column = whole_.columns[0];
    return line;
}

// Thin if runs are compared, since each run has its own line.
plot::Stroke ProfilePanel::stroke_of_law() const {
    if (record_.compares()) return {.role = {.of = Role::Of::muted}, .width = 0.07};
    if (choices_.size() == 1) return {.role = {.of = Role::Of::accent}};
    return {.role = {.of = Role::Of::muted}, .dashes = {0.5}};
}

// The law as a line through the middles of the slabs.
plot::Line ProfilePanel::law_of(std::size_t run, std::size_t choice) const {
    const std::vector<double>& densities = record_.runs[run].laws[choice];
    const double width = record_.runs[run].length / static_cast<double>(densities.size());
    std::vector<double> along;
    for (std::size_t slab = 0; slab < densities.size(); ++slab)
        along.push_back((static_cast<double>(slab) + 0.5) * width);
    plot::Line law = curve(run, choice, "law", std::move(along), densities);
    law.still = true;
    law.depth = 1;
    law.stroke = stroke_of_law();
    if (record_.compares())
        law.stroke.role = plot::stroke_of_run(run).role;
    else if (choices_.size() > 1)
        law.stroke.role = role_among(context_, choices_, choice);
    return law;
}

plot::Note ProfilePanel::note() const {
    const Language language = context_.language();
    plot::Note note{.wraps = true};
    note.entries.push_back({.words = {plot::Text(words_of_moments(language, spec_, over_))}});
    if (std::ranges::any_of(record_.runs, [](const ProfileRun& run) { return !run.laws.empty(); }))
        note.entries.push_back({.sample = stroke_of_law(), .words = {say(language, "ideal gas")}});
    if (record_.runs_in_mean > 1)
        note.entries.push_back(
            {.words = {plot::Text(counted(language, record_.runs_in_mean, Phrase{"mean of {} run"},
                                          Phrase{"mean of {} runs"}))}});
    return note;
}

void ProfilePanel::make_axes() {
    const Scene& scene = context_.scene;
    const Language language = context_.language();
    const std::string quantity = name_of_quantity(Language::english, scene, spec_.quantity, {});
    const std::string place = scene.gas.box.dimension == 1 ? "position" : is_up() ? "y" : "x";
    const double most = std::ranges::max_element(record_.runs, {}, &ProfileRun::most)->most;
    const double top = round_up_for_axis(1.02 * most);
    const double low = spec_.quantity == FieldOf::flow ? -top : 0.0;
    plot::Axis places{
        .title = scene.gas.box.dimension == 1 ? say(language, "position") : place,
        .low = 0.0,
        .high = std::ranges::max_element(record_.runs, {}, &ProfileRun::length)->length};
    plot::Axis values{
        .title = name_of_quantity(language, scene, spec_.quantity, {}), .low = low, .high = top};
    const std::string of_place = column_name(place, reduced::length);
    const std::string of_value = column_name(quantity, unit_of_quantity(scene, spec_.quantity));
    whole_ = {.titles = titles(),
              .x = is_up() ? values : places,
              .y = is_up() ? places : values,
              .columns = {"piece (number)", is_up() ? of_value : of_place,
                          is_up() ? of_place : of_value}};
    if (record_.runs_in_mean > 1) whole_.columns.push_back("standard error of " + of_value);
    whole_.language = language;
    std::vector<std::string> names;
    for (const ProfileRun& run : record_.runs) names.push_back(run.name);
    if (record_.compares()) plot::name_runs(whole_, std::move(names));
    whole_.notes.push_back(note());
    for (std::size_t run = 0; run < record_.runs.size(); ++run)
        for (std::size_t k = 0; k < record_.runs[run].laws.size(); ++k)
            whole_.layers.emplace_back(law_of(run, k));
}

std::shared_ptr<const PanelState> ProfilePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ProfileState>();
    state->runs.emplace_back();
    for (CellQuantity& one : shown_) {
        one.see(input);
        state->runs.front().push_back(values_of(one));
    }
    return state;
}

std::shared_ptr<const PanelState> ProfilePanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    std::vector<Values> all;
    for (const auto& state : states)
        all.push_back(dynamic_cast<const ProfileState&>(*state).runs.front());
    auto both = std::make_shared<ProfileState>();
    if (record_.compares()) {
        both->runs = std::move(all);
        return both;
    }
    both->runs = {all.front()};
    both->errors = all.front();
    for (std::size_t choice = 0; choice < choices_.size(); ++choice)
        for (Eigen::Index slab = 0; slab < cells_.all(); ++slab) {
            std::vector<double> each;
            for (const Values& values : all) each.push_back(values[choice][slab]);
            const MeanError mean = mean_error(each);
            both->runs.front()[choice][slab] = mean.mean;
            both->errors[choice][slab] = mean.error;
        }
    return both;
}

// Thin lines at a standard error on both sides.
void ProfilePanel::add_errors(plot::Plot& plot, plot::Line& line, const Eigen::ArrayXd& values,
                              const Eigen::ArrayXd& errors) const {
    std::vector<double> known;
    for (Eigen::Index slab = 0; slab < values.size(); ++slab)
        if (!std::isnan(values[slab])) known.insert(known.end(), 2, errors[slab]);
    for (const double side : {-1.0, 1.0}) {
        plot::Line bound = line;
        bound.part = side < 0.0 ? "less error" : "plus error";
        bound.stroke.width = 0.06;
        bound.stroke.dashes = {};
        std::vector<double> at;
        for (std::size_t k = 0; k < known.size(); ++k)
            at.push_back((is_up() ? line.x[k] : line.y[k]) +
                         (std::isfinite(known[k]) ? side * known[k] : 0.0));
        if (is_up())
            bound.x = plot::column(whole_.columns[1], std::move(at));
        else
            bound.y = plot::column(whole_.columns[2], std::move(at));
        plot.layers.emplace_back(std::move(bound));
    }
    line.more = {plot::column(whole_.columns[3], std::move(known))};
}

std::optional<std::array<double, 2>> ProfilePanel::time_shown(double at) const {
    const auto start = start_of_mean(over_, at);
    if (!start) return {};
    return {{*start, at}};
}

// "between 0.02 and 0.11", of all particles or of some.
std::string ProfilePanel::account_of(const Eigen::ArrayXd& values, std::size_t choice) const {
    const Language language = context_.language();
    const auto known = !values.isNaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const std::string low = three_digits(language, known.select(values, infinite).minCoeff());
    const std::string high = three_digits(language, known.select(values, -infinite).maxCoeff());
    if (record_.compares())
        return known.any() ? say(language, "between {} and {}", low, high)
                           : say(language, "unknown");
    if (!known.any()) return "";
    const std::string what = name_of_quantity(language, context_.scene, spec_.quantity, {});
    const std::string axis = is_up() ? "y" : "x", time = words_of_moments(language, spec_, over_);
    if (spec_.of.empty())
        return say(language, "{} along {}, {}: between {} and {}.", what, axis, time, low, high);
    return say(language, "{} of {} along {}, {}: between {} and {}.", what,
               name_of(context_.scene, choices_[choice]), axis, time, low, high);
}

plot::Plot ProfilePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const auto& shown = static_cast<const ProfileState&>(*state);
    for (std::size_t run = 0; run < shown.runs.size(); ++run)
        for (std::size_t k = 0; k < shown.runs[run].size(); ++k) {
            const Eigen::ArrayXd& values = shown.runs[run][k];
            plot::Line line = line_of(run, k, values, "profile");
            line.stroke =
                record_.compares()
                    ? plot::stroke_of_run(run, 0.22)
                    : plot::Stroke{.role = role_among(context_, choices_, k),
                                   .width = 0.22,
                                   .print_dashes = plot::dashes_in_print(k, choices_.size()),
                                   .shade = plot::Shade::legible};
            if (!shown.errors.empty()) add_errors(now, line, values, shown.errors[k]);
            now.layers.emplace_back(std::move(line));
            const std::string words = account_of(values, k);
            if (record_.compares())
                now.accounts_of_runs.push_back(words);
            else if (!words.empty())
                now.account += (now.account.empty() ? "" : " ") + capitalised(words);
        }
    return now;
}

}  // namespace

std::unique_ptr<Panel> make_profile(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<ProfilePanel>(context, spec);
}

}  // namespace carom
