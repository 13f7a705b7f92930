// A film that is ready to be drawn: the results of the first pass over its run, as a value. The
// value can be written and read back by another process, which draws the whole film or any part of
// it from there.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "films/film_options.h"
#include "films/frame_span.h"
#include "films/words/film_text.h"
#include "media/formats.h"
#include "panels/frame.h"
#include "panels/recording.h"
#include "scene/scene.h"

namespace carom {

struct FilmPlan {
    Scene scene;     ///< with the precision (bits) that was found; also in the scenes of other runs
    FrameSpan span;  ///< the frames that are drawn
    std::vector<int> segments;     ///< as segment_starts(), counted from span.first
    std::vector<RunStart> starts;  ///< of the runs that the film shows, its own first
    std::vector<Recording> runs;   ///< in the same order: the frames of the whole film, or from a
                                   ///< later frame on
    std::string progress;  ///< archived state of the panels before the first frame of `runs`;
                           ///< empty: their initial state
    std::string axes;  ///< archived axes and scales that the first pass has fixed for each panel
    std::vector<std::string> number_texts;  ///< that are filled into the words of the scene
    std::vector<std::int16_t> sound;        ///< samples for the span; empty: silent
    std::vector<std::uint32_t> colors;      ///< palette, 0xffRRGGBB, for formats with few colours
    FilmText text;                          ///< if it is asked for
    std::vector<std::string> passes;        ///< what each simulation of the run was for

    int frames() const { return span.frames(); }

    /// The particles of the film's own run.
    const Particles& particles() const { return starts.front().particles; }

    /// The ticks of the frames of `runs`.
    const std::vector<Tick>& ticks() const { return runs.front().ticks(); }

    /// The number of frames of `runs` up to the end of the span.
    std::size_t frames_to_play() const {
        return static_cast<std::size_t>(span.end - ticks().front().frame);
    }

    /// The film's panels with fixed axes, ready for the second pass. They refer to the plan, which
    /// must outlive them.
    std::unique_ptr<PanelSet> panels() const;
};

/// The second pass of a film: its frames in order. The plan must outlive it.
class FilmFrames {
  public:
    explicit FilmFrames(const FilmPlan& plan);

    /// What is done with a frame.
    using Taker = std::function<void(FrameData frame, const AdvanceResult& advanced)>;

    /// Goes on to all frames before number `end`, counted from the first one of the plan's
    /// recordings; `take` sees what has happened in the film's own run. With `ends_still` the last
    /// of them is that of a still. Throws as Recording::Player::next().
    void go_to(std::size_t end, const Taker& take, bool ends_still = false);

    PanelSet& panels() const { return *panels_; }

    /// The frames from the next one up to but excluding number `end`, as a plan that continues this
    /// one in another process.
    FilmPlan rest(FilmPlan without_runs, std::size_t end) const;

  private:
    std::unique_ptr<PanelSet> panels_;
    RunsPlayer player_;
};

/// The number of frames that are drawn of a scene's film with these options.
int frames_of(const Scene& scene, const FilmOptions& options);

/// Whether the film of a scene has sound in a format.
bool has_sound(const Scene& scene, const OutputFormat& format);

/// What all parts of a film share, and its options, as bytes: everything except its sound and the
/// frames of its runs.
std::string shared_bytes(FilmPlan& plan, FilmOptions& options);

/// Reads back what shared_bytes() gave, including `options`; `name` denotes the bytes in messages.
/// Throws SystemError if the bytes are damaged or from another version of carom, or if the scene's
/// template has changed.
FilmPlan read_shared(std::string bytes, const std::string& name, FilmOptions& options);

/// The rest of a plan as bytes: the frames of its runs, and the state of its panels before them.
/// For a run that is too large to be kept, the exact state of its simulation instead of the frames.
std::string run_bytes(FilmPlan& plan);

/// Reads back what run_bytes() gave, into the plan to which it belongs. Throws SystemError if the
/// bytes are damaged.
void read_run(FilmPlan& plan, std::string bytes, const std::string& name);

}  // namespace carom
