// A film as text, for people who cannot see it and for players that display text tracks: captions,
// chapters and descriptions as WebVTT, and a transcript. A silent film needs a text alternative
// (WCAG 2.2, success criterion 1.2.1).
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "films/frame_span.h"
#include "physics/advance_result.h"
#include "physics/particles.h"
#include "util/pending/pending_output.h"

namespace carom {

struct Scene;

/// Words that are shown from `start` to `end` (seconds of the film). Line breaks are kept.
struct Cue {
    double start = 0.0, end = 0.0;
    std::string words;

    template <class Archive>
    void archive(Archive& archive) {
        archive(start, end, words);
    }
};

/// The contents of a WebVTT file (W3C, https://www.w3.org/TR/webvtt1/) with these cues. Cues
/// without words or without duration are left out.
std::string webvtt(const std::vector<Cue>& cues);

/// The complete text files of a film. Times are in seconds from the first frame of the span.
struct FilmText {
    std::string captions;  ///< the captions below the gas, and what is heard; or empty
    std::string chapters;  ///< one from each event to the next; quarters of a film without events
    std::string descriptions;  ///< what is seen, and the numbers when a chapter begins
    std::string transcript;    ///< all of these as plain text

    // The same content in parts, for pages.
    std::vector<Cue> chapter_list = {};
    std::string about = {};          ///< what the film is and what is seen in it
    std::vector<Cue> passages = {};  ///< what happens, and the values of the numbers then

    template <class Archive>
    void archive(Archive& archive) {
        archive(captions, chapters, descriptions, transcript, chapter_list, about, passages);
    }
};

/// A frame at which a chapter begins or the film ends, and the state of the gas then. Texts are
/// empty if there is nothing to tell.
struct Moment {
    int frame = 0;
    double time = 0.0;
    bool reversed = false;                 ///< the velocities are reversed at this frame
    bool ends = false;                     ///< the film ends at this frame
    bool is_title = false;                 ///< the frame shows the title card
    std::vector<std::string> events = {};  ///< events at this frame in words, except for reversals
    std::vector<std::string> notes = {};   ///< what changes in the picture, not in the gas
    std::string mark = {};                 ///< words of a place that is marked at this frame
    std::string end_card = {};
    std::string caption = {};   ///< the caption that appears at this frame
    std::string surfaces = {};  ///< the surfaces that move or are open
    std::int64_t collisions = 0;
    double mean_speed = 0.0, mean_energy = 0.0;
    std::vector<double> species_energy = {};
    std::array<double, 3> shares{};
};

/// Makes the text of a film while its run is being simulated.
class FilmTextMaker {
  public:
    /// `ticks` is the scene's timeline, and `span` a part of it. `scene` and `particles` must
    /// outlive the object. If the film is a part of a joined film, it begins at second `joined_at`
    /// of that film and is one chapter there. With `has_sound` the captions tell when collisions
    /// are heard.
    FilmTextMaker(const Scene& scene, const FrameSpan& span, const std::vector<Tick>& ticks,
                  const Particles& particles, std::optional<double> joined_at = {},
                  bool has_sound = false);

    /// To be called for every frame of the timeline, in order.
    void see(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);

    /// The finished text; to be called after the last frame, with the numbers that are filled into
    /// the words of the scene (WordNumbers::texts()).
    FilmText text(const std::vector<std::string>& number_texts = {});

  private:
    const Scene& scene_;
    FrameSpan span_;
    const Particles& particles_;
    void hear(const Tick& tick, const CollisionCounts& counts);

    std::optional<double> joined_at_;
    bool has_sound_;
    std::int64_t collisions_ = 0;   ///< so far, including those with walls
    std::vector<FrameSpan> heard_;  ///< separate spans of frames in which something is heard
    std::vector<Moment> moments_;   ///< in order
    std::size_t next_ = 0;          ///< index of the next moment to be seen
};

/// The endings of text files, by content. They are appended to the film's name without its
/// extension.
inline const std::map<std::string, std::string> text_endings = {
    {"captions", ".captions.vtt"},
    {"chapters", ".chapters.vtt"},
    {"descriptions", ".descriptions.vtt"},
    {"transcript", ".transcript.txt"}};

/// Whether the film of a scene has captions in a format that has sound.
bool has_captions(const Scene& scene);

/// Which text files are written next to a film. A film with sound always needs captions.
enum class TextFiles { none, captions, all };

inline TextFiles files_wanted(bool text, bool has_sound) {
    if (text) return TextFiles::all;
    return has_sound ? TextFiles::captions : TextFiles::none;
}

/// The path of a text file next to the film at `path`; `what` is a key of text_endings. Next to a
/// folder of frames it is named after the folder.
std::filesystem::path text_path(const std::filesystem::path& path, const std::string& what);

/// The contents of a text file; `what` is a key of text_endings.
std::string text_for_file(const FilmText& text, const std::string& what);

/// Commits the film at `path` together with the wanted text files next to it (text_path()), and
/// with `picture` unless it is null. All of them appear or none. A film without captions gets no
/// caption file, but an existing one is replaced by an empty one. Throws SystemError.
void commit_with_text(PendingOutput& film, const FilmText& text, TextFiles wanted,
                      const std::filesystem::path& path, PendingOutput* picture = nullptr);

}  // namespace carom
