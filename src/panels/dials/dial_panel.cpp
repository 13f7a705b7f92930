#include "panels/dials/dial_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/plot/layers.h"
#include "util/text.h"

namespace carom {
namespace {

// In units; heights of digits are relative to the size of the text.
struct DialSize {
    static constexpr double title_space = 2.0;  // above all faces
    static constexpr double gap = 0.8;          // between faces
    static constexpr double note_space = 1.4, least_under_note = 6.1;
    static constexpr double digits = 1.35, digits_in_line = 1.2;  // under faces
    static constexpr double one_line = 1.8, two_lines = 3.0, after_name = 0.5;
    static constexpr double largest_digits = 2.6, digit_height = 0.73;  // beside a face
    static constexpr double least_beside = 5.5, least_beside_of_mean = 9.5, line = 1.35;
    static constexpr std::size_t most_note_lines = 4;
};

struct DialState : PanelState {
    struct Moment {
        std::size_t now = 0, said = 0;  ///< frames
    };
    std::vector<Moment> runs;
};

TextStyle number_style(const DrawContext& dc, double size) {
    return {.size = size * dc.unit,
            .weight = 500,
            .color = dc.theme.ink,
            .fonts = dc.theme.fonts,
            .lettering = Lettering::numbers};
}

TextStyle name_style(const DrawContext& dc, const plot::Role& role) {
    TextStyle style = label_style(dc);
    style.color = legible(plot::color_of(role, dc.theme), dc.theme);
    return style;
}

}  // namespace

double DialScale::share(double value) const {
    return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

// The scale ignores rare high numbers, such as means over a short time, which would make all others
// small.
DialScale scale_of_readings(const std::vector<std::vector<double>>& lines) {
    constexpr double nearly_all = 0.99, rare = 1.3;
    std::vector<double> all;
    bool has_negative = false;
    for (const std::vector<double>& line : lines)
        for (const double value : line) {
            if (!std::isfinite(value)) continue;
            has_negative = has_negative || value < 0.0;
            all.push_back(std::abs(value));
        }
    if (all.empty()) return {};
    std::ranges::sort(all);
    const double usual =
        all[static_cast<std::size_t>(nearly_all * static_cast<double>(all.size() - 1))];
    const double most = all.back() <= rare * usual ? all.back() : usual;
    if (!(most > 0.0)) return {};
    const double high = round_up_for_axis(most);
    return {has_negative ? -high : 0.0, high};
}

namespace {

// The places of the number and of the name of a reading, if the panel itself draws them.
struct PlaceOfWords {
    TextStyle number;
    Point at;    // right end of the number's baseline
    Point name;  // left end of the name's baseline, or its middle
    Align name_align = Align::left;
};

using WidestNumber = std::function<double(const TextStyle&)>;

// Places to the right of a face, vertically centred: the number, the name, and `lines` lines of a
// note.
PlaceOfWords words_beside(const DrawContext& dc, const Rect& words, const std::string& name,
                          std::size_t lines, const WidestNumber& widest) {
    const double u = dc.unit, of_unit = widest(number_style(dc, 1.0));
    PlaceOfWords place{number_style(dc, 1.0), {}, {}};
    place.number.align = Align::right;
    place.number.size = std::clamp(words.width / of_unit, 1.0, DialSize::largest_digits) * u;
    const double above = DialSize::digit_height * place.number.size;
    const double height = above + DialSize::line * u * (name.empty() ? 0.0 : 1.0) +
                          DialSize::line * u * static_cast<double>(lines);
    const double y = words.y + 0.5 * (words.height - height) + above;
    place.at = {words.x + widest(place.number), y};
    place.name = {words.x, y + 1.1 * DialSize::line * u};
    return place;
}

// Places centred under a face: name and number in one line, or the name under the number.
PlaceOfWords words_below(const DrawContext& dc, const Rect& words, const std::string& name,
                         bool is_one_line, const WidestNumber& widest) {
    const double u = dc.unit, middle = words.x + 0.5 * words.width, y = words.y + 1.45 * u;
    PlaceOfWords place{
        number_style(dc, is_one_line ? DialSize::digits_in_line : DialSize::digits), {}, {}};
    place.number.align = Align::right;
    const double number = widest(place.number);
    if (name.empty() || !is_one_line) {
        place.at = {middle + 0.5 * number, y};
        place.name = {middle, y + 1.3 * u};
        place.name_align = Align::center;
        return place;
    }
    const double name_width = measure_text(escape_markup(name), label_style(dc)).width;
    const double half = 0.5 * (number + DialSize::after_name * u + name_width);
    place.name = {middle - half, y};
    place.at = {middle + half, y};
    return place;
}

}  // namespace

/// Where the faces and the words are; of several readings the words are under each face.
struct DialPanel::Layout {
    std::vector<Rect> faces, words;
    std::vector<PlaceOfWords> places;      ///< where the panel draws words
    std::vector<std::string> note_beside;  ///< lines under the words of the only reading
    std::vector<std::string> note_rows;    ///< the same under the title
};

DialPanel::DialPanel(const PanelContext& context, const PanelSpec& spec, DialSubject subject)
    : context_(context), subject_(std::move(subject)), reader_(subject_) {
    if (spec.title) subject_.title = *spec.title;
}

void DialPanel::survey(const FrameInput& input) {
    record_.runs.front().add(input.tick.time, reader_(input), input.is_sample, input.is_frame);
}

void DialPanel::make_axes() {
    std::vector<std::vector<double>> all;
    for (const History& run : record_.runs) {
        all.insert(all.end(), run.y.begin(), run.y.end());
        for (std::size_t i = 0; i < run.error.size(); ++i) {
            std::vector<double>& ends = all.emplace_back(run.y[i]);
            for (std::size_t k = 0; k < ends.size(); ++k) ends[k] += run.error[i][k];
        }
    }
    scale_ = scale_of_readings(all);
    if (!subject_.counts) return;
    for (const std::vector<double>& line : all)
        for (const double value : line) scale_.high = std::max(scale_.high, value);
}

std::shared_ptr<const PanelState> DialPanel::state(const FrameInput& input) {
    if (input.refreshes_readouts || seen_ == 0) said_ = seen_;
    auto state = std::make_shared<DialState>();
    state->runs = {{seen_, said_}};
    ++seen_;
    return state;
}

std::shared_ptr<const PanelState> DialPanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    auto all = std::make_shared<DialState>();
    for (const auto& state : states)
        all->runs.push_back(dynamic_cast<const DialState&>(*state).runs.front());
    return all;
}

// The lines; those of compared runs have the names and the colours of the runs.
std::vector<MeterLine> DialPanel::lines() const {
    if (!record_.compares()) return subject_.lines;
    std::vector<MeterLine> all;
    for (std::size_t k = 0; k < record_.runs.size(); ++k)
        for (const MeterLine& line : subject_.lines) {
            const std::string& run = record_.runs[k].name;
            const bool is_only = subject_.lines.size() == 1;
            all.push_back(
                {line.column, is_only ? run : run + ", " + line.name, plot::stroke_of_run(k).role});
        }
    return all;
}

std::vector<DialPanel::Reading> DialPanel::readings(const PanelState& state) const {
    const auto& now = dynamic_cast<const DialState&>(state);
    const std::vector<MeterLine> all = lines();
    std::vector<Reading> readings;
    for (std::size_t k = 0; k < record_.runs.size(); ++k)
        for (std::size_t i = 0; i < record_.runs[k].frames.y.size(); ++i) {
            const auto at = [](const std::vector<double>& line, std::size_t frame) {
                return line.at(std::min(frame, line.size() - 1));
            };
            // A mean combines states of the same frame.
            const DialState::Moment& moment = now.runs.at(std::min(k, now.runs.size() - 1));
            const Measured& run = record_.runs[k].frames;
            readings.push_back(
                {all.at(readings.size()), at(run.y[i], moment.now), at(run.y[i], moment.said)});
            if (!run.error.empty()) readings.back().error = at(run.error[i], moment.said);
        }
    return readings;
}

std::optional<std::array<double, 2>> DialPanel::error_band(const Reading& reading) const {
    const double error = reading.error.value_or(0.0);
    if (!(error > 0.0)) return std::nullopt;
    return std::array{scale_.share(reading.value - error), scale_.share(reading.value + error)};
}

// A mean of the counts of several runs is not a whole number.
bool DialPanel::is_whole() const { return subject_.counts && record_.runs_in_mean == 1; }

// That all numbers have in common, if they are written with one; otherwise 0.
int DialPanel::power() const {
    if (is_whole()) return 0;
    return common_power(ticks(scale_.low, scale_.high), scale_.high);
}

DialScale DialPanel::written_scale() const {
    const double factor = std::pow(10.0, -power());
    return {factor * scale_.low, factor * scale_.high};
}

std::string DialPanel::written(double value, const std::optional<double>& error, int power) const {
    if (std::isnan(value)) return "–";
    if (is_whole()) return grouped(std::llround(value));
    const double factor = std::pow(10.0, -power);
    if (error) return with_error(context_.language(), factor * value, factor * *error);
    return steady_number(context_.language(), factor * value,
                         {factor * scale_.low, factor * scale_.high});
}

std::string DialPanel::number(double value, const std::optional<double>& error) const {
    return written(value, error, 0);
}

double DialPanel::widest_number(const TextStyle& style) const {
    const Measured& run = record_.runs.front().frames;
    if (run.error.empty())
        return std::max(measure_text(written(scale_.low, {}, power()), style).width,
                        measure_text(written(scale_.high, {}, power()), style).width);
    std::string longest;
    for (std::size_t i = 0; i < run.y.size(); ++i)
        for (std::size_t frame = 0; frame < run.y[i].size(); ++frame) {
            std::string words = written(run.y[i][frame], run.error[i][frame], power());
            if (words.size() > longest.size()) longest = std::move(words);
        }
    for (char& letter : longest)
        if (letter >= '1' && letter <= '9') letter = '0';
    return measure_text(longest, style).width;
}

std::string DialPanel::note() const {
    if (record_.runs_in_mean == 1) return subject_.note;
    const Language language = context_.language();
    const std::string mean =
        say(language, "{} ± standard error", words_of_mean(language, record_.runs_in_mean));
    return subject_.note.empty() ? mean : mean + "; " + subject_.note;
}

// Arranges the faces in the number of rows that makes them largest.
DialPanel::Layout DialPanel::layout_in_grid(const DrawContext& dc, const Rect& area) const {
    const double u = dc.unit;
    const std::vector<MeterLine> all = lines();
    const std::size_t count = std::max<std::size_t>(1, all.size());
    const auto widest = [this](const TextStyle& style) { return widest_number(style); };
    Layout best;
    double largest = -1.0;
    for (std::size_t rows = 1; rows <= count; ++rows) {
        const std::size_t columns = (count + rows - 1) / rows;
        const double cell_width =
            (area.width - DialSize::gap * u * static_cast<double>(columns - 1)) /
            static_cast<double>(columns);
        const double cell_height =
            (area.height - DialSize::gap * u * static_cast<double>(rows - 1)) /
            static_cast<double>(rows);
        bool is_one_line = true;
        for (const MeterLine& line : all) {
            const double name = measure_text(escape_markup(line.name), label_style(dc)).width;
            is_one_line =
                is_one_line && name + DialSize::after_name * u +
                                       widest_number(number_style(dc, DialSize::digits_in_line)) <=
                                   cell_width;
        }
        const double words =
            !has_words() ? 0.0 : (is_one_line ? DialSize::one_line : DialSize::two_lines) * u;
        const double across = (cell_width - width().units * u) / std::max(width().heights, 1e-9);
        const double height = std::min(cell_height - words, across);
        if (height <= largest && largest > 0.0) continue;
        largest = height;
        best = Layout();
        const double face_height = height < least_face() * u ? 0.0 : std::max(height, u);
        const double face_width =
            std::min(cell_width, width().units * u + width().heights * face_height);
        for (std::size_t k = 0; k < count; ++k) {
            const double x =
                area.x + static_cast<double>(k % columns) * (cell_width + DialSize::gap * u);
            const double y =
                area.y + static_cast<double>(k / columns) * (cell_height + DialSize::gap * u);
            const double top = y + std::max(0.0, 0.5 * (cell_height - words - face_height));
            best.faces.push_back(
                {x + 0.5 * (cell_width - face_width), top, face_width, face_height});
            best.words.push_back({x, top + face_height, cell_width, words});
            if (has_words())
                best.places.push_back(words_below(
                    dc, best.words.back(), all.empty() ? "" : all[k].name, is_one_line, widest));
        }
    }
    return best;
}

// A single face has its text beside it, if there is room.
DialPanel::Layout DialPanel::layout(const DrawContext& dc) const {
    const double u = dc.unit;
    Rect area = dc.area;
    area.y += DialSize::title_space * u;
    area.height -= DialSize::title_space * u;
    if (has_words() && lines().size() == 1) {
        const double beside =
            record_.runs_in_mean > 1 ? DialSize::least_beside_of_mean : DialSize::least_beside;
        const double most = area.width - (beside + DialSize::gap) * u;
        const double height =
            std::min(area.height, (most - width().units * u) / std::max(width().heights, 1e-9));
        const double face_width = width().units * u + width().heights * height;
        if (height >= 0.6 * area.height) {
            Layout layout;
            const double top = area.y + 0.5 * (area.height - height);
            layout.faces = {{area.x, top, face_width, height}};
            const double left = area.x + face_width + 1.4 * DialSize::gap * u;
            layout.words = {{left, area.y, area.right() - left, area.height}};
            TextStyle small = label_style(dc);
            small.max_width = layout.words[0].width;
            if (!note().empty())
                layout.note_beside = wrapped(note(), small, DialSize::most_note_lines);
            layout.places = {
                words_beside(dc, layout.words[0], lines().front().name, layout.note_beside.size(),
                             [this](const TextStyle& style) { return widest_number(style); })};
            return layout;
        }
    }
    TextStyle small = label_style(dc);
    small.max_width = area.width;
    std::vector<std::string> rows;
    if (!note().empty()) rows = wrapped(note(), small, DialSize::most_note_lines);
    const double taken = DialSize::note_space * u * static_cast<double>(rows.size());
    if (area.height - taken < DialSize::least_under_note * u) rows.clear();
    if (!rows.empty()) {
        area.y += taken;
        area.height -= taken;
    }
    Layout layout = layout_in_grid(dc, area);
    layout.note_rows = std::move(rows);
    return layout;
}

// The names, and the note under the title or beside the only face.
void DialPanel::draw_words(Canvas& canvas, const DrawContext& dc, const Layout& layout) const {
    const double u = dc.unit;
    double row = dc.area.y + (DialSize::title_space + 0.75) * u;
    for (const std::string& line : layout.note_rows) {
        TextStyle style = label_style(dc);
        style.max_width = dc.area.width;
        draw_text(canvas, {dc.area.x, row}, escape_markup(line), style);
        row += DialSize::note_space * u;
    }
    const std::vector<MeterLine> all = lines();
    for (std::size_t k = 0; k < layout.places.size(); ++k) {
        const PlaceOfWords& place = layout.places[k];
        TextStyle style = name_style(dc, all[k].role);
        style.align = place.name_align;
        style.max_width = layout.words[k].width;
        double y = place.name.y;
        if (!all[k].name.empty()) {
            draw_text(canvas, place.name, escape_markup(all[k].name), style);
            y += DialSize::line * u;
        }
        TextStyle small = label_style(dc);
        small.max_width = layout.words[k].width;
        for (const std::string& line : layout.note_beside) {
            draw_text(canvas, {place.name.x, y}, escape_markup(line), small);
            y += DialSize::line * u;
        }
    }
}

void DialPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const std::string title = escape_markup(subject_.title);
    draw_panel_title(canvas, dc,
                     power() == 0 ? title : title + " /\u200910" + superscript(power()));
    const Layout layout = this->layout(dc);
    const std::vector<MeterLine> all = lines();
    for (std::size_t k = 0; k < all.size(); ++k)
        if (has_room_for(layout.faces[k], dc)) draw_face(canvas, dc, layout.faces[k], all[k]);
    draw_words(canvas, dc, layout);
}

void DialPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const Layout layout = this->layout(dc);
    const std::vector<Reading> now = readings(state);
    for (std::size_t k = 0; k < now.size(); ++k) {
        if (has_room_for(layout.faces[k], dc)) draw_value(canvas, dc, layout.faces[k], now[k]);
        if (k < layout.places.size())
            draw_text(canvas, layout.places[k].at, written(now[k].said, now[k].error, power()),
                      layout.places[k].number);
    }
}

Table DialPanel::table(const PanelState& state, const Theme&) const {
    Table table{{"part", "of", "value", "unit"}};
    const bool compares = record_.compares(), is_mean = record_.runs_in_mean > 1;
    if (compares) table.columns.insert(table.columns.begin() + 1, "run");
    if (is_mean) table.columns.insert(table.columns.end() - 1, "standard error");
    const std::vector<Reading> now = readings(state);
    const std::size_t lines = std::max<std::size_t>(1, subject_.lines.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
        TableCell value = now[k].value;
        if (is_whole()) value = static_cast<std::int64_t>(std::llround(now[k].value));
        std::vector<TableCell> row{subject_.part, now[k].line.column, value,
                                   unit_text(subject_.quantity, table.units)};
        if (compares) row.insert(row.begin() + 1, record_.runs[k / lines].name);
        if (is_mean) row.insert(row.end() - 1, now[k].error.value());
        table.rows.push_back(std::move(row));
    }
    return table;
}

// "pressure 1.25", "pressure: left wall 1.25 and right wall 1.3".
std::string DialPanel::account_of(const std::vector<Reading>& readings) const {
    const Language language = context_.language();
    const std::string quantity = say(language, subject_.quantity.word);
    if (readings.size() == 1)
        return quantity + " " + number(readings.front().value, readings.front().error);
    std::vector<std::string> each;
    for (std::size_t k = 0; k < readings.size(); ++k)
        each.push_back(subject_.lines.at(k % subject_.lines.size()).name + " " +
                       number(readings[k].value, readings[k].error));
    return quantity + ": " + listed(language, each);
}

std::string DialPanel::account(const PanelState& state) const {
    if (record_.compares()) return "";
    std::string words = account_of(readings(state));
    if (!subject_.note.empty()) words += " (" + subject_.note + ")";
    return sentence(capitalised(words));
}

std::vector<std::string> DialPanel::accounts_of_runs(const PanelState& state) const {
    const std::vector<Reading> all = readings(state);
    std::vector<std::string> accounts;
    const auto lines = static_cast<std::ptrdiff_t>(subject_.lines.size());
    for (std::size_t k = 0; k < record_.runs.size(); ++k) {
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(k) * lines;
        accounts.push_back(account_of({first, first + lines}));
    }
    return accounts;
}

}  // namespace carom
