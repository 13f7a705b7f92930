// The distance of the gas from its earlier states while it returns after a reversal: the largest
// and the root-mean-square distance of the particles, on a logarithmic axis, against the time or
// the collisions since the reversal, with the law by which such distances grow. For compared runs,
// only the largest distance.
#include "panels/echo/return_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "panels/echo/echo_record.h"
#include "panels/means/runs_record.h"
#include "panels/plot/plot_panel.h"
#include "util/text.h"

namespace carom {
namespace {

using namespace plot;
using Step = EchoRecord::Step;
using Steps = std::vector<Step>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double line_width = 0.18, law_width = 0.1;  // units

/// One run.
struct Echo {
    std::string name;
    Steps steps;
    std::vector<double> reversals;  ///< their times
    double radius = 0.0;            ///< mean of the particles; 0: none
    bool all_alike = true;          ///< their radii
    std::optional<double> bits;     ///< that are lost with each collision
    void archive(auto& archive) { archive(name, steps, reversals, radius, all_alike, bits); }
};

using EchoRuns = RunsRecord<Echo>;

/// What a line shows of each step. Logarithms are -infinity for 0, and finite also where the value
/// is too small for a double.
struct Distance {
    Phrase name, short_name;
    double ReturnDistance::*value;
    double ReturnDistance::*log10;
};
constexpr Distance largest{Phrase{"largest"}, Phrase{"largest"}, &ReturnDistance::largest,
                           &ReturnDistance::log10_largest};
constexpr Distance root_mean_square{Phrase{"root mean square"}, Phrase{"rms"},
                                    &ReturnDistance::root_mean_square,
                                    &ReturnDistance::log10_root_mean_square};

class ReturnDistancePanel : public RecordPanel<EchoRuns> {
  public:
    ReturnDistancePanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context),
          spec_(spec),
          against_collisions_(spec.options.as<ReturnDistanceOptions>().against_collisions),
          echo_(context) {}

    void survey(const FrameInput& input) override { echo_.survey(input); }
    bool wants_return_distances() const override { return true; }
    void archive(Archive& archive) override { archive(record_, low_, high_, last_); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive&) override {}
    Plot plot(const PanelState* state) const override;

  private:
    void finish_record() override;
    void make_axes() override;

    bool compares() const { return record_.compares(); }
    // Among the lines of compared runs the law has no colour of its own.
    Stroke stroke_of_law() const {
        return {.role = {compares() ? Role::Of::muted : Role::Of::accent}, .width = law_width};
    }
    double along(const Step& step) const {
        return against_collisions_ ? step.collisions : step.since;
    }
    Steps law(const Echo& run, std::size_t reversal) const;
    bool has_law() const;
    std::string account_of(const Echo& run, std::size_t shown) const;

    Stroke stroke(const Distance& distance, std::size_t run) const;
    Polyline line(const char* part, const std::string& of, const Steps& steps,
                  const Distance& distance) const;
    void add_distance(Plot& plot, std::size_t run, const Distance& distance,
                      std::size_t shown) const;
    void add_law(Plot& plot, std::size_t run, std::size_t shown) const;
    void add_level(Plot& plot) const;
    void add_end(Plot& plot) const;
    void add_start(Plot& plot) const;
    void add_words(Plot& plot) const;

    PanelContext context_;
    PanelSpec spec_;
    bool against_collisions_;  // along the horizontal axis
    EchoRecord echo_;
    double low_ = -16.0, high_ = 0.0;  // powers of ten
    double last_ = 1.0;                // of the horizontal axis
};

// The steps after a reversal until the law reaches the radius of a particle, where distances are no
// longer small and the law ends.
Steps ReturnDistancePanel::law(const Echo& run, std::size_t reversal) const {
    Steps points;
    if (!spec_.theory || !run.bits) return points;
    const double end = std::log10(run.radius);
    auto next = std::ranges::lower_bound(run.steps, reversal, {}, &Step::reversal);
    for (; next != run.steps.end() && next->reversal == reversal && next->is_known; ++next) {
        const Step& step = *next;
        points.push_back(step);
        if (step.log10_law < end) continue;
        if (points.size() == 1) return {};
        const Step& before = points[points.size() - 2];
        const double share = (end - before.log10_law) / (step.log10_law - before.log10_law);
        points.back().since = std::lerp(before.since, step.since, share);
        points.back().collisions = std::lerp(before.collisions, step.collisions, share);
        points.back().log10_law = end;
        break;
    }
    for (Step& point : points) {
        point.apart.log10_largest = point.log10_law;
        point.apart.largest = std::pow(10.0, point.log10_law);
    }
    return points;
}

bool ReturnDistancePanel::has_law() const {
    return std::ranges::any_of(record_.runs, [&](const Echo& run) { return !law(run, 0).empty(); });
}

void ReturnDistancePanel::finish_record() {
    const Eigen::ArrayXd& radius = context_.particles.radius;
    Echo echo{.name = "",
              .steps = echo_.steps(),
              .reversals = echo_.reversals(),
              .bits = echo_.bits_per_collision()};
    if (radius.size() > 0) echo.radius = radius.mean();
    if (radius.size() > 0) echo.all_alike = (radius == radius[0]).all();
    record_.runs = {std::move(echo)};
}

// The axes hold all that is drawn.
void ReturnDistancePanel::make_axes() {
    double least = infinity, most = -infinity, last = 0.0;  // powers of ten, and a place
    const auto take = [&](double power) {
        if (std::isfinite(power)) least = std::min(least, power);
    };
    for (const Echo& run : record_.runs) {
        if (run.radius > 0.0) most = std::max(most, std::log10(run.radius));
        for (const Step& step : run.steps) {
            if (!step.is_known) continue;
            last = std::max(last, along(step));
            most = std::max(most, step.apart.log10_largest);
            take(step.apart.log10_largest);
            if (!compares()) take(step.apart.log10_root_mean_square);
        }
        for (std::size_t k = 0; k < run.reversals.size(); ++k)
            for (const Step& point : law(run, k)) least = std::min(least, point.log10_law);
    }
    if (last > 0.0) last_ = last;
    if (std::isfinite(least)) low_ = std::floor(least);
    if (std::isfinite(most)) high_ = std::ceil(most);
    high_ = std::max(high_, low_ + 2.0);
}

std::shared_ptr<const PanelState> ReturnDistancePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ShownState>();
    const Steps& steps = record_.runs.front().steps;
    const auto next = std::ranges::upper_bound(steps, input.tick.frame, {}, &Step::frame);
    state->shown = {static_cast<std::size_t>(next - steps.begin())};
    return state;
}

// Whether, and when, the echo of the last reversal has departed from the original path.
std::string ReturnDistancePanel::account_of(const Echo& run, std::size_t shown) const {
    const Language language = context_.language();
    const Step* last = nullptr;
    for (std::size_t k = 0; k < shown; ++k) {
        const Step& step = run.steps[k];
        if (step.reversal != run.steps[shown - 1].reversal || !step.is_known) continue;
        last = &step;
        if (run.radius > 0.0 && step.apart.log10_largest > std::log10(run.radius))
            return say(language, "one radius away after {} collisions per particle",
                       three_digits(language, step.collisions));
    }
    if (last == nullptr) return say(language, "not yet reversed");
    return say(language, "return error {} after {} collisions per particle",
               three_digits_of_power(language, last->apart.log10_largest),
               three_digits(language, last->collisions));
}

Stroke ReturnDistancePanel::stroke(const Distance& distance, std::size_t run) const {
    if (compares()) return stroke_of_run(run, line_width);
    if (distance.name == largest.name)
        return {.role = {Role::Of::highlight}, .width = line_width, .shade = Shade::legible};
    return {.role = {Role::Of::bar},
            .width = line_width,
            .dashes = {0.5, 0.5},
            .shade = Shade::legible};
}

const Heading since_column{"since the reversal", quantities::time};
const Heading collisions_column{"collisions of each", quantities::count};
const Heading distance_column = quantities::distance;
const Heading log_column{"log10 of distance", quantities::distance.logarithm()};
const Heading reversal_column{"reversal", quantities::ordinal};

// A piece of the line ends at each reversal, and where the distance is exactly 0.
Polyline ReturnDistancePanel::line(const char* part, const std::string& of, const Steps& steps,
                                   const Distance& distance) const {
    std::vector<double> reversal, since, collisions, value, log;
    std::vector<int> pieces;
    int piece = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Step& step = steps[k];
        reversal.push_back(static_cast<double>(step.reversal) + 1.0);
        since.push_back(step.since);
        collisions.push_back(step.collisions);
        value.push_back(step.apart.*distance.value);
        log.push_back(step.is_known ? step.apart.*distance.log10 : std::nan(""));
        if (k > 0 && (step.reversal != steps[k - 1].reversal || !std::isfinite(log.back())))
            ++piece;
        pieces.push_back(piece);
    }
    Polyline line;
    line.part = part;
    line.of = of;
    Column along = column(since_column, std::move(since));
    Column other = column(collisions_column, std::move(collisions));
    if (against_collisions_) std::swap(along, other);
    line.x = std::move(along);
    line.y = column(log_column, std::move(log));
    line.more = {column(reversal_column, std::move(reversal)), std::move(other),
                 column(distance_column, std::move(value))};
    line.piece = std::make_shared<const std::vector<int>>(std::move(pieces));
    return line;
}

// Echoes of former reversals are fainter. Distances of exactly 0 are shown as rings instead of a
// line.
void ReturnDistancePanel::add_distance(Plot& plot, std::size_t run, const Distance& distance,
                                       std::size_t shown) const {
    const Steps& steps = record_.runs[run].steps;
    std::size_t present = shown;
    while (present > 0 && steps[present - 1].reversal == steps[shown - 1].reversal) --present;
    Polyline line = this->line("line", std::string(distance.name.english), steps, distance);
    if (compares()) line.run = run;
    line.depth = distance.name == largest.name ? static_cast<int>(run) : 1;
    const auto add = [&](Shown part, double fade) {
        line.shown = part;
        line.stroke = stroke(distance, run);
        line.stroke.fade = fade;
        plot.layers.emplace_back(line);
        Points zeros;
        zeros.depth = line.depth;
        zeros.shown = part;
        zeros.x = line.x;
        std::vector<double> at_zero;
        for (const Step& step : steps) {
            const double log = step.apart.*distance.log10;
            at_zero.push_back(step.is_known && std::isinf(log) ? log : std::nan(""));
        }
        zeros.y = column(log_column, std::move(at_zero));
        zeros.spacing = 0.3;
        zeros.dot = {.role = line.stroke.role, .radius = 0.2, .fade = fade, .ring = 0.1};
        plot.layers.emplace_back(std::move(zeros));
    };
    if (present > 0) add({0, present}, 0.4);
    add({present, shown}, 0.0);
    if (compares()) return;
    while (shown > present && !steps[shown - 1].is_known) --shown;
    if (shown == present) return;
    Points head;
    head.depth = line.depth;
    head.x = column(line.x.heading, {line.x[shown - 1]});
    head.y = column(line.y.heading, {line.y[shown - 1]});
    head.dot = {.role = line.stroke.role, .radius = 0.3};
    plot.layers.emplace_back(std::move(head));
}

void ReturnDistancePanel::add_law(Plot& plot, std::size_t run, std::size_t shown) const {
    const Echo& echo = record_.runs[run];
    const Steps points = law(echo, shown > 0 ? echo.steps[shown - 1].reversal : 0);
    if (points.empty()) return;
    Polyline curve = line("curve", "upper estimate", points, largest);
    if (shown == 0) curve.shown.end = 0;
    curve.stroke = stroke_of_law();
    curve.depth = static_cast<int>(record_.runs.size()) + 1;
    if (compares()) curve.run = run;
    plot.layers.emplace_back(std::move(curve));
}

// The level of a particle's radius, beyond which the echo is visibly lost. Its label is at the
// right end, since lines are steep at the left.
void ReturnDistancePanel::add_level(Plot& plot) const {
    const Echo& first = record_.runs.front();
    const double power = std::log10(first.radius);
    if (!(first.radius > 0.0) || power < low_) return;
    for (const Echo& run : record_.runs)
        if (run.radius != first.radius) return;
    Level level;
    level.part = "level";
    level.of = "mean radius";
    level.column = log_column;
    level.x_column = against_collisions_ ? collisions_column : since_column;
    level.value = power;
    level.more = {column(distance_column, {first.radius})};
    level.still = true;
    Label name;
    constexpr std::array of_one{Phrase{"one bead radius"}, Phrase{"one disk radius"},
                                Phrase{"one sphere radius"}};
    const auto dimension = static_cast<std::size_t>(context_.box().dimension);
    const Phrase radius = first.all_alike ? of_one.at(dimension - 1) : Phrase{"mean radius"};
    name.words = {say(context_.language(), radius)};
    name.anchors = {{.at = {1.0, power},
                     .x_is_share = true,
                     .offset = {-0.4, 1.2},
                     .align = Align::right,
                     .step = {-1.0, 0.0}}};
    level.label = std::move(name);
    plot.layers.emplace_back(std::move(level));
}

// Where the gas is back at its start.
void ReturnDistancePanel::add_end(Plot& plot) const {
    const Echo& run = record_.runs.front();
    if (compares() || run.reversals.empty()) return;
    const double end = run.reversals.front() * (1.0 - 1e-9);
    const auto there = std::ranges::find_if(run.steps, [&](const Step& step) {
        return step.reversal == 0 && step.is_known && step.since >= end;
    });
    if (there == run.steps.end()) return;
    Marker marker;
    marker.value = along(*there);
    marker.still = true;
    Label name;
    name.words = {say(context_.language(), "exact return"), say(context_.language(), "return")};
    name.anchors = {{.at = {marker.value, 1.0},
                     .y_is_share = true,
                     .offset = {-0.4, -0.5},
                     .align = Align::right}};
    marker.label = std::move(name);
    plot.layers.emplace_back(std::move(marker));
}

// In an empty plot, tells when the measurement begins.
void ReturnDistancePanel::add_start(Plot& plot) const {
    const Echo& run = record_.runs.front();
    Label label;
    const Language language = context_.language();
    const std::string time = "<i>t</i> = " + three_digits(language, run.reversals.front());
    label.words = {say(language, "starts at {}", time), say(language, "from {}", time)};
    for (const Point at : {Point{0.5, 0.5}, {0.5, 0.75}, {0.5, 0.25}, {0.6, 0.5}})
        label.anchors.push_back({.at = at,
                                 .x_is_share = true,
                                 .y_is_share = true,
                                 .offset = {0.0, 0.35},
                                 .align = Align::center});
    plot.layers.emplace_back(std::move(label));
}

// The title gives the number of bits of the run, which determines whether the gas returns. The
// growth law is named only if it is the same for all runs.
void ReturnDistancePanel::add_words(Plot& plot) const {
    const Language language = context_.language();
    const std::string title = say(language, "Return error");
    const int bits = context_.run().bits.value_or(bits_of_double);
    plot.titles = {say(language, "Return error ({}-bit arithmetic)", bits),
                   say(language, "Return error, {} bits", bits), title};
    if (compares()) plot.titles = {title};
    if (spec_.title) plot.titles = {escape_markup(*spec_.title)};
    Note lines;
    if (compares())
        lines.entries = {
            {{}, {say(language, "the largest of all particles"), say(language, "the largest")}}};
    else
        for (const Distance& distance : {largest, root_mean_square})
            lines.entries.push_back(
                {stroke(distance, 0),
                 {say(language, distance.name), say(language, distance.short_name)}});
    if (has_law())
        lines.entries.push_back(
            {stroke_of_law(),
             {say(language, "upper estimate of growth"), say(language, "upper estimate")}});
    lines.wraps = true;
    plot.notes = {std::move(lines)};
    std::vector<std::string> names;
    for (const auto& one : record_.runs) names.push_back(one.name);
    if (compares()) name_runs(plot, std::move(names));
    const std::optional<double>& lost = record_.runs.front().bits;
    if (has_law() &&
        std::ranges::all_of(record_.runs, [&](const Echo& run) { return run.bits == lost; }))
        plot.finding =
            say(language,
                "Upper estimate of the growth: small distances double {} times with each "
                "collision of a particle.",
                three_digits(language, *lost));
}

Plot ReturnDistancePanel::plot(const PanelState* state) const {
    const Language language = context_.language();
    const Quantity across =
        against_collisions_
            ? quantities::count.named(Phrase{"collisions per particle since the reversal"})
            : quantities::time.named(Phrase{"time since the reversal"});
    Plot plot{
        .language = language,
        .x = axis_of(language, across, 0.0, last_),
        .y = {.low = low_, .high = high_, .kind = Axis::Kind::powers, .has_zero_place = true}};
    if (against_collisions_) plot.x.short_title = say(language, "collisions per particle");
    plot.y.quantity = log_column.quantity;
    plot.columns = {reversal_column, since_column, distance_column, collisions_column, log_column};
    add_words(plot);
    const std::vector<std::size_t> none(record_.runs.size(), 0);
    const std::vector<std::size_t>& shown =
        state ? static_cast<const ShownState&>(*state).shown : none;
    const bool has_begun = shown != none;  // else labels keep clear of what will come
    for (std::size_t k = 0; k < record_.runs.size(); ++k) {
        const Echo& run = record_.runs[k];
        add_distance(plot, k, largest, shown[k]);
        if (!compares()) add_distance(plot, k, root_mean_square, shown[k]);
        add_law(plot, k, shown[k]);
        if (compares()) plot.accounts_of_runs.push_back(account_of(run, shown[k]));
    }
    add_level(plot);
    add_end(plot);
    if (state && !has_begun && !record_.runs.front().reversals.empty()) add_start(plot);
    if (has_begun && !compares())
        plot.account = say(language, "For the particle that is farthest away: {}.",
                           account_of(record_.runs.front(), shown[0]));
    return plot;
}

}  // namespace

std::unique_ptr<Panel> make_return_distance(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<ReturnDistancePanel>(context, spec);
}

}  // namespace carom
