// The Scene: a plain, complete, validated value. Nothing after loading knows YAML, defaults or
// templates.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "physics/gas.h"
#include "physics/run.h"
#include "scene/sweep.h"
#include "util/diagnostics.h"
#include "util/language.h"

namespace carom {

enum class ThemeName { light, dark, print };
enum class ColorBy { speed, speed_class, energy, direction, species, mass };
enum class Labels { none, mass, index };

/// A number that monitors can show.
enum class Monitor {
    time,
    collisions,  ///< of particles with one another
    mean_speed,
    mean_energy,
    slow,
    medium,
    fast,
    all_collisions,   ///< those with walls too
    return_distance,  ///< the largest of all particles, after a reversal
    overlap           ///< the deepest so far of two particles that collided
};

struct PictureSize {
    int width = 1920;
    int height = 1080;
    bool operator==(const PictureSize&) const = default;
};

/// How a species is drawn.
struct SpeciesLook {
    std::optional<std::string> color;    ///< #rrggbb, of its disks and lines in all pictures
    bool fill = true;                    ///< false: rings
    std::string label;                   ///< a word beside it, may be empty
    std::optional<double> trail;         ///< seconds of film; none: by the film
    std::optional<double> drawn_radius;  ///< of beads on a wire, length; none: by their radius
};

/// A rectangle of a template's layout in grid units (template's own grid, origin top left).
struct Slot {
    double x = 0, y = 0, width = 0, height = 0;
};

/// Where things stand in a frame: read from a template.
struct LayoutSpec {
    double grid_width = 80,
           grid_height = 45;  ///< the picture in grid units; stretched to fill it
    Slot title;               ///< title and subtitle, in as many lines as it has room for
    Slot gas;
    Slot color_bar;
    std::optional<Slot> caption;  ///< the line of captions, where the scene has any; the rest has
                                  ///< made room for it then
    std::optional<Slot> monitors;
    std::vector<Slot> panels;
};

/// The places of all particles at a moment, kept in sight until the next mark.
struct Mark {
    double at = 0.0;  ///< simulated time
    std::string words;
};

/// Words under the gas, until the next caption or for a while.
struct Caption {
    double at = 0.0;                     ///< simulated time
    std::string words;                   ///< empty: none from then on
    std::optional<double> seconds = {};  ///< of film, at most; none: until the next
};

/// The film stands still, and simulated time does not pass.
struct Pause {
    double at = 0.0;       ///< simulated time
    double seconds = 0.0;  ///< of film
};

/// The simulated time in which something is shown.
struct TimeSpan {
    double from = 0.0;
    std::optional<double> until = {};  ///< none: the end of the run
};

/// Particles that a panel shows as one: a species, one particle, or all where neither is given.
struct Chosen {
    std::optional<std::size_t> species = {};
    std::optional<std::int64_t> particle = {};
};

/// The time that a panel's numbers are taken over.
struct Over {
    enum class Since { now, start, window } since = Since::now;
    double window = 0.0;  ///< simulated time before the present
};

enum class Component { x, y, both };

/// Two beads that need not be in the scene, as they meet.
struct GivenPair {
    Eigen::Array2d inverse_mass;  ///< 0: infinite, one at most
    Eigen::Array2d velocity;      ///< before they meet; unequal
};

/// The whole box, or line.
struct WholeBox {};

/// A view of this width whose middle is a particle, or the centre of mass of several.
struct Followed {
    Chosen what;
    double width = 0.0;  ///< length
};

/// What is seen of the box.
using View = std::variant<WholeBox, Region, Followed>;

/// What a field or a profile shows of the particles in a cell.
enum class FieldOf {
    density,       ///< particles in a unit of area
    temperature,   ///< of their motion relative to the cell's mean velocity
    speed,         ///< their mean
    flow,          ///< their mean velocity, as arrows
    concentration  ///< the share of a species
};

/// A quantity in square cells, drawn over the gas.
struct Field {
    FieldOf of = FieldOf::density;
    std::optional<std::size_t> species = {};  ///< of the concentration
    int cells = 32;                           ///< along the longer side of the box
    double over = 0.5;      ///< simulated time before the present that it is averaged over
    double opacity = 0.85;  ///< of its colours over the ground
};

/// A part of the box that a panel measures in.
struct NamedRegion {
    std::string name;
    Region region = {{0.0, 0.0}, {0.0, 0.0}};
};

/// What is measured of the particles in each part of the box.
enum class PartMeasure { count, temperature, mean_energy, center };

/// A straight line across the box, or from one place on it to another, that particles cross.
struct CountingLine {
    int axis = 0;     ///< that it is perpendicular to: 0 for x, 1 for y
    double at = 0.0;  ///< its place on that axis
    std::optional<std::pair<double, double>> between = {};  ///< along the other axis; none: all
};

/// What a counter counts at walls and partitions.
enum class Counted { hits, crossings };

/// What those that cross a line carry over it.
enum class Carried { particles, energy, mean_energy };

/// When a stopwatch starts.
struct WatchStart {
    double at = 0.0;                        ///< simulated time
    std::optional<std::size_t> event = {};  ///< of Run::events, at that time, that starts it
};

/// What an entropy is of.
enum class EntropyOf { velocities, positions, both };

struct Scene;

/// What a figure shows of a sweep: a number of its runs against a key that is varied.
struct SweepShown {
    std::string number;   ///< of a run, by its name
    std::string against;  ///< the key of one axis; each combination of the others is a line
    std::string across;   ///< the words of the axis across; empty: made from the key
    Sweep sweep = {};     ///< that the figure runs, unless `from`
    std::optional<std::string> from = {};  ///< the folder, or the summary, of a joined sweep
    std::function<std::shared_ptr<const Scene>(const std::vector<std::string>& changes)>
        scene_with = {};  ///< loads the scene's run with changes, KEY.PATH=VALUE; throws SceneError
};

/// A panel of a film with its options; those without a meaning for its kind are as here.
struct PanelSpec {
    std::string kind;
    std::optional<std::string> title = {};    ///< none: by kind
    std::vector<Chosen> of = {};              ///< drawn together; empty: all particles
    std::optional<Over> over = {};            ///< none: by kind
    std::optional<Component> component = {};  ///< none: by kind
    std::optional<int> bins = {};             ///< histograms: none: by rule
    std::optional<std::pair<double, double>> range = {};
    bool theory = true;
    bool fit = false;
    std::optional<bool> mean_now = {};  ///< none: by kind
    std::optional<bool> mean_start = {};
    int seeds = 1;                  ///< of a figure: of how many it shows the mean
    SweepShown sweep = {};          ///< of a figure
    bool test = false;              ///< of a figure: whether the bars are tested against the theory
    std::optional<double> at = {};  ///< of a figure: the time that it shows; none in films
    bool at_ends = false;           ///< of a figure of several runs: each at its end, not one time
    bool reference_initial = false;  ///< classes of speed by the mean at the start, not the present
    double from = 0.0;               ///< displacements: the time that they are since
    std::optional<double> fit_from = {};  ///< displacements: of their line; none: by kind
    bool all_origins = false;             ///< displacements: averaged over all starting times
    std::optional<double> to = {};    ///< pair correlations: the largest distance; none: by kind
    std::optional<double> lags = {};  ///< the longest time between two values; none: by kind
    bool logarithmic = false;         ///< free flights: the axis up
    bool ends_at_walls = false;       ///< free flights: at walls and partitions, too
    bool against_collisions = false;  ///< return distances; otherwise against the time
    FieldOf quantity = FieldOf::density;      ///< of a profile
    std::vector<std::int32_t> surfaces = {};  ///< what is measured at, by their numbers
    std::vector<NamedRegion> regions = {};    ///< parts of the box; none: beside a partition
    PartMeasure measure = PartMeasure::count;
    EntropyOf entropy_of = EntropyOf::velocities;
    bool gauge = false;                     ///< a pressure: a dial instead of a plot
    std::optional<CountingLine> line = {};  ///< crossings: instead of a partition
    std::optional<Counted> counted = {};    ///< none: by what the surfaces are
    Carried carried = Carried::particles;   ///< of a flux
    WatchStart since = {};                  ///< of a stopwatch
    std::vector<Monitor> numbers = {};      ///< monitors: those shown; none: all
    std::string words = {};                 ///< text
    std::optional<GivenPair> given = {};    ///< collision maps: none: of the run
    bool walk = false;                      ///< collision maps: all collisions so far
    std::optional<bool> scaled = {};  ///< collision maps: by the roots of the masses; none: walks
    TimeSpan show = {};               ///< of a film: when it is there
    std::optional<View> view = {};    ///< the gas in a figure; none: as in the film
    Diagnostic place = {};  ///< in the file, with an empty message, for errors found later
};

/// Trails that a film asks for; a species' own `trail` wins.
struct Trails {
    std::vector<Chosen> of;  ///< empty: none
    double seconds = 0.0;    ///< of film
};

/// A span of simulated time that a film shows slower.
struct SlowSpan {
    double from = 0.0, to = 0.0;
    double factor = 1.0;  ///< 0.1: ten times slower
};

/// Particles that stand out for a while: all others are dimmed.
struct Spotlight {
    TimeSpan time;
    std::vector<Chosen> on;
};

/// A point of a panel's plot.
struct PlotPoint {
    std::size_t panel = 0;         ///< of Film::panels
    double x = 0.0;                ///< on its horizontal axis
    std::optional<double> y = {};  ///< none: the top of what is drawn there
};

/// Words that point to a particle, or to a place in a plot.
struct Callout {
    double at = 0.0;       ///< simulated time
    double seconds = 4.0;  ///< of film
    std::variant<std::int64_t, PlotPoint> on = std::int64_t{0};
    std::string words;
};

/// The camera goes over to another view.
struct CameraMove {
    double at = 0.0;  ///< simulated time
    View view;
    double seconds = 1.5;  ///< of film, that it takes
};

/// One of the runs that a figure or a film shows side by side.
struct ComparedRun {
    std::string label;                ///< in the picture
    std::vector<std::string> values;  ///< laid over its scene, as KEY.PATH=VALUE
    Diagnostic place = {};            ///< with an empty message, for errors found later
    std::shared_ptr<const Scene> scene =
        {};  ///< with these values; of a figure with this one only, which compares nothing there
};

/// A picture of a moment, or of several side by side, for a text or a slide.
struct FigureSpec {
    std::string name;  ///< of its files
    PanelSpec panel;   ///< its kind may be `gas` too; of numbers over a time, `over` is a window
    std::vector<double> times;     ///< simulated, not falling; several: a strip
    double width = 8.9;            ///< centimetres
    std::optional<double> height;  ///< centimetres; none: by kind
    bool slide = false;            ///< large type
    ThemeName theme = ThemeName::print;
    std::optional<std::string> caption, alt;  ///< none: made from what the figure shows
    std::vector<ComparedRun> compare = {};    ///< side by side in one panel; none: the scene's run
};

/// The run that a film shows beside the scene's own, at the same times.
struct Beside : ComparedRun {
    std::string own_label;  ///< of the scene's own run
};

enum class SoundOf { collisions };

/// The sound of a film: a click for each collision of its run.
struct Sound {
    SoundOf of = SoundOf::collisions;
    double loudness = 0.3;                 ///< the largest sample, as a share of full scale
    std::optional<double> reference = {};  ///< impulse of a collision that sounds at 880 Hz; none:
                                           ///< as usual_impulse() (sound/film_sound.h)
};

struct Film {
    std::string template_name = "lecture";
    LayoutSpec layout;
    double seconds = 30.0;  ///< of the whole film, holds and pauses included
    int fps = 30;
    PictureSize size;
    ThemeName theme = ThemeName::dark;
    bool transparent = false;  ///< nothing lies behind the box, the panels and the words
    ColorBy color_by = ColorBy::speed;
    std::optional<std::string> palette;  ///< none: the theme's
    Labels labels = Labels::none;
    bool velocities = false;  ///< whether arrows show them
    std::optional<double>
        velocity_scale;       ///< an arrow's length over its velocity, a time; none: by rule
    bool flashes = false;     ///< whether a mark shows where two particles touch
    double title_card = 0.0;  ///< seconds; 0: none
    std::string end_card;     ///< its words; empty: none
    Trails trails;
    std::vector<Pause> pauses;      ///< in order of time; from the run's events
    std::vector<SlowSpan> slow;     ///< in order, apart, with room for the easing between them
    std::vector<Monitor> monitors;  ///< the numbers in the layout's row; none: all
    std::vector<PanelSpec> panels;  ///< at most as many as layout.panels
    std::vector<std::string> panels_left_out = {};  ///< kinds; a template laid over has no place
    std::vector<Spotlight> spotlights;
    std::vector<Callout> callouts;
    std::vector<CameraMove> camera;  ///< in order of time; none: the whole box throughout
    std::optional<Field> field;
    std::optional<Beside> beside;
    std::optional<Sound> sound;             ///< none: the film is silent
    Language language = Language::english;  ///< of carom's own words; a scene's stay as they are
};

/// Where a scene came from.
/// Texts of files by their paths.
using FileTexts = std::map<std::string, std::string>;

struct SceneSource {
    std::string path;                    ///< as the user gave it
    std::string text;                    ///< the whole file, as read
    std::string template_text;           ///< of its film, as read
    std::vector<std::string> overrides;  ///< what the command line laid over it, as KEY.PATH=VALUE
    std::string physics = {};            ///< run_fingerprint() of it, with these
    FileTexts files = {};               ///< what it names beside itself, as read: templates, scenes
    bool is_held_to_classroom = false;  ///< whether its limits are those of classroom.h
};

/// Bytes of a scene's file and its template, which loading it again reads.
inline std::size_t read_bytes(const SceneSource& source) {
    return source.text.size() + source.template_text.size();
}

struct Scene {
    std::string title;
    std::string subtitle;
    std::string description;
    std::uint64_t seed = 1;  ///< equal to gas.seed
    Gas gas;
    std::vector<SpeciesLook> looks;  ///< one for each species
    Run run;
    std::vector<Mark> marks;        ///< in order of time; equal times in the order listed
    std::vector<Caption> captions;  ///< in order of time; equal times in the order listed
    Film film;
    std::vector<FigureSpec> figures;
    SceneSource source;
    std::vector<Diagnostic> surface_places;  ///< of each surface of the box; of sides that are not
                                             ///< written, of the box
    Diagnostic surfaces_place;               ///< of the first that acts, or of gravity
    Diagnostic precision_place;              ///< of `precision` (or of the scene) in the file, and
    Diagnostic ceiling_place;                ///< of `most_collisions` (or of the run), and
    std::vector<Diagnostic> event_places;    ///< of each of run.events, as those of the species
    std::vector<Diagnostic> species_spans;  ///< one for each species: its place in the file with an
                                            ///< empty message, for errors found later
};

}  // namespace carom
