#include "panels/collision/single_collision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/palette.h"
#include "panels/gas/bead_words.h"
#include "panels/plot/layers.h"
#include "panels/registry.h"
#include "util/archive.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double apart = 1.6;          // distance of the centres before and after, over contact's
constexpr double longest_arrow = 1.0;  // over the distance at contact
constexpr double words_above = 1.65, words_below = 1.4;  // units, of each stage
constexpr double least_of_row = 7.2;        // units, the width of two numbers side by side
constexpr double height_of_row = 1.25;      // units
constexpr double least_with_numbers = 6.5;  // units, the height of a stage

bool has_rows_of_numbers(const Rect& stage, double unit) {
    return stage.width < least_of_row * unit;
}

// In a low stage the disks take their place.
bool has_numbers(const Rect& stage, double unit) {
    return stage.height >= least_with_numbers * unit;
}

double height_of_numbers(const Rect& stage, double unit) {
    if (!has_numbers(stage, unit)) return 0.2;
    return words_below + (has_rows_of_numbers(stage, unit) ? height_of_row : 0.0);
}
constexpr double lift_of_arrows = 0.75;  // units, from one row of arrows to the next

using Vector = Eigen::Array2d;

// What stands in one stage, in lengths of the scene, from the centre of mass.
struct Pose {
    std::array<Vector, 2> center;
    std::array<Vector, 2> arrow;  // velocities, or their changes
};

// The collision with beads of a size, where they are points.
struct Cause {
    std::array<Vector, 2> place, before, after;
    std::array<double, 2> radius, weight;  // weight: share of the mass
    Vector drift;                          // of the centre of mass
    double back, on;                       // time before and after the contact
};

// How long until the centres are as far apart as is shown, in a flight of at most so long.
double time_apart(const Vector& between, const Vector& moving, double longest) {
    const double a = moving.square().sum(), b = std::abs((between * moving).sum());
    const double c = between.square().sum() * (1.0 - apart * apart);
    return std::clamp((-b + std::sqrt(b * b - a * c)) / a, 0.0, longest);
}

Cause cause_of(const PairCollision& met, const Particles& particles) {
    Cause cause{.place = met.place,
                .before = met.before,
                .after = met.after,
                .radius = {particles.radius[met.particle[0]], particles.radius[met.particle[1]]},
                .weight = {},
                .drift = {},
                .back = 0.0,
                .on = 0.0};
    const Vector moving = met.before[1] - met.before[0];
    double longest_back = met.time - met.since, longest_on = met.until - met.time;
    if (cause.radius[0] + cause.radius[1] == 0.0) {  // points: as if they had a size
        cause.radius = {0.5, 0.5};
        cause.place[1] = cause.place[0] - moving / std::sqrt(moving.square().sum());
        longest_back = longest_on = std::numeric_limits<double>::infinity();
    }
    const double first = particles.inverse_mass[met.particle[0]],
                 second = particles.inverse_mass[met.particle[1]];
    cause.weight = {second / (first + second), first / (first + second)};
    cause.drift = cause.weight[0] * met.before[0] + cause.weight[1] * met.before[1];
    const Vector between = cause.place[1] - cause.place[0];
    cause.back = time_apart(between, moving, longest_back);
    cause.on = time_apart(between, met.after[1] - met.after[0], longest_on);
    return cause;
}

std::array<Pose, 3> poses(const Cause& cause) {
    std::array<Pose, 3> all;
    const Vector middle = cause.weight[0] * cause.place[0] + cause.weight[1] * cause.place[1];
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector at_contact = cause.place[k] - middle;
        all[0].center[k] = at_contact - cause.back * (cause.before[k] - cause.drift);
        all[1].center[k] = at_contact;
        all[2].center[k] = at_contact + cause.on * (cause.after[k] - cause.drift);
        all[0].arrow[k] = cause.before[k];
        all[1].arrow[k] = cause.after[k] - cause.before[k];
        all[2].arrow[k] = cause.after[k];
    }
    return all;
}

double length(const Vector& v) { return std::sqrt(v.square().sum()); }

// Half of what the stages need each way, in lengths of the scene.
Vector half_extent(const std::array<Pose, 3>& all, const Cause& cause, double time) {
    Vector half = (time * cause.drift).abs();
    for (const Pose& pose : all)
        for (std::size_t k = 0; k < 2; ++k) {
            half = half.max(pose.center[k].abs() + cause.radius[k]);
            half = half.max((pose.center[k] + time * pose.arrow[k]).abs());
        }
    return half;
}

// One above another, or side by side.
std::array<Rect, 3> places(const Rect& area, double unit, bool high) {
    const double gap = unit;
    std::array<Rect, 3> rects;
    for (std::size_t i = 0; i < 3; ++i) {
        const double n = static_cast<double>(i);
        const double width = high ? area.width : (area.width - 2.0 * gap) / 3.0;
        const double height = high ? (area.height - 2.0 * gap) / 3.0 : area.height;
        rects[i] = {area.x + (high ? 0.0 : n * (width + gap)),
                    area.y + (high ? n * (height + gap) : 0.0), width, height};
    }
    return rects;
}

}  // namespace

CollisionStages collision_stages(const PairCollision& pair, const Particles& particles,
                                 const Rect& area, double unit, int dimension) {
    const Cause cause = cause_of(pair, particles);
    const std::array<Pose, 3> all = poses(cause);
    double fastest = length(cause.drift);
    for (const Pose& pose : all)
        for (const Vector& arrow : pose.arrow) fastest = std::max(fastest, length(arrow));
    const double sigma = cause.radius[0] + cause.radius[1];
    const double time = longest_arrow * sigma / fastest;
    const Vector half = half_extent(all, cause, time);
    const double margin = 0.15 * unit;
    const auto height_for_disks = [&](const Rect& rect) {
        return rect.height - (words_above + height_of_numbers(rect, unit)) * unit;
    };
    const auto scale_in = [&](const std::array<Rect, 3>& rects) {
        const double high = height_for_disks(rects[0]);
        double most = (0.5 * rects[0].width - margin) / half[0];
        if (dimension == 2) most = std::min(most, (0.5 * high - margin) / half[1]);
        return std::min(most,
                        std::max(unit, 0.3 * high) / std::max(cause.radius[0], cause.radius[1]));
    };
    const auto beside = places(area, unit, false), above = places(area, unit, true);
    const std::array<Rect, 3> rects = scale_in(above) > scale_in(beside) ? above : beside;
    const double high = height_for_disks(rects[0]), scale = scale_in(rects);

    CollisionStages stages;
    stages.radius = {scale * cause.radius[0], scale * cause.radius[1]};
    stages.reach = scale * time;
    const double largest = std::max(stages.radius[0], stages.radius[1]);
    for (std::size_t i = 0; i < 3; ++i) {
        CollisionStage& stage = stages.stage[i];
        stage.area = rects[i];
        stage.mass_center = {rects[i].x + rects[i].width / 2,
                             rects[i].y + words_above * unit + high / 2};
        const auto pixels = [&](const Vector& v) {
            return Point{stage.mass_center.x + scale * v[0], stage.mass_center.y - scale * v[1]};
        };
        const auto arrow = [&](const Vector& from, const Vector& along, int row) {
            const double lift = row == 0 || dimension == 2
                                    ? 0.0
                                    : (row > 0 ? 1 : -1) * largest + row * lift_of_arrows * unit;
            const Point start = pixels(from), end = pixels(from + time * along);
            return StageArrow{{start.x, start.y - lift}, {end.x, end.y - lift}};
        };
        for (std::size_t k = 0; k < 2; ++k) {
            stage.center[k] = pixels(all[i].center[k]);
            stage.velocity[k] = arrow(all[i].center[k], all[i].arrow[k], k == 0 ? 1 : 2);
        }
        stage.mass_center_velocity = arrow(Vector::Zero(), cause.drift, -1);
    }
    return stages;
}

namespace {

struct StageState : PanelState {
    std::size_t present = 0;  // stage; 3: none
};

class SingleCollisionPanel : public Panel {
  public:
    SingleCollisionPanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context), spec_(spec), watch_(context, spec) {}

    void survey(const FrameInput& input) override { watch_.survey(input); }
    bool surveys_collisions() const override { return true; }
    void fix_axes() override { met_ = watch_.collision(); }
    void archive(Archive& archive) override { archive(met_); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

  private:
    CollisionStages stages(const DrawContext& dc) const;
    Rect room(const DrawContext& dc) const;
    ArrowStyle style(const DrawContext& dc, Color color) const;
    ArrowStyle change_style(const DrawContext& dc) const;
    void draw_stage(Canvas& canvas, const DrawContext& dc, std::size_t index) const;
    void draw_words(Canvas& canvas, const DrawContext& dc, std::size_t index) const;
    void draw_key(Canvas& canvas, const DrawContext& dc) const;
    std::array<plot::Text, 2> amounts(std::size_t index) const;
    using Panel::draw_key;

    PanelContext context_;
    PanelSpec spec_;
    PairCollisionWatch watch_;
    PairCollision met_;
};

constexpr double title_height = 1.9, row_height = 1.4;  // units
constexpr double least_with_law = 14.0;    // units: in lower areas the pictures take its place
constexpr double least_of_one_row = 19.0;  // units, of a key
constexpr double tint = 0.3;               // of the disks, so that arrows stand out from them

bool has_law(const DrawContext& dc) { return dc.area.height >= least_with_law * dc.unit; }

double key_height(const DrawContext& dc) {
    const double rows = dc.area.width < least_of_one_row * dc.unit && has_law(dc) ? 2.0 : 1.0;
    return (rows + (has_law(dc) ? 1.0 : 0.0)) * row_height;
}
constexpr std::array names{Phrase{"before"}, Phrase{"contact"}, Phrase{"after"}};

// The middle third of what the stages show belongs to the contact.
std::shared_ptr<const PanelState> SingleCollisionPanel::state(const FrameInput& input) {
    auto state = std::make_shared<StageState>();
    state->present = 3;
    if (!context_.in_film) return state;
    const Cause cause = cause_of(met_, context_.particles);
    const double since = input.tick.time - met_.time;
    state->present = since < -cause.back / 3.0 ? 0 : since < cause.on / 3.0 ? 1 : 2;
    return state;
}

Rect SingleCollisionPanel::room(const DrawContext& dc) const {
    const double top = title_height * dc.unit, bottom = key_height(dc) * dc.unit;
    return {dc.area.x, dc.area.y + top, dc.area.width,
            std::max(dc.unit, dc.area.height - top - bottom)};
}

CollisionStages SingleCollisionPanel::stages(const DrawContext& dc) const {
    return collision_stages(met_, context_.particles, room(dc), dc.unit,
                            context_.scene.gas.box.dimension);
}

ArrowStyle SingleCollisionPanel::style(const DrawContext& dc, Color color) const {
    return plot::arrow_style(dc, color, dc.theme.page, 0.07);
}

// A colour that neither particle has; open arrows where there is no such colour.
ArrowStyle SingleCollisionPanel::change_style(const DrawContext& dc) const {
    const Color accent = edge_of(dc.theme.accent, dc.theme);
    const Color first = color_of(context_, met_, 0, dc.theme),
                second = color_of(context_, met_, 1, dc.theme);
    constexpr double least_difference = 0.12;
    if (to_pixel(accent) != to_pixel(dc.theme.ink)) {
        const std::array both{first, second};
        const bool is_apart =
            std::min(difference(accent, first), difference(accent, second)) > least_difference;
        return style(
            dc, is_apart ? accent : edge_of(kind_colors_beside(both, dc.theme).front(), dc.theme));
    }
    ArrowStyle open = style(dc, dc.theme.page);
    open.edge = std::max(1.0, 0.1 * dc.unit);
    open.edge_color = dc.theme.ink;
    return open;
}

void SingleCollisionPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const Language language = context_.language();
    const std::string of = plot::markup_of(names_of(context_, met_), dc.theme);
    const std::string at = three_digits(language, met_.time);
    const std::string title =
        spec_.title ? escape_markup(*spec_.title)
                    : fitting_title(dc, {say(language, "Collision of {} at time {}", of, at),
                                         say(language, "Collision of {}", of), capitalised(of)});
    draw_panel_title(canvas, dc, title);
    for (std::size_t i = 0; i < 3; ++i) draw_stage(canvas, dc, i);
    draw_key(canvas, dc);
}

void SingleCollisionPanel::draw_stage(Canvas& canvas, const DrawContext& dc,
                                      std::size_t index) const {
    const CollisionStages all = stages(dc);
    const CollisionStage& stage = all.stage[index];
    const double u = dc.unit;
    if (index == 1) {  // the line of centres, as far as the changes reach and a little more
        const Point& a = stage.center[0];
        const Point& b = stage.center[1];
        const double apart_by = std::hypot(b.x - a.x, b.y - a.y);
        double beyond = std::max(all.radius[0], all.radius[1]) + u;
        for (const StageArrow& arrow : stage.velocity)
            beyond = std::max(
                beyond, std::hypot(arrow.to.x - arrow.from.x, arrow.to.y - arrow.from.y) + 0.6 * u);
        const Point along{(b.x - a.x) / apart_by, (b.y - a.y) / apart_by};
        canvas.clip_to(stage.area);
        canvas.stroke_line({a.x - beyond * along.x, a.y - beyond * along.y},
                           {b.x + beyond * along.x, b.y + beyond * along.y}, 0.09 * u,
                           dc.theme.muted, 0.3 * u);
        canvas.release_clip();
    }
    if (context_.scene.gas.box.dimension == 1 && index != 1)  // the wire
        canvas.stroke_line({stage.area.x, stage.mass_center.y},
                           {stage.area.right(), stage.mass_center.y}, 0.08 * u, dc.theme.muted);
    for (std::size_t k = 0; k < 2; ++k) {
        const Color color = color_of(context_, met_, k, dc.theme);
        const double line = std::max(1.5, 0.14 * u);
        canvas.fill_circle(stage.center[k], all.radius[k], edge_of(color, dc.theme));
        canvas.fill_circle(stage.center[k], std::max(0.0, all.radius[k] - line),
                           mix(dc.theme.page, color, tint));
    }
    if (index == 1)
        canvas.stroke_line(stage.center[0], stage.center[1], 0.09 * u, dc.theme.muted, 0.3 * u);
    const Color grey = dc.theme.muted;
    draw_arrow(canvas, stage.mass_center_velocity.from, stage.mass_center_velocity.to,
               style(dc, grey));
    canvas.fill_circle(stage.mass_center, 0.3 * u, dc.theme.page);
    canvas.fill_circle(stage.mass_center, 0.22 * u, grey);
    for (const StageArrow& arrow : stage.velocity)
        draw_arrow(canvas, arrow.from, arrow.to,
                   index == 1 ? change_style(dc) : style(dc, dc.theme.ink));
    draw_words(canvas, dc, index);
}

std::array<plot::Text, 2> SingleCollisionPanel::amounts(std::size_t index) const {
    std::array<plot::Text, 2> texts;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector v = index == 0 ? met_.before[k] : index == 1 ? change(met_, k) : met_.after[k];
        texts[k] =
            plot::named(three_digits(context_.language(), length(v)), role_of(context_, met_, k));
    }
    return texts;
}

// The numbers under a stage: in one row, or one below the other.
void SingleCollisionPanel::draw_words(Canvas& canvas, const DrawContext& dc,
                                      std::size_t index) const {
    const CollisionStage stage = stages(dc).stage[index];
    TextStyle style = label_style(dc);
    style.align = Align::center;
    const double middle = stage.area.x + stage.area.width / 2;
    if (!has_numbers(stage.area, dc.unit)) return;
    const double y = stage.area.bottom() - 0.3 * dc.unit;
    const auto [first, second] = amounts(index);
    if (has_rows_of_numbers(stage.area, dc.unit)) {
        draw_text(canvas, {middle, y - height_of_row * dc.unit}, plot::markup_of(first, dc.theme),
                  style);
        draw_text(canvas, {middle, y}, plot::markup_of(second, dc.theme), style);
        return;
    }
    const Language language = context_.language();
    const std::array<std::string, 3> all =
        index == 1
            ? std::array<std::string, 3>{say(language, "changes") + " ", "|Δ<i>v</i>| ", "Δ "}
            : std::array<std::string, 3>{say(language, "speeds") + " ", "|<i>v</i>| ", ""};
    const char* between = language == Language::english ? ", " : "; ";
    for (const std::string& words : all) {
        const std::string text =
            plot::markup_of(plot::Text(words) + first + between + second, dc.theme);
        const bool is_last = &words == &all.back();
        if (!is_last && measure_text(text, style).width > stage.area.width) continue;
        draw_text(canvas, {middle, y}, text, style);
        return;
    }
}

// What the arrows are, and the law.
void SingleCollisionPanel::draw_key(Canvas& canvas, const DrawContext& dc) const {
    const double u = dc.unit;
    double x = dc.area.x;
    double baseline = dc.area.bottom() - (key_height(dc) - 1.15) * u;
    const Language language = context_.language();
    std::array<std::pair<ArrowStyle, std::string>, 3> key{
        {{style(dc, dc.theme.ink), say(language, "velocity")},
         {change_style(dc), say(language, "its change")},
         {style(dc, dc.theme.muted), say(language, "centre of mass")}}};
    double row = 0.0;
    for (const auto& [drawn, words] : key)
        row += 2.8 * u + measure_text(words, label_style(dc)).width;
    if (row > dc.area.width && !has_law(dc)) {  // nor room for another row
        key[0].second = "<i>v</i>";
        key[1].second = "Δ<i>v</i>";
    }
    for (const auto& [drawn, words] : key) {
        if (x + 1.9 * u + measure_text(words, label_style(dc)).width > dc.area.right()) {
            if (!has_law(dc)) break;  // nor room for another row
            x = dc.area.x;
            baseline += row_height * u;
        }
        draw_arrow(canvas, {x, baseline - 0.35 * u}, {x + 1.6 * u, baseline - 0.35 * u}, drawn);
        x += 1.9 * u;
        x += draw_text(canvas, {x, baseline}, words, label_style(dc)).width + 0.9 * u;
    }
    if (!has_law(dc)) return;
    const Eigen::Array2d inverse{context_.particles.inverse_mass[met_.particle[0]],
                                 context_.particles.inverse_mass[met_.particle[1]]};
    const std::size_t movable = inverse[0] > 0.0 ? 0 : 1;
    const double momentum =
        length(change(met_, movable)) / inverse[static_cast<Eigen::Index>(movable)];
    const std::string given = three_digits(language, momentum);
    const std::array<std::string, 3> laws{
        say(language, "momentum {} is transferred along the line of centres", given),
        say(language, "momentum {} along the line of centres", given),
        say(language, "momentum transfer {}", given)};
    TextStyle style = label_style(dc);
    for (const std::string& law : laws) {
        const bool is_last = &law == &laws.back();
        if (!is_last && measure_text(law, style).width > dc.area.width) continue;
        style.max_width = dc.area.width;
        draw_text(canvas, {dc.area.x, dc.area.bottom() - 0.15 * u}, law, style);
        return;
    }
}

// The name of the present stage stands out.
void SingleCollisionPanel::draw(Canvas& canvas, const DrawContext& dc,
                                const PanelState& state) const {
    const std::size_t present = static_cast<const StageState&>(state).present;
    const CollisionStages all = stages(dc);
    for (std::size_t i = 0; i < 3; ++i) {
        TextStyle style = label_style(dc);
        style.align = Align::center;
        if (i == present) style.color = dc.theme.ink, style.weight = 600;
        const Rect& area = all.stage[i].area;
        const Point at{area.x + area.width / 2, area.y + 1.0 * dc.unit};
        const double width = draw_text(canvas, at, say(context_.language(), names[i]), style).width;
        if (i == present)
            canvas.stroke_line({at.x - width / 2, at.y + 0.35 * dc.unit},
                               {at.x + width / 2, at.y + 0.35 * dc.unit}, 0.12 * dc.unit,
                               dc.theme.ink);
    }
}

// Places from the centre of mass; arrows are velocities, at contact their changes.
Table SingleCollisionPanel::table(const PanelState&, const Theme&) const {
    Table table{{"part", "stage", "of", column_name("x", reduced::length),
                 column_name("y", reduced::length), column_name("radius", reduced::length), "arrow",
                 column_name("arrow x", reduced::speed), column_name("arrow y", reduced::speed)}};
    const Cause cause = cause_of(met_, context_.particles);
    const std::array<Pose, 3> all = poses(cause);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 2; ++k)
            table.rows.push_back({"particle", std::string(names[i].english),
                                  std::int64_t{met_.particle[k]}, all[i].center[k][0],
                                  all[i].center[k][1], cause.radius[k],
                                  i == 1 ? "change of velocity" : "velocity", all[i].arrow[k][0],
                                  all[i].arrow[k][1]});
        table.rows.push_back({"centre of mass",
                              std::string(names[i].english),
                              {},
                              0.0,
                              0.0,
                              {},
                              "velocity",
                              cause.drift[0],
                              cause.drift[1]});
    }
    return table;
}

}  // namespace

std::unique_ptr<Panel> make_single_collision(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<SingleCollisionPanel>(context, spec);
}

}  // namespace carom
