#include "panels/field/profile.h"

#include <algorithm>
#include <cmath>

#include "panels/means/thinning.h"
#include "panels/means/trailing.h"
#include "panels/registry.h"
#include "panels/surfaces/place_options.h"
#include "physics/box.h"
#include "physics/run.h"
#include "physics/sample_times.h"
#include "scene/panel_kind.h"
#include "scene/reading/overlay_reading.h"
#include "stats/histogram.h"
#include "stats/means/mean_error.h"

namespace carom {
namespace {

constexpr int usual_slabs = 20;

}  // namespace

// There is a law only if each run has one.
ProfileRecord mean_of(const std::vector<ProfileRecord>& records) {
    ProfileRecord mean = begun_mean(records);
    ProfileRun& all = mean.runs.front();
    std::vector<const Measured*> of_each;
    bool all_have_laws = true;
    for (const ProfileRecord& record : records) {
        all.most = std::max(all.most, record.runs.front().most);
        of_each.push_back(&record.runs.front().laws);
        all_have_laws = all_have_laws && !of_each.back()->y.empty();
    }
    all.laws = all_have_laws ? mean_of(of_each) : Measured{};
    return mean;
}

ProfilePanel::ProfilePanel(const PanelContext& context, const PanelSpec& spec)
    : context_(context),
      spec_(spec),
      axis_(axis_of(spec)),
      cells_(slabs(context.box(), axis_, options().cells.value_or(usual_slabs))),
      over_(spec.over.value_or(usual_window_of_profile(context.run()))),
      choices_(choices(spec)) {
    for (const Chosen& chosen : choices_)
        surveyed_.emplace_back(context, cells_, options().quantity, std::nullopt, window_of(over_),
                               chosen);
    shown_ = surveyed_;
}

// The law of each choice, if all have one.
void ProfilePanel::add_laws() {
    NumberRows& laws = record_.runs.front().laws.y;
    for (const Chosen& chosen : choices_) {
        Law found =
            law(context_.gas, LawOf::heights,
                {.of = members(context_, chosen), .axis = axis_, .cells = cells_.count[axis_]});
        if (!found) return laws.clear();
        laws.push_back(std::move(found.curve));
    }
}

// An event in the window divides it into times of different gases; only a nudge changes no mean.
bool ProfilePanel::is_changed_in_window(double until) const {
    const Run& run = context_.run();
    const double from = until - over_.window;
    const auto is_inside = [&](double time) { return time > from && time < until; };
    return std::ranges::any_of(run.events, [&](const RunEvent& event) {
        if (perturbation_of(event)) return false;
        if (is_inside(event.at)) return true;
        return event.is_mirrored && std::ranges::any_of(reversal_times(run), [&](double reversal) {
                   return reversal > event.at && is_inside(2.0 * reversal - event.at);
               });
    });
}

std::optional<Eigen::ArrayXd> ProfilePanel::errors_of(const CellQuantity& quantity,
                                                      double time) const {
    if (over_.since != Over::Since::window || is_changed_in_window(time)) return {};
    return quantity.errors(axis_);
}

void ProfilePanel::survey(const FrameInput& input) {
    if (frames_seen_ == 0 && spec_.theory && options().quantity == FieldOf::density) add_laws();
    const auto slabs = static_cast<double>(cells_.all());
    for (CellQuantity& one : surveyed_) {
        one.see(input);
        const Eigen::ArrayXd values = values_of(one);
        const double time = input.tick.time;
        if (over_.since == Over::Since::window && time >= over_.window &&
            !is_changed_in_window(time))
            ++full_windows_;
        if (errors_of(one, time)) ++known_errors_;
        for_each_kept(values.size(), slabs * static_cast<double>(surveyed_.size()), frames_seen_,
                      static_cast<int>(sample_count(context_.run())), [&](Eigen::Index k) {
                          if (!std::isnan(values[k])) pool_.push_back(std::abs(values[k]));
                      });
    }
    ++frames_seen_;
}

void ProfilePanel::finish_record() {
    ProfileRun& run = record_.runs.front();
    run.length = cells_.box[axis_];
    run.most = pool_.empty() ? 0.0 : quantile(pool_, 0.999);
    for (const std::vector<double>& law : run.laws.y)
        run.most = std::max(run.most, *std::ranges::max_element(law));
    // By chance pieces that depend on each other pass the test now and then.
    run.has_errors = known_errors_ > 0 && 2 * known_errors_ >= full_windows_;
    pool_ = {};
    surveyed_ = {};
}

std::shared_ptr<const PanelState> ProfilePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ProfileState>();
    Measured& now = state->runs.emplace_back();
    const double width = cells_.box[axis_] / static_cast<double>(cells_.count[axis_]);
    for (int edge = 0; edge <= cells_.count[axis_]; ++edge) now.x.push_back(edge * width);
    for (CellQuantity& one : shown_) {
        one.see(input);
        const Eigen::ArrayXd values = values_of(one);
        now.y.emplace_back(values.begin(), values.end());
        std::vector<double>& errors = now.error.emplace_back();
        if (const std::optional<Eigen::ArrayXd> known = errors_of(one, input.tick.time))
            errors.assign(known->begin(), known->end());
    }
    return state;
}

std::shared_ptr<const PanelState> ProfilePanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    auto both = std::make_shared<ProfileState>();
    std::vector<const Measured*> all;
    for (const auto& state : states)
        all.push_back(&dynamic_cast<const ProfileState&>(*state).runs.front());
    if (record_.compares())
        for (const Measured* run : all) both->runs.push_back(*run);
    else
        both->runs = {mean_of(all)};
    return both;
}

std::optional<std::array<double, 2>> ProfilePanel::time_shown(double at) const {
    const auto start = start_of_mean(over_, at);
    if (!start) return {};
    return {{*start, at}};
}

namespace {

std::vector<Binding<ProfileOptions>> profile_keys() {
    return {
        bind_key("quantity", &ProfileOptions::quantity, quantity_notation(false),
                 "What it shows; `flow` is the mean velocity along the axis."),
        cells_key(&ProfileOptions::cells),
        bind_key("around", &ProfileOptions::around, vector_of(2, not_negative, quantities::length),
                 "A point: the density then is shown in rings around it, against the distance "
                 "from it, up to the nearest side of the box.")
            .default_text("none: along an axis"),
        bind_key("mark_front", &ProfileOptions::front, flag(),
                 "With `around`: whether to mark the distance at which the density is highest, "
                 "as the mean over three neighbouring rings, where it exceeds the mean density "
                 "of the box by more than three standard deviations of a gas at rest.")};
}

void check_profile(PanelSpec& panel, const Node& node, Reading& reading) {
    const Box& box = reading.box();
    const auto& options = panel.options.as<ProfileOptions>();
    const auto refuse_key = [&](const char* key, const char* message, const char* hint) {
        if (const Node* written = given(node, key)) reading.errors.add(*written, message, hint);
    };
    if (!options.around) {
        if (options.front)
            refuse_key("mark_front",
                       "`mark_front` needs `around`, the point that it runs away from",
                       "for instance around: [20, 15]");
        return;
    }
    if (box.dimension == 3)
        return refuse_key("around", "in a box with three lengths a profile goes along an axis",
                          "leave it out, and choose the axis by `component`");
    if (box.dimension == 1)
        return refuse_key("around", "on a wire there are no rings around a point",
                          "leave it out: a profile along the wire shows the density");
    for (const char* key : {"component", "quantity"})
        refuse_key(key, "a profile `around` a point is of the density in rings", "leave it out");
    const bool is_inside = on_each_axis(box.dimension, [&](int axis) {
        const double size = box.size[axis], at = (*options.around)[axis];
        return size <= 0.0 || (at > 0.0 && at < size);  // a size of 0 is reported
    });
    if (!is_inside)
        refuse_key("around", "this point is not inside the box",
                   "rings reach from the point to the nearest side");
}

std::unique_ptr<Panel> make_profile(const PanelContext& context, const PanelSpec& spec) {
    if (spec.options.as<ProfileOptions>().around) return make_radial_profile(context, spec);
    return std::make_unique<ProfilePanel>(context, spec);
}

}  // namespace

PanelKind profile_kind() {
    using enum Ability;
    return {.name = "profile",
            .words = Phrase{"profile"},
            .shows =
                "Density, temperature, mean speed or flow (`quantity`) in slabs along an axis, "
                "which is vertical for y. A density in gravity comes with that of an ideal gas "
                "of as many disks that share a fixed energy. With `around`, the density in rings "
                "around a point against the distance from it.",
            .make = make_profile,
            .abilities = {of, over, component, theory, means, comparison},
            .keys = option_keys(profile_keys()),
            .rule = check_profile,
            .work = always(PanelWork{.flights = PanelWork::Flights::followed})};
}

}  // namespace carom
