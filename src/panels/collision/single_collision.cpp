// The panel of one collision, in three pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/palette.h"
#include "panels/collision/collision_stages.h"
#include "panels/gas/bead_words.h"
#include "panels/plot/layers.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "util/archive.h"
#include "util/text.h"

namespace carom {
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
    void archive_progress(Archive&) override {}
    Room least_room() const override { return {8.0, 7.0}; }
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    std::string account(const PanelState& state) const override;
    std::optional<std::array<double, 2>> time_shown(double) const override {
        return {{met_.time, met_.time}};
    }

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
constexpr double least_of_one_row = 25.0;  // units, of a key
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
    const CollisionCause cause = cause_of(met_, context_.particles);
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
    return collision_stages(met_, context_.particles, room(dc), dc.unit, context_.box().dimension);
}

ArrowStyle SingleCollisionPanel::style(const DrawContext& dc, Color color) const {
    return plot::arrow_style(dc, color, dc.theme.page, 0.07);
}

// A colour that neither particle has; open arrows where there is no such colour.
ArrowStyle SingleCollisionPanel::change_style(const DrawContext& dc) const {
    const Color usual = edge_of(dc.theme.highlight, dc.theme);
    const Color first = color_of(context_, met_, 0, dc.theme),
                second = color_of(context_, met_, 1, dc.theme);
    constexpr double least_difference = 0.12;
    if (to_pixel(usual) != to_pixel(dc.theme.ink)) {
        const std::array both{first, second};
        const bool is_apart =
            std::min(difference(usual, first), difference(usual, second)) > least_difference;
        return style(
            dc, is_apart ? usual : edge_of(kind_colors_beside(both, dc.theme).front(), dc.theme));
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
    if (context_.box().dimension == 1 && index != 1)  // the wire
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
        const Vec v = index == 0 ? met_.before[k] : index == 1 ? change(met_, k) : met_.after[k];
        texts[k] =
            plot::named(three_digits(context_.language(), length(v)), role_of(context_, met_, k));
    }
    return texts;
}

std::string SingleCollisionPanel::account(const PanelState&) const {
    const Language language = context_.language();
    const auto speeds = [&](const std::array<Vec, 2>& velocities) {
        return listed(language, std::array{three_digits(language, length(velocities[0])),
                                           three_digits(language, length(velocities[1]))});
    };
    return say(language, "{} collide at time {}: speeds {} before and {} after.",
               plain_names_of(context_, met_), three_digits(language, met_.time),
               speeds(met_.before), speeds(met_.after));
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
    const std::string between(between_numbers(language));
    for (const std::string& words : all) {
        const std::string text =
            plot::markup_of(plot::Text(words) + first + between + second, dc.theme);
        if (measure_text(text, style).width <= stage.area.width)
            return void(draw_text(canvas, {middle, y}, text, style));
        if (&words == &all.back()) leave_out(text);
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
    const Vec inverse{context_.particles.inverse_mass[met_.particle[0]],
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
    Table table{{"part",
                 "stage",
                 "of",
                 {"x", quantities::length},
                 {"y", quantities::length},
                 {"radius", quantities::length},
                 "arrow",
                 {"arrow x", quantities::velocity},
                 {"arrow y", quantities::velocity}}};
    const CollisionCause cause = cause_of(met_, context_.particles);
    const std::array<CollisionPose, 3> all = poses(cause);
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

std::unique_ptr<Panel> make_single_collision(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<SingleCollisionPanel>(context, spec);
}

}  // namespace

PanelKind single_collision_kind() {
    using enum Ability;
    return {.name = "single-collision",
            .words = Phrase{"single collision"},
            .shows = "One collision in a plane: the velocities before, at and after contact.",
            .make = make_single_collision,
            .abilities = {of, pair},
            .has_own_time = always(true),
            .has_plot = false,
            .in_space_instead = "give `size` two lengths: it shows a collision in a plane"};
}

}  // namespace carom
