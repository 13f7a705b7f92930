#include "panels/plot/notes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

namespace carom::plot {
namespace {

constexpr double swatch_gap = 0.5, entry_gap = 1.5;  // units
constexpr double narrow_gap = 0.4;        // between entries that are squeezed into one row
constexpr double first_baseline = 2.5;    // units
constexpr double swatch_over_plot = 2.4;  // of notes that begin at the plot's edge, units
constexpr double gap_beside = 1.4;        // between a plot and the note beside it, units
constexpr double most_rows = 0.45;  // of the height: limit for a note that may be beside the plot

// Dots are narrower than other swatches.
double swatch_of(const Note& note, const KeyEntry& entry, const DrawContext& dc) {
    if (entry.swatch || !entry.arrows.empty()) return note.swatch_width * dc.unit;
    return entry.dot ? 2.5 * entry.dot->radius * dc.unit : 0.0;
}

double width_of(const Text& words, const DrawContext& dc) {
    return measure_text(markup_of(words, dc.theme), label_style(dc)).width;
}

const Text& words_of(const KeyEntry& entry, std::size_t length) {
    return entry.words[std::min(length, entry.words.size() - 1)];
}

// The words that an entry shows, or one of the rows into which they are broken, and their place.
struct PlacedEntry {
    const KeyEntry* entry;
    Text words;
    Point at;  // of the baseline
    double swatch, width;
    bool is_first = true;  // of its rows: with the swatch
};

// The width of a swatch and the gap after it.
double width_with_gap(double swatch, const DrawContext& dc) {
    return swatch > 0.0 ? swatch + swatch_gap * dc.unit : 0.0;
}

double width_before(const Note& note, const KeyEntry::Reserved& reserved, const DrawContext& dc) {
    return width_with_gap(reserved.has_swatch ? note.swatch_width * dc.unit : 0.0, dc);
}

// Measures an entry, with its swatch in the given width or in its own.
PlacedEntry measured(const Note& note, const KeyEntry& entry, std::size_t length,
                     const DrawContext& dc, std::optional<double> swatch_width = {}) {
    const double swatch = swatch_width.value_or(swatch_of(note, entry, dc));
    const Text& words = words_of(entry, length);
    double width = entry.reserved.empty() ? width_with_gap(swatch, dc) + width_of(words, dc) : 0.0;
    for (const KeyEntry::Reserved& reserved : entry.reserved)
        width = std::max(width, width_before(note, reserved, dc) + width_of(reserved.words, dc));
    return {&entry, words, {}, swatch, width};
}

// The rows into which words are broken at spaces so that each fits into the room, if it can.
std::vector<Text> rows_of(const Text& words, double room, const DrawContext& dc) {
    if (words.pieces.size() != 1 || width_of(words, dc) <= room) return {words};
    std::vector<Text> rows;
    std::string row;
    std::istringstream all(words.pieces.front().markup);
    for (std::string word; std::getline(all, word, ' ');) {
        std::string longer = row.empty() ? word : row + " " + word;
        if (!row.empty() && width_of(Text(longer), dc) > room) {
            rows.emplace_back(std::exchange(row, word));
            continue;
        }
        row = std::move(longer);
    }
    rows.emplace_back(row);
    return rows;
}

// How many rows an entry takes at most, whatever its words become.
std::size_t most_rows_of(const Note& note, const PlacedEntry& placed, const DrawContext& dc) {
    const double own = dc.area.width - width_with_gap(placed.swatch, dc);
    std::size_t most = rows_of(placed.words, own, dc).size();
    for (const KeyEntry::Reserved& reserved : placed.entry->reserved)
        most = std::max(
            most,
            rows_of(reserved.words, dc.area.width - width_before(note, reserved, dc), dc).size());
    return most;
}

// Narrows the widest entries of a row until all fit side by side.
void squeeze(std::vector<PlacedEntry>& row, double room) {
    std::vector<double> widths;
    for (const PlacedEntry& item : row) widths.push_back(item.width);
    std::ranges::sort(widths);
    double most = room;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        most = room / static_cast<double>(widths.size() - i);
        if (widths[i] > most) break;
        room -= widths[i];
    }
    for (PlacedEntry& item : row) item.width = std::min(item.width, most);
}

// Puts all entries in one row, some cut at their ends; empty if more than `most_cut` would be cut
// off.
std::vector<PlacedEntry> places_in_one_row(const Note& note, const DrawContext& dc, Point start) {
    constexpr double most_cut = 0.1;  // of all words
    std::vector<PlacedEntry> placed;
    double whole = 0.0;
    for (const KeyEntry& entry : note.entries) {
        placed.push_back(measured(note, entry, entry.words.size() - 1, dc));
        whole += placed.back().width;
    }
    const double gap = narrow_gap * dc.unit;
    const double room = dc.area.width - gap * static_cast<double>(placed.size() - 1);
    if (room < (1.0 - most_cut) * whole) return {};
    squeeze(placed, room);
    for (PlacedEntry& item : placed) {
        item.at = start;
        start.x += item.width + gap;
    }
    return placed;
}

struct PlacedEntries {
    std::vector<PlacedEntry> all;
    double last_row = 0.0;  // below the first, pixels
};

// Adds the rows of an entry that is too long for one, from a place on.
void add_rows(const PlacedEntry& item, const DrawContext& dc, Point at, PlacedEntries& placed) {
    const double room = dc.area.width - width_with_gap(item.swatch, dc);
    for (const Text& row : rows_of(item.words, room, dc)) {
        PlacedEntry part = item;
        part.words = row;
        part.at = at;
        part.is_first = placed.all.empty() || placed.all.back().entry != item.entry;
        placed.all.push_back(std::move(part));
        at.y += note_height * dc.unit;
    }
}

// Puts entries in rows; `start` is the left end of the baseline of the first row.
PlacedEntries places(const Note& note, const DrawContext& dc, Point start = {}) {
    std::size_t lengths = 1, length = 0;
    for (const KeyEntry& entry : note.entries) lengths = std::max(lengths, entry.words.size());
    const auto whole = [&] {
        double sum = -entry_gap * dc.unit;
        for (const KeyEntry& entry : note.entries)
            sum += measured(note, entry, length, dc).width + entry_gap * dc.unit;
        return sum;
    };
    while (length + 1 < lengths && whole() > dc.area.width) ++length;
    PlacedEntries placed;
    Point at;
    for (const KeyEntry& entry : note.entries) {
        PlacedEntry item = measured(note, entry, length, dc);
        const bool breaks = note.wraps && entry.breaks && item.width > dc.area.width;
        item.width = std::min(dc.area.width, item.width);
        if (note.wraps && at.x > 0.0 && at.x + item.width > dc.area.width)
            at = {0.0, at.y + note_height * dc.unit};
        if (note.may_be_beside && at.y > most_rows * plot_area(dc).height) break;
        item.at = {start.x + at.x, start.y + at.y};
        if (breaks) {
            add_rows(item, dc, item.at, placed);
            at.y += note_height * dc.unit * static_cast<double>(most_rows_of(note, item, dc) - 1);
        } else {
            placed.all.push_back(item);
        }
        at.x += item.width + entry_gap * dc.unit;
        placed.last_row = at.y;
    }
    return placed;
}

// The same for a column, in which all words are left-aligned; also returns the width of the column.
std::pair<std::vector<PlacedEntry>, double> column_of(const Note& note, const DrawContext& dc) {
    std::vector<PlacedEntry> entries;
    double width = 0.0;
    for (const KeyEntry& entry : note.entries) {
        entries.push_back(measured(note, entry, 0, dc, note.swatch_width * dc.unit));
        width = std::max(width, entries.back().width + gap_beside * dc.unit);
    }
    return {std::move(entries), width};
}

// In columns right of an area, as many as there is room for.
std::vector<PlacedEntry> places_beside(const Note& note, const DrawContext& dc, const Rect& area) {
    const double u = dc.unit;
    auto [placed, width] = column_of(note, dc);
    Point at{area.right() + gap_beside * u, area.y + u};
    for (std::size_t i = 0; i < placed.size(); ++i, at.y += note_height * u) {
        if (at.y > area.bottom()) at = {at.x + width, area.y + u};
        if (at.x + placed[i].width > dc.area.right() + 1e-6) {
            placed.resize(i);
            break;
        }
        placed[i].at = at;
    }
    return placed;
}

// The height of its rows, units.
double height_of(const Note& note, const DrawContext& dc) {
    if (note.entries.empty()) return note.changes ? note_height : 0.0;
    return note_height + places(note, dc).last_row / dc.unit;
}

// Whether the title that is shown is one of the last `count` ones, all others being too long.
bool has_one_of_last_titles(const Plot& plot, std::size_t count, const DrawContext& dc) {
    const auto fits = [&](const Text& title, TextStyle style) {
        return measure_text(markup_of(title, dc.theme), style).width <= dc.area.width;
    };
    const TextStyle full = title_style(dc);
    TextStyle small = full;
    small.size = dc.unit;
    for (const Text& title : plot.wide_titles)
        if (fits(title, full)) return false;
    for (std::size_t i = 0; i + count < plot.titles.size(); ++i)
        if (fits(plot.titles[i], small)) return false;
    return true;
}

struct ShownNote {
    const Note* note;
    double height;       // units
    bool is_in_one_row;  // in spite of `wraps`, as there is no room for more rows
};

// The notes that are drawn: only those that the shown title requires, and only as long as enough
// room remains for the data. A key whose rows would take too much is squeezed into one row if most
// of its words fit, since lines without names are useless.
std::vector<ShownNote> notes_of(const Plot& plot, const DrawContext& dc) {
    double room = plot_area(dc).height / dc.unit - least_height;
    std::vector<ShownNote> notes;
    for (const Note& note : plot.notes) {
        if (note.of_last_titles > 0 && !has_one_of_last_titles(plot, note.of_last_titles, dc))
            continue;
        ShownNote shown{&note, height_of(note, dc), false};
        if (!note.may_be_beside && shown.height > room) {
            const bool is_key = note.wraps && note.of_last_titles > 0 && note.entries.size() > 1;
            if (!is_key || note_height > room || places_in_one_row(note, dc, {}).empty()) continue;
            shown = {&note, note_height, true};
        }
        room -= shown.height;
        notes.push_back(shown);
    }
    return notes;
}

}  // namespace

double first_note(const Plot& plot, const DrawContext& dc) {
    const double drop_over_bars = plot.bar_notes ? 0.3 : 0.0;
    return dc.area.y + (first_baseline + drop_over_bars) * dc.unit;
}

double width_beside(const Note& note, const DrawContext& dc) { return column_of(note, dc).second; }

double height_of_rows(const Plot& plot, const DrawContext& dc, bool is_key_beside) {
    double sum = 0.0;
    for (const ShownNote& shown : notes_of(plot, dc))
        if (!(shown.note->may_be_beside && is_key_beside)) sum += shown.height;
    return sum;
}

namespace {

// One entry at the left edge of the plot, its swatch left of that.
void draw_note_over_plot(Canvas& canvas, const Frame& frame, const Note& note, double y) {
    const DrawContext& dc = frame.dc;
    TextStyle style = label_style(dc);
    style.max_width = frame.area.width;
    for (const KeyEntry& entry : note.entries) {
        const double end = frame.area.x - swatch_gap * dc.unit, middle = y - 0.35 * dc.unit;
        if (entry.swatch)
            draw_stroke(
                canvas, dc,
                std::array{Point{end - swatch_over_plot * dc.unit, middle}, Point{end, middle}},
                *entry.swatch);
        std::string words;
        for (const Text& text : entry.words) {  // a little more room, as its numbers change
            words = markup_of(text, dc.theme);
            if (measure_text(words + "00", label_style(dc)).width <= style.max_width) break;
        }
        draw_text(canvas, {frame.area.x, y}, words, style);
    }
}

// A line, a dot in its middle, arrows over it.
void draw_swatch(Canvas& canvas, const DrawContext& dc, const PlacedEntry& placed) {
    const KeyEntry& entry = *placed.entry;
    const double y = placed.at.y - 0.35 * dc.unit;
    const auto along = [&](double share) { return Point{placed.at.x + share * placed.swatch, y}; };
    if (entry.swatch) draw_stroke(canvas, dc, std::array{along(0.0), along(1.0)}, *entry.swatch);
    if (entry.dot) draw_dot(canvas, dc, along(0.5), *entry.dot);
    for (const Arrow& arrow : entry.arrows)
        draw_arrow(canvas, dc, along(arrow.from.x), along(arrow.to.x), arrow);
}

void draw_note(Canvas& canvas, const Frame& frame, const std::vector<PlacedEntry>& placed) {
    const DrawContext& dc = frame.dc;
    for (const PlacedEntry& item : placed) {
        if (item.is_first) draw_swatch(canvas, dc, item);
        if (item.entry->is_hidden) continue;
        const double words = width_with_gap(item.swatch, dc);
        TextStyle style = label_style(dc);
        style.max_width =
            std::min(item.width - words + 0.1 * dc.unit, dc.area.right() - item.at.x - words);
        draw_text(canvas, {item.at.x + words, item.at.y}, markup_of(item.words, dc.theme), style);
        frame.placer.keep_clear(Rect{item.at.x, item.at.y - 0.9 * dc.unit,
                                     item.width + entry_gap * dc.unit, 1.2 * dc.unit});
    }
}

}  // namespace

void draw_notes(Canvas& canvas, const Frame& frame, const Plot& plot, DrawnPart part) {
    const DrawContext& dc = frame.dc;
    double y = first_note(plot, dc);
    for (const ShownNote& shown : notes_of(plot, dc)) {
        const Note& note = *shown.note;
        const bool is_beside = note.may_be_beside && frame.is_key_beside;
        if (note.changes == (part == DrawnPart::changing)) {
            if (note.is_over_plot)
                draw_note_over_plot(canvas, frame, note, y);
            else
                draw_note(canvas, frame,
                          is_beside             ? places_beside(note, dc, frame.area)
                          : shown.is_in_one_row ? places_in_one_row(note, dc, {dc.area.x, y})
                                                : places(note, dc, {dc.area.x, y}).all);
        }
        if (!is_beside) y += shown.height * dc.unit;
    }
}

}  // namespace carom::plot
