#include "panels/field/field_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "draw/arrow.h"
#include "panels/field/smooth_cells.h"
#include "panels/means/thinning.h"
#include "physics/theory/laws/symmetry.h"
#include "scene/scene.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double share_above = 0.02;  // of the cells of all frames, beyond the scale
constexpr double least_contrast_of_outlines = 2.2;
constexpr double part_of_cell = 0.35;  // units: of what a colour is filled into
constexpr double part_of_slab = 0.1;   // the same where all parts lie in one row
constexpr int most_cells_along = 16;   // of a cell along an axis, unless all lie in one row
constexpr double key_height = 3.6;     // units, of the arrow that is the key of a flow

// "mean over height and the last 10".
std::string words_of_mean(const Scene& scene) {
    const Language language = scene.film.language;
    const std::array<bool, 3> even = even_axes(scene.gas, scene.run.events);
    const std::string time = plain_number(language, scene.film.field->over);
    if (even[0] && even[1]) return say(language, "mean over the box and the last {}", time);
    if (scene.gas.box.dimension == 3) {
        if (even[0]) return say(language, "mean over width, depth and the last {}", time);
        if (even[1]) return say(language, "mean over height, depth and the last {}", time);
        return say(language, "mean over depth and the last {}", time);
    }
    if (even[0]) return say(language, "mean over width and the last {}", time);
    if (even[1]) return say(language, "mean over height and the last {}", time);
    return say(language, "mean over the last {}", time);
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

namespace {

// As they are seen: in space from the back of the box to its front.
Cells squares_of_picture(const Box& box, int along_longer) {
    Box seen = box;
    seen.dimension = std::min(box.dimension, 2);
    Cells cells = square_cells(seen, along_longer);
    if (box.dimension == 3) cells.size[2] = cells.box[2] = box.size[2];
    return cells;
}

}  // namespace

Cells cells_of_field(const Scene& scene) {
    Cells cells = squares_of_picture(scene.gas.box, scene.film.field->cells);
    const std::array<bool, 3> even = even_axes(scene.gas, scene.run.events);
    for (const Eigen::Index axis : {0, 1}) {
        if (!even.at(static_cast<std::size_t>(axis))) continue;
        cells.count[axis] = 1;
        cells.size[axis] = cells.box[axis];
    }
    return cells;
}

Quantity quantity_of_field(const Scene& scene, FieldOf of) {
    switch (of) {
        case FieldOf::density:
            return quantities::density(scene.gas.box.dimension);
        case FieldOf::temperature:
            return quantities::temperature;
        case FieldOf::speed:
            return quantities::speed.named(Phrase{"mean speed"});
        case FieldOf::flow:
            return quantities::velocity.named(Phrase{"flow"});
        case FieldOf::concentration:
            return quantities::share;
    }
    return {};
}

std::string name_of_quantity(Language language, const Scene& scene, FieldOf of,
                             std::optional<std::size_t> species) {
    if (of == FieldOf::concentration)
        return say(language, "share of {}", scene.gas.species[species.value_or(0)].name);
    return say(language, quantity_of_field(scene, of).word);
}

CellQuantity::CellQuantity(const PanelContext& context, const Cells& cells, FieldOf of,
                           std::optional<std::size_t> species, std::optional<double> window,
                           const Chosen& chosen)
    : of_(of),
      area_(cells.content()),
      members_(context, {chosen, Chosen{.species = species}}),
      all_(context.box(), context.particles, cells,
           {members_.flags(0), window, of == FieldOf::temperature},
           velocity_changes(context.run())) {
    if (of == FieldOf::concentration)
        part_.emplace(context.box(), context.particles, cells,
                      CellAverages::Wanted{members_.flags(1), window},
                      velocity_changes(context.run()));
}

void CellQuantity::choose() {
    all_.choose(members_.flags(0));
    if (part_) part_->choose(members_.flags(1));
}

void CellQuantity::see(const FrameInput& input) {
    const auto see = [&](std::span<const Collision> collisions) {
        all_.see(input.sample, collisions);
        if (part_) part_->see(input.sample, collisions);
    };
    see(input.advanced.collisions);
    if (!members_.see(input.sample)) return;
    choose();
    see({});  // the present moment
}

CellQuantity::Ratio CellQuantity::ratio(const CellSums& all, const CellSums* part,
                                        Eigen::Index axis) const {
    const auto axes = static_cast<double>(all.velocity.cols());
    switch (of_) {
        case FieldOf::density:
            return {all.particles, Eigen::ArrayXd::Constant(all.particles.size(), all.time)};
        case FieldOf::temperature:
            return {all.thermal_energy, all.thermal_freedom * axes};
        case FieldOf::speed:
            return {all.speed, all.particles};
        case FieldOf::flow:
            return {all.velocity.col(axis), all.particles};
        case FieldOf::concentration:
            return {part->particles, all.particles};
    }
    return {};
}

Eigen::ArrayXd CellQuantity::values(Eigen::Index axis, double least_particles) const {
    const CellSums sums = all_.sums();
    const std::optional<CellSums> part = part_ ? std::optional(part_->sums()) : std::nullopt;
    const Ratio of = ratio(sums, part ? &*part : nullptr, axis);
    Eigen::ArrayXd values = of.sum / of.weight;
    if (of_ == FieldOf::density) values /= area_;
    constexpr double rounding = 1e-9;
    return (sums.mean_particles() >= least_particles - rounding)
        .select(values, std::numeric_limits<double>::quiet_NaN());
}

std::optional<Eigen::ArrayXd> CellQuantity::errors(Eigen::Index axis) const {
    const std::vector<CellSums> all = all_.pieces();
    const std::vector<CellSums> parts = part_ ? part_->pieces() : std::vector<CellSums>{};
    if (all.empty()) return {};
    const auto count = static_cast<Eigen::Index>(all.size());
    const Eigen::Index cells = all.front().particles.size();
    PieceSums pieces{Eigen::ArrayXXd(count, cells), Eigen::ArrayXXd(count, cells)};
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Ratio of = ratio(all[k], part_ ? &parts[k] : nullptr, axis);
        pieces.sum.row(static_cast<Eigen::Index>(k)) = of.sum.transpose();
        pieces.weight.row(static_cast<Eigen::Index>(k)) = of.weight.transpose();
    }
    std::optional<Eigen::ArrayXd> errors = standard_errors(pieces);
    if (errors && of_ == FieldOf::density) *errors /= area_;
    return errors;
}

FieldLayer::FieldLayer(const PanelContext& context)
    : context_(context), field_(context.film().field) {
    if (!field_) return;
    cells_ = cells_of_field(context.scene);
    squares_ = squares_of_picture(context.box(), field_->cells);
    scale_.mean = words_of_mean(context.scene);
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
    if (is_flow() && context_.box().dimension > 1)
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
    if (is_flow() && context_.box().dimension > 1)
        for (const double value : shown_->values(1)) state->up.push_back(static_cast<float>(value));
    return state;
}

// The colour map of the field, which differs from that of the disks: magma, or viridis if the disks
// have magma or a similar map. Its range begins where it differs from blank cells, and ends where
// the outlines of disks still stand out. For temperatures on a light ground it is reversed, so that
// hot is yellow beside red walls, and cold is violet.
ColorMap FieldLayer::colors(const Theme& theme) const {
    if (theme.kind == ThemeKind::print) return ColorMap({rgb(0xE4E4E4), rgb(0x8A8A8A)});
    const std::string disks = context_.film().palette.value_or("viridis");
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

// The longest arrow of the scale has the width of a square cell.
double FieldLayer::reach(double scale) const { return squares_.size[0] * scale / scale_.top; }

Eigen::Index FieldLayer::measured_in(Eigen::Index square) const {
    const Eigen::Index x = square % squares_.count[0], y = square / squares_.count[0];
    return (cells_.count[0] == 1 ? 0 : x) + (cells_.count[1] == 1 ? 0 : y) * cells_.count[0];
}

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
                      const Place& place, const OnWall& on_wall) const {
    if (!is_flow()) return draw_colors(canvas, dc, state, place, on_wall);
    for (Eigen::Index square = 0; square < squares_.all(); ++square) {
        const auto cell = static_cast<std::size_t>(measured_in(square));
        const double value = static_cast<double>(state.values[cell]);
        if (std::isnan(value)) continue;
        const Rect exact = place(squares_.region(square));
        const double up = state.up.empty() ? 0.0 : static_cast<double>(state.up[cell]);
        Point middle{exact.x + exact.width / 2, exact.y + exact.height / 2}, flow{value, up};
        const double reach = exact.width / scale_.top;
        if (on_wall) {
            const Vec center = squares_.region(square).low + 0.5 * squares_.size;
            middle = on_wall(center);
            const Point end = on_wall(center + squares_.size[0] / scale_.top * Vec{value, up});
            flow = {(end.x - middle.x) / reach, (middle.y - end.y) / reach};
        }
        draw_flow(canvas, dc, middle, flow, reach);
    }
}

// Cells are divided into parts that can hardly be told apart. Parts of one colour beside each other
// are filled together.
void FieldLayer::draw_colors(Canvas& canvas, const DrawContext& dc, const FieldState& state,
                             const Place& place, const OnWall& on_wall) const {
    const ColorMap map = colors(dc.theme);
    const Box& box = context_.box();
    const Rect first = place(cells_.region(0));
    const bool has_rows = cells_.count[0] > 1 && cells_.count[1] > 1;
    const auto parts_of = [&](Eigen::Index axis) {
        if (cells_.count[axis] == 1) return 1;
        const double size = (axis == 0 ? first.width : first.height) / dc.unit;
        if (!has_rows) return static_cast<int>(std::ceil(size / part_of_slab));
        return std::clamp(static_cast<int>(std::round(size / part_of_cell)), 1, most_cells_along);
    };
    const std::array<int, 2> parts{parts_of(0), parts_of(1)};
    Eigen::ArrayXd values(static_cast<Eigen::Index>(state.values.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i)
        values[i] = static_cast<double>(state.values[static_cast<std::size_t>(i)]);
    values = smooth_cells(values, cells_.count[0], parts,
                          {box.is_periodic(0), box.dimension > 1 && box.is_periodic(1)});
    Cells fine = cells_;
    for (const std::size_t axis : {0, 1}) {
        fine.count[static_cast<Eigen::Index>(axis)] *= parts.at(axis);
        fine.size[static_cast<Eigen::Index>(axis)] /= parts.at(axis);
    }
    const auto color_at = [&](Eigen::Index i) -> std::optional<std::uint32_t> {
        if (std::isnan(values[i])) return std::nullopt;
        return to_pixel(scale_.color(map, std::max(0.0, values[i])));
    };
    // On whole pixels, and each edge once, so that neighbours neither overlap nor leave a gap.
    const Eigen::Index columns = fine.count[0], rows = fine.count[1];
    std::vector<double> left{}, bottom{};
    for (Eigen::Index x = 0; x < columns; ++x) left.push_back(std::round(place(fine.region(x)).x));
    left.push_back(std::round(place(fine.region(columns - 1)).right()));
    for (Eigen::Index y = 0; y < rows; ++y)
        bottom.push_back(std::round(place(fine.region(y * columns)).bottom()));
    bottom.push_back(std::round(place(fine.region((rows - 1) * columns)).y));
    for (Eigen::Index begin = 0, next = 0; begin < values.size(); begin = next) {
        const std::optional<std::uint32_t> color = color_at(begin);
        next = begin + 1;
        while (next % columns != 0 && color_at(next) == color) ++next;
        if (!color) continue;
        const Color its = rgb(*color & 0xFFFFFF);
        if (on_wall) {
            // Each reaches a little under the next ones, so that no gap shows between them.
            const Vec low = fine.region(begin).low;
            const Vec high = lower(fine.region(next - 1).high + 0.1 * fine.size, box.size);
            canvas.fill_polygon(std::array{on_wall({low[0], low[1]}), on_wall({high[0], low[1]}),
                                           on_wall({high[0], high[1]}), on_wall({low[0], high[1]})},
                                mix(dc.theme.page, its, field_->opacity));
            continue;
        }
        const auto row = static_cast<std::size_t>(begin / columns);
        const double x = left[static_cast<std::size_t>(begin % columns)], y = bottom[row + 1];
        canvas.fill(
            {x, y, left[static_cast<std::size_t>((next - 1) % columns) + 1] - x, bottom[row] - y},
            with_alpha(its, field_->opacity));
    }
}

void FieldLayer::draw_key(Canvas& canvas, const DrawContext& dc, double scale) const {
    const double u = dc.unit;
    Rect area = dc.area;
    TextStyle style = label_style(dc);
    style.max_width = area.width;
    std::vector<std::string> lines = wrapped(scale_.mean, style, 4);
    if (is_clear_somewhere_)
        for (std::string& line : wrapped(say(context_.language(), "blank: fewer than 3"), style, 3))
            lines.push_back(std::move(line));
    const double height = 1.35 * u * static_cast<double>(lines.size());
    double baseline = area.bottom() - height + 1.2 * u;
    for (const std::string& line : lines) {
        draw_text(canvas, {area.x, baseline}, escape_markup(line), style);
        baseline += 1.35 * u;
    }
    area.height -= height + 0.9 * u;
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
    if (is_flow()) row.add_words(scale_.mean);
}

void FieldLayer::add_columns(Table& table) const {
    if (!shown()) return;
    const Quantity quantity = quantity_of_field(context_.scene, field_->of);
    if (!is_flow() || context_.box().dimension == 1)
        table.columns.emplace_back(
            name_of_quantity(Language::english, context_.scene, field_->of, field_->species),
            quantity);
    else
        for (const char* name : {"flow x", "flow y"}) table.columns.emplace_back(name, quantity);
}

void FieldLayer::add_rows(Table& table, const FieldState& state, std::size_t x,
                          std::optional<std::size_t> y) const {
    const std::size_t columns = table.columns.size(), own = state.up.empty() ? 1 : 2;
    for (std::size_t cell = 0; cell < state.values.size(); ++cell) {
        const Region region = cells_.region(static_cast<Eigen::Index>(cell));
        const Vec middle = 0.5 * (region.low + region.high);
        std::vector<TableCell>& row = table.rows.emplace_back();
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
    const Language language = scene.film.language;
    return say(language, "Field: {}, {}, in {}; cells with fewer than 3 particles are blank",
               name_of_quantity(language, scene, field->of, field->species), words_of_mean(scene),
               size_of_cells(language, scene.gas.box, cells_of_field(scene)));
}

}  // namespace carom
