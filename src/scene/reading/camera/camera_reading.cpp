#include "scene/reading/camera/camera_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "physics/gas.h"
#include "physics/surfaces/behaviours.h"
#include "scene/limits.h"
#include "scene/reading/panel_reading.h"
#include "scene/yaml/scalar.h"
#include "util/overloaded.h"

namespace carom {
namespace {

// Refuses a viewpoint of anything but a box in space.
void check_in_space(const Node& node, Reading& reading) {
    if (reading.box().dimension != 3)
        reading.errors.add(node, "only a box with three lengths is seen from a viewpoint",
                           "leave it out, or give `size` of `box` a third length, the depth");
}

constexpr Range turns{-360.0, {360.0}}, tilts{-90.0, {90.0}}, lenses{1.0, {100.0}};
constexpr const char *meaning_of_turn =
                         "By how many degrees the box is turned about its upright "
                         "axis: with a negative number its right wall comes to the "
                         "front, with 0 it is seen from the front.",
                     *meaning_of_tilt =
                         "By how many degrees the eye is above the middle of the "
                         "box; below it with a negative number.",
                     *meaning_of_lens =
                         "The distance of the eye from the middle of the box, as a "
                         "multiple of the box's diagonal: the larger it is, the "
                         "weaker is the perspective.";

// Returns the region that the sides of the box may reach during the run. It is an upper bound,
// because reversals are ignored. A piston may go any distance.
Region reach_of(const Box& box, const Run& run) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Region reach{{0.0, 0.0}, box.size};
    const auto all = behaviours_in_time(box.surfaces, run);
    for (std::size_t side = 0; side < box.surfaces.numbered_sides().size(); ++side)
        for (const Behaviour& behaviour : all[side]) {
            const bool is_far = box.surfaces.is_far_side(side);
            const int axis = box.surfaces.axis_of(side);
            const double outward = std::visit(
                Overloaded{[](const Reflecting&) { return 0.0; }, [](const Bath&) { return 0.0; },
                           [&](const Driven& its) {
                               return std::max(0.0, is_far ? its.velocity : -its.velocity) *
                                      std::min(run.until, its.until);
                           },
                           [](const Piston&) { return infinite; },
                           [](const Membrane&) { return 0.0; }, [](const Diffuse&) { return 0.0; }},
                behaviour);
            double& end = is_far ? reach.high[axis] : reach.low[axis];
            end = is_far ? std::max(end, box.size[axis] + outward) : std::min(end, -outward);
        }
    return reach;
}

}  // namespace

// Reports something that begins at or after the end of the run: it would never be visible.
void check_begin(const Node& place, const char* key, double time, Reading& reading) {
    const double until = reading.run.until;
    if (until > 0.0 && time >= until)
        reading.errors.add(place,
                           fmt::format("expected a time from 0 on and below `until` ({}) "
                                       "for `{}`, found {}",
                                       until, key, described(place)),
                           "times are simulated time, as those of `run.events`");
}

// Returns the particle chosen by its number, or the only particle of a species.
std::optional<std::int64_t> only_one(const Chosen& chosen, const Gas& gas) {
    if (chosen.particle || !chosen.species) return chosen.particle;
    if (gas.species[*chosen.species].count != 1) return std::nullopt;
    std::int64_t first = 0;
    for (std::size_t k = 0; k < *chosen.species; ++k) first += gas.species[k].count;
    return first;
}

Notation<Region> region_notation(const std::string& key, const std::string& instead) {
    const auto part = [=](const std::vector<double>& ends, const Node& node,
                          Reading& reading) -> std::optional<Region> {
        const Box& box = reading.box();
        const bool is_view = key == "view";
        const Region whole = is_view ? reach_of(box, reading.run) : Region{{}, box.size};
        const bool can_widen = !box.contains(whole);
        const auto axes = static_cast<std::size_t>(box.dimension);
        const std::string form =
            fmt::format("{} with {}", corners(box.dimension), order_of_corners(box.dimension));
        if (ends.size() != 2 * axes) {
            reading.errors.add(node, fmt::format("expected {}{} for `{}`", instead, form, key),
                               box.dimension == 3 ? "the left, lower and back ends first"
                                                  : "the left and lower ends first");
            return std::nullopt;
        }
        const std::optional<Region> region = region_of(box.dimension, ends);
        const bool is_inside = region && on_each_axis(box.dimension, [&](int axis) {
                                   return region->low[axis] >= whole.low[axis] &&
                                          region->high[axis] <= whole.high[axis];
                               });
        if (region && (is_inside || !(box.size[0] > 0.0))) return region;
        reading.errors.add(
            node,
            region ? fmt::format("this {} reaches outside the box", is_view ? "view" : "region")
                   : fmt::format("expected {} for `{}`", form, key),
            !region     ? "write the smaller coordinates first"
            : can_widen ? "the box goes from 0 to its size, or as far as its walls move"
                        : "the box goes from 0 to its size");
        return std::nullopt;
    };
    return parsed(list_of(number(any_number, quantities::length), 2, {6}, corners(2)), part);
}

Notation<View> view_notation() {
    return either(as<View>(mapped(one_of<bool>({{"box", true}}), [](bool) { return WholeBox{}; })),
                  as<View>(region_notation("view", "`box` or ")));
}

Notation<ViewpointChange> viewpoint_notation() {
    const KeyTable<ViewpointChange> table{
        .name = "`viewpoint`",
        .keys = {bind_key("turn", &ViewpointChange::turn, number(turns), meaning_of_turn)
                     .default_text("as before"),
                 bind_key("tilt", &ViewpointChange::tilt, number(tilts), meaning_of_tilt)
                     .default_text("as before"),
                 bind_key("lens", &ViewpointChange::lens, number(lenses), meaning_of_lens)
                     .default_text("as before")},
        .rule = [](ViewpointChange&, const Node& node, Reading& reading) {
            check_in_space(node, reading);
        }};
    return mapping(table, "{turn: degrees, tilt: degrees, lens: number}");
}

namespace {

/// An item of `camera`.
struct CameraDraft {
    double at = 0.0;
    std::optional<View> view;
    std::vector<Chosen> follow;
    std::optional<double> width;
    std::optional<ViewpointChange> viewpoint;
    double seconds = CameraMove{}.seconds;
};

// In a periodic box, the centre of mass of several particles is not defined, so that the camera
// cannot follow it.
void check_followed(const CameraDraft& draft, const Node& node, Reading& reading) {
    const Node* follow = given(node, "follow");
    if (follow == nullptr || draft.follow.empty()) return;
    const Box& box = reading.box();
    if (draft.follow.size() > 1 ||
        (!draft.follow.front().particle && !draft.follow.front().species))
        reading.errors.add(*follow, "`follow` takes one particle or one species",
                           "for instance `follow: 0`");
    else if (!box.is_closed() && !only_one(draft.follow.front(), reading.gas))
        reading.errors.add(*follow,
                           "in a periodic box a species has no centre of mass to be followed",
                           "give the number of one particle");
}

std::optional<CameraMove> camera_move(const CameraDraft& draft, const Node& node,
                                      Reading& reading) {
    check_begin(*given(node, "at"), "at", draft.at, reading);
    check_followed(draft, node, reading);
    const Node* follow = given(node, "follow");
    if (follow != nullptr && !draft.width && find(node, "width") == nullptr)
        reading.errors.add(*follow, "`follow` needs `width`: how much of the box is seen",
                           reading.box().size[0] > 0.0
                               ? fmt::format("for instance half of the box, `width: {}`",
                                             0.5 * reading.box().size[0])
                               : "");
    if (const Node* width = given(node, "width"); width != nullptr && follow == nullptr)
        reading.errors.add(*width, "`width` applies to `follow` only",
                           "leave it out: `view` says how much is seen");
    const ViewpointChange from = draft.viewpoint.value_or(ViewpointChange{});
    if (draft.view) return CameraMove{draft.at, draft.view, from, draft.seconds};
    if (draft.follow.empty() || !draft.width) return std::nullopt;
    return CameraMove{draft.at, Followed{draft.follow.front(), *draft.width}, from, draft.seconds};
}

Notation<std::vector<CameraMove>> camera_notation() {
    const KeyTable<CameraDraft> table{
        .name = "an item of `camera`",
        .keys = {bind_key("at", &CameraDraft::at, number(not_negative, quantities::time),
                          "The simulated time at which the move begins.")
                     .required(),
                 bind_key("view", &CameraDraft::view, view_notation(),
                          "What is visible after the move: `box`, the whole box, or a part of it."),
                 bind_key("follow", &CameraDraft::follow, chosen_notation(),
                          "Instead of `view`: what stays in the middle, a particle or a species' "
                          "centre of mass."),
                 bind_key("width", &CameraDraft::width, number(positive, quantities::length),
                          "With `follow`: the width of the visible part, as a length."),
                 bind_key("viewpoint", &CameraDraft::viewpoint, viewpoint_notation(),
                          "In space, from where the box is seen after the move."),
                 bind_key("over", &CameraDraft::seconds, number({0.8, most_seconds}),
                          "How long the move takes, in seconds of film.")},
        .choices = {{{"view", "follow"}, true}}};
    const auto moves =
        list_of(parsed(complete_mapping(table,
                                        "{at: time, view: what} or {at: time, follow: "
                                        "particle, width: length}"),
                       camera_move),
                0, most_overlays, "a list of {at, view} and {at, follow, width}");
    return mapped(moves, [](std::vector<CameraMove> all) {
        std::ranges::stable_sort(all, {}, &CameraMove::at);
        return all;
    });
}

}  // namespace

Binding<Film> camera_key() {
    return bind_key("camera", &Film::camera, camera_notation(),
                    "Moves the camera to a part of the box, to a particle that it follows, and "
                    "back; in space also to another viewpoint. A small map and a scale bar of a "
                    "round length show what the picture covers.")
        .default_text("the whole box");
}

Binding<Film> viewpoint_key() {
    const KeyTable<FilmViewpoint> table{
        .name = "`viewpoint`",
        .keys = {bind_key("turn", &FilmViewpoint::turn, number(turns), meaning_of_turn),
                 bind_key("tilt", &FilmViewpoint::tilt, number(tilts), meaning_of_tilt),
                 bind_key("spin", &FilmViewpoint::spin, number(turns),
                          "By how many degrees the box turns further during the film, easing in "
                          "and out."),
                 bind_key("lens", &FilmViewpoint::lens, number(lenses), meaning_of_lens)},
        .rule = [](FilmViewpoint&, const Node& node, Reading& reading) {
            check_in_space(node, reading);
        }};
    return bind_key("viewpoint", &Film::viewpoint,
                    mapping(table, "{turn: degrees, tilt: degrees, spin: degrees, lens: number}"),
                    "From where a box with three lengths is seen.")
        .default_text("from the front, the right and above");
}

}  // namespace carom
