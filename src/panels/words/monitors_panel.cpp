#include "panels/words/monitors_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "panels/plot/layers.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "scene/words.h"
#include "stats/speed_classes.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// The format of a number.
enum class Format { fixed, count, per_cent, power };

struct MonitorColumn {
    Quantity quantity;  // with its label
    double width;       // units, at the smallest size of text
    Format format;
};

// In the order of Monitor.
constexpr std::array all_columns{
    MonitorColumn{quantities::time, 7.08, Format::fixed},
    MonitorColumn{quantities::count.named(Phrase{"collisions"}), 7.788, Format::count},
    MonitorColumn{quantities::speed.named(Phrase{"mean speed"}), 7.788, Format::fixed},
    MonitorColumn{quantities::mean_energy, 8.968, Format::fixed},
    MonitorColumn{quantities::per_cent.named(Phrase{"slow, < ½ mean"}), 9.6, Format::per_cent},
    MonitorColumn{quantities::per_cent.named(Phrase{"medium"}), 5.9, Format::per_cent},
    MonitorColumn{quantities::per_cent.named(Phrase{"fast, > 1½ mean"}), 9.6, Format::per_cent},
    MonitorColumn{quantities::count.named(Phrase{"all collisions"}), 8.968, Format::count},
    MonitorColumn{quantities::length.named(Phrase{"return error"}), 8.968, Format::power},
    MonitorColumn{quantities::per_cent.named(Phrase{"largest overlap"}), 8.968, Format::per_cent}};
static_assert(all_columns.size() == std::tuple_size_v<MonitorNumbers>);

constexpr double widest_column = 8.968;
constexpr double widest_number = 6.4;
constexpr double tightest = 0.85;  // the widths of columns have some air
constexpr double digits_over_label = 1.53;
constexpr double digit_height = 1.1;   // of the size of their label
constexpr double least_gap = 0.8;      // units, between the numbers of columns
constexpr double above_digits = 0.8;   // of the size of their label
constexpr double largest_label = 1.6;  // units
constexpr double title_height = 2.0;   // units
constexpr double arrow_place = 5.29;   // units, to the middle of the arrow that follows the time
constexpr double arrow_gap = 0.9;      // units, from the end of a long time to its middle
constexpr double arrow_size = 0.6;     // units, from its middle to its ends

const MonitorColumn& column(Monitor number) { return all_columns.at(index_of(number)); }

std::string count_words(Language language, std::int64_t count) {
    return count < 1'000'000 ? grouped(count) : three_digits(language, static_cast<double>(count));
}

// Whole per cent, one digit padded by a figure space.
std::string percent(double per_cent) {
    const auto whole = std::to_string(std::lround(per_cent));
    std::string padding;
    for (std::size_t i = whole.size(); i < 2; ++i) padding += "\u2007";
    return padding + whole + "\u2009%";
}

// The time farthest from 0 on a clock that turns back at every reversal.
double farthest_time(const Run& run) {
    std::vector<double> turns = reversal_times(run);
    std::erase_if(turns, [&](double time) { return time > run.until; });
    turns.push_back(run.until);
    const auto of = [&](double time) { return folded_time(run, time); };
    return of(std::ranges::max(turns, {}, [&](double time) { return std::abs(of(time)); }));
}

// The size of text, in units, at which a label above its number fills a height; labels grow less
// than numbers.
double size_in(double height) {
    constexpr double air = 0.95;
    const double size = (height - air) / (1.0 + above_digits + digit_height);
    if (size <= largest_label) return size;
    return (height - air - (1.0 + above_digits) * largest_label) / digit_height;
}

}  // namespace

void draw_time_arrow(Canvas& canvas, Point center, double size, double turn, Color color) {
    std::array<Point, 3> corners;
    const double angle = turn * std::numbers::pi;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double a = angle + 2.0 * std::numbers::pi * static_cast<double>(i) / 3.0;
        corners[i] = {center.x + size * std::cos(a), center.y + size * std::sin(a)};
    }
    canvas.fill_polygon(corners, color);
}

// The places and the size of the numbers: as large as the area allows, in one row or several.
struct MonitorsPanel::Row {
    Rect area;
    std::size_t shown, columns;
    double spacing, size, height;  // of text and rows as multiples of the smallest
    double unit;
    double label_size() const { return std::min(size, largest_label); }
    double digits() const { return digits_over_label * size; }
    double label_baseline() const { return label_size() * unit; }
    double baseline() const {
        return label_baseline() + (above_digits * label_size() + digit_height * size) * unit;
    }
};

std::string MonitorsPanel::label(Monitor number) const {
    return escape_markup(say(context_.language(), column(number).quantity.word));
}

std::vector<std::string> MonitorsPanel::left_out(const DrawContext& dc) const {
    return names_after(row(dc).shown);
}

// Of the first `count` numbers.
MonitorsPanel::Row MonitorsPanel::row_of(const Rect& area, double unit, std::size_t count) const {
    Row best{area, count, count, 0.0, 0.0, 0.0, unit};
    for (std::size_t rows = 1; rows <= count; ++rows) {
        const std::size_t columns = (count + rows - 1) / rows;
        double width = column_width(unit) * static_cast<double>(columns);
        if (count == 1) width = std::max(widest_number, shows_time() ? widest_time(unit) : 0.0);
        if (rows == 1 && count > 1) {
            width = 0.0;
            for (std::size_t i = 0; i < count; ++i) width += this->width(numbers_[i], unit);
        }
        const double across = area.width / unit / width;
        const double height = area.height / unit / static_cast<double>(rows);
        const double size = std::min(across, size_in(height));
        if (rows == 1 || (size > best.size && best.size < 1.0))
            best = {area, count, columns, across, size, height, unit};
    }
    return best;
}

// The layout of as many of the numbers as there is room for, beginning with the first.
MonitorsPanel::Row MonitorsPanel::row(const DrawContext& dc) const {
    Rect area = dc.area;
    if (title_) {
        area.y += title_height * dc.unit;
        area.height -= title_height * dc.unit;
    }
    constexpr double loosest = 1.35;
    std::size_t count = numbers_.size();
    while (count > 1 && row_of(area, dc.unit, count).spacing < tightest) --count;
    Row best = row_of(area, dc.unit, count);
    best.size = std::max(1.0, best.size);
    best.spacing = std::min(best.spacing, loosest * best.size);
    return best;
}

// The lengths of rows differ by at most one number, and the last rows are the longer ones, so that
// no number is left alone.
Point MonitorsPanel::place(const Row& row, std::size_t index) const {
    const std::size_t rows = (row.shown + row.columns - 1) / row.columns;
    const std::size_t shorter = rows * row.columns - row.shown;
    const std::size_t in_shorter = shorter * (row.columns - 1);
    const bool in_short = index < in_shorter;
    const std::size_t length = in_short ? row.columns - 1 : row.columns;
    const std::size_t before = in_short ? index : index - in_shorter;
    const std::size_t line = before / length + (in_short ? 0 : shorter);
    double x = row.area.x;
    for (std::size_t i = index - before % length; i < index; ++i)
        x += (row.columns < row.shown ? column_width(row.unit) : width(numbers_[i], row.unit)) *
             row.spacing * row.unit;
    return {x, row.area.y + row.height * row.unit * static_cast<double>(line)};
}

// The width of the longest time in units, at the smallest size of text and with the arrow after it;
// 0 if it is no longer than usual.
double MonitorsPanel::widest_time(double unit) const {
    const TextStyle style = style_of_numbers(digits_over_label * unit, 500);
    const double width =
        measure_text(text(Monitor::time, widest_value(Monitor::time)), style).width / unit;
    if (width + (turns() ? arrow_gap : 0.0) < arrow_place - (turns() ? 0.0 : arrow_size))
        return 0.0;
    return width + (turns() ? arrow_gap + arrow_size : 0.0);
}

TextStyle MonitorsPanel::style_of_numbers(double size, int weight) const {
    return {.size = size,
            .weight = weight,
            .color = {},
            .fonts = theme_of(context_.film()).fonts,
            .lettering = Lettering::numbers};
}

// With as many digits as a number gets.
double MonitorsPanel::widest_value(Monitor number) const {
    switch (column(number).format) {
        case Format::fixed:
            return largest_.at(index_of(number));
        case Format::count:
            return 888'888.0;
        case Format::per_cent:
            return 88.0;
        case Format::power:
            return std::log10(8.88e-16);
    }
    return none;
}

// In units, at the smallest size of text. Numbers with a power of ten, and longer words of other
// languages, need more than the usual width.
double MonitorsPanel::width(Monitor number, double unit) const {
    const double usual = width_for_label(number, unit);
    if (number == Monitor::time) return std::max(usual, (widest_time(unit) + least_gap) / tightest);
    const Format format = column(number).format;
    if (format != Format::fixed && format != Format::power) return usual;
    const double least = format == Format::power ? none : smallest_.at(index_of(number));
    const TextStyle style = style_of_numbers(digits_over_label * unit, 500);
    double widest = 0.0;
    for (const double value : {least, widest_value(number)})
        widest = std::max(widest, measure_text(text(number, value), style).width / unit);
    return std::max(usual, (widest + least_gap) / tightest);
}

double MonitorsPanel::width_for_label(Monitor number, double unit) const {
    TextStyle style = style_of_numbers(1.035 * unit, 400);
    style.lettering = Lettering::text;
    const double label_width = measure_text(label(number), style).width / unit;
    return std::max(column(number).width, (label_width + least_gap) / tightest);
}

// Of all columns where there are several rows.
double MonitorsPanel::column_width(double unit) const {
    double widest = std::max(widest_column, shows_time() ? width(Monitor::time, unit) : 0.0);
    for (const Monitor number : numbers_) widest = std::max(widest, width_for_label(number, unit));
    return widest;
}

std::vector<Monitor> or_usual(const std::vector<Monitor>& asked) {
    if (!asked.empty()) return asked;
    return {Monitor::time, Monitor::collisions, Monitor::mean_speed, Monitor::mean_energy};
}

MonitorsPanel::MonitorsPanel(const PanelContext& context, const std::vector<Monitor>& numbers,
                             const std::optional<std::string>& title)
    : context_(context), are_asked_(!numbers.empty()), numbers_(or_usual(numbers)), title_(title) {
    smallest_.fill(infinity);
    largest_[index_of(Monitor::time)] = farthest_time(context.run());
    if (std::ranges::find(numbers_, Monitor::return_distance) != numbers_.end())
        echo_.emplace(context);
}

MonitorNumbers monitor_numbers(const PanelContext& context, const FrameInput& input) {
    const CollisionCounts& counts = input.advanced.counts;
    const double mean_speed = mean_of_speeds(context.particles, input.speed);
    const auto shares = class_shares(input.speed, mean_speed);
    return {folded_time(context.run(), input.tick.time),
            static_cast<double>(counts.particle),
            mean_speed,
            mean_over_finite_masses(context.particles, input.energy),
            100.0 * shares[0],
            100.0 * shares[1],
            100.0 * shares[2],
            static_cast<double>(counts.particle + counts.wall),
            none,
            100.0 * input.advanced.impulses.largest_overlap};
}

const Quantity& quantity_of(Monitor number) { return column(number).quantity; }

void MonitorsPanel::survey(const FrameInput& input) {
    if (echo_) echo_->survey(input);
    expect(input.speed, input.energy);
}

void MonitorsPanel::expect(const Eigen::ArrayXd& speed, const Eigen::ArrayXd& energy) {
    for (const auto& [number, value] :
         {std::pair{Monitor::mean_speed, mean_of_speeds(context_.particles, speed)},
          std::pair{Monitor::mean_energy, mean_over_finite_masses(context_.particles, energy)}}) {
        double &largest = largest_.at(index_of(number)), &smallest = smallest_.at(index_of(number));
        largest = std::max(largest, value);
        smallest = std::min(smallest, value);
    }
}

void MonitorsPanel::share_ranges(const std::vector<MonitorsPanel*>& panels) {
    MonitorsPanel& first = *panels.front();
    for (std::size_t i = 0; i < first.largest_.size(); ++i)
        for (const MonitorsPanel* panel : panels) {
            first.largest_[i] = std::max(first.largest_[i], panel->largest_[i]);
            first.smallest_[i] = std::min(first.smallest_[i], panel->smallest_[i]);
        }
    for (MonitorsPanel* panel : panels) {
        panel->largest_ = first.largest_;
        panel->smallest_ = first.smallest_;
    }
}

void MonitorsPanel::archive(Archive& archive) {
    archive(largest_, smallest_);
    if (echo_) echo_->archive(archive);
}

std::shared_ptr<const PanelState> MonitorsPanel::state(const FrameInput& input) {
    auto state = std::make_shared<MonitorsState>();
    state->numbers = monitor_numbers(context_, input);
    if (echo_)
        if (const auto apart = echo_->at(input.tick.frame)) {
            state->return_distance = apart->largest;
            state->numbers[index_of(Monitor::return_distance)] = apart->log10_largest;
        }
    if (input.refreshes_readouts || !readouts_) readouts_ = state->numbers;
    state->readouts = *readouts_;
    state->slow = input.tick.slow;
    const bool turning = input.tick.phase == Phase::reversing;
    const int before = input.tick.reversals - (turning && input.tick.progress > 0.5);
    const double turned = turning ? input.tick.progress : 0.0;
    state->arrow = before + smooth(turned);
    return state;
}

void MonitorsPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    if (title_) draw_panel_title(canvas, dc, escape_markup(*title_));
    const Row rows = row(dc);
    for (std::size_t i = 0; i < rows.shown; ++i)
        if (!comes_and_goes(numbers_[i])) draw_label(canvas, dc, rows, i);
}

void MonitorsPanel::draw_label(Canvas& canvas, const DrawContext& dc, const Row& rows,
                               std::size_t index) const {
    TextStyle style = label_style(dc);
    style.size = 1.035 * rows.label_size() * dc.unit;
    const Point at = place(rows, index);
    draw_text(canvas, {at.x, at.y + rows.label_baseline()}, label(numbers_[index]), style);
}

std::string MonitorsPanel::text(Monitor number, double value) const {
    switch (column(number).format) {
        case Format::fixed:
            return steady_number(context_.language(), value, {0.0, largest_.at(index_of(number))});
        case Format::count:
            return count_words(context_.language(), static_cast<std::int64_t>(value));
        case Format::per_cent:
            return percent(value);
        case Format::power:
            return three_digits_of_power(context_.language(), value);
    }
    return "";
}

std::optional<double> MonitorsPanel::enough_height() const {
    constexpr double enough = 8.2;
    if (numbers_.size() > 1) return {};
    return enough + (title_ ? title_height : 0.0);
}

bool MonitorsPanel::turns() const { return branch_count(context_.run()) > 1; }

bool MonitorsPanel::shows_time() const {
    return std::ranges::find(numbers_, Monitor::time) != numbers_.end();
}

std::vector<std::string> MonitorsPanel::names_after(std::size_t shown) const {
    std::vector<std::string> names;
    for (std::size_t i = shown; are_asked_ && i < numbers_.size(); ++i)
        names.push_back(fmt::format("the monitor `{}`", word_of(numbers_[i])));
    return names;
}

// Beside the word "time".
void MonitorsPanel::draw_slowness(Canvas& canvas, const DrawContext& dc, const Row& rows,
                                  const Slowness& slow) const {
    if (slow.share <= 0.0) return;
    const auto index =
        static_cast<std::size_t>(std::ranges::find(numbers_, Monitor::time) - numbers_.begin());
    const Point at = place(rows, index);
    TextStyle style = label_style(dc);
    style.size = 1.035 * rows.label_size() * dc.unit;
    const double right = measure_text(label(Monitor::time), style).width;
    style.weight = 600;
    style.color = with_alpha(dc.theme.highlight, slow.share);
    draw_text(canvas, {at.x + right + 0.5 * style.size, at.y + rows.label_baseline()},
              localised(context_.language(), slow_words(slow)), style);
}

// After the time at `at`; where there is no room for it, in the line of the word "time", at the
// right end.
Point MonitorsPanel::place_of_arrow(const DrawContext& dc, const Row& rows, const Point& at) const {
    const double size = rows.size * dc.unit, half = arrow_size * size;
    const double usual = arrow_place * rows.spacing * dc.unit;
    const double x = at.x + std::max(usual, widest_time(dc.unit) * size - half);
    if (rows.shown > 1 || x + half <= rows.area.right())
        return {x, at.y + rows.baseline() - 0.55 * size};
    return {rows.area.right() - half, at.y + rows.label_baseline() - 0.55 * half};
}

void MonitorsPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const MonitorsState&>(state);
    const Row rows = row(dc);
    TextStyle style = title_style(dc);
    style.size = rows.digits() * dc.unit;
    style.lettering = Lettering::numbers;
    for (std::size_t i = 0; i < rows.shown; ++i) {
        const double value = now.readouts.at(index_of(numbers_[i]));
        if (is_absent(numbers_[i], value)) continue;
        if (comes_and_goes(numbers_[i])) draw_label(canvas, dc, rows, i);
        const Point at = place(rows, i);
        const double baseline = at.y + rows.baseline();
        draw_text(canvas, {at.x, baseline}, text(numbers_[i], value), style);
        if (numbers_[i] != Monitor::time) continue;
        draw_slowness(canvas, dc, rows, now.slow);
        if (!turns()) continue;
        draw_time_arrow(canvas, place_of_arrow(dc, rows, at), arrow_size * rows.size * dc.unit,
                        now.arrow, dc.theme.highlight);
    }
}

Table MonitorsPanel::table(const PanelState& state, const Theme&) const {
    const auto& now = static_cast<const MonitorsState&>(state);
    Table table{{"part", "of", "value", "unit"}};
    for (const Monitor which : numbers_) {
        const double number = now.numbers.at(index_of(which));
        TableCell value = number;
        if (column(which).format == Format::count) value = static_cast<std::int64_t>(number);
        if (column(which).format == Format::power) value = now.return_distance;
        const Quantity& quantity = column(which).quantity;
        table.rows.push_back({"number", std::string(quantity.word.english), value,
                              unit_text(quantity, table.units)});
    }
    return table;
}

std::unique_ptr<Panel> make_monitors(const PanelContext& context,
                                     const std::vector<Monitor>& numbers) {
    return std::make_unique<MonitorsPanel>(context, numbers);
}

}  // namespace carom
