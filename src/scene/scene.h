// The Scene: a plain, complete, validated value. Nothing after loading knows YAML, defaults or
// templates.
#pragma once

#include <array>
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
#include "scene/panel_spec.h"
#include "scene/sweep.h"
#include "util/diagnostics.h"
#include "util/language.h"

namespace carom {

enum class ThemeName { light, dark, print };
enum class ColorBy { speed, speed_class, energy, direction, species, mass };
enum class Labels { none, mass, index };

/// A quantity that a row of monitors can show.
enum class Monitor {
    time,
    collisions,  ///< between particles
    mean_speed,
    mean_energy,
    slow,
    medium,
    fast,
    all_collisions,   ///< between particles and with walls
    return_distance,  ///< the largest of all particles, after a reversal
    overlap           ///< the largest so far of two colliding particles
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
    std::string label;                   ///< a word shown next to it, may be empty
    std::optional<double> trail;         ///< seconds of film; none: as the film's Trails say
    std::optional<double> drawn_radius;  ///< as a length; none: their radius
};

/// A rectangle of a template's layout, in units of the template's grid, with the origin at the top
/// left.
struct Slot {
    double x = 0, y = 0, width = 0, height = 0;
};

/// Whether a place lies inside another one.
inline bool is_within(const Slot& slot, const Slot& other) {
    constexpr double rounding = 1e-9;
    return slot.x >= other.x - rounding && slot.y >= other.y - rounding &&
           slot.x + slot.width <= other.x + other.width + rounding &&
           slot.y + slot.height <= other.y + other.height + rounding;
}

/// Whether a place has room for one line only, in which a key or numbers then stand.
inline bool is_one_line(const Slot& slot) { return slot.height < 3.0; }

/// The places of everything in a frame, read from a template.
struct LayoutSpec {
    double grid_width = 80,
           grid_height = 45;  ///< the picture in grid units; stretched to fill it
    Slot title;               ///< in as many lines as it has room for
    Slot gas;
    Slot color_bar;
    std::optional<Slot> caption;  ///< the line of captions and, at the start, of the subtitle,
                                  ///< where the scene has any; the rest has made room for it then
    std::optional<Slot> clock;
    std::optional<Slot> monitors;
    std::vector<Slot> panels;  ///< those inside the gas's place lie over the gas
};

/// The positions of all particles at a moment, kept visible until the next mark.
struct Mark {
    double at = 0.0;  ///< simulated time
    std::string words;
};

/// A text under the gas, shown until the next caption or for a limited time.
struct Caption {
    double at = 0.0;                     ///< simulated time
    std::string words;                   ///< empty: no caption from then on
    std::optional<double> seconds = {};  ///< of film, at most; none: until the next
};

/// A pause: the film shows a still picture, and simulated time does not advance.
struct Pause {
    double at = 0.0;       ///< simulated time
    double seconds = 0.0;  ///< of film
};

/// The whole box, or the whole line in one dimension.
struct WholeBox {};

/// A view of a given width, centred on a particle or on the centre of mass of several.
struct Followed {
    Chosen what;
    double width = 0.0;  ///< length
};

/// The part of the box that the picture shows.
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
    std::optional<std::size_t> species = {};  ///< for the concentration
    int cells = 32;                           ///< along the longer side of the box
    double over = 0.5;      ///< simulated time before the present that it is averaged over
    double opacity = 0.85;  ///< of its colours over the background
};

/// The trails that a film shows; `trail` of a species overrides them.
struct Trails {
    std::vector<Chosen> of;  ///< empty: none
    double seconds = 0.0;    ///< of film
    int seeds = 0;           ///< runs with further seeds whose whole paths are drawn faintly
};

/// A span of simulated time that a film shows in slow motion.
struct SlowSpan {
    double from = 0.0, to = 0.0;
    double factor = 1.0;  ///< 0.1: ten times slower
};

/// Particles that are highlighted for a while: all others are dimmed.
struct Spotlight {
    TimeSpan time;
    std::vector<Chosen> on;
};

/// A part of the box in which particles fade out after they have entered it.
struct FadeOut {
    Region within = {{0.0, 0.0}, {0.0, 0.0}};
    double seconds = 3.0;  ///< of film
};

/// A point of a panel's plot.
struct PlotPoint {
    std::size_t panel = 0;         ///< of Film::panels
    double x = 0.0;                ///< on its horizontal axis
    std::optional<double> y = {};  ///< none: the top of what is drawn there
};

/// A text that points to a particle, or to a point in a plot.
struct Callout {
    double at = 0.0;       ///< simulated time
    double seconds = 4.0;  ///< of film
    std::variant<std::int64_t, PlotPoint> on = std::int64_t{0};
    std::string words;
};

/// A move of the camera to another view.
struct CameraMove {
    double at = 0.0;  ///< simulated time
    View view;
    double seconds = 1.5;  ///< of film, duration of the move
};

/// One of the runs that a figure or a film shows side by side.
struct ComparedRun {
    std::string label;                ///< in the picture
    std::vector<std::string> values;  ///< overrides of its scene, as KEY.PATH=VALUE
    Diagnostic place = {};            ///< with an empty message, for errors found later
    std::shared_ptr<const Scene> scene =
        {};  ///< with these values; of a figure with this one only, which compares nothing there
};

/// A picture of one moment, or of several side by side, for a document or a slide.
struct FigureSpec {
    std::string name;  ///< of its files
    PanelSpec panel;   ///< its kind may be `gas` too; of numbers over a time, `over` is a window
    std::vector<double> times;     ///< simulated, in increasing order; several: a strip
    double width = 8.9;            ///< centimetres
    std::optional<double> height;  ///< centimetres; none: by kind
    bool slide = false;            ///< large type
    ThemeName theme = ThemeName::light;
    std::optional<std::string> caption, alt;  ///< none: made from what the figure shows
    std::vector<ComparedRun> compare = {};    ///< shown in one panel; empty: the scene's run alone
};

/// What a figure shows of a sweep; null if it shows none. And whether it does the runs of one
/// itself.
inline const SweepShown* sweep_of(const FigureSpec& figure) {
    return figure.panel.options.find<SweepShown>();
}
inline bool runs_sweep(const FigureSpec& figure) {
    return sweep_of(figure) != nullptr && !figure.panel.joined;
}

/// The second run that a film shows side by side with the scene's own, at the same times.
struct Beside : ComparedRun {
    std::string own_label;     ///< of the scene's own run
    bool is_overlaid = false;  ///< both in one box, each in its own colour
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
    double seconds = 30.0;  ///< of the whole film, including holds and pauses
    int fps = 30;
    PictureSize size;
    ThemeName theme = ThemeName::dark;
    bool transparent = false;  ///< no background behind the box, the panels and the text
    ColorBy color_by = ColorBy::speed;
    std::optional<std::string> palette;  ///< none: the theme's
    Labels labels = Labels::none;
    bool velocities = false;  ///< whether arrows show the velocities
    std::optional<double>
        velocity_scale;    ///< length of an arrow divided by its velocity, a time; none: automatic
    bool flashes = false;  ///< whether a mark shows where two particles collide
    double title_card = 0.0;  ///< duration in seconds; 0: none
    std::string end_card;     ///< its text; empty: none
    Trails trails;
    bool streaks = false;           ///< whether disks show the path of their last moment
    std::vector<Pause> pauses;      ///< in order of time; from the run's events
    std::vector<SlowSpan> slow;     ///< in order, without overlap, with room for easing in between
    std::vector<Monitor> monitors;  ///< the quantities in the layout's row; empty: its default
    std::vector<PanelSpec> panels;  ///< at most as many as layout.panels
    std::vector<std::string> panels_left_out = {};  ///< kinds an overriding template cannot place
    std::vector<Spotlight> spotlights;
    std::optional<FadeOut> fade_out;
    std::vector<Callout> callouts;
    std::vector<CameraMove> camera;  ///< in order of time; empty: the whole box throughout
    std::optional<Field> field;
    std::optional<Beside> beside;
    std::optional<Sound> sound;             ///< none: the film is silent
    Language language = Language::english;  ///< of carom's own words, not the scene's
};

/// Texts of files by their paths.
using FileTexts = std::map<std::string, std::string>;

/// Where a scene came from.
struct SceneSource {
    std::string path;                    ///< as the user gave it
    std::string text;                    ///< the whole file, as read
    std::string template_text;           ///< the template of its film, as read
    std::vector<std::string> overrides;  ///< values set on the command line, as KEY.PATH=VALUE
    std::string physics = {};            ///< its run_fingerprint(), including the overrides
    FileTexts files = {};                ///< texts of the other files it names: templates, scenes
    bool is_held_to_classroom = false;   ///< whether the limits of classroom.h apply
};

/// Returns the bytes of a scene's file and its template, which are read again whenever the scene is
/// reloaded.
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
    std::vector<Diagnostic> notes;  ///< what is valid in its files but should be written in another
                                    ///< way, and what was left out
    std::vector<Diagnostic> surface_places;  ///< of each surface of the box; for sides that are not
                                             ///< in the file, the place of the box
    Diagnostic surfaces_place;   ///< of the first that does more than reflect, or of gravity
    Diagnostic precision_place;  ///< of `precision` in the file; not given: of the scene
    Diagnostic ceiling_place;    ///< of `most_collisions`; not given: of the run
    std::vector<Diagnostic> event_places;   ///< one for each of run.events
    std::vector<Diagnostic> species_spans;  ///< one for each species: its place in the file with an
                                            ///< empty message, for errors found later
};

}  // namespace carom
