// The collision of two beads on a wire in the plane of their velocities: an ellipse of constant
// energy, a line of constant momentum, and their two intersections, the states before and after the
// collision. Alternatively, all collisions of the two beads as a walk on the ellipse.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>

#include "panels/collision/pair_collision.h"
#include "panels/collision/pair_motion.h"
#include "panels/gas/bead_words.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "util/text.h"

namespace carom {
namespace {

using namespace plot;
using Vector = Eigen::Array2d;
using Cause = WalkStep::Cause;

constexpr int ellipse_points = 240;
constexpr double air_around = 1.08;  // over the largest velocities, at the ends of the axes
constexpr int depth_of_zero = 5, depth_of_equal = 4, depth_of_energy = 3, depth_of_lines = 2,
              depth_of_arrows = 1;

const plot::Mark full{.role = {Role::Of::ink}, .radius = 0.36, .halo = 0.1};
const plot::Mark hollow{.role = {Role::Of::ink}, .radius = 0.36, .is_hollow = true, .halo = 0.1};
const Stroke of_energy{.width = 0.16}, of_equal{.width = 0.1, .dashes = {0.12, 0.3}};
const Stroke of_steps{.role = {Role::Of::highlight}, .width = 0.14, .shade = Shade::legible};
const Stroke of_walls{.width = 0.11, .dashes = {0.4, 0.3}};
const Role ink{Role::Of::ink}, page{Role::Of::page}, muted{Role::Of::muted};

struct MapState : PanelState {
    std::size_t steps = 0;  // of the walk, so far
    int stage = 0;          // of the collision shown: 1 before, 2 after, 0 another flight
};

struct Counts {
    std::int64_t pair = 0, wall = 0;
};

Stroke of_momentum() {
    Stroke stroke = of_steps;
    stroke.print_dashes = dashes_in_print(1, 2);
    return stroke;
}

// Three digits, without zeros at the end.
std::string few_digits(Language language, double value) {
    return plain_number(language, std::stod(fmt::format("{:.3g}", off_the_tie(value))));
}

// The total momentum as text; 0 if the two momenta cancel up to round-off.
std::string momentum_words(Language language, const PairMotion& motion) {
    const double least = 1e-12 * (motion.before / motion.inverse_mass).abs().maxCoeff();
    return few_digits(language, std::abs(motion.momentum()) < least ? 0.0 : motion.momentum());
}

// The components of a vector as text; those that are 0 up to round-off are written as 0.
std::vector<std::string> numbers(Language language, const Vector& velocity) {
    const double least = 1e-9 * velocity.abs().maxCoeff();
    const auto words = [&](double v) {
        return few_digits(language, std::abs(v) < least ? 0.0 : v);
    };
    return {words(velocity[0]), words(velocity[1])};
}

std::string in_brackets(Language language, const Vector& velocity) {
    return fmt::format("({})", fmt::join(numbers(language, velocity), between_numbers(language)));
}

class CollisionMapPanel : public PlotPanel {
  public:
    CollisionMapPanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context), spec_(spec), watch_(context, spec), walk_watch_(context, spec) {}

    void survey(const FrameInput& input) override;
    bool surveys_collisions() const override { return !spec_.given; }
    void fix_axes() override;
    void archive(Archive& archive) override {
        archive(met_, motion_, number_, walk_, factor_, reach_);
        if (archive.is_reading()) make_plot();
    }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive&) override {}
    Plot plot(const PanelState* state) const override;
    std::optional<std::array<double, 2>> time_shown(double at) const override;

  private:
    bool is_walk() const { return spec_.walk; }
    bool is_scaled() const { return spec_.scaled.value_or(is_walk()); }
    void find_motion();
    Counts counts_of(std::size_t steps) const;
    std::string subscripted(const char* letter, std::size_t k) const;
    std::string name_of(std::size_t k) const;
    std::string column_of(std::size_t k) const;
    Axis axis(std::size_t k) const;
    std::vector<Text> titles() const;
    /// Only a walk says all without numbers of particles.
    std::optional<std::array<std::string, 2>> walking_names() const {
        return is_walk() && met_ ? own_names(context_, *met_) : std::nullopt;
    }
    Note key(std::size_t steps) const;
    Note key_of_walk(std::size_t steps) const;
    Note key_of_collision() const;
    std::string energy_words() const {
        return say(context_.language(), "energy {}",
                   few_digits(context_.language(), motion_.energy()));
    }
    std::vector<Column> columns(const std::vector<Vector>& velocities) const;
    Line line(const std::vector<Vector>& through, Stroke stroke, int depth) const;
    Points points(const std::vector<Vector>& at, const plot::Mark& mark) const;
    Arrow arrow(const Vector& from, const Vector& to, const Role& role, const Role& edge) const;
    void make_plot();
    void add_energy();
    void add_collision();
    void add_matrix();
    void add_walk(Plot& plot, std::size_t steps) const;
    std::string account_of(std::size_t steps) const;

    PanelContext context_;
    PanelSpec spec_;
    PairCollisionWatch watch_;
    WalkWatch walk_watch_;
    std::optional<PairCollision> met_;  // of the run
    PairMotion motion_;
    std::array<std::int64_t, 2> number_{1, 2};  // what the two are called
    std::vector<WalkStep> walk_;
    Vector factor_{1.0, 1.0};  // of each velocity: 1, or the root of its mass
    Vector reach_{1.0, 1.0};   // largest velocities shown, times factor_
    Plot whole_;               // what is still
};

void CollisionMapPanel::survey(const FrameInput& input) {
    if (spec_.given) return;
    watch_.survey(input);
    if (is_walk()) walk_watch_.survey(input);
}

void CollisionMapPanel::find_motion() {
    if (spec_.given) {
        motion_ = {.inverse_mass = spec_.given->inverse_mass, .before = spec_.given->velocity};
        motion_.after = (collision_matrix(motion_.inverse_mass) * motion_.before.matrix()).array();
        return;
    }
    met_ = watch_.collision();
    for (std::size_t k = 0; k < 2; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        number_[k] = met_->particle[k];
        motion_.inverse_mass[i] = context_.particles.inverse_mass[met_->particle[k]];
        motion_.before[i] = met_->before[k][0];
        motion_.after[i] = met_->after[k][0];
    }
}

void CollisionMapPanel::fix_axes() {
    find_motion();
    if (motion_.has_infinite_mass() && (is_scaled() || is_walk()))
        refuse(spec_.place,
               fmt::format(
                   "a collision with an infinite mass has no ellipse of energy, which `{}` needs",
                   spec_.scaled == true ? "scaled" : "walk"),
               "leave it out, or give a pair of finite masses");
    if (is_scaled()) factor_ = motion_.inverse_mass.rsqrt();
    if (is_walk()) walk_ = walk_watch_.steps();
    reach_ = motion_.before.abs().max(motion_.after.abs());
    if (!motion_.has_infinite_mass())
        reach_ = (2.0 * motion_.energy() * motion_.inverse_mass).sqrt();
    reach_ = (factor_ * reach_).max(0.25 * (factor_ * reach_).maxCoeff());
    make_plot();
}

std::shared_ptr<const PanelState> CollisionMapPanel::state(const FrameInput& input) {
    auto state = std::make_shared<MapState>();
    const double now = input.tick.time;
    while (state->steps < walk_.size() && walk_[state->steps].time <= now) ++state->steps;
    if (met_ && now >= met_->since && now <= met_->until) state->stage = now < met_->time ? 1 : 2;
    return state;
}

Counts CollisionMapPanel::counts_of(std::size_t steps) const {
    Counts counts;
    for (std::size_t i = 0; i < steps; ++i) {
        if (walk_[i].cause == Cause::pair) ++counts.pair;
        if (walk_[i].cause == Cause::wall) ++counts.wall;
    }
    return counts;
}

std::string CollisionMapPanel::subscripted(const char* letter, std::size_t k) const {
    constexpr std::array lowered{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string words = letter;
    for (const char digit : std::to_string(number_[k]))
        words += lowered[static_cast<std::size_t>(digit - '0')];
    return words;
}

std::string CollisionMapPanel::name_of(std::size_t k) const {
    return is_scaled() ? fmt::format("sqrt(m{0}) v{0}", number_[k])
                       : fmt::format("v{}", number_[k]);
}

std::string CollisionMapPanel::column_of(std::size_t k) const {
    return column_name(name_of(k), is_scaled() ? "mass^0.5 length/time" : reduced::speed);
}

Axis CollisionMapPanel::axis(std::size_t k) const {
    // In this order the root needs no bar over the mass.
    const auto own = walking_names();
    const std::string name =
        own ? own->at(k) + ": v" + (is_scaled() ? "\u2009√m" : "")
            : subscripted("v", k) + (is_scaled() ? "\u2009√" + subscripted("m", k) : "");
    const double end = air_around * reach_[static_cast<Eigen::Index>(k)];
    return {.title = met_ ? named(name, role_of(context_, *met_, k)) : Text(name),
            .low = -end,
            .high = end};
}

std::vector<Text> CollisionMapPanel::titles() const {
    if (spec_.title) return {escape_markup(*spec_.title)};
    const Language language = context_.language();
    const Text of =
        met_ ? names_of(context_, *met_)
             : Text(say(language, "masses {} and {}", mass_text(language, motion_.inverse_mass[0]),
                        mass_text(language, motion_.inverse_mass[1])));
    const Text words = text_of(language, Phrase{"Velocities of {}"}, {of});
    if (is_walk())
        return {text_of(language, Phrase{"{}, collision by collision"}, {words}),
                say(language, "Velocities, collision by collision"), say(language, "Velocities")};
    return {text_of(language, Phrase{"{} in their collision"}, {words}), words,
            say(language, "Velocities in a collision")};
}

Note CollisionMapPanel::key_of_walk(std::size_t steps) const {
    const Counts counts = counts_of(steps), all = counts_of(walk_.size());
    const Language language = context_.language();
    const auto with_each_other = [&](const Counts& of) {
        return say(language, "with each other: {}", grouped(of.pair));
    };
    const auto with_a_wall = [&](const Counts& of) {
        return say(language, "with a wall: {}", grouped(of.wall));
    };
    return {
        .entries =
            {{.words = {say(language, "start")}, .mark = hollow},
             {.words = {spec_.at ? say(language, "at time {}", plain_number(language, *spec_.at))
                                 : say(language, "now")},
              .mark = full},
             {.sample = of_energy, .words = {energy_words()}},
             {.sample = of_steps,
              .words = {with_each_other(counts)},
              .reserved = {{with_each_other(all)}}},
             {.sample = of_walls, .words = {with_a_wall(counts)}, .reserved = {{with_a_wall(all)}}},
             {.sample = of_equal,
              .words = {walking_names() ? say(language, "equal velocities")
                                        : subscripted("v", 0) + " = " + subscripted("v", 1)}}},
        .changes = true};
}

Note CollisionMapPanel::key_of_collision() const {
    const std::array v{subscripted("v", 0), subscripted("v", 1)};
    const Language language = context_.language();
    std::string energy = energy_words();
    std::string momentum = say(language, "momentum {}", momentum_words(language, motion_));
    if (motion_.has_infinite_mass()) {
        const std::size_t wall = motion_.inverse_mass[0] > 0.0 ? 1 : 0;
        const double velocity = motion_.before[static_cast<Eigen::Index>(wall)];
        energy = say(language, "no ellipse: |{} − {}| = {}", v[0], v[1],
                     few_digits(language, motion_.speed_apart()));
        momentum = say(language, "{} = {}, mass ∞", v[wall], few_digits(language, velocity));
    }
    const Vector stays = factor_ / factor_[0];
    Vector turns = factor_ * motion_.turning();
    turns /= turns[0] != 0.0 ? turns[0] : turns[1];
    const auto sample = [](double from, double to, const Role& role, const Role& edge) {
        return Arrow{{}, {from, 0.0}, {to, 0.0}, role, edge};
    };
    return {
        .entries = {{.words = {say(language, "before {}", in_brackets(language, motion_.before))},
                     .mark = hollow},
                    {.words = {say(language, "after {}", in_brackets(language, motion_.after))},
                     .mark = full},
                    {.sample = of_energy, .words = {energy}},
                    {.sample = of_momentum(), .words = {momentum}},
                    {.sample = of_equal,
                     .words = {say(language, "{} is conserved", in_brackets(language, stays))},
                     .arrows = {sample(0.0, 0.6, muted, page)}},
                    {.words = {say(language, "{} is reversed", in_brackets(language, turns))},
                     .arrows = {sample(0.5, 0.0, page, ink), sample(0.5, 1.0, ink, page)}}}};
}

Note CollisionMapPanel::key(std::size_t steps) const {
    Note note = is_walk() ? key_of_walk(steps) : key_of_collision();
    note.wraps = note.may_be_beside = true;
    note.sample_width = 2.0;
    return note;
}

// The columns of some velocities, as the axes and the table show them.
std::vector<Column> CollisionMapPanel::columns(const std::vector<Vector>& velocities) const {
    std::vector<double> first, second;
    for (const Vector& velocity : velocities) {
        first.push_back(factor_[0] * velocity[0]);
        second.push_back(factor_[1] * velocity[1]);
    }
    return {column(column_of(0), std::move(first)), column(column_of(1), std::move(second))};
}

Line CollisionMapPanel::line(const std::vector<Vector>& through, Stroke stroke, int depth) const {
    const std::vector<Column> places = columns(through);
    Line line{{.depth = depth, .still = true}, places[0], places[1]};
    line.is_thinned = false;
    line.stroke = std::move(stroke);
    line.marks_exits = false;  // arrows are velocities
    return line;
}

Points CollisionMapPanel::points(const std::vector<Vector>& at, const plot::Mark& mark) const {
    const std::vector<Column> places = columns(at);
    Points points{{}, places[0], places[1]};
    points.mark = mark;
    return points;
}

Arrow CollisionMapPanel::arrow(const Vector& from, const Vector& to, const Role& role,
                               const Role& edge) const {
    const Vector start = factor_ * from, end = factor_ * to;
    return {{.depth = depth_of_arrows, .still = true},
            {start[0], start[1]},
            {end[0], end[1]},
            role,
            edge};
}

// For an infinite mass: the two velocities that the other bead can have, in the frame of the
// infinite mass.
void CollisionMapPanel::add_energy() {
    const Layer still{.depth = depth_of_energy, .still = true};
    if (motion_.has_infinite_mass()) {
        for (const Vector& through : {motion_.before, motion_.after})
            if (motion_.inverse_mass[0] > 0.0)
                whole_.layers.emplace_back(Marker{still, "", through[0], {}, of_energy});
            else
                whole_.layers.emplace_back(Level{still, "", through[1], of_energy});
        return;
    }
    const Vector half = (2.0 * motion_.energy() * motion_.inverse_mass).sqrt();
    std::vector<Vector> around;
    for (int i = 0; i <= ellipse_points; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / ellipse_points;
        around.push_back({half[0] * std::cos(turn), half[1] * std::sin(turn)});
    }
    Line ellipse = line(around, of_energy, depth_of_energy);
    ellipse.part = "curve";
    ellipse.of = "energy";
    whole_.layers.emplace_back(std::move(ellipse));
}

// The arrows from 0 to the motion of the centre of mass, and from there to the velocities before
// and after; in the table they list the centre of mass and the eigenvectors.
void CollisionMapPanel::add_collision() {
    const double time = met_ ? met_->time : std::nan("");
    const auto add_point = [&](const char* of, const Vector& at, const plot::Mark& mark) {
        Points point = points({at}, mark);
        static_cast<Layer&>(point) = {.part = "point", .of = of, .still = true};
        point.more = {column(whole_.columns[1], {time})};
        whole_.layers.emplace_back(std::move(point));
    };
    const auto add_arrow = [&](const char* part, const char* of, const Vector& listed,
                               Arrow arrow) {
        arrow.part = part;
        arrow.of = of;
        arrow.more = columns({listed});
        whole_.layers.emplace_back(std::move(arrow));
    };
    add_point("before", motion_.before, hollow);
    add_point("after", motion_.after, full);
    const Vector middle = Vector::Constant(motion_.mass_center_velocity());
    Arrow center = arrow(Vector::Zero(), middle, muted, page);
    Arrow before = arrow(middle, motion_.before, page, ink);
    Arrow after = arrow(middle, motion_.after, ink, page);
    center.shortest = 1.0;
    before.gap = after.gap = full.radius;
    before.shortest = after.shortest = 0.8;
    add_arrow("point", "centre of mass", middle, std::move(before));
    add_arrow("eigenvector", "1", Vector::Ones(), std::move(center));
    add_arrow("eigenvector", "-1", motion_.turning(), std::move(after));
    const Vector far =
        motion_.turning() * (10.0 * reach_.sum() / (factor_ * motion_.turning()).abs().maxCoeff());
    whole_.layers.emplace_back(
        line({motion_.before - far, motion_.before + far}, of_momentum(), depth_of_lines));
}

// Each row gives a velocity after a collision, as the axes show it, as a sum of those before it.
void CollisionMapPanel::add_matrix() {
    const Eigen::Matrix2d matrix = factor_.matrix().asDiagonal() *
                                   collision_matrix(motion_.inverse_mass) *
                                   factor_.inverse().matrix().asDiagonal();
    for (std::size_t k = 0; k < 2; ++k)
        whole_.columns.push_back(
            column_name(fmt::format("coefficient of {}", name_of(k)), "number"));
    for (std::size_t row = 0; row < 2; ++row) {
        Layer numbers{.part = "matrix", .of = name_of(row)};
        for (std::size_t k = 0; k < 2; ++k)
            numbers.more.push_back(
                column(whole_.columns[2 + 2 + k],
                       {matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k))}));
        whole_.numbers.push_back(std::move(numbers));
    }
}

void CollisionMapPanel::make_plot() {
    whole_ = {.language = context_.language(),
              .titles = titles(),
              .x = axis(0),
              .y = axis(1),
              .has_equal_scales = true};
    whole_.columns = {"step (number)", column_name("time", reduced::time), column_of(0),
                      column_of(1)};
    whole_.notes = {key(walk_.size())};
    const Layer zero{.depth = depth_of_zero, .still = true};
    const Stroke faint{.width = 0.06, .fade = 0.6};
    whole_.layers.emplace_back(Level{zero, "", 0.0, faint});
    whole_.layers.emplace_back(Marker{zero, "", 0.0, {}, faint});
    const Vector far = Vector::Constant(10.0 * reach_.sum() / factor_.maxCoeff());
    whole_.layers.emplace_back(line({-far, far}, of_equal, depth_of_equal));
    add_energy();
    if (!is_walk()) add_collision();
    add_matrix();
}

// Long walks are drawn finer.
void CollisionMapPanel::add_walk(Plot& plot, std::size_t steps) const {
    constexpr std::array causes{"start", "collision of the two", "wall", "reversal"};
    const double fine = std::sqrt(std::min(1.0, 40.0 / static_cast<double>(walk_.size())));
    const auto add_steps = [&](Cause cause, Stroke stroke) {
        std::vector<Vector> ends;
        std::vector<int> pieces;
        for (std::size_t i = 1; i < steps; ++i) {
            if (walk_[i].cause != cause) continue;
            ends.insert(ends.end(), {walk_[i - 1].velocity, walk_[i].velocity});
            pieces.insert(pieces.end(), 2, static_cast<int>(i));
        }
        stroke.width *= fine;
        Line line = this->line(ends, std::move(stroke), depth_of_lines);
        line.still = false;
        line.piece = std::make_shared<const std::vector<int>>(std::move(pieces));
        plot.layers.emplace_back(std::move(line));
    };
    add_steps(Cause::pair, of_steps);
    add_steps(Cause::wall, of_walls);
    std::vector<Vector> velocities;
    std::vector<double> numbers, times;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < steps; ++i) {
        velocities.push_back(walk_[i].velocity);
        numbers.push_back(static_cast<double>(i));
        times.push_back(walk_[i].time);
        names.emplace_back(causes.at(static_cast<std::size_t>(walk_[i].cause)));
    }
    Points all = points(velocities, {.role = of_steps.role, .radius = std::max(0.1, 0.22 * fine)});
    all.part = "point";
    all.of_each = std::move(names);
    all.more = {column(plot.columns[0], std::move(numbers)),
                column(plot.columns[1], std::move(times))};
    plot.layers.emplace_back(std::move(all));
    plot.layers.emplace_back(points({walk_.front().velocity}, hollow));
    if (steps > 1) plot.layers.emplace_back(points({walk_[steps - 1].velocity}, full));
}

std::string CollisionMapPanel::account_of(std::size_t steps) const {
    const Language language = context_.language();
    const auto mass = [&](Eigen::Index k) {
        return motion_.inverse_mass[k] > 0.0
                   ? say(language, "mass {}", mass_text(language, motion_.inverse_mass[k]))
                   : say(language, "infinite mass");
    };
    const auto both = [&](const Vector& velocity) {
        return listed(language, numbers(language, velocity));
    };
    const std::string pair = say(language, "Beads of {} and {}", mass(0), mass(1));
    if (is_walk()) {
        const Counts counts = counts_of(steps);
        return say(language, "{} at energy {}: {} and {}, from velocities {} to {}.", pair,
                   few_digits(language, motion_.energy()),
                   carom::counted(language, counts.pair, Phrase{"{} collision with one another"},
                                  Phrase{"{} collisions with one another"}),
                   carom::counted(language, counts.wall, Phrase{"{} with a wall"},
                                  Phrase{"{} with a wall"}),
                   both(walk_.front().velocity), both(walk_[steps - 1].velocity));
    }
    const std::string kept =
        motion_.has_infinite_mass()
            ? say(language,
                  "the infinite mass keeps its velocity, and the relative speed {} is conserved",
                  few_digits(language, motion_.speed_apart()))
            : say(language, "energy {} and momentum {} are conserved",
                  few_digits(language, motion_.energy()), momentum_words(language, motion_));
    return say(language, "{}, with velocities {} before their collision and {} after it: {}.", pair,
               both(motion_.before), both(motion_.after), kept);
}

std::optional<std::array<double, 2>> CollisionMapPanel::time_shown(double at) const {
    if (is_walk()) return {{0.0, at}};
    if (!met_) return {};
    return {{met_->time, met_->time}};
}

Plot CollisionMapPanel::plot(const PanelState* state) const {
    Plot plot = whole_;
    if (state == nullptr) return plot;
    const auto& now = static_cast<const MapState&>(*state);
    plot.account = account_of(now.steps);
    if (is_walk()) {
        plot.notes = {key(now.steps)};
        add_walk(plot, now.steps);
    } else if (now.stage > 0 && context_.in_film) {
        plot.layers.emplace_back(points({now.stage == 1 ? motion_.before : motion_.after},
                                        {.role = of_steps.role, .radius = 0.75, .ring = 0.12}));
    }
    return plot;
}

}  // namespace

std::unique_ptr<Panel> make_collision_map(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<CollisionMapPanel>(context, spec);
}

}  // namespace carom
