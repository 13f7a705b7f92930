#include "panels/field/field_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/arrow.h"
#include "panels/thinning.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double share_above = 0.02;  // of the cells of all frames, beyond the scale
constexpr double least_contrast_of_outlines = 2.2;
constexpr double key_height = 3.6;  // units, of the arrow that is the key of a flow

std::vector<bool> members_of(const PanelContext& context, std::optional<std::size_t> species) {
    std::vector<bool> members;
    for (const int its : context.particles.species)
        members.push_back(!species || std::cmp_equal(its, *species));
    return members;
}

Cells cells_of(const PanelContext& context) {
    const Scene& scene = context.scene;
    return scene.film.field ? square_cells(scene.gas.box, scene.film.field->cells) : Cells{};
}

std::string size_of_cells(Language language, const Box& box, const Cells& cells) {
    const std::string width = plain_number(language, cells.size[0]);
    if (box.dimension == 1) return say(language, "cells of length {}", width);
    return say(language, "cells of {} by {}", width, plain_number(language, cells.size[1]));
}

// Where there is little room.
std::string short_name(const Scene& scene, const Field& field) {
    if (field.of == FieldOf::temperature) return "T";
    const Language language = scene.film.language;
    if (field.of == FieldOf::speed) return say(language, "speed");
    return field.species ? scene.gas.species[*field.species].name
                         : name_of_quantity(language, scene, field.of, {});
}

}  // namespace

std::string name_of_quantity(Language language, const Scene& scene, FieldOf of,
                             std::optional<std::size_t> species) {
    switch (of) {
        case FieldOf::density:
            return say(language, "density");
        case FieldOf::temperature:
            return say(language, "temperature");
        case FieldOf::speed:
            return say(language, "mean speed");
        case FieldOf::flow:
            return say(language, "flow");
        case FieldOf::concentration:
            return say(language, "share of {}", scene.gas.species[species.value_or(0)].name);
    }
    return "";
}

std::string unit_of_quantity(const Scene& scene, FieldOf of) {
    switch (of) {
        case FieldOf::density:
            return scene.gas.box.dimension == 1 ? "1/length" : "1/length^2";
        case FieldOf::temperature:
            return reduced::energy;
        case FieldOf::concentration:
            return "1";
        default:
            return reduced::speed;
    }
}

CellQuantity::CellQuantity(const PanelContext& context, const Cells& cells, FieldOf of,
                           std::optional<std::size_t> species, std::optional<double> window,
                           const std::vector<bool>& members)
    : of_(of),
      area_(cells.area()),
      all_(context.scene.gas.box, context.particles, cells,
           {members, window, of == FieldOf::temperature}, velocity_changes(context.scene.run)) {
    if (of == FieldOf::concentration)
        part_.emplace(context.scene.gas.box, context.particles, cells,
                      CellAverages::Wanted{members_of(context, species), window},
                      velocity_changes(context.scene.run));
}

void CellQuantity::see(const FrameInput& input) {
    all_.see(input.sample, input.advanced.collisions);
    if (part_) part_->see(input.sample, input.advanced.collisions);
}

Eigen::ArrayXd CellQuantity::values(Eigen::Index axis, double least_particles) const {
    const CellSums sums = all_.sums();
    Eigen::ArrayXd values;
    switch (of_) {
        case FieldOf::density:
            values = sums.mean_particles() / area_;
            break;
        case FieldOf::temperature:
            values = sums.temperature();
            break;
        case FieldOf::speed:
            values = sums.mean_speed();
            break;
        case FieldOf::flow:
            values = sums.mean_velocity().col(axis);
            break;
        case FieldOf::concentration:
            values = part_->sums().particles / sums.particles;
            break;
    }
    constexpr double rounding = 1e-9;
    return (sums.mean_particles() >= least_particles - rounding)
        .select(values, std::numeric_limits<double>::quiet_NaN());
}

FieldLayer::FieldLayer(const PanelContext& context)
    : context_(context), field_(context.scene.film.field), cells_(cells_of(context)) {
    if (!field_) return;
    scale_.language = context.language();
    scale_.title = name_of_quantity(context.language(), context.scene, field_->of, field_->species);
    scale_.symbol = escape_markup(short_name(context.scene, *field_));
    surveyed_.emplace(context_, cells_, field_->of, field_->species, field_->over);
    shown_ = surveyed_;
}

void FieldLayer::survey(const FrameInput& input) {
    if (!shown()) return;
    surveyed_->see(input);
    Eigen::ArrayXd values = surveyed_->values();
    if (is_flow() && context_.scene.gas.box.dimension == 2)
        values = (values.square() + surveyed_->values(1).square()).sqrt();
    is_clear_somewhere_ = is_clear_somewhere_ || values.isNaN().any();
    for_each_kept(values.size(), static_cast<double>(values.size()), frames_seen_++,
                  context_.frames, [&](Eigen::Index cell) {
                      if (!std::isnan(values[cell])) pool_.push_back(std::abs(values[cell]));
                  });
}

void FieldLayer::add_survey(const FieldLayer& other) {
    pool_.insert(pool_.end(), other.pool_.begin(), other.pool_.end());
    is_clear_somewhere_ = is_clear_somewhere_ || other.is_clear_somewhere_;
}

void FieldLayer::fix_scale() {
    if (!shown()) return;
    if (!pool_.empty() && field_->of != FieldOf::concentration) fix_top(scale_, pool_, share_above);
    pool_ = {};
    surveyed_.reset();
}

std::shared_ptr<const FieldState> FieldLayer::see(const FrameInput& input) {
    if (!shown()) return nullptr;
    shown_->see(input);
    auto state = std::make_shared<FieldState>();
    for (const double value : shown_->values()) state->values.push_back(static_cast<float>(value));
    if (is_flow() && context_.scene.gas.box.dimension == 2)
        for (const double value : shown_->values(1)) state->up.push_back(static_cast<float>(value));
    return state;
}

// The colour map of the field, which differs from that of the disks: magma, or viridis if the disks
// have magma or a similar map. Its range begins where it differs from blank cells, and ends where
// the outlines of disks still stand out. For temperatures on a light ground it is reversed, so that
// hot is yellow beside red walls, and cold is violet.
ColorMap FieldLayer::colors(const Theme& theme) const {
    if (theme.kind == ThemeKind::print) return ColorMap({rgb(0xE4E4E4), rgb(0x8A8A8A)});
    const std::string disks = context_.scene.film.palette.value_or("viridis");
    const bool is_warm = disks == "magma" || disks == "inferno" || disks == "plasma";
    const char* name = is_warm ? "viridis" : "magma";
    const ColorMap whole = color_map(name);
    const double first = theme.dark ? 0.22 : 0.93, step = theme.dark ? -0.01 : 0.01;
    double last = theme.dark ? 1.0 : 0.0;
    while (contrast(theme.ink, mix(theme.ground, whole.at(last), field_->opacity)) <
               least_contrast_of_outlines &&
           std::abs(last - first) > 0.3)
        last += step;
    const bool is_turned = !theme.dark && field_->of == FieldOf::temperature;
    return is_turned ? color_map(name, last, first) : color_map(name, first, last);
}

// The longest arrow of the scale has the width of a cell.
double FieldLayer::reach(double scale) const { return cells_.size[0] * scale / scale_.top; }

void FieldLayer::draw_flow(Canvas& canvas, const DrawContext& dc, Point middle, Point velocity,
                           double reach) const {
    const double length = scale_.top * reach, speed = std::hypot(velocity.x, velocity.y);
    const double most = 1.5 * scale_.top;  // longer arrows would lie over others
    const double half = 0.5 * reach * (speed > most ? most / speed : 1.0);
    const double head = std::min(std::max(0.4 * length, 4.0), 0.85 * dc.unit);
    draw_arrow(canvas, {middle.x - half * velocity.x, middle.y + half * velocity.y},
               {middle.x + half * velocity.x, middle.y - half * velocity.y},
               {.shaft = std::min(std::max(0.22 * head, 1.2), 0.2 * dc.unit),
                .head_length = head,
                .head_width = 0.9 * head,
                .edge = std::max(0.8, 0.1 * head),
                .color = dc.theme.highlight,
                .edge_color = dc.theme.ground});
}

void FieldLayer::draw(Canvas& canvas, const DrawContext& dc, const FieldState& state,
                      const std::function<Rect(const Region&)>& place) const {
    const ColorMap map = colors(dc.theme);
    for (std::size_t cell = 0; cell < state.values.size(); ++cell) {
        const double value = static_cast<double>(state.values[cell]);
        if (std::isnan(value)) continue;
        const Rect exact = place(cells_.region(static_cast<Eigen::Index>(cell)));
        if (is_flow()) {
            const double up = state.up.empty() ? 0.0 : static_cast<double>(state.up[cell]);
            draw_flow(canvas, dc, {exact.x + exact.width / 2, exact.y + exact.height / 2},
                      {value, up}, exact.width / scale_.top);
            continue;
        }
        // Rounded to whole pixels, so that neighbouring cells neither overlap nor leave a gap.
        const double x = std::round(exact.x), y = std::round(exact.y);
        canvas.fill({x, y, std::round(exact.right()) - x, std::round(exact.bottom()) - y},
                    with_alpha(scale_.color(map, value), field_->opacity));
    }
}

void FieldLayer::draw_key(Canvas& canvas, const DrawContext& dc, double scale) const {
    const double u = dc.unit;
    Rect area = dc.area;
    TextStyle style = label_style(dc);
    style.max_width = area.width;
    if (is_clear_somewhere_) {
        const std::vector<std::string> lines =
            wrapped(say(context_.language(), "blank: fewer than 3"), style, 3);
        const double height = 1.35 * u * static_cast<double>(lines.size());
        double y = area.bottom() - height + 1.2 * u;
        for (const std::string& line : lines) {
            draw_text(canvas, {area.x, y}, line, style);
            y += 1.35 * u;
        }
        area.height -= height + 0.9 * u;
    }
    if (!is_flow())
        return draw_color_bar(canvas, {area, u, dc.theme, dc.disks}, colors(dc.theme), scale_,
                              field_->opacity);
    const double length = reach(scale) * scale_.top;
    const double y = area.y + (key_height - 1.2) * u;
    draw_text(canvas, {area.x, area.y + 0.9 * u}, escape_markup(scale_.title), style);
    draw_flow(canvas, dc, {area.x + 0.5 * length, y}, {scale_.top, 0.0}, reach(scale));
    draw_text(canvas, {area.x + length + 0.5 * u, y + 0.36 * u},
              plain_number(context_.language(), scale_.top), style);
}

void FieldLayer::add_key(KeyRow& row, double scale) const {
    const DrawContext dc = row.context();
    if (!is_flow()) {
        row.add_ramp(colors(dc.theme), scale_, field_->opacity);
    } else {
        const double length = reach(scale) * scale_.top, gap = 0.4 * dc.unit;
        row.add_words(scale_.title);
        const std::string number = plain_number(context_.language(), scale_.top);
        row.add(length + gap + measure_text(number, label_style(dc)).width,
                [=, this](Canvas& canvas, Point at) {
                    draw_flow(canvas, dc, {at.x + 0.5 * length, at.y - 0.35 * dc.unit},
                              {scale_.top, 0.0}, reach(scale));
                    draw_text(canvas, {at.x + length + gap, at.y}, number, label_style(dc));
                });
    }
    if (is_clear_somewhere_) row.add_words(say(context_.language(), "blank: fewer than 3"));
}

void FieldLayer::add_columns(Table& table) const {
    if (!shown()) return;
    const std::string unit = unit_of_quantity(context_.scene, field_->of);
    if (!is_flow() || context_.scene.gas.box.dimension == 1)
        return table.columns.push_back(column_name(
            name_of_quantity(Language::english, context_.scene, field_->of, field_->species),
            unit));
    for (const char* name : {"flow x", "flow y"}) table.columns.push_back(column_name(name, unit));
}

void FieldLayer::add_rows(Table& table, const FieldState& state, std::size_t x,
                          std::optional<std::size_t> y) const {
    const std::size_t columns = table.columns.size(), own = state.up.empty() ? 1 : 2;
    for (std::size_t cell = 0; cell < state.values.size(); ++cell) {
        const Region region = cells_.region(static_cast<Eigen::Index>(cell));
        const Eigen::Array2d middle = 0.5 * (region.low + region.high);
        std::vector<Cell>& row = table.rows.emplace_back();
        row.resize(columns);
        row[0] = "cell";
        row[x] = middle[0];
        if (y) row[*y] = middle[1];
        if (std::isnan(state.values[cell])) continue;
        row[columns - own] = state.values[cell];
        if (own == 2) row[columns - 1] = state.up[cell];
    }
}

std::string FieldLayer::account(const FieldState& state) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < state.values.size(); ++k)
        if (!std::isnan(state.values[k]))
            values.push_back(state.up.empty() ? double(state.values[k])
                                              : double(std::hypot(state.values[k], state.up[k])));
    std::string words = words_of_field(context_.scene);
    const Language language = context_.language();
    if (values.empty()) return words + ". " + say(language, "All cells are blank.");
    const auto [low, high] = std::ranges::minmax(values);
    const std::string least = three_digits(language, low), most = three_digits(language, high);
    return words + ". " +
           (is_flow() ? say(language, "The speed of the flow is between {} and {}.", least, most)
                      : say(language, "The values are between {} and {}.", least, most));
}

std::string words_of_field(const Scene& scene) {
    const std::optional<Field>& field = scene.film.field;
    if (!field) return "";
    const Cells cells = square_cells(scene.gas.box, field->cells);
    const Language language = scene.film.language;
    return say(language,
               "Field: {}, in {}, averaged over a time of {}; cells with fewer than 3 particles "
               "are blank",
               name_of_quantity(language, scene, field->of, field->species),
               size_of_cells(language, scene.gas.box, cells), plain_number(language, field->over));
}

}  // namespace carom
