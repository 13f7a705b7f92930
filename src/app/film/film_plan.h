// A film that is ready to be drawn: the settled first pass over its run, as a value. It can be
// written, read back by another process, and drawn from there, whole or from any frame on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/film/frame_span.h"
#include "app/film/words/film_text.h"
#include "app/progress.h"
#include "media/film_writer.h"
#include "media/formats.h"
#include "panels/frame.h"
#include "panels/recording.h"
#include "scene/scene.h"

namespace carom {

/// What is wanted of a scene's film beyond what the scene says.
struct FilmOptions {
    std::filesystem::path output = {};  ///< as format_of_film() reads it
    Quality quality = Quality::standard;
    bool is_quality_asked = false;  ///< by the user, if only for the usual one
    int threads = 1;
    bool text = false;                     ///< its FilmText, in files beside it
    std::optional<double> joined_at = {};  ///< seconds of the film that it is a part of
    std::optional<double> from = {},
                          to = {};     ///< as frames_between() reads them; none: the whole film
    Recording::Room room = {};         ///< for the frames of the run; beyond it is simulated again
    std::filesystem::path cache = {};  ///< folder of an AxesCache; empty: none
    double most_bytes = std::numeric_limits<double>::infinity();  ///< a larger film is not written
};

/// The run that a film shows beside its own.
struct RunBeside {
    RunStart start;
    Recording run;
};

struct FilmPlan {
    Scene scene;     ///< with the precision that it calculates with; so has that beside it
    FrameSpan span;  ///< that is drawn
    std::vector<int> segments;  ///< as segment_starts(), counted from span.first
    Particles particles;
    Sample start;                     ///< at time 0
    Recording run;                    ///< of the whole film, or from some frame on
    std::optional<RunBeside> beside;  ///< if there is one, its run from the same frame on
    std::string progress;  ///< how far the panels are at the first frame of `run`; empty: at their
                           ///< beginning
    std::string axes;      ///< what the first pass has fixed of each panel
    std::vector<std::int16_t> sound;    ///< of the span; none: it is silent
    std::vector<std::uint32_t> colors;  ///< 0xffRRGGBB, where the format has few
    FilmText text;                      ///< where it is wanted
    std::vector<std::string> passes;    ///< what the run was simulated for, each time that it was

    int frames() const { return span.frames(); }

    /// How many frames of `run` there are up to the end of the span.
    std::size_t frames_to_play() const {
        return static_cast<std::size_t>(span.end - run.ticks().front().frame);
    }

    /// The film's panels with their axes, ready for the second pass. Refers to the plan.
    std::unique_ptr<PanelSet> panels() const;
};

/// Simulates the run of a scene, which fixes all that holds for the whole film. `when_placed` is
/// called once the gas has found its places, with what is known then: the scene, the span and the
/// particles. Throws SceneError (the gas cannot be placed, or does not return), SystemError,
/// Interrupted.
FilmPlan prepare(const Scene& scene, const FilmOptions& options, Progress& progress,
                 const std::function<void(const FilmPlan&)>& when_placed = {});

/// Ends the first pass of panels, and gives what it has fixed of each.
std::string fixed_axes(PanelSet& panels);

/// Frames that are drawn of the film of a scene.
int frames_of(const Scene& scene, const FilmOptions& options);

/// Whether the film of a scene has sound in a format.
bool has_sound(const Scene& scene, const OutputFormat& format);

/// What a film will be simulated for, as far as is known before: of so many particles.
std::vector<std::string> expected_passes(const Scene& scene, std::int64_t particles);

/// Collisions in all runs of a film, those with walls included.
struct FilmCollisions {
    double count = 0.0;
    bool kept = false;  ///< for its panels; for sound they are seen and not kept
};

/// Bytes of memory that render() takes at most for a film in a format, whatever its quality, of so
/// many particles in each of its runs: an upper estimate from measured peaks (docs/scaling.md).
std::int64_t memory_of_film(const Scene& scene, const OutputFormat& format, std::int64_t particles,
                            const FilmCollisions& collisions, int threads);

/// What all parts of a film share, and what is wanted of it, as bytes: all but its sound and the
/// frames of its runs.
std::string shared_bytes(FilmPlan& plan, FilmOptions& options);

/// Reads them back, into `options` too; `name` stands for the bytes in messages. Throws SystemError
/// where they are damaged, of another version of carom, or the scene's template has changed.
FilmPlan read_shared(std::string bytes, const std::string& name, FilmOptions& options);

/// The rest: the frames of its runs, and how far its panels are before them. Of a run that was not
/// kept the exact state of its simulation.
std::string run_bytes(FilmPlan& plan);

/// Reads them back into the plan that they belong to. Throws SystemError where they are damaged.
void read_run(FilmPlan& plan, std::string bytes, const std::string& name);

}  // namespace carom
