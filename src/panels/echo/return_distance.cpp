// The numbers of return distances: what is compared, the axes, tables and words.
#include "panels/echo/return_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/echo/return_distance_state.h"
#include "panels/plots/comparison.h"
#include "panels/registry.h"
#include "util/text.h"

namespace carom {

const char* ReturnDistancePanel::name_of(Line line) {
    return line == Line::largest ? "largest" : "root mean square";
}

double ReturnDistancePanel::value_of(const EchoRecord::Step& step, Line line) {
    return line == Line::largest ? step.apart.largest : step.apart.root_mean_square;
}

// -infinity for 0; finite also where the value is too small for a double.
double ReturnDistancePanel::log_of(const EchoRecord::Step& step, Line line) {
    return line == Line::largest ? step.apart.log10_largest : step.apart.log10_root_mean_square;
}

ReturnDistancePanel::ReturnDistancePanel(const PanelContext& context, const PanelSpec& spec)
    : context_(context), spec_(spec), echo_(context) {}

std::vector<ReturnDistancePanel::Line> ReturnDistancePanel::lines() const {
    if (compares()) return {Line::largest};
    return {Line::largest, Line::root_mean_square};
}

double ReturnDistancePanel::along(const EchoRecord::Step& step) const {
    return spec_.against_collisions ? step.collisions : step.since;
}

// Mean of the particles; 0: none.
double ReturnDistancePanel::radius() const {
    return context_.particles.count() > 0 ? context_.particles.radius.mean() : 0.0;
}

// The steps after a reversal.
ReturnDistancePanel::Steps ReturnDistancePanel::way_back(const ReturnDistancePanel& run,
                                                         std::size_t reversal) const {
    const auto found =
        std::ranges::equal_range(run.echo_.steps(), reversal, {}, &EchoRecord::Step::reversal);
    return {found.begin(), found.end()};
}

// Up to a radius: there distances are no longer small, and the law ends.
std::vector<ReturnDistancePanel::LawPoint> ReturnDistancePanel::law(const ReturnDistancePanel& run,
                                                                    std::size_t reversal) const {
    std::vector<LawPoint> points;
    if (!spec_.theory || !run.echo_.bits_per_collision()) return points;
    const double end = std::log10(run.radius());
    for (const EchoRecord::Step& step : way_back(run, reversal)) {
        if (!step.is_known) break;
        points.push_back({step, along(step), step.log10_law});
        if (step.log10_law < end) continue;
        if (points.size() == 1) return {};
        const LawPoint& before = points[points.size() - 2];
        const double share =
            (end - before.log10_distance) / (step.log10_law - before.log10_distance);
        points.back().along = std::lerp(before.along, points.back().along, share);
        points.back().step.since = std::lerp(before.step.since, step.since, share);
        points.back().step.collisions = std::lerp(before.step.collisions, step.collisions, share);
        points.back().log10_distance = end;
        break;
    }
    return points;
}

bool ReturnDistancePanel::has_law() const {
    return std::ranges::any_of(
        runs_, [&](const ReturnDistancePanel* run) { return !law(*run, 0).empty(); });
}

void ReturnDistancePanel::fix_axes() { choose_axes(); }

void ReturnDistancePanel::settle_beside(const std::vector<Panel*>& others,
                                        const std::vector<std::string>& names) {
    names_ = names;
    runs_.clear();
    for (ReturnDistancePanel* run : runs_of(*this, others)) runs_.push_back(run);
    choose_axes();
}

// For all that is drawn.
void ReturnDistancePanel::choose_axes() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double least = infinity, most = -infinity, last = 0.0;  // powers of ten, and a place
    for (const ReturnDistancePanel* run : runs_) {
        if (const double size = run->radius(); size > 0.0) most = std::max(most, std::log10(size));
        for (const EchoRecord::Step& step : run->echo_.steps()) {
            if (!step.is_known) continue;
            last = std::max(last, along(step));
            most = std::max(most, step.apart.log10_largest);
            for (const Line line : lines())
                if (std::isfinite(log_of(step, line))) least = std::min(least, log_of(step, line));
        }
        for (std::size_t k = 0; k < run->echo_.reversals().size(); ++k)
            for (const LawPoint& point : law(*run, k))
                least = std::min(least, point.log10_distance);
    }
    if (last > 0.0) last_ = last;
    if (std::isfinite(least)) low_ = std::floor(least);
    if (std::isfinite(most)) high_ = std::ceil(most);
    high_ = std::max(high_, low_ + 2.0);
}

std::shared_ptr<const PanelState> ReturnDistancePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ReturnDistanceState>();
    state->shown = {echo_.shown(input.tick.frame)};
    return state;
}

std::shared_ptr<const PanelState> ReturnDistancePanel::beside(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    return shown_of_each<ReturnDistanceState>(states);
}

// Whether, and when, the way back of the last reversal has left the way out.
std::string ReturnDistancePanel::told_of(const ReturnDistancePanel& run, std::size_t shown) const {
    const std::vector<EchoRecord::Step>& steps = run.echo_.steps();
    const EchoRecord::Step* last = nullptr;
    for (std::size_t k = 0; k < shown; ++k) {
        const EchoRecord::Step& step = steps[k];
        if (step.reversal != steps[shown - 1].reversal || !step.is_known) continue;
        last = &step;
        if (run.radius() > 0.0 && step.apart.log10_largest > std::log10(run.radius()))
            return fmt::format("a radius astray after {} collisions of each",
                               three_digits(step.collisions));
    }
    if (last == nullptr) return "not on the way back";
    return fmt::format("{} from the way out after {} collisions of each",
                       three_digits_of_power(last->apart.log10_largest),
                       three_digits(last->collisions));
}

std::vector<std::string> ReturnDistancePanel::told_of_runs(const PanelState& state) const {
    std::vector<std::string> told;
    for (std::size_t k = 0; k < runs_.size(); ++k)
        told.push_back(
            told_of(*runs_[k], static_cast<const ReturnDistanceState&>(state).shown.at(k)));
    return told;
}

std::string ReturnDistancePanel::account(const PanelState& state) const {
    const std::size_t shown = static_cast<const ReturnDistanceState&>(state).shown.front();
    if (shown == 0) return "";
    return fmt::format("At the last the largest is {}.", told_of(*this, shown));
}

// The same for all runs, or there is no law to name.
std::string ReturnDistancePanel::finding(const PanelState&) const {
    if (!has_law()) return "";
    const double bits = *echo_.bits_per_collision();
    for (const ReturnDistancePanel* run : runs_)
        if (run->echo_.bits_per_collision() != bits) return "";
    return fmt::format(
        "The growth law: distances double {} times with each collision of a particle.",
        three_digits(bits));
}

Table ReturnDistancePanel::table_of(const ReturnDistancePanel& run, std::size_t shown) const {
    Table table{{"part", "of", "reversal (number)",
                 column_name("since the reversal", reduced::time),
                 column_name("distance", reduced::length), "collisions of each (count)",
                 "log10 of distance"}};
    const auto logarithm = [](double value) { return std::isfinite(value) ? Cell{value} : Cell{}; };
    for (const Line line : lines())
        for (std::size_t k = 0; k < shown; ++k) {
            const EchoRecord::Step& step = run.echo_.steps()[k];
            if (step.is_known)
                table.rows.push_back({"line", name_of(line),
                                      static_cast<std::int64_t>(step.reversal) + 1, step.since,
                                      value_of(step, line), step.collisions,
                                      logarithm(log_of(step, line))});
        }
    for (std::size_t k = 0; k < run.echo_.reversals().size(); ++k)
        for (const LawPoint& point : law(run, k))
            table.rows.push_back({"curve", "growth law", static_cast<std::int64_t>(k) + 1,
                                  point.step.since, std::pow(10.0, point.log10_distance),
                                  point.step.collisions, point.log10_distance});
    if (run.radius() > 0.0 && std::log10(run.radius()) >= low_)
        for (const double place : {0.0, last_}) {
            table.rows.push_back(
                {"level", "mean radius", {}, {}, run.radius(), {}, std::log10(run.radius())});
            table.rows.back()[spec_.against_collisions ? 5 : 3] = place;
        }
    return table;
}

Table ReturnDistancePanel::table(const PanelState& state, const Theme&) const {
    const std::vector<std::size_t>& shown = static_cast<const ReturnDistanceState&>(state).shown;
    if (!compares()) return table_of(*this, shown.front());
    Table all;
    for (std::size_t k = 0; k < runs_.size(); ++k)
        add_table_of_run(all, names_[k], table_of(*runs_[k], shown.at(k)));
    return all;
}

std::unique_ptr<Panel> make_return_distance(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<ReturnDistancePanel>(context, spec);
}

}  // namespace carom
