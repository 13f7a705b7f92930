// A film as plain values: its time, its picture, its panels, and what is shown over the gas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "physics/box.h"
#include "scene/figure_spec.h"
#include "scene/layout.h"
#include "scene/looks.h"
#include "scene/panel_spec.h"
#include "util/language.h"

namespace carom {

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

/// From where a box in space is seen. The picture plane stands across the line from the eye to the
/// middle of the box, so that upright edges stay upright in its middle.
struct Viewpoint {
    double turn = -28.0;  ///< degrees by which the box is turned about its upright axis, counter-
                          ///< clockwise as seen from above: -28 brings the right wall to the front
    double tilt = 14.0;   ///< degrees by which the eye is above the middle of the box
    double lens = 1.9;    ///< distance of the eye from the middle of the box, in its diagonals
};

/// The parts of a viewpoint that are given; the others stay as they are.
struct ViewpointChange {
    std::optional<double> turn = {}, tilt = {}, lens = {};

    Viewpoint applied_to(const Viewpoint& from) const {
        return {turn.value_or(from.turn), tilt.value_or(from.tilt), lens.value_or(from.lens)};
    }
};

/// The viewpoint of a film.
struct FilmViewpoint : Viewpoint {
    double spin = 0.0;  ///< degrees by which the box turns further during the film
};

/// The part of the box that the picture shows.
using View = std::variant<WholeBox, Region, Followed>;

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
    double at = 0.0;                 ///< simulated time
    std::optional<View> view;        ///< none: as before
    ViewpointChange viewpoint = {};  ///< in space
    double seconds = 1.5;            ///< of film, duration of the move
};

/// The runs that a film shows side by side, at the same times: first the scene's own.
struct FilmRuns {
    std::string own_label;                      ///< of the scene's own run, if there are others
    std::optional<std::string> own_color = {};  ///< #rrggbb, of the same; none: the first
    std::vector<ComparedRun> others;            ///< empty: the scene's own run alone
    bool is_overlaid = false;                   ///< all in one box, each in its own colour

    std::size_t count() const { return 1 + others.size(); }

    /// The colours of all runs, in order, as far as they are given.
    std::vector<std::optional<std::string>> colors() const {
        std::vector<std::optional<std::string>> all{own_color};
        for (const ComparedRun& run : others) all.push_back(run.color);
        return all;
    }

    /// The labels of all runs, in order.
    std::vector<std::string> labels() const {
        std::vector<std::string> all{own_label};
        for (const ComparedRun& run : others) all.push_back(run.label);
        return all;
    }
};

/// The sound of a film: a click for each collision of its run.
struct Sound {
    SoundOf of = SoundOf::collisions;
    double loudness = 0.3;                 ///< the largest sample, as a share of full scale
    std::optional<double> reference = {};  ///< impulse of a collision that sounds at 880 Hz; none:
                                           ///< as usual_impulse() (sound/film_sound.h)
};

struct Style;

struct Film {
    std::string template_name = "lecture";
    LayoutSpec layout;
    double seconds = 30.0;  ///< of the whole film, including holds and pauses
    int fps = 30;
    PictureSize size;
    ThemeName theme = ThemeName::dark;
    std::shared_ptr<const Style> style;  ///< of films and figures; null: none
    bool transparent = false;            ///< no background behind the box, the panels and the text
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
    FilmViewpoint viewpoint;         ///< of a box in space
    std::optional<Field> field;
    FilmRuns runs;
    std::optional<Sound> sound;             ///< none: the film is silent
    bool has_recipe = true;                 ///< whether its file contains what it was made from
    Language language = Language::english;  ///< of carom's own words, not the scene's
};

}  // namespace carom
