// All limits of the scene language. A scene may come from an untrusted source: a value beyond a
// limit is refused, with the value and the limit in the message, before memory is allocated for it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace carom {

/// An upper (or lower) limit and the words that say what it limits.
struct Limit {
    double value;
    std::string_view meaning = {};  ///< empty: messages do not name the limit
    constexpr std::size_t count() const { return static_cast<std::size_t>(value); }
};

/// "the limit is 200 species"; empty if it has no meaning.
std::string to_text(const Limit& limit);

/// A bound as messages show it: 2000000, 1e12.
std::string number_text(double value);

inline constexpr Limit most_file_bytes{4 << 20, "bytes in a scene or template file"};
inline constexpr Limit most_nesting{24, "levels of nested lists and mappings"};
inline constexpr Limit most_page_nesting{24, "levels of nested sections in a page's template"};
inline constexpr Limit most_values{500'000, "values in a file, with its aliases expanded"};
inline constexpr Limit most_letters{4'000, "characters in a description"};
inline constexpr Limit most_title_letters{200, "characters in a title"};
inline constexpr Limit most_caption_letters{60, "characters in a caption, which is one line"};
inline constexpr Limit most_words_letters{600, "characters in the text of a panel"};
inline constexpr Limit most_name_letters{40, "characters in a name or label"};
inline constexpr Limit most_overrides{1'000, "values set on the command line"};
inline constexpr Limit most_errors_shown{50, "errors shown in one run"};

inline constexpr Limit largest_quantity{1e12, "of any length, mass, speed or time"};
inline constexpr Limit smallest_quantity{1e-12, "of a length, mass or time that must be positive"};
inline constexpr Limit most_seeds{64, "runs averaged in a figure"};
inline constexpr Limit most_runs{1'000'000, "runs of a sweep"};
inline constexpr Limit most_points{10'000, "points of a sweep"};
inline constexpr Limit largest_seed{9007199254740991, "of a seed: 2^53 - 1, exact in every reader"};
inline constexpr Limit most_particles{2'000'000, "particles in all"};
inline constexpr Limit most_returning{300'000, "particles whose return distance is measured"};
inline constexpr Limit most_in_both_runs{1'000, "particles whose distance in two runs is measured"};
inline constexpr Limit most_seed_paths{10, "runs whose paths are drawn with trails"};
inline constexpr Limit most_species{200, "species"};
inline constexpr Limit most_obstacles{1'000, "obstacles in a box"};
inline constexpr Limit most_partitions{64, "partitions of a box"};
inline constexpr Limit most_gaps{100, "gaps of a partition"};
inline constexpr Limit most_corners{1'000, "corners of an obstacle"};
inline constexpr Limit most_events{1'000, "events of a run"};
inline constexpr Limit most_precise{16'384, "bits of a number: 4,900 decimal digits"};
inline constexpr Limit most_samples{10e6, "samples of a run"};
inline constexpr Limit most_time_steps{10e6, "time steps of a run"};
inline constexpr Limit most_run_collisions{1e15, "collisions of a run, with `most_collisions`"};
inline constexpr Limit most_pairs_compared{20e6, "pairs compared in search of overlaps"};

inline constexpr Limit most_frames{108'000, "frames of a film: an hour at 30 frames a second"};
inline constexpr Limit most_frames_per_second{120, "frames in a second of film"};
inline constexpr Limit most_seconds{86'400, "seconds of a film"};
inline constexpr Limit most_sound_seconds{3'600, "seconds of a film with sound"};
inline constexpr Limit most_trail_seconds{3'600, "seconds of a trail"};
inline constexpr Limit smallest_side{64, "pixels on a side of a picture, at least"};
inline constexpr Limit largest_side{8192, "pixels on a side of a picture"};
inline constexpr Limit most_panels{12, "panels of a film"};
inline constexpr Limit most_slow_spans{100, "spans of slow motion"};
inline constexpr Limit most_overlays{100, "spotlights, callouts, or moves of the camera"};
inline constexpr Limit most_field_cells{200, "cells of a field along the longer side of the box"};
inline constexpr Limit most_figures{200, "figures of a scene"};
inline constexpr Limit most_set_scenes{100, "scenes of a figure set"};
inline constexpr Limit most_strip{12, "moments in a strip"};
inline constexpr Limit most_compared{6, "runs compared in one figure"};
inline constexpr Limit most_read_again{
    2 << 20, "bytes of a scene and its template read again, for runs that figures compare or vary"};
inline constexpr Limit most_changes{20, "values that a compared run sets"};
inline constexpr Limit largest_figure{100, "centimetres on a side of a figure"};
inline constexpr Limit smallest_figure{2, "centimetres on a side of a figure, at least"};
inline constexpr Limit most_monitors{8, "numbers in a row of monitors"};
inline constexpr Limit most_bins{1'000, "bins of a histogram"};
inline constexpr Limit most_chosen{8, "choices of particles drawn together"};
inline constexpr Limit largest_grid{1'000, "units on a side of a template's grid"};

// Narrower limits for scenes embedded in other documents; they apply only on request (classroom.h).
inline constexpr Limit most_classroom_seconds{120, "seconds of a film, with --limits classroom"};
inline constexpr Limit most_classroom_frames{7'200, "frames of a film, with --limits classroom"};
inline constexpr Limit most_classroom_work{300, "seconds of CPU time, with --limits classroom"};
inline constexpr Limit most_classroom_memory{2'000, "MB of memory, with --limits classroom"};
inline constexpr Limit most_classroom_bytes{1'000, "MB of output, with --limits classroom"};
inline constexpr Limit most_classroom_side{
    3'840, "pixels on a side of a picture, with --limits classroom"};
inline constexpr Limit most_classroom_particles{20'000,
                                                "particles in all, with --limits classroom"};
inline constexpr Limit most_classroom_samples{
    200e6, "samples of a run times its particles, with --limits classroom"};
inline constexpr Limit most_classroom_steps{
    200e6, "time steps of a run times its particles, with --limits classroom"};
inline constexpr Limit most_classroom_collisions{100e6,
                                                 "collisions of a run, with --limits classroom"};
inline constexpr Limit most_classroom_precise_collisions{
    200'000, "collisions of a run of more bits than doubles have, with --limits classroom"};

}  // namespace carom
