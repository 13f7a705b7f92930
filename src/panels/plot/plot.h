// A plot as a value: axes, layers of data with their meaning, notes, and its texts for captions. It
// is independent of pixels, fonts and other panels. draw_plot() draws it, and table_of() lists its
// numbers.
//
// Lengths are in units of the layout (the smallest size of text); data are in those of the axes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "draw/color.h"
#include "draw/geometry.h"
#include "draw/palette.h"
#include "draw/style.h"
#include "draw/text.h"
#include "panels/table.h"
#include "physics/units/unit_table.h"
#include "util/language.h"

namespace carom::plot {

// ---------------------------------------------------------------------------------- colour, dash

/// A colour by its meaning; the theme gives the actual colour.
struct Role {
    enum class Of { ink, muted, accent, bar, highlight, page, run, own };
    Of of = Of::muted;
    std::size_t index = 0;       ///< of a compared run
    std::array<Color, 3> own{};  ///< on the light, the dark and the print theme
};

/// A role whose colour on each theme, the light, the dark and the print one, is given by a
/// function.
template <class ColorOn>
Role own_role(const std::array<const Theme*, 3>& themes, const ColorOn& color_on) {
    return {.of = Role::Of::own,
            .own = {color_on(*themes[0]), color_on(*themes[1]), color_on(*themes[2])}};
}

/// How a colour is changed so that it is visible on the page.
enum class Shade {
    as_it_is,
    legible,  ///< the nearest shade that stands out
    rimmed    ///< unchanged, with a rim of that shade
};

/// How a line is drawn.
struct Stroke {
    Role role = {};
    double width = 0.16;
    std::vector<double> dashes = {};        ///< line, gap, ... on every theme; empty: solid
    std::vector<double> print_dashes = {};  ///< instead in print, where greys tell lines apart
    Shade shade = Shade::as_it_is;
    double fade = 0.0;  ///< toward the page, 0 to 1
};

/// The dashes in print of one of several lines; solid if there is only one.
std::vector<double> dashes_in_print(std::size_t line, std::size_t lines);

/// The stroke of one of several compared runs: its own colour, and its own dashes on every theme.
Stroke stroke_of_run(std::size_t run, double width = 0.16);

// ------------------------------------------------------------------------------------------ words

/// The swatch before a name in print, where the colour of the name cannot serve as a key.
enum class Swatch { none, line, disk };

/// Markup in pieces, each with its colour.
struct Text {
    struct Piece {
        std::string markup;
        std::optional<Role> role = {};  ///< none: the text's own
        Swatch swatch = Swatch::none;
        std::size_t line = 0;  ///< index of the line that the swatch shows
    };
    std::vector<Piece> pieces;

    Text() = default;
    Text(std::string markup)
        : pieces{{std::move(markup)}} {}                     // NOLINT(google-explicit-constructor)
    Text(const char* markup) : Text(std::string(markup)) {}  // NOLINT(google-explicit-constructor)
    Text& operator+=(const Text& more);
    bool empty() const { return pieces.empty(); }
};
Text operator+(Text first, const Text& second);

/// A phrase of the program in a language, filled with texts: {} takes the next one, {0} the first.
Text text_of(Language language, Phrase phrase, const std::vector<Text>& texts);

/// A plain name (not markup) in its colour.
Text named(const std::string& name, const Role& role, Swatch swatch = Swatch::none,
           std::size_t line = 0);

/// Places for words: a point, and further points from there in steps, as far as the plot's area
/// extends.
struct Anchor {
    Point at;  ///< data, or shares of the area from its top left corner
    bool x_is_share = false, y_is_share = false;
    Point offset = {};  ///< from there to the baseline, units
    Align align = Align::left;
    Point step = {};          ///< units; none: this place only
    bool has_swatch = false;  ///< the label's swatch is drawn before the words here
    bool is_inside = false;   ///< only if the words lie wholly inside the plot
};

// ----------------------------------------------------------------------------------------- layers

/// A column of numbers of the table, shared by the plots of all frames.
struct Column {
    Heading heading;
    std::shared_ptr<const std::vector<double>> values = {};
    double operator[](std::size_t i) const { return (*values)[i]; }
    std::size_t size() const { return values ? values->size() : 0; }
};
Column column(Heading heading, std::vector<double> values);

/// The range of data that a frame shows: the rest comes later in the film, or is too old.
struct Shown {
    std::size_t first = 0;
    std::size_t end = std::numeric_limits<std::size_t>::max();
};

/// The common part of all layers.
struct Layer {
    std::string part = {};  ///< in the table: "line"; empty: not listed
    std::string of = {};
    std::optional<std::size_t> run = {};  ///< none: all runs of the plot
    int depth = 0;       ///< deeper layers are drawn first, equal ones in the plot's order
    bool still = false;  ///< the same in every frame: drawn once
    std::vector<Column> more = {};  ///< further columns of the table, not drawn
};

/// A disk at a point.
struct Dot {
    Role role = {};
    double radius = 0.3;
    Shade shade = Shade::legible;
    bool is_hollow = false;
    bool is_hollow_if_pale = false;  ///< in print, of a grey that hardly differs from the paper
    double halo = 0.0;               ///< width of a rim in the page's colour around it
    double fade = 0.0;               ///< toward the page, 0 to 1
    double ring = 0.0;               ///< > 0: a ring of this width instead
};

/// A path through points; it is broken where the number of the piece changes, and cut where it
/// leaves the plot.
struct Polyline : Layer {
    Column x, y;
    Shown shown = {};
    std::shared_ptr<const std::vector<int>> piece = {};  ///< none: one piece
    Heading piece_column = {};                           ///< of the table; empty: not listed
    bool is_thinned = true;  ///< points that nearly coincide are drawn once
    Stroke stroke = {};
    bool marks_exits = true;       ///< by arrows where it is cut
    std::optional<Dot> head = {};  ///< at its present end
};

/// A band of an error to either side of a line.
struct Band : Layer {
    Column x, y, error;
    bool is_along_x = false;  ///< the error is one of x
    Shown shown = {};
    std::shared_ptr<const std::vector<int>> piece = {};
    Role role = {};
    double alpha = 0.3;
};

struct Points : Layer {
    Column x, y;
    std::vector<std::string> of_each = {};  ///< in the table, instead of `of`
    Shown shown = {};
    double spacing = 0.0;  ///< units: a point nearer than this to the last one drawn is left out
    Dot dot = {};
};

/// Words at the first free one of some places. If none is free, words with a swatch go to the
/// nearest free place of the plot; others are left out.
struct Label : Layer {
    std::vector<Text> words;  ///< from longest to shortest; the first that fits its place is used
    std::vector<Anchor> anchors = {};
    Role role = {};
    std::optional<Stroke> swatch = {};  ///< before them
    bool is_name = false;  ///< of a line or of bars, see NamedAtLines; of all, without a swatch
    std::optional<double> level = {};      ///< the level that they name, which is the nearest one
    std::optional<std::size_t> line = {};  ///< the layer of the growing line that they name: they
                                           ///< come when its end has come to them
};

/// A line at one value of y across the plot.
struct Level : Layer {
    Heading column = {};  ///< of the table
    double value = 0.0;
    Stroke stroke = {.width = 0.08, .dashes = {0.3}};
    std::optional<Label> label = {};
    Heading x_column = {};  ///< of the table, for its two ends
};

/// Names a level at its line: over or under it, as near to its right end as the words are free; as
/// a key, with a swatch of the line, if they are nowhere free beside it. `deviation`: of a band
/// about the level, which they keep off.
void name_level(Level& level, std::vector<Text> words, double deviation = 0.0);

/// A line at one value of x from the bottom to the top of the plot, or to a point.
struct Marker : Layer {
    Heading column = {};  ///< of the table
    double value = 0.0;
    std::optional<double> up_to = {};  ///< none: the top
    Stroke stroke = {.width = 0.08};
    std::optional<Label> label = {};
    bool is_under_axis = false;  ///< a tick from the axis downward instead
};

/// Colours from 0 to `top`, on the light, the dark and the print theme.
struct Ramp {
    std::array<ColorMap, 3> maps;
    double top = 1.0;

    Color color(double value, const Theme& theme) const {
        return maps.at(static_cast<std::size_t>(theme.kind)).at(value / top);
    }
};

/// The heights of bins side by side.
struct Bars : Layer {
    Column from, to, value, error;    ///< errors may be none
    double below = 0.0, above = 0.0;  ///< beyond the ends of the axis, for the table
    /// The number of each bar that is taller than the axis, and fades out there; empty: none is.
    std::vector<std::string> taller = {};
    Role role = {.of = Role::Of::bar};
    std::shared_ptr<const Ramp> ramp = {};  ///< instead of the role: each bar has the colour of its
                                            ///< middle, and a strip under the axis shows them
    double alpha = 1.0;                     ///< of the filling; 0: none
    std::optional<Stroke> edge = {};        ///< of the upper edge
    Stroke error_stroke = {.width = 0.08};
};

struct Arrow : Layer {
    Point from, to;
    Role role = {.of = Role::Of::ink}, edge = {.of = Role::Of::page};
    double gap = 0.0;       ///< units that are left out at its end
    double shortest = 0.0;  ///< units; a shorter arrow is not drawn
};

using AnyLayer = std::variant<Bars, Polyline, Band, Points, Level, Marker, Arrow, Label>;

/// What all kinds of layers have in common.
const Layer& common(const AnyLayer& layer);

/// The text over bars: names and numbers of markers, at places that are fixed while markers and
/// numbers change, and how many values lie beyond the ends of the axis.
struct BarNotes {
    struct Reach {
        double from, to, value;
    };
    struct Name {
        Stroke swatch;
        std::string name, short_name;  ///< plain words
        std::string number;
        bool has_number = true;
    };
    std::vector<Name> names = {};
    std::string typical_number = {};  ///< number whose width determines the places
    bool are_in_a_row = false;        ///< names are side by side in a row and share its width
    bool may_be_beside = true;  ///< at the top right or left if no bar ever reaches there; else in
                                ///< a row above
    std::vector<Reach> highest = {};                  ///< of the bars in the whole film
    std::string below = {}, above = {}, beyond = {};  ///< "3", "5", "faster"; empty: none
};

/// What a plot shows instead where all names of its lines and bars (Label::is_name) have places
/// beside these: titles without the names, no title of the vertical axis, and no notes under
/// titles. Where one with a swatch has no place, none of the names is drawn.
struct NamedAtLines {
    std::vector<Text> titles = {};
    std::vector<std::string> means = {};  ///< instead of each name over bars, if there are any
};

// ----------------------------------------------------------------------------------- words around

/// A swatch, then words: a part of a key.
struct KeyEntry {
    std::optional<Stroke> swatch = {};
    std::vector<Text> words;         ///< from the longest on
    std::optional<Dot> dot = {};     ///< the swatch, or in its middle
    std::vector<Arrow> arrows = {};  ///< over the swatch; coordinates are shares of its width
    /// All that changing words may become: reserves their room.
    struct Reserved {
        Text words;
        bool has_swatch = true;  ///< whether the entry then has its swatch, too
    };
    std::vector<Reserved> reserved = {};
    bool is_hidden = false;  ///< in this frame: only its room is kept
    bool breaks = false;     ///< words that are too long for a row are broken at spaces, in a note
                             ///< that wraps; only words of one piece
};

/// Words under the title: entries in a row, each in its longest version with which all fit. Every
/// frame must need as many rows as the axes, for which there is no frame: else its data would be
/// drawn on other scales than those of the axes.
struct Note {
    std::vector<KeyEntry> entries = {};
    bool wraps = false;         ///< into as many rows as they need
    bool changes = false;       ///< from frame to frame; its row is reserved even while it is empty
    bool is_over_plot = false;  ///< begins at the plot's left edge, with swatches to the left
    bool may_be_beside = false;  ///< in a column right of the plot, if that makes the plot larger
    double swatch_width = 2.6;   ///< units
    std::size_t of_last_titles = 0;  ///< shown under so many last titles only; 0: under all
};

// ------------------------------------------------------------------------------------ axes, plot

struct Axis {
    enum class Kind {
        linear,
        logarithmic,  ///< of positive data
        powers        ///< data are decimal logarithms themselves
    };
    Text title = {};
    Text short_title = {};  ///< used if numbers gave way to `title`
    bool is_titled_by_scene =
        false;                     ///< the title stays where names at lines replace those of axes
    double low = 0.0, high = 1.0;  ///< decimal logarithms, unless linear
    Kind kind = Kind::linear;
    std::optional<Quantity> quantity = {};  ///< what its numbers are
    bool is_whole = false;                  ///< ticks at whole numbers only
    bool has_zero_place = false;            ///< a separate place for 0 below the powers of ten
};

/// An axis of a quantity, with its word as the title.
Axis axis_of(Language language, const Quantity& quantity, double low, double high);

/// The unit in which an axis shows its numbers, which are data in the units of the simulation.
ShownUnit unit_of(const Axis& axis, UnitSystem units);

/// A plot, complete and immutable. Copies share its data.
struct Plot {
    Language language = Language::english;  ///< of its numbers
    std::vector<Text> titles = {};          ///< from the longest on
    std::vector<Text> wide_titles = {};     ///< tried before those, at full size only
    Axis x = {}, y = {};
    bool has_equal_scales = false;  ///< then axes may show more than `low` to `high`
    std::vector<AnyLayer> layers = {};
    std::vector<Layer> numbers = {};  ///< of the table only: not drawn
    std::vector<Note> notes = {};
    std::optional<BarNotes> bar_notes = {};
    std::optional<NamedAtLines> at_lines = {};
    std::shared_ptr<const Ramp> ramp = {};           ///< of its bars, which may come later
    std::vector<Heading> columns = {};               ///< of the table, in order
    UnitSystem units = UnitSystem::reduced;          ///< of its numbers
    std::vector<std::string> runs = {};              ///< names of compared runs
    std::string account = {};                        ///< what it shows, in whole sentences
    std::string finding = {};                        ///< what a caption adds to that
    std::vector<std::string> accounts_of_runs = {};  ///< of each run: "mean 1.25"
};

/// In real units, adds their units to the titles of the axes, which then stay where names at lines
/// replace them.
void name_units(Plot& plot);

/// Adds the name of the line that was added last: in its colour, beside it where it is free. It is
/// one of the names of NamedAtLines.
void name_last_line(Plot& plot, const Text& words);

/// Names the runs that a plot compares, and adds a key: a swatch of each run's line before its
/// name.
void name_runs(Plot& plot, std::vector<std::string> names);

}  // namespace carom::plot
