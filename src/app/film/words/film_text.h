// A film as text, for those who cannot see it and for players that show text of their own:
// captions, chapters and descriptions as WebVTT, and a transcript. A silent film needs a text
// alternative (WCAG 2.2, success criterion 1.2.1).
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/film/frame_span.h"
#include "physics/advance_result.h"
#include "physics/particles.h"
#include "scene/scene.h"
#include "util/pending/pending_output.h"

namespace carom {

/// Words from `start` to `end`, seconds; lines are kept.
struct Cue {
    double start = 0.0, end = 0.0;
    std::string words;

    template <class Archive>
    void archive(Archive& archive) {
        archive(start, end, words);
    }
};

/// A file of timed words (WebVTT, W3C, https://www.w3.org/TR/webvtt1/). Cues without words or
/// without length are left out.
std::string webvtt(const std::vector<Cue>& cues);

/// Whole files. Times count from the first frame of the span.
struct FilmText {
    std::string captions;      ///< what stands under the gas, and what is heard; empty: neither
    std::string chapters;      ///< from event to event, or quarters of a film that has none
    std::string descriptions;  ///< what is seen, and how the numbers stand when a chapter begins
    std::string transcript;    ///< all of these as plain text

    // The same in parts, for pages.
    std::vector<Cue> chapter_list = {};
    std::string about = {};          ///< what the film is and what is seen in it
    std::vector<Cue> passages = {};  ///< what happens, and how the numbers stand then

    template <class Archive>
    void archive(Archive& archive) {
        archive(captions, chapters, descriptions, transcript, chapter_list, about, passages);
    }
};

/// A frame at which a chapter begins, or the film ends, and how the gas is then.
struct Moment {
    int frame = 0;
    double time = 0.0;
    bool reversed = false;                 ///< just now
    bool ends = false;                     ///< the film
    bool is_title = false;                 ///< the title card
    std::vector<std::string> events = {};  ///< of just now, in words, but for reversals
    std::vector<std::string> notes = {};   ///< what changes in the picture, not in the gas
    std::string mark = {};                 ///< the words of places that are marked just now
    std::string end_card = {};
    std::string caption = {};   ///< that comes up just now
    std::string surfaces = {};  ///< those that move or are open
    std::int64_t collisions = 0;
    double mean_speed = 0.0, mean_energy = 0.0;
    std::vector<double> species_energy = {};
    std::array<double, 3> shares{};
};

/// Makes the text of a film while its run is simulated.
class FilmTextMaker {
  public:
    /// `span` is of `ticks`, the scene's timeline; all but these outlive it. A film that is a part
    /// of another begins at `joined_at` seconds of that, and is one chapter there. With
    /// `has_sound` collisions are heard.
    FilmTextMaker(const Scene& scene, const FrameSpan& span, const std::vector<Tick>& ticks,
                  const Particles& particles, std::optional<double> joined_at = {},
                  bool has_sound = false);

    /// Every frame of the timeline in order.
    void see(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);

    /// After the last frame.
    FilmText text() const;

  private:
    const Scene& scene_;
    FrameSpan span_;
    const Particles& particles_;
    void hear(const Tick& tick, const CollisionCounts& counts);

    std::optional<double> joined_at_;
    bool has_sound_;
    std::int64_t collisions_ = 0;   ///< so far, with those with walls
    std::vector<FrameSpan> heard_;  ///< frames in which something is, apart
    std::vector<Moment> moments_;   ///< in order
    std::size_t next_ = 0;          ///< to be seen
};

/// What their files are called, by what they hold: the film's name without its extension, and this.
inline const std::map<std::string, std::string> text_endings = {
    {"captions", ".captions.vtt"},
    {"chapters", ".chapters.vtt"},
    {"descriptions", ".descriptions.vtt"},
    {"transcript", ".transcript.txt"}};

/// Whether the film of a scene has captions, in a format that has sound.
bool has_captions(const Scene& scene);

/// Which files of its text stand beside a film: what is heard needs captions.
enum class TextFiles { none, captions, all };

inline TextFiles files_wanted(bool text, bool has_sound) {
    if (text) return TextFiles::all;
    return has_sound ? TextFiles::captions : TextFiles::none;
}

/// The file of its text beside the film at `path`; `what` is one of text_endings. Beside a folder
/// of frames it has the name of that.
std::filesystem::path text_path(const std::filesystem::path& path, const std::string& what);

/// Gives the film at `path` its name, together with the files of its text that are wanted, beside
/// it (text_path). All or none appear. A film without captions has no file of them, but an earlier
/// one is emptied. Throws SystemError.
void commit_with_text(PendingOutput& film, const FilmText& text, TextFiles wanted,
                      const std::filesystem::path& path);

}  // namespace carom
